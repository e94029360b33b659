//! The techniques, one folder each.
//!
//! To add one: a folder here with its shaders, a type that implements [`Technique`], and a line in
//! [`build`]. Its settings are a file in `whitecap-scene/src/technique/`, whose registry gives the
//! scene file, the command line and the tests its name.

pub mod meshuggah;

use crate::uniforms::Shared;
use crate::{RenderError, View};
use whitecap_scene::Scene;

/// Everything that a technique may use to make one frame.
pub struct Frame<'a> {
    /// The device.
    pub device: &'a wgpu::Device,
    /// Its queue, for uploads.
    pub queue: &'a wgpu::Queue,
    /// Passes that must run before the water is drawn go here.
    pub encoder: &'a mut wgpu::CommandEncoder,
    /// The views of this frame.
    pub views: &'a [View],
    /// Simulation time, seconds.
    pub time_s: f64,
}

/// A way to draw water.
///
/// A technique keeps no clock and no camera: what it draws follows from the scene it was built for, the
/// views and the time, whatever it drew before.
pub trait Technique: Send + Sync {
    /// Brings everything on the device to `frame.time_s` and sets up each view.
    ///
    /// # Errors
    ///
    /// What the device refuses.
    fn prepare(&mut self, frame: &mut Frame<'_>) -> Result<(), RenderError>;

    /// Draws the water as `frame.views[view]` of the last [`Technique::prepare`] sees it. Groups 0
    /// and 1 are bound.
    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize);
}

/// What a technique is built from.
pub struct Build<'a> {
    /// The device.
    pub device: &'a wgpu::Device,
    /// Its queue.
    pub queue: &'a wgpu::Queue,
    /// The scene.
    pub scene: &'a Scene,
    /// Bind groups 0 and 1, and the target.
    pub(crate) shared: &'a Shared,
    /// Irradiance on the sea, linear, per channel.
    pub irradiance: glam::Vec3,
    /// Display brightness of the sky against a day's, see [`crate::environment::Environment::daylight`].
    pub daylight: f32,
    /// Cosine of the sun's angle to the zenith, 1 under a sky without a known sun.
    pub sun_cos: f32,
}

/// The technique that the scene names.
///
/// # Errors
///
/// When its sea cannot be built or the device cannot hold it.
pub fn build(build: &Build<'_>) -> Result<Box<dyn Technique>, RenderError> {
    match &build.scene.technique {
        whitecap_scene::Technique::Meshuggah(settings) => {
            Ok(Box::new(meshuggah::Meshuggah::new(build, settings)?))
        }
        other => Err(RenderError::Unsupported { what: format!("the technique {}", other.word()) }),
    }
}

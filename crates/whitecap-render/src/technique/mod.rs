//! The techniques, one folder each.
//!
//! To add one: a folder here with its shaders, a type that implements [`Technique`], and a line in
//! [`build`]. Its settings are a file in `whitecap-scene/src/technique/`, whose registry gives the
//! scene file, the command line and the tests its name.

pub mod five_sample;
pub mod meshuggah;
pub mod ocean_water;
pub mod projected_grid;
pub mod rippling_lake;
pub mod spectral_ocean;

use crate::environment::Light;
use crate::pass::Objects;
use crate::surface::Backend;
use crate::timing::PassTimer;
use crate::uniforms::Shared;
use crate::{RenderError, View};
use whitecap_scene::{Scene, Technique as Settings};

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
    /// Bind groups 0 and 1.
    pub(crate) shared: &'a Shared,
    /// What stands or floats in the water, in its place at `time_s`.
    pub(crate) objects: &'a Objects,
    /// Who wants to know how long each pass takes.
    pub(crate) timer: Option<&'a mut PassTimer>,
}

impl Frame<'_> {
    /// Says that the pass called `name` ends here: what was done since the last call was its work. Where passes
    /// are timed the device is waited for; otherwise nothing happens.
    pub(crate) fn end_of_pass(&mut self, name: &'static str) {
        if let Some(timer) = &mut self.timer {
            timer.end_of_pass(self.device, self.queue, self.encoder, name);
        }
    }
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

    /// As [`Technique::draw`] into a float target of the picture's depth format: the normal of the water, and in alpha the
    /// luminance of the sun's glitter in what the picture shows there, kcd/m². The answer is whether the technique has
    /// that, and was built for it ([`Build::aux`]); nothing is drawn otherwise.
    fn draw_aux(&self, _pass: &mut wgpu::RenderPass<'_>, _view: usize) -> bool {
        false
    }

    /// Draws the sky behind everything, if the technique has one of its own; the answer is whether it has. Groups
    /// 0 and 1 are bound.
    fn draw_sky(&self, _pass: &mut wgpu::RenderPass<'_>, _view: usize) -> bool {
        false
    }
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
    /// What stands or floats in the water.
    pub(crate) objects: &'a Objects,
    /// Who works a spectral sea out; `None` leaves it to [`Backend::auto`].
    pub backend: Option<Backend>,
    /// Whether [`Technique::draw_aux`] will be called.
    pub aux: bool,
    /// What the spectral ocean leaves out.
    pub(crate) without: Option<spectral_ocean::Feature>,
    /// Irradiance on the sea, linear, per channel.
    pub irradiance: glam::Vec3,
    /// Display brightness of the sky against a day's, see [`crate::environment::Environment::daylight`].
    pub daylight: f32,
    /// Light in the scene's own measure, for techniques that draw in it.
    pub light: Option<&'a Light>,
    /// Unit vector towards the sun; straight up under a sky without a known sun.
    pub toward_sun: glam::Vec3,
}

#[cfg(test)]
impl<'a> Build<'a> {
    /// Under white light of irradiance 1 from straight above, for tests.
    pub(crate) fn under_white_light(
        device: &'a wgpu::Device,
        queue: &'a wgpu::Queue,
        scene: &'a Scene,
        shared: &'a Shared,
        objects: &'a Objects,
    ) -> Self {
        let (irradiance, toward_sun) = (glam::Vec3::ONE, glam::Vec3::Y);
        Self {
            device,
            queue,
            scene,
            shared,
            objects,
            backend: None,
            aux: false,
            without: None,
            irradiance,
            daylight: 1.0,
            light: None,
            toward_sun,
        }
    }
}

impl Build<'_> {
    /// Whether a processor does the drawing: then triangles and filtered samples are dear.
    pub(crate) fn is_software(&self) -> bool {
        self.device.adapter_info().device_type == wgpu::DeviceType::Cpu
    }
}

/// The technique that the scene names.
///
/// # Errors
///
/// When its sea cannot be built or the device cannot hold it.
pub fn build(build: &Build<'_>) -> Result<Box<dyn Technique>, RenderError> {
    Ok(match &build.scene.technique {
        Settings::OceanWater(settings) => Box::new(ocean_water::OceanWater::new(build, settings)?),
        Settings::RipplingLake(settings) => Box::new(rippling_lake::RipplingLake::new(build, settings)?),
        Settings::ProjectedGrid(settings) => Box::new(projected_grid::ProjectedGrid::new(build, settings)?),
        Settings::Meshuggah(settings) => Box::new(meshuggah::Meshuggah::new(build, settings)?),
        Settings::FiveSample(settings) => Box::new(five_sample::FiveSample::new(build, settings)?),
        Settings::SpectralOcean(settings) => Box::new(spectral_ocean::SpectralOcean::new(build, settings)?),
        other => return Err(RenderError::Unsupported { what: format!("the technique {}", other.word()) }),
    })
}

/// A scene whose sea is not of a kind that its technique draws: reading a file refuses it, so it was put
/// together in memory.
pub(crate) fn wrong_sea(build: &Build<'_>) -> RenderError {
    let Scene { technique, sea, .. } = build.scene;
    RenderError::Unsupported {
        what: format!("a sea of model \"{}\" for the technique {}", sea.model.word(), technique.word()),
    }
}

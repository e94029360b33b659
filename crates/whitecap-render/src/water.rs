//! The water in a host's own frame.

use crate::environment::Environment;
use crate::gpu::checked;
use crate::pass::{ObjectPass, Objects, SkyPass};
use crate::surface::Backend;
use crate::technique::spectral_ocean::Feature;
use crate::technique::{self, Build, Frame, Technique};
use crate::timing::PassTimer;
use crate::uniforms::{Role, Shared};
use crate::{RenderError, TargetFormat, View};
use glam::Vec3;
use whitecap_scene::Scene;

/// A sea, its sky and the technique that draws it, in wgpu's middleware pattern: the host owns device,
/// frame and pass, and calls [`Water::prepare`] before its pass and [`Water::draw`] inside it.
///
/// ```no_run
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, pass_of: impl Fn(&mut wgpu::CommandEncoder) -> wgpu::RenderPass<'static>) -> Result<(), Box<dyn std::error::Error>> {
/// use whitecap_render::{TargetFormat, View, Water};
/// let scene = whitecap_scene::open("meshuggah")?;
/// let mut water = Water::new(device, queue, &scene, TargetFormat::default())?;
/// let view = View::of_camera(&scene.camera, [1280, 720]);
///
/// let mut encoder = device.create_command_encoder(&Default::default());
/// water.prepare(device, queue, &mut encoder, &[view], 12.5)?;
/// let mut pass = pass_of(&mut encoder); // the host's own pass, with a depth attachment
/// // … the host's own draws …
/// water.draw(&mut pass, 0);
/// water.draw_sky(&mut pass, 0); // unless the host has a sky of its own
/// # Ok(()) }
/// ```
pub struct Water {
    shared: Shared,
    objects: Objects,
    object_pass: ObjectPass,
    aux_objects: Option<ObjectPass>,
    sky: SkyPass,
    technique: Box<dyn Technique>,
}

/// What a host may decide about a [`Water`] beside its scene. The picture is the same for all of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WaterOptions {
    /// Who works a spectral sea out; `None` leaves it to [`Backend::auto`].
    pub backend: Option<Backend>,
    /// Whether [`Water::draw_aux`] will be called, which needs pipelines of its own.
    pub aux: bool,
}

impl Water {
    /// Computes the scene's sky and builds its technique for passes of `target`'s format.
    ///
    /// # Errors
    ///
    /// When the scene's sea cannot be built or the device cannot hold what it needs.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        scene: &Scene,
        target: TargetFormat,
    ) -> Result<Water, RenderError> {
        Water::with_environment(device, queue, scene, &Environment::new(scene)?, target)
    }

    /// As [`Water::new`] with an environment that was made before, for hosts that share one or compute
    /// it on a thread of their own.
    ///
    /// # Errors
    ///
    /// As [`Water::new`].
    pub fn with_environment(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        scene: &Scene,
        environment: &Environment,
        target: TargetFormat,
    ) -> Result<Water, RenderError> {
        Water::with_options(device, queue, scene, environment, target, &WaterOptions::default())
    }

    /// As [`Water::with_environment`], with what is left to whitecap otherwise.
    ///
    /// # Errors
    ///
    /// As [`Water::new`], and [`RenderError::Unsupported`] if an option asks for what the device or the scene's sea
    /// cannot do.
    pub fn with_options(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        scene: &Scene,
        environment: &Environment,
        target: TargetFormat,
        options: &WaterOptions,
    ) -> Result<Water, RenderError> {
        Water::without(device, queue, scene, environment, target, options, None)
    }

    /// As [`Water::with_options`], but for a part of the light that is left out to measure its cost.
    pub(crate) fn without(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        scene: &Scene,
        environment: &Environment,
        target: TargetFormat,
        options: &WaterOptions,
        without: Option<Feature>,
    ) -> Result<Water, RenderError> {
        checked(device, "the water", || {
            let shared = Shared::new(device, queue, environment, target);
            let objects = Objects::new(device, queue, scene)?;
            let object_pass = ObjectPass::new(device, &shared, &objects, &target);
            let aux_objects = options.aux.then(|| ObjectPass::aux(device, &shared, &objects, &target));
            let sky = SkyPass::new(device, &shared, &target);
            let technique = technique::build(&Build {
                device,
                queue,
                scene,
                shared: &shared,
                objects: &objects,
                backend: options.backend,
                aux: options.aux,
                without,
                irradiance: environment.irradiance,
                daylight: environment.daylight,
                light: environment.light.as_ref(),
                toward_sun: environment.sun.map_or(Vec3::Y, |sun| sun.toward),
            })?;
            Ok(Water { shared, objects, object_pass, aux_objects, sky, technique })
        })
    }

    /// Brings the sea to `time_s` and sets up each of `views`. The same time and views give the same
    /// picture, whatever was drawn before.
    ///
    /// Call it once a frame, before the pass; its uploads take effect with the next submission.
    ///
    /// # Errors
    ///
    /// [`RenderError::LimitExceeded`] for more than [`crate::MAX_VIEWS`] views, or what the device refuses.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        views: &[View],
        time_s: f64,
    ) -> Result<(), RenderError> {
        self.prepare_timed(device, queue, encoder, views, time_s, None)
    }

    pub(crate) fn prepare_timed(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        views: &[View],
        time_s: f64,
        mut timer: Option<&mut PassTimer>,
    ) -> Result<(), RenderError> {
        let Water { shared, objects, technique, .. } = self;
        shared.write_views(queue, views)?;
        objects.prepare(queue, views, time_s);
        if let Some(skies) = &mut shared.skies {
            skies.prepare(device, queue, encoder, views);
            if let Some(timer) = &mut timer {
                timer.end_of_pass(device, queue, encoder, "atmosphere");
            }
        }
        technique.prepare(&mut Frame { device, queue, encoder, views, time_s, shared, objects, timer })
    }

    /// Draws the scene's objects and the water as `views[view]` of the last [`Water::prepare`] sees them, with
    /// depth test and depth write. It changes the pass's pipeline, bind groups 0 to 3, vertex buffers and the
    /// index buffer.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        self.draw_objects(pass, view);
        self.draw_surface(pass, view);
    }

    /// As [`Water::draw`], but the unit normal in the world's axes in place of colour, and in alpha the luminance of the
    /// sun's glitter, kcd/m². The answer is whether the scene's technique has that; see [`WaterOptions::aux`]. The target's
    /// colour must hold such numbers: a float format.
    pub fn draw_aux(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) -> bool {
        self.draw_surface_aux(pass, view) && self.draw_objects_aux(pass, view)
    }

    pub(crate) fn draw_objects_aux(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) -> bool {
        let Some(objects) = &self.aux_objects else { return false };
        objects.draw(pass, &self.shared, &self.objects, view, Role::Main);
        true
    }

    pub(crate) fn draw_surface_aux(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) -> bool {
        self.shared.bind(pass, view, Role::Main);
        self.technique.draw_aux(pass, view)
    }

    pub(crate) fn draw_objects(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        self.object_pass.draw(pass, &self.shared, &self.objects, view, Role::Main);
    }

    pub(crate) fn draw_surface(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        self.shared.bind(pass, view, Role::Main);
        self.technique.draw(pass, view);
    }

    /// Draws the scene's sky behind everything that is in the pass already.
    pub fn draw_sky(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        self.shared.bind(pass, view, Role::Main);
        if !self.technique.draw_sky(pass, view) {
            self.sky.draw(pass, &self.shared, view, Role::Main);
        }
    }

    /// Groups 0 and 1.
    pub(crate) fn shared(&self) -> &Shared {
        &self.shared
    }

    pub(crate) fn has_objects(&self) -> bool {
        !self.objects.is_empty()
    }
}

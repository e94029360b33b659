//! One picture without a window.

mod filter;
mod layers;
mod supersampled;

pub use filter::{FILTER_RADIUS_PX, MAX_SAMPLES, sample_offsets_px};
pub use layers::{AuxPicture, Shading, Shows, render_aux};
pub use supersampled::{LightPicture, LightUnit, render_light, render_supersampled};

use crate::environment::Environment;
use crate::gpu::{checked, read_texture};
use crate::surface::Backend;
use crate::technique::spectral_ocean::Feature;
use crate::timing::PassTimer;
use crate::{FeatureTime, Gpu, PassTime, RenderError, TargetFormat, View, Water, WaterOptions};
use whitecap_scene::{Scene, Technique};

/// What to render.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureRequest {
    /// Width in pixels, at least 1.
    pub width: u32,
    /// Height in pixels, at least 1.
    pub height: u32,
    /// Simulation time, seconds.
    pub time_s: f64,
    /// Who works a spectral sea out; `None` leaves it to [`Backend::auto`].
    pub backend: Option<Backend>,
}

impl PictureRequest {
    fn options(&self) -> WaterOptions {
        WaterOptions { backend: self.backend, ..Default::default() }
    }
}

/// A picture of 8-bit display values (sRGB), rows from the top, RGBA.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Four bytes a pixel.
    pub rgba8: Vec<u8>,
}

/// The steps of [`render_picture`], in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The sky and its reflections are computed.
    Sky,
    /// Shaders are compiled and the sea is set up.
    Setup,
    /// The sea is evaluated and drawn.
    Draw,
    /// The picture is brought back from the device.
    ReadBack,
}

impl Stage {
    /// All of them, in order.
    pub const ALL: &[Stage] = &[Stage::Sky, Stage::Setup, Stage::Draw, Stage::ReadBack];

    /// In a word or two.
    pub fn label(self) -> &'static str {
        match self {
            Stage::Sky => "sky",
            Stage::Setup => "set-up",
            Stage::Draw => "draw",
            Stage::ReadBack => "read-back",
        }
    }
}

/// Samples of a pixel in a still that nobody asked more or fewer for: glints are finer than pixels, and nobody waits for a frame.
pub const SAMPLES_OF_STILL: u32 = 4;

/// Display values cannot be averaged as light can: their stills are shaded for each of the adapter's own samples.
const STILL: TargetFormat = TargetFormat {
    color: wgpu::TextureFormat::Rgba8Unorm,
    depth: wgpu::TextureFormat::Depth32Float,
    depth_compare: wgpu::CompareFunction::Greater,
    sample_count: SAMPLES_OF_STILL,
    sample_shading: true,
};

/// Pictures of one scene at one size. What one of them has set up serves the next: the light around in any case, the sea and its
/// pipelines where both are drawn into the same format, as all stills of several samples and auxiliary pictures are. So
/// the frames of a sequence: [`Pictures::at`] goes on to another moment.
pub struct Pictures<'a> {
    gpu: &'a Gpu,
    scene: &'a Scene,
    request: PictureRequest,
    expects_aux: bool,
    environment: Option<Environment>,
    set_up: Option<SetUp>,
}

impl<'a> Pictures<'a> {
    /// Nothing is set up before the first picture is asked for.
    pub fn new(gpu: &'a Gpu, scene: &'a Scene, request: &PictureRequest) -> Self {
        Pictures { gpu, scene, request: *request, expects_aux: false, environment: None, set_up: None }
    }

    /// Goes on to another moment, `time_s` in seconds. What is drawn then does not depend on what was drawn before.
    pub fn at(&mut self, time_s: f64) -> &mut Self {
        self.request.time_s = time_s;
        self
    }

    /// The same, whose set-up for a still serves [`Pictures::aux`], too.
    pub fn expecting_aux(self) -> Self {
        Pictures { expects_aux: true, ..self }
    }

    /// As [`render_picture`]. `progress` hears of each stage that there is something to do in.
    ///
    /// # Errors
    ///
    /// As [`render_picture`].
    pub fn picture(&mut self, progress: &mut dyn FnMut(Stage)) -> Result<Picture, RenderError> {
        let result = self.draw(progress);
        self.unless_lost(result)
    }

    /// A lost device makes every later call fail; what matters is that it was lost.
    fn unless_lost<T>(&self, result: Result<T, RenderError>) -> Result<T, RenderError> {
        if result.is_err() {
            self.gpu.check()?;
        }
        result
    }

    fn draw(&mut self, progress: &mut dyn FnMut(Stage)) -> Result<Picture, RenderError> {
        if self.scene.technique.is_scene_linear() {
            let mut begun = |stage, done| {
                if stage != Stage::Draw || done == 0 {
                    progress(stage);
                }
            };
            return self.supersampled(SAMPLES_OF_STILL, &mut begun);
        }
        let (gpu, view, time_s) = (self.gpu, self.view(), self.request.time_s);
        let (device, queue) = (&gpu.device, &gpu.queue);
        let SetUp { water, attachments, .. } = self.set_up(&STILL, progress)?;
        progress(Stage::Draw);
        checked(device, "the frame", || {
            let mut encoder = device.create_command_encoder(&Default::default());
            water.prepare(device, queue, &mut encoder, &[view], time_s)?;
            let mut pass = attachments.begin(&mut encoder, &STILL, true);
            water.draw(&mut pass, 0);
            water.draw_sky(&mut pass, 0);
            drop(pass);
            submit(gpu, encoder)
        })?;
        progress(Stage::ReadBack);
        read_picture(gpu, &attachments.resolved)
    }

    fn view(&self) -> View {
        View::of_camera(&self.scene.camera, [self.request.width, self.request.height])
    }

    /// The water that is drawn into `target`: what the picture before has left, if that will do.
    fn set_up(
        &mut self,
        target: &TargetFormat,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<&mut SetUp, RenderError> {
        let (device, queue, view) = (&self.gpu.device, &self.gpu.queue, self.view());
        let aux = self.expects_aux && *target == layers::TARGET && self.scene.technique.is_scene_linear();
        let serves = |set_up: &SetUp| set_up.target == *target && (set_up.aux || !aux);
        let left = self.set_up.take().filter(serves);
        let set_up = match left {
            Some(set_up) => set_up,
            None => {
                check_size(device, &self.request)?;
                let environment = match self.environment.take() {
                    Some(environment) => environment,
                    None => {
                        progress(Stage::Sky);
                        Environment::new(self.scene)?
                    }
                };
                let environment = self.environment.insert(environment);
                progress(Stage::Setup);
                let options = WaterOptions { aux, ..self.request.options() };
                let water = Water::with_options(device, queue, self.scene, environment, *target, &options)?;
                let attachments = checked(device, "a picture of this size", || {
                    Ok(Attachments::new(device, &self.request, target))
                })?;
                let exposure = environment.light.as_ref().map(|light| light.exposure_of(&view));
                SetUp { water, attachments, exposure, target: *target, aux }
            }
        };
        Ok(self.set_up.insert(set_up))
    }
}

/// Renders `scene` as its camera sees it, [`SAMPLES_OF_STILL`] times a pixel: as [`render_supersampled`] where a technique works in
/// light, with the adapter's own samples elsewhere. `progress` hears of each stage as it begins.
///
/// # Errors
///
/// [`RenderError::LimitExceeded`] for a size of 0 or beyond the adapter's limit; what the scene or the
/// device refuses otherwise.
pub fn render_picture(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    progress: &mut dyn FnMut(Stage),
) -> Result<Picture, RenderError> {
    Pictures::new(gpu, scene, request).picture(progress)
}

/// The water and what it is drawn into.
struct SetUp {
    water: Water,
    attachments: Attachments,
    /// What radiance of 1 kcd/m² becomes in the picture's linear light, if that is what the water is drawn in.
    exposure: Option<f32>,
    target: TargetFormat,
    /// Whether it has the pipelines of auxiliary pictures.
    aux: bool,
}

/// Submits, and waits until it is done.
fn submit(gpu: &Gpu, encoder: wgpu::CommandEncoder) -> Result<(), RenderError> {
    gpu.queue.submit([encoder.finish()]);
    gpu.device
        .poll(wgpu::PollType::wait_indefinitely())
        .map_err(|e| RenderError::DeviceLost { reason: e.to_string() })?;
    Ok(())
}

fn read_picture(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Picture, RenderError> {
    let mut rgba8 =
        checked(&gpu.device, "the picture's read-back", || read_texture(&gpu.device, &gpu.queue, texture))?;
    // Alpha is a matter between a technique and its host; a picture is opaque.
    rgba8.iter_mut().skip(3).step_by(4).for_each(|alpha| *alpha = u8::MAX);
    gpu.check()?;
    Ok(Picture { width: texture.width(), height: texture.height(), rgba8 })
}

/// Renders `runs` frames of `scene`, a thirtieth of a second apart, as a window would show them (one sample a
/// pixel), and gives the median time of each pass. A frame before them, which compiles and warms up, does not
/// count.
///
/// # Errors
///
/// As [`render_picture`].
pub fn time_passes(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    runs: usize,
) -> Result<Vec<PassTime>, RenderError> {
    let frames = timed_frames(gpu, scene, request, runs, &[None])?;
    Ok(frames.iter().flat_map(|frames| medians(frames)).collect())
}

/// As [`time_passes`], and by how much the water's pass is longer than without each [`Feature`]: the median difference of frames
/// that are drawn in turns. Features share work, so they need not add up. None for techniques that have none.
///
/// # Errors
///
/// As [`render_picture`].
pub fn time_features(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    runs: usize,
) -> Result<(Vec<PassTime>, Vec<FeatureTime>), RenderError> {
    if !matches!(scene.technique, Technique::SpectralOcean(_)) {
        return Ok((time_passes(gpu, scene, request, runs)?, Vec::new()));
    }
    let variants: Vec<Option<Feature>> =
        std::iter::once(None).chain(Feature::ALL.iter().copied().map(Some)).collect();
    let frames = timed_frames(gpu, scene, request, runs, &variants)?;
    let Some((whole, rest)) = frames.split_first() else { return Ok((Vec::new(), Vec::new())) };
    let water_ms =
        |passes: &[PassTime]| passes.iter().find(|pass| pass.name == WATER).map_or(f64::NAN, |pass| pass.ms);
    let cost = |(feature, without): (&Feature, &Vec<Vec<PassTime>>)| {
        let turns = whole.iter().zip(without);
        let differences = turns.map(|(whole, without)| water_ms(whole) - water_ms(without));
        FeatureTime { name: feature.label(), ms: median(differences.collect()) }
    };
    Ok((medians(whole), Feature::ALL.iter().zip(rest).map(cost).collect()))
}

/// The pass that draws the water.
const WATER: &str = "water";

/// For each variant, the passes of each frame. The variants take turns.
fn timed_frames(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    runs: usize,
    variants: &[Option<Feature>],
) -> Result<Vec<Vec<Vec<PassTime>>>, RenderError> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    check_size(device, request)?;
    let target = TargetFormat::default();
    let options = request.options();
    let environment = Environment::new(scene)?;
    let water = |without: &Option<Feature>| {
        Water::without(device, queue, scene, &environment, target, &options, *without)
    };
    let mut waters = variants.iter().map(water).collect::<Result<Vec<_>, _>>()?;
    let attachments =
        checked(device, "a picture of this size", || Ok(Attachments::new(device, request, &target)))?;
    let view = View::of_camera(&scene.camera, [request.width, request.height]);
    let mut frames: Vec<Vec<Vec<PassTime>>> = vec![Vec::new(); variants.len()];
    for (run, variant) in (0..=runs).flat_map(|run| (0..variants.len()).map(move |variant| (run, variant))) {
        let water = &mut waters[variant];
        let passes = checked(device, "the frame", || {
            let mut encoder = device.create_command_encoder(&Default::default());
            let mut timer = PassTimer::start();
            let time_s = request.time_s + run as f64 / 30.0;
            water.prepare_timed(device, queue, &mut encoder, &[view], time_s, Some(&mut timer))?;
            if water.has_objects() {
                water.draw_objects(&mut attachments.begin(&mut encoder, &target, true), 0);
                timer.end_of_pass(device, queue, &mut encoder, "objects");
            }
            water.draw_surface(&mut attachments.begin(&mut encoder, &target, !water.has_objects()), 0);
            timer.end_of_pass(device, queue, &mut encoder, WATER);
            water.draw_sky(&mut attachments.begin(&mut encoder, &target, false), 0);
            timer.end_of_pass(device, queue, &mut encoder, "sky");
            Ok(timer.passes())
        })?;
        gpu.check()?;
        if run > 0 {
            frames[variant].push(passes);
        }
    }
    Ok(frames)
}

/// The median time of each pass over all frames, which have the same passes.
fn medians(frames: &[Vec<PassTime>]) -> Vec<PassTime> {
    let passes = frames.first().map_or(&[][..], Vec::as_slice).iter().enumerate();
    passes
        .map(|(i, pass)| {
            let ms = frames.iter().filter_map(|frame| frame.get(i)).map(|pass| pass.ms);
            PassTime { name: pass.name, ms: median(ms.collect()) }
        })
        .collect()
}

/// NaN of nothing.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn check_size(device: &wgpu::Device, request: &PictureRequest) -> Result<(), RenderError> {
    let limit = device.limits().max_texture_dimension_2d;
    for (what, asked) in [("the picture's width", request.width), ("the picture's height", request.height)] {
        if asked == 0 || asked > limit {
            return Err(RenderError::LimitExceeded {
                what: what.into(),
                asked: u64::from(asked),
                accepted: format!("1 to {limit} pixels"),
            });
        }
    }
    Ok(())
}

struct Attachments {
    /// Where pixels have several samples.
    color: Option<wgpu::TextureView>,
    depth: wgpu::Texture,
    resolved: wgpu::Texture,
}

impl Attachments {
    fn new(device: &wgpu::Device, request: &PictureRequest, target: &TargetFormat) -> Attachments {
        let texture = |label, format, sample_count, usage| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d {
                    width: request.width,
                    height: request.height,
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        use wgpu::TextureUsages as U;
        let samples = target.sample_count;
        let color = || texture("samples", target.color, samples, U::RENDER_ATTACHMENT);
        // What has one sample may be read back, or read by a pass that follows.
        let reading = U::COPY_SRC | U::TEXTURE_BINDING;
        let depth_reading = if samples > 1 { U::empty() } else { reading };
        Attachments {
            color: (samples > 1).then(|| color().create_view(&Default::default())),
            depth: texture("depth", target.depth, samples, U::RENDER_ATTACHMENT | depth_reading),
            resolved: texture("picture", target.color, 1, U::RENDER_ATTACHMENT | reading),
        }
    }

    /// The pass that draws the picture; `first` if nothing has been drawn yet.
    fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        target: &TargetFormat,
        first: bool,
    ) -> wgpu::RenderPass<'e> {
        let resolved = self.resolved.create_view(&Default::default());
        let (color, depth) = if first {
            (wgpu::LoadOp::Clear(wgpu::Color::BLACK), wgpu::LoadOp::Clear(target.far_depth()))
        } else {
            (wgpu::LoadOp::Load, wgpu::LoadOp::Load)
        };
        // Samples are resolved in one pass; without them each pass goes on where the last one ended.
        let store = if self.color.is_some() { wgpu::StoreOp::Discard } else { wgpu::StoreOp::Store };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: self.color.as_ref().unwrap_or(&resolved),
                depth_slice: None,
                resolve_target: self.color.is_some().then_some(&resolved),
                ops: wgpu::Operations { load: color, store },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth.create_view(&Default::default()),
                depth_ops: Some(wgpu::Operations { load: depth, store }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }
}

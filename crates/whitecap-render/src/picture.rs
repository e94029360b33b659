//! One picture without a window.

use crate::environment::Environment;
use crate::gpu::{checked, read_texture};
use crate::{Gpu, RenderError, TargetFormat, View, Water};
use whitecap_scene::Scene;

/// What to render.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureRequest {
    /// Width in pixels, at least 1.
    pub width: u32,
    /// Height in pixels, at least 1.
    pub height: u32,
    /// Simulation time, seconds.
    pub time_s: f64,
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

/// Stills are shaded four times a pixel: glints are finer than pixels, and nobody waits for a frame.
const STILL: TargetFormat = TargetFormat {
    color: wgpu::TextureFormat::Rgba8Unorm,
    depth: wgpu::TextureFormat::Depth32Float,
    depth_compare: wgpu::CompareFunction::Greater,
    sample_count: 4,
    sample_shading: true,
};

/// Renders `scene` as its camera sees it. `progress` hears of each stage as it begins.
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
    let picture = draw(gpu, scene, request, progress);
    if picture.is_err() {
        // A lost device makes every later call fail; what matters is that it was lost.
        gpu.check()?;
    }
    picture
}

fn draw(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    progress: &mut dyn FnMut(Stage),
) -> Result<Picture, RenderError> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    check_size(device, request)?;
    progress(Stage::Sky);
    let environment = Environment::new(scene)?;
    progress(Stage::Setup);
    let target = STILL;
    let mut water = Water::with_environment(device, queue, scene, &environment, target)?;
    drop(environment);
    let attachments =
        checked(device, "a picture of this size", || Ok(Attachments::new(device, request, &target)))?;
    progress(Stage::Draw);
    let view = View::of_camera(&scene.camera, [request.width, request.height]);
    checked(device, "the frame", || {
        let mut encoder = device.create_command_encoder(&Default::default());
        water.prepare(device, queue, &mut encoder, &[view], request.time_s)?;
        let mut pass = attachments.begin(&mut encoder, &target);
        water.draw(&mut pass, 0);
        water.draw_sky(&mut pass, 0);
        drop(pass);
        queue.submit([encoder.finish()]);
        device
            .poll(wgpu::PollType::wait_indefinitely())
            .map_err(|e| RenderError::DeviceLost { reason: e.to_string() })?;
        Ok(())
    })?;
    progress(Stage::ReadBack);
    let rgba8 =
        checked(device, "the picture's read-back", || read_texture(device, queue, &attachments.resolved))?;
    gpu.check()?;
    Ok(Picture { width: request.width, height: request.height, rgba8 })
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
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
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
        let color = texture("samples", target.color, samples, U::RENDER_ATTACHMENT);
        let depth = texture("depth", target.depth, samples, U::RENDER_ATTACHMENT);
        Attachments {
            color: color.create_view(&Default::default()),
            depth: depth.create_view(&Default::default()),
            resolved: texture("picture", target.color, 1, U::RENDER_ATTACHMENT | U::COPY_SRC),
        }
    }

    fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        target: &TargetFormat,
    ) -> wgpu::RenderPass<'e> {
        let resolved = self.resolved.create_view(&Default::default());
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color,
                depth_slice: None,
                resolve_target: Some(&resolved),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(target.far_depth()),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }
}

//! The water that is drawn: built from a scene, kept as long as it draws what the scene says.

use std::sync::Arc;
use whitecap_render::environment::Environment;
use whitecap_render::{Gpu, RenderError, TargetFormat, View, Water};
use whitecap_scene::{Picture, Scene, Sky};

/// The light of a scene, and what it was made of.
struct Light {
    environment: Environment,
    sky: Sky,
    picture: Picture,
    is_linear: bool,
}

/// A scene's water on a device, with the attachments of the passes that it is drawn in.
pub(crate) struct Stage {
    gpu: Arc<Gpu>,
    target: TargetFormat,
    light: Option<Light>,
    water: Option<Water>,
    attachments: Option<Attachments>,
}

struct Attachments {
    size_px: [u32; 2],
    /// Where pixels have several samples.
    color: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
}

impl Stage {
    /// For a surface of this colour.
    pub(crate) fn new(gpu: Arc<Gpu>, color: wgpu::TextureFormat) -> Stage {
        let sample_count = if gpu.adapter.is_software() { 1 } else { 4 };
        let target = TargetFormat { color, sample_count, ..TargetFormat::default() };
        Stage { gpu, target, light: None, water: None, attachments: None }
    }

    /// Builds the water anew for a scene. If that fails, what was there goes on being drawn.
    pub(crate) fn show(&mut self, scene: &Scene) -> Result<(), RenderError> {
        let is_linear = scene.technique.is_scene_linear();
        let is_lit = self.light.as_ref().is_some_and(|light| {
            light.sky == scene.sky && light.picture == scene.picture && light.is_linear == is_linear
        });
        if !is_lit {
            let environment = Environment::new(scene)?;
            let (sky, picture) = (scene.sky.clone(), scene.picture.clone());
            self.light = Some(Light { environment, sky, picture, is_linear });
        }
        let Some(light) = &self.light else { return Ok(()) };
        let Gpu { device, queue, .. } = &*self.gpu;
        self.water = Some(Water::with_environment(device, queue, scene, &light.environment, self.target)?);
        Ok(())
    }

    /// Draws the water and its sky at `time_s` over all of `target`, whose size the view has.
    pub(crate) fn draw(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::TextureView,
        view: &View,
        time_s: f64,
    ) -> Result<(), RenderError> {
        let Gpu { device, queue, .. } = &*self.gpu;
        let Some(water) = &mut self.water else { return Ok(()) };
        water.prepare(device, queue, encoder, std::slice::from_ref(view), time_s)?;
        if self.attachments.as_ref().is_none_or(|attachments| attachments.size_px != view.size_px) {
            self.attachments = Some(Attachments::new(device, &self.target, view.size_px));
        }
        let Some(attachments) = &self.attachments else { return Ok(()) };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("water"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: attachments.color.as_ref().unwrap_or(target),
                depth_slice: None,
                resolve_target: attachments.color.is_some().then_some(target),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store: if attachments.color.is_some() {
                        wgpu::StoreOp::Discard
                    } else {
                        wgpu::StoreOp::Store
                    },
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &attachments.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(self.target.far_depth()),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        water.draw(&mut pass, 0);
        water.draw_sky(&mut pass, 0);
        Ok(())
    }
}

impl Attachments {
    fn new(device: &wgpu::Device, target: &TargetFormat, size_px: [u32; 2]) -> Attachments {
        let texture = |label, format| {
            device
                .create_texture(&wgpu::TextureDescriptor {
                    label: Some(label),
                    size: wgpu::Extent3d { width: size_px[0], height: size_px[1], depth_or_array_layers: 1 },
                    mip_level_count: 1,
                    sample_count: target.sample_count,
                    dimension: wgpu::TextureDimension::D2,
                    format,
                    usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                    view_formats: &[],
                })
                .create_view(&Default::default())
        };
        Attachments {
            size_px,
            color: (target.sample_count > 1).then(|| texture("samples", target.color)),
            depth: texture("depth", target.depth),
        }
    }
}

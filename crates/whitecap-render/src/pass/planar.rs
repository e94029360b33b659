//! Mirror and refraction maps: the scene without its water, on one side of the water's plane.

use super::{ObjectPass, SkyPass};
use crate::TargetFormat;
use crate::gpu::resources::texture_2d;
use crate::technique::{Build, Frame};
use crate::uniforms::Role;

/// What a planar map shows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlanarSettings {
    pub(crate) role: Role,
    pub(crate) size_px: [u32; 2],
    /// Whether the sky is drawn behind the objects. Without it the map is transparent there.
    pub(crate) sky: bool,
    /// What is where nothing is drawn, display-referred.
    pub(crate) background: [f64; 4],
    /// How far the map reaches past the plane, metres, so that no seam opens where waves lift its edge.
    pub(crate) margin_m: f32,
}

/// Renders the objects, and the sky if asked for, into a map for each view: mirrored in the level y = 0 and
/// without what lies under it, or as they are and without what lies over it. Raw 8-bit colour, no sRGB.
///
/// Reads: the objects and the environment. Writes: [`PlanarPass::map`].
pub(crate) struct PlanarPass {
    settings: PlanarSettings,
    target: TargetFormat,
    objects: ObjectPass,
    sky: Option<SkyPass>,
    depth: wgpu::TextureView,
    maps: Vec<wgpu::TextureView>,
}

impl PlanarPass {
    pub(crate) fn new(build: &Build<'_>, settings: PlanarSettings) -> PlanarPass {
        let (device, shared) = (build.device, build.shared);
        // The host's sense of depth, since its projection is used.
        let target = TargetFormat {
            color: wgpu::TextureFormat::Rgba8Unorm,
            depth: wgpu::TextureFormat::Depth32Float,
            sample_count: 1,
            sample_shading: false,
            ..shared.target
        };
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let depth = texture_2d(device, "planar depth", settings.size_px, 1, target.depth, usage);
        PlanarPass {
            target,
            objects: ObjectPass::new(device, shared, build.objects, &target),
            sky: settings.sky.then(|| SkyPass::new(device, shared, &target)),
            depth: depth.create_view(&Default::default()),
            maps: Vec::new(),
            settings,
        }
    }

    /// Renders the map of view `index` of the frame.
    pub(crate) fn render(&mut self, frame: &mut Frame<'_>, index: usize) {
        let Some(view) = frame.views.get(index) else { return };
        let settings = self.settings;
        self.make_maps(frame.device, index + 1);
        frame.shared.write_view(frame.queue, index, view, settings.role, &self.target, settings.margin_m);
        let [r, g, b, a] = settings.background;
        let mut pass = frame.encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("planar map"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.maps[index],
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(self.target.far_depth()),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        self.objects.draw(&mut pass, frame.shared, frame.objects, index, settings.role);
        if let Some(sky) = &self.sky {
            sky.draw(&mut pass, frame.shared, index, settings.role);
        }
    }

    /// The map of a view. It is the same texture from frame to frame.
    pub(crate) fn map(&mut self, device: &wgpu::Device, index: usize) -> &wgpu::TextureView {
        self.make_maps(device, index + 1);
        &self.maps[index]
    }

    fn make_maps(&mut self, device: &wgpu::Device, count: usize) {
        while self.maps.len() < count {
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
            let map = texture_2d(device, "planar map", self.settings.size_px, 1, self.target.color, usage);
            self.maps.push(map.create_view(&Default::default()));
        }
    }
}

#[cfg(test)]
pub(crate) mod tests;

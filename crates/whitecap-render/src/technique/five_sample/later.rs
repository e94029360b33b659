//! What Berglund left for later: the ground under the water, and the maps of what stands in it.

use super::super::{Build, Frame};
use crate::RenderError;
use crate::gpu::resources::{self, linear_sampler, texture_2d, write_level};
use crate::pass::{PlanarPass, PlanarSettings};
use crate::uniforms::{Role, sampler_entry, texture_entry};
use glam::DVec2;
use whitecap_scene::mesh::Ground;
use whitecap_scene::technique as settings;

/// Texels along a side of the mirror and the refraction map.
const MAP_PX: u32 = 1024;
const SOFTWARE_MAP_PX: u32 = 512;

/// How far the maps reach past the water's plane, metres: no gap opens where waves push them about.
const MARGIN_M: f32 = 0.15;

/// Bind group 3, as `later.wesl` declares it.
pub(super) struct Later {
    pub(super) layout: wgpu::BindGroupLayout,
    place: Option<GroundPlace>,
    ground: wgpu::TextureView,
    nothing: wgpu::TextureView,
    sampler: wgpu::Sampler,
    mirror: Option<PlanarPass>,
    bottom: Option<PlanarPass>,
    /// One for each view.
    groups: Vec<wgpu::BindGroup>,
}

/// Where the ground's grid lies.
#[derive(Clone, Copy, Debug)]
struct GroundPlace {
    north_west_m: DVec2,
    points_per_m: DVec2,
}

impl Later {
    pub(super) fn new(build: &Build<'_>, settings: &settings::FiveSample) -> Result<Later, RenderError> {
        use wgpu::ShaderStages as S;
        let (device, queue) = (build.device, build.queue);
        let d2 = wgpu::TextureViewDimension::D2;
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("five-sample later"),
            entries: &[
                texture_entry(0, S::FRAGMENT, d2, false),
                texture_entry(1, S::FRAGMENT, d2, true),
                texture_entry(2, S::FRAGMENT, d2, true),
                sampler_entry(3, S::FRAGMENT),
            ],
        });
        let ground = build.objects.ground();
        let (place, heights) = match &ground {
            Some(ground) => (Some(GroundPlace::of(ground)), ground.heights_m()),
            None => (None, &[Ground::NOWHERE_M; 4][..]),
        };
        let side = ground.as_ref().map_or(2, Ground::resolution) as u32;
        let format = wgpu::TextureFormat::R32Float;
        let usage = wgpu::TextureUsages::COPY_DST;
        let texture = texture_2d(device, "ground", [side, side], 1, format, usage);
        write_level(queue, &texture, 0, bytemuck::cast_slice(heights));

        let nothing = texture_2d(device, "nothing", [1, 1], 1, wgpu::TextureFormat::Rgba8Unorm, usage);
        write_level(queue, &nothing, 0, &[0; 4]);
        let px = if build.is_software() { SOFTWARE_MAP_PX } else { MAP_PX };
        let planar = |role| {
            PlanarPass::new(
                build,
                PlanarSettings {
                    role,
                    size_px: [px, px],
                    sky: false,
                    background: [0.0; 4],
                    margin_m: MARGIN_M,
                },
            )
        };
        Ok(Later {
            layout,
            place,
            ground: texture.create_view(&Default::default()),
            nothing: nothing.create_view(&Default::default()),
            sampler: linear_sampler(device, "planar", wgpu::AddressMode::ClampToEdge),
            mirror: settings.reflected_geometry.then(|| planar(Role::Mirror)),
            // Where water draws back, the bare ground is seen too.
            bottom: (settings.depth_fog || settings.waves_meet_land).then(|| planar(Role::Refraction)),
            groups: Vec::new(),
        })
    }

    /// Renders the maps of every view.
    pub(super) fn prepare(&mut self, frame: &mut Frame<'_>) {
        for (name, map) in [("mirror map", &mut self.mirror), ("refraction map", &mut self.bottom)] {
            let Some(map) = map else { continue };
            for index in 0..frame.views.len() {
                map.render(frame, index);
            }
            frame.end_of_pass(name);
        }
        for index in self.groups.len()..frame.views.len() {
            let group = self.group(frame.device, index);
            self.groups.push(group);
        }
    }

    pub(super) fn bind(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        if let Some(group) = self.groups.get(view) {
            pass.set_bind_group(3, group, &[]);
        }
    }

    /// The ground's north-western corner from the eye, and its grid points to a metre. Without any ground, a place
    /// so far away that no pixel finds it.
    pub(super) fn ground_from(&self, eye_m: DVec2) -> ([f32; 2], [f32; 2]) {
        match self.place {
            Some(place) => {
                ((place.north_west_m - eye_m).as_vec2().to_array(), place.points_per_m.as_vec2().to_array())
            }
            None => ([f32::MAX; 2], [1.0; 2]),
        }
    }

    fn group(&mut self, device: &wgpu::Device, index: usize) -> wgpu::BindGroup {
        let mirror = self.mirror.as_mut().map(|map| map.map(device, index));
        let bottom = self.bottom.as_mut().map(|map| map.map(device, index));
        use wgpu::BindingResource::{Sampler, TextureView};
        let resources = [
            TextureView(&self.ground),
            TextureView(mirror.unwrap_or(&self.nothing)),
            TextureView(bottom.unwrap_or(&self.nothing)),
            Sampler(&self.sampler),
        ];
        resources::bind_group(device, "five-sample later", &self.layout, resources)
    }
}

impl GroundPlace {
    fn of(ground: &Ground) -> GroundPlace {
        GroundPlace { north_west_m: ground.bounds()[0], points_per_m: 1.0 / ground.cell_m() }
    }
}

/// How far below sea level the water's edge is, metres. Twin of `swash_drop_m` in `shore.wesl`.
#[cfg(test)]
pub(super) fn swash_drop_m(turns: f64, height_m: f64) -> f64 {
    height_m * (1.0 - (std::f64::consts::TAU * turns).cos())
}

/// The share of waves that is left in water of this depth. Twin of `shoal` in `shore.wesl`.
#[cfg(test)]
pub(super) fn shoal(depth_m: f64, shore_depth_m: f64) -> f64 {
    let t = (depth_m / shore_depth_m).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Where in its period a wave is over ground of this depth, turns. Twin of `swash_phase` in `shore.wesl`.
#[cfg(test)]
pub(super) fn swash_phase(depth_m: f64, turns: f64, height_m: f64) -> f64 {
    turns + depth_m / (6.0 * height_m.max(0.01))
}

//! The air between the eye and what it sees, for techniques that draw in linear light.
//!
//! Two tables for each view, made by compute passes after Hillaire 2020 (sections 5.3 and 5.4): the sky from the view's eye,
//! and what the air adds and takes before anything in any direction at any distance. They hold for the height of the eye
//! alone, not for where it looks: a turn of the head, a mirror map or a reflection reads the same ones, and they are made
//! anew only when that height changes. `sky_light.wesl` reads them.
//!
//! Hillaire's volume follows the picture. Ours goes by azimuth from the sun, elevation from the horizon and the root of the
//! share of the way to where the ray ends, and holds the light that the air adds over the share that it takes: that hardly
//! changes along a ray, so that 48 × 80 × 48 entries do for a whole sphere.

use crate::View;
use crate::environment::{Air, Light, SUN_KLX};
use crate::gpu::resources::{bind_group, buffer, texture_2d, write_level};
use crate::shader_lib::{self, Shader};
use crate::uniforms::{texture_entry, uniform_entry};
use glam::{DVec3, Vec3};
use half::f16;
use whitecap_scene::ToneMap;
use whitecap_waves::optics::atmosphere::{LOWEST_EYE_M, Table, horizon_rad};

/// The highest eye that the tables are made for, metres.
const HIGHEST_EYE_M: f64 = 60e3;

/// Clouds have vanished for an eye at the height of their layer, and begin to below it, metres.
const CLOUDS_FADE_M: [f64; 2] = [3e3, 9e3];

/// Entries of the tables, as `sky_light.wesl` has them.
const SKY_SIZE: [u32; 2] = [128, 128];
const AERIAL_SIZE: [u32; 3] = [48, 80, 48];

/// Layout twin of `GpuAir` in `atmosphere.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct GpuAir {
    toward_sun: [f32; 3],
    sun_radius_rad: f32,
    sun_klx: [f32; 3],
    haze: f32,
    eye_km: f32,
    horizon_rad: f32,
    clouds: f32,
    visibility_m: f32,
}

/// Layout twin of `GpuPicture` in `tone_map.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct GpuPicture {
    exposure: f32,
    tone_map: u32,
}

impl GpuPicture {
    fn of(light: &Light) -> GpuPicture {
        let tone_map = match light.tone_map {
            ToneMap::Agx => 0,
            ToneMap::Aces => 1,
            ToneMap::PbrNeutral => 2,
            ToneMap::None => 3,
        };
        GpuPicture { exposure: light.exposure, tone_map }
    }
}

/// Bindings 3 to 8 of group 1, where techniques draw in linear light; 9 is the passes' own.
pub(crate) fn sky_layout_entries(stages: wgpu::ShaderStages) -> [wgpu::BindGroupLayoutEntry; 6] {
    use wgpu::TextureViewDimension::{D2, D3};
    [
        uniform_entry(3, stages),
        uniform_entry(4, stages),
        texture_entry(5, stages, D2, true),
        texture_entry(6, stages, D2, true),
        texture_entry(7, stages, D3, true),
        texture_entry(8, stages, D2, true),
    ]
}

/// The light around as all views share it: bindings 0 to 2 of group 1.
pub(crate) struct Around {
    pub(crate) cube: wgpu::TextureView,
    pub(crate) sampler: wgpu::Sampler,
    pub(crate) sun: wgpu::Buffer,
}

impl Around {
    pub(crate) fn resources(&self) -> [wgpu::BindingResource<'_>; 3] {
        use wgpu::BindingResource::{Sampler, TextureView};
        [TextureView(&self.cube), Sampler(&self.sampler), self.sun.as_entire_binding()]
    }
}

/// Each view's sky.
pub(crate) struct Skies {
    around: Around,
    picture: wgpu::Buffer,
    layout: wgpu::BindGroupLayout,
    /// What does not depend on the eye.
    air: GpuAir,
    has_clouds: bool,
    /// Where the sky is computed: the tables of the air, and who makes those of a view from them.
    passes: Option<Passes>,
    sea_level_sky: wgpu::TextureView,
    transmittance: wgpu::TextureView,
    views: Vec<ViewSky>,
    /// Whose sky each view of the last frame has: its own, or that of an earlier view whose eye is as high.
    shared: Vec<usize>,
}

struct Passes {
    multiple: wgpu::TextureView,
    sky_view: wgpu::ComputePipeline,
    aerial: wgpu::ComputePipeline,
}

struct ViewSky {
    uniform: wgpu::Buffer,
    group: wgpu::BindGroup,
    /// The groups of both passes.
    made_by: Option<[[wgpu::BindGroup; 2]; 2]>,
    /// The eye that the tables are for, metres.
    eye_m: Option<f64>,
}

impl Skies {
    pub(crate) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        light: &Light,
        layout: &wgpu::BindGroupLayout,
        around: Around,
    ) -> Skies {
        let nothing = || table(device, queue, "no table", [1, 1], &[DVec3::ZERO], 1.0);
        let sun =
            light.sun.map_or((Vec3::Y, Vec3::ZERO, 1.0), |s| (s.toward, s.illuminance_klx, s.radius_rad));
        let mut air = GpuAir {
            toward_sun: sun.0.to_array(),
            sun_klx: sun.1.to_array(),
            sun_radius_rad: sun.2,
            haze: 0.0,
            eye_km: 0.0,
            horizon_rad: 0.0,
            clouds: 0.0,
            visibility_m: 0.0,
        };
        let (sea_level_sky, transmittance, passes, has_clouds) = match &light.air {
            Air::Computed { atmosphere, sea_level, has_clouds } => {
                air.toward_sun = sea_level.toward_sun().as_vec3().to_array();
                air.sun_klx = [SUN_KLX; 3];
                air.sun_radius_rad = crate::environment::SUN_RADIUS_RAD;
                air.haze = atmosphere.haze() as f32;
                let upload = |label, t: &Table, scale| {
                    table(device, queue, label, t.size().map(|n| n as u32), t.values(), scale)
                };
                let passes = Passes {
                    multiple: upload("multiple scattering", atmosphere.multiple_table(), 1.0),
                    sky_view: pipeline(device, &shader_lib::ATMOSPHERE_SKY_VIEW),
                    aerial: pipeline(device, &shader_lib::ATMOSPHERE_AERIAL),
                };
                (
                    // The table holds roots.
                    upload("sky at sea level", sea_level.table(), f64::from(SUN_KLX).sqrt()),
                    upload("transmittance", atmosphere.transmittance_table(), 1.0),
                    Some(passes),
                    *has_clouds,
                )
            }
            Air::Photographed { visibility_m } => {
                air.visibility_m = *visibility_m;
                (nothing(), nothing(), None, false)
            }
        };
        let picture = GpuPicture::of(light);
        let picture =
            buffer(device, queue, "picture", bytemuck::bytes_of(&picture), wgpu::BufferUsages::UNIFORM);
        let mut skies = Skies {
            around,
            picture,
            layout: layout.clone(),
            air,
            has_clouds,
            passes,
            sea_level_sky,
            transmittance,
            views: Vec::new(),
            shared: Vec::new(),
        };
        skies.make_views(device, 1);
        skies
    }

    /// Group 1 of the first view, which is always there.
    pub(crate) fn first_group(&self) -> &wgpu::BindGroup {
        &self.views[0].group
    }

    /// Group 1 of a view.
    pub(crate) fn group(&self, view: usize) -> Option<&wgpu::BindGroup> {
        self.shared.get(view).and_then(|&owner| self.views.get(owner)).map(|sky| &sky.group)
    }

    /// Makes the tables of views whose eye has changed its height.
    pub(crate) fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        views: &[View],
    ) {
        self.make_views(device, views.len());
        // What single precision does not tell apart is the same eye.
        let eyes_m: Vec<f64> = views
            .iter()
            .map(|view| f64::from(view.eye_m.y.clamp(LOWEST_EYE_M, HIGHEST_EYE_M) as f32))
            .collect();
        self.shared = (0..eyes_m.len())
            .map(|i| eyes_m.iter().position(|eye_m| *eye_m == eyes_m[i]).unwrap_or(i))
            .collect();
        for (i, (sky, &eye_m)) in self.views.iter_mut().zip(&eyes_m).enumerate() {
            if self.shared[i] != i {
                continue;
            }
            if sky.eye_m.replace(eye_m) == Some(eye_m) {
                continue;
            }
            let [low, high] = CLOUDS_FADE_M;
            let faded = ((eye_m - low) / (high - low)).clamp(0.0, 1.0);
            let air = GpuAir {
                eye_km: (eye_m / 1e3) as f32,
                horizon_rad: horizon_rad(eye_m) as f32,
                clouds: if self.has_clouds {
                    (1.0 - faded * faded * (3.0 - 2.0 * faded)) as f32
                } else {
                    0.0
                },
                ..self.air
            };
            queue.write_buffer(&sky.uniform, 0, bytemuck::bytes_of(&air));
            let (Some(passes), Some([sky_view, aerial])) = (&self.passes, &sky.made_by) else { continue };
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some("atmosphere"),
                timestamp_writes: None,
            });
            for (pipeline, groups, [x, y]) in [
                (&passes.sky_view, sky_view, SKY_SIZE),
                (&passes.aerial, aerial, [AERIAL_SIZE[0], AERIAL_SIZE[1]]),
            ] {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, &groups[0], &[]);
                pass.set_bind_group(1, &groups[1], &[]);
                pass.dispatch_workgroups(x.div_ceil(8), y.div_ceil(8), 1);
            }
        }
    }

    fn make_views(&mut self, device: &wgpu::Device, count: usize) {
        while self.views.len() < count {
            self.views.push(self.view(device));
        }
    }

    fn view(&self, device: &wgpu::Device) -> ViewSky {
        use wgpu::BindingResource::{Sampler, TextureView};
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("air"),
            size: size_of::<GpuAir>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let size = |size: u32| if self.passes.is_some() { size } else { 1 };
        let storage = wgpu::TextureUsages::STORAGE_BINDING;
        let sky_view =
            texture_2d(device, "sky", SKY_SIZE.map(size), 1, wgpu::TextureFormat::Rgba16Float, storage)
                .create_view(&Default::default());
        let aerial = volume(device, AERIAL_SIZE.map(size)).create_view(&Default::default());
        let of_view = [
            self.picture.as_entire_binding(),
            uniform.as_entire_binding(),
            TextureView(&sky_view),
            TextureView(&self.sea_level_sky),
            TextureView(&aerial),
            TextureView(&self.transmittance),
        ];
        let resources = self.around.resources().into_iter().chain(of_view);
        let group = bind_group(device, "environment", &self.layout, resources);
        let made_by = self.passes.as_ref().map(|passes| {
            [(&passes.sky_view, &sky_view), (&passes.aerial, &aerial)].map(|(pipeline, target)| {
                let air = [
                    (1, Sampler(&self.around.sampler)),
                    (4, uniform.as_entire_binding()),
                    (8, TextureView(&self.transmittance)),
                    (9, TextureView(&passes.multiple)),
                ];
                [
                    numbered_group(device, &pipeline.get_bind_group_layout(0), &[(0, TextureView(target))]),
                    numbered_group(device, &pipeline.get_bind_group_layout(1), &air),
                ]
            })
        });
        ViewSky { uniform, group, made_by, eye_m: None }
    }
}

/// A bind group whose bindings are not 0, 1, 2 ….
fn numbered_group(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    bindings: &[(u32, wgpu::BindingResource<'_>)],
) -> wgpu::BindGroup {
    let entries: Vec<_> = bindings
        .iter()
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding: *binding, resource: resource.clone() })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("atmosphere"),
        layout,
        entries: &entries,
    })
}

fn pipeline(device: &wgpu::Device, shader: &Shader) -> wgpu::ComputePipeline {
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(shader.name),
        layout: None,
        module: &shader.module(device),
        entry_point: Some("cs_march"),
        compilation_options: Default::default(),
        cache: None,
    })
}

fn volume(device: &wgpu::Device, [width, height, depth]: [u32; 3]) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("aerial perspective"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: depth },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D3,
        format: wgpu::TextureFormat::Rgba16Float,
        usage: wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    })
}

/// A table of colours times `scale` as half floats.
fn table(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    label: &str,
    size: [u32; 2],
    values: &[DVec3],
    scale: f64,
) -> wgpu::TextureView {
    let texel = |v: &DVec3| (*v * scale).extend(1.0).to_array().map(f16::from_f64);
    let texels: Vec<[f16; 4]> = values.iter().map(texel).collect();
    let (format, usage) = (wgpu::TextureFormat::Rgba16Float, wgpu::TextureUsages::COPY_DST);
    let texture = texture_2d(device, label, size, 1, format, usage);
    write_level(queue, &texture, 0, bytemuck::cast_slice(&texels));
    texture.create_view(&Default::default())
}

#[cfg(test)]
mod tests;

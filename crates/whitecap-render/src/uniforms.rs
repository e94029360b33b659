//! What every pass is told: the view, and the light around.

use crate::environment::{CubeMap, Environment, FACE_SIZE, Meter, SUN_RADIUS_RAD, display_from_linear};
use crate::gpu::resources::{bind_group, buffer};
use crate::pass::{Around, Skies, sky_layout_entries};
use crate::{RenderError, TargetFormat, View};
use glam::{Mat4, Vec3, Vec4};

/// Views of one sea that a frame can hold.
pub const MAX_VIEWS: usize = 16;

/// Every downlevel device takes dynamic offsets at multiples of this.
const SLOT_BYTES: usize = 256;

/// Layout twin of `GpuView` in `view.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct GpuView {
    pub(crate) clip_from_eye_world: [[f32; 4]; 4],
    pub(crate) eye_world_from_clip: [[f32; 4]; 4],
    pub(crate) pixel_angle_rad: f32,
    pub(crate) far_depth: f32,
    pub(crate) stores: u32,
    pub(crate) most_radiance: f32,
    pub(crate) clip_plane: [f32; 4],
    pub(crate) exposure_gain: f32,
    pub(crate) end: [u32; 3],
}

/// What a view of the scene is for. All of a view's roles share its eye, so that what lies in the world is placed
/// once for all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// The picture itself.
    Main,
    /// The scene mirrored in the water's plane, without what lies under it.
    Mirror,
    /// The scene as it is, without what lies over the water's plane.
    Refraction,
}

impl Role {
    const COUNT: usize = 3;

    /// The plane as the eye sees it: what is kept has a product with it of 0 or more. `margin_m` lets the maps
    /// reach past the plane, so that no seam opens where waves lift their edge.
    fn clip_plane(self, plane_m: f32, margin_m: f32) -> Vec4 {
        match self {
            Role::Main => Vec4::ZERO,
            Role::Mirror => Vec4::new(0.0, 1.0, 0.0, margin_m - plane_m),
            Role::Refraction => Vec4::new(0.0, -1.0, 0.0, margin_m + plane_m),
        }
    }

    /// Eye-relative world from eye-relative world, mirrored in the level plane at `plane_m`.
    fn mirrored(self, plane_m: f32) -> Mat4 {
        match self {
            Role::Mirror => {
                Mat4::from_cols(Vec4::X, Vec4::NEG_Y, Vec4::Z, Vec4::new(0.0, 2.0 * plane_m, 0.0, 1.0))
            }
            Role::Main | Role::Refraction => Mat4::IDENTITY,
        }
    }
}

impl GpuView {
    /// `plane_m` is the height of the water's level over the eye.
    pub(crate) fn new(
        view: &View,
        target: &TargetFormat,
        role: Role,
        plane_m: f32,
        margin_m: f32,
    ) -> GpuView {
        let clip_from_eye_world = view.clip_from_eye_world() * role.mirrored(plane_m);
        GpuView {
            clip_from_eye_world: clip_from_eye_world.to_cols_array_2d(),
            eye_world_from_clip: clip_from_eye_world.inverse().to_cols_array_2d(),
            pixel_angle_rad: view.pixel_angle_rad(),
            far_depth: target.far_depth(),
            stores: target.stores() as u32,
            most_radiance: target.most_radiance(),
            clip_plane: role.clip_plane(plane_m, margin_m).to_array(),
            exposure_gain: 1.0,
            end: [0; 3],
        }
    }
}

/// Layout twin of `GpuSun` in `view.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct GpuSun {
    pub(crate) toward: [f32; 3],
    pub(crate) radius_rad: f32,
    pub(crate) display: [f32; 3],
    pub(crate) padding: u32,
    pub(crate) skylight: [f32; 3],
    pub(crate) end: u32,
}

/// A uniform per view in one buffer, chosen by dynamic offset, so that all views of a frame can be
/// prepared before any is drawn.
pub(crate) struct ViewSlots<T> {
    pub(crate) buffer: wgpu::Buffer,
    what: std::marker::PhantomData<T>,
}

impl<T: bytemuck::Pod> ViewSlots<T> {
    const STRIDE: usize = size_of::<T>().next_multiple_of(SLOT_BYTES);

    /// A slot for each view.
    pub(crate) fn new(device: &wgpu::Device, label: &str) -> Self {
        Self::with_slots(device, label, MAX_VIEWS)
    }

    /// Any number of slots, for uniforms of which a view has several.
    pub(crate) fn with_slots(device: &wgpu::Device, label: &str, slots: usize) -> Self {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: (slots.max(1) * Self::STRIDE) as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        ViewSlots { buffer, what: std::marker::PhantomData }
    }

    pub(crate) fn write(&self, queue: &wgpu::Queue, slot: usize, value: &T) {
        queue.write_buffer(&self.buffer, (slot * Self::STRIDE) as u64, bytemuck::bytes_of(value));
    }

    pub(crate) fn offset(slot: usize) -> u32 {
        (slot * Self::STRIDE) as u32
    }

    pub(crate) fn layout_entry(binding: u32, visibility: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
        wgpu::BindGroupLayoutEntry {
            binding,
            visibility,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: true,
                min_binding_size: std::num::NonZeroU64::new(size_of::<T>() as u64),
            },
            count: None,
        }
    }

    pub(crate) fn binding(&self) -> wgpu::BindingResource<'_> {
        wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: &self.buffer,
            offset: 0,
            size: std::num::NonZeroU64::new(size_of::<T>() as u64),
        })
    }
}

/// Bind groups 0 (view) and 1 (environment), shared by the sky and every technique.
pub(crate) struct Shared {
    pub(crate) target: TargetFormat,
    pub(crate) views: ViewSlots<GpuView>,
    pub(crate) view_layout: wgpu::BindGroupLayout,
    pub(crate) view_group: wgpu::BindGroup,
    pub(crate) environment_layout: wgpu::BindGroupLayout,
    pub(crate) environment_group: wgpu::BindGroup,
    /// Each view's group 1 in place of that one, where the light is linear.
    pub(crate) skies: Option<Skies>,
    /// What exposes each view, where that is left to it.
    meter: Option<Meter>,
}

impl Shared {
    pub(crate) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        environment: &Environment,
        target: TargetFormat,
    ) -> Shared {
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT;
        let views = ViewSlots::with_slots(device, "views", Role::COUNT * MAX_VIEWS);
        let view_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("view"),
            entries: &[ViewSlots::<GpuView>::layout_entry(0, stages)],
        });
        let view_group = bind_group(device, "view", &view_layout, [views.binding()]);

        // Tests read the sky in compute passes, as techniques may.
        let stages = if environment.light.is_some() { stages | wgpu::ShaderStages::COMPUTE } else { stages };
        let mut entries = vec![
            texture_entry(0, stages, wgpu::TextureViewDimension::Cube, true),
            sampler_entry(1, stages),
            uniform_entry(2, stages),
        ];
        if environment.light.is_some() {
            entries.extend(sky_layout_entries(stages));
        }
        let environment_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("environment"),
            entries: &entries,
        });
        let cube = upload_cube(device, queue, &environment.cube);
        let sun = upload_sun(device, queue, environment);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("environment"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..Default::default()
        });
        let around = Around { cube, sampler, sun };
        let (skies, environment_group) = match &environment.light {
            Some(light) => {
                let skies = Skies::new(device, queue, light, &environment_layout, around);
                let group = skies.first_group().clone();
                (Some(skies), group)
            }
            None => (None, bind_group(device, "environment", &environment_layout, around.resources())),
        };
        let meter = environment.light.as_ref().and_then(|light| light.meter);
        Shared { target, views, view_layout, view_group, environment_layout, environment_group, skies, meter }
    }

    pub(crate) fn write_views(&self, queue: &wgpu::Queue, views: &[View]) -> Result<(), RenderError> {
        if views.len() > MAX_VIEWS {
            return Err(RenderError::LimitExceeded {
                what: "the number of views in a frame".into(),
                asked: views.len() as u64,
                accepted: format!("at most {MAX_VIEWS}"),
            });
        }
        for (i, view) in views.iter().enumerate() {
            self.write_view(queue, i, view, Role::Main, &self.target, 0.0);
        }
        Ok(())
    }

    /// Sets up one role of one view, for a target that may differ from the picture's.
    pub(crate) fn write_view(
        &self,
        queue: &wgpu::Queue,
        index: usize,
        view: &View,
        role: Role,
        target: &TargetFormat,
        margin_m: f32,
    ) {
        let mut value = GpuView::new(view, target, role, -view.eye_m.y as f32, margin_m);
        value.exposure_gain = self.meter.map_or(1.0, |meter| meter.gain(view));
        self.views.write(queue, role as usize * MAX_VIEWS + index, &value);
    }

    /// Binds groups 0 and 1 for one role of one view.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass<'_>, view: usize, role: Role) {
        let slot = role as usize * MAX_VIEWS + view;
        pass.set_bind_group(0, &self.view_group, &[ViewSlots::<GpuView>::offset(slot)]);
        let skies = self.skies.as_ref().and_then(|skies| skies.group(view));
        pass.set_bind_group(1, skies.unwrap_or(&self.environment_group), &[]);
    }
}

/// A sampled 2-D or cube texture of floats.
pub(crate) fn texture_entry(
    binding: u32,
    visibility: wgpu::ShaderStages,
    view_dimension: wgpu::TextureViewDimension,
    filterable: bool,
) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable },
            view_dimension,
            multisampled: false,
        },
        count: None,
    }
}

/// A uniform that is the same for every view.
pub(crate) fn uniform_entry(binding: u32, visibility: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A filtering sampler.
pub(crate) fn sampler_entry(binding: u32, visibility: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        count: None,
    }
}

fn upload_cube(device: &wgpu::Device, queue: &wgpu::Queue, cube: &CubeMap) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("environment"),
        size: wgpu::Extent3d { width: FACE_SIZE, height: FACE_SIZE, depth_or_array_layers: 6 },
        mip_level_count: cube.levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba16Float,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (level, texels) in cube.levels.iter().enumerate() {
        let size = FACE_SIZE >> level;
        queue.write_texture(
            wgpu::TexelCopyTextureInfo { mip_level: level as u32, ..texture.as_image_copy() },
            bytemuck::cast_slice(texels),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(size * 8),
                rows_per_image: Some(size),
            },
            wgpu::Extent3d { width: size, height: size, depth_or_array_layers: 6 },
        );
    }
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::Cube),
        ..Default::default()
    })
}

fn upload_sun(device: &wgpu::Device, queue: &wgpu::Queue, environment: &Environment) -> wgpu::Buffer {
    let (toward, radiance) = environment.sun.map_or((Vec3::Y, Vec3::ZERO), |s| (s.toward, s.radiance));
    let sun = GpuSun {
        toward: toward.to_array(),
        radius_rad: SUN_RADIUS_RAD,
        display: radiance.to_array().map(display_from_linear),
        padding: 0,
        skylight: environment.skylight.to_array(),
        end: 0,
    };
    buffer(device, queue, "sun", bytemuck::bytes_of(&sun), wgpu::BufferUsages::UNIFORM)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shader_lib::{self, layout::assert_layout};

    #[test]
    fn rust_and_wgsl_agree_about_layout() {
        assert_layout!(
            GpuView,
            shader_lib::SKY.wgsl,
            "GpuView",
            [
                clip_from_eye_world,
                eye_world_from_clip,
                pixel_angle_rad,
                far_depth,
                stores,
                most_radiance,
                clip_plane,
                exposure_gain
            ]
        );
        assert_layout!(GpuSun, shader_lib::SKY.wgsl, "GpuSun", [toward, radius_rad, display, skylight]);
    }
}

//! What every pass is told: the view, and the light around.

use crate::environment::{CubeMap, Environment, FACE_SIZE, SUN_RADIUS_RAD, display_from_linear};
use crate::{RenderError, TargetFormat, View};
use glam::Vec3;

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
    pub(crate) stores_linear_light: u32,
    pub(crate) padding: u32,
}

impl GpuView {
    pub(crate) fn new(view: &View, target: &TargetFormat) -> GpuView {
        let clip_from_eye_world = view.clip_from_eye_world();
        GpuView {
            clip_from_eye_world: clip_from_eye_world.to_cols_array_2d(),
            eye_world_from_clip: clip_from_eye_world.inverse().to_cols_array_2d(),
            pixel_angle_rad: view.pixel_angle_rad(),
            far_depth: target.far_depth(),
            stores_linear_light: u32::from(target.stores_linear_light()),
            padding: 0,
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
}

/// A uniform per view in one buffer, chosen by dynamic offset, so that all views of a frame can be
/// prepared before any is drawn.
pub(crate) struct ViewSlots<T> {
    pub(crate) buffer: wgpu::Buffer,
    what: std::marker::PhantomData<T>,
}

impl<T: bytemuck::Pod> ViewSlots<T> {
    const FITS: () = assert!(size_of::<T>() <= 2 * SLOT_BYTES, "a slot is two alignments wide");
    const STRIDE: usize = if size_of::<T>() <= SLOT_BYTES { SLOT_BYTES } else { 2 * SLOT_BYTES };

    pub(crate) fn new(device: &wgpu::Device, label: &str) -> Self {
        let () = Self::FITS;
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: (MAX_VIEWS * Self::STRIDE) as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        ViewSlots { buffer, what: std::marker::PhantomData }
    }

    pub(crate) fn write(&self, queue: &wgpu::Queue, view: usize, value: &T) {
        queue.write_buffer(&self.buffer, (view * Self::STRIDE) as u64, bytemuck::bytes_of(value));
    }

    pub(crate) fn offset(view: usize) -> u32 {
        (view * Self::STRIDE) as u32
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
}

impl Shared {
    pub(crate) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        environment: &Environment,
        target: TargetFormat,
    ) -> Shared {
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT;
        let views = ViewSlots::new(device, "views");
        let view_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("view"),
            entries: &[ViewSlots::<GpuView>::layout_entry(0, stages)],
        });
        let view_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("view"),
            layout: &view_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: views.binding() }],
        });

        let environment_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("environment"),
            entries: &[
                texture_entry(0, stages, wgpu::TextureViewDimension::Cube, true),
                sampler_entry(1, stages),
                wgpu::BindGroupLayoutEntry {
                    binding: 2,
                    visibility: stages,
                    ty: wgpu::BindingType::Buffer {
                        ty: wgpu::BufferBindingType::Uniform,
                        has_dynamic_offset: false,
                        min_binding_size: None,
                    },
                    count: None,
                },
            ],
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
        let environment_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("environment"),
            layout: &environment_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&cube) },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
                wgpu::BindGroupEntry { binding: 2, resource: sun.as_entire_binding() },
            ],
        });
        Shared { target, views, view_layout, view_group, environment_layout, environment_group }
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
            self.views.write(queue, i, &GpuView::new(view, &self.target));
        }
        Ok(())
    }

    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        pass.set_bind_group(0, &self.view_group, &[ViewSlots::<GpuView>::offset(view)]);
        pass.set_bind_group(1, &self.environment_group, &[]);
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
    };
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("sun"),
        size: size_of::<GpuSun>() as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    queue.write_buffer(&buffer, 0, bytemuck::bytes_of(&sun));
    buffer
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
            [clip_from_eye_world, eye_world_from_clip, pixel_angle_rad, far_depth, stores_linear_light]
        );
        assert_layout!(GpuSun, shader_lib::SKY.wgsl, "GpuSun", [toward, radius_rad, display]);
    }
}

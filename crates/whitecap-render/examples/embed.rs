//! A foreign wgpu program with a frame of its own: it draws its own triangle and our sea in one pass.
//!
//! `cargo run --release --example embed [PICTURE]` writes `embed.png` unless told otherwise.

#![allow(clippy::print_stdout)] // it is a program

use glam::{DVec3, Mat4, Vec3};
use std::error::Error;
use whitecap_render::{TargetFormat, View, Water};

const SIZE: [u32; 2] = [1280, 720];

/// This program's own choice of formats: an sRGB target, the usual depth, four samples.
const TARGET: TargetFormat = TargetFormat {
    color: wgpu::TextureFormat::Rgba8UnormSrgb,
    depth: wgpu::TextureFormat::Depth24Plus,
    depth_compare: wgpu::CompareFunction::Less,
    sample_count: 4,
    sample_shading: false,
};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "embed.png".into());
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;

    // The host's camera and projection, in the host's own convention.
    let eye_m = DVec3::new(12.0, 3.0, 5.0);
    let view = View {
        eye_m,
        view_from_world: glam::camera::rh::view::look_to_quat(Vec3::new(-0.94, -0.04, 0.34), Vec3::Y),
        clip_from_view: glam::camera::rh::proj::directx::perspective(0.8, 16.0 / 9.0, 0.5, 50_000.0),
        size_px: SIZE,
    };

    // The water: made once, prepared before the pass, drawn inside it.
    let scene = whitecap_scene::open("meshuggah")?;
    let mut water = Water::new(&device, &queue, &scene, TARGET)?;

    let triangle = Triangle::new(&device, &queue, &view);
    let color = attachment(&device, TARGET.color, TARGET.sample_count);
    let depth = attachment(&device, TARGET.depth, TARGET.sample_count);
    let resolved = attachment(&device, TARGET.color, 1);
    let [color_view, depth_view, resolved_view] =
        [&color, &depth, &resolved].map(|t| t.create_view(&Default::default()));

    let mut encoder = device.create_command_encoder(&Default::default());
    water.prepare(&device, &queue, &mut encoder, &[view], 2.0)?;
    {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("the host's pass"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &color_view,
                depth_slice: None,
                resolve_target: Some(&resolved_view),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth_view,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        triangle.draw(&mut pass);
        water.draw(&mut pass, 0);
        water.draw_sky(&mut pass, 0);
    }
    queue.submit([encoder.finish()]);

    let pixels = whitecap_render::gpu::read_texture(&device, &queue, &resolved)?;
    image::save_buffer(&path, &pixels, SIZE[0], SIZE[1], image::ColorType::Rgba8)?;
    println!("{path}");
    Ok(())
}

fn attachment(device: &wgpu::Device, format: wgpu::TextureFormat, sample_count: u32) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// The host's own drawing: a red sail that stands in the sea.
struct Triangle {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
}

const SAIL: &str = "
@group(0) @binding(0) var<uniform> clip_from_world: mat4x4f;

@vertex fn vs_main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
    var corners = array(vec3f(-13.0, -4.0, 9.0), vec3f(-13.0, -4.0, 16.0), vec3f(-13.0, 6.5, 12.0));
    return clip_from_world * vec4f(corners[i], 1.0);
}

@fragment fn fs_main() -> @location(0) vec4f { return vec4f(0.75, 0.08, 0.03, 1.0); }
";

impl Triangle {
    fn new(device: &wgpu::Device, queue: &wgpu::Queue, view: &View) -> Triangle {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("sail"),
            source: wgpu::ShaderSource::Wgsl(SAIL.into()),
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("sail"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: None,
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: TARGET.depth,
                depth_write_enabled: Some(true),
                depth_compare: Some(TARGET.depth_compare),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count: TARGET.sample_count, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: None,
                compilation_options: Default::default(),
                targets: &[Some(TARGET.color.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let world_from_eye = Mat4::from_translation(-view.eye_m.as_vec3());
        let matrix = view.clip_from_eye_world() * world_from_eye;
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("sail"),
            size: 64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&uniform, 0, bytemuck::bytes_of(&matrix.to_cols_array()));
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sail"),
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() }],
        });
        Triangle { pipeline, group }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}

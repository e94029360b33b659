//! The adapter that GPU tests share, ours and those of programs that embed the water.

use std::io::Write;
use std::sync::OnceLock;

use super::resources::{bind_group, texture_2d};
use super::{Gpu, read_buffer, read_texture};
use crate::TargetFormat;
use crate::shader_lib::Shader;

/// Set by `cargo xtask test`: a machine without an adapter then fails the GPU tests instead of skipping them.
pub const REQUIRE: &str = "WHITECAP_REQUIRE_ADAPTER";

/// The machine's best adapter, opened once per process.
///
/// Where there is none, or only one that lacks what WebGPU asks for, the answer is `None` and the reason
/// stands on standard error, past libtest's capture.
///
/// # Panics
///
/// Without such an adapter, if [`REQUIRE`] is set.
pub fn gpu() -> Option<&'static Gpu> {
    static GPU: OnceLock<Result<Gpu, String>> = OnceLock::new();
    match GPU.get_or_init(open) {
        Ok(gpu) => Some(gpu),
        Err(reason) => {
            assert!(std::env::var_os(REQUIRE).is_none(), "{REQUIRE} is set, and {reason}");
            let _ = writeln!(
                std::io::stderr(),
                "SKIPPED a test that draws: {reason}. `cargo xtask setup` installs a software adapter."
            );
            None
        }
    }
}

/// Runs `entry` of a compute shader once for each of `inputs` (64 to a workgroup) and reads what it wrote: group
/// 0 holds the inputs at binding 0 and as many outputs at binding 1, both as storage buffers.
///
/// # Panics
///
/// If the device fails.
pub fn compute<I: bytemuck::Pod, O: bytemuck::Pod>(
    gpu: &Gpu,
    shader: &Shader,
    entry: &str,
    inputs: &[I],
) -> Vec<O> {
    compute_beside(&gpu.device, &gpu.queue, shader, entry, inputs, 0, &[])
}

/// A group that a compute shader reads beside its inputs; see [`compute_beside`].
pub struct BoundGroup<'a> {
    /// Its index, from 0 to 3.
    pub index: u32,
    /// Its layout.
    pub layout: &'a wgpu::BindGroupLayout,
    /// The group.
    pub group: &'a wgpu::BindGroup,
    /// Its dynamic offsets.
    pub offsets: &'a [u32],
}

/// As [`compute`], with inputs and outputs in group `io` and `others` beside it.
///
/// # Panics
///
/// If the device fails, or a group's index is above 3.
pub fn compute_beside<I: bytemuck::Pod, O: bytemuck::Pod>(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    shader: &Shader,
    entry: &str,
    inputs: &[I],
    io: u32,
    others: &[BoundGroup<'_>],
) -> Vec<O> {
    let storage = |binding, read_only| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    };
    let io_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(shader.name),
        entries: &[storage(0, true), storage(1, false)],
    });
    let mut layouts = [None; 4];
    layouts[io as usize] = Some(&io_layout);
    for other in others {
        layouts[other.index as usize] = Some(other.layout);
    }
    let groups = 1 + layouts.iter().rposition(Option::is_some).unwrap_or(0);
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(shader.name),
        layout: Some(&device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(shader.name),
            bind_group_layouts: &layouts[..groups],
            immediate_size: 0,
        })),
        module: &shader.module(device),
        entry_point: Some(entry),
        compilation_options: Default::default(),
        cache: None,
    });
    let buffer = |size: usize, usage| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(shader.name),
            size: size as u64,
            usage: usage | wgpu::BufferUsages::STORAGE,
            mapped_at_creation: false,
        })
    };
    let input = buffer(size_of_val(inputs), wgpu::BufferUsages::COPY_DST);
    queue.write_buffer(&input, 0, bytemuck::cast_slice(inputs));
    let output = buffer(inputs.len() * size_of::<O>(), wgpu::BufferUsages::COPY_SRC);
    let resources = [input.as_entire_binding(), output.as_entire_binding()];
    let io_group = bind_group(device, shader.name, &io_layout, resources);
    let mut encoder = device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(io, &io_group, &[]);
        for other in others {
            pass.set_bind_group(other.index, other.group, other.offsets);
        }
        pass.dispatch_workgroups((inputs.len() as u32).div_ceil(64), 1, 1);
    }
    queue.submit([encoder.finish()]);
    let bytes = read_buffer(device, queue, &output).expect("the device answers");
    bytemuck::pod_collect_to_vec(&bytes)
}

/// A target of one sample a pixel that is read back.
pub struct Canvas<'a> {
    gpu: &'a Gpu,
    /// What has been drawn.
    pub color: wgpu::Texture,
    depth: wgpu::TextureView,
    far_depth: f32,
}

impl<'a> Canvas<'a> {
    /// A canvas of the target's formats.
    pub fn new(gpu: &'a Gpu, target: &TargetFormat, size_px: [u32; 2]) -> Canvas<'a> {
        let texture = |format, usage| {
            texture_2d(
                &gpu.device,
                "canvas",
                size_px,
                1,
                format,
                usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
            )
        };
        let color = texture(target.color, wgpu::TextureUsages::COPY_SRC);
        let depth = texture(target.depth, wgpu::TextureUsages::empty()).create_view(&Default::default());
        Canvas { gpu, color, depth, far_depth: target.far_depth() }
    }

    /// Encodes a pass that draws over `ground`, at the far depth.
    pub fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        ground: wgpu::Color,
        draw: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("canvas"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color.create_view(&Default::default()),
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(ground), store: wgpu::StoreOp::Store },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(self.far_depth),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        draw(&mut pass);
    }

    /// The bytes of what was drawn, rows from the top.
    ///
    /// # Panics
    ///
    /// If the device fails.
    pub fn pixels(&self) -> Vec<u8> {
        read_texture(&self.gpu.device, &self.gpu.queue, &self.color).expect("the device answers")
    }
}

fn open() -> Result<Gpu, String> {
    let gpu = Gpu::open(None).map_err(|error| error.to_string())?;
    if gpu.adapter.webgpu_compliant {
        Ok(gpu)
    } else {
        Err(format!("the only adapter, {}, lacks some of what WebGPU asks for", gpu.adapter))
    }
}

//! The adapter that GPU tests share, ours and those of programs that embed the water.

use std::io::Write;
use std::sync::OnceLock;

use super::{Gpu, read_buffer};
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
    let (device, queue) = (&gpu.device, &gpu.queue);
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(shader.name),
        layout: None,
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
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(shader.name),
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: input.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 1, resource: output.as_entire_binding() },
        ],
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups((inputs.len() as u32).div_ceil(64), 1, 1);
    }
    queue.submit([encoder.finish()]);
    let bytes = read_buffer(device, queue, &output).expect("the device answers");
    bytemuck::pod_collect_to_vec(&bytes)
}

fn open() -> Result<Gpu, String> {
    let gpu = Gpu::open(None).map_err(|error| error.to_string())?;
    if gpu.adapter.webgpu_compliant {
        Ok(gpu)
    } else {
        Err(format!("the only adapter, {}, lacks some of what WebGPU asks for", gpu.adapter))
    }
}

//! Textures, tables, buffers, bind groups and pipelines in a line each.

use crate::shader_lib::Shader;

/// A 2-D texture that shaders sample.
pub(crate) fn texture_2d(
    device: &wgpu::Device,
    label: &str,
    size_px: [u32; 2],
    levels: u32,
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: size_px[0], height: size_px[1], depth_or_array_layers: 1 },
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    })
}

/// Replaces a whole level of `texture` by `texels`, rows tightly packed from the top.
pub(crate) fn write_level(queue: &wgpu::Queue, texture: &wgpu::Texture, mip_level: u32, texels: &[u8]) {
    let size = wgpu::Extent3d {
        width: (texture.width() >> mip_level).max(1),
        height: (texture.height() >> mip_level).max(1),
        depth_or_array_layers: 1,
    };
    queue.write_texture(
        wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() },
        texels,
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(texels.len() as u32 / size.height),
            rows_per_image: None,
        },
        size,
    );
}

/// A square map of raw 8-bit values with its mip chain, the largest level first.
pub(crate) fn rgba8_map(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    label: &str,
    size: u32,
    levels: &[Vec<[u8; 4]>],
) -> wgpu::TextureView {
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let usage = wgpu::TextureUsages::COPY_DST;
    let texture = texture_2d(device, label, [size, size], levels.len() as u32, format, usage);
    for (level, texels) in levels.iter().enumerate() {
        write_level(queue, &texture, level as u32, bytemuck::cast_slice(texels));
    }
    texture.create_view(&Default::default())
}

/// A 1-D table as a texture of one row: browsers have no filtered 1-D textures with mips, and a 2-D one costs
/// the same.
pub(crate) fn table_1d(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    label: &str,
    entries: &[[u8; 4]],
) -> wgpu::TextureView {
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let usage = wgpu::TextureUsages::COPY_DST;
    let texture = texture_2d(device, label, [entries.len() as u32, 1], 1, format, usage);
    write_level(queue, &texture, 0, bytemuck::cast_slice(entries));
    texture.create_view(&Default::default())
}

/// A filtering sampler, trilinear where the map has mips.
pub(crate) fn linear_sampler(
    device: &wgpu::Device,
    label: &str,
    address: wgpu::AddressMode,
) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some(label),
        address_mode_u: address,
        address_mode_v: address,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..Default::default()
    })
}

/// A buffer with these contents. Not wgpu's `create_buffer_init`: that panics where the device has no memory
/// left.
pub(crate) fn buffer(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    label: &str,
    contents: &[u8],
    usage: wgpu::BufferUsages,
) -> wgpu::Buffer {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: (contents.len() as u64).next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT).max(4),
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    queue.write_buffer(&buffer, 0, contents);
    buffer
}

/// Triangles on the device: one vertex buffer and 32-bit indices.
pub(crate) struct IndexedMesh {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
}

impl IndexedMesh {
    pub(crate) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        label: &str,
        vertices: &[u8],
        indices: &[u32],
    ) -> IndexedMesh {
        IndexedMesh {
            vertices: buffer(device, queue, label, vertices, wgpu::BufferUsages::VERTEX),
            indices: buffer(device, queue, label, bytemuck::cast_slice(indices), wgpu::BufferUsages::INDEX),
            index_count: indices.len() as u32,
        }
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }
}

/// A bind group of `resources` at bindings 0, 1, 2 ….
pub(crate) fn bind_group<'r>(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: impl IntoIterator<Item = wgpu::BindingResource<'r>>,
) -> wgpu::BindGroup {
    let entries: Vec<_> = resources
        .into_iter()
        .enumerate()
        .map(|(i, resource)| wgpu::BindGroupEntry { binding: i as u32, resource })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

/// A render pipeline in the form that all of ours have: `vs_main` and `fs_main` of one shader, one colour
/// target, triangles that are seen from both sides.
pub(crate) struct PipelineRequest<'a> {
    pub(crate) label: &'a str,
    pub(crate) shader: &'a Shader,
    /// Values of the shader's `override` declarations; those that are left out have their defaults.
    pub(crate) constants: &'a [(&'a str, f64)],
    /// Layouts of groups 0, 1, 2 ….
    pub(crate) groups: &'a [Option<&'a wgpu::BindGroupLayout>],
    pub(crate) vertices: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub(crate) color: wgpu::TextureFormat,
    pub(crate) depth: Option<wgpu::DepthStencilState>,
    pub(crate) multisample: wgpu::MultisampleState,
}

impl PipelineRequest<'_> {
    pub(crate) fn create(&self, device: &wgpu::Device) -> wgpu::RenderPipeline {
        let module = self.shader.module(device);
        let compilation_options =
            wgpu::PipelineCompilationOptions { constants: self.constants, ..Default::default() };
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: self.groups,
            immediate_size: 0,
        });
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vs_main"),
                compilation_options: compilation_options.clone(),
                buffers: self.vertices,
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: self.depth.clone(),
            multisample: self.multisample,
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fs_main"),
                compilation_options,
                targets: &[Some(self.color.into())],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

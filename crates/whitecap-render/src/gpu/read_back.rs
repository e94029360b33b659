//! From the device's memory to ours.

use super::RenderError;

/// Copies the first mip of an uncompressed 2-D `texture` of one aspect into bytes, rows tightly packed.
///
/// Blocks until the device is done.
///
/// # Errors
///
/// [`RenderError::DeviceLost`] when the device does not answer; [`RenderError::Unsupported`] for a
/// compressed texture or one with a stencil, and in a browser, where nothing waits.
pub fn read_texture(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    texture: &wgpu::Texture,
) -> Result<Vec<u8>, RenderError> {
    read_level(device, queue, texture, 0)
}

/// As [`read_texture`], for any mip.
///
/// # Errors
///
/// As [`read_texture`].
pub fn read_level(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    texture: &wgpu::Texture,
    mip_level: u32,
) -> Result<Vec<u8>, RenderError> {
    let [width, height] = [texture.width(), texture.height()].map(|side| (side >> mip_level).max(1));
    let texel = texture
        .format()
        .block_copy_size(None)
        .filter(|_| texture.format().block_dimensions() == (1, 1))
        .ok_or_else(|| RenderError::Unsupported { what: format!("read-back of {:?}", texture.format()) })?;
    let row = width * texel;
    let padded_row = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let staging = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("read-back"),
        size: u64::from(padded_row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    encoder.copy_texture_to_buffer(
        wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() },
        wgpu::TexelCopyBufferInfo {
            buffer: &staging,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(padded_row),
                rows_per_image: None,
            },
        },
        wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
    );
    queue.submit([encoder.finish()]);
    let padded = map(device, &staging)?;
    Ok(padded.chunks(padded_row as usize).flat_map(|r| &r[..row as usize]).copied().collect())
}

/// Copies `buffer`, which needs `COPY_SRC`, into bytes. Blocks until the device is done.
///
/// # Errors
///
/// [`RenderError::DeviceLost`] when the device does not answer; [`RenderError::Unsupported`] in a browser.
pub fn read_buffer(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    buffer: &wgpu::Buffer,
) -> Result<Vec<u8>, RenderError> {
    let staging = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("read-back"),
        size: buffer.size(),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &staging, 0, buffer.size());
    queue.submit([encoder.finish()]);
    map(device, &staging)
}

/// How long an answer may take after the device has finished.
const ANSWER_WITHIN: std::time::Duration = std::time::Duration::from_secs(10);

fn map(device: &wgpu::Device, staging: &wgpu::Buffer) -> Result<Vec<u8>, RenderError> {
    if cfg!(target_arch = "wasm32") {
        return Err(RenderError::Unsupported {
            what: "a way to wait for it, since this is a browser".into(),
        });
    }
    let lost = |reason: String| RenderError::DeviceLost { reason };
    let (sender, receiver) = std::sync::mpsc::channel();
    staging.map_async(wgpu::MapMode::Read, .., move |result| {
        let _ = sender.send(result);
    });
    device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| lost(e.to_string()))?;
    // Another thread's poll may have taken the answer and be about to pass it on.
    match receiver.recv_timeout(ANSWER_WITHIN) {
        Ok(Ok(())) => {}
        Ok(Err(e)) => return Err(lost(e.to_string())),
        Err(_) => return Err(lost("read-back was never answered".into())),
    }
    let view = staging.get_mapped_range(..).map_err(|e| lost(e.to_string()))?;
    let bytes = view.to_vec();
    drop(view);
    staging.unmap();
    Ok(bytes)
}

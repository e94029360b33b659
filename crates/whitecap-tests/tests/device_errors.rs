//! What the device refuses comes back as an error that says what to do, never as a panic.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use whitecap_render::gpu::{checked, list_adapters};
use whitecap_render::picture::{PictureRequest, render_picture};
use whitecap_render::{Gpu, RenderError};
use whitecap_tests::adapter::gpu;

fn request(width: u32, height: u32) -> PictureRequest {
    PictureRequest { backend: None, width, height, time_s: 0.0 }
}

#[test]
fn an_unknown_adapter_is_answered_with_those_there_are() {
    if gpu().is_none() {
        return;
    }
    let error = Gpu::open(Some("no such thing")).err().unwrap();
    let RenderError::NoSuchAdapter { wanted, available } = &error else { panic!("{error:?}") };
    assert_eq!(wanted, "no such thing");
    assert!(available.contains(&list_adapters()[0].name));
}

#[test]
fn adapters_answer_to_part_of_their_name_in_any_case() {
    if gpu().is_none() {
        return;
    }
    let name = list_adapters()[0].name.to_uppercase();
    let word = name.split(' ').next().unwrap();
    assert!(Gpu::open(Some(word)).is_ok());
}

#[test]
fn sizes_beyond_the_limit_name_the_limit() {
    let Some(gpu) = gpu() else { return };
    let scene = whitecap_scene::open("meshuggah").unwrap();
    let limit = gpu.device.limits().max_texture_dimension_2d;
    for (width, height, asked) in [(0, 9, 0), (9, 0, 0), (limit + 1, 9, limit + 1), (9, u32::MAX, u32::MAX)] {
        let error = render_picture(gpu, &scene, &request(width, height), &mut |_| {}).err().unwrap();
        let RenderError::LimitExceeded { asked: found, accepted, .. } = &error else { panic!("{error:?}") };
        assert_eq!(*found, u64::from(asked));
        assert!(accepted.contains(&limit.to_string()));
    }
    gpu.check().unwrap();
}

#[test]
fn a_lost_device_is_an_error() {
    if gpu().is_none() {
        return;
    }
    let own = Gpu::open(None).unwrap();
    own.device.destroy();
    let scene = whitecap_scene::open("meshuggah").unwrap();
    let error = render_picture(&own, &scene, &request(64, 36), &mut |_| {}).err().unwrap();
    assert!(matches!(error, RenderError::DeviceLost { .. }), "{error:?}");
    assert!(error.to_string().contains("--adapter"));
}

#[test]
fn what_wgpu_rejects_is_named_after_what_was_made() {
    let Some(gpu) = gpu() else { return };
    let error = checked(&gpu.device, "a thing", || {
        let _ = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: 1 << 60,
            usage: wgpu::BufferUsages::VERTEX,
            mapped_at_creation: false,
        });
        Ok(())
    })
    .err()
    .unwrap();
    assert!(matches!(error, RenderError::Internal { .. } | RenderError::OutOfMemory { .. }), "{error:?}");
    let memory = RenderError::OutOfMemory { what: "a picture of this size".into() };
    assert!(memory.to_string().contains("smaller picture"));
    // The device is still good.
    gpu.check().unwrap();
}

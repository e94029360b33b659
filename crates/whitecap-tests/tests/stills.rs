//! Stills of many samples a pixel: what their number may change, and what it may not.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use std::f64::consts::SQRT_2;

use glam::{DVec2, DVec3};
use whitecap_render::environment::SUN_RADIUS_RAD;
use whitecap_render::gpu::for_tests::Canvas;
use whitecap_render::picture::{
    FILTER_RADIUS_PX, LightPicture, LightUnit, MAX_SAMPLES, PictureRequest, render_light, render_supersampled,
};
use whitecap_render::{Gpu, RenderError, TargetFormat, View, Water};
use whitecap_scene::{Scene, Sky, technique};
use whitecap_tests::adapter::gpu;

fn request(width: u32, height: u32) -> PictureRequest {
    PictureRequest { backend: None, width, height, time_s: 1.0 }
}

fn light(gpu: &Gpu, scene: &Scene, size: [u32; 2], samples: u32) -> LightPicture {
    render_light(gpu, scene, &request(size[0], size[1]), samples, &mut |_, _| {}).unwrap()
}

fn ocean() -> Scene {
    whitecap_scene::open("spectral-ocean").unwrap()
}

/// Looking down at the sea: no sky, whose sun would outshine it, and no horizon.
fn sea_alone() -> Scene {
    let mut scene = ocean();
    scene.camera.look_at_m = [scene.camera.position_m[0] + 8.0, -1.0, scene.camera.position_m[2] - 5.0];
    scene
}

#[test]
fn one_sample_is_the_frame_of_a_window() {
    let Some(gpu) = gpu() else { return };
    let size = [96, 54];
    for technique in technique::ALL {
        let scene = whitecap_scene::open(technique.word).unwrap();
        let target = TargetFormat::default();
        let mut water = Water::new(&gpu.device, &gpu.queue, &scene, target).unwrap();
        let canvas = Canvas::new(gpu, &target, size);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let view = View::of_camera(&scene.camera, size);
        water.prepare(&gpu.device, &gpu.queue, &mut encoder, &[view], 1.0).unwrap();
        canvas.draw(&mut encoder, wgpu::Color::BLACK, |pass| {
            water.draw(pass, 0);
            water.draw_sky(pass, 0);
        });
        gpu.queue.submit([encoder.finish()]);
        let window = canvas.pixels();
        let still =
            render_supersampled(gpu, &scene, &request(size[0], size[1]), 1, &mut |_, _| {}).unwrap().rgba8;
        let channels = || window.chunks(4).zip(still.chunks(4)).flat_map(|(a, b)| a[..3].iter().zip(&b[..3]));
        let largest = channels().map(|(a, b)| a.abs_diff(*b)).max();
        assert!(largest <= Some(1), "{}: {largest:?} levels", technique.word);
    }
}

#[test]
fn a_still_is_the_same_each_time_and_tells_how_far_it_is() {
    let Some(gpu) = gpu() else { return };
    for scene in [ocean(), whitecap_scene::open("meshuggah").unwrap()] {
        let mut heard = Vec::new();
        let first = render_light(gpu, &scene, &request(64, 36), 11, &mut |_, done| heard.push(done)).unwrap();
        assert_eq!(heard[2..14], [(0..=11).collect::<Vec<u32>>()].concat());
        assert_eq!(light(gpu, &scene, [64, 36], 11), first);
        let linear = scene.technique.is_scene_linear();
        let unit = if linear { LightUnit::KilocandelaPerSquareMetre } else { LightUnit::DisplayWhite };
        assert_eq!(first.unit, unit);
        if !linear {
            assert_eq!(first.exposure, 1.0);
            assert!(first.rgb.as_flattened().iter().all(|light| (0.0..=1.0).contains(light)));
        }
    }
}

#[test]
fn numbers_of_samples_beyond_the_accepted_are_refused() {
    let Some(gpu) = gpu() else { return };
    for samples in [0, MAX_SAMPLES + 1, u32::MAX] {
        let error = render_supersampled(gpu, &ocean(), &request(8, 8), samples, &mut |_, _| {}).unwrap_err();
        let RenderError::LimitExceeded { asked, accepted, .. } = error else { panic!("{error:?}") };
        assert_eq!((asked, accepted.as_str()), (samples.into(), "1 to 1024"));
    }
}

/// What is filtered away comes back as roughness, whatever the number.
#[test]
fn brightness_does_not_depend_on_the_number_of_samples() {
    let Some(gpu) = gpu() else { return };
    // Towards the sun, where glitter is, and down at the water.
    for scene in [ocean(), sea_alone(), whitecap_scene::open("meshuggah").unwrap()] {
        let size = [256, 144];
        let horizon = (0.5
            * f64::from(size[1])
            * (1.0 + pitch(&scene).tan() / (0.5 * scene.camera.vertical_fov_deg).to_radians().tan()))
        .ceil()
        .max(0.0) as usize;
        let mean = |samples| {
            let picture = light(gpu, &scene, size, samples);
            let below = &picture.rgb[(horizon + 3) * size[0] as usize..];
            below.iter().map(|&rgb| luminance(rgb)).sum::<f64>() / below.len() as f64
        };
        let means = [1, 4, 16].map(mean);
        // A single sample has the slopes of a whole pixel as roughness, which is a little less bright in glitter: 1.1 % on the mean
        // of seven moments, 1.6 % at the most. Display values clip glints: how many a picture of one sample has is more a matter
        // of chance.
        let bounds = if scene.technique.is_scene_linear() { [0.02, 0.01] } else { [0.02, 0.02] };
        for (found, bound) in means.iter().zip(bounds) {
            assert!((found / means[2] - 1.0).abs() < bound, "{}: {means:?}", scene.technique.word());
        }
    }
}

fn pitch(scene: &Scene) -> f64 {
    let toward = DVec3::from(scene.camera.look_at_m) - DVec3::from(scene.camera.position_m);
    toward.normalize().y.asin()
}

fn luminance([r, g, b]: [f32; 3]) -> f64 {
    f64::from(0.2126 * r + 0.7152 * g + 0.0722 * b)
}

/// Aliasing, of glitter and silhouettes alike: the distance from a picture of very many samples.
#[test]
fn every_sample_brings_the_picture_nearer_to_its_end() {
    let Some(gpu) = gpu() else { return };
    let island = whitecap_scene::open("five-sample-island").unwrap();
    for scene in [sea_alone(), island] {
        let size = [48, 27];
        // A few glints are much of one moment's error.
        let moments_s = [0.0, 3.7, 20.0, 41.0];
        let light = |time_s, samples| {
            let request = PictureRequest { time_s, ..request(size[0], size[1]) };
            render_light(gpu, &scene, &request, samples, &mut |_, _| {}).unwrap()
        };
        let ends = moments_s.map(|time_s| light(time_s, 128));
        let error = |samples| {
            let of_moment = |(time_s, end): (f64, &LightPicture)| -> f32 {
                let found = light(time_s, samples);
                let differences = found.rgb.as_flattened().iter().zip(end.rgb.as_flattened());
                differences.map(|(a, b)| (a - b).powi(2)).sum()
            };
            moments_s.into_iter().zip(&ends).map(of_moment).sum::<f32>().sqrt()
        };
        let errors = [1, 4, 16].map(error);
        let falls = errors.windows(2).all(|pair| pair[1] < 0.6 * pair[0]);
        assert!(falls, "{}: {errors:?}", scene.technique.word());
    }
}

/// The sun's disc, a million times as bright as its sky, lies where it is, and the filter leaves no ring around it.
#[test]
fn the_picture_is_not_shifted() {
    let Some(gpu) = gpu() else { return };
    let mut scene = ocean();
    let Sky::Atmosphere(sky) = &mut scene.sky else { panic!() };
    // High up, where the air takes the same from all of the disc.
    let (azimuth, elevation) = (30.0_f64, 88.0_f64);
    (sky.sun_azimuth_deg, sky.sun_elevation_deg, sky.cloud_cover) = (azimuth, elevation, 0.0);
    let (azimuth, elevation) = (azimuth.to_radians(), elevation.to_radians());
    let toward_sun =
        DVec3::new(azimuth.sin() * elevation.cos(), elevation.sin(), -azimuth.cos() * elevation.cos());
    // Between a pixel's centre and its corner.
    let look_at = DVec3::from(scene.camera.position_m) + 1e4 * (toward_sun + DVec3::new(1.1e-4, 0.0, 0.7e-4));
    scene.camera.look_at_m = look_at.to_array();
    scene.camera.vertical_fov_deg = 2.0;
    let size = [64, 64];
    let view = View::of_camera(&scene.camera, size);
    let sun = view.clip_from_eye_world().project_point3(toward_sun.as_vec3() * 100.0);
    let expected = 32.0 * (DVec2::ONE + DVec2::new(f64::from(sun.x), -f64::from(sun.y)));
    let radius_px = f64::from(SUN_RADIUS_RAD / view.pixel_angle_rad());
    for samples in [64, 100] {
        let picture = light(gpu, &scene, size, samples);
        let sky = luminance(picture.rgb[0]);
        let (mut sum, mut weighted) = (0.0, DVec2::ZERO);
        for (i, &rgb) in picture.rgb.iter().enumerate() {
            let at = DVec2::new((i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5);
            let light = luminance(rgb) - sky;
            sum += light;
            weighted += light * at;
            // The sky round the sun is brighter, but by no sun.
            let is_outside = (at - expected).length() > radius_px + 1.0 + SQRT_2 * FILTER_RADIUS_PX;
            assert!(!is_outside || (0.0..sky).contains(&light.abs()), "{light} beside the sun at {at}");
        }
        let shift = weighted / sum - expected;
        assert!(sum > 1e6 * sky && shift.abs().max_element() < 1e-3, "{samples} samples shift it by {shift}");
    }
}

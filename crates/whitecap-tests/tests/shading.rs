//! What a pixel of the Meshuggah ocean holds, by hand: under a sky of one colour, under a sky with one lamp, and
//! where waves pass from geometry into normals.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::{DVec3, Vec3};
use std::sync::Arc;
use whitecap_render::environment::linear_from_display;
use whitecap_render::picture::{PictureRequest, render_picture};
use whitecap_render::{Gpu, View};
use whitecap_scene::panorama::Panorama;
use whitecap_scene::{Scene, Sky, Technique};
use whitecap_tests::adapter::gpu;
use whitecap_waves::optics::{fresnel_jensen_golias, water_color_lerp};

const SIZE: [u32; 2] = [160, 90];

fn scene(edits: &[(&str, &str)]) -> Scene {
    let mut toml = whitecap_scene::named::find("meshuggah").unwrap().toml.to_owned();
    for (from, to) in edits {
        assert!(toml.contains(from), "the scene has no {from}");
        toml = toml.replacen(from, to, 1);
    }
    Scene::from_toml(&toml, "test.toml").unwrap_or_else(|e| panic!("{e}"))
}

/// Puts a panorama over the scene whose radiance is given by direction.
fn with_sky(scene: &mut Scene, exposure_ev: f64, radiance: impl Fn(DVec3) -> f32) {
    let (width, height) = (256, 128);
    let pixel = |i: usize| {
        let azimuth =
            ((i % width) as f64 + 0.5) / width as f64 * std::f64::consts::TAU - std::f64::consts::PI;
        let zenith = ((i / width) as f64 + 0.5) / height as f64 * std::f64::consts::PI;
        let (x, z) = (azimuth.sin() * zenith.sin(), -azimuth.cos() * zenith.sin());
        [radiance(DVec3::new(x, zenith.cos(), z)); 3]
    };
    let pixels = (0..width * height).map(pixel).collect();
    let settings = whitecap_scene::sky::PanoramaSky { file: "made.hdr".into(), yaw_deg: 0.0, exposure_ev };
    scene.sky = Sky::Panorama(settings);
    scene.panorama = Some(Arc::new(Panorama { width, height, pixels, repaired: 0 }));
}

fn render(gpu: &Gpu, scene: &Scene) -> Vec<[u8; 4]> {
    let request = PictureRequest { backend: None, width: SIZE[0], height: SIZE[1], time_s: 0.0 };
    let picture = render_picture(gpu, scene, &request, &mut |_| {}).unwrap();
    picture.rgba8.chunks(4).map(|p| [p[0], p[1], p[2], p[3]]).collect()
}

/// Unit direction through the middle of each pixel.
fn rays(scene: &Scene) -> Vec<Vec3> {
    let view = View::of_camera(&scene.camera, SIZE);
    let world_from_clip = view.clip_from_eye_world().inverse();
    (0..SIZE[0] * SIZE[1])
        .map(|i| {
            let x = ((i % SIZE[0]) as f32 + 0.5) / SIZE[0] as f32 * 2.0 - 1.0;
            let y = 1.0 - ((i / SIZE[0]) as f32 + 0.5) / SIZE[1] as f32 * 2.0;
            world_from_clip.project_point3(Vec3::new(x, y, 0.5)).normalize()
        })
        .collect()
}

/// A sea that is all but flat, under an all but black sky of one colour: each pixel is the water's colour plus
/// sky times exposure times Fresnel, in both forms, through integer and fraction.
#[test]
fn a_flat_sea_is_the_sum_that_the_text_gives() {
    let Some(gpu) = gpu() else { return };
    for (fresnel, visibility_km) in [("per-vertex-split", 1e6), ("per-pixel", 1e6), ("per-pixel", 0.1)] {
        let mut scene = scene(&[
            ("fresnel = \"per-vertex-split\"", &format!("fresnel = \"{fresnel}\"")),
            ("visibility_km = 12.0", &format!("visibility_km = {visibility_km:?}")),
            ("exposure = 1.5", "exposure = 3.7"),
            ("from_deg = 250.0", "from_deg = 250.0\nsignificant_height_m = 0.01"),
            ("deep_color = [0.0, 0.1, 0.18]", "deep_color = [0.0, 0.2, 0.4]"),
            ("grazing_color = [0.0, 0.17, 0.17]", "grazing_color = [0.3, 0.1, 0.0]"),
        ]);
        scene.camera.look_at_m = [-20.0, 0.0, 0.0];
        with_sky(&mut scene, -4.0, |_| 0.5);
        let pixels = render(gpu, &scene);
        let sky = f64::from(pixels[0][0]) / 255.0;
        assert!((0.05..0.2).contains(&sky), "the sky is {sky}");
        let mut exposures = 0..0;
        for (ray, pixel) in rays(&scene).iter().zip(&pixels) {
            let cos = f64::from(-ray.y);
            if cos < 0.06 {
                continue; // ripples of a centimetre still count towards the horizon
            }
            let exposed = (3.7 * fresnel_jensen_golias(cos)).min(4.0);
            exposures.end = exposures.end.max(exposed as i32);
            let water = water_color_lerp(cos, [0.3, 0.1, 0.0], [0.0, 0.2, 0.4]);
            for channel in 0..3 {
                // Koschmieder 1924, through haze that a viewer 4 m up has all of before him.
                let clear = (-3.912 * (4.0 / cos) / (1000.0 * visibility_km)).exp();
                let surface = water[channel] + sky * exposed;
                let expected = 255.0 * (clear * surface + (1.0 - clear) * sky).min(1.0);
                let seen = f64::from(pixel[channel]);
                assert!(
                    (seen - expected).abs() < 3.0,
                    "{fresnel}, cosine {cos}: {seen} instead of {expected}"
                );
            }
        }
        assert!(exposures.end >= 2, "the integer part was never needed");
    }
}

/// The colour table runs the same way as the blend: bright along the surface, dark straight down, and a black
/// sky adds nothing.
#[test]
fn the_table_of_water_colours_is_read_from_grazing_to_deep() {
    let Some(gpu) = gpu() else { return };
    let mut scene = scene(&[
        ("water_color = \"lerp\"", "water_color = \"nishita-nakamae\""),
        // Shallow: a slanting ray gathers up to half as much again as one straight down.
        ("exposure = 1.5", "exposure = 0.0\nbottom_depth_m = 1.0\nscattering_per_m = [0.1, 0.1, 0.1]"),
        ("tile_repeats = 4", "tile_repeats = 4\nextinction_per_m = [0.1, 0.1, 0.1]"),
        ("from_deg = 250.0", "from_deg = 250.0\nsignificant_height_m = 0.01"),
    ]);
    scene.camera.look_at_m = [-6.0, 0.0, 0.0];
    with_sky(&mut scene, 1.0, |_| 0.5);
    let pixels = render(gpu, &scene);
    let blue_of_row = |y: u32| {
        let row = &pixels[(y * SIZE[0]) as usize..((y + 1) * SIZE[0]) as usize];
        row.iter().map(|p| f64::from(p[2])).sum::<f64>() / row.len() as f64
    };
    let (far, near) = (blue_of_row(5), blue_of_row(SIZE[1] - 5));
    assert!(far > 1.08 * near, "{far} far off, {near} below");
    assert!(linear_from_display((near / 255.0) as f32) > 0.005);
}

/// A lamp in the sky is seen in its own direction, on every face of the cube that is above the water.
#[test]
fn each_direction_of_the_sky_is_seen_where_it_is() {
    let Some(gpu) = gpu() else { return };
    let mut scene = scene(&[]);
    for (bearing_deg, elevation_deg) in [
        (10.0, 12.0),
        (100.0, 12.0),
        (190.0, 12.0),
        (280.0, 12.0),
        (20.0, 70.0),
        (110.0, 70.0),
        (200.0, 70.0),
        (290.0, 70.0),
    ] {
        let (bearing, elevation) = (f64::to_radians(bearing_deg), f64::to_radians(elevation_deg));
        let lamp =
            DVec3::new(bearing.sin() * elevation.cos(), elevation.sin(), -bearing.cos() * elevation.cos());
        with_sky(&mut scene, 0.0, |d| if d.angle_between(lamp) < 0.07 { 1.0 } else { 0.1 });
        let eye = DVec3::from(scene.camera.position_m);
        scene.camera.look_at_m = (eye + 100.0 * lamp).to_array();
        let pixels = render(gpu, &scene);
        let bright = pixels[(SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2) as usize][1];
        for corner in [0, SIZE[0] - 1] {
            let dark = pixels[corner as usize][1];
            assert!(
                bright > dark + 30,
                "{bearing_deg}° {elevation_deg}°: {bright} in the middle, {dark} in a corner"
            );
        }
    }
}

/// Waves that the mesh has handed to the normals look like those that are still geometry: same places, same
/// signs. One mesh ends before the nearest pixel, the other reaches beyond the farthest that is compared.
#[test]
fn waves_look_alike_as_geometry_and_as_normals() {
    let Some(gpu) = gpu() else { return };
    let luminance = |tile_repeats: u32, bump_repeats: f64| {
        let mut scene = scene(&[
            ("fresnel = \"per-vertex-split\"", "fresnel = \"per-pixel\""),
            ("visibility_km = 12.0", "visibility_km = 1e6"),
            ("deep_color = [0.0, 0.1, 0.18]", "deep_color = [0.0, 0.0, 0.0]"),
            ("grazing_color = [0.0, 0.17, 0.17]", "grazing_color = [1.0, 1.0, 1.0]"),
            ("exposure = 1.5", "exposure = 0.0"),
        ]);
        let Technique::Meshuggah(settings) = &mut scene.technique else { panic!() };
        settings.tile_repeats = tile_repeats;
        settings.bump_repeats = bump_repeats;
        scene.camera.position_m = [0.0, 75.0, 0.0];
        scene.camera.look_at_m = [-75.0, 0.0, 0.0];
        let pixels = render(gpu, &scene);
        // The lower half: 80 to 106 m away.
        pixels[pixels.len() / 2..].iter().map(|p| f64::from(p[1])).collect::<Vec<_>>()
    };
    let (normals, geometry) = (luminance(1, 250.0), luminance(4, 1000.0));
    // What is common to all of a row is perspective, not waves.
    let waves = |values: &[f64]| -> Vec<f64> {
        values
            .chunks(SIZE[0] as usize)
            .flat_map(|row| {
                let mean = row.iter().sum::<f64>() / row.len() as f64;
                row.iter().map(move |v| v - mean).collect::<Vec<_>>()
            })
            .collect()
    };
    let (a, b) = (waves(&normals), waves(&geometry));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let correlation = dot(&a, &b) / (dot(&a, &a) * dot(&b, &b)).sqrt();
    assert!(dot(&b, &b) / b.len() as f64 > 1.0, "there are no waves to compare");
    assert!(correlation > 0.7, "correlation {correlation}");
}

//! Whatever a scene of the ocean may say, its picture is light: finite, and nowhere negative.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use std::sync::Arc;

use whitecap_render::Gpu;
use whitecap_render::picture::{PictureRequest, render_light, render_picture};
use whitecap_scene::Scene;
use whitecap_scene::panorama::Panorama;
use whitecap_scene::reference::{Accepts, reference};
use whitecap_tests::adapter::gpu;

const REQUEST: PictureRequest = PictureRequest { backend: None, width: 32, height: 18, time_s: 2.0 };

/// A small sea with lines in one of its tables in place of those that it has.
fn scene(table: &str, lines: &str) -> Scene {
    let mut text = String::from("technique = \"spectral-ocean\"\n");
    for (name, keys) in [
        ("sea", "cascades = 1\nresolution = 64\ndepth_m = 20.0\nchoppiness = 1.0"),
        ("sea.system", "spectrum = \"jonswap\"\nwind_speed_mps = 9.0\nfrom_deg = 270.0"),
        ("spectral-ocean", ""),
        ("sky", ""),
        ("picture", ""),
        ("camera", "position_m = [0, 4, 0]\nlook_at_m = [100, 0, 0]"),
        ("object", ""),
    ] {
        let given = if name == table { lines } else { "" };
        if name == "object" && given.is_empty() {
            continue;
        }
        let is_given =
            |line: &&str| given.lines().any(|other| other.split(' ').next() == line.split(' ').next());
        let kept = keys.lines().filter(|line| !is_given(line)).collect::<Vec<_>>().join("\n");
        let header = if ["sea.system", "object"].contains(&name) {
            format!("[[{name}]]")
        } else {
            format!("[{name}]")
        };
        text += &format!("{header}\n{given}\n{kept}\n");
    }
    Scene::from_toml(&text, "bounds.toml").unwrap_or_else(|error| panic!("{error}"))
}

/// Radiance of every pixel, one sample each.
fn assert_is_light(gpu: &Gpu, scene: &Scene, what: &str) {
    let picture = render_light(gpu, scene, &REQUEST, 1, &mut |_, _| {}).unwrap();
    let odd = picture.rgb.iter().flatten().find(|light| !(light.is_finite() && **light >= 0.0));
    assert_eq!(odd, None, "{what}");
    assert!(picture.exposure.is_finite() && picture.exposure > 0.0, "{what}: exposure {}", picture.exposure);
}

/// Each key of the tables that say how the ocean looks, at both of its bounds or in each of its words.
#[test]
fn the_bounds_of_every_key_give_a_picture() {
    let Some(gpu) = gpu() else { return };
    let mut drawn = 0;
    for doc in reference() {
        let is_of_pictures = ["sky", "camera", "picture", "spectral-ocean"].contains(&doc.table.as_str());
        if !is_of_pictures || doc.only_with == Some(("kind", "panorama")) {
            continue;
        }
        let values = match &doc.accepts {
            Accepts::Real { min, max, .. } => vec![format!("{min:?}"), format!("{max:?}")],
            Accepts::Colour { min, max, .. } => vec![format!("{:?}", [min; 3]), format!("{:?}", [max; 3])],
            Accepts::Point { min, max } => vec![format!("{min:?}"), format!("{max:?}")],
            // Words are the same path with other numbers; the others are shown by scenes.
            Accepts::Words(words) if doc.key != "kind" => {
                words[words.len() - 1..].iter().map(|word| format!("{word:?}")).collect()
            }
            _ => continue,
        };
        for value in values {
            let line = format!("{} = {value}", doc.key);
            assert_is_light(gpu, &scene(&doc.table, &line), &line);
            drawn += 1;
        }
    }
    assert!(drawn >= 30, "{drawn}");
}

/// Cameras in the water, under its bottom, in an island, straight down and up, far out and high up; suns on the horizon, under it
/// and overhead.
#[test]
fn odd_places_give_a_picture() {
    let Some(gpu) = gpu() else { return };
    for (table, lines) in [
        ("camera", "position_m = [0, -0.5, 0]"),
        ("camera", "position_m = [0, -100, 0]\nlook_at_m = [0, 0, 0]"),
        ("camera", "position_m = [0, 4, 0]\nlook_at_m = [0, -5, 0]"),
        ("camera", "position_m = [0, 4, 0]\nlook_at_m = [0, 50, 0]"),
        ("camera", "position_m = [1e7, 0, -1e7]\nlook_at_m = [0, 0, 0]"),
        ("camera", "position_m = [0, 1e5, 0]\nlook_at_m = [1e6, 0, 0]"),
        ("object", "mesh = \"island\"\nposition_m = [0, 0, 0]"),
        ("sky", "sun_elevation_deg = 0.0\nsun_azimuth_deg = 90.0\ncloud_cover = 0.0"),
        ("sky", "sun_elevation_deg = -10.0\nhaze = 20.0\ncloud_cover = 1.0"),
        ("sky", "sun_elevation_deg = 90.0\nhaze = 0.0\ncloud_cover = 0.0"),
    ] {
        assert_is_light(gpu, &scene(table, lines), lines);
    }
}

/// Skies without a sun, with the brightest that a file may hold, and black but for one pixel, which is what is left of files
/// with values that are no light.
#[test]
fn odd_panoramas_give_a_picture() {
    let Some(gpu) = gpu() else { return };
    let (width, height) = (16, 8);
    for (name, light) in [
        ("even", (|_| 1.0) as fn(usize) -> f32),
        ("glaring", |_| 65504.0),
        ("dim", |_| 1e-30),
        ("one pixel", |i| if i == 20 { 65504.0 } else { 0.0 }),
        ("every other pixel", |i| if i % 2 == 0 { 65504.0 } else { 0.0 }),
        ("light from below", |i| if i >= 100 { 10.0 } else { 0.0 }),
    ] {
        let pixels = (0..width * height).map(|i| [light(i); 3]).collect();
        let panorama = Panorama { width, height, pixels, repaired: 0 };
        let scene = scene("sky", "kind = \"panorama\"\nfile = \"none.hdr\"");
        assert_is_light(gpu, &Scene { panorama: Some(Arc::new(panorama)), ..scene }, name);
    }
}

/// All the light that exposures can make is white, and the least is black: nothing overflows on the way to a display.
#[test]
fn exposures_beyond_all_light_are_white_and_black() {
    let Some(gpu) = gpu() else { return };
    for tone_map in ["agx", "aces", "pbr-neutral", "none"] {
        for (exposure_ev100, exposure_ev, range) in [(-10.0, 20.0, 230..=255), (30.0, -20.0, 0..=1)] {
            let mut scene =
                scene("picture", &format!("exposure_ev100 = {exposure_ev100:?}\ntone_map = {tone_map:?}"));
            let whitecap_scene::Sky::Atmosphere(sky) = &mut scene.sky else { panic!() };
            sky.exposure_ev = exposure_ev;
            let picture = render_picture(gpu, &scene, &REQUEST, &mut |_| {}).unwrap();
            let odd =
                picture.rgba8.chunks(4).find(|pixel| pixel[..3].iter().any(|value| !range.contains(value)));
            assert_eq!(odd, None, "{tone_map}, {exposure_ev100} EV");
        }
    }
}

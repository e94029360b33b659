//! What pictures show beside their light is where it says, and is the sea that queries know.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::{DVec2, DVec3, Vec3};
use whitecap_render::Gpu;
use whitecap_render::picture::{AuxPicture, PictureRequest, Shows, render_aux};
use whitecap_scene::{Camera, Scene, Sky, Technique, object, technique};
use whitecap_tests::adapter::gpu;
use whitecap_waves::model::Surface;

const TIME_S: f64 = 3.0;

fn layers(gpu: &Gpu, scene: &Scene, width: u32, height: u32) -> AuxPicture {
    let request = PictureRequest { backend: None, width, height, time_s: TIME_S };
    let picture = render_aux(gpu, scene, &request, &mut |_| {}).unwrap();
    let pixels = (width * height) as usize;
    assert_eq!(
        (picture.shows.len(), picture.depth_m.len(), picture.position_m.len()),
        (pixels, pixels, pixels)
    );
    picture
}

fn ocean() -> Scene {
    whitecap_scene::open("spectral-ocean").unwrap()
}

/// An island before the camera.
fn with_island(name: &str) -> Scene {
    let toml = whitecap_scene::named::find(name).unwrap().toml;
    let toml = format!("{toml}\n[[object]]\nmesh = \"island\"\nposition_m = [-90.0, 0.0, 20.0]\n");
    let mut scene = Scene::from_toml(&toml, "island.toml").unwrap_or_else(|e| panic!("{e}"));
    scene.camera =
        Camera { position_m: [0.0, 4.0, 0.0], look_at_m: [-90.0, 4.0, 20.0], vertical_fov_deg: 45.0 };
    scene
}

fn position(picture: &AuxPicture, i: usize) -> DVec3 {
    Vec3::from(picture.position_m[i]).as_dvec3()
}

#[test]
fn positions_and_depths_lie_on_the_rays_of_their_pixels() {
    let Some(gpu) = gpu() else { return };
    for technique in technique::ALL {
        let mut scene = whitecap_scene::open(technique.word).unwrap();
        for moved_m in [DVec3::ZERO, DVec3::new(-1_000_300.0, 0.0, 7_000.0)] {
            for place in [&mut scene.camera.position_m, &mut scene.camera.look_at_m] {
                *place = (DVec3::from(*place) + moved_m).to_array();
            }
            let picture = layers(gpu, &scene, 96, 54);
            let eye = DVec3::from(scene.camera.position_m) - picture.origin_m;
            assert!(eye.x.abs() <= 512.0 && eye.z.abs() <= 512.0);
            assert!(moved_m != DVec3::ZERO || picture.origin_m == DVec3::ZERO);
            let (clip, view) = (picture.clip_from_position.as_dmat4(), picture.view_from_position.as_dmat4());
            let mut drawn = 0;
            for i in 0..picture.shows.len() {
                if picture.shows[i] == Shows::Sky {
                    assert!(picture.depth_m[i] == f32::INFINITY && picture.distance_m[i] == f32::INFINITY);
                    assert_eq!(picture.position_m[i], [0.0; 3]);
                    continue;
                }
                drawn += 1;
                let position = position(&picture, i);
                let ndc = clip.project_point3(position);
                let found = DVec2::new(48.0 * (1.0 + ndc.x), 27.0 * (1.0 - ndc.y));
                let centre = DVec2::new((i % 96) as f64 + 0.5, (i / 96) as f64 + 0.5);
                let word = technique.word;
                assert!((found - centre).length() < 0.01, "{word}: {position} is at {found}, not {centre}");
                let (depth, distance) = (f64::from(picture.depth_m[i]), f64::from(picture.distance_m[i]));
                let tolerance = 1e-4 + 1e-5 * distance;
                assert!((-view.transform_point3(position).z - depth).abs() < tolerance, "{word}: {depth} m");
                assert!(((position - eye).length() - distance).abs() < tolerance, "{word}: {distance} m");
            }
            let is_lake = technique.word == "rippling-lake";
            assert!(drawn > 96 * 54 / 4 || is_lake && moved_m != DVec3::ZERO, "{}: {drawn}", technique.word);
        }
    }
}

/// Looking steeply down, where the mesh is finest, and along, where waves have left it.
#[test]
fn water_lies_on_the_surface_that_queries_tell() {
    let Some(gpu) = gpu() else { return };
    let mut scene = ocean();
    let surface = scene.surface().unwrap();
    let significant_height_m = 4.0 * surface.variance_m2().sqrt();
    let radius_m = match &scene.technique {
        Technique::SpectralOcean(settings) => 1000.0 * settings.curvature_radius_km,
        _ => panic!(),
    };
    for (toward, within, within_deg) in [([2.0, -4.0, 1.0], 0.003, 3.5), ([20.0, -4.0, 10.0], 0.01, 9.0)] {
        let eye = DVec3::from(scene.camera.position_m);
        scene.camera.look_at_m = (eye + DVec3::from(toward)).to_array();
        let picture = layers(gpu, &scene, 96, 54);
        let seen: Vec<usize> = (0..picture.shows.len())
            .filter(|&i| picture.shows[i] == Shows::Water && picture.distance_m[i] < 60.0)
            .collect();
        let at = |i: usize| position(&picture, i) + picture.origin_m;
        let places: Vec<DVec2> = seen.iter().map(|&i| DVec2::new(at(i).x, at(i).z)).collect();
        let points = surface.query(&places, TIME_S).unwrap();
        let (mut squares, mut turns) = (0.0, 0.0);
        for ((&i, place), point) in seen.iter().zip(&places).zip(&points) {
            let drop_m = (place - DVec2::new(eye.x, eye.z)).length_squared() / (2.0 * radius_m);
            let error = at(i).y + drop_m - point.displacement_m.y;
            squares += error * error;
            let normal = Vec3::from(picture.shading.as_ref().unwrap().normal[i]).as_dvec3();
            assert!((normal.length() - 1.0).abs() < 1e-5, "{normal}");
            turns += normal.angle_between(point.normal).powi(2);
        }
        let count = seen.len() as f64;
        let (height, turn) = ((squares / count).sqrt(), (turns / count).sqrt().to_degrees());
        assert!(height < within * significant_height_m, "{toward:?}: {height} m of {significant_height_m} m");
        assert!(turn < within_deg, "{toward:?}: {turn}°");
    }
}

/// The classics draw their seas as they draw them, coarser than queries know them; positions are those of the same waves.
#[test]
fn water_of_every_technique_moves_as_queries_tell() {
    let Some(gpu) = gpu() else { return };
    for technique in technique::ALL {
        let scene = whitecap_scene::open(technique.word).unwrap();
        let surface = scene.surface().unwrap();
        let picture = layers(gpu, &scene, 96, 54);
        let seen: Vec<DVec3> = (0..picture.shows.len())
            .filter(|&i| picture.shows[i] == Shows::Water && picture.distance_m[i] < 30.0)
            .map(|i| position(&picture, i) + picture.origin_m)
            .collect();
        let places: Vec<DVec2> = seen.iter().map(|at| DVec2::new(at.x, at.z)).collect();
        let points = surface.query(&places, TIME_S).unwrap();
        let rms = |values: &mut dyn Iterator<Item = f64>| {
            (values.map(|value| value * value).sum::<f64>() / seen.len().max(1) as f64).sqrt()
        };
        let error = rms(&mut seen.iter().zip(&points).map(|(at, point)| at.y - point.displacement_m.y));
        let deviation = surface.variance_m2().sqrt();
        assert!(
            seen.len() > 1000 && error < 0.003 + 0.1 * deviation,
            "{}: {error} m of {deviation} m",
            technique.word
        );
    }
}

#[test]
fn objects_are_told_from_water_and_sky_and_stand_in_their_places() {
    let Some(gpu) = gpu() else { return };
    for name in ["spectral-ocean", "meshuggah"] {
        let scene = with_island(name);
        let ground = object::ground(&scene.read_objects().unwrap()).unwrap();
        let picture = layers(gpu, &scene, 96, 54);
        let count = |wanted| picture.shows.iter().filter(|shows| **shows == wanted).count();
        let counts = [Shows::Sky, Shows::Water, Shows::Object].map(count);
        assert!(counts.iter().all(|&count| count > 200), "{name}: {counts:?}");
        let errors_m = (0..picture.shows.len()).filter(|&i| picture.shows[i] == Shows::Object).map(|i| {
            let place = position(&picture, i);
            place.y - ground.height_m(place.x, place.z).unwrap()
        });
        // The ground is a coarser grid than the island.
        let error_m = (errors_m.map(|error| error * error).sum::<f64>() / counts[2] as f64).sqrt();
        assert!(error_m < 0.05, "{name}: {error_m} m off the ground");
        // Normals are those of techniques in linear light.
        assert_eq!(picture.shading.is_some(), name == "spectral-ocean");
        let Some(shading) = &picture.shading else { continue };
        for (i, shows) in picture.shows.iter().enumerate() {
            let normal = Vec3::from(shading.normal[i]);
            let expected = if *shows == Shows::Sky { 0.0 } else { 1.0 };
            assert!((normal.length() - expected).abs() < 1e-5, "{shows:?}: {normal}");
            assert!(*shows != Shows::Object || normal.y > 0.0, "{normal} on an island");
            assert!(*shows == Shows::Water || shading.glint[i] == 0.0);
        }
    }
}

#[test]
fn glint_is_where_water_mirrors_the_sun() {
    let Some(gpu) = gpu() else { return };
    let mut scene = ocean();
    let Sky::Atmosphere(sky) = &mut scene.sky else { panic!() };
    (sky.sun_azimuth_deg, sky.sun_elevation_deg) = (240.0, 30.0);
    let (azimuth, elevation) = (240.0_f64.to_radians(), 30.0_f64.to_radians());
    let toward_sun =
        DVec3::new(azimuth.sin() * elevation.cos(), elevation.sin(), -azimuth.cos() * elevation.cos());
    let eye = DVec3::from(scene.camera.position_m);
    scene.camera.look_at_m = (eye + DVec3::new(toward_sun.x, -0.4, toward_sun.z) * 10.0).to_array();
    let picture = layers(gpu, &scene, 192, 108);
    let shading = picture.shading.as_ref().unwrap();
    let (mut bright, mut mirrors) = (Vec::new(), Vec::new());
    for (i, &glint) in shading.glint.iter().enumerate() {
        assert!((0.0..=1.0).contains(&glint));
        if picture.shows[i] != Shows::Water {
            continue;
        }
        let away = (position(&picture, i) + picture.origin_m - eye).normalize();
        let normal = Vec3::from(shading.normal[i]).as_dvec3();
        let off_deg = away.reflect(normal).angle_between(toward_sun).to_degrees();
        if glint > 0.9 {
            bright.push(off_deg);
        }
        if off_deg < 2.0 {
            mirrors.push(glint);
        }
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    assert!(
        bright.len() > 100 && mean(&bright) < 15.0,
        "{} bright pixels, {}° off",
        bright.len(),
        mean(&bright)
    );
    assert!(mirrors.len() > 20 && mirrors.iter().all(|glint| *glint > 0.8), "{mirrors:?}");

    let Sky::Atmosphere(sky) = &mut scene.sky else { panic!() };
    sky.sun_elevation_deg = -10.0;
    let night = layers(gpu, &scene, 48, 27);
    assert!(night.shading.unwrap().glint.iter().all(|glint| *glint == 0.0));
}

//! What of the spectral ocean can be measured in its pictures: that light does not depend on distance, that the sun's glitter
//! has the slopes of the sea, and where the horizon lies.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use std::sync::Arc;

use glam::{DVec2, DVec3, Vec3, Vec4};
use whitecap_render::gpu::for_tests::Canvas;
use whitecap_render::{Gpu, MAX_VIEWS, TargetFormat, View, Water};
use whitecap_scene::panorama::Panorama;
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::{Camera, Scene};
use whitecap_tests::adapter::gpu;
use whitecap_waves::model::spectral::Band;
use whitecap_waves::optics::fresnel_exact;
use whitecap_waves::statistics::PolarSpectrum;

/// Radiance of the scene, kcd/m².
const TARGET: TargetFormat = TargetFormat {
    color: wgpu::TextureFormat::Rgba32Float,
    depth: wgpu::TextureFormat::Depth32Float,
    depth_compare: wgpu::CompareFunction::Greater,
    sample_count: 1,
    sample_shading: true,
};

/// No light is negative.
const NOTHING: wgpu::Color = wgpu::Color { r: -1.0, g: 0.0, b: 0.0, a: 1.0 };

/// The sea of `system` under a panorama, through clear air on a level earth, over water that gives no light back.
fn scene(system: &str, choppiness: f64, panorama: Panorama) -> Scene {
    let text = format!(
        "technique = \"spectral-ocean\"\nseed = 3\n[sea]\nchoppiness = {choppiness:?}\n[[sea.system]]\n{system}\n\
         [spectral-ocean]\nvisibility_km = 1e6\ncurvature_radius_km = 1e6\n\
         absorption_per_m = [10, 10, 10]\nscattering_per_m = [1e-4, 1e-4, 1e-4]\n\
         [sky]\nkind = \"panorama\"\nfile = \"none.hdr\"\n\
         [camera]\nposition_m = [0, 5, 0]\nlook_at_m = [100, 0, 0]\n"
    );
    Scene { panorama: Some(Arc::new(panorama)), ..Scene::from_toml(&text, "ocean.toml").unwrap() }
}

/// A panorama whose radiance is `radiance` of the elevation's sine.
fn sky(radiance: impl Fn(f64) -> f32) -> Panorama {
    let (width, height) = (64, 512);
    let row = |y: usize| {
        let sine = ((0.5 - (y as f64 + 0.5) / height as f64) * std::f64::consts::PI).sin();
        vec![[radiance(sine); 3]; width]
    };
    Panorama { width, height, pixels: (0..height).flat_map(row).collect(), repaired: 0 }
}

/// Radiance of the water as all views see it, with -1 where there is none. Colour is left out: the green.
fn radiances(
    gpu: &Gpu,
    water: &mut Water,
    size: [u32; 2],
    views: &[View],
    time_s: f64,
) -> Vec<Vec<Option<f64>>> {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    water.prepare(&gpu.device, &gpu.queue, &mut encoder, views, time_s).unwrap();
    let canvases: Vec<_> = views.iter().map(|_| Canvas::new(gpu, &TARGET, size)).collect();
    for (i, canvas) in canvases.iter().enumerate() {
        canvas.draw(&mut encoder, NOTHING, |pass| water.draw(pass, i));
    }
    gpu.queue.submit([encoder.finish()]);
    let of = |canvas: &Canvas<'_>| {
        let pixels: Vec<Vec4> = bytemuck::pod_collect_to_vec(&canvas.pixels());
        pixels.iter().map(|pixel| (pixel.x >= 0.0).then_some(f64::from(pixel.y))).collect()
    };
    canvases.iter().map(of).collect()
}

fn look(eye: DVec3, toward: DVec3, vertical_fov_deg: f64, size: [u32; 2]) -> View {
    let look_at = eye + toward;
    View::of_camera(
        &Camera { position_m: eye.to_array(), look_at_m: look_at.to_array(), vertical_fov_deg },
        size,
    )
}

/// The direction that a pixel's middle looks in.
fn ray(view: &View, size: [u32; 2], i: usize) -> DVec3 {
    let (x, y) = (i as u32 % size[0], i as u32 / size[0]);
    let ndc = Vec3::new(
        (x as f32 + 0.5) / size[0] as f32 * 2.0 - 1.0,
        1.0 - (y as f32 + 0.5) / size[1] as f32 * 2.0,
        0.5,
    );
    view.clip_from_eye_world().inverse().project_point3(ndc).as_dvec3().normalize()
}

/// Places all over some kilometres, none twice.
fn place(i: usize) -> DVec2 {
    let i = i as f64 + 1.0;
    3000.0 * DVec2::new((0.754_877_666 * i).fract(), (0.569_840_291 * i).fract())
}

/// From 4 m and up to 64 times as high, at the same angles, the sea is as bright, to 2 % and the standard error of the two means,
/// half a per cent, by the chance of what waves a picture has: what a pixel no longer resolves is roughness. Seen steeply and at grazing angles, under a sky that
/// is four times as bright at the horizon. Foam, of which a near picture has much or none, needs choppiness.
#[test]
fn brightness_does_not_depend_on_distance() {
    let Some(gpu) = gpu() else { return };
    let system =
        "spectrum = \"elfouhaily\"\nwind_speed_mps = 5.0\nfrom_deg = 270.0\nspreading = \"elfouhaily\"";
    let size = [32, 18];
    let mut water = Water::new(
        &gpu.device,
        &gpu.queue,
        &scene(system, 0.0, sky(|sine| 1.0 + 3.0 * (-4.0 * sine.max(0.0)).exp() as f32)),
        TARGET,
    )
    .unwrap();
    for pitch_deg in [-60.0_f64, -25.0, -12.0] {
        let (sine, cosine) = pitch_deg.to_radians().sin_cos();
        let (mut nearest, mut error_of_nearest) = (0.0, 0.0);
        for doubling in 0..7 {
            let height_m = 4.0 * f64::from(1 << doubling);
            // Few waves are in a near picture, many in a far one.
            let frames = (30 >> doubling).max(6);
            let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
            for frame in 0..frames {
                let views: Vec<View> = (0..MAX_VIEWS)
                    .map(|i| {
                        let number = 1000 * doubling + MAX_VIEWS * frame + i;
                        let at = place(number);
                        let (z, x) = (number as f64 * 2.4).sin_cos();
                        let toward = DVec3::new(x * cosine, sine, z * cosine);
                        look(DVec3::new(at.x, height_m, at.y), toward, 12.0, size)
                    })
                    .collect();
                for picture in radiances(gpu, &mut water, size, &views, 10.0 * frame as f64) {
                    let mean = picture.iter().map(|light| light.unwrap()).sum::<f64>() / picture.len() as f64;
                    sum += mean;
                    squares += mean * mean;
                    count += 1.0;
                }
            }
            let mean = sum / count;
            let error = ((squares / count - mean * mean) / count).sqrt() / mean;
            if doubling == 0 {
                (nearest, error_of_nearest) = (mean, error);
            }
            let error = error.hypot(error_of_nearest);
            let drift = mean / nearest - 1.0;
            println!("{pitch_deg}°, {height_m} m: {:+.2} % ± {:.2} %", 100.0 * drift, 100.0 * error);
            assert!(
                drift.abs() < 0.02 + error.min(0.006),
                "{pitch_deg}° from {height_m} m: {drift} ± {error}"
            );
        }
    }
}

/// Under a black sky with the sun at the zenith, a picture straight down is the distribution of slopes: each pixel is lit by
/// the facets that turn the sun to the eye (Cox and Munk 1954). Its second moments are those of the sea to 10 %, and Cox and
/// Munk's for this wind to 20 %.
#[test]
fn the_glitter_has_the_slopes_of_the_sea() {
    let Some(gpu) = gpu() else { return };
    let wind_mps = 10.0;
    let system = format!(
        "spectrum = \"elfouhaily\"\nwind_speed_mps = {wind_mps:?}\nfrom_deg = 270.0\nspreading = \"elfouhaily\""
    );
    let with_sun = sky(|sine| if sine > 0.999_95 { 1e5 } else { 1.0 });
    let size = [256, 256];
    let [lit, unlit] = [with_sun, sky(|_| 1.0)].map(|panorama| scene(&system, 0.0, panorama));
    let spectra = lit.sea.spectra().unwrap();
    let dispersion = lit.sea.water().unwrap().dispersion;
    let sea =
        PolarSpectrum::of(&spectra, dispersion, Band::WHOLE).unwrap().within(Band { from: 0.0, to: 370.0 }).1;
    // Clean surface: up and down the wind, and across it.
    let cox_munk = [0.00316 * wind_mps, 0.003 + 0.00192 * wind_mps];

    let mut waters = [lit, unlit].map(|scene| Water::new(&gpu.device, &gpu.queue, &scene, TARGET).unwrap());
    for height_m in [20.0, 60.0, 300.0] {
        let (mut along, mut across, mut all) = (0.0, 0.0, 0.0);
        for number in 0..if height_m < 100.0 { 24 } else { 2 } {
            let at = place(number);
            let view = look(DVec3::new(at.x, height_m, at.y), DVec3::NEG_Y, 140.0, size);
            let [lit, unlit] =
                waters.each_mut().map(|water| radiances(gpu, water, size, &[view], 0.0).remove(0));
            for (i, (lit, unlit)) in lit.iter().zip(&unlit).enumerate() {
                let glitter = lit.unwrap() - unlit.unwrap();
                let toward_eye = -ray(&view, size, i);
                let half = (toward_eye + DVec3::Y).normalize();
                let slope = -DVec2::new(half.x, half.z) / half.y;
                // L = E F p/(4 cos θ cos⁴ β); and what of the plane of slopes a pixel covers: with t = tan θ in the
                // picture and s = tan θ/2, s ds over t dt.
                let density = glitter * toward_eye.y * half.y.powi(4) / fresnel_exact(half.y, 1.34);
                let s = slope.length().max(1e-6);
                let t = 2.0 * s / (1.0 - s * s);
                let area = (1.0 - s * s).powi(2) / (2.0 * (1.0 + s * s)) * s / t;
                along += density * area * slope.x * slope.x;
                across += density * area * slope.y * slope.y;
                all += density * area;
            }
        }
        let [along, across] = [along / all, across / all];
        println!(
            "{height_m} m: {along:.4} {across:.4}, sea {:.4} {:.4}, Cox and Munk {:.4} {:.4}",
            sea.xx, sea.zz, cox_munk[0], cox_munk[1]
        );
        for (name, found, of_sea, measured) in
            [("along", along, sea.xx, cox_munk[0]), ("across", across, sea.zz, cox_munk[1])]
        {
            assert!((found / of_sea - 1.0).abs() < 0.1, "{name} from {height_m} m: {found}, sea {of_sea}");
            assert!((found / measured - 1.0).abs() < 0.2, "{name} from {height_m} m: {found}, {measured}");
        }
    }
}

/// The last water is seen √(2h/R) below the level, from √(2Rh) away, on the earth and on a smaller planet.
#[test]
fn the_horizon_lies_where_the_earth_curves_away() {
    let Some(gpu) = gpu() else { return };
    let system = "spectrum = \"pierson-moskowitz\"\nsignificant_height_m = 0.01\nfrom_deg = 270.0";
    let size = [8, 1024];
    for radius_km in [6371.0, 1737.4] {
        let mut scene = scene(system, 1.0, sky(|_| 1.0));
        let whitecap_scene::Technique::SpectralOcean(settings) = &mut scene.technique else { panic!() };
        settings.curvature_radius_km = radius_km;
        let mut water = Water::new(&gpu.device, &gpu.queue, &scene, TARGET).unwrap();
        for height_m in [2.0_f64, 10.0, 100.0, 1000.0, 10_000.0] {
            let expected = (2.0 * height_m / (1000.0 * radius_km)).sqrt();
            // The picture is four times as high as the dip.
            let view = look(
                DVec3::new(40.0, height_m, -7.0),
                DVec3::new(expected.cos(), -expected.sin(), 0.0),
                (4.0 * expected).to_degrees(),
                size,
            );
            let picture = radiances(gpu, &mut water, size, &[view], 0.0).remove(0);
            let first = picture.chunks(8).position(|row| row.iter().all(Option::is_some)).unwrap();
            let dip = -ray(&view, size, first * 8 + 4).y.asin();
            // A pixel is 0.4 % of the dip, and to the sphere's own horizon the formula is a series in h/R.
            assert!(
                (dip / expected - 1.0).abs() < 0.01,
                "{radius_km} km from {height_m} m: {dip}, {expected}"
            );
        }
    }
}

/// From the height of a hill, a mountain and an airliner, straight down on a sea of wind and swell under the sun: what a picture
/// shows is not to be found again a tile further, for any tile of which it holds two.
#[test]
fn no_tile_is_seen_to_repeat() {
    let Some(gpu) = gpu() else { return };
    const SIDE: usize = 320;
    const FOV_DEG: f64 = 50.0;
    for height_m in [1000.0, 3000.0, 10_000.0] {
        let text = format!(
            "technique = \"spectral-ocean\"\nseed = 6\n\
             [[sea.system]]\nspectrum = \"elfouhaily\"\nwind_speed_mps = 11.0\nfrom_deg = 300.0\n\
             spreading = \"elfouhaily\"\n\
             [[sea.system]]\nspectrum = \"jonswap\"\nsignificant_height_m = 1.8\npeak_period_s = 12.0\ngamma = 5.0\n\
             from_deg = 340.0\nspreading = {{ cos2s = 40.0 }}\n\
             [sky]\nkind = \"atmosphere\"\nsun_elevation_deg = 40.0\n\
             [camera]\nposition_m = [0.0, {height_m:?}, 0.0]\nlook_at_m = [1.0, 0.0, 0.0]\n"
        );
        let scene = Scene::from_toml(&text, "above.toml").unwrap();
        let SeaSurface::Spectral(sea) = scene.sea.build(scene.seed).unwrap() else { panic!() };
        let mut water = Water::new(&gpu.device, &gpu.queue, &scene, TARGET).unwrap();
        let size = [SIDE as u32; 2];
        let pictures: Vec<Vec<f64>> = (0..3)
            .flat_map(|frame| {
                let above = |i: usize| {
                    let at = 20.0 * place(MAX_VIEWS * frame + i);
                    look(DVec3::new(at.x, height_m, at.y), DVec3::NEG_Y, FOV_DEG, size)
                };
                let views: Vec<View> = (0..MAX_VIEWS).map(above).collect();
                radiances(gpu, &mut water, size, &views, 60.0 * frame as f64)
            })
            .map(|picture| picture.into_iter().map(|light| light.unwrap().ln()).collect())
            .collect();
        // What all have in common is the view's: the sun's glitter, the air.
        let common: Vec<f64> = (0..SIDE * SIDE)
            .map(|i| pictures.iter().map(|picture| picture[i]).sum::<f64>() / pictures.len() as f64)
            .collect();
        let per_m = SIDE as f64 / (2.0 * height_m * (0.5 * FOV_DEG).to_radians().tan());
        for cascade in &sea.parameters().cascades {
            let lag = cascade.tile_size_m * per_m;
            for (x, y) in [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, -1.0), (2.0, 0.0), (2.0, -1.0)] {
                let (x, y) = (lag * x, lag * y);
                if lag < 8.0 || f64::max(x, y) > 0.6 * SIDE as f64 {
                    continue;
                }
                let mut sums = [0.0; 3];
                for picture in &pictures {
                    let at = |column: f64, row: f64| {
                        let (i, j, t, u) = (column as usize, row as usize, column.fract(), row.fract());
                        let light = |i: usize, j: usize| picture[j * SIDE + i] - common[j * SIDE + i];
                        let along = |j: usize| light(i, j) * (1.0 - t) + light(i + 1, j) * t;
                        along(j) * (1.0 - u) + along(j + 1) * u
                    };
                    let margin = 1.0;
                    let end = SIDE as f64 - 2.0;
                    for row in (0..SIDE).map(|row| row as f64) {
                        for column in (0..SIDE).map(|column| column as f64) {
                            let (there_x, there_y) = (column + x, row + y);
                            if [column, row, there_x, there_y].iter().all(|at| (margin..end).contains(at)) {
                                let (here, there) = (at(column, row), at(there_x, there_y));
                                sums[0] += here * there;
                                sums[1] += here * here;
                                sums[2] += there * there;
                            }
                        }
                    }
                }
                let alike = sums[0] / (sums[1] * sums[2]).sqrt();
                println!(
                    "{height_m} m, tile of {:.1} m, lag ({x:.0}, {y:.0}) pixels: {alike:+.3}",
                    cascade.tile_size_m
                );
                assert!(alike.abs() < 0.1, "{height_m} m, tile of {} m: {alike}", cascade.tile_size_m);
            }
        }
    }
}

use super::gpu::{group_layout, ocean_group};
use super::*;
use crate::TargetFormat;
use crate::environment::Environment;
use crate::gpu::for_tests::{BoundGroup, compute_beside, gpu};
use crate::gpu::resources::buffer;
use crate::pass::Objects;
use crate::shader_lib::{self, layout::assert_layout};
use crate::uniforms::Shared;
use glam::{DVec3, Vec2};
use whitecap_scene::Scene;
use whitecap_waves::model::TileFields;
use whitecap_waves::model::spectral::Patch;

#[test]
fn rust_and_wgsl_agree_about_layout() {
    let wgsl = shader_lib::SPECTRAL_OCEAN.wgsl;
    assert_layout!(
        GpuSpectralOcean,
        wgsl,
        "GpuSpectralOcean",
        [level_origins, cascades, cell_m, eye_height_m, earth_radius_m, cascade_count, foam,]
    );
    assert_layout!(
        GpuWaters,
        wgsl,
        "GpuWaters",
        [light, slopes_beyond, depth_m, slopes_whole, sun_klx, sky_klx, sun_radius_rad, toward_sun]
    );
    assert_layout!(
        GpuCascade,
        wgsl,
        "GpuCascade",
        [eye_in_tile, tiles_per_m, samples, fade_start_m, fade_end_m, half_texel, slope_shape, patchwork]
    );
}

fn scene() -> Scene {
    whitecap_scene::open("spectral-ocean").unwrap()
}

fn with_technique(scene: &Scene, test: impl FnOnce(&wgpu::Device, &wgpu::Queue, SpectralOcean)) {
    let Some(gpu) = gpu() else { return };
    let (device, queue) = (&gpu.device, &gpu.queue);
    let environment = Environment::new(scene).unwrap();
    // A still's mesh, which also carries the finest tile about an eye 1 m over the water where a processor draws.
    let target = TargetFormat { sample_shading: true, ..TargetFormat::default() };
    let shared = Shared::new(device, queue, &environment, target);
    let objects = Objects::new(device, queue, scene).unwrap();
    let whitecap_scene::Technique::SpectralOcean(settings) = &scene.technique else { panic!() };
    let build = Build {
        light: environment.light.as_ref(),
        ..Build::under_white_light(device, queue, scene, &shared, &objects)
    };
    test(device, queue, SpectralOcean::new(&build, settings).unwrap());
}

fn bring_to(device: &wgpu::Device, queue: &wgpu::Queue, technique: &mut SpectralOcean, time_s: f64) {
    let mut encoder = device.create_command_encoder(&Default::default());
    for maps in &mut technique.tiles {
        maps.update(queue, &mut encoder, time_s);
    }
    queue.submit([encoder.finish()]);
}

fn view_from(eye_m: DVec3) -> View {
    let camera = whitecap_scene::Camera {
        position_m: eye_m.to_array(),
        look_at_m: (eye_m + DVec3::new(10.0, -1.0, 3.0)).to_array(),
        vertical_fov_deg: 45.0,
    };
    View::of_camera(&camera, [320, 180])
}

/// The vertex stage's own function on the device: positions from the eye.
fn read_vertices(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    technique: &SpectralOcean,
    view: &View,
    grid: &[[f32; 4]],
) -> Vec<[f32; 4]> {
    let layout = group_layout(device);
    let waters = buffer(device, queue, "waters", &[0; size_of::<GpuWaters>()], wgpu::BufferUsages::UNIFORM);
    let group = ocean_group(device, &layout, &technique.tiles, &technique.foam, &waters, &technique.slots);
    technique.slots.write(queue, 3, &technique.uniforms(view));
    let ocean = BoundGroup {
        index: 2,
        layout: &layout,
        group: &group,
        offsets: &[ViewSlots::<GpuSpectralOcean>::offset(3)],
    };
    compute_beside(device, queue, &shader_lib::SPECTRAL_OCEAN_VERTICES, "cs_displace", grid, 3, &[ocean])
}

/// The cubic B-spline, `u` samples from its middle.
fn cubic_spline(u: f64) -> f64 {
    let u = u.abs();
    if u < 1.0 { 2.0 / 3.0 - u * u + 0.5 * u * u * u } else { (2.0 - u).max(0.0).powi(3) / 6.0 }
}

/// The spline with a tile's coefficients: the twin of `displacement_at` in `surface.wesl`.
fn displacement_at(coefficients: &TileFields, place: DVec2) -> DVec3 {
    let n = coefficients.resolution() as i64;
    let corner = place.floor();
    let mut sum = DVec3::ZERO;
    for (j, i) in (-1..=2).flat_map(|j| (-1..=2).map(move |i| (j, i))) {
        let column = corner + DVec2::new(f64::from(i), f64::from(j));
        let weight = cubic_spline(place.x - column.x) * cubic_spline(place.y - column.y);
        let [x, z] = [column.x, column.y].map(|place| (place as i64).rem_euclid(n) as usize);
        sum += weight * DVec3::from(coefficients.displacement(z * n as usize + x).map(f64::from));
    }
    sum
}

/// Places round the eye on all levels, and the places in the world where they rest.
fn some_vertices(technique: &SpectralOcean, view: &View) -> (Vec<[f32; 4]>, Vec<DVec2>) {
    let eye = DVec2::new(view.eye_m.x, view.eye_m.z);
    let first_m = technique.cell_m(view.eye_m.y);
    let mut vertices = Vec::new();
    let mut rests = Vec::new();
    for i in 0..700_i32 {
        let (x, z, level) = (i * 37 % 127 - 63, i * 53 % 121 - 60, i % technique.levels as i32);
        let cell_m = first_m * f64::from(level).exp2();
        vertices.push([x as f32, z as f32, level as f32, 0.0]);
        rests.push((eye / cell_m).round() * cell_m + DVec2::new(x.into(), z.into()) * cell_m);
    }
    (vertices, rests)
}

const EYES: [(DVec3, f64); 4] = [
    (DVec3::new(0.0, 4.0, 0.0), 0.0),
    (DVec3::new(-31.7, 1.0, 811.2), 3.7),
    (DVec3::new(1_000_123.4, 8.0, -2_000_456.7), -512.25),
    (DVec3::new(-12.5, 400.0, 777.7), 1e6),
];

/// Here and a thousand kilometres away, on every level, while waves fade: the device's sum is the one in f64.
#[test]
fn drawn_vertices_are_the_sum_of_the_tiles() {
    with_technique(&scene(), |device, queue, mut technique| {
        let hs_m = technique.significant_height_m;
        for (eye_m, time_s) in EYES {
            let view = view_from(eye_m);
            let mut fields = Vec::new();
            let whole = scene().sea.build(scene().seed).unwrap().into_tiles().unwrap();
            for mut model in whole {
                let mut tile = TileFields::new(model.resolution());
                model.evaluate_coefficients(time_s, &mut tile);
                fields.push((model.tile_size_m(), tile));
            }
            bring_to(device, queue, &mut technique, time_s);
            let uniforms = technique.uniforms(&view);
            let (grid, rests) = some_vertices(&technique, &view);
            let drawn = read_vertices(device, queue, &technique, &view, &grid);
            for (rest_m, drawn) in rests.iter().zip(&drawn) {
                let from_eye = DVec3::new(rest_m.x, 0.0, rest_m.y) - eye_m;
                let mut expected = from_eye;
                for (index, ((tile_m, tile), cascade)) in fields.iter().zip(&uniforms.cascades).enumerate() {
                    let [from, to] = [cascade.fade_start_m, cascade.fade_end_m].map(f64::from);
                    let t = ((from_eye.length() - from) / (to - from)).clamp(0.0, 1.0);
                    let share = 1.0 - t * t * (3.0 - 2.0 * t);
                    let of_copy = |patch: Patch| {
                        let place = (rest_m / tile_m + patch.shift).fract_gl() * tile.resolution() as f64;
                        patch.weight * displacement_at(tile, place)
                    };
                    let alone = Patch { shift: DVec2::ZERO, weight: 1.0, slope_per_m: DVec2::ZERO };
                    let sewn = technique.patchworks.get(index);
                    let patches = sewn.map_or(vec![alone], |sewn| sewn.patches_at(*rest_m).to_vec());
                    expected += share * patches.into_iter().map(of_copy).sum::<DVec3>();
                }
                let level = DVec2::new(from_eye.x, from_eye.z).length();
                expected.y -= whitecap_waves::optics::curvature_drop_m(level, 6_371_000.0);
                let drawn = DVec3::new(drawn[0].into(), drawn[1].into(), drawn[2].into());
                // f32 from the eye, and in tiles: some millionths of the distance.
                let rounding = 2e-6 * from_eye.length();
                let error = (drawn - expected).abs().max_element();
                assert!(error < 2e-4 * hs_m + rounding, "{eye_m} at {rest_m}: {drawn} instead of {expected}");
            }
        }
    });
}

/// The meshes of a processor's frames, of its stills and of other devices.
fn meshes() -> [(u32, u32); 3] {
    [mesh_size(true, false), mesh_size(true, true), mesh_size(false, false)]
}

/// How much of each tile the mesh still has so far from the eye.
fn shares(uniforms: &GpuSpectralOcean, distance_m: f64) -> impl Iterator<Item = f64> + '_ {
    uniforms.cascades[..uniforms.cascade_count as usize].iter().map(move |cascade| {
        let [from, to] = [cascade.fade_start_m, cascade.fade_end_m].map(f64::from);
        let t = ((distance_m - from) / (to - from)).clamp(0.0, 1.0);
        1.0 - t * t * (3.0 - 2.0 * t)
    })
}

/// A vertex of the mesh.
struct Vertex {
    rest_m: DVec2,
    /// In the world, where the Earth is flat.
    drawn_m: DVec3,
    /// How much of each tile it is moved by.
    shares: Vec<f64>,
}

/// Vertices about viewers who stand `height_m` over several places at several times, on a mesh: a circle of them on each of the
/// first `levels`, near the viewer on the first one, in the middle of their rings on the others.
fn vertices_about_viewers(
    (cells, mesh_levels): (u32, u32),
    height_m: f64,
    levels: u32,
    mut test: impl FnMut(&SpectralOcean, f64, &[Vertex]),
) {
    with_technique(&scene(), |device, queue, mut technique| {
        (technique.grid, technique.levels) = (mesh(cells, mesh_levels), mesh_levels);
        let on_circle = |i: u32| {
            let level = i % levels;
            let radius = f64::from(cells) * if level == 0 { 0.125 } else { 0.375 };
            let (z, x) = (f64::from(i) * 2.4).sin_cos();
            [(radius * x).round() as f32, (radius * z).round() as f32, level as f32, 0.0]
        };
        let grid: Vec<[f32; 4]> = (0..24 * levels).map(on_circle).collect();
        for time_s in [0.0, 3.7, -1_234.5, 9e5] {
            bring_to(device, queue, &mut technique, time_s);
            let mut vertices = Vec::new();
            for i in 0..6 {
                let x_m = -31.7 + 373.1 * f64::from(i);
                let eye_m = DVec3::new(x_m, height_m, 811.2 - 1_917.3 * f64::from(i * i));
                let view = view_from(eye_m);
                let uniforms = technique.uniforms(&view);
                for ([x, z, level, _], drawn) in
                    grid.iter().zip(read_vertices(device, queue, &technique, &view, &grid))
                {
                    let cell_m = technique.cell_m(height_m) * f64::from(*level).exp2();
                    let cells = (DVec2::new(eye_m.x, eye_m.z) / cell_m).round();
                    let rest_m = (cells + DVec2::new((*x).into(), (*z).into())) * cell_m;
                    let from_eye = DVec3::new(rest_m.x, 0.0, rest_m.y) - eye_m;
                    let level_m = DVec2::new(from_eye.x, from_eye.z).length();
                    let mut drawn_m = eye_m + Vec3::new(drawn[0], drawn[1], drawn[2]).as_dvec3();
                    drawn_m.y += whitecap_waves::optics::curvature_drop_m(level_m, 6_371_000.0);
                    let shares = shares(&uniforms, from_eye.length()).collect();
                    vertices.push(Vertex { rest_m, drawn_m, shares });
                }
            }
            test(&technique, time_s, &vertices);
        }
    });
}

/// Where a viewer of each mesh is near the water: all of it is within the distance where waves begin to leave.
const NEAR_M: [f64; 3] = [0.25, 1.0, 1.0];

/// Near the viewer what is drawn is what the sea says, on every mesh.
#[test]
fn near_the_viewer_the_drawn_sea_is_the_sea() {
    let sea = scene().sea.build(scene().seed).unwrap();
    for (mesh, height_m) in meshes().into_iter().zip(NEAR_M) {
        let (mut sum, mut worst, mut highest, mut count) = (0.0, 0.0_f64, 0.0_f64, 0.0);
        vertices_about_viewers(mesh, height_m, 1, |technique, time_s, vertices| {
            for Vertex { rest_m, drawn_m, shares } in vertices {
                assert!(shares.iter().all(|share| *share == 1.0), "{mesh:?}: {shares:?}");
                let point = sea.sample(*rest_m, time_s).displacement_m;
                let expected_m = DVec3::new(rest_m.x, 0.0, rest_m.y) + point;
                let error = (*drawn_m - expected_m) / technique.significant_height_m;
                (sum, count) = (sum + error.length_squared(), count + 1.0);
                (worst, highest) = (worst.max(error.length()), highest.max(error.y.abs()));
            }
        });
        let rms = f64::sqrt(sum / count);
        println!("{mesh:?}: rms {rms:.5}, worst {worst:.5}, of height {highest:.5}");
        let is_near = rms < 0.0006 && worst < 0.0012 && highest < 0.001;
        assert!(is_near || count == 0.0 && gpu().is_none(), "{mesh:?}: {rms}, {worst}, {highest}");
    }
}

/// Who asks for the height over a vertex is told where the vertex is, on every mesh.
#[test]
fn near_the_viewer_the_drawn_sea_is_the_queried_one() {
    let sea = scene().sea.build(scene().seed).unwrap();
    for (mesh, height_m) in meshes().into_iter().zip(NEAR_M) {
        let mut compared = 0;
        vertices_about_viewers(mesh, height_m, 1, |technique, time_s, vertices| {
            let places: Vec<DVec2> =
                vertices.iter().map(|vertex| DVec2::new(vertex.drawn_m.x, vertex.drawn_m.z)).collect();
            let bound_m = (1e-3 * technique.significant_height_m).max(1e-3);
            for (Vertex { drawn_m, .. }, found) in vertices.iter().zip(sea.query(&places, time_s).unwrap()) {
                if found.jacobian < 0.3 {
                    continue; // the crest all but folds
                }
                let error_m = (found.height_m() - drawn_m.y).abs();
                assert!(error_m < bound_m, "{mesh:?}: {drawn_m} at {time_s}: {found:?}");
                compared += 1;
            }
        });
        assert!(compared > 500 || compared == 0 && gpu().is_none(), "{mesh:?}: {compared}");
    }
}

/// Further away the mesh lacks of each tile what has left it, and nothing else: of a tile of standard deviation σ that has the
/// share s left, (1 − s) σ of the height over a vertex, root mean square.
#[test]
fn far_from_the_viewer_the_drawn_sea_lacks_the_waves_that_have_left_it() {
    const LEVELS: u32 = 9;
    let sea = scene().sea.build(scene().seed).unwrap();
    let tiles = scene().sea.build(scene().seed).unwrap().into_tiles().unwrap();
    let deviations: Vec<f64> = tiles.iter().map(|tile| tile.variance_m2().sqrt()).collect();
    let deviation_m = sea.variance_m2().sqrt();
    let lacking_m = |shares: &mut dyn Iterator<Item = f64>| {
        shares
            .zip(&deviations)
            .map(|(share, deviation)| ((1.0 - share) * deviation).powi(2))
            .sum::<f64>()
            .sqrt()
    };
    for mesh in meshes() {
        // For each level: vertices, squares of what they should lack, and squares and the greatest of what they lack.
        let mut levels = [(0.0, 0.0, 0.0, 0.0_f64); LEVELS as usize];
        vertices_about_viewers(mesh, 1.0, LEVELS, |technique, time_s, vertices| {
            if time_s == 0.0 {
                let uniforms = technique.uniforms(&view_from(DVec3::Y));
                for distance_m in [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0] {
                    let part = lacking_m(&mut shares(&uniforms, distance_m)) / deviation_m;
                    println!("{mesh:?} lacks {:.1} % of the height {distance_m} m away", 100.0 * part);
                }
            }
            let places: Vec<DVec2> =
                vertices.iter().map(|vertex| DVec2::new(vertex.drawn_m.x, vertex.drawn_m.z)).collect();
            for (i, (vertex, found)) in vertices.iter().zip(sea.query(&places, time_s).unwrap()).enumerate() {
                let expected_m = lacking_m(&mut vertex.shares.iter().copied());
                if expected_m < 2e-3 * deviation_m || found.jacobian < 0.3 {
                    continue;
                }
                let error_m = (found.height_m() - vertex.drawn_m.y).abs();
                let (count, expected, errors, worst) = &mut levels[i % LEVELS as usize];
                *count += 1.0;
                *expected += expected_m * expected_m;
                *errors += error_m * error_m;
                *worst = worst.max(error_m / expected_m);
            }
        });
        for (level, (count, expected, errors, worst)) in levels.into_iter().enumerate() {
            let found = f64::sqrt(errors / expected);
            println!(
                "{mesh:?}, level {level}: {count} vertices, {found:.3} of what they should lack, {worst:.1} at worst"
            );
            if count > 500.0 {
                assert!(
                    (found - 1.0).abs() < 0.1 && worst < 5.0,
                    "{mesh:?}, level {level}: {found}, {worst}"
                );
            }
        }
        let compared = levels.iter().filter(|level| level.0 > 500.0).count();
        assert!(compared >= 5 || compared == 0 && gpu().is_none(), "{mesh:?}: {compared} levels");
    }
}

/// No water is moved further sideways than the mesh's seams are searched for: not by all tiles together, at their furthest.
#[test]
fn water_stays_within_the_margin() {
    let scenes = whitecap_scene::named::ALL.iter().map(|named| whitecap_scene::open(named.name).unwrap());
    for scene in scenes.filter(|scene| matches!(scene.technique, whitecap_scene::Technique::SpectralOcean(_)))
    {
        let sea = scene.sea.build(scene.seed).unwrap();
        let height_m = whitecap_waves::statistics::significant_height_m(sea.variance_m2());
        let mut tiles = sea.into_tiles().unwrap();
        let mut fields = TileFields::default();
        for time_s in [0.0, 77.0, -1e5] {
            let furthest_m = tiles.iter_mut().map(|tile| {
                tile.evaluate(time_s, &mut fields);
                let sway = |i| {
                    let [x, _, z] = fields.displacement(i);
                    f64::from(x.hypot(z))
                };
                (0..fields.resolution().pow(2)).map(sway).fold(0.0, f64::max)
            });
            let sway = furthest_m.sum::<f64>() / height_m;
            assert!(sway < SWAY && sway > 0.5, "{sway} significant heights at {time_s} s");
        }
    }
}

/// Waves may leave the mesh, but only in the order of their lengths, and all before it turns coarse.
#[test]
fn waves_have_left_the_mesh_before_it_turns_coarse() {
    with_technique(&scene(), |_, _, technique| {
        for eye_height_m in [0.0, 1.0, 30.0, 9_000.0, -5.0] {
            let uniforms = technique.uniforms(&view_from(DVec3::new(3.0, eye_height_m, 4.0)));
            let half_width_m = f64::from(uniforms.cell_m)
                * f64::from(technique.levels - 1).exp2()
                * f64::from(technique.grid.half_cells());
            let mut longer_m = f64::INFINITY;
            for cascade in &uniforms.cascades[..technique.tiles.len()] {
                assert!(cascade.fade_start_m < cascade.fade_end_m);
                assert!(f64::from(cascade.fade_end_m) <= longer_m.min(0.95 * half_width_m));
                longer_m = f64::from(cascade.fade_end_m);
            }
        }
    });
}

/// Texel (i, j) of a normal map is drawn where sample (i, j) of the tile lies, anywhere in the world.
#[test]
fn the_maps_lie_where_the_samples_lie() {
    with_technique(&scene(), |_, _, technique| {
        for eye in [DVec3::new(0.0, 3.0, 0.0), DVec3::new(77.7, 3.0, -1.3), DVec3::new(-1e6, 3.0, 2e6)] {
            let uniforms = technique.uniforms(&view_from(eye));
            for (cascade, maps) in uniforms.cascades.iter().zip(&technique.tiles) {
                let sample = DVec2::new(eye.x, eye.z) / maps.tile_size_m() * maps.resolution() as f64;
                let n = maps.resolution() as f32;
                let texel = (Vec2::from(cascade.eye_in_tile) + cascade.half_texel) * n - 0.5;
                let off = (texel.as_dvec2() - sample) / f64::from(n);
                assert!((off - off.round()).abs().max_element() * f64::from(n) < 1e-2, "{off}");
            }
        }
    });
}

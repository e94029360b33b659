//! Meshes: what the built-in ones promise, and the ground that they make.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use glam::{DVec3, Vec3};
use whitecap_scene::mesh::{self, BUILT_IN, Ground, Island, LakeBed, Mesh, Placement};

fn make(word: &str, seed: u64) -> Mesh {
    (mesh::built_in(word).unwrap().make)(seed)
}

fn ground(mesh: &Mesh, resolution: usize) -> Ground {
    Ground::new(mesh.triangles_in_world(&Placement::default()), resolution).unwrap()
}

#[test]
fn every_built_in_mesh_is_sound_small_and_of_its_seed() {
    for built_in in BUILT_IN {
        for seed in [0, 7, u64::MAX] {
            let mesh = (built_in.make)(seed);
            mesh.validate().unwrap_or_else(|fault| panic!("{}: {fault}", built_in.word));
            let triangles = mesh.indices.len() / 3;
            assert!((500..=8000).contains(&triangles), "{}: {triangles} triangles", built_in.word);
            assert_eq!(mesh, (built_in.make)(seed), "{}", built_in.word);
        }
        assert_eq!((built_in.make)(1) == (built_in.make)(2), built_in.word == "duck", "{}", built_in.word);
        assert!(!built_in.summary.ends_with('.'));
    }
}

#[test]
fn triangles_run_counter_clockwise_from_outside() {
    for built_in in BUILT_IN {
        let mesh = (built_in.make)(7);
        for (corners, indices) in mesh.triangles().zip(mesh.indices.chunks_exact(3)) {
            let [a, b, c] = corners;
            let face = (b - a).cross(c - a);
            let normal: Vec3 = indices.iter().map(|i| Vec3::from(mesh.normals[*i as usize])).sum();
            // Slivers may be at odds with the smooth normals; there is nothing to see of them.
            let is_sliver = face.length() < 1e-3 * (b - a).length_squared().max((c - a).length_squared());
            assert!(is_sliver || face.dot(normal) > 0.0, "{}: {corners:?}", built_in.word);
        }
    }
}

/// The volume that a closed surface encloses, by the divergence theorem; positive if it faces outwards.
#[test]
fn the_duck_encloses_a_duck_and_faces_north() {
    let duck = make("duck", 0);
    let volume_m3: f32 = duck.triangles().map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum();
    assert!((0.15..0.4).contains(&volume_m3), "{volume_m3}");

    let [low, high] = duck.bounds().unwrap();
    assert!((0.9..1.1).contains(&(high.z - low.z)), "its length: {}", high.z - low.z);
    assert!(low.y < -0.1 && high.y > 0.6 && (low.x + high.x).abs() < 0.01);

    // A third of the body, whose back is at about 0.37 m, is below the water.
    let body = high.y.min(0.37) - low.y;
    assert!((0.25..0.4).contains(&(-low.y / body)), "{low}");

    // Orange is the beak: more red than green than blue, well ahead of everything else.
    let is_beak = |color: &[f32; 3]| color[0] > 0.8 && color[1] < 0.6 && color[2] < 0.3;
    let beak = || duck.positions.iter().zip(&duck.colors).filter(|(_, color)| is_beak(color));
    assert!(beak().count() > 50);
    assert!(beak().all(|(place, _)| place[2] < -0.2));
}

#[test]
fn the_island_rises_from_the_sea() {
    for seed in [0, 7, 12] {
        let island = Island::new(seed);
        let mesh = make("island", seed);
        let [low, high] = mesh.bounds().unwrap();
        assert!((8.0..10.0).contains(&high.y), "seed {seed}: {high}");
        assert!((-14.5..-11.0).contains(&low.y), "seed {seed}: {low}");
        assert!((high.x - 90.0).abs() < 0.5);

        let ground = ground(&mesh, 512);
        assert!(ground.height_m(0.0, 0.0).unwrap() > 2.0);
        for degrees in (0..360).step_by(5) {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let height_m = |radius_m: f64| island.height_m(radius_m * cos, radius_m * sin);
            assert!(height_m(28.0) > 0.0, "seed {seed}: water 28 m off the middle, {degrees}°");
            assert!(height_m(52.0) < 0.0, "seed {seed}: land 52 m off the middle, {degrees}°");
            assert!((-14.5..-9.5).contains(&height_m(89.9)), "seed {seed}: {}", height_m(89.9));
            // The mesh follows the formula.
            for radius_m in [5.0, 20.0, 40.0, 60.0] {
                let on_mesh = ground.height_m(radius_m * cos, radius_m * sin).unwrap();
                let error_m = (on_mesh - height_m(radius_m)).abs();
                assert!(error_m < 0.8, "seed {seed}: {error_m} m off at {radius_m} m, {degrees}°");
            }
        }
    }
}

#[test]
fn the_lake_lies_in_a_basin_that_closes_the_view() {
    for seed in [0, 7, 12] {
        let bed = LakeBed::new(seed);
        let mesh = make("lake-bed", seed);
        let ground = ground(&mesh, 512);
        let middle_m = ground.height_m(0.0, 0.0).unwrap();
        assert!((middle_m + 5.0).abs() < 0.5, "seed {seed}: {middle_m}");
        let mut shores_m = Vec::new();
        for degrees in (0..360).step_by(5) {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let height_m = |radius_m: f64| bed.height_m(radius_m * cos, radius_m * sin);
            let rim_m = height_m(149.9);
            assert!((6.0..15.6).contains(&rim_m), "seed {seed}: a rim of {rim_m} m, {degrees}°");
            let shore_m =
                (200..700).map(|tenth| 0.1 * f64::from(tenth)).find(|r| height_m(*r) > 0.0).unwrap();
            // Once on land, always on land: no second lake is behind the shore.
            assert!((shore_m as u32 + 1..150).all(|r| height_m(f64::from(r)) > 0.0), "{degrees}°");
            shores_m.push(shore_m);
        }
        let (least, most) = shores_m.iter().fold((f64::MAX, 0.0_f64), |(l, m), r| (l.min(*r), m.max(*r)));
        assert!(least > 30.0 && most < 53.0 && most - least > 3.0, "seed {seed}: {least} to {most}");
    }
}

#[test]
fn trees_stand_on_the_bed_of_the_same_lake() {
    let bed = LakeBed::new(7);
    let trees = make("trees", 7);
    let low_points: Vec<_> = trees.positions.iter().filter(|place| place[1] < -0.5).collect();
    assert!(!low_points.is_empty(), "no tree stands in the water");
    for [x, y, z] in trees.positions.iter().map(|place| place.map(f64::from)) {
        assert!(y > bed.height_m(x, z) - 2.5, "a tree is under the ground at {x}, {z}");
    }
}

#[test]
fn posts_stand_in_water() {
    let [low, high] = make("posts", 7).bounds().unwrap();
    assert!((-3.1..-2.5).contains(&low.y) && (1.2..1.6).contains(&high.y), "{low} {high}");
}

/// Two triangles that tile a rectangle, at a height for each place.
fn sheet([west, east]: [f64; 2], [north, south]: [f64; 2], y: impl Fn(f64, f64) -> f64) -> Vec<[DVec3; 3]> {
    let at = |x, z| DVec3::new(x, y(x, z), z);
    let [a, b, c, d] = [at(west, north), at(east, north), at(east, south), at(west, south)];
    vec![[a, d, c], [a, c, b]]
}

#[test]
fn the_height_of_a_plane_is_exact() {
    let level = Ground::new(sheet([-10.0, 30.0], [5.0, 25.0], |_, _| -3.0).into_iter(), 17).unwrap();
    assert!(level.heights_m().iter().all(|height| *height == -3.0));
    assert_eq!(level.height_m(12.345, 6.789), Some(-3.0));
    assert_eq!(level.depth_m(12.345, 6.789), Some(3.0));
    assert_eq!(level.resolution(), 17);
    assert_eq!(level.cell_m().to_array(), [2.5, 1.25]);

    let plane = |x: f64, z: f64| 1.0 + 0.25 * x - 0.5 * z;
    let slope = Ground::new(sheet([-10.0, 30.0], [5.0, 25.0], plane).into_iter(), 100).unwrap();
    for (x, z) in [(-10.0, 5.0), (30.0, 25.0), (30.0, 5.0), (-10.0, 25.0), (3.3, 7.7), (29.99, 24.99)] {
        let found = slope.height_m(x, z).unwrap();
        assert!((found - plane(x, z)).abs() < 1e-5, "{found} for {} at {x}, {z}", plane(x, z));
    }
}

#[test]
fn there_is_no_ground_outside_or_in_gaps() {
    let mut two = sheet([0.0, 10.0], [0.0, 10.0], |_, _| 1.0);
    two.extend(sheet([20.0, 30.0], [0.0, 10.0], |_, _| 2.0));
    let ground = Ground::new(two.into_iter(), 61).unwrap();
    assert_eq!(ground.height_m(5.0, 5.0), Some(1.0));
    assert_eq!(ground.height_m(25.0, 5.0), Some(2.0));
    for (x, z) in [(15.0, 5.0), (-0.01, 5.0), (30.01, 5.0), (5.0, -0.01), (5.0, 10.01), (f64::NAN, 5.0)] {
        assert_eq!(ground.height_m(x, z), None, "{x}, {z}");
    }
    assert!(ground.heights_m().contains(&Ground::NOWHERE_M));
}

#[test]
fn the_highest_surface_counts() {
    let mut layers = sheet([0.0, 10.0], [0.0, 10.0], |_, _| 4.0);
    layers.extend(sheet([0.0, 10.0], [0.0, 10.0], |_, _| -4.0));
    layers.rotate_left(1);
    let ground = Ground::new(layers.into_iter(), 9).unwrap();
    assert!(ground.heights_m().iter().all(|height| *height == 4.0));
}

#[test]
fn there_is_no_ground_without_triangles_or_with_odd_ones() {
    assert_eq!(Ground::new(std::iter::empty(), 64), None);
    let upright = [[DVec3::ZERO, DVec3::Y, DVec3::X]];
    assert_eq!(Ground::new(upright.into_iter(), 64), None);
    let odd = [[DVec3::ZERO, DVec3::Z, DVec3::new(1.0, f64::NAN, 0.0)]];
    assert_eq!(Ground::new(odd.into_iter(), 64), None);
    // The resolution is brought into its range.
    let sheet = || sheet([0.0, 1.0], [0.0, 1.0], |_, _| 1.0).into_iter();
    assert_eq!(Ground::new(sheet(), 0).unwrap().resolution(), 2);
    assert_eq!(Ground::new(sheet(), usize::MAX).unwrap().resolution(), Ground::MAX_RESOLUTION);
}

#[test]
fn ground_follows_the_placement() {
    let island = make("island", 3);
    let placement = Placement { position_m: DVec3::new(5e6, 1.0, -2e6), heading_deg: 90.0, scale: 0.5 };
    let placed = Ground::new(island.triangles_in_world(&placement), 512).unwrap();
    let formula = Island::new(3);
    // 20 m north of the island's middle, as the mesh has it, is now 10 m east.
    let height_m = placed.height_m(5e6 + 10.0, -2e6).unwrap();
    assert!((height_m - (1.0 + 0.5 * formula.height_m(0.0, -20.0))).abs() < 0.4, "{height_m}");
}

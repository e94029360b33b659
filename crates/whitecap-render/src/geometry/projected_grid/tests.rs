use super::hull::{Frustum, visible_hull};
use super::projector::{self, Projector};
use super::*;
use glam::{DQuat, Quat, camera::rh};

/// Everything that a test wants to know of a camera.
struct Camera {
    request: GridRequest,
    forward: DVec3,
}

impl Camera {
    /// `infinite` depths are reversed, the others the usual ones to 1,000 km.
    fn new(height_m: f64, turn: DQuat, fov_rad: f64, infinite: bool) -> Camera {
        let view_from_world = turn.inverse().as_quat();
        let clip_from_view = if infinite {
            rh::proj::directx::perspective_infinite_reverse(fov_rad as f32, 16.0 / 9.0, 0.1)
        } else {
            rh::proj::directx::perspective(fov_rad as f32, 16.0 / 9.0, 0.1, 1e6)
        };
        let request = GridRequest {
            clip_from_eye_world: clip_from_view * Mat4::from_quat(view_from_world),
            eye_height_m: height_m,
            slab_m: 0.8,
            far_m: 1e5,
            elevation_m: 7.0,
        };
        Camera { request, forward: turn * DVec3::NEG_Z }
    }

    fn pitched(height_m: f64, azimuth_deg: f64, pitch_deg: f64, roll_deg: f64, fov_deg: f64) -> Camera {
        let turn = DQuat::from_rotation_y(azimuth_deg.to_radians())
            * DQuat::from_rotation_x(pitch_deg.to_radians())
            * DQuat::from_rotation_z(roll_deg.to_radians());
        Camera::new(height_m, turn, fov_deg.to_radians(), true)
    }

    /// The ray through a place on the screen, −1 to 1 along both axes.
    fn ray(&self, x: f64, y: f64) -> DVec3 {
        let world_from_clip = self.request.clip_from_eye_world.as_dmat4().inverse();
        world_from_clip.project_point3(DVec3::new(x, y, 0.5)).normalize()
    }

    /// Where a ray meets a level, metres east and south of the eye, if it does so within reach.
    fn hit(&self, ray: DVec3, level_m: f64) -> Option<DVec2> {
        let t = (level_m - self.request.eye_height_m) / ray.y;
        let depth = t * ray.dot(self.forward);
        (t.is_finite() && depth > 0.1001 && depth < 0.999 * self.request.far_m)
            .then(|| DVec2::new(ray.x, ray.z) * t)
    }
}

struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn camera(&mut self, i: usize) -> Camera {
        let height_m = match i % 5 {
            0 => self.between(-50.0, -0.8),
            1 => self.between(-0.8, 0.8),
            2 => self.between(0.8, 20.0),
            3 => 10.0_f64.powf(self.between(0.0, 3.7)),
            _ => self.between(0.0, 200.0),
        };
        let fov_rad = self.between(2.0_f64.to_radians(), 150.0_f64.to_radians());
        let upright = DQuat::from_rotation_y(self.between(0.0, 6.3));
        let turn = match i % 7 {
            // Straight down and straight up, then anything.
            0 => upright * DQuat::from_rotation_x(-std::f64::consts::FRAC_PI_2),
            1 => upright * DQuat::from_rotation_x(std::f64::consts::FRAC_PI_2),
            2 => upright * DQuat::from_rotation_x(self.between(-0.05, 0.05)),
            _ => {
                upright
                    * DQuat::from_rotation_x(self.between(-1.57, 1.57))
                    * DQuat::from_rotation_z(self.between(-3.2, 3.2))
            }
        };
        Camera::new(height_m, turn, fov_rad, !i.is_multiple_of(3))
    }
}

/// What the technique promises: through every point of the screen where there is water, the grid is there, whether
/// the water rests there or was displaced to it from below or above.
#[test]
fn all_visible_water_is_covered_for_ten_thousand_cameras() {
    let mut random = Random(7);
    let (mut covered, mut dry) = (0, 0);
    for i in 0..10_000 {
        let camera = random.camera(i);
        let grid = ProjectedGrid::new(&camera.request);
        for _ in 0..50 {
            let ray = camera.ray(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            let slab_m = camera.request.slab_m;
            for level_m in [0.0, random.between(-slab_m, slab_m), slab_m, -slab_m] {
                let Some(water) = camera.hit(ray, level_m) else {
                    dry += 1;
                    continue;
                };
                let grid = grid.as_ref().unwrap_or_else(|| panic!("camera {i} sees water and gets no grid"));
                let place =
                    grid.place_of(water).unwrap_or_else(|| panic!("camera {i}: behind the projector"));
                let low = place.min_element().min(1.0 - place.max_element());
                assert!(low > -1e-6, "camera {i}: water at {water} lies at {place} of the grid");
                covered += 1;
            }
        }
    }
    assert!(covered > 500_000 && dry > 200_000, "{covered} points of water, {dry} of none");
}

/// Homogeneous interpolation between four corners is the same as cutting every line with the level.
#[test]
fn vertices_equal_direct_intersections() {
    let mut random = Random(11);
    let mut worst = 0.0_f64;
    for i in 0..2_000 {
        let camera = random.camera(i);
        let Some(grid) = ProjectedGrid::new(&camera.request) else { continue };
        let Projector { height_m, right, up, forward } = grid.projector;
        for (across, down) in [(0, 0), (64, 128), (64, 0), (0, 128), (13, 64), (40, 127), (1, 3)] {
            let (u, v) = (f64::from(across) / 64.0, f64::from(down) / 128.0);
            let at = grid.range.min + grid.range.size * DVec2::new(u, v);
            let line = forward + at.x * right + at.y * up;
            let direct = DVec2::new(line.x, line.z) * (-height_m / line.y);
            worst = worst.max(grid.point(u, v).distance(direct) / direct.length().max(height_m));
        }
    }
    assert!(worst < 1e-4, "vertices are off by {worst} of their distance");
}

/// The range brings any projection to the same grid: with the camera's own projection, as in the text, the corners
/// are the same points.
#[test]
fn the_projectors_lens_does_not_matter() {
    let camera = Camera::pitched(4.0, 30.0, -12.0, 5.0, 45.0);
    let grid = ProjectedGrid::new(&camera.request).unwrap();
    let frustum = Frustum::new(&camera.request).unwrap();
    let hull = visible_hull(&frustum, camera.request.slab_m);
    let p = grid.projector;
    let world_from_view =
        DMat4::from_cols(p.right.extend(0.0), p.up.extend(0.0), (-p.forward).extend(0.0), DVec4::W);
    let view_from_sea = world_from_view.transpose() * DMat4::from_translation(DVec3::NEG_Y * p.height_m);
    let clip_from_view =
        glam::camera::rh::proj::directx::perspective(45.0_f32.to_radians(), 16.0 / 9.0, 0.1, 1e4);
    let clip_from_sea = clip_from_view.as_dmat4() * view_from_sea;
    let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for point in &hull {
        let seen = clip_from_sea.project_point3(*point);
        let seen = DVec2::new(seen.x, seen.y);
        (min, max) = (min.min(seen), max.max(seen));
    }
    let range = Range { min, size: max - min };
    let world_from_grid = clip_from_sea.inverse() * range.matrix();
    for (i, (u, v)) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].into_iter().enumerate() {
        let (seen, own) = (corner_on_level(&world_from_grid, u, v), grid.corners()[i]);
        let (seen, own) = (seen / seen.w, own / own.w);
        assert!(seen.distance(own) < 1e-6 * own.length(), "{seen} for {own}");
    }
}

#[test]
fn no_water_in_view_is_no_grid() {
    for (height_m, pitch_deg) in [(10.0, 40.0), (2.0, 30.0), (3_000.0, 23.0), (-20.0, -40.0)] {
        let camera = Camera::pitched(height_m, 20.0, pitch_deg, 0.0, 45.0);
        assert!(ProjectedGrid::new(&camera.request).is_none(), "at {height_m} m, {pitch_deg} degrees up");
        let turned = Camera::pitched(height_m, 20.0, -pitch_deg, 0.0, 45.0);
        assert!(ProjectedGrid::new(&turned.request).is_some());
    }
}

/// The text's placement: as high as the camera, but never lower than the elevation, and mirrored from under water.
#[test]
fn the_projector_keeps_over_the_water() {
    let height = |eye_height_m: f64| {
        let mut request = Camera::pitched(1.0, 0.0, -10.0, 0.0, 45.0).request;
        request.eye_height_m = eye_height_m;
        projector::height_m(&request)
    };
    assert_eq!(height(100.0), 100.0);
    for eye_height_m in [-0.7, 0.0, 3.0, 6.9] {
        assert!((height(eye_height_m) - 7.0).abs() < 1e-12, "{eye_height_m}");
    }
    // Under water: over S_lower by so much that the mirrored height and the elevation add up.
    assert!((height(-20.0) - (7.0 + 20.0 - 0.8)).abs() < 1e-12);
}

/// The aim of the text for a plain camera: a blend of where it looks and of a place 10 m ahead.
#[test]
fn the_projector_aims_as_the_text_says() {
    let camera = Camera::pitched(20.0, 0.0, -30.0, 0.0, 40.0);
    let frustum = Frustum::new(&camera.request).unwrap();
    let projector = Projector::new(&camera.request, &frustum, &visible_hull(&frustum, 0.8));
    let aim1_m = 20.0 / 30.0_f64.to_radians().tan();
    let aim2_m = 10.0 * 30.0_f64.to_radians().cos();
    let aim_m = 0.5 * aim1_m + 0.5 * aim2_m;
    let expected = DVec3::new(0.0, -20.0, -aim_m).normalize();
    assert!(projector.forward.distance(expected) < 1e-6, "{}", projector.forward);
    // Looking as steeply up, it aims at the same place.
    let up = Camera::pitched(20.0, 0.0, 30.0, 0.0, 100.0);
    let frustum = Frustum::new(&up.request).unwrap();
    let mirrored = Projector::new(&up.request, &frustum, &visible_hull(&frustum, 0.8));
    assert!(mirrored.forward.distance(expected) < 1e-6, "{}", mirrored.forward);
}

/// A grid is laid out by what is seen, not by where in the world it is: the eye's place never enters.
#[test]
fn cells_are_small_near_the_viewer() {
    let camera = Camera::pitched(4.0, 0.0, -10.0, 0.0, 45.0);
    let grid = ProjectedGrid::new(&camera.request).unwrap();
    let near = grid.point(0.5, 1.0 / 128.0).distance(grid.point(0.5, 0.0));
    let far = grid.point(0.5, 1.0).distance(grid.point(0.5, 127.0 / 128.0));
    assert!(near < 0.3 && far > 1e4, "{near} and {far}");
    assert!(grid.point(0.5, 0.0).y > grid.point(0.5, 1.0).y, "v = 0 is near, and north is ahead");
    assert!(grid.point(0.0, 0.5).x < grid.point(1.0, 0.5).x, "u runs to the right");
}

#[test]
fn matrices_of_no_view_are_refused() {
    let mut request = Camera::pitched(4.0, 0.0, -10.0, 0.0, 45.0).request;
    for broken in [Mat4::ZERO, Mat4::NAN, Mat4::from_quat(Quat::NAN)] {
        request.clip_from_eye_world = broken;
        assert!(ProjectedGrid::new(&request).is_none());
    }
}

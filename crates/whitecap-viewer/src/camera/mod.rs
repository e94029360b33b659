//! Ways to move through a scene.
//!
//! A [`Rig`] holds an eye in f64 and which way it looks. It flies freely, or goes round a place. What it shows is a scene's
//! [`Camera`], so that a view can be saved and rendered.

use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;
use whitecap_scene::Camera;

/// The eye looks up and down to within this of the vertical, rad.
const UPRIGHT_RAD: f64 = 0.01;

/// Metres a second for each metre above the water, and at least.
const SPEED_PER_HEIGHT: f64 = 1.0;
const LEAST_SPEED_MPS: f64 = 4.0;

/// The furthest that what is looked at is taken to be.
const FURTHEST_M: f64 = 1e5;

/// Where the eye may be: what scene files accept, metres, less the way to what it looks at.
const FAR_M: f64 = 1e7 - FURTHEST_M;
const HIGHEST_M: f64 = 1e5;
const LOWEST_M: f64 = -100.0;

/// How the eye moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Where it looks.
    Fly,
    /// Round what it looks at.
    Orbit,
}

/// An eye that somebody moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rig {
    eye_m: DVec3,
    /// Bearing from north, clockwise from above, and elevation.
    azimuth_rad: f64,
    elevation_rad: f64,
    /// To what it looks at.
    distance_m: f64,
    vertical_fov_deg: f64,
    mode: Mode,
}

impl Rig {
    /// Where a scene is seen from.
    pub fn of(camera: &Camera) -> Rig {
        let eye_m = DVec3::from(camera.position_m);
        let ahead = DVec3::from(camera.look_at_m) - eye_m;
        let distance_m = ahead.length();
        let limit = FRAC_PI_2 - UPRIGHT_RAD;
        Rig {
            eye_m,
            azimuth_rad: ahead.x.atan2(-ahead.z),
            elevation_rad: (ahead.y / distance_m).clamp(-1.0, 1.0).asin().clamp(-limit, limit),
            distance_m: distance_m.min(FURTHEST_M),
            vertical_fov_deg: camera.vertical_fov_deg,
            mode: Mode::Fly,
        }
    }

    /// What it shows, as a scene file says it.
    pub fn camera(&self) -> Camera {
        Camera {
            position_m: self.eye_m.to_array(),
            look_at_m: (self.eye_m + self.distance_m * self.ahead()).to_array(),
            vertical_fov_deg: self.vertical_fov_deg,
        }
    }

    /// How it moves.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The other way to move, from where it is.
    pub fn change_mode(&mut self) {
        self.mode = match self.mode {
            Mode::Fly => Mode::Orbit,
            Mode::Orbit => Mode::Fly,
        };
        // What it goes round lies on the water where it looks down, and not beyond sight.
        if self.mode == Mode::Orbit {
            let down = -self.ahead().y;
            let to_water_m = if down > 0.01 { self.eye_m.y.max(1.0) / down } else { 100.0 };
            self.distance_m = to_water_m.clamp(1.0, 1000.0);
        }
    }

    fn ahead(&self) -> DVec3 {
        let (sine, cosine) = self.elevation_rad.sin_cos();
        DVec3::new(self.azimuth_rad.sin() * cosine, sine, -self.azimuth_rad.cos() * cosine)
    }

    /// Turns by angles, rad: to the right and up. In orbit the eye goes round instead.
    pub fn turn(&mut self, right_rad: f64, up_rad: f64) {
        let middle_m = self.eye_m + self.distance_m * self.ahead();
        self.azimuth_rad = (self.azimuth_rad + right_rad).rem_euclid(std::f64::consts::TAU);
        let limit = FRAC_PI_2 - UPRIGHT_RAD;
        self.elevation_rad = (self.elevation_rad + up_rad).clamp(-limit, limit);
        if self.mode == Mode::Orbit {
            self.go_to(middle_m - self.distance_m * self.ahead());
        }
    }

    /// Moves for `seconds`: `right`, `up` and `forward` from −1 to 1, `haste` times as fast as is usual at this height.
    pub fn go(&mut self, right: f64, up: f64, forward: f64, haste: f64, seconds: f64) {
        let speed_mps = haste * (SPEED_PER_HEIGHT * self.eye_m.y.abs()).max(LEAST_SPEED_MPS);
        let way_m = speed_mps * seconds;
        let ahead = self.ahead();
        let aside = DVec2::new(self.azimuth_rad.cos(), self.azimuth_rad.sin());
        match self.mode {
            Mode::Fly => {
                let aside = DVec3::new(aside.x, 0.0, aside.y);
                self.go_to(self.eye_m + way_m * (right * aside + up * DVec3::Y + forward * ahead));
            }
            Mode::Orbit => {
                self.zoom(-forward * seconds * haste);
                self.turn(-right * seconds * haste.min(4.0), -up * seconds * haste.min(4.0));
            }
        }
    }

    /// Goes away from what it looks at by a factor e^`by`; in flight the angle of view widens so.
    pub fn zoom(&mut self, by: f64) {
        match self.mode {
            Mode::Fly => self.vertical_fov_deg = (self.vertical_fov_deg * by.exp()).clamp(1.0, 120.0),
            Mode::Orbit => {
                let middle_m = self.eye_m + self.distance_m * self.ahead();
                self.distance_m = (self.distance_m * by.exp()).clamp(1.0, FURTHEST_M);
                self.go_to(middle_m - self.distance_m * self.ahead());
            }
        }
    }

    fn go_to(&mut self, eye_m: DVec3) {
        let bound = DVec3::new(FAR_M, HIGHEST_M, FAR_M);
        self.eye_m = eye_m.clamp(DVec3::new(-FAR_M, LOWEST_M, -FAR_M), bound);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Camera =
        Camera { position_m: [3.0, 5.0, -2.0], look_at_m: [103.0, -20.0, 40.0], vertical_fov_deg: 45.0 };

    #[test]
    fn a_rig_shows_what_the_scene_does() {
        let camera = Rig::of(&CAMERA).camera();
        assert_eq!(camera.position_m, CAMERA.position_m);
        assert!(DVec3::from(camera.look_at_m).distance(CAMERA.look_at_m.into()) < 1e-9);
    }

    #[test]
    fn forward_is_ahead_and_right_is_right() {
        let mut rig = Rig::of(&Camera { look_at_m: [3.0, 5.0, -102.0], ..CAMERA });
        rig.go(0.0, 0.0, 1.0, 1.0, 1.0);
        assert!(rig.eye_m.z < -2.0 && (rig.eye_m.x - 3.0).abs() < 1e-9, "north is ahead: {}", rig.eye_m);
        rig.go(1.0, 0.0, 0.0, 1.0, 1.0);
        assert!(rig.eye_m.x > 3.5, "east is on the right: {}", rig.eye_m);
        let ahead = rig.ahead();
        rig.turn(0.3, 0.2);
        assert!(rig.ahead().x > ahead.x && rig.ahead().y > ahead.y, "right and up");
    }

    #[test]
    fn orbits_keep_their_distance_and_their_middle() {
        let mut rig = Rig::of(&CAMERA);
        rig.change_mode();
        let middle = rig.eye_m + rig.distance_m * rig.ahead();
        for i in 0..50 {
            rig.turn(0.2, 0.05 * f64::from(i % 5 - 2));
            let now = rig.eye_m + rig.distance_m * rig.ahead();
            assert!(now.distance(middle) < 1e-6);
        }
    }

    #[test]
    fn the_eye_stays_where_scenes_may_be_seen_from() {
        let mut rig = Rig::of(&CAMERA);
        for _ in 0..100 {
            rig.go(0.0, 1.0, 1.0, 1e6, 1.0);
            rig.turn(0.4, 3.0);
        }
        let scene = whitecap_scene::open("spectral-ocean").unwrap();
        whitecap_scene::Scene { camera: rig.camera(), ..scene }.to_toml().unwrap();
    }
}

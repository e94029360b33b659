//! Finds the sun in a panorama.

use super::{LUMINANCE, SUN_RADIUS_RAD, SunLight};
use glam::{DQuat, DVec3, Vec3};
use std::f64::consts::{PI, TAU};
use whitecap_scene::panorama::Panorama;

/// The sun is at least so many times as bright as the sky around it. Bright clouds are ten times as bright, a sun that a
/// camera could not take in a few hundred times.
const LEAST_PEAK: f32 = 50.0;

/// What around the brightest pixel is above so many times the surroundings is the sun's, blurred by the lens. The map keeps
/// it up to there, so that no hole is left.
const GLARE: f32 = 8.0;

/// Surroundings are seen at this angle from the peak, and the glare reaches no further than the other, radians.
const SURROUNDINGS_RAD: f64 = 0.14;
const REACH_RAD: f64 = 0.087;

/// The sun of a panorama, in the panorama's own axes.
pub(super) struct PanoramaSun {
    brightest: DVec3,
    /// Luminance that the map keeps near it.
    limit: f32,
    toward: DVec3,
    illuminance: Vec3,
}

impl PanoramaSun {
    /// `None` where nothing above the horizon is bright enough.
    pub(super) fn find(panorama: &Panorama) -> Option<PanoramaSun> {
        let above = &panorama.pixels[..panorama.width * panorama.height.div_ceil(2)];
        let luminance = |pixel: &[f32; 3]| Vec3::from(*pixel).dot(LUMINANCE);
        let (at, peak) = above
            .iter()
            .map(luminance)
            .enumerate()
            .fold((0, 0.0), |best, here| if here.1 > best.1 { here } else { best });
        let brightest = direction_of(panorama, at);
        let limit = GLARE * surroundings(panorama, brightest);
        if peak <= limit / GLARE * LEAST_PEAK {
            return None;
        }
        let mut sun = PanoramaSun { brightest, limit, toward: DVec3::ZERO, illuminance: Vec3::ZERO };
        let [from, to] = [-1.0, 1.0].map(|side| {
            let row = (at / panorama.width) as f64 + side * (REACH_RAD / PI * panorama.height as f64 + 1.0);
            (row.max(0.0) as usize).min(panorama.height)
        });
        for i in from * panorama.width..to * panorama.width {
            let direction = direction_of(panorama, i);
            // Under the horizon the water's reflection of it begins.
            if !sun.is_near(direction) || direction.y < -f64::from(SUN_RADIUS_RAD) {
                continue;
            }
            let solid_angle =
                TAU / panorama.width as f64 * PI / panorama.height as f64 * direction.x.hypot(direction.z);
            let pixel = Vec3::from(panorama.pixels[i]);
            let taken = (pixel - sun.kept(pixel)) * solid_angle as f32;
            sun.illuminance += taken;
            sun.toward += direction * f64::from(taken.dot(LUMINANCE));
        }
        sun.toward = sun.toward.try_normalize()?;
        Some(sun)
    }

    /// What the map shows of `radiance` in a direction, both as the panorama has them.
    pub(super) fn without(&self, direction: DVec3, radiance: Vec3) -> Vec3 {
        if self.is_near(direction) { self.kept(radiance) } else { radiance }
    }

    /// The light, once the panorama has been turned to the world's axes.
    pub(super) fn light(&self, world_from_panorama: DQuat) -> SunLight {
        SunLight {
            toward: (world_from_panorama * self.toward).as_vec3(),
            illuminance_klx: self.illuminance,
            radius_rad: SUN_RADIUS_RAD,
        }
    }

    fn is_near(&self, direction: DVec3) -> bool {
        direction.distance_squared(self.brightest) < REACH_RAD * REACH_RAD
    }

    fn kept(&self, radiance: Vec3) -> Vec3 {
        let luminance = radiance.dot(LUMINANCE);
        if luminance > self.limit { radiance * (self.limit / luminance) } else { radiance }
    }
}

/// Median luminance of a ring around a direction.
fn surroundings(panorama: &Panorama, direction: DVec3) -> f32 {
    let across = direction.any_orthonormal_vector();
    let mut ring: Vec<f32> = (0..72)
        .map(|i| {
            let turned = DQuat::from_axis_angle(direction, TAU * f64::from(i) / 72.0) * across;
            let seen = panorama.sample(direction * SURROUNDINGS_RAD.cos() + turned * SURROUNDINGS_RAD.sin());
            Vec3::from(seen).dot(LUMINANCE)
        })
        .collect();
    ring.sort_by(f32::total_cmp);
    ring[ring.len() / 2]
}

/// Unit vector of a pixel's middle, as [`Panorama::sample`] has them.
fn direction_of(panorama: &Panorama, index: usize) -> DVec3 {
    let (column, row) = ((index % panorama.width) as f64 + 0.5, (index / panorama.width) as f64 + 0.5);
    let azimuth = (column / panorama.width as f64 - 0.5) * TAU;
    let (sin, cos) = (row / panorama.height as f64 * PI).sin_cos();
    DVec3::new(azimuth.sin() * sin, cos, -azimuth.cos() * sin)
}

/// A sky of radiance `sky` with a disc of the sun's size, its edge smoothed over the pixels that it cuts.
#[cfg(test)]
pub(super) fn with_disc(toward: DVec3, sky: f32, disc: f32) -> Panorama {
    let (width, height) = (1024, 512);
    let mut panorama = Panorama { width, height, pixels: vec![[sky; 3]; width * height], repaired: 0 };
    for i in 0..width * height {
        if direction_of(&panorama, i).distance(toward) > 0.03 {
            continue;
        }
        let inside = (0..400).filter(|s| {
            let (column, row) = ((i % width) as f64, (i / width) as f64);
            let azimuth = ((column + f64::from(s % 20) / 20.0 + 0.025) / width as f64 - 0.5) * TAU;
            let (sin, cos) = ((row + f64::from(s / 20) / 20.0 + 0.025) / height as f64 * PI).sin_cos();
            DVec3::new(azimuth.sin() * sin, cos, -azimuth.cos() * sin).distance(toward)
                < f64::from(SUN_RADIUS_RAD)
        });
        let share = inside.count() as f32 / 400.0;
        panorama.pixels[i] = [sky + share * disc, sky + share * 0.8 * disc, sky + share * 0.5 * disc];
    }
    panorama
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sun_is_found_where_it_is_with_its_energy() {
        for (azimuth, elevation) in [(0.3_f64, 0.4_f64), (3.1, 0.02), (-2.0, 1.3), (1.0, 1.45)] {
            let toward = DVec3::new(
                azimuth.sin() * elevation.cos(),
                elevation.sin(),
                -azimuth.cos() * elevation.cos(),
            );
            let sun = PanoramaSun::find(&with_disc(toward, 2.0, 5e4)).unwrap().light(DQuat::IDENTITY);
            let off_deg = sun.toward.as_dvec3().distance(toward).to_degrees();
            assert!(off_deg < 0.2, "{off_deg}° off at {elevation}");
            let whole = 5e4 * PI as f32 * SUN_RADIUS_RAD * SUN_RADIUS_RAD;
            let error = (sun.illuminance_klx / (whole * Vec3::new(1.0, 0.8, 0.5)) - 1.0).abs();
            assert!(error.max_element() < 0.02, "{error} at {elevation}");
        }
    }

    #[test]
    fn what_is_merely_bright_is_no_sun() {
        assert!(PanoramaSun::find(&with_disc(DVec3::new(0.6, 0.8, 0.0), 2.0, 40.0)).is_none());
        assert!(PanoramaSun::find(&with_disc(DVec3::new(0.6, 0.8, 0.0), 0.0, 0.0)).is_none());
        // Nor is a lamp on the ground.
        assert!(PanoramaSun::find(&with_disc(DVec3::new(0.6, -0.8, 0.0), 2.0, 5e4)).is_none());
    }

    #[test]
    fn the_map_keeps_the_sky_and_loses_the_disc() {
        let toward = DVec3::new(0.6, 0.8, 0.0);
        let panorama = with_disc(toward, 2.0, 5e4);
        let sun = PanoramaSun::find(&panorama).unwrap();
        let seen = |d: DVec3| sun.without(d, Vec3::from(panorama.sample(d)));
        assert!(seen(toward).dot(LUMINANCE) < 1.001 * GLARE * 2.0);
        assert_eq!(seen(DVec3::new(-0.6, 0.8, 0.0)), Vec3::splat(2.0));
    }
}

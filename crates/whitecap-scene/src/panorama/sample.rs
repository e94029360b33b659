//! What a panorama shows in a direction.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::Panorama;

impl Panorama {
    /// The radiance seen in `direction` (x east, y up, z south; of any length but zero).
    ///
    /// It is interpolated between the four nearest pixels. The left and right edges join; above the middle of
    /// the first row and below that of the last the picture does not change.
    pub fn sample(&self, direction: DVec3) -> [f32; 3] {
        let u = 0.5 + direction.x.atan2(-direction.z) / TAU;
        // acos(y) of the unit direction, but exact near the poles.
        let v = direction.x.hypot(direction.z).atan2(direction.y) / PI;

        let (left, right_part) = split(u * self.width as f64 - 0.5);
        let (upper, lower_part) = split(v * self.height as f64 - 0.5);
        let column = |x: i64| x.rem_euclid(self.width as i64) as usize;
        let row = |y: i64| y.clamp(0, self.height as i64 - 1) as usize;
        let pixel = |x, y| self.pixels[row(y) * self.width + column(x)];

        let between = |a: [f32; 3], b: [f32; 3], part: f32| -> [f32; 3] {
            std::array::from_fn(|channel| a[channel] + (b[channel] - a[channel]) * part)
        };
        between(
            between(pixel(left, upper), pixel(left + 1, upper), right_part),
            between(pixel(left, upper + 1), pixel(left + 1, upper + 1), right_part),
            lower_part,
        )
    }
}

/// The pixel below a coordinate, and how far the coordinate is on the way to the next.
fn split(coordinate: f64) -> (i64, f32) {
    let floor = coordinate.floor();
    (floor as i64, (coordinate - floor) as f32)
}

//! One point of the sea, summed directly in f64.
//!
//! Symbols as in the [module above](super). The cost is that of all N²/2 waves, some milliseconds at 512².

use super::lattice::{Waves, signed};
use crate::model::SurfacePoint;
use crate::turns::cos_sin_exact;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The same sums as the transform's, from the same amplitudes, at any place.
pub(super) fn sample(waves: &Waves, rest_m: DVec2, time_s: f64) -> SurfacePoint {
    let n = waves.n;
    let spacing = TAU / waves.tile_size_m;
    // In tiles: whole turns of every wave drop out exactly.
    let place = rest_m / waves.tile_size_m;
    let place = place - place.floor();

    let mut height = 0.0;
    let mut slope = DVec2::ZERO;
    let mut shift = DVec2::ZERO;
    let (mut gxx, mut gxz, mut gzz) = (0.0, 0.0, 0.0);
    for p in 0..n / 2 {
        let [p_re, p_im, q_re, q_im] = waves.amplitudes(p);
        // A wave and its mirror image at (−p, −q) are conjugate: their sum is twice the real part. Column 0
        // holds both.
        let images = if p == 0 { 1.0 } else { 2.0 };
        for q in 0..n {
            if p_re[q] == 0.0 && p_im[q] == 0.0 && q_re[q] == 0.0 && q_im[q] == 0.0 {
                continue;
            }
            let lattice = DVec2::new(p as f64, f64::from(signed(n, q)));
            let k = spacing * lattice;
            let lean = waves.choppiness / k.length();

            let (cos_t, sin_t) = cos_sin_exact(waves.turns_per_s(p)[lattice.y.abs() as usize] * time_s);
            let h_re = cos_t * f64::from(p_re[q]) + sin_t * f64::from(q_re[q]);
            let h_im = cos_t * f64::from(p_im[q]) + sin_t * f64::from(q_im[q]);
            let (cos_x, sin_x) = cos_sin_exact(lattice.dot(place));
            // h e^{ik·x}, with its image. A factor i turns the real part into minus the imaginary one.
            let re = images * (h_re * cos_x - h_im * sin_x);
            let im = images * (h_re * sin_x + h_im * cos_x);

            height += re;
            slope -= k * im;
            shift -= k * (lean * im);
            gxx -= k.x * k.x * lean * re;
            gxz -= k.x * k.y * lean * re;
            gzz -= k.y * k.y * lean * re;
        }
    }
    let tangent_x = DVec3::new(1.0 + gxx, slope.x, gxz);
    let tangent_z = DVec3::new(gxz, slope.y, 1.0 + gzz);
    let normal = tangent_z.cross(tangent_x);
    SurfacePoint {
        displacement_m: DVec3::new(shift.x, height, shift.y),
        jacobian: normal.y,
        normal: normal.try_normalize().unwrap_or(DVec3::Y),
        slope,
    }
}

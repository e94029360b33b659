//! One point of a tile, summed directly in f64.
//!
//! Symbols as in the [module above](super). The cost is that of all N²/2 waves, some milliseconds at 512².

use super::SpectralTileParameters;
use super::lattice::{Waves, signed};
use crate::model::SurfacePoint;
use crate::turns::cos_sin_exact;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// What the waves of a tile do at one point: the sums that tiles add up before a surface is made of them.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    pub(crate) height: f64,
    pub(crate) shift: DVec2,
    pub(crate) slope: DVec2,
    /// ∂Dx/∂x, ∂Dx/∂z, ∂Dz/∂z, with choppiness.
    pub(crate) gradient: [f64; 3],
    /// Of the water, without the current.
    pub(crate) velocity: DVec3,
}

impl Sums {
    /// Adds the shape of a wave `k` whose height is the real part `re` of a number with the imaginary part `im`: the
    /// wave a quarter of its length on. `lean` is its reach along over its height, for each rad/m.
    pub(crate) fn add_shape(&mut self, k: DVec2, lean: f64, re: f64, im: f64) {
        self.height += re;
        self.slope -= k * im;
        self.shift -= k * (lean * im);
        self.gradient[0] -= k.x * k.x * lean * re;
        self.gradient[1] -= k.x * k.y * lean * re;
        self.gradient[2] -= k.y * k.y * lean * re;
    }

    /// The surface that they make, on a current in m/s.
    pub(crate) fn surface(&self, current_mps: DVec2) -> SurfacePoint {
        let [gxx, gxz, gzz] = self.gradient;
        let tangent_x = DVec3::new(1.0 + gxx, self.slope.x, gxz);
        let tangent_z = DVec3::new(gxz, self.slope.y, 1.0 + gzz);
        let normal = tangent_z.cross(tangent_x);
        SurfacePoint {
            displacement_m: DVec3::new(self.shift.x, self.height, self.shift.y),
            jacobian: normal.y,
            normal: normal.try_normalize().unwrap_or(DVec3::Y),
            slope: self.slope,
            velocity_mps: self.velocity + DVec3::new(current_mps.x, 0.0, current_mps.y),
        }
    }
}

impl std::ops::AddAssign for Sums {
    fn add_assign(&mut self, other: Self) {
        self.height += other.height;
        self.shift += other.shift;
        self.slope += other.slope;
        for (sum, other) in self.gradient.iter_mut().zip(other.gradient) {
            *sum += other;
        }
        self.velocity += other.velocity;
    }
}

/// The same sums as the transform's, from the same amplitudes, at any place; the velocity at `depth_m` below the
/// calm surface.
pub(super) fn sums(
    waves: &Waves,
    parameters: &SpectralTileParameters,
    rest_m: DVec2,
    depth_m: f64,
    time_s: f64,
) -> Sums {
    let n = waves.n;
    let spacing = TAU / waves.tile_size_m;
    // In tiles: whole turns of every wave drop out exactly.
    let place = rest_m / waves.tile_size_m;
    let place = place - place.floor();
    // e^{ik·x} is a product of one factor for p and one for q.
    let along_z: Vec<_> = (0..n).map(|q| cos_sin_exact(f64::from(signed(n, q)) * place.y)).collect();

    let mut sums = Sums::default();
    for p in 0..=waves.reach.min(n / 2 - 1) {
        let [p_re, p_im, q_re, q_im] = waves.amplitudes(p);
        let (turns_per_s, drift) = (waves.turns_per_s(p), waves.drift_turns_per_s(p));
        let (cos_p, sin_p) = cos_sin_exact(p as f64 * place.x);
        // A wave and its mirror image at (−p, −q) are conjugate: their sum is twice the real part. Column 0
        // holds both.
        let images = if p == 0 { 1.0 } else { 2.0 };
        for q in 0..n {
            if p_re[q] == 0.0 && p_im[q] == 0.0 && q_re[q] == 0.0 && q_im[q] == 0.0 {
                continue;
            }
            let lattice = DVec2::new(p as f64, f64::from(signed(n, q)));
            let k = spacing * lattice;
            let length = k.length();
            let turns_per_s = turns_per_s[lattice.y.abs() as usize];
            let lean = parameters.choppiness * parameters.water.dispersion.orbit_ratio(length) / length;

            let (cos_t, sin_t) = cos_sin_exact(turns_per_s * time_s);
            // The current turns all of it back by δt.
            let (cos_q, sin_q) = along_z[q];
            let (mut cos_x, mut sin_x) = (cos_p * cos_q - sin_p * sin_q, sin_p * cos_q + cos_p * sin_q);
            if let Some(drift) = drift {
                let (cos_d, sin_d) = cos_sin_exact(drift[q] * time_s);
                (cos_x, sin_x) = (cos_x * cos_d + sin_x * sin_d, sin_x * cos_d - cos_x * sin_d);
            }
            // h e^{ik·x}, with its image. A factor i turns the real part into minus the imaginary one.
            let wave = |cos: f64, sin: f64| {
                let re = cos * f64::from(p_re[q]) + sin * f64::from(q_re[q]);
                let im = cos * f64::from(p_im[q]) + sin * f64::from(q_im[q]);
                (images * (re * cos_x - im * sin_x), images * (re * sin_x + im * cos_x))
            };
            let (re, im) = wave(cos_t, sin_t);
            // ∂h/∂t is ω times h a quarter turn later.
            let (rate_re, rate_im) = wave(-sin_t, cos_t);
            let omega = TAU * turns_per_s;
            let (along, up) = parameters.water.dispersion.orbits_below(length, depth_m);

            sums.add_shape(k, lean, re, im);
            let horizontal = -k / length * (along * omega * rate_im);
            sums.velocity += DVec3::new(horizontal.x, up * omega * rate_re, horizontal.y);
        }
    }
    sums
}

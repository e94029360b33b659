//! How energy is spread over directions, from what a buoy can measure of it: four numbers for each frequency.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | θ | direction of travel, radians from east towards south |
//! | D(θ) | share of the energy for each radian, ∫ D dθ = 1 |
//! | c₁, c₂ | ∫ D e^{iθ} dθ and ∫ D e^{2iθ} dθ |
//! | r₁, θ₁ | size and angle of c₁ |
//! | r₂, θ₂ | size of c₂, and half its angle |
//! | φ₁, φ₂ | coefficients of the autoregressive process whose spectrum D is |
//!
//! Of all D with the same c₁ and c₂ the maximum-entropy method (Lygre and Krogstad, 1986, *J. Phys.
//! Oceanogr.* 16, 2052–2060) takes the one that assumes least; Longuet-Higgins's (1963, in *Ocean Wave
//! Spectra*) smooths the first three terms of the Fourier series until nothing is negative.

use std::f64::consts::{PI, TAU};

/// What is known of the directions of waves of one frequency: the first two Fourier coefficients of D.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirectionalMoments {
    /// r₁, 0..=1: 1 if all waves run one way, 0 if as many run either way.
    pub r1: f64,
    /// θ₁, the mean direction that the waves travel towards, radians from east towards south.
    pub mean_toward_rad: f64,
    /// r₂, 0..=1.
    pub r2: f64,
    /// θ₂, the principal direction in radians from east towards south; with θ₂ + π it means the same.
    pub principal_toward_rad: f64,
}

/// How D is made from its moments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DirectionMethod {
    /// Maximum entropy (Lygre and Krogstad, 1986): has exactly the moments given. Peaks may be sharp, and a
    /// broad distribution may come out as two peaks.
    #[default]
    MaximumEntropy,
    /// The weighted Fourier sum (Longuet-Higgins, Cartwright and Smith, 1963): keeps the directions and gives
    /// ⅔ r₁ and ⅙ r₂, which is too broad: never less than 47° of directional spread.
    LonguetHiggins,
}

impl DirectionalMoments {
    /// The largest r₁ that maximum entropy follows: a spread of 11°, as narrow as swell gets.
    pub const LARGEST_R1: f64 = 0.98;

    /// The largest |φ₂| = |c₂ − c₁²|/(1 − r₁²) that maximum entropy follows. 1 is two infinitely narrow
    /// beams, and more than 1 is no distribution at all.
    pub const LARGEST_PHI2: f64 = 0.95;

    /// The moments of D ∝ cos^{2s}((θ − θ₁)/2): r₁ = s/(s+1), r₂ = s(s−1)/((s+1)(s+2)), for `s` ≥ 0
    /// (Longuet-Higgins, Cartwright and Smith, 1963).
    pub fn of_cos2s(s: f64, mean_toward_rad: f64) -> Self {
        let r2 = s * (s - 1.0) / ((s + 1.0) * (s + 2.0));
        // Below s = 1 the second moment lies across the mean direction.
        let across = if r2 < 0.0 { PI / 2.0 } else { 0.0 };
        Self {
            r1: s / (s + 1.0),
            mean_toward_rad,
            r2: r2.abs(),
            principal_toward_rad: mean_toward_rad + across,
        }
    }

    /// How far c₂ lies outside of the disc |c₂ − c₁²| ≤ 1 − r₁² that every distribution without negative values keeps it in
    /// (Lygre and Krogstad, 1986: the moments' Toeplitz matrix is positive, |φ₂| ≤ 1); 0 inside. Where r₁ is more than 1, which
    /// none has, or something is not a number, it is infinite.
    pub fn contradiction(&self) -> f64 {
        if !(0.0..=1.0).contains(&self.r1) {
            return f64::INFINITY;
        }
        let c1 = polar(self.r1, self.mean_toward_rad);
        let away = sub(polar(self.r2, 2.0 * self.principal_toward_rad), mul(c1, c1));
        let beyond = norm2(away).sqrt() - (1.0 - norm2(c1));
        if beyond.is_finite() { beyond.max(0.0) } else { f64::INFINITY }
    }

    /// D as a function of θ in radians, never negative, by `method`.
    ///
    /// Moments that contradict each other, which noise in a buoy's record brings, are brought to the nearest
    /// that do not: if r₁ is above its limit, D is smoothed until it is there, which takes q off c₁ and q²
    /// off c₂ (Poisson's kernel); then c₂ is drawn towards c₁² until |φ₂| is within its own. For
    /// Longuet-Higgins both limits are 1. What is not a number counts as 0.
    pub fn distribution(&self, method: DirectionMethod) -> impl Fn(f64) -> f64 + use<> {
        let limits = match method {
            DirectionMethod::MaximumEntropy => [Self::LARGEST_R1, Self::LARGEST_PHI2],
            DirectionMethod::LonguetHiggins => [1.0, 1.0],
        };
        let Coefficients { c1, c2, phi2 } = self.consistent(limits);
        // φ₁ = c₁(1 − φ₂), with c̄₁ where c₁ is not real: φ₁ = c₁ − φ₂ c̄₁ (Levinson's recursion).
        let phi1 = sub(c1, mul(phi2, conjugate(c1)));
        let noise = (1.0 - norm2(c1)) * (1.0 - norm2(phi2));
        move |theta: f64| {
            let (sin, cos) = libm::sincos(theta);
            let (sin2, cos2) = (2.0 * sin * cos, cos * cos - sin * sin);
            match method {
                DirectionMethod::MaximumEntropy => {
                    let once = mul(phi1, [cos, -sin]);
                    let twice = mul(phi2, [cos2, -sin2]);
                    noise / (TAU * norm2([1.0 - once[0] - twice[0], once[1] + twice[1]]))
                }
                DirectionMethod::LonguetHiggins => {
                    let first = c1[0] * cos + c1[1] * sin;
                    let second = c2[0] * cos2 + c2[1] * sin2;
                    ((0.5 + 2.0 / 3.0 * first + second / 6.0) / PI).max(0.0)
                }
            }
        }
    }

    /// c₁, c₂ and φ₂ of a distribution that exists, with r₁ and |φ₂| no larger than the limits.
    fn consistent(&self, [largest_r1, largest_phi2]: [f64; 2]) -> Coefficients {
        let known = |r: f64, angle: f64| {
            if r.is_finite() && angle.is_finite() { polar(r, angle) } else { [0.0, 0.0] }
        };
        let r1 = self.r1.clamp(0.0, 1.0);
        let q = if r1 > largest_r1 { largest_r1 / r1 } else { 1.0 };
        let c1 = known(q * r1, self.mean_toward_rad);
        let c2 = known(q * q * self.r2.clamp(0.0, 1.0), 2.0 * self.principal_toward_rad);
        let square = mul(c1, c1);
        let room = 1.0 - norm2(c1);
        let away = sub(c2, square);
        let phi2_size = if room > 0.0 { norm2(away).sqrt() / room } else { f64::INFINITY };
        let kept = if phi2_size > largest_phi2 { largest_phi2 / phi2_size } else { 1.0 };
        let away = away.map(|part| part * kept);
        let phi2 = if room > 0.0 { away.map(|part| part / room) } else { [0.0, 0.0] };
        Coefficients { c1, c2: [square[0] + away[0], square[1] + away[1]], phi2 }
    }
}

/// Complex numbers as real and imaginary parts.
struct Coefficients {
    c1: [f64; 2],
    c2: [f64; 2],
    phi2: [f64; 2],
}

fn polar(r: f64, angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [r * cos, r * sin]
}

fn mul(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn sub(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn conjugate(a: [f64; 2]) -> [f64; 2] {
    [a[0], -a[1]]
}

fn norm2(a: [f64; 2]) -> f64 {
    a[0] * a[0] + a[1] * a[1]
}

/// cos^{2s}((θ − θ₁)/2) as a function of θ in radians, for `s` ≥ 0; [`sampled`] scales it.
pub fn cos2s_distribution(s: f64, mean_toward_rad: f64) -> impl Fn(f64) -> f64 {
    move |theta| libm::pow(libm::cos(0.5 * (theta - mean_toward_rad)).abs(), 2.0 * s)
}

/// `count` directions of equal spacing over the circle, radians.
pub fn even_directions(count: usize) -> Vec<f64> {
    (0..count).map(|i| TAU * i as f64 / count as f64).collect()
}

/// `distribution` on [`even_directions`]: the mean over the cell around each, so that no peak falls between
/// two, scaled so that the mean over the circle is 1/2π whatever the shape. Flat if the distribution is 0
/// all round.
pub fn sampled(distribution: impl Fn(f64) -> f64, count: usize) -> Vec<f64> {
    const PARTS: usize = 16;
    let part = TAU / (count * PARTS) as f64;
    let cell = |i: usize| {
        // From half a cell before the direction to half a cell after it.
        let first = (i * PARTS) as f64 - 0.5 * (PARTS - 1) as f64;
        (0..PARTS).map(|j| distribution((first + j as f64) * part)).sum::<f64>()
    };
    let cells: Vec<f64> = (0..count).map(cell).collect();
    let integral = cells.iter().sum::<f64>() * TAU / count as f64;
    if integral > 0.0 && integral.is_finite() {
        cells.into_iter().map(|cell| cell / integral).collect()
    } else {
        vec![1.0 / TAU; count]
    }
}

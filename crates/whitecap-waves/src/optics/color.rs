//! The colour of the water's own light: the classic blend of two colours, and the single scattering that it
//! stands for.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | c | extinction coefficient | 1/m |
//! | β | scattering out of the sun's ray into the view ray | 1/(m sr) |
//! | E | irradiance on a plane facing the sun, below the surface | W/m², or any |
//! | μs, μv | cosines of the *refracted* sun and view rays to the vertical | |
//! | l | path of the view ray to the bottom, depth/μv | m |
//! | L | radiance towards the eye, below the surface | that unit/sr |

/// Refractive index of fresh water at visible wavelengths, relative to air.
pub const WATER_REFRACTIVE_INDEX: f64 = 1.333;

/// The classic water colour (Wenzel, "Ocean scene", in *Meshuggah*, 2002): from `grazing`, seen along the
/// surface, to `deep`, seen straight down, linear in `cos`, the cosine between view and normal (taken within
/// 0..=1).
pub fn water_color_lerp(cos: f64, grazing: [f64; 3], deep: [f64; 3]) -> [f64; 3] {
    let c = cos.clamp(0.0, 1.0);
    std::array::from_fn(|channel| grazing[channel] + c * (deep[channel] - grazing[channel]))
}

/// Homogeneous water under a flat surface, lit by the sun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaterBody {
    /// β in 1/(m sr): for scattering alike in all directions, the scattering coefficient over 4π. At least 0.
    pub scattering_per_m: [f64; 3],
    /// c in 1/m, absorption and scattering together. At least 0; above 0 where the water has no bottom.
    pub extinction_per_m: [f64; 3],
    /// Depth in metres, above 0; `f64::INFINITY` for no bottom. The bottom itself is black.
    pub depth_m: f64,
    /// E: what the sun sends through the surface, on a plane facing the refracted ray.
    pub sun_irradiance: [f64; 3],
    /// The cosine of the sun's zenith angle above the water, taken within 0..=1.
    pub sun_cos: f64,
}

impl WaterBody {
    /// The colour for `n` view cosines evenly spaced from 0 (grazing) to 1 (straight down), in that order:
    /// the one-dimensional texture of the classic technique. A table of one holds the grazing colour.
    pub fn table(&self, n: usize) -> Vec<[f32; 3]> {
        let last = n.saturating_sub(1).max(1) as f64;
        (0..n)
            .map(|i| water_color_single_scatter(i as f64 / last, self).map(|channel| channel as f32))
            .collect()
    }
}

/// The radiance that single scattering in `body` sends to an eye above it, `view_cos` being the cosine between
/// the view and the vertical in air (taken within 0..=1).
///
/// Sun light reaches the point at distance s along the view ray over a path s μv/μs and returns over s, so
/// L = βE ∫₀ˡ exp(−c s (1 + μv/μs)) ds = βE μs/(c (μs + μv)) · (1 − exp(−c l (1 + μv/μs))). It is what the
/// method of Nishita and Nakamae (1994) comes to for a flat surface. The loss of light on its way through
/// the surface is left to the caller.
pub fn water_color_single_scatter(view_cos: f64, body: &WaterBody) -> [f64; 3] {
    let mu_s = refracted_cosine(body.sun_cos);
    let mu_v = refracted_cosine(view_cos);
    // Length of light's way per metre of view ray, there and back.
    let way = 1.0 + mu_v / mu_s;
    let path_m = body.depth_m / mu_v;
    std::array::from_fn(|channel| {
        let c = body.extinction_per_m[channel];
        // ∫₀ˡ exp(−c s way) ds; expm1 keeps thin water exact, and clear water needs its own limit.
        let lit_m = if c > 0.0 { -libm::expm1(-c * path_m * way) / (c * way) } else { path_m };
        body.scattering_per_m[channel] * body.sun_irradiance[channel] * lit_m
    })
}

/// Snell's law for a flat surface seen from air: the cosine below it, between 0.661 and 1.
fn refracted_cosine(cos: f64) -> f64 {
    let cos = cos.clamp(0.0, 1.0);
    (1.0 - (1.0 - cos * cos) / (WATER_REFRACTIVE_INDEX * WATER_REFRACTIVE_INDEX)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODY: WaterBody = WaterBody {
        scattering_per_m: [0.001, 0.003, 0.004],
        extinction_per_m: [0.4, 0.08, 0.05],
        depth_m: f64::INFINITY,
        sun_irradiance: [1.0, 0.9, 0.8],
        sun_cos: 0.8,
    };

    #[test]
    fn the_blend_runs_from_grazing_to_deep() {
        let (green, blue) = ([0.0, 0.25, 0.2], [0.0, 0.08, 0.15]);
        assert_eq!(water_color_lerp(0.0, green, blue), green);
        assert_eq!(water_color_lerp(-0.4, green, blue), green);
        for (seen, expected) in water_color_lerp(1.0, green, blue).iter().zip(blue) {
            assert!((seen - expected).abs() < 1e-15);
        }
        assert!((water_color_lerp(0.25, green, blue)[1] - 0.2075).abs() < 1e-12);
    }

    #[test]
    fn refraction_by_snell() {
        for degrees in [0.0_f64, 20.0, 50.0, 80.0, 90.0] {
            let below = (degrees.to_radians().sin() / 1.333).asin().cos();
            assert!((refracted_cosine(degrees.to_radians().cos()) - below).abs() < 1e-12);
        }
    }

    /// Against the integral itself, light lost step by step along both rays.
    #[test]
    fn single_scattering_is_the_integral() {
        let body = WaterBody { depth_m: 6.0, ..BODY };
        let view_cos = 0.35;
        let (mu_s, mu_v) = (refracted_cosine(0.8), refracted_cosine(view_cos));
        let steps = 20_000;
        let expected: [f64; 3] = std::array::from_fn(|channel| {
            let dz = 6.0 / f64::from(steps);
            (0..steps)
                .map(|i| (f64::from(i) + 0.5) * dz)
                .map(|z| (-body.extinction_per_m[channel] * (z / mu_s + z / mu_v)).exp() * dz / mu_v)
                .sum::<f64>()
                * body.scattering_per_m[channel]
                * body.sun_irradiance[channel]
        });
        for (seen, expected) in water_color_single_scatter(view_cos, &body).iter().zip(expected) {
            assert!((seen / expected - 1.0).abs() < 1e-7);
        }
    }

    #[test]
    fn deep_shallow_and_clear_limits() {
        // Straight down under a zenith sun, no bottom: βE/(2c).
        let noon = WaterBody { sun_cos: 1.0, ..BODY };
        let deep = water_color_single_scatter(1.0, &noon);
        assert!((deep[1] - 0.003 * 0.9 / 0.16).abs() < 1e-15);
        // A film of water, and water that takes nothing away: βE times the path.
        let film = water_color_single_scatter(1.0, &WaterBody { depth_m: 1e-6, ..noon });
        assert!((film[0] / (0.001 * 1e-6) - 1.0).abs() < 1e-6);
        let clear = WaterBody { extinction_per_m: [0.0; 3], depth_m: 5.0, ..noon };
        assert!((water_color_single_scatter(1.0, &clear)[2] - 0.004 * 0.8 * 5.0).abs() < 1e-15);
        // Deep water is what ever deeper water tends to.
        let deeper = water_color_single_scatter(0.3, &WaterBody { depth_m: 1e4, ..BODY });
        for (seen, expected) in deeper.iter().zip(water_color_single_scatter(0.3, &BODY)) {
            assert!((seen - expected).abs() < 1e-15);
        }
    }

    #[test]
    fn the_table_samples_the_function() {
        let table = BODY.table(5);
        assert_eq!(table.len(), 5);
        for (i, entry) in table.iter().enumerate() {
            let expected = water_color_single_scatter(i as f64 / 4.0, &BODY);
            assert_eq!(*entry, expected.map(|channel| channel as f32));
        }
        // Without a bottom the long grazing ray gathers the most.
        assert!(table[0][1] > table[4][1]);
        assert!(BODY.table(1).len() == 1 && BODY.table(0).is_empty());
    }
}

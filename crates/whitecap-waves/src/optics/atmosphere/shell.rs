//! Heights and distances in the shell of air around a round Earth.
//!
//! Everything is kept in heights over the ground and not in distances from the centre, whose differences single
//! precision loses: the shader does the same.

/// Radius of the ground (Hillaire 2020, table 1), km.
pub(super) const GROUND_KM: f64 = 6360.0;

/// The air ends at this height, km.
pub(super) const TOP_KM: f64 = 100.0;

/// A ray from a height in a direction whose cosine to the zenith is `mu`, and how far it goes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    /// Where it starts, km over the ground.
    pub(super) height_km: f64,
    /// Cosine of its angle to the zenith there.
    pub(super) mu: f64,
    /// Its length, km.
    pub(super) length_km: f64,
}

impl Ray {
    /// As far as the ground if the ray is `downward`, that is, goes below the horizon; to the end of the air otherwise.
    pub(super) fn whole(height_km: f64, mu: f64, downward: bool) -> Ray {
        let length_km = if downward { to_ground_km(height_km, mu) } else { to_top_km(height_km, mu) };
        Ray { height_km, mu, length_km }
    }

    /// Height at a distance along the ray, km.
    pub(super) fn height_at(&self, distance_km: f64) -> f64 {
        let r = GROUND_KM + self.height_km;
        let beyond = squared_beyond(self.height_km) + distance_km * (distance_km + 2.0 * r * self.mu);
        height_of(beyond)
    }

    /// Cosine of the sun's zenith angle at a distance along the ray, where its height is `here_km`: `mu_s` is that at its start, `nu` the cosine
    /// between ray and sun.
    pub(super) fn sun_at(&self, distance_km: f64, here_km: f64, mu_s: f64, nu: f64) -> f64 {
        (((GROUND_KM + self.height_km) * mu_s + distance_km * nu) / (GROUND_KM + here_km)).clamp(-1.0, 1.0)
    }

    /// Where along the ray the Earth hides the middle of the sun: from one distance to another, which are both the ray's
    /// length where nowhere. The shadow is a cylinder behind the Earth, and the ray crosses it once at most.
    pub(super) fn shadow(&self, mu_s: f64, nu: f64) -> [f64; 2] {
        let lit = [self.length_km; 2];
        let r = GROUND_KM + self.height_km;
        // Squared distance from the cylinder's axis over the radius', a t² + 2 b t + c, is below 0 within.
        let a = (1.0 - nu * nu).max(1e-12);
        let b = r * (self.mu - mu_s * nu);
        let c = squared_beyond(self.height_km) - r * r * mu_s * mu_s;
        let discriminant = b * b - a * c;
        if discriminant <= 0.0 {
            return lit;
        }
        let q = -b - discriminant.sqrt().copysign(b);
        let (mut enters, mut leaves) = ((q / a).min(c / q), (q / a).max(c / q));
        // Of the two halves of the axis, the one away from the sun.
        let across = -r * mu_s / nu;
        if nu < 0.0 {
            enters = enters.max(across);
        } else if nu > 0.0 {
            leaves = leaves.min(across);
        } else if mu_s >= 0.0 {
            return lit;
        }
        let [enters, leaves] = [enters, leaves].map(|t| t.clamp(0.0, self.length_km));
        if enters < leaves { [enters, leaves] } else { lit }
    }

    /// Places along the ray, km from its start, and the lengths that each stands for.
    ///
    /// They are close where the air is dense: in pairs (Gauss–Legendre's) over even parts of the root of the distance
    /// from the lowest point, as many as that root is long over `steps`. None of those parts lies on both sides of the shadow's edge;
    /// within `shadow`, from [`Ray::shadow`], where the light is soft, they are longer.
    pub(super) fn nodes(&self, shadow: [f64; 2], steps: Steps) -> impl Iterator<Item = (f64, f64)> + use<> {
        let lowest_km = (-(GROUND_KM + self.height_km) * self.mu).clamp(0.0, self.length_km);
        let root = |distance_km: f64| {
            let beyond = distance_km - lowest_km;
            beyond.abs().sqrt().copysign(beyond)
        };
        let edges = [0.0, shadow[0], shadow[1], self.length_km].map(root);
        let whole = edges[3] - edges[0];
        let pairs = (whole / steps.longest).ceil().max(steps.fewest);
        let weights = [edges[1] - edges[0], DARK_WEIGHT * (edges[2] - edges[1]), edges[3] - edges[2]];
        let share = pairs / weights.iter().sum::<f64>().max(1e-9);
        (0..3).flat_map(move |part| {
            // Rounding does not make a part of one that has no length.
            let pairs = (weights[part] * share - 1e-4).ceil().max(0.0);
            let step = (edges[part + 1] - edges[part]) / pairs.max(1.0);
            (0..pairs as u32).flat_map(move |i| {
                PAIR.map(|place| {
                    let x = edges[part] + (f64::from(i) + place) * step;
                    (lowest_km + x * x.abs(), x.abs() * step)
                })
            })
        })
    }
}

/// How finely a ray is divided.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steps {
    /// Length of a pair's part, at most, in the root of the distance from the ray's lowest point, √km.
    pub(super) longest: f64,
    /// Pairs at least.
    pub(super) fewest: f64,
}

/// What a length in the Earth's shadow counts when a ray's pairs are shared out.
const DARK_WEIGHT: f64 = 0.5;

/// Places of Gauss's and Legendre's two points; each stands for half of the whole.
const PAIR: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// r² − R² for a height, km².
pub(super) fn squared_beyond(height_km: f64) -> f64 {
    height_km * (2.0 * GROUND_KM + height_km)
}

/// The height, not below 0, whose r² − R² is `squared_beyond`.
pub(super) fn height_of(squared_beyond: f64) -> f64 {
    (squared_beyond / ((GROUND_KM * GROUND_KM + squared_beyond).max(0.0).sqrt() + GROUND_KM)).max(0.0)
}

/// Cosine to the zenith of the horizon that an eye at a height sees; it is not above 0.
pub(super) fn horizon_mu(height_km: f64) -> f64 {
    -squared_beyond(height_km).max(0.0).sqrt() / (GROUND_KM + height_km)
}

/// Distance to the end of the air, km.
pub(super) fn to_top_km(height_km: f64, mu: f64) -> f64 {
    let r = GROUND_KM + height_km;
    let above = squared_beyond(TOP_KM) - squared_beyond(height_km);
    // Of the two forms of the root, the one that does not subtract what is nearly equal.
    let root = (r * r * mu * mu + above).max(0.0).sqrt();
    if mu > 0.0 { above.max(0.0) / (root + r * mu) } else { root - r * mu }
}

/// Distance to the ground along a ray below the horizon, km.
pub(super) fn to_ground_km(height_km: f64, mu: f64) -> f64 {
    let r = GROUND_KM + height_km;
    let root = (r * r * mu * mu - squared_beyond(height_km)).max(0.0).sqrt();
    squared_beyond(height_km) / (root - r * mu).max(1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_end_on_the_spheres() {
        for height_km in [0.001, 2.0, 60.0] {
            for mu in [-1.0, -0.5, -0.1, 0.0, 0.3, 1.0] {
                let downward = mu < horizon_mu(height_km);
                let ray = Ray::whole(height_km, mu, downward);
                let end_km = if downward { 0.0 } else { TOP_KM };
                assert!((ray.height_at(ray.length_km) - end_km).abs() < 1e-6, "{height_km} {mu}");
            }
        }
    }

    #[test]
    fn nodes_fill_the_ray_and_are_close_where_it_is_low() {
        for shadow in [[1e9; 2], [0.0, 200.0], [300.0, 900.0]] {
            let ray = Ray::whole(20.0, -0.05, false);
            let nodes: Vec<_> = ray
                .nodes(shadow.map(|km| f64::min(km, ray.length_km)), Steps { longest: 1.2, fewest: 14.0 })
                .collect();
            let whole: f64 = nodes.iter().map(|node| node.1).sum();
            // The pair over the lowest point, where lengths have a corner, is a little off.
            assert!((whole - ray.length_km).abs() < 0.2, "{whole} of {}", ray.length_km);
            assert!(nodes.windows(2).all(|two| two[0].0 < two[1].0));
            let length = |node: &&(f64, f64)| node.1;
            let shortest = nodes.iter().min_by(|a, b| length(a).total_cmp(&length(b))).unwrap();
            let lowest =
                nodes.iter().min_by(|a, b| ray.height_at(a.0).total_cmp(&ray.height_at(b.0))).unwrap();
            assert!((shortest.0 - lowest.0).abs() < 10.0, "{shortest:?} {lowest:?}");
        }
    }

    /// Where the middle of the sun is behind the Earth's edge by the cosines along the ray, it is by the cylinder too.
    #[test]
    fn the_shadow_is_where_the_sun_is_under_the_horizon() {
        for (height_km, mu) in
            [(0.001, 0.0), (0.001, 0.4), (12.0, -0.03), (12.0, -0.3), (60.0, -0.1), (60.0, 0.5)]
        {
            for sun_deg in [30.0, 1.0, -2.0, -5.0, -10.0_f64] {
                for azimuth_deg in [0.0, 40.0, 90.0, 140.0, 180.0_f64] {
                    let (mu_s, cos_s) = sun_deg.to_radians().sin_cos();
                    let nu = mu * mu_s + (1.0 - mu * mu).sqrt() * cos_s * azimuth_deg.to_radians().cos();
                    let ray = Ray::whole(height_km, mu, mu < horizon_mu(height_km));
                    let [enters, leaves] = ray.shadow(mu_s, nu);
                    for part in 0..200 {
                        let at_km = ray.length_km * (f64::from(part) + 0.5) / 200.0;
                        let here_km = ray.height_at(at_km);
                        let beyond = ray.sun_at(at_km, here_km, mu_s, nu) - horizon_mu(here_km);
                        let dark = at_km > enters && at_km < leaves;
                        assert!(
                            dark == (beyond < 0.0) || beyond.abs() < 1e-6,
                            "{height_km} {mu} {sun_deg} {azimuth_deg}"
                        );
                    }
                }
            }
        }
    }
}

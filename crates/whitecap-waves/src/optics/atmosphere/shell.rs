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
        (beyond / ((GROUND_KM * GROUND_KM + beyond).max(0.0).sqrt() + GROUND_KM)).max(0.0)
    }

    /// Cosine of the sun's zenith angle at a distance along the ray: `mu_s` is that at its start, `nu` the cosine
    /// between ray and sun.
    pub(super) fn sun_at(&self, distance_km: f64, mu_s: f64, nu: f64) -> f64 {
        let (r, here) = (GROUND_KM + self.height_km, GROUND_KM + self.height_at(distance_km));
        ((r * mu_s + distance_km * nu) / here).clamp(-1.0, 1.0)
    }

    /// The middles and lengths of `steps` parts of the ray that are short where the air is dense: they grow with the
    /// square root of the distance from the lowest point.
    pub(super) fn steps(&self, steps: u32) -> impl Iterator<Item = (f64, f64)> + use<> {
        let lowest_km = (-(GROUND_KM + self.height_km) * self.mu).clamp(0.0, self.length_km);
        let (first, last) = (-lowest_km.sqrt(), (self.length_km - lowest_km).sqrt());
        let distance = move |part: f64| {
            let x = first + part * (last - first) / f64::from(steps);
            lowest_km + x * x.abs()
        };
        (0..steps).map(f64::from).map(move |i| (distance(i + 0.5), distance(i + 1.0) - distance(i)))
    }
}

/// r² − R² for a height, km².
pub(super) fn squared_beyond(height_km: f64) -> f64 {
    height_km * (2.0 * GROUND_KM + height_km)
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
    fn steps_fill_the_ray_and_are_short_where_it_is_low() {
        let ray = Ray::whole(20.0, -0.05, false);
        let steps: Vec<_> = ray.steps(32).collect();
        let whole: f64 = steps.iter().map(|step| step.1).sum();
        assert!((whole - ray.length_km).abs() < 1e-9);
        let length = |step: &&(f64, f64)| step.1;
        let shortest = steps.iter().min_by(|a, b| length(a).total_cmp(&length(b))).unwrap();
        let lowest = steps.iter().min_by(|a, b| ray.height_at(a.0).total_cmp(&ray.height_at(b.0))).unwrap();
        assert!((shortest.0 - lowest.0).abs() < 10.0, "{shortest:?} {lowest:?}");
    }
}

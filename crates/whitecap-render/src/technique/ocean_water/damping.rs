//! Where waves are lower: the text's v5.x, by which its artists calmed the shores.
//!
//! Here it follows from the ground under the water. It also calms what the mesh cannot carry: the text's plane
//! ended somewhere, ours goes on to the horizon in ever larger triangles.

use glam::DVec2;
use whitecap_scene::mesh::Ground;
use whitecap_scene::technique::shore_damping;

/// Of the grid's half width: from where on waves are lower, and from where on there are none. The rest is a
/// margin for the grid's steps.
const FADE_START: f64 = 0.4;
const FADE_END: f64 = 0.92;

/// What calms the waves round one viewer.
pub(super) struct Damping<'a> {
    pub(super) ground: Option<&'a Ground>,
    /// Depth from which on waves are whole, metres.
    pub(super) shore_depth_m: f64,
    /// Half the grid's width, metres.
    pub(super) half_m: f64,
    /// The eye: east and south, and its height, metres.
    pub(super) eye: DVec2,
    pub(super) eye_height_m: f64,
}

impl Damping<'_> {
    /// v5.x at a place (east, south): 0 for full waves, 1 for none.
    pub(super) fn at(&self, place: DVec2) -> f32 {
        self.of_shore(place).max(self.of_distance(place)) as f32
    }

    /// Linear in the depth, up to all of it at the waterline.
    fn of_shore(&self, place: DVec2) -> f64 {
        let depth_m = self.ground.and_then(|ground| ground.depth_m(place.x, place.y));
        shore_damping(depth_m, self.shore_depth_m)
    }

    fn of_distance(&self, place: DVec2) -> f64 {
        let distance = (place - self.eye).extend(self.eye_height_m).length() / self.half_m;
        let t = ((distance - FADE_START) / (FADE_END - FADE_START)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// A beach that goes down a tenth of the way out, from x = 0 eastwards, 100 m wide.
    fn beach() -> Ground {
        let at = |x: f64, z: f64| DVec3::new(x, -0.1 * x, z);
        let [a, b, c, d] = [at(-50.0, -50.0), at(150.0, -50.0), at(-50.0, 50.0), at(150.0, 50.0)];
        Ground::new([[a, c, b], [b, c, d]].into_iter(), 201).unwrap()
    }

    fn damping(ground: Option<&Ground>) -> Damping<'_> {
        Damping { ground, shore_depth_m: 5.0, half_m: 1000.0, eye: DVec2::ZERO, eye_height_m: 4.0 }
    }

    #[test]
    fn waves_are_whole_in_deep_water_and_none_at_the_shore() {
        let beach = beach();
        let damping = damping(Some(&beach));
        for (x, expected) in [(-20.0, 1.0), (0.0, 1.0), (25.0, 0.5), (40.0, 0.2), (50.0, 0.0), (120.0, 0.0)] {
            assert!((f64::from(damping.at(DVec2::new(x, 3.0))) - expected).abs() < 1e-4, "{x}");
        }
        // Past the ground the water is deep.
        assert_eq!(damping.at(DVec2::new(160.0, 0.0)), 0.0);
    }

    #[test]
    fn waves_end_before_the_grid_does() {
        let damping = damping(None);
        assert_eq!(damping.at(DVec2::new(390.0, 0.0)), 0.0);
        assert_eq!(damping.at(DVec2::new(0.0, -925.0)), 1.0);
        let mut last = 0.0;
        for x in 0..100 {
            let here = damping.at(DVec2::new(f64::from(x) * 10.0, 0.0));
            assert!(here >= last);
            last = here;
        }
        // From high up no disc of waves is seen in a still sea.
        let high = Damping { eye_height_m: 2000.0, ..damping };
        assert_eq!(high.at(DVec2::ZERO), 1.0);
    }
}

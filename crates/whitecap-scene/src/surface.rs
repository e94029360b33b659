//! The surface that a scene shows: its sea, calmed where its technique calms it.

use glam::{DVec2, DVec3};
use whitecap_waves::model::{Surface, SurfacePoint};
use whitecap_waves::query::{self, QueryError};

use crate::error::SceneError;
use crate::mesh::Ground;
use crate::object;
use crate::scene::Scene;
use crate::sea::SeaSurface;
use crate::technique::{Technique, shore_damping};

/// Half the step over which the ground's slope is taken, metres.
const STEP_M: f64 = 0.25;

/// A scene's sea with what its ground does to the waves: what floats on it, and what is asked for a height.
///
/// `ocean-water` calms its waves towards a shore. What it does by the distance from a viewer, so that far waves do
/// not outrun their mesh, belongs to a view and not to the sea.
#[derive(Debug)]
pub struct SceneSurface {
    sea: SeaSurface,
    shore: Option<Shore>,
}

#[derive(Debug)]
struct Shore {
    ground: Ground,
    depth_m: f64,
}

impl Scene {
    /// The moving surface of the whole scene. Equal scenes give equal surfaces.
    ///
    /// # Errors
    ///
    /// As [`Sea::build`](crate::Sea::build) and [`Scene::read_objects`].
    pub fn surface(&self) -> Result<SceneSurface, SceneError> {
        let sea = self.sea.build(self.seed)?;
        let shore = match &self.technique {
            Technique::OceanWater(settings) => object::ground(&self.read_objects()?)
                .map(|ground| Shore { ground, depth_m: settings.shore_depth_m }),
            _ => None,
        };
        Ok(SceneSurface { sea, shore })
    }
}

impl SceneSurface {
    /// The sea as it is in open water.
    pub fn sea(&self) -> &SeaSurface {
        &self.sea
    }
}

impl Shore {
    /// The share of the waves that is left at a place.
    fn left(&self, place: DVec2) -> f64 {
        1.0 - shore_damping(self.ground.depth_m(place.x, place.y), self.depth_m)
    }
}

impl Surface for SceneSurface {
    /// In open water.
    fn variance_m2(&self) -> f64 {
        self.sea.variance_m2()
    }

    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        let open = self.sea.sample(rest_m, time_s);
        let Some(shore) = &self.shore else { return open };
        let across = |step: DVec2| (shore.left(rest_m + step) - shore.left(rest_m - step)) / (2.0 * STEP_M);
        let gradient = DVec2::new(across(DVec2::X * STEP_M), across(DVec2::Y * STEP_M));
        let left = shore.left(rest_m);
        if left == 1.0 && gradient == DVec2::ZERO {
            return open;
        }
        // Sines move upright, so the surface is its height alone.
        let slope = open.slope * left + gradient * open.displacement_m.y;
        SurfacePoint {
            displacement_m: open.displacement_m * left,
            normal: DVec3::new(-slope.x, 1.0, -slope.y).normalize(),
            jacobian: open.jacobian,
            slope,
            velocity_mps: open.velocity_mps * left,
        }
    }

    fn query(&self, places_m: &[DVec2], time_s: f64) -> Result<Vec<SurfacePoint>, QueryError> {
        if self.shore.is_none() {
            return self.sea.query(places_m, time_s);
        }
        // Damped waves are those of sines, which move upright: the water over a place rests there.
        query::check(places_m, time_s)?;
        Ok(places_m.iter().map(|place_m| self.sample(*place_m, time_s)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_are_calm_at_the_shore_and_whole_in_open_water() {
        let scene = crate::open("ocean-water-shore").unwrap();
        let (surface, ground) =
            (scene.surface().unwrap(), object::ground(&scene.read_objects().unwrap()).unwrap());
        let Technique::OceanWater(settings) = &scene.technique else { panic!() };
        let mut calmed = 0;
        for i in 0..400 {
            let place = DVec2::new(f64::from(i % 20) * 11.0 - 110.0, f64::from(i / 20) * 11.0 - 110.0);
            let (here, open) = (surface.sample(place, 3.7), surface.sea().sample(place, 3.7));
            match ground.depth_m(place.x, place.y) {
                Some(depth_m) if depth_m <= 0.0 => assert_eq!(here.displacement_m.y, 0.0),
                Some(depth_m) if depth_m < settings.shore_depth_m => {
                    let left = depth_m / settings.shore_depth_m;
                    assert!((here.displacement_m.y - left * open.displacement_m.y).abs() < 1e-9);
                    calmed += 1;
                }
                _ => assert!((here.displacement_m - open.displacement_m).length() < 1e-12),
            }
        }
        assert!(calmed > 10, "{calmed}");
    }

    #[test]
    fn a_calmed_slope_is_that_of_the_calmed_height() {
        let surface = crate::open("ocean-water-shore").unwrap().surface().unwrap();
        let mut calmed = 0;
        for i in 0..64 {
            // From the beach out to open water.
            let place = DVec2::from_angle(f64::from(i) * 0.39) * (50.0 + 0.6 * f64::from(i));
            let height = |at: DVec2| surface.sample(at, 1.3).displacement_m.y;
            let step = DVec2::X * 0.25;
            let slope = (height(place + step) - height(place - step)) / 0.5;
            let point = surface.sample(place, 1.3);
            assert!((slope - point.slope.x).abs() < 5e-3, "{place}");
            assert!((point.normal.x / point.normal.y + point.slope.x).abs() < 1e-12);
            let open = surface.sea().sample(place, 1.3);
            let by_the_share_alone = open.slope.x * point.displacement_m.y / open.displacement_m.y;
            calmed += i32::from((slope - by_the_share_alone).abs() > 1e-2);
        }
        assert!(calmed > 5, "the ground's own slope shows at {calmed} places");
    }
}

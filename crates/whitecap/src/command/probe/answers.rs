//! What is known about a place.

use super::super::options::Place;
use glam::{DVec2, DVec3};
use whitecap_scene::SceneSurface;
use whitecap_waves::model::sines::SumOfSines;
use whitecap_waves::model::{Surface, SurfacePoint};
use whitecap_waves::query::QueryError;

/// In metres: x east, y up, z south.
#[derive(serde::Serialize)]
pub(super) struct InWorld {
    pub(super) x_m: f64,
    pub(super) z_m: f64,
    pub(super) time_s: f64,
    pub(super) height_m: f64,
    /// Of the water that is over the place, from where it rests.
    pub(super) displacement_m: [f64; 3],
    pub(super) normal: [f64; 3],
    /// Of the water.
    pub(super) velocity_mps: [f64; 3],
}

/// In the units of the text: x along u, y along v, z up.
#[derive(serde::Serialize)]
pub(super) struct InText {
    pub(super) u: f64,
    pub(super) v: f64,
    pub(super) time_s: f64,
    pub(super) height: f64,
    pub(super) normal: [f64; 3],
}

/// The surface over each of `places` at one moment, in their order.
pub(super) fn answers(
    surface: &SceneSurface,
    places: &[Place],
    time_s: f64,
) -> Result<Vec<InWorld>, QueryError> {
    let places_m: Vec<DVec2> = places.iter().map(|&place| place.into()).collect();
    let answer = |(&[x_m, z_m], point): (&Place, SurfacePoint)| {
        let displacement_m = array(point.displacement_m);
        InWorld {
            x_m,
            z_m,
            time_s,
            height_m: displacement_m[1],
            displacement_m,
            normal: array(point.normal),
            velocity_mps: array(point.velocity_mps),
        }
    };
    Ok(places.iter().zip(surface.query(&places_m, time_s)?).map(answer).collect())
}

/// The surface at each of the texture coordinates `places` at one moment, in their order.
pub(super) fn answers_in_text(
    sines: &SumOfSines,
    places: &[Place],
    time_s: f64,
) -> impl Iterator<Item = InText> {
    places.iter().map(move |&[u, v]| {
        let surface = sines.at_uv(DVec2::new(u, v), time_s, 0.0);
        InText { u, v, time_s, height: surface.height + 0.0, normal: array(surface.normal) }
    })
}

/// A negative zero becomes a plain one: it is the same place, and reads better.
fn array(vector: DVec3) -> [f64; 3] {
    vector.to_array().map(|component| component + 0.0)
}

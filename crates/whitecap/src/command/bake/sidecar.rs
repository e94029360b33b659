//! What baked numbers are, for programs: `bake.json`, and the attribute of each OpenEXR file.

use super::format::{Bounds, Format};
use super::map::Map;
use super::surface::Sea;
use super::{Bake, Shown};
use crate::command::frames::Frames;
use crate::command::series::Grid;
use serde_json::{Value, json};
use whitecap_scene::Scene;
use whitecap_scene::sea::SeaModel;

/// Everything that does not change from frame to frame.
pub(super) fn of_bake(bake: &Bake, scene: &Scene, sea: &Sea, frames: Frames, shown: &[Shown]) -> Value {
    let maps: serde_json::Map<String, Value> =
        bake.maps().iter().map(|map| (map.word().to_owned(), of_map(bake.format, *map, sea))).collect();
    let of_shown = |shown: &Shown| {
        let mut value = shown.facts.clone();
        if let Value::Object(object) = &mut value {
            object.insert(
                "files".to_owned(),
                json!(format!("{}.{{map}}.%04d.{}", shown.name, bake.format.extension())),
            );
        }
        value
    };
    json!({
        "whitecap": env!("CARGO_PKG_VERSION"),
        "scene": bake.scene,
        "seed": scene.seed,
        "axes": "x east, y up, z south; columns run east, rows south",
        "significant_height_m": sea.significant_height_m(),
        "choppiness": sea.sea().parameters().choppiness,
        "loop_s": loop_s(scene),
        "frames": { "from": frames.from, "to": frames.to, "per_s": bake.fps.to_string(), "frame_0_s": bake.time },
        "format": bake.format.word(),
        "maps": maps,
        "foam_threshold": sea.foam().map(|foam| foam.threshold()),
        "of": shown.iter().map(of_shown).collect::<Vec<_>>(),
    })
}

/// What one file says of itself.
pub(super) fn of_file(bake: &Bake, scene: &Scene, sea: &Sea, shown: &Shown, map: Map, time_s: f64) -> String {
    json!({
        "whitecap": env!("CARGO_PKG_VERSION"),
        "scene": bake.scene,
        "seed": scene.seed,
        "time_s": time_s,
        "loop_s": loop_s(scene),
        "map": of_map(bake.format, map, sea),
        "of": shown.facts,
    })
    .to_string()
}

fn of_map(format: Format, map: Map, sea: &Sea) -> Value {
    let mut value = json!({ "is": map.doc(), "unit": map.unit(), "channels": map.channels().len() });
    if let (Format::Png16, Value::Object(object)) = (format, &mut value) {
        let Bounds { black, white } = sea.bounds(map);
        object.insert("black".to_owned(), json!(black));
        object.insert("white".to_owned(), json!(white));
    }
    value
}

/// Of one cascade.
pub(super) fn of_cascade(sea: &Sea, index: usize) -> Value {
    let cascade = sea.sea().parameters().cascades[index];
    json!({
        "cascade": index,
        "tile_size_m": cascade.tile_size_m,
        "resolution": cascade.resolution,
        "first_sample_m": [0.0, 0.0],
        "spacing_m": cascade.tile_size_m / cascade.resolution as f64,
        "sewn": sea.sea().patchwork(index).is_some(),
    })
}

/// Of a rectangle.
pub(super) fn of_area(grid: Grid) -> Value {
    json!({
        "area_m": { "x": [grid.x_m.from, grid.x_m.to], "z": [grid.z_m.from, grid.z_m.to] },
        "columns": grid.x_m.count,
        "rows": grid.z_m.count,
    })
}

fn loop_s(scene: &Scene) -> Option<f64> {
    match &scene.sea.model {
        SeaModel::Spectral(settings) => settings.loop_s,
        _ => None,
    }
}

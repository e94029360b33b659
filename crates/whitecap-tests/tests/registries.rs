//! What stands in a registry cannot arrive untested: the named scenes show every entry, and the laws run over
//! the named scenes.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::{DVec2, DVec3};
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::{named, sea, sky, technique};
use whitecap_waves::model::{Surface, TileFields};
use whitecap_waves::statistics::{significant_height_m, variance};

/// Skies that need a file from outside; `crates/whitecap-scene/tests` and the environment's own tests cover them.
const NEEDS_A_FILE: &[&str] = &["panorama"];

#[test]
fn every_registered_word_is_shown_by_a_named_scene() {
    let shown: Vec<String> =
        named::ALL.iter().map(|named| whitecap_scene::open(named.name).unwrap().to_toml().unwrap()).collect();
    let is_shown = |key: &str, word: &str| {
        let line = format!("{key} = \"{word}\"");
        shown.iter().any(|toml| toml.lines().any(|l| l.trim() == line))
    };
    let techniques = technique::ALL.iter().map(|entry| ("technique", entry.word));
    let models = sea::MODELS.iter().map(|entry| ("model", entry.word));
    let spectra = sea::system::SPECTRA.iter().map(|entry| ("spectrum", entry.word));
    let skies = sky::ALL.iter().map(|entry| ("kind", entry.word));
    for (key, word) in techniques.chain(models).chain(spectra).chain(skies) {
        assert!(is_shown(key, word) || NEEDS_A_FILE.contains(&word), "no named scene has {key} = \"{word}\"");
    }
}

/// A spline of coefficients, at a place counted in samples.
fn drawn_between(coefficients: &TileFields, place: DVec2) -> DVec3 {
    let n = coefficients.resolution();
    let weight = |u: f64| match u.abs() {
        u if u < 1.0 => 2.0 / 3.0 - u * u + 0.5 * u * u * u,
        u => (2.0 - u).max(0.0).powi(3) / 6.0,
    };
    let first = place.floor() - 1.0;
    let near = (0..16).map(|i| first + DVec2::new(f64::from(i % 4), f64::from(i / 4)));
    near.map(|column| {
        let [x, z] = [column.x, column.y].map(|sample| sample.rem_euclid(n as f64) as usize);
        let coefficient = DVec3::from(coefficients.displacement(z * n + x).map(f64::from));
        weight(place.x - column.x) * weight(place.y - column.y) * coefficient
    })
    .sum()
}

/// The promises of `WaveModel`: the tile is the direct answer, its coefficients draw what is between samples, it repeats,
/// and it depends on nothing but the time.
#[test]
fn every_named_scenes_sea_keeps_the_models_promises() {
    for named in named::ALL {
        let scene = whitecap_scene::open(named.name).unwrap();
        let tiles = scene.sea.build(scene.seed).unwrap().into_tiles();
        for mut model in tiles.into_iter().flatten() {
            let (n, size_m) = (model.resolution(), model.tile_size_m());
            let height_m = significant_height_m(model.variance_m2());
            let near = 1e-4 * height_m;
            let mut fields = TileFields::new(n);
            for time_s in [0.0, 3.7, -4_321.5, 900_000.25] {
                model.evaluate(time_s, &mut fields);
                let first = fields.height.clone();
                for i in (0..n * n).step_by(n * n / 97) {
                    let rest = DVec2::new((i % n) as f64, (i / n) as f64) * size_m / n as f64;
                    let point = model.sample(rest, time_s);
                    let drawn = DVec3::from(fields.displacement(i).map(f64::from));
                    assert!((point.displacement_m - drawn).abs().max_element() < near, "{}", named.name);
                    let normal = DVec3::from(fields.normal(i).map(f64::from));
                    assert!((point.normal - normal).abs().max_element() < 1e-3, "{}", named.name);
                    let next = model.sample(rest + DVec2::new(size_m, -3.0 * size_m), time_s);
                    assert!((point.displacement_m - next.displacement_m).abs().max_element() < near);
                }
                model.evaluate_coefficients(time_s, &mut fields);
                for i in 0..20 {
                    let samples = DVec2::new(0.37 + 5.61 * f64::from(i), 0.83 + 3.19 * f64::from(i));
                    let point = model.sample(samples * size_m / n as f64, time_s);
                    let error = (drawn_between(&fields, samples) - point.displacement_m).length();
                    // A lone tile carries waves down to two samples.
                    assert!(error < 0.03 * height_m, "{}: {error} of {height_m}", named.name);
                }
                model.evaluate(time_s + 50.0, &mut fields);
                model.evaluate(time_s, &mut fields);
                assert_eq!(first, fields.height, "{} remembers", named.name);
            }
        }
    }
}

/// What every surface promises, tile or not, its shores included: it depends on its place and the time alone, and
/// trembles neither far from the origin nor long after the start.
#[test]
fn every_named_scenes_surface_keeps_its_promises() {
    for named in named::ALL {
        let scene = whitecap_scene::open(named.name).unwrap();
        let surface = scene.surface().unwrap();
        let hs_m = significant_height_m(surface.variance_m2());
        // A direct sum over all waves of several tiles takes its time.
        let places = if matches!(surface.sea(), SeaSurface::Spectral(_)) { 4 } else { 40 };
        for time_s in [0.0, 3.7, -4_321.5, 1e6] {
            for far_m in [0.0, 1e6] {
                for i in 0..places {
                    let rest = DVec2::new(far_m + 7.31 * f64::from(i), -far_m - 3.77 * f64::from(i));
                    let point = surface.sample(rest, time_s);
                    assert_eq!(point, surface.sample(rest, time_s), "{}", named.name);
                    assert!((point.normal.length() - 1.0).abs() < 1e-9 && point.normal.y > -1.0);
                    // No surface jumps: a millimetre further on it is nearly where it was.
                    let step = surface.sample(rest + DVec2::splat(7e-4), time_s).displacement_m;
                    let moved = (step - point.displacement_m).length();
                    assert!(moved < 5e-3 + 0.03 * hs_m, "{}: jumps by {moved} m", named.name);
                }
            }
        }
        // The measured variance is the promised one, as far as a few thousand places can tell.
        let places: Vec<DVec2> =
            (0..500).map(|i| DVec2::new(61.803 * f64::from(i % 23), 38.197 * f64::from(i / 23))).collect();
        let heights: Vec<f32> = (0..8)
            .flat_map(|i| surface.query(&places, 37.0 * f64::from(i)).unwrap())
            .map(|point| point.height_m() as f32)
            .collect();
        let measured = significant_height_m(variance(&heights));
        assert!((measured - hs_m).abs() <= 0.15 * hs_m, "{}: {measured} m instead of {hs_m} m", named.name);
    }
}

/// Ask for a height, measure it: for other heights than the scene's own, seeds and moments.
#[test]
fn the_significant_height_asked_for_is_the_one_there_is() {
    for named in named::ALL {
        for (asked_m, seed, time_s) in [(0.5, 1, 0.0), (1.0, 2, 60.0), (2.5, 77, -7.5)] {
            let mut scene = whitecap_scene::open(named.name).unwrap();
            let sea::SeaModel::Spectral(settings) = &mut scene.sea.model else { continue };
            settings.system.truncate(1);
            let sea::system::System::Phillips(system) = &mut settings.system[0] else { continue };
            system.significant_height_m = Some(asked_m);
            let mut measured = 0.0;
            for mut model in scene.sea.build(seed).unwrap().into_tiles().into_iter().flatten() {
                let mut fields = TileFields::new(model.resolution());
                model.evaluate(time_s, &mut fields);
                measured += variance(&fields.height);
            }
            let measured_m = significant_height_m(measured);
            assert!((measured_m / asked_m - 1.0).abs() < 0.01, "{measured_m} instead of {asked_m}");
        }
    }
}

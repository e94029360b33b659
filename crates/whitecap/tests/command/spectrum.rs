//! `spectrum`: the sea in numbers and in a chart.

use crate::{json, names_in, sentence, stderr, stdout, whitecap};
use serde_json::Value;
use std::path::Path;

const KEYS: [&str; 8] = [
    "significant_height_m",
    "peak_period_s",
    "zero_crossing_period_s",
    "m0_m2",
    "mean_direction_from_deg",
    "peak_direction_from_deg",
    "directional_spread_deg",
    "mean_square_slope",
];

fn spectrum(folder: &Path, arguments: &[&str]) -> Value {
    json(&whitecap(folder).arg("spectrum").args(arguments).arg("--json").assert().success())
}

fn near(found: &Value, expected: f64, tolerance: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - expected).abs() <= tolerance, "{found} instead of {expected}");
}

/// A sea of Phillips's with these lines in its tables.
fn scene(folder: &Path, sea: &str, systems: &[&str]) -> &'static str {
    let systems: String =
        systems.iter().map(|lines| format!("[[sea.system]]\nspectrum = \"phillips\"\n{lines}\n")).collect();
    let camera = "[camera]\nposition_m = [0.0, 4.0, 0.0]\nlook_at_m = [100.0, 0.0, 0.0]\n";
    let text = format!("technique = \"meshuggah\"\n[sea]\n{sea}\n{systems}{camera}");
    std::fs::write(folder.join("sea.toml"), text).unwrap();
    "sea.toml"
}

#[test]
fn what_is_asked_for_is_what_the_spectrum_holds_and_what_the_surface_has() {
    let folder = tempfile::tempdir().unwrap();
    let system = "wind_speed_mps = 8.0\nfrom_deg = 340.0\nsignificant_height_m = 2.0";
    let name = scene(folder.path(), "tile_size_m = 300.0\nresolution = 256", &[system]);
    let found = spectrum(folder.path(), &[name]);
    for column in ["requested", "theory", "surface"] {
        let numbers = found[column].as_object().unwrap();
        assert!(KEYS.iter().all(|key| numbers.contains_key(*key)), "{column}: {numbers:?}");
        near(&numbers["significant_height_m"], 2.0, 0.02);
        near(&numbers["m0_m2"], 0.25, 0.005);
        near(&numbers["mean_direction_from_deg"], 340.0, 1.0);
    }
    assert_eq!(found["requested"]["peak_period_s"], Value::Null);
    // Tp = 2π U/(g (4/5)^¼), Tz = 2π U/(g π^¼), and cos² over half the compass.
    let (theory, surface) = (&found["theory"], &found["surface"]);
    near(&theory["peak_period_s"], 5.418, 0.003);
    near(&theory["zero_crossing_period_s"], 3.849, 0.01);
    near(&theory["directional_spread_deg"], 31.51, 0.02);
    near(&theory["peak_direction_from_deg"], 340.0, 0.01);
    near(&surface["peak_period_s"], 5.418, 0.3);
    near(&surface["directional_spread_deg"], 31.5, 1.0);
    near(&surface["peak_direction_from_deg"], 340.0, 5.0);
    near(&surface["kurtosis"], 3.0, 0.3);
    let slopes = &found["mean_square_slope"];
    assert!(slopes["resolved"].as_f64().unwrap() < slopes["total"].as_f64().unwrap());
    near(&found["whitecap_cover"], 3.84e-6 * 8.0_f64.powf(3.41), 1e-9);
    let cascade = &found["cascades"][0];
    assert_eq!((&cascade["tile_size_m"], &cascade["resolution"]), (&300.0.into(), &256.into()));
    near(&cascade["shortest_wavelength_m"], 2.34375, 1e-9);
    near(&cascade["longest_wavelength_m"], 300.0, 1e-9);
    near(&cascade["m0_m2"], 0.25, 0.005);
    assert_eq!(found["warnings"], serde_json::json!([]));
}

#[test]
fn variances_of_systems_add() {
    let folder = tempfile::tempdir().unwrap();
    let (sea, swell) = ("wind_speed_mps = 8.0\nfrom_deg = 340.0", "wind_speed_mps = 9.0\nfrom_deg = 200.0");
    let (sea_3, swell_4) =
        (format!("{sea}\nsignificant_height_m = 0.3"), format!("{swell}\nsignificant_height_m = 0.4"));
    let tile = "tile_size_m = 500.0\nresolution = 128";
    let found = spectrum(folder.path(), &[scene(folder.path(), tile, &[&sea_3, &swell_4])]);
    for column in ["requested", "theory", "surface"] {
        near(&found[column]["significant_height_m"], 0.5, 0.012);
    }
    assert_eq!(found["requested"]["mean_direction_from_deg"], Value::Null, "two have no one direction");
    assert_eq!(found["systems"][1]["significant_height_m"], 0.4);
    assert_eq!(found["wind_speed_mps"], 9.0);
    let half_said = spectrum(folder.path(), &[scene(folder.path(), tile, &[sea, &swell_4])]);
    assert_eq!(half_said["requested"]["significant_height_m"], Value::Null);
}

#[test]
fn another_seed_is_another_surface_of_the_same_spectrum() {
    let folder = tempfile::tempdir().unwrap();
    let (eleven, eight) = (spectrum(folder.path(), &[]), spectrum(folder.path(), &["--seed", "8"]));
    assert_eq!(eleven["theory"], eight["theory"]);
    assert_ne!(eleven["surface"], eight["surface"]);
    assert_ne!(eleven["surface"], spectrum(folder.path(), &["--time", "3"])["surface"]);
    assert_eq!(eleven, spectrum(folder.path(), &["spectral-ocean", "--seed", "11", "--time", "0"]));
}

#[test]
fn a_tile_that_is_too_small_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let name = scene(folder.path(), "tile_size_m = 45.0", &["wind_speed_mps = 9.0\nfrom_deg = 0.0"]);
    let told = stdout(&whitecap(folder.path()).args(["spectrum", name]).assert().success());
    let warning = "warning: sea.system[0]: its tiles carry ";
    assert!(told.contains(warning) && told.contains("sea.tile_size_m = 509 and sea.resolution = "), "{told}");
}

#[test]
fn people_get_a_table() {
    let folder = tempfile::tempdir().unwrap();
    let told = stdout(&whitecap(folder.path()).args(["spectrum", "meshuggah"]).assert().success());
    for words in ["requested", "theory", "surface", "Hs, m", "1.728", "250.0", "tile of 150.0 m, 64 samples"]
    {
        assert!(told.contains(words), "{words} is missing from:\n{told}");
    }
}

/// A sea state, or a height by itself, has the wind of the fully developed sea; a swell has none, and says so.
#[test]
fn whitecaps_have_a_wind_or_a_reason() {
    let folder = tempfile::tempdir().unwrap();
    let tile = "tile_size_m = 600.0\nresolution = 256";
    for said in ["sea_state = 5", "significant_height_m = 3.25"] {
        let name = scene(folder.path(), tile, &[&format!("{said}\nfrom_deg = 0.0")]);
        let found = spectrum(folder.path(), &[name]);
        // 0.02133 U19.5²: 3.25 m at 12.34 m/s, 12.03 m/s at 10 m.
        near(&found["wind_speed_mps"], 12.03, 0.01);
        near(&found["whitecap_cover"], 3.84e-6 * 12.03_f64.powf(3.41), 1e-4);
        let told = stdout(&whitecap(folder.path()).args(["spectrum", name]).assert().success());
        assert!(told.contains("at 12.0 m/s, the wind of the fully developed sea"), "{told}");
    }
    let swell = "significant_height_m = 1.0\npeak_period_s = 10.0\nfrom_deg = 0.0";
    let name = scene(folder.path(), tile, &[swell]);
    assert_eq!(spectrum(folder.path(), &[name])["whitecap_cover"], Value::Null);
    let told = stdout(&whitecap(folder.path()).args(["spectrum", name]).assert().success());
    assert!(told.contains("no whitecap cover: no system says its wind"), "{told}");
}

#[test]
fn a_sea_without_a_spectrum_has_a_surface_only() {
    let folder = tempfile::tempdir().unwrap();
    for scene in ["ocean-water", "projected-grid", "five-sample"] {
        let found = spectrum(folder.path(), &[scene]);
        assert_eq!((&found["theory"], &found["cascades"]), (&Value::Null, &serde_json::json!([])), "{scene}");
        assert!(found["warnings"][0].as_str().unwrap().contains("has no spectrum"), "{found}");
        let opened = whitecap_scene::open(scene).unwrap();
        let expected = opened.sea.build(opened.seed).unwrap().variance_m2();
        // Noise repeats, and one square of it need not be like the next.
        near(&found["surface"]["m0_m2"], expected, 0.2 * expected);
        let assert = whitecap(folder.path()).args(["spectrum", scene, "-o", "a.svg"]).assert().code(2);
        assert!(sentence(&assert).contains("has no spectrum to draw"), "{}", stderr(&assert));
    }
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn the_picture_shows_both_seas_and_where_they_come_from() {
    let folder = tempfile::tempdir().unwrap();
    let tile = "tile_size_m = 300.0\nresolution = 64";
    for (from_deg, east, south) in [(250, false, true), (20, true, false)] {
        let name = scene(folder.path(), tile, &[&format!("wind_speed_mps = 9.0\nfrom_deg = {from_deg}.0")]);
        let arguments = ["spectrum", name, "-o", "chart.PNG"];
        whitecap(folder.path()).args(arguments).assert().success();
        let picture = image::open(folder.path().join("chart.PNG")).unwrap().into_rgb8();
        assert_eq!(picture.dimensions(), (1200, 800));
        let count = |color: [u8; 3]| picture.pixels().filter(|pixel| pixel.0 == color).count();
        assert!((500..20_000).contains(&count([20, 98, 168])), "the lines of theory");
        assert!((500..20_000).contains(&count([214, 92, 32])), "the marks of the surface");
        assert!((1000..20_000).contains(&count([28, 39, 51])), "letters");
        assert!(count([255, 255, 255]) > 480_000, "paper");
        // The darkest cells of the compass, about its middle.
        let dark: Vec<(u32, u32)> = picture
            .enumerate_pixels()
            .filter(|(x, _, pixel)| *x > 660 && pixel[0] < 13 && pixel[1] < 70)
            .filter(|(_, y, _)| *y < 620)
            .map(|(x, y, _)| (x, y))
            .collect();
        assert!(dark.len() > 300, "{}", dark.len());
        let mean = |side: fn(&(u32, u32)) -> u32| dark.iter().map(side).sum::<u32>() / dark.len() as u32;
        let middle = (1290 + 545) / 2;
        assert_eq!((mean(|at| at.0) > middle, mean(|at| at.1) > MIDDLE_Y), (east, south), "from {from_deg}");
    }
}

/// Where the compass has its middle, in pixels from above.
const MIDDLE_Y: u32 = 375;

#[test]
fn the_drawing_is_whole_xml_with_its_axes_named() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("a & <b>.toml"),
        whitecap_scene::named::find("meshuggah").unwrap().toml,
    )
    .unwrap();
    whitecap(folder.path()).args(["spectrum", "a & <b>.toml", "-o", "chart.svg"]).assert().success();
    assert_eq!(names_in(folder.path()), ["a & <b>.toml", "chart.svg"]);
    let text = std::fs::read_to_string(folder.path().join("chart.svg")).unwrap();
    let mut open = Vec::new();
    for piece in text.split('<').skip(1) {
        let (tag, after) = piece.split_once('>').unwrap();
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        assert!(!after.contains('>'), "{after}");
        for entity in after.split('&').skip(1) {
            assert!(
                ["amp;", "lt;", "gt;", "quot;", "apos;"].iter().any(|e| entity.starts_with(e)),
                "{after}"
            );
        }
        match tag.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name)),
            None if tag.ends_with('/') => {}
            None => open.push(tag.split_whitespace().next().unwrap()),
        }
    }
    assert!(open.is_empty(), "{open:?}");
    assert!(text.starts_with("<svg width=\"1200\" height=\"800\" viewBox=\"0 0 2400 1600\""));
    for words in
        ["frequency, Hz", "S(f), m²/Hz", "% per degree", "clockwise from north", "\nN\n", "Hs 1.73 m"]
    {
        assert!(text.contains(words), "{words:?} is missing");
    }
}

#[test]
fn a_chart_that_cannot_be_written_is_refused_before_any_work() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["spectrum", "-o", "absent/chart.svg", "--json"];
    let assert = whitecap(folder.path()).args(arguments).assert().code(2);
    assert!(sentence(&assert).contains("the folder absent does not exist"), "{}", stderr(&assert));
    assert_eq!(json(&assert)["error"], sentence(&assert).as_str());
    std::fs::create_dir(folder.path().join("folder.png")).unwrap();
    let assert = whitecap(folder.path()).args(["spectrum", "-o", "folder.png"]).assert().code(2);
    assert!(sentence(&assert).contains("folder.png is a folder"), "{}", stderr(&assert));
    assert_eq!(stdout(&assert), "");
}

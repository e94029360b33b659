//! What a user reads when a scene is wrong: each message whole, to the letter.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use whitecap_scene::Scene;

/// A scene with every table; the cases change one line of it.
const SCENE: &str = r#"technique = "meshuggah"
seed = 7

[sea]
tile_size_m = 100.0
resolution = 64
amplitudes = "deterministic"

[[sea.system]]
spectrum = "phillips"
wind_speed_mps = 8.0
from_deg = 250.0

[meshuggah]
tile_repeats = 4
fresnel = "per-pixel"

[sky]
kind = "atmosphere"
sun_elevation_deg = 18.0

[camera]
position_m = [0.0, 4.0, 0.0]
look_at_m = [-200.0, 0.0, 50.0]
"#;

/// The message for the scene with `line` in place of the line that begins with `begins`.
fn message(begins: &str, line: &str) -> String {
    assert_eq!(SCENE.lines().filter(|l| l.starts_with(begins)).count(), 1, "{begins}");
    let changed = |l| if str::starts_with(l, begins) { line } else { l };
    let text = SCENE.lines().map(changed).collect::<Vec<_>>().join("\n");
    message_for(&text)
}

fn message_for(text: &str) -> String {
    Scene::from_toml(text, "storm.toml").unwrap_err().to_string()
}

#[test]
fn the_scene_itself_is_good() {
    Scene::from_toml(SCENE, "storm.toml").unwrap();
}

#[test]
fn numbers_out_of_range() {
    for (line, found) in [
        ("wind_speed_mps = -3", "-3"),
        ("wind_speed_mps = nan", "nan"),
        ("wind_speed_mps = inf", "inf"),
        ("wind_speed_mps = 1e999", "1e999"),
        ("wind_speed_mps = 80.1", "80.1"),
    ] {
        assert_eq!(
            message("wind_speed_mps", line),
            format!(
                "storm.toml:11: sea.system[0].wind_speed_mps = {found}: out of range; accepted: 0.1 to 50 m/s"
            )
        );
    }
    assert_eq!(
        message("tile_repeats", "tile_repeats = 17"),
        "storm.toml:15: meshuggah.tile_repeats = 17: out of range; accepted: 1 to 16"
    );
    for seed in ["-1", "9223372036854775808", "0xffff_ffff_ffff_ffff_ffff_ffff_ffff_ffff_ffff"] {
        assert_eq!(
            message("seed", &format!("seed = {seed}")),
            format!("storm.toml:2: seed = {seed}: out of range; accepted: 0 to 9223372036854775807")
        );
    }
    assert_eq!(
        message("resolution", "resolution = 100"),
        "storm.toml:6: sea.resolution = 100: not one of the accepted sizes: \
         16, 32, 64, 128, 256, 512, 1024, 2048"
    );
    assert_eq!(
        message("position_m", "position_m = [0, inf, 0]"),
        "storm.toml:23: camera.position_m[1] = inf: out of range; accepted: -100 to 100000 m"
    );
}

/// A scene of the ocean with these lines in the table.
fn ocean(table: &str, lines: &str) -> String {
    let mut text = String::from("technique = \"spectral-ocean\"\n");
    for (name, keys) in [
        ("[sea]", ""),
        ("[[sea.system]]", "spectrum = \"jonswap\"\nsea_state = 4\nfrom_deg = 9\n"),
        ("[spectral-ocean]", ""),
        ("[sky]", ""),
        ("[picture]", ""),
        ("[camera]", "position_m = [0, 4, 0]\nlook_at_m = [9, 0, 0]\n"),
    ] {
        let given = if name == table { lines } else { "" };
        let key = given.split(' ').next().unwrap_or_default();
        let others = keys.lines().filter(|line| key.is_empty() || !line.starts_with(key));
        text += &format!("{name}\n{given}\n{}\n", others.collect::<Vec<_>>().join("\n"));
    }
    message_for(&text)
}

/// Suns that are nowhere, light beyond all bounds, cameras off the Earth, seas of no tiles and of a thousand.
#[test]
fn what_the_ocean_is_refused() {
    for (table, line, refused) in [
        (
            "[sky]",
            "sun_elevation_deg = nan",
            "sky.sun_elevation_deg = nan: out of range; accepted: -10 to 90 deg",
        ),
        (
            "[sky]",
            "sun_elevation_deg = -11",
            "sky.sun_elevation_deg = -11: out of range; accepted: -10 to 90 deg",
        ),
        (
            "[sky]",
            "sun_elevation_deg = 90.5",
            "sky.sun_elevation_deg = 90.5: out of range; accepted: -10 to 90 deg",
        ),
        ("[sky]", "sun_azimuth_deg = inf", "sky.sun_azimuth_deg = inf: out of range; accepted: 0 to 360 deg"),
        ("[sky]", "sun_azimuth_deg = -1", "sky.sun_azimuth_deg = -1: out of range; accepted: 0 to 360 deg"),
        ("[sky]", "haze = -1", "sky.haze = -1: out of range; accepted: 0 to 20"),
        ("[sky]", "cloud_cover = 1.1", "sky.cloud_cover = 1.1: out of range; accepted: 0 to 1"),
        ("[sky]", "exposure_ev = 1e999", "sky.exposure_ev = 1e999: out of range; accepted: -20 to 20 EV"),
        ("[sky]", "exposure_ev = -21", "sky.exposure_ev = -21: out of range; accepted: -20 to 20 EV"),
        (
            "[picture]",
            "exposure_ev100 = -1000",
            "picture.exposure_ev100 = -1000: out of range; accepted: -10 to 30 EV",
        ),
        (
            "[picture]",
            "exposure_ev100 = nan",
            "picture.exposure_ev100 = nan: out of range; accepted: -10 to 30 EV",
        ),
        (
            "[picture]",
            "tone_map = \"agy\"",
            "picture.tone_map = \"agy\": no such choice; did you mean \"agx\"? accepted: \"agx\", \"aces\", \
             \"pbr-neutral\", \"none\"",
        ),
        (
            "[camera]",
            "position_m = [1e9, 4, 0]",
            "camera.position_m[0] = 1e9: out of range; accepted: -10000000 to 10000000 m",
        ),
        (
            "[camera]",
            "position_m = [0, 1e9, 0]",
            "camera.position_m[1] = 1e9: out of range; accepted: -100 to 100000 m",
        ),
        (
            "[camera]",
            "look_at_m = [0, 0, nan]",
            "camera.look_at_m[2] = nan: out of range; accepted: -10000000 to 10000000 m",
        ),
        (
            "[camera]",
            "vertical_fov_deg = 0",
            "camera.vertical_fov_deg = 0: out of range; accepted: 1 to 170 deg",
        ),
        (
            "[camera]",
            "vertical_fov_deg = 180",
            "camera.vertical_fov_deg = 180: out of range; accepted: 1 to 170 deg",
        ),
        ("[sea]", "cascades = 0", "sea.cascades = 0: out of range; accepted: 1 to 8"),
        ("[sea]", "cascades = 1000", "sea.cascades = 1000: out of range; accepted: 1 to 8"),
        ("[sea]", "cascade = []", "sea.cascade = []: found 0; accepted: 1 to 8 tables [[sea.cascade]]"),
        (
            "[spectral-ocean]",
            "absorption_per_m = [0, 1, 1]",
            "spectral-ocean.absorption_per_m[0] = 0: out of range; accepted: 0.0001 to 10 1/m",
        ),
        (
            "[spectral-ocean]",
            "scattering_per_m = [1, 1, inf]",
            "spectral-ocean.scattering_per_m[2] = inf: out of range; accepted: 0.0001 to 10 1/m",
        ),
        (
            "[spectral-ocean]",
            "bottom_albedo = [1, 1.5, 1]",
            "spectral-ocean.bottom_albedo[1] = 1.5: out of range; accepted: 0 to 1",
        ),
        (
            "[spectral-ocean]",
            "visibility_km = 0",
            "spectral-ocean.visibility_km = 0: out of range; accepted: 0.1 to 1000000 km",
        ),
        (
            "[spectral-ocean]",
            "curvature_radius_km = -6371",
            "spectral-ocean.curvature_radius_km = -6371: out of range; accepted: 1 to 1000000 km",
        ),
    ] {
        let message = ocean(table, line);
        let (place, said) = message.split_once(": ").unwrap();
        assert!(place.starts_with("storm.toml:"), "{message}");
        assert_eq!(said, refused);
    }
    let thousand =
        (0..1000).map(|i| format!("{{ tile_size_m = {}.5 }}", i + 10)).collect::<Vec<_>>().join(", ");
    let message = ocean("[sea]", &format!("cascade = [{thousand}]"));
    assert!(message.contains("found 1000; accepted: 1 to 8 tables [[sea.cascade]]"), "{message}");
    // Foam follows from the sea: it has no keys.
    let message = message_for("technique = \"spectral-ocean\"\n[foam]\ncover = nan\n");
    assert!(message.starts_with("storm.toml:2: foam: unknown key; accepted here: "), "{message}");
}

#[test]
fn an_element_of_an_array_has_its_own_line() {
    assert_eq!(
        message("tile_repeats", "deep_color = [1,\n 0.1,\n 2]"),
        "storm.toml:17: meshuggah.deep_color[2] = 2: out of range; accepted: 0 to 1"
    );
}

#[test]
fn wrong_types() {
    assert_eq!(
        message("wind_speed_mps", "wind_speed_mps = \"fresh\""),
        "storm.toml:11: sea.system[0].wind_speed_mps = \"fresh\": found a string, wanted a number; \
         accepted: 0.1 to 50 m/s"
    );
    assert_eq!(
        message("resolution", "resolution = 64.0"),
        "storm.toml:6: sea.resolution = 64.0: found a float, wanted an integer; \
         accepted: 16, 32, 64, 128, 256, 512, 1024, 2048"
    );
    assert_eq!(
        message("seed", "seed = 1979-05-27"),
        "storm.toml:2: seed = 1979-05-27: found a date or time, wanted an integer; \
         accepted: 0 to 9223372036854775807"
    );
    assert_eq!(
        message("technique", "technique = 3"),
        "storm.toml:1: technique = 3: found an integer, wanted a string; \
         accepted: \"ocean-water\", \"rippling-lake\", \"projected-grid\", \"meshuggah\", \"five-sample\", \
         \"spectral-ocean\""
    );
    assert_eq!(
        message("tile_repeats", "deep_color = [1, 0.1]"),
        "storm.toml:15: meshuggah.deep_color = [1, 0.1]: found 2 elements, wanted 3; \
         accepted: [red, green, blue], each 0 to 1"
    );
    assert_eq!(message_for("sea = 3"), "storm.toml:1: sea = 3: found an integer, wanted a table");
    assert_eq!(
        message("[[sea.system]]", "[sea.system]"),
        "storm.toml:9: sea.system: found a table, wanted 1 or more tables [[sea.system]]"
    );
    assert_eq!(
        message_for("sea.system = [3]"),
        "storm.toml:1: sea.system[0] = 3: found an integer, wanted a table"
    );
}

#[test]
fn a_technique_without_a_tone_map_has_no_picture() {
    assert_eq!(
        message("[meshuggah]", "[picture]\n[meshuggah]"),
        "storm.toml:14: picture: the technique \"meshuggah\" works on display values, which nothing maps; accepted: \
         no [picture] table, sky.exposure_ev sets its exposure"
    );
}

#[test]
fn unknown_keys() {
    assert_eq!(
        message("tile_size_m", "tile_sise_m = 100.0"),
        "storm.toml:5: sea.tile_sise_m: unknown key; did you mean \"tile_size_m\"? \
         accepted here: amplitudes, cascade, cascades, choppiness, current_mps, current_toward_deg, depth_m, loop_s, \
         model, resolution, shortest_wave_m, surface_tension, system, tile_size_m"
    );
    assert_eq!(
        message("[meshuggah]", "[meshuga]"),
        "storm.toml:14: meshuga: unknown key; did you mean \"meshuggah\"? \
         accepted here: camera, five-sample, meshuggah, object, ocean-water, picture, projected-grid, \
         rippling-lake, sea, seed, sky, spectral-ocean, technique"
    );
    assert_eq!(
        message("position_m", "\"two\\nlines\" = 1"),
        "storm.toml:23: camera.\"two\\nlines\": unknown key; \
         accepted here: look_at_m, position_m, vertical_fov_deg"
    );
}

#[test]
fn a_key_of_another_kind() {
    assert_eq!(
        message("kind", "kind = \"panorama\""),
        "storm.toml:20: sky.sun_elevation_deg: only with kind = \"atmosphere\", but here kind = \"panorama\"; \
         accepted here: exposure_ev, file, kind, yaw_deg"
    );
}

#[test]
fn unknown_words() {
    assert_eq!(
        message("technique", "technique = \"meshugah\""),
        "storm.toml:1: technique = \"meshugah\": no such technique; did you mean \"meshuggah\"? \
         accepted: \"ocean-water\", \"rippling-lake\", \"projected-grid\", \"meshuggah\", \"five-sample\", \
         \"spectral-ocean\""
    );
    assert_eq!(
        message("spectrum", "spectrum = \"brown\""),
        "storm.toml:10: sea.system[0].spectrum = \"brown\": no such spectrum; accepted: \
         \"pierson-moskowitz\", \"jonswap\", \"tma\", \"elfouhaily\", \"phillips\""
    );
    assert_eq!(
        message("fresnel", "fresnel = \"PerPixel\""),
        "storm.toml:16: meshuggah.fresnel = \"PerPixel\": no such choice; did you mean \"per-pixel\"? \
         accepted: \"per-vertex-split\", \"per-pixel\""
    );
}

/// Each technique draws seas of its own.
#[test]
fn a_sea_of_another_technique() {
    assert_eq!(
        message("tile_size_m", "model = \"perlin\""),
        "storm.toml:5: sea.model = \"perlin\": not a sea that technique = \"meshuggah\" draws; \
         accepted: \"spectral\""
    );
    let text = "technique = \"ocean-water\"\n[sea]\nmodel = \"perlin\"\n";
    assert_eq!(
        message_for(text),
        "storm.toml:3: sea.model = \"perlin\": not a sea that technique = \"ocean-water\" draws; \
         accepted: \"sines\""
    );
    // Before its settings are missed, which would not help.
    let text = "technique = \"ocean-water\"\n[sea]\nmodel = \"spectral\"\n";
    assert!(message_for(text).starts_with("storm.toml:3: sea.model = \"spectral\": not a sea that"));
    let text = "technique = \"ocean-water\"\n[[sea.wave]]\nheight = 3\n";
    assert_eq!(message_for(text), "storm.toml:2: sea.wave: found 1; accepted: 4 tables [[sea.wave]]");
}

#[test]
fn objects() {
    let after = |object: &str| message_for(&format!("{SCENE}[[object]]\n{object}"));
    assert_eq!(
        after("mesh = \"duk\""),
        "storm.toml:26: object[0].mesh = \"duk\": no such choice; did you mean \"duck\"? \
         accepted: \"island\", \"duck\", \"lake-bed\", \"posts\", \"trees\""
    );
    assert_eq!(
        after("scale = 2"),
        "storm.toml:25: object[0]: has neither mesh nor file; accepted: one of the two"
    );
    assert_eq!(
        after("mesh = \"duck\"\nfile = \"a.glb\""),
        "storm.toml:27: object[0].file = \"a.glb\": beside mesh; accepted: one of the two, mesh or file"
    );
    assert_eq!(
        after("mesh = \"duck\"\nfloats = 1"),
        "storm.toml:27: object[0].floats = 1: found an integer, wanted a boolean; accepted: true, false"
    );
}

#[test]
fn missing_keys_and_tables() {
    assert_eq!(
        message("from_deg", ""),
        "storm.toml:9: sea.system[0].from_deg: missing; required: 0 to 360 deg"
    );
    assert_eq!(
        message("look_at_m", ""),
        "storm.toml:22: camera.look_at_m: missing; required: [x, y, z], x -10000000 to 10000000, \
         y -10000000 to 10000000, z -10000000 to 10000000 m"
    );
    assert_eq!(message_for(""), "storm.toml: sea.system: missing; required: 1 or more tables [[sea.system]]");
    assert_eq!(
        message_for("\n[sea]\n"),
        "storm.toml:2: sea.system: missing; required: 1 or more tables [[sea.system]]"
    );
    assert_eq!(
        message_for("sea.system = []"),
        "storm.toml:1: sea.system = []: found 0; accepted: 1 or more tables [[sea.system]]"
    );
}

#[test]
fn contradictions() {
    assert_eq!(
        message("tile_size_m", "tile_size_m = 1"),
        "storm.toml:5: sea.tile_size_m = 1: one tile carries only 0 % of the energy of wave system 0: 64 \
         samples a side and 1 m hold waves from 0.03 to 1.0 m, and its peak is at 50.2 m; sea.tile_size_m = 402 and \
         sea.resolution = 256 hold them"
    );
    assert_eq!(
        message("from_deg", "from_deg = 250.0\nsmall_wave_cutoff_m = 9.5"),
        "storm.toml:13: sea.system[0].small_wave_cutoff_m = 9.5: 9.5 is out of range for this sea; \
         accepted: at least 0 and at most U²/g"
    );
    assert_eq!(
        message("tile_repeats", "scattering_per_m = [1, 0.1, 0.1]"),
        "storm.toml:14: meshuggah.extinction_per_m: less than scattering_per_m = [1.0, 0.1, 0.1]; \
         accepted: extinction is scattering plus absorption"
    );
    assert_eq!(
        message("look_at_m", "look_at_m = [0, 4, 0]"),
        "storm.toml:24: camera.look_at_m = [0, 4, 0]: the same place as position_m; \
         accepted: at least 0.001 m away from it"
    );
}

#[test]
fn a_current_has_a_speed() {
    assert_eq!(
        message("amplitudes", "current_toward_deg = 90"),
        "storm.toml:7: sea.current_toward_deg = 90: without current_mps; accepted: both or none of them, as a \
         current has a speed"
    );
    let still = SCENE.replace("amplitudes", "current_mps = 0\ncurrent_toward_deg = 90\namplitudes");
    Scene::from_toml(&still, "storm.toml").unwrap();
}

/// What is wrong with the tiles is said under the keys of the tables that the file has.
#[test]
fn tiles_that_do_not_hold_the_sea() {
    let with = |tiles: &str| {
        let start =
            "technique = \"spectral-ocean\"\n[sea]\n[[sea.system]]\nspectrum = \"jonswap\"\nfrom_deg = 9\n";
        let camera = "[camera]\nposition_m = [0, 4, 0]\nlook_at_m = [9, 0, 0]\n";
        let sea = "significant_height_m = 3\npeak_period_s = 9\n";
        Scene::from_toml(&format!("{start}{sea}{tiles}{camera}"), "storm.toml")
    };
    let tile = |size_m: f64, resolution: u32| {
        format!("[[sea.cascade]]\ntile_size_m = {size_m:?}\nresolution = {resolution}\n")
    };
    let refused = |tiles: &str| with(tiles).unwrap_err().to_string();
    assert_eq!(
        refused(&(tile(7.0, 64) + &tile(20.0, 64))),
        "storm.toml:12: sea.cascade[1].tile_size_m = 20.0: the 2 tiles carry only 6 % of the energy of wave system 0: \
         its waves are too long; a tile of 510 m is large enough"
    );
    assert_eq!(
        refused(&tile(20.0, 64)),
        "storm.toml:9: sea.cascade[0].tile_size_m = 20.0: a tile of 20 m with 64 samples a side carries only 6 % of \
         the energy of wave system 0: its waves are too long; a tile of 510 m is large enough"
    );
    let message = refused(&(tile(9000.0, 16) + &tile(5000.0, 16)));
    assert!(
        message.starts_with("storm.toml:13: sea.cascade[1].resolution = 16: the 2 tiles carry only"),
        "{message}"
    );
    // And where only a part is lost.
    let warned = |tiles: &str| with(tiles).unwrap().warnings.join("\n");
    let message = warned(&(tile(30.0, 64) + &tile(80.0, 64)));
    assert!(message.contains("too long for a tile of 80 m; sea.cascade[1].tile_size_m = "), "{message}");
    let message = warned(&(tile(800.0, 64) + &tile(600.0, 32)));
    assert!(message.contains("a greater sea.cascade[1].resolution or one more [[sea.cascade]]"), "{message}");
}

/// Bands that are given: what no tile holds, what two carry, and what none does.
#[test]
fn bands_of_tiles() {
    let with = |tiles: &[&str]| {
        let start =
            "technique = \"spectral-ocean\"\n[sea]\n[[sea.system]]\nspectrum = \"jonswap\"\nfrom_deg = 9\n";
        let sea = "significant_height_m = 3\npeak_period_s = 9\n";
        let tiles: String =
            tiles.iter().map(|tile| format!("[[sea.cascade]]\n{}\n", tile.replace("; ", "\n"))).collect();
        let camera = "[camera]\nposition_m = [0, 4, 0]\nlook_at_m = [9, 0, 0]\n";
        Scene::from_toml(&format!("{start}{sea}{tiles}{camera}"), "storm.toml")
    };
    let refused = |tiles: &[&str]| with(tiles).unwrap_err().to_string();
    let warned = |tiles: &[&str]| with(tiles).unwrap().warnings.join("\n");
    const LARGE: &str = "tile_size_m = 1200.0";
    for tiles in [
        &["tile_size_m = 1200.0; shortest_wave_m = 20.0", "tile_size_m = 120.0; longest_wave_m = 20.0"][..],
        &["tile_size_m = 120.0; longest_wave_m = 60.0", LARGE],
        &["tile_size_m = 1200.0; longest_wave_m = 1200.0; shortest_wave_m = 9.375"],
        &["tile_size_m = 1200.0; shortest_wave_m = 20.0", "tile_size_m = 120.0; shortest_wave_m = 2.0"],
    ] {
        assert_eq!(warned(tiles), "", "{tiles:?}");
    }
    for (tile, found) in [
        ("longest_wave_m = 150.1", "storm.toml:11: sea.cascade[0].longest_wave_m = 150.1"),
        ("shortest_wave_m = 2.2", "storm.toml:11: sea.cascade[0].shortest_wave_m = 2.2"),
        ("shortest_wave_m = 200", "storm.toml:11: sea.cascade[0].shortest_wave_m = 200"),
    ] {
        let held = "not held by this tile; 150 m with 128 samples a side hold waves from 2.34375 to 150 m";
        assert_eq!(
            refused(&[&format!("tile_size_m = 150; resolution = 128; {tile}")]),
            format!("{found}: {held}")
        );
    }
    let twice = "both carry waves from 20 to 30 m, whose energy would count twice; accepted: bands apart, by longest_wave_m and \
                 shortest_wave_m";
    assert!(
        refused(&["tile_size_m = 120; longest_wave_m = 30", "tile_size_m = 1200; shortest_wave_m = 20"])
            .ends_with(&format!("sea.cascade[1] and sea.cascade[0] {twice}"))
    );
    let message = refused(&["tile_size_m = 120; longest_wave_m = 20; shortest_wave_m = 20"]);
    assert!(message.contains("sea.cascade[0].shortest_wave_m = 20: "), "{message}");
    let message =
        refused(&["tile_size_m = 1200; shortest_wave_m = 10", "tile_size_m = 120; shortest_wave_m = 15"]);
    assert!(message.contains("sea.cascade[1] has no waves left from 10 m down"), "{message}");

    let message =
        warned(&["tile_size_m = 1200; shortest_wave_m = 60", "tile_size_m = 120; longest_wave_m = 40"]);
    assert!(message.contains("waves from 40 to 60 m are in no band, "), "{message}");
    assert!(message.contains("% of its energy; sea.cascade[1].longest_wave_m = 60 holds them"), "{message}");
    let message = warned(&["tile_size_m = 1200; shortest_wave_m = 70", "tile_size_m = 20"]);
    assert!(message.contains("waves from 20 to 70 m are in no band"), "{message}");
    assert!(message.contains("sea.cascade[0].shortest_wave_m = 20 holds them"), "{message}");
    let message = warned(&["tile_size_m = 1200; longest_wave_m = 200"]);
    assert!(message.contains("waves from 200 to 1200 m are in no band"), "{message}");
    assert!(message.contains("sea.cascade[0].longest_wave_m = 1200 holds them"), "{message}");
    let message = warned(&["tile_size_m = 1200; shortest_wave_m = 60"]);
    assert!(message.contains("waves from 18.75 to 60 m are in no band"), "{message}");
    // Less than half of the energy.
    let message = refused(&["tile_size_m = 1200; longest_wave_m = 80"]);
    assert!(message.contains("sea.cascade: the tiles carry only "), "{message}");
    assert!(message.contains("waves from 80 to 1200 m are in no band"), "{message}");
}

/// A scene whose only wave system has these lines.
fn system(lines: &str) -> String {
    format!("[sea]\ntile_size_m = 400.0\nresolution = 256\n[[sea.system]]\nfrom_deg = 250.0\n{lines}\n")
}

#[test]
fn a_wave_system_says_how_high_it_is_in_one_way() {
    let after = |lines: &str| message_for(&system(lines));
    assert_eq!(
        after("spectrum = \"jonswap\""),
        "storm.toml:4: sea.system[0]: does not say how high its waves are; accepted: one of wind_speed_mps, \
         significant_height_m, sea_state, beaufort"
    );
    for (spectrum, first, second, found) in [
        ("jonswap", "wind_speed_mps", "significant_height_m", "2"),
        ("jonswap", "wind_speed_mps", "sea_state", "2"),
        ("tma", "significant_height_m", "beaufort", "2"),
        ("pierson-moskowitz", "sea_state", "beaufort", "2"),
        ("elfouhaily", "wind_speed_mps", "beaufort", "2"),
        ("phillips", "wind_speed_mps", "sea_state", "2"),
        ("phillips", "significant_height_m", "beaufort", "2"),
    ] {
        assert_eq!(
            after(&format!("spectrum = \"{spectrum}\"\n{first} = 4\n{second} = {found}")),
            format!(
                "storm.toml:8: sea.system[0].{second} = {found}: beside {first}, which says how high the waves \
                 are; remove one of the two"
            )
        );
    }
    assert_eq!(
        after("spectrum = \"jonswap\"\nsignificant_height_m = 2\nfetch_km = 100"),
        "storm.toml:8: sea.system[0].fetch_km = 100: beside significant_height_m, but only with \
         wind_speed_mps or beaufort; remove fetch_km, or give wind_speed_mps or beaufort instead of \
         significant_height_m"
    );
    for spectrum in ["pierson-moskowitz", "jonswap", "phillips"] {
        assert_eq!(
            after(&format!("spectrum = \"{spectrum}\"\nwind_speed_mps = 9\npeak_period_s = 8")),
            "storm.toml:8: sea.system[0].peak_period_s = 8: beside wind_speed_mps, but only with \
             significant_height_m; remove peak_period_s, or give significant_height_m instead of wind_speed_mps"
        );
    }
    assert!(after("spectrum = \"pierson-moskowitz\"\nsea_state = 4\nfetch_km = 100").starts_with(
        "storm.toml:8: sea.system[0].fetch_km: only with spectrum = \"jonswap\", \"tma\" or \"elfouhaily\", but here \
         spectrum = \"pierson-moskowitz\"; "
    ));
    assert!(after("spectrum = \"phillips\"\nsea_state = 4\ngamma = 2").starts_with(
        "storm.toml:8: sea.system[0].gamma: only with spectrum = \"jonswap\" or \"tma\", but here spectrum = \
         \"phillips\"; "
    ));
}

#[test]
fn absurd_waves() {
    let after = |line: &str| {
        let lead = if line.contains("height") { "" } else { "significant_height_m = 2\n" };
        message_for(&system(&format!("spectrum = \"jonswap\"\n{lead}{line}")))
    };
    for (key, found, accepted) in [
        ("significant_height_m", "-1", "0.01 to 40 m"),
        ("significant_height_m", "0", "0.01 to 40 m"),
        ("significant_height_m", "90", "0.01 to 40 m"),
        ("peak_period_s", "-8", "0.5 to 40 s"),
        ("peak_period_s", "0", "0.5 to 40 s"),
        ("peak_period_s", "nan", "0.5 to 40 s"),
        ("gamma", "0.5", "1 to 10"),
        ("gamma", "-3.3", "1 to 10"),
        ("gamma", "11", "1 to 10"),
        ("fetch_km", "-100", "0.01 to 20000 km"),
        ("fetch_km", "0", "0.01 to 20000 km"),
        ("fetch_km", "1e9", "0.01 to 20000 km"),
        ("sea_state", "10", "0 to 9"),
        ("sea_state", "-1", "0 to 9"),
        ("beaufort", "13", "0 to 12"),
        ("swell", "1.5", "0 to 1"),
    ] {
        let line = if key == "significant_height_m" { 7 } else { 8 };
        assert_eq!(
            after(&format!("{key} = {found}")),
            format!("storm.toml:{line}: sea.system[0].{key} = {found}: out of range; accepted: {accepted}")
        );
    }
}

#[test]
fn spreadings() {
    let after = |spreading: &str| {
        message_for(&system(&format!("spectrum = \"jonswap\"\nsea_state = 4\nspreading = {spreading}")))
    };
    let accepted = "accepted: \"cos2\", \"mitsuyasu\", \"hasselmann\", \"donelan-banner\", \"elfouhaily\"";
    assert_eq!(
        after("\"haselmann\""),
        format!(
            "storm.toml:8: sea.system[0].spreading = \"haselmann\": no such spreading; did you mean \
             \"hasselmann\"? {accepted}"
        )
    );
    assert_eq!(
        after("25"),
        format!(
            "storm.toml:8: sea.system[0].spreading = 25: found an integer, wanted a string or a table; \
             {accepted}, {{ cos2s = 0 to 1000 }}"
        )
    );
    assert_eq!(
        after("{ cos2s = -1 }"),
        "storm.toml:8: sea.system[0].spreading.cos2s = -1: out of range; accepted: 0 to 1000"
    );
    assert_eq!(after("{}"), "storm.toml:8: sea.system[0].spreading.cos2s: missing; required: 0 to 1000");
    assert_eq!(
        after("{ s = 3 }"),
        "storm.toml:8: sea.system[0].spreading.s: unknown key; accepted here: cos2s"
    );
}

#[test]
fn a_shallow_spectrum_over_deep_water() {
    let camera = "[camera]\nposition_m = [0, 4, 0]\nlook_at_m = [9, 0, 0]";
    let message = message_for(&system(&format!("spectrum = \"tma\"\nsea_state = 4\n{camera}")));
    assert!(message.ends_with("this spectrum is that of shallow water; set depth_m"), "{message}");
}

#[test]
fn text_that_is_not_toml() {
    assert_eq!(
        message("sun_elevation_deg", "sun_elevation_deg = 18.0.1"),
        "storm.toml:20:25: not valid TOML: invalid float, expected nothing"
    );
    assert_eq!(
        message("sun_elevation_deg", "sun_elevation_deg = 18.0\nsun_elevation_deg = 3"),
        "storm.toml:21:1: not valid TOML: duplicate key"
    );
    assert_eq!(message_for("technique"), "storm.toml:1:10: not valid TOML: key with no value, expected `=`");
}

#[test]
fn what_is_quoted_is_short() {
    let long = "é".repeat(1000);
    assert_eq!(
        message("kind", &format!("kind = \"{long}\"")),
        format!(
            "storm.toml:19: sky.kind = \"{}…: no such sky; accepted: \"atmosphere\", \"panorama\"",
            "é".repeat(59)
        )
    );
    assert_eq!(
        message_for(&"#".repeat((1 << 20) + 1)),
        "storm.toml: longer than a scene file may be; accepted: up to 1 MiB"
    );
}

#[test]
fn the_parts_of_an_error() {
    let text = SCENE.replace("seed = 7", "seed = -7");
    let error = Scene::from_toml(&text, "storm.toml").unwrap_err();
    assert_eq!(error.file(), Some("storm.toml"));
    assert_eq!(error.line(), Some(2));
    assert_eq!(error.key(), Some("seed"));
    assert_eq!(error.found(), Some("-7"));
    assert_eq!(error.problem(), "out of range; accepted: 0 to 9223372036854775807");
}

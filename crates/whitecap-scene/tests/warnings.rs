//! Where a sea bends what was asked for, or is none that is found: its warnings, and where they end.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use whitecap_scene::Scene;

/// An OpenEXR file of 8 × 4 pixels of this light, but for two.
fn write_sky(path: &std::path::Path, odd: [f32; 2]) {
    exr::prelude::write_rgb_file(path, 8, 4, |x, y| match (x, y) {
        (0, 0) => (odd[0], 1.0, 1.0),
        (1, 0) => (1.0, odd[1], 1.0),
        _ => (1.0, 1.0, 1.0),
    })
    .unwrap();
}

/// A scene of these keys of the sea and these systems, lines apart by "; ".
fn read(sea: &str, systems: &[&str]) -> Result<Scene, String> {
    let systems = systems.iter().map(|system| format!("[[sea.system]]; from_deg = 270.0; {system}; "));
    let text = format!(
        "technique = \"spectral-ocean\"; [sea]; {sea}; {}[camera]; position_m = [0, 4, 0]; look_at_m = [9, 0, 0]",
        systems.collect::<String>()
    );
    Scene::from_toml(&text.replace("; ", "\n"), "sea").map_err(|error| error.to_string())
}

fn warnings(sea: &str, systems: &[&str]) -> Vec<String> {
    read(sea, systems).unwrap().warnings
}

/// One warning, with all of these words.
fn one(sea: &str, systems: &[&str], words: &[&str]) {
    let found = warnings(sea, systems);
    assert!(found.len() == 1 && words.iter().all(|word| found[0].contains(word)), "{sea}: {found:?}");
}

const SWELL: &str = "spectrum = 'jonswap'; significant_height_m = 2; peak_period_s = 8";

/// Half a turn of the 8 s of the peak to a loop: 5 % of it at 80 s.
#[test]
fn loops_that_change_the_period_of_the_peak() {
    assert_eq!(warnings("loop_s = 82.0", &[SWELL]), Vec::<String>::new());
    one("loop_s = 79.0", &[SWELL], &["loop_s = 79", "sea.system[0] by up to 5 %", "81 s or more"]);
    one("loop_s = 40.0", &[SWELL], &["by up to 10 %"]);
}

/// 0.3 m/s carries waves of 100 m by 0.27 of their length in 90 s, which rounds to none.
#[test]
fn loops_that_change_the_current() {
    let still = warnings("loop_s = 90.0", &[SWELL]);
    assert_eq!(still, Vec::<String>::new());
    let words = [
        "loop_s = 90",
        "takes the current from",
        "sea.system[0]",
        "current_mps = 0.3",
        "0.27 of their lengths",
    ];
    one("loop_s = 90.0; current_mps = 0.3", &[SWELL], &words);
    one("loop_s = 900.0; current_mps = 0.3", &[SWELL], &["changes the current by up to 19 % for"]);
    assert_eq!(warnings("loop_s = 3400.0; current_mps = 0.3", &[SWELL]), Vec::<String>::new());
}

/// One tile of 64 samples: 4 % of the energy is in waves below two samples.
#[test]
fn tiles_that_do_not_hold_a_system() {
    let one_tile = |size: f64| format!("cascades = 1; resolution = 64; tile_size_m = {size:.0}");
    assert_eq!(warnings(&one_tile(400.0), &[SWELL]), Vec::<String>::new());
    one(&one_tile(700.0), &[SWELL], &["its tiles carry 9", "are too short for the samples"]);
    // Heights have the digits that tell them apart.
    let ripples = "spectrum = 'jonswap'; significant_height_m = 0.09; peak_period_s = 1.6";
    one(
        "cascades = 1; resolution = 64; tile_size_m = 28.0",
        &[ripples],
        &["m of 0.0900 m of significant height"],
    );
}

/// Variances add: what each system may be, all together may not.
#[test]
fn systems_that_are_too_much_together() {
    let high = "spectrum = 'jonswap'; significant_height_m = 40; peak_period_s = 40";
    let refused = read("choppiness = 1.0", &[high; 8]).unwrap_err();
    let words = ["sea.system: ", "113.1 m of significant height together", "accepted: up to 40 m"];
    assert!(words.iter().all(|word| refused.contains(word)), "{refused}");

    // 0.55 d each, 0.78 d both.
    let shallow = "spectrum = 'jonswap'; significant_height_m = 5.5; peak_period_s = 14";
    let found = warnings("depth_m = 10.0", &[shallow]);
    assert_eq!(found, Vec::<String>::new());
    let both = warnings("depth_m = 10.0", &[shallow; 2]);
    let [steep, high] = &both[..] else { panic!("{both:?}") };
    assert!(steep.contains("all together: steeper than a sea can be: 7.78 m"), "{steep}");
    assert!(high.contains("all together: higher than the water can carry: 7.78 m"), "{high}");

    // 7.31 m on 112.8 m is as steep as a sea of 8.5 s may be.
    let steep = "spectrum = 'jonswap'; significant_height_m = 5; peak_period_s = 8.5";
    assert_eq!(warnings("choppiness = 1.0", &[steep; 2]), Vec::<String>::new());
    one("choppiness = 1.0", &[steep; 3], &["all together: steeper than a sea can be: 8.66 m"]);
    // Once is enough.
    let steeper = "spectrum = 'jonswap'; significant_height_m = 9; peak_period_s = 8.5";
    one("choppiness = 1.0", &[steeper, steep], &["sea.system[0]: steeper"]);
}

/// What a message says would hold the waves holds them: its keys put in, nothing is left to say.
#[test]
fn advice_about_tiles_can_be_followed() {
    let ripples = "spectrum = 'jonswap'; significant_height_m = 0.1; peak_period_s = 1";
    let storm = "spectrum = 'jonswap'; significant_height_m = 4; peak_period_s = 15";
    let wind_sea = "spectrum = 'jonswap'; significant_height_m = 4; peak_period_s = 12";
    for (keys, systems, advised) in [
        ("cascades = 2; resolution = 64", &[ripples, storm][..], "sea.cascades = "),
        ("cascades = 1", &[ripples, storm], "sea.cascades = "),
        ("tile_size_m = 100.0", &[wind_sea], "sea.tile_size_m = "),
        ("tile_size_m = 100.0; cascades = 1; resolution = 16", &[wind_sea], "sea.tile_size_m = "),
        ("shortest_wave_m = 1000.0; resolution = 16", &[wind_sea, ripples], "sea.shortest_wave_m = "),
        ("cascades = 1; resolution = 16; tile_size_m = 1500.0", &[wind_sea], "sea."),
    ] {
        let told = match read(keys, systems) {
            Ok(scene) => scene.warnings.join("\n"),
            Err(refused) => refused,
        };
        assert!(told.contains(advised) && told.contains(" hold"), "{keys}: {told}");
        let advice = told.rsplit_once("; ").unwrap().1.split_once(" hold").unwrap().0;
        let mut changed: Vec<_> = keys.split("; ").map(str::to_owned).collect();
        for line in advice.split(" and ").map(|line| line.strip_prefix("sea.").unwrap()) {
            let (key, _) = line.split_once(' ').unwrap();
            changed.retain(|old| !old.starts_with(key));
            // Numbers in metres are printed without a fraction where they have none.
            let is_whole = key.ends_with("_m") && !line.contains('.');
            changed.push(if is_whole { format!("{line}.0") } else { line.to_owned() });
        }
        assert_eq!(warnings(&changed.join("; "), systems), Vec::<String>::new(), "{keys}: {told}");
    }
}

/// 50 m/s over the open sea.
#[test]
fn seas_higher_than_any_that_was_measured() {
    let hurricane = "spectrum = 'pierson-moskowitz'; wind_speed_mps = 50";
    one("", &[hurricane], &["higher than any sea that was measured: 56.", "had 19 m"]);
    assert_eq!(warnings("", &["spectrum = 'pierson-moskowitz'; wind_speed_mps = 28"]), Vec::<String>::new());
}

/// Waves of 8 s bring their energy by 6.2 m/s, and the longest of the peak a little faster.
#[test]
fn currents_that_no_waves_run_against() {
    let words = ["current_mps = 7", "sea.system[0] with 7.0 m/s", "6.3 m/s"];
    one("current_mps = 7.0; current_toward_deg = 270.0", &[SWELL], &words);
    for with in
        ["current_mps = 7.0; current_toward_deg = 90.0", "current_mps = 5.0; current_toward_deg = 270.0"]
    {
        assert_eq!(warnings(with, &[SWELL]), Vec::<String>::new());
    }
}

/// The peak over wave numbers of waves of 8 s, longer than the 99.9 m of that over frequencies.
#[test]
fn tiles_that_hold_few_waves_of_the_peak() {
    let tile = |size_m: f64| format!("cascades = 1; resolution = 256; tile_size_m = {size_m:?}");
    assert_eq!(warnings(&tile(202.0), &[SWELL]), Vec::<String>::new());
    let words = [
        "sea.tile_size_m = 180: ",
        "holds 1.8 waves",
        "sea.system[0]",
        "100.7 m long",
        "than 2",
        "= 806 holds eight",
    ];
    one(&tile(180.0), &[SWELL], &words);
    let ripples = "spectrum = 'jonswap'; significant_height_m = 0.1; peak_period_s = 3";
    one(&tile(180.0), &[ripples, SWELL], &["the peak of sea.system[1]"]);
    let tiles = "cascade = [{ tile_size_m = 20.0 }, { tile_size_m = 150.0 }]";
    one(tiles, &[SWELL], &["sea.cascade[1].tile_size_m = 150: ", "holds 1.5 waves"]);
    // What is planned holds eight.
    assert_eq!(warnings("", &[SWELL]), Vec::<String>::new());
}

/// Cells of a planned tile are an eighth of the peak's wave number wide: 2.07° of standard deviation. Against the spread that
/// surfaces have: 4.7° and 5.0° for s = 300, 2.6° and 3.2° for 1000.
#[test]
fn tiles_whose_directions_are_too_few() {
    let narrow = |s: u32| {
        format!(
            "spectrum = 'jonswap'; significant_height_m = 2; peak_period_s = 12; spreading = {{ cos2s = {s} }}"
        )
    };
    assert_eq!(warnings("", &[&narrow(150)]), Vec::<String>::new());
    let words = [
        "sea.tile_size_m = 18",
        "at the peak of sea.system[0] spread over 4.7°, drawn over 5.1°",
        " = 2506 has",
    ];
    one("", &[&narrow(300)], &words);
    one("", &[&narrow(1000)], &["over 2.6°, drawn over 3.3°"]);
    let enough = warnings("", &[&narrow(1000)]).remove(0);
    let tile_size_m = enough.rsplit_once("tile_size_m = ").unwrap().1.split(' ').next().unwrap();
    assert_eq!(warnings(&format!("tile_size_m = {tile_size_m}.0"), &[&narrow(1000)]), Vec::<String>::new());
}

/// The eye in the water, under its bottom and in an island, each with how deep.
#[test]
fn cameras_that_are_in_the_way_of_what_they_look_at() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sea.toml");
    let island = "[[object]]\nmesh = \"island\"\n";
    for (sea, position_m, object, words) in [
        ("", "[0, 0.0, 0]", "", &[][..]),
        ("", "[0, -2.5, 0]", "", &["position_m = [0.0, -2.5, 0.0]: 2.5 m under the level of the sea"]),
        ("depth_m = 8.0", "[0, -7.5, 0]", "", &["7.5 m under the level of the sea"]),
        ("depth_m = 8.0", "[0, -100, 0]", "", &["92.0 m under the bottom of the sea"]),
        ("", "[0, 2.0, 0]", island, &["m inside the ground that the objects make there"]),
        ("", "[0, 200.0, 0]", island, &[]),
        ("", "[1e6, 2.0, 0]", island, &[]),
    ] {
        let text = format!(
            "technique = \"spectral-ocean\"\n[sea]\n{sea}\n[[sea.system]]\nfrom_deg = 270.0\n{}\n[camera]\n\
             position_m = {position_m}\nlook_at_m = [9, 0, 0]\n{object}",
            "spectrum = 'jonswap'\nsignificant_height_m = 1\npeak_period_s = 6"
        );
        std::fs::write(&path, text).unwrap();
        let found = Scene::load(&path).unwrap().warnings;
        assert!(found.len() == words.len() && words.iter().all(|word| found[0].contains(word)), "{found:?}");
    }
}

/// What is no light in the picture of a sky is counted.
#[test]
fn panoramas_that_hold_what_is_no_light() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sea.toml");
    let text = "technique = \"spectral-ocean\"\n[[sea.system]]\nfrom_deg = 270.0\nspectrum = 'jonswap'\nsea_state = 3\n\
                [sky]\nkind = \"panorama\"\nfile = \"sky.exr\"\n[camera]\nposition_m = [0, 4, 0]\nlook_at_m = [9, 0, 0]\n";
    std::fs::write(&path, text).unwrap();
    for (odd, count) in [([1.0, 2.0], 0), ([f32::NAN, 2.0], 1), ([1.0, -3.0], 1), ([-1.0, f32::INFINITY], 2)]
    {
        write_sky(&folder.path().join("sky.exr"), odd);
        let found = Scene::load(&path).unwrap().warnings;
        let said = format!("sky.file: {count} of 32 pixels are negative, not finite or brighter");
        let is_said = found.len() == 1 && found[0].starts_with(&said);
        assert!(if count == 0 { found.is_empty() } else { is_said }, "{odd:?}: {found:?}");
    }
}

/// Ω = 5, the youngest sea of the law, is that of some 2 km under 20 m/s.
#[test]
fn fetches_shorter_than_the_law_of_elfouhaily_knows() {
    let said = |fetch_km: f64| {
        let system = format!("spectrum = 'elfouhaily'; wind_speed_mps = 20.0; fetch_km = {fetch_km:?}");
        warnings("", &[&system]).into_iter().any(|warning| warning.contains("inverse wave age"))
    };
    assert!(said(0.1) && said(2.0));
    assert!(!said(10.0) && !said(300.0));
}

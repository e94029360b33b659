//! Scenes of measured seas: which file and record they mean, and what they say when there is none.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use std::f64::consts::TAU;
use std::path::Path;

use whitecap_scene::sea::system::System;
use whitecap_scene::sea::{SeaModel, SeaSurface};
use whitecap_scene::{Scene, SceneError};
use whitecap_waves::model::Surface;
use whitecap_waves::model::{TileFields, WaveModel};
use whitecap_waves::statistics::{Moments, significant_height_m};

/// Hs = 4√(0.01 · (½·1 + 4 + ½·2)) by trapezoids = 0.938 m, and an hour before half as high.
const HISTORY: &str = "\
YYYY MM DD hh mm  .100  .110  .120
2020 06 08 02 50  .250 1.000  .500
2020 06 08 03 50 1.000 4.000 2.000
2020 06 08 04 50    MM    MM    MM
";

const CAMERA: &str = "[camera]\nposition_m = [0.0, 5.0, 0.0]\nlook_at_m = [50.0, 0.0, 0.0]\n";

fn write(folder: &Path, system: &str) -> std::path::PathBuf {
    std::fs::create_dir_all(folder.join("data")).unwrap();
    std::fs::write(folder.join("data/buoy.txt"), HISTORY).unwrap();
    let scene = folder.join("storm.toml");
    let sea = "technique = \"meshuggah\"\n[sea]\ntile_size_m = 600.0\nresolution = 128\n[[sea.system]]\n";
    std::fs::write(&scene, format!("{sea}{system}\n{CAMERA}")).unwrap();
    scene
}

fn open(system: &str) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().unwrap();
    Scene::load(&write(folder.path(), system)).and_then(|scene| scene.sea.build(1).map(|_| scene))
}

fn height_m(system: &str) -> f64 {
    let folder = tempfile::tempdir().unwrap();
    let scene = Scene::load(&write(folder.path(), system)).unwrap();
    significant_height_m(scene.sea.build(1).unwrap().variance_m2())
}

#[test]
fn the_sea_is_as_high_as_the_file_says() {
    for (system, expected_m) in [
        ("measured = \"data/buoy.txt\"\nfrom_deg = 250.0", 0.938),
        (
            "measured = \"data/buoy.txt\"\nfrom_deg = 250.0\ntime = \"2020-06-08T02:50:00Z\"\ncos2s = 30.0",
            0.469,
        ),
        ("measured = \"data/buoy.txt\"\nfrom_deg = 250.0\nrecord = 2\nplace = \"buoy\"", 0.469),
    ] {
        let found = height_m(system);
        assert!((found / expected_m - 1.0).abs() < 0.02, "{system}: {found} m");
    }
}

#[test]
fn errors_name_the_line_of_the_scene_and_the_file() {
    for (system, place, problem) in [
        ("measured = \"no.txt\"", ":6: sea.system[0].measured = \"no.txt\": ", "no.txt: cannot be read"),
        (
            "measured = \"storm.toml\"",
            ":6: sea.system[0].measured = ",
            "storm.toml: no known format, by its first line",
        ),
        (
            "measured = \"data/buoy.txt\"",
            ":5: sea.system[0].from_deg: ",
            "buoy.txt: no directions in the file; needs from_deg",
        ),
        (
            "measured = \"data/buoy.txt\"\nfrom_deg = 9\ntime = \"2021-06-08T02:50\"",
            ":8: sea.system[0].time = \"2021-06-08T02:50\": ",
            "no record of 2021-06-08T02:50:00Z; there are 3 from 2020-06-08T02:50:00Z to 2020-06-08T04:50:00Z",
        ),
        (
            "measured = \"data/buoy.txt\"\nfrom_deg = 9\nrecord = 7",
            ":8: sea.system[0].record = 7: ",
            "no record 7; accepted: 0, the newest, to 2",
        ),
        (
            "measured = \"data/buoy.txt\"\nfrom_deg = 9\nrecord = 0",
            ":8: sea.system[0].record = 0: ",
            "every value is missing",
        ),
        (
            "measured = \"data/buoy.txt\"\nfrom_deg = 9\nplace = \"x\"",
            ":8: sea.system[0].place = \"x\": ",
            "no place \"x\"; accepted: \"buoy\"",
        ),
        (
            "measured = \"data/buoy.txt\"\nfrom_deg = 9\ncos2s = 1001",
            ":8: sea.system[0].cos2s = 1001: ",
            "out of range; accepted: 0 to 1000",
        ),
        (
            "measured = \"data/buoy.txt\"\nspectrum = \"phillips\"",
            ":7: sea.system[0].spectrum = \"phillips\": ",
            "beside measured; accepted: one of the two",
        ),
        (
            "measured = \"a\"\nrecord = 1\ntime = \"2021-06-08T02:50\"",
            ":7: sea.system[0].record = 1: ",
            "beside time",
        ),
        ("measured = \"a\"\nwind_speed_mps = 9", ":7: sea.system[0].wind_speed_mps: ", "unknown key"),
        (
            "measured = \"a\"\ntime = \"noon\"",
            ":7: sea.system[0].time = \"noon\": ",
            "no time; accepted: a time such as 2022-09-12T06:00:00Z",
        ),
    ] {
        let said = open(system).unwrap_err().to_string();
        assert!(said.contains(&format!("storm.toml{place}")) && said.contains(problem), "{said}");
    }
}

/// A set of files of which one ends an hour early.
#[test]
fn a_passed_over_hour_is_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let scene = write(folder.path(), "measured = \"data/44097.data_spec\"");
    let hour = |hour: u32, value: f64| {
        format!("2020 06 08 0{hour} 50 {value} (0.100) {value} (0.110) {value} (0.120)\n")
    };
    let file = |extension: &str, head: &str, value: f64, hours: &[u32]| {
        let rows: String = hours.iter().map(|&at| hour(at, value)).collect();
        let path = folder.path().join(format!("data/44097.{extension}"));
        std::fs::write(path, format!("#YY MM DD hh mm {head}\n{rows}")).unwrap();
    };
    file("data_spec", "Sep_Freq < spec_1", 3.0, &[5, 4]);
    for (extension, head, value) in
        [("swdir", "alpha1_1", 270.0), ("swdir2", "alpha2_1", 270.0), ("swr2", "r2_1", 0.6)]
    {
        file(extension, head, value, &[5, 4]);
    }
    file("swr1", "r1_1", 0.8, &[4]);
    let warnings = Scene::load(&scene).unwrap().warnings.join("\n");
    assert!(
        warnings.contains(
            "44097.swr1 has no directions of 2020-06-08T05:50:00Z, the newest record; that of 2020-06-08T04:50:00Z is \
             drawn"
        ),
        "{warnings}"
    );
    let scene = write(folder.path(), "measured = \"data/44097.data_spec\"\ntime = \"2020-06-08T05:50\"");
    let said = Scene::load(&scene).unwrap_err().to_string();
    assert!(said.contains("storm.toml:7: sea.system[0].time = \"2020-06-08T05:50\": "), "{said}");
    assert!(said.contains("44097.swr1; accepted: another time, or from_deg"), "{said}");
}

/// The warnings of a record of five frequencies, with these values in its files.
fn warnings_of(r1: &str, r2: &str, density: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let scene = write(folder.path(), "measured = \"data/44097.data_spec\"");
    let rows = |values: &str| {
        let pairs = values
            .split(' ')
            .zip(1..)
            .map(|(value, i)| format!(" {value} ({:.3})", 0.1 + 0.01 * f64::from(i)));
        pairs.collect::<String>()
    };
    for (extension, head, values) in [
        ("data_spec", "Sep_Freq < spec_1", density),
        ("swdir", "alpha1_1", "270 270 270 270 270"),
        ("swdir2", "alpha2_1", "270 270 270 270 270"),
        ("swr1", "r1_1", r1),
        ("swr2", "r2_1", r2),
    ] {
        let text = format!("#YY MM DD hh mm {head}\n2020 06 08 05 50{}\n", rows(values));
        std::fs::write(folder.path().join(format!("data/44097.{extension}")), text).unwrap();
    }
    Scene::load(&scene).unwrap().warnings
}

/// r1 = 0.9 and r2 = 0.1 in line: |c₂ − c₁²| = 0.71, and 1 − r₁² is 0.19. The first two of five bands hold 3 of 9 parts of the
/// energy, the first alone one.
#[test]
fn directions_that_no_waves_have_are_a_warning() {
    let said = |r1: &str, r2: &str, density: &str| {
        let warnings = warnings_of(r1, r2, density);
        warnings.into_iter().filter(|warning| warning.contains("directional moments")).collect::<Vec<_>>()
    };
    let energy = "1 2 3 2 1";
    for (r1, r2) in [
        ("0.80 0.80 0.80 0.80 0.80", "0.64 0.50 0.40 0.30 0.90"),
        // As narrow as there is, in hundredths.
        ("1.00 0.99 0.98 0.99 0.00", "1.00 0.96 0.94 0.97 1.00"),
    ] {
        assert_eq!(said(r1, r2, energy), Vec::<String>::new());
    }
    let found = said("0.90 0.90 0.80 0.80 0.80", "0.10 0.10 0.64 0.64 999", energy);
    let words = ["sea.system[0]: ", "44097.data_spec: 2 of 4 frequencies, with 33.3 % of the energy, have "];
    assert!(found.len() == 1 && words.iter().all(|word| found[0].contains(word)), "{found:?}");
    // Where there is next to no energy, or none, nothing is said.
    let crooked = |density: &str| said("0.90 0.80 0.80 0.80 0.80", "0.10 0.64 0.64 0.64 0.64", density);
    assert!(crooked("0.2 2 3 2 1")[0].contains("1 of 5 frequencies, with 2.4 % of the energy"));
    for density in ["0.05 2 3 2 1", "0 2 3 2 1"] {
        assert_eq!(crooked(density), Vec::<String>::new());
    }
}

/// Files of seas that are not found, and of files that end too soon, say so as parameters do.
#[test]
fn seas_that_cannot_be_are_refused_or_warned_of() {
    let opened = |header: &str, densities: &str, water: &str| {
        let folder = tempfile::tempdir().unwrap();
        let scene = write(folder.path(), "measured = \"data/buoy.txt\"\nfrom_deg = 250.0");
        let file = format!("YYYY MM DD hh {header}\n2020 06 08 03 {densities}\n");
        std::fs::write(folder.path().join("data/buoy.txt"), file).unwrap();
        let text = std::fs::read_to_string(&scene).unwrap();
        std::fs::write(&scene, text.replace("[sea]\n", &format!("[sea]\n{water}\n"))).unwrap();
        match Scene::load(&scene) {
            Ok(scene) => scene.warnings.join("\n"),
            Err(error) => error.to_string(),
        }
    };
    const BANDS: &str = ".08 .10 .12 .14 .20 .40";
    // 4√(0.02 · 23 …) = 2.8 m on waves of 156 m.
    let usual = opened(BANDS, "1 10 8 4 1 .01", "");
    assert!(!usual.contains("sea.system"), "{usual}");
    for (densities, water, expected) in [
        ("1e3 1e4 8e3 4e3 1e3 1", "", "buoy.txt: 103.6 m of significant height; accepted: up to 40 m"),
        ("50 500 400 200 50 .5", "", "steeper than a sea can be: 2"),
        ("1 10 8 4 1 .01", "depth_m = 4.0", "higher than the water can carry: "),
        ("1 10 8 4 1 .8", "", "buoy.txt ends at 0.4 Hz, among its waves: "),
        // m0 = 1 0.02 + 8 0.02 + 4 0.04 + 1 0.13 + 0.01 0.2 m²; missing are (1 + 8)/2 0.02.
        (
            "1 999 8 4 1 .01",
            "",
            "values of 1 of its 6 frequencies, at 0.1 Hz, are missing and count as no energy: 2.75 m of significant height, \
             3.00 m if",
        ),
        ("1 10 8 4 999 MM", "", "2 of its 6 frequencies, from 0.2 to 0.4 Hz, are missing"),
    ] {
        let said = opened(BANDS, densities, water);
        assert!(said.contains(expected) && said.contains("sea.system[0]"), "{said}");
    }
}

/// Densities of a wind sea of 2 m and 8 s over these frequencies.
fn wind_sea_m2phz(frequencies_hz: &[f64]) -> Vec<f64> {
    let sea = whitecap_waves::spectrum::jonswap::Jonswap::from_height_and_period(2.0, 8.0, 3.3).unwrap();
    let density = |hz: &f64| TAU * whitecap_waves::spectrum::Omnidirectional::density_m2s(&sea, TAU * hz);
    frequencies_hz.iter().map(density).collect()
}

/// A file of each format, with as many frequencies as theirs have: the surface that is drawn has the height that the file has
/// by its makers' own sum, to 1 %.
#[test]
fn surfaces_have_the_height_of_their_files() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    let words = |values: &[f64]| values.iter().map(|value| format!(" {value:.6}")).collect::<String>();
    let bands: Vec<f64> = (2..=48).map(|i| 0.01 * f64::from(i)).collect();
    let density = wind_sea_m2phz(&bands);
    write("history.txt", format!("YYYY MM DD hh mm{}\n2020 06 08 03 50{}\n", words(&bands), words(&density)));
    let pairs = |values: &[f64]| {
        values.iter().zip(&bands).map(|(value, hz)| format!(" {value:.6} ({hz:.3})")).collect::<String>()
    };
    write(
        "buoy.data_spec",
        format!("#YY MM DD hh mm Sep_Freq < spec_1\n2020 06 08 03 50 0.2{}\n", pairs(&density)),
    );
    for (extension, head, value) in [
        ("swdir", "alpha1_1", 250.0),
        ("swdir2", "alpha2_1", 250.0),
        ("swr1", "r1_1", 0.8),
        ("swr2", "r2_1", 0.5),
    ] {
        let values = vec![value; bands.len()];
        write(
            &format!("buoy.{extension}"),
            format!("#YY MM DD hh mm {head}\n2020 06 08 03 50{}\n", pairs(&values)),
        );
    }
    let steps: Vec<f64> = (0..36).map(|i| 0.035 * 1.08_f64.powi(i)).collect();
    let toward: Vec<f64> = (0..24).map(|i| TAU * f64::from(i) / 24.0).collect();
    let shape: Vec<f64> = toward.iter().map(|toward| (1.0 + toward.cos()).powi(4)).collect();
    let all: f64 = shape.iter().sum::<f64>() * TAU / 24.0;
    // Frequencies run fastest.
    let table: Vec<f64> = shape
        .iter()
        .flat_map(|share| wind_sea_m2phz(&steps).into_iter().map(move |s| s * share / all))
        .collect();
    write(
        "points.spec",
        format!(
            "'WAVEWATCH III SPECTRA'     36    24     1 'one point'\n{}\n{}\n20200608 030000\n\
             'buoy      '  40.98-171.12      46.6   1.45 225.6   0.18  94.1\n{}\n",
            words(&steps),
            words(&toward),
            table.iter().map(|value| format!(" {value:.6e}")).collect::<String>()
        ),
    );
    for (file, more) in [
        ("history.txt", "from_deg = 250.0"),
        ("buoy.data_spec", ""),
        ("points.spec", ""),
        ("named:buoy.spec", ""),
    ] {
        let scene = folder.path().join("scene.toml");
        let text = format!(
            "technique = \"spectral-ocean\"\n[[sea.system]]\nmeasured = \"{file}\"\n{more}\n{CAMERA}"
        );
        std::fs::write(&scene, text).unwrap();
        let scene = Scene::load(&scene).unwrap();
        let path =
            if file.starts_with("named:") { Path::new(file).to_owned() } else { folder.path().join(file) };
        let record = &whitecap_scene::measured::load(&path).unwrap()[0];
        let own_m = significant_height_m(record.variance_m2());
        let whitecap_scene::sea::SeaSurface::Spectral(mut sea) = scene.sea.build(scene.seed).unwrap() else {
            panic!("another sea")
        };
        let mut fields = TileFields::default();
        let drawn = sea.tiles_mut().iter_mut().map(|tile| {
            tile.evaluate(12.5, &mut fields);
            Moments::of(&fields.height).variance
        });
        let drawn_m = significant_height_m(drawn.sum());
        assert!((drawn_m / own_m - 1.0).abs() < 0.01, "{file}: {drawn_m} m of {own_m} m");
    }
}

/// A tail goes on from the last frequency as f⁻⁵: S f/4 of it in all, and none of the file's own waves changes.
#[test]
fn a_tail_is_that_of_a_wind_sea() {
    let sea = |tail: bool| {
        let scene = format!(
            "technique = \"spectral-ocean\"\n[[sea.system]]\nmeasured = \"named:buoy.spec\"\ntail = {tail}\n{CAMERA}"
        );
        Scene::from_toml(&scene, "scene.toml").unwrap()
    };
    let variance_m2 = |scene: &Scene| scene.sea.spectra().unwrap()[0].variance_m2();
    let [without, with] = [sea(false), sea(true)];
    let record = &whitecap_scene::measured::load(Path::new("named:buoy.spec")).unwrap()[0];
    let found = variance_m2(&with) - variance_m2(&without);
    assert!((found / record.variance_beyond_m2() - 1.0).abs() < 0.02, "{found}");
    let longest = record.with_tail();
    assert_eq!(longest.frequencies_hz[..28], record.frequencies_hz[..]);
    assert!(longest.frequencies_hz.last().is_some_and(|hz| (9.5..=10.0).contains(hz)));
}

#[test]
fn an_unknown_named_file_is_refused_with_those_that_there_are() {
    let said = open("measured = \"named:bouy.spec\"").unwrap_err().to_string();
    assert!(
        said.contains("no such file comes with whitecap; accepted: \"named:buoy.spec\", or a path"),
        "{said}"
    );
}

/// Text alone has no folder: nothing is opened, and what is written back is the same scene.
#[test]
fn text_is_read_without_its_files() {
    let text = "technique = \"meshuggah\"\n[[sea.system]]\nmeasured = \"no.spec\"\ntime = \"2022-09-12T06:00\"\n\
                direction_method = \"longuet-higgins\"\n";
    let scene = Scene::from_toml(&format!("{text}{CAMERA}"), "text").unwrap();
    let SeaModel::Spectral(settings) = &scene.sea.model else { panic!("another sea") };
    let System::Measured(system) = &settings.system[0] else { panic!("another system") };
    assert_eq!(system.measured, Path::new("no.spec"));
    assert_eq!(Scene::from_toml(&scene.to_toml().unwrap(), "again").unwrap(), scene);
}

/// A newer record without waves is passed over, and the scene says so; who asks for a record himself hears nothing.
#[test]
fn a_newer_record_without_waves_is_told_of() {
    let found = |line: &str, more: &str| {
        let folder = tempfile::tempdir().unwrap();
        let scene = write(folder.path(), &format!("measured = \"data/buoy.txt\"\nfrom_deg = 250.0\n{more}"));
        let (whole, _) = HISTORY.split_at(HISTORY.rfind("2020").unwrap());
        std::fs::write(folder.path().join("data/buoy.txt"), format!("{whole}{line}")).unwrap();
        let warnings = Scene::load(&scene).unwrap().warnings;
        warnings.into_iter().filter(|warning| warning.contains("newest")).collect::<Vec<_>>()
    };
    for (values, expected) in
        [(".00 .00 .00", "is of a calm, all values are 0"), ("999.0 999.0 999.0", "has no values")]
    {
        let newer = format!("2020 06 08 04 50 {values}\n");
        let warnings = found(&newer, "");
        let words =
            ["buoy.txt: the newest record of 2020-06-08T04:50:00Z", expected, "that of 2020-06-08T03:50:00Z"];
        assert!(
            warnings.len() == 1 && words.iter().all(|word| warnings[0].contains(word)),
            "{values}: {warnings:?}"
        );
        assert_eq!(found(&newer, "time = \"2020-06-08T03:50:00Z\""), Vec::<String>::new());
        assert_eq!(found(&newer, "record = 1"), Vec::<String>::new());
    }
    assert_eq!(found("", ""), Vec::<String>::new());
}

/// Tiles end where the file does: none is empty.
#[test]
fn no_tile_is_without_waves() {
    let folder = tempfile::tempdir().unwrap();
    let scene = write(folder.path(), "measured = \"data/buoy.txt\"\nfrom_deg = 250.0");
    let text = std::fs::read_to_string(&scene).unwrap();
    let planned =
        text.replace("tile_size_m = 600.0\nresolution = 128\n", "").replace("meshuggah", "spectral-ocean");
    std::fs::write(&scene, planned).unwrap();
    let sea = Scene::load(&scene).unwrap().sea.build(1).unwrap();
    let SeaSurface::Spectral(sea) = sea else { panic!("another sea") };
    assert!(sea.tiles().iter().all(|tile| tile.variance_m2() > 0.0), "{:?}", sea.parameters().cascades);
}

/// A value that one of the four files lacks leaves its frequency without directions: the third of five, with 3 of 9 parts of the
/// energy.
#[test]
fn frequencies_without_directions_are_a_warning() {
    let usual = "0.80 0.80 0.80 0.80 0.80";
    let said = |r2: &str| {
        let warnings = warnings_of(usual, r2, "1 2 3 2 1");
        warnings.into_iter().filter(|warning| warning.contains("no directions")).collect::<Vec<_>>()
    };
    assert_eq!(said("0.50 0.50 0.50 0.50 0.50"), Vec::<String>::new());
    let found = said("0.50 0.50 999.0 0.50 0.50");
    assert!(found.len() == 1 && found[0].contains("1 frequencies, with 33.3 %"), "{found:?}");
}

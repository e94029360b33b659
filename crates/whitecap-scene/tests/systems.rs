//! Wave systems: what the keys ask for is what the spectrum has.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use glam::DVec2;
use whitecap_scene::Scene;
use whitecap_scene::sea::system::{System, TmaSystem};
use whitecap_scene::sea::{SeaModel, SeaSurface};
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::Surface;
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::statistics::significant_height_m;

const DEEP: Dispersion = Dispersion::DEEP;

/// The system of a sea with these lines.
fn system(lines: &str) -> System {
    let text = format!(
        "[sea]\ntile_size_m = 1000.0\nresolution = 256\n[[sea.system]]\nfrom_deg = 270.0\n{}\n\
         [camera]\nposition_m = [0, 4, 0]\nlook_at_m = [9, 0, 0]\n",
        lines.replace("; ", "\n")
    );
    let scene = Scene::from_toml(&text, "systems").unwrap();
    let again = Scene::from_toml(&scene.to_toml().unwrap(), "again").unwrap();
    assert_eq!(again.sea, scene.sea, "{lines}");
    let SeaModel::Spectral(mut settings) = scene.sea.model else { panic!("{lines}") };
    settings.system.remove(0)
}

fn height_m(system: &System) -> f64 {
    significant_height_m(system.build("sea.system[0]", &DEEP).unwrap().variance_m2())
}

fn period_s(system: &System) -> f64 {
    system.omnidirectional(&DEEP).unwrap().unwrap().peak_period_s()
}

#[test]
fn heights_and_periods_asked_for() {
    for (lines, height, period) in [
        (
            "spectrum = 'pierson-moskowitz'; wind_speed_mps = 15",
            2.133 * 1.5_f64.powi(2) * 1.026_f64.powi(2),
            11.24,
        ),
        ("spectrum = 'pierson-moskowitz'; significant_height_m = 3", 3.0, 8.66),
        ("spectrum = 'pierson-moskowitz'; significant_height_m = 3; peak_period_s = 12", 3.0, 12.0),
        ("spectrum = 'pierson-moskowitz'; sea_state = 6", 5.0, 11.18),
        ("spectrum = 'jonswap'; wind_speed_mps = 15; fetch_km = 300", 5.6475, 10.289),
        ("spectrum = 'jonswap'; significant_height_m = 2; peak_period_s = 13; gamma = 5", 2.0, 13.0),
        ("spectrum = 'jonswap'; sea_state = 5", 3.25, 9.013),
    ] {
        let system = system(lines);
        assert!((height_m(&system) / height - 1.0).abs() < 1e-3, "{lines}: {}", height_m(&system));
        assert!((period_s(&system) / period - 1.0).abs() < 1e-3, "{lines}: {}", period_s(&system));
    }
    // 2.6332 m at 10 m/s; Beaufort 6 blows at 12.287 m/s.
    let height = height_m(&system("spectrum = 'elfouhaily'; wind_speed_mps = 10"));
    assert!((height - 2.6332).abs() < 1e-3);
    let height = height_m(&system("spectrum = 'elfouhaily'; significant_height_m = 4"));
    assert!((height - 4.0).abs() < 1e-9);
    for spectrum in ["pierson-moskowitz", "jonswap", "elfouhaily", "phillips"] {
        let by_number = height_m(&system(&format!("spectrum = '{spectrum}'; beaufort = 6")));
        let by_wind = height_m(&system(&format!("spectrum = '{spectrum}'; wind_speed_mps = 12.2865")));
        assert!((by_number / by_wind - 1.0).abs() < 1e-4, "{spectrum}");
    }
    for (lines, height) in [
        ("wind_speed_mps = 12; significant_height_m = 2", 2.0),
        ("significant_height_m = 2; peak_period_s = 9", 2.0),
        ("significant_height_m = 2.5", 2.5),
        ("sea_state = 4", 1.875),
    ] {
        assert!((height_m(&system(&format!("spectrum = 'phillips'; {lines}"))) - height).abs() < 1e-9);
    }
}

#[test]
fn a_calm_is_flat() {
    for spectrum in ["pierson-moskowitz", "jonswap", "elfouhaily", "phillips"] {
        for calm in ["sea_state = 0", "beaufort = 0"] {
            assert_eq!(height_m(&system(&format!("spectrum = '{spectrum}'; {calm}"))), 0.0);
        }
    }
}

/// The scene's depth reaches the spectrum: 1.6700 m over ten metres, 2.1386 m over deep water.
#[test]
fn depth_lowers_the_sea() {
    let lines = "spectrum = 'jonswap'; wind_speed_mps = 10; fetch_km = 100; spreading = { cos2s = 4.0 }";
    let System::Jonswap(deep) = system(lines) else { panic!() };
    let shallow = System::Tma(TmaSystem(deep));
    let height = |depth_m: f64| {
        let water = Dispersion::at_depth(depth_m).unwrap();
        significant_height_m(shallow.build("sea.system[0]", &water).unwrap().variance_m2())
    };
    assert!((height(10.0) - 1.6700).abs() < 1e-4 && (height(1e4) - 2.1386).abs() < 1e-4);
    assert!(shallow.build("sea.system[0]", &DEEP).is_err());
}

/// Weather from the west runs east, and more narrowly as swell; the spreading is the one of the file.
#[test]
fn directions_asked_for() {
    let density = |more: &str, angle: f64| {
        let lines = format!("spectrum = 'jonswap'; significant_height_m = 2; peak_period_s = 10; {more}");
        let k = 0.05 * DVec2::from_angle(angle);
        system(&lines).build("sea.system[0]", &DEEP).unwrap().density_m4(k)
    };
    assert!(density("swell = 0.0", 0.0) > 100.0 * density("swell = 0.0", 3.0));
    let share = |more: &str| density(more, 0.8) / density(more, 0.0);
    assert!(share("swell = 0.8") < share("swell = 0.0"));
    for (more, expected) in [
        ("spreading = 'cos2'", 0.8_f64.cos().powi(2)),
        ("spreading = { cos2s = 25.0 }", 0.4_f64.cos().powi(50)),
    ] {
        assert!((share(more) / expected - 1.0).abs() < 1e-6, "{more}");
    }
    let words = ["mitsuyasu", "hasselmann", "donelan-banner", "elfouhaily"];
    let shares: Vec<_> = words.iter().map(|word| share(&format!("spreading = '{word}'"))).collect();
    for (i, a) in shares.iter().enumerate() {
        assert!(shares[..i].iter().all(|b| (a / b - 1.0).abs() > 0.01), "{shares:?}");
    }
}

fn warnings_over(lines: &str, water: &Dispersion) -> Vec<String> {
    let system = system(lines);
    let spectrum = system.build("sea.system[0]", water).unwrap();
    system.warnings(water, &*spectrum)
}

/// Twenty-five systems of 0.6 m make a sea of 3 m.
#[test]
fn any_number_of_systems_adds_by_variance() {
    let system = |i: u32| {
        format!(
            "[[sea.system]]\nspectrum = \"jonswap\"\nsignificant_height_m = 0.6\npeak_period_s = 8.0\nfrom_deg = {}.0\n",
            12 * i
        )
    };
    let text: String = (0..25).map(system).collect();
    let camera = "[camera]\nposition_m = [0, 4, 0]\nlook_at_m = [9, 0, 0]\n";
    let scene = Scene::from_toml(
        &format!("technique = \"spectral-ocean\"\n[sea]\nresolution = 64\n{text}{camera}"),
        "many",
    )
    .unwrap();
    let SeaSurface::Spectral(sea) = scene.sea.build(1).unwrap() else { panic!() };
    let height_m = significant_height_m(sea.variance_m2());
    assert!((height_m - 3.0).abs() < 0.03, "{height_m}");
}

#[test]
fn warnings_about_seas_that_are_not_found() {
    let warnings = |lines: &str| warnings_over(lines, &DEEP);
    for usual in [
        "spectrum = 'jonswap'; wind_speed_mps = 12; fetch_km = 300",
        "spectrum = 'jonswap'; wind_speed_mps = 12",
        "spectrum = 'jonswap'; wind_speed_mps = 8; fetch_km = 30",
        "spectrum = 'jonswap'; wind_speed_mps = 8; fetch_km = 220",
        "spectrum = 'pierson-moskowitz'; sea_state = 7",
        "spectrum = 'elfouhaily'; wind_speed_mps = 20",
        "spectrum = 'phillips'; wind_speed_mps = 9",
        "spectrum = 'jonswap'; significant_height_m = 1.2; peak_period_s = 13; gamma = 7",
        "spectrum = 'jonswap'; beaufort = 0",
    ] {
        assert_eq!(warnings(usual), Vec::<String>::new(), "{usual}");
    }
    let one = |lines: &str, words: &[&str]| {
        let found = warnings(lines);
        assert!(found.len() == 1 && words.iter().all(|word| found[0].contains(word)), "{found:?}");
    };
    // 10 m on waves of g 6²/2π = 56.2 m; 3.75 m would be the limit.
    one(
        "spectrum = 'jonswap'; significant_height_m = 10; peak_period_s = 6",
        &["steeper", "10.00 m", "56.2 m", "3.75 m"],
    );
    one("spectrum = 'phillips'; significant_height_m = 10; peak_period_s = 6", &["steeper", "56.2 m"]);
    one("spectrum = 'jonswap'; sea_state = 4; gamma = 8", &["gamma = 8", "1 to 7"]);
    one("spectrum = 'jonswap'; wind_speed_mps = 8; fetch_km = 5000", &["fetch_km = 5000", "111 km"]);
    one("spectrum = 'jonswap'; wind_speed_mps = 8; fetch_km = 225", &["fetch_km = 225", "111 km"]);
    let shallow = Dispersion::at_depth(3.0).unwrap();
    let found = warnings_over("spectrum = 'jonswap'; sea_state = 4; gamma = 1", &shallow);
    assert!(found.len() == 1 && found[0].contains("depth_m = 3") && found[0].contains("1.80 m"), "{found:?}");
}

/// The greatest S(ω) is where it was asked to be, or the scene says where it is.
#[test]
fn a_peak_that_is_not_where_it_was_asked_to_be() {
    let shallow = Dispersion::at_depth(3.0).unwrap();
    let about_period = |lines: &str, water: &Dispersion| {
        let found = warnings_over(lines, water);
        found.into_iter().filter(|warning| warning.starts_with("peak_period_s")).collect::<Vec<_>>().join("")
    };
    let System::Jonswap(swell) =
        system("spectrum = 'jonswap'; significant_height_m = 1; peak_period_s = 9; gamma = 1")
    else {
        panic!()
    };
    let tma = System::Tma(TmaSystem(swell));
    let found = tma.warnings(&shallow, &*tma.build("sea.system[0]", &shallow).unwrap()).concat();
    assert!(found.contains("peak_period_s = 9: the spectrum has its peak at 7.9"), "{found}");
    let cut = "spectrum = 'phillips'; significant_height_m = 1; peak_period_s = 5; small_wave_cutoff_m = 3";
    assert!(about_period(cut, &DEEP).contains("peak_period_s = 5: the spectrum has its peak at 5.19 s"));
    for spectrum in ["pierson-moskowitz", "jonswap", "elfouhaily", "phillips"] {
        for period_s in [4.0, 6.0, 15.0] {
            let lines =
                format!("spectrum = '{spectrum}'; significant_height_m = 0.2; peak_period_s = {period_s}");
            assert_eq!(about_period(&lines, &DEEP), "", "{lines}");
            assert!((height_m(&system(&lines)) / 0.2 - 1.0).abs() < 1e-9, "{lines}");
        }
    }
}

/// Tiles that are planned for a spectrum lose less than 0.5 % of its variance, from the faintest breeze to a hurricane, from the
/// deck of a boat and from an aircraft.
#[test]
fn planned_tiles_hold_every_wind_sea() {
    const SPECTRA: [(&str, &str); 6] = [
        ("", "pierson-moskowitz"),
        ("", "jonswap"),
        ("fetch_km = 2", "jonswap"),
        ("fetch_km = 100", "tma"),
        ("", "elfouhaily"),
        ("", "phillips"),
    ];
    let mut least: (f64, String) = (1.0, String::new());
    for (more, spectrum) in SPECTRA {
        for wind_mps in [1.0, 1.5, 2.0, 3.0, 6.0, 15.0, 30.0] {
            for eye_m in [4.0, 1500.0] {
                let depth = if spectrum == "tma" { "depth_m = 20.0\n" } else { "" };
                let text = format!(
                    "technique = \"spectral-ocean\"\n[sea]\n{depth}[[sea.system]]\nfrom_deg = 270.0\nspectrum = \"{spectrum}\"\n\
                     wind_speed_mps = {wind_mps:?}\n{more}\n[camera]\nposition_m = [0, {eye_m:?}, 0]\nlook_at_m = [9, 0, 0]\n"
                );
                let scene = Scene::from_toml(&text, "systems").unwrap();
                let SeaSurface::Spectral(sea) = scene.sea.build(scene.seed).unwrap() else {
                    panic!("{text}")
                };
                let captured = sea.captured_fractions()[0];
                if captured < least.0 {
                    least = (captured, text);
                }
            }
        }
    }
    assert!(least.0 > 0.995, "{} of {}", least.0, least.1);
}

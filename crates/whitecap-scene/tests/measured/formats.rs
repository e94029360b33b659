//! Every format, with numbers that can be done by hand.

use std::f64::consts::TAU;

use whitecap_scene::measured::{Directions, Energy, Format, from_bytes, load};
use whitecap_waves::spectrum::tabulated::{DirectionMethod, DirectionalMoments};

use super::*;

fn near(found: f64, expected: f64) -> bool {
    (found / expected - 1.0).abs() < 1e-9
}

#[test]
fn ndbc_real_time_without_directions() {
    let seas = read(DATA_SPEC);
    assert_eq!(seas.len(), 4);
    assert!(seas.iter().all(|sea| sea.source == Format::NdbcRealTime));
    assert_eq!(seas[0].time.unwrap().to_string(), "2020-06-08T03:50:00Z");
    assert_eq!(seas[0].place.name.as_deref(), Some("44097"));
    assert_eq!(*seas[0].frequencies_hz, [0.1, 0.11, 0.12]);
    assert!(near(seas[0].variance_m2(), 0.07));
    assert!(near(seas[1].variance_m2(), 0.03));
    assert_eq!((&seas[2].energy, &seas[3].energy), (&Energy::Missing, &Energy::Calm));

    // Up to the narrowest that a scene may ask for.
    for s in [4.0, 1000.0] {
        let from_west = Directions { from_deg: Some(270.0), cos2s: Some(s), method: None };
        let spectrum = spectrum(&seas[0], from_west);
        // Trapezoids: 0.01 · (½·1 + 4 + ½·2).
        assert!(near(variance(&spectrum), 0.055));
        let (from_deg, r1) = mean_from_deg(&spectrum);
        assert!((from_deg - 270.0).abs() < 0.1, "{from_deg}");
        assert!((r1 - s / (s + 1.0)).abs() < 1e-3, "r1 = s/(s+1): {r1}");
    }
}

#[test]
fn ndbc_real_time_with_directions() {
    let seas = with_directions();
    let Energy::Moments { moments, .. } = &seas[0].energy else { panic!("no moments") };
    assert_eq!(moments.iter().map(Option::is_some).collect::<Vec<_>>(), [false, true, true]);
    // The next hour has no directions, so it is like a file without.
    assert_eq!(seas[1].lacking_directions(), Some("44097.data_spec (.swdir)"));
    for (method, expected) in [
        (None, 0.8),
        (Some(DirectionMethod::MaximumEntropy), 0.8),
        (Some(DirectionMethod::LonguetHiggins), 0.8 * 2.0 / 3.0),
    ] {
        let spectrum = spectrum(&seas[0], Directions { method, ..Directions::default() });
        assert!(near(variance(&spectrum), 0.055));
        let (from_deg, r1) = mean_from_deg(&spectrum);
        assert!((from_deg - 270.0).abs() < 0.1, "{from_deg}");
        assert!((r1 - expected).abs() < 2e-3, "{method:?}: {r1}");
    }
}

/// A frequency without directions takes those of the nearest that has them, above it or below.
#[test]
fn missing_directions_are_those_of_the_nearest_frequency() {
    let toward = |mean_toward_rad| {
        Some(DirectionalMoments { r1: 0.9, mean_toward_rad, r2: 0.81, principal_toward_rad: mean_toward_rad })
    };
    let sea = MeasuredSea {
        frequencies_hz: [0.05, 0.06, 0.1, 0.11, 0.12, 0.2].into(),
        energy: Energy::Moments {
            density: vec![1.0, 2.0, 4.0, 3.0, 2.0, 1.0],
            moments: vec![None, toward(0.5), None, toward(2.0), None, toward(4.5)],
        },
        ..with_directions()[0].clone()
    };
    let spectrum = spectrum(&sea, Directions::default());
    let nearest = [0.5, 0.5, 2.0, 2.0, 2.0, 4.5];
    for (hz, expected) in sea.frequencies_hz.iter().zip(nearest) {
        let (mut east, mut south) = (0.0, 0.0);
        for i in 0..720 {
            let theta = TAU * f64::from(i) / 720.0;
            let density = spectrum.density_m2phzprad(*hz, theta);
            (east, south) = (east + density * theta.cos(), south + density * theta.sin());
        }
        let found = south.atan2(east).rem_euclid(TAU);
        assert!((found - expected).abs() < 1e-3, "{hz} Hz: {found} instead of {expected}");
    }
}

/// Nines stand for a missing value only where they are none of the column.
#[test]
fn nines_that_are_values_are_kept() {
    let text = DATA_SPEC.replacen("4.000", "99.00", 1).replacen("2.000", "9999.0", 1);
    let directions = DIRECTIONS.map(|file| file.replacen("270.0", "99.0", 1));
    let files = directions.each_ref().map(|file| file.as_bytes());
    let seas = from_bytes_with_directions(text.as_bytes(), files, "x").unwrap();
    let Energy::Moments { density, moments } = &seas[0].energy else { panic!("no moments") };
    assert_eq!(density[..], [1.0, 99.0, 9999.0]);
    // A bearing from 99° is one towards 279°, which from east towards south is 189°.
    let [mean_deg, principal_deg] = moments[1]
        .map(|moments| [moments.mean_toward_rad, moments.principal_toward_rad].map(f64::to_degrees))
        .unwrap();
    assert!((mean_deg - 189.0).abs() < 1e-9 && (principal_deg - 189.0).abs() < 1e-9, "{mean_deg}");

    let history = read(&HISTORY.replacen("3.00", "99.00", 1));
    // By bands of 0.01 Hz.
    assert!(near(history[0].variance_m2(), 0.01 * (0.5 + 99.0 + 1.5)));
}

/// Each column has markers of its own, and without a value there is none.
#[test]
fn nines_that_are_no_values_are_missing() {
    for marker in ["999.0", "999.00", "MM"] {
        let seas = read(&DATA_SPEC.replacen("4.000", marker, 1));
        let Energy::Omnidirectional { density } = &seas[0].energy else { panic!("no densities") };
        assert_eq!(density[..], [1.0, 0.0, 2.0], "{marker}");
    }
    for (file, found, markers) in [
        (0, "270.0", &["999", "MM"][..]),
        (1, "90.0", &["999.0"]),
        (2, "0.80", &["9.99", "99.0", "999.0", "MM"]),
    ] {
        for marker in markers {
            let mut directions = DIRECTIONS.map(str::to_owned);
            let last = directions[file].rfind(found).unwrap();
            directions[file].replace_range(last..last + found.len(), marker);
            let files = directions.each_ref().map(|file| file.as_bytes());
            let seas = from_bytes_with_directions(DATA_SPEC.as_bytes(), files, "x").unwrap();
            let Energy::Moments { moments, .. } = &seas[0].energy else { panic!("no moments") };
            assert_eq!(moments.iter().filter(|moments| moments.is_some()).count(), 1, "{file} {marker}");
        }
    }
}

/// Waves from the north-east go towards the south-west: the file's α₁ = 45.
#[test]
fn ndbc_directions_are_where_waves_come_from() {
    let [mean, principal, r1, r2] =
        DIRECTIONS.map(|file| file.replace("270.0", "45.0").replace(" 90.0", " 225.0"));
    let files = [mean.as_bytes(), principal.as_bytes(), r1.as_bytes(), r2.as_bytes()];
    let seas = from_bytes_with_directions(DATA_SPEC.as_bytes(), files, "x").unwrap();
    let spectrum = spectrum(&seas[0], Directions::default());
    assert!((mean_from_deg(&spectrum).0 - 45.0).abs() < 0.1);
    // From east towards south: south-west is at 135°.
    let south_west = spectrum.density_m2phzprad(0.11, 135.0_f64.to_radians());
    assert!(south_west > 100.0 * spectrum.density_m2phzprad(0.11, -45.0_f64.to_radians()) / 2.0);
}

#[test]
fn ndbc_history_with_its_kinds_of_header() {
    let seas = read(HISTORY);
    assert_eq!(seas.len(), 2);
    assert_eq!(seas[0].source, Format::NdbcHistory);
    assert!(near(seas[0].variance_m2(), 0.05) && near(seas[1].variance_m2(), 0.01));
    assert_eq!(seas[1].time.unwrap().to_string(), "2000-01-01T01:00:00Z");

    let with_minutes =
        read("#YY  MM DD hh mm .0900 .1000\n#yr mo dy hr mn Hz Hz\n2007 02 28 23 40 1.00 MM\n");
    assert_eq!(with_minutes[0].time.unwrap().to_string(), "2007-02-28T23:40:00Z");
    assert!(near(with_minutes[0].variance_m2(), 0.01));
    // Two digits of the year, and a first frequency that is no wave.
    let old = read("YY MM DD hh .000 .010 .020\n96 12 31 05 7.0 1.0 2.0\n");
    assert_eq!(old[0].time.unwrap().to_string(), "1996-12-31T05:00:00Z");
    assert_eq!(*old[0].frequencies_hz, [0.01, 0.02]);
    assert!(near(old[0].variance_m2(), 0.03));
    // As Windows writes lines, and with a byte-order mark.
    let windows = format!("\u{feff}{}", HISTORY.replace('\n', "\r\n"));
    assert_eq!(read(&windows), seas);
}

#[test]
fn ww3_points_and_times() {
    let seas = read(WW3);
    assert_eq!(seas.len(), 4);
    assert_eq!(seas[0].source, Format::WaveWatch3);
    assert_eq!(seas[0].place.name.as_deref(), Some("first"));
    assert_eq!(seas[0].place.coordinates, Some([-171.12, 40.98]));
    assert_eq!(seas[1].place.name.as_deref(), Some("buoy 2"));
    assert_eq!(seas[3].time.unwrap().to_string(), "2022-09-12T07:00:00Z");
    assert_eq!(seas[3].energy, Energy::Calm);

    assert!(near(seas[0].variance_m2(), 2.0 * TAU * 0.1));
    assert!(near(seas[2].variance_m2(), TAU * 0.1));
    let all_round = spectrum(&seas[0], Directions::default());
    // The table's own directions are not even, and its sum by trapezoids does not mind.
    assert!(near(variance(&all_round), 2.0 * TAU * 0.1));
    // Frequencies within directions: 3 at 0.15 Hz towards 0.785 rad, north-east, and so from 225°.
    let beam = spectrum(&seas[1], Directions::default());
    let north_east = -45.02_f64.to_radians();
    assert!((beam.density_m2phzprad(0.15, north_east) - 3.0).abs() < 2e-3);
    let north_west = 3.0 * north_east;
    assert!(beam.density_m2phzprad(0.15, north_west) < 1e-9);
    assert!(beam.density_m2phzprad(0.1, north_east) < 1e-9);
}

/// 0.02 m²/(Hz deg) in one of four directions: m0 = 0.02 · 90 · 0.1 ln 1.25.
#[test]
fn swan_tables() {
    let seas = read(SWAN);
    assert_eq!(seas.len(), 4);
    assert_eq!(seas[0].source, Format::Swan);
    assert_eq!((&seas[1].energy, &seas[2].energy), (&Energy::Missing, &Energy::Calm));
    assert_eq!(seas[3].time.unwrap().to_string(), "2016-10-12T00:00:00Z");
    let m0 = 0.02 * 90.0 * 0.1 * 1.25_f64.ln();
    assert!(near(seas[0].variance_m2(), m0));
    assert!(near(seas[3].variance_m2(), 0.5 * m0));
    let table = spectrum(&seas[0], Directions::default());
    assert!((variance(&table) / m0 - 1.0).abs() < 0.01);
    assert!((mean_from_deg(&table).0 - 180.0).abs() < 0.1);
}

/// 90° anticlockwise from east is towards the north: the same waves as from the south.
#[test]
fn swan_cartesian_directions_and_energy() {
    let cartesian = SWAN
        .replace("NDIR ", "CDIR ")
        .replace("     0.0\n    90.0\n   180.0\n   270.0\n", "   0.0\n  180.0\n   90.0\n  270.0\n");
    let (cartesian, nautical) = (read(&cartesian), read(SWAN));
    let value = |sea, toward: f64| spectrum(sea, Directions::default()).density_m2phzprad(0.1, toward);
    for degree in (-180..180).step_by(15) {
        let toward = f64::from(degree).to_radians();
        assert!((value(&cartesian[0], toward) - value(&nautical[0], toward)).abs() < 1e-9, "{degree}");
    }
    // ρ g = 1025 · 9.81.
    let joules = SWAN.replace("VaDens", "EnDens").replace("1.0E-03", "10.05525");
    assert!(near(read(&joules)[0].variance_m2(), nautical[0].variance_m2()));
}

#[test]
fn swan_without_times() {
    let start = SWAN.find("TIME").unwrap();
    let places = SWAN.find("LONLAT").unwrap();
    let first = SWAN.find("20161011").unwrap();
    let second = SWAN.find("20161012").unwrap();
    let table = &SWAN[SWAN.find("FACTOR").unwrap()..second];
    let stationary = [&SWAN[..start], &SWAN[places..first], table].concat();
    let seas = read(&stationary);
    assert_eq!((seas.len(), seas[0].time), (2, None));
    assert_eq!(seas[0].energy, read(SWAN)[0].energy);
}

/// A spread of 30° is r₁ = 1 − ½ (π/6)².
#[test]
fn swan_means_and_spreads() {
    let text = "\
SWAN   1
TIME
 1
LOCATIONS
 1
 0.0 0.0
RFREQ
 2
 0.10
 0.20
QUANT
 3
VaDens
m2/Hz
 -0.9900E+02
CDIR
degr
 -0.9990E+03
DSPRDEGR
degr
 -0.9000E+01
19680606.030000
LOCATION   1
 0.5000E+00 0.0 30.0
 -0.9900E+02 -999.0 -9.0
19680606.040000
LOCATION   1
 0.5000E+00 -999.0 -9.0
 0.5000E+00 -999.0 -9.0
19680606.050000
NODATA
";
    let seas = read(text);
    assert!(matches!(seas[1].energy, Energy::Omnidirectional { .. }));
    assert_eq!(seas[2].energy, Energy::Missing);
    let spectrum = spectrum(&seas[0], Directions::default());
    // One triangle: ½ · 0.5 · 0.1.
    assert!(near(variance(&spectrum), 0.025));
    let (from_deg, r1) = mean_from_deg(&spectrum);
    assert!((from_deg - 270.0).abs() < 0.1, "towards the east: {from_deg}");
    let expected = 1.0 - 0.5 * (std::f64::consts::PI / 6.0).powi(2);
    assert!((r1 - expected).abs() < 2e-3, "{r1} {expected}");
}

#[test]
fn directions_are_read_from_beside_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let at = |extension: &str| folder.path().join(format!("41010.{extension}"));
    std::fs::write(at("data_spec"), DATA_SPEC).unwrap();
    assert_eq!(load(&at("data_spec")).unwrap()[0].energy, read(DATA_SPEC)[0].energy);
    let extensions = ["swdir", "swdir2", "swr1", "swr2"];
    for (extension, text) in extensions.into_iter().zip(DIRECTIONS).take(3) {
        std::fs::write(at(extension), text).unwrap();
    }
    let error = load(&at("data_spec")).unwrap_err().to_string();
    assert!(error.ends_with(
        "needs 41010.swr2 beside it; accepted: all of .swdir .swdir2 .swr1 .swr2, or none of them"
    ));
    std::fs::write(at("swr2"), DIRECTIONS[3]).unwrap();
    assert_eq!(load(&at("data_spec")).unwrap()[0].energy, with_directions()[0].energy);
    // An error is about the file that it is in.
    std::fs::write(at("swr1"), DIRECTIONS[2].replace("0.80 (0.120)", "1.80 (0.120)")).unwrap();
    let error = load(&at("data_spec")).unwrap_err().to_string();
    assert!(error.ends_with(
        "41010.swr1:2: found \"1.8\"; accepted: a number from 0 to 1, or MM or 999 where it is missing"
    ));
    let error = from_bytes(DIRECTIONS[0].as_bytes(), "x.swdir").unwrap_err().to_string();
    assert!(error.starts_with("x.swdir: directions without energy"));
}

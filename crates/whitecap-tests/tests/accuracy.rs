//! `docs/accuracy.md` says how near the sea is to what was asked for: measured here, and held to its bounds.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::DVec2;
use std::f64::consts::TAU;
use std::fmt::Write;
use whitecap_tests::repository::{alike, root, updates};
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::{
    Amplitudes, Band, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, Water,
};
use whitecap_waves::model::{Surface, SurfacePoint, WaveModel};
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::elfouhaily::Elfouhaily;
use whitecap_waves::spectrum::jonswap::{Jonswap, energy_scale, fetch_law_height_m};
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
use whitecap_waves::spectrum::pierson_moskowitz::PiersonMoskowitz;
use whitecap_waves::spectrum::tabulated::{
    DirectionMethod, DirectionalMoments, Tabulated, TabulatedParameters, even_directions, sampled,
};
use whitecap_waves::spectrum::tma::Tma;
use whitecap_waves::spectrum::{Omnidirectional, Profile, WaveSpectrum};
use whitecap_waves::spreading::{Spread, Spreading};
use whitecap_waves::statistics::{SeaStatistics, SurfaceStatistics, significant_height_m};

const INTRODUCTION: &str = "\
# Accuracy

How near the sea is to what was asked for. `crates/whitecap-tests/tests/accuracy.rs` measures these numbers, holds them to the
bounds below and writes this page (`cargo xtask docs`). See [spectra](spectra.md), [synthesis](synthesis.md) and
[queries](queries.md) for what is measured.
";

type System = Box<dyn WaveSpectrum>;

#[test]
fn the_page_says_what_is_measured() {
    let expected = format!("{INTRODUCTION}{}{}{}", synthesis(), queries(), known_values());
    let path = root().join("docs/accuracy.md");
    if updates() {
        std::fs::write(&path, &expected).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(alike(&found, &expected), "docs/accuracy.md is not what is measured; run `cargo xtask docs`");
}

/// Two significant digits, with decimals and without an exponent.
fn two_digits(x: f64) -> String {
    let decimals = (1.0 - x.abs().max(1e-9).log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{x:.decimals$}")
}

/// As above, for what rounding alone may leave.
fn percent(x: f64) -> String {
    if x < 0.01 { "< 0.01".to_owned() } else { two_digits(x) }
}

fn spread(
    omnidirectional: impl Omnidirectional + 'static,
    spreading: Spreading,
    dispersion: Dispersion,
) -> System {
    spread_toward(DVec2::from_angle(0.4), omnidirectional, spreading, dispersion)
}

fn spread_toward(
    toward: DVec2,
    omnidirectional: impl Omnidirectional + 'static,
    spreading: Spreading,
    dispersion: Dispersion,
) -> System {
    let spread = Spread { spreading, swell: 0.0 };
    let parameters = DirectionalParameters { spread, toward, dispersion };
    Box::new(Directional::new(omnidirectional, parameters).unwrap())
}

fn sea(systems: &[System], cascades: Vec<Cascade>, dispersion: Dispersion, seed: u64) -> SpectralSea {
    let parameters = SpectralSeaParameters {
        cascades,
        choppiness: 1.0,
        water: Water { dispersion, ..Water::STILL },
        seed,
        amplitudes: Amplitudes::Deterministic,
    };
    SpectralSea::new(parameters, systems).unwrap()
}

/// A wind sea of 1.6 m at 7 s that meets a swell of 0.9 m at 13 s, as a buoy's moments have them.
fn buoy(water: Dispersion) -> Tabulated {
    let frequencies_hz: Vec<f64> = (0..60).map(|i| 0.03 * 1.04_f64.powi(i)).collect();
    let swell = Jonswap::from_height_and_period(0.9, 13.0, 3.3).unwrap();
    let wind_sea = Jonswap::from_height_and_period(1.6, 7.0, 2.0).unwrap();
    let directions = 48;
    let toward_rad = even_directions(directions);
    let mut density = Vec::new();
    for &hz in &frequencies_hz {
        let energy = |spectrum: &Jonswap| TAU * spectrum.density_m2s(TAU * hz);
        let (long, short) = (energy(&swell), energy(&wind_sea));
        let all = long + short;
        // Both narrow and against each other: r1 is small where they are alike, and r2 is not.
        let moments = DirectionalMoments {
            r1: 0.8 * (long - short).abs() / all.max(1e-12),
            mean_toward_rad: if long > short { 0.4 } else { 3.3 },
            r2: 0.5,
            principal_toward_rad: 0.4,
        };
        let shape = sampled(moments.distribution(DirectionMethod::MaximumEntropy), directions);
        density.extend(shape.iter().map(|shape| all * shape));
    }
    Tabulated::new(TabulatedParameters { frequencies_hz, toward_rad, density }, &water).unwrap()
}

/// Every spectrum on three planned tiles.
fn synthesis() -> String {
    let shallow = Dispersion::at_depth(10.0).unwrap();
    let deep = Dispersion::DEEP;
    let cos2 = Spreading::CosSquared;
    let jonswap = |wind, fetch_km: f64| Jonswap::from_wind_and_fetch(wind, 1000.0 * fetch_km, 3.3).unwrap();
    let swell = Jonswap::from_height_and_period(1.0, 12.0, 5.0).unwrap();
    let phillips = Phillips::new(PhillipsParameters {
        wind_speed_mps: 10.0,
        toward: DVec2::X,
        significant_height_m: None,
        opposing_energy: 0.0,
        small_wave_cutoff_m: 0.0,
    });
    let cos2s = |exponent| Spreading::Cos2s { exponent };
    let seas: [(&str, Vec<System>, Dispersion); 13] = [
        (
            "Pierson–Moskowitz, 10 m/s",
            vec![spread(PiersonMoskowitz::from_wind(10.0).unwrap(), cos2, deep)],
            deep,
        ),
        ("JONSWAP, 5 m/s, 20 km", vec![spread(jonswap(5.0, 20.0), cos2, deep)], deep),
        ("JONSWAP, 10 m/s, 100 km", vec![spread(jonswap(10.0, 100.0), Spreading::Hasselmann, deep)], deep),
        ("JONSWAP, 20 m/s, 400 km", vec![spread(jonswap(20.0, 400.0), Spreading::Mitsuyasu, deep)], deep),
        (
            "TMA over 10 m, 10 m/s, 100 km",
            vec![spread(Tma::over(jonswap(10.0, 100.0), 10.0).unwrap(), cos2, shallow)],
            shallow,
        ),
        (
            "Elfouhaily, 10 m/s",
            vec![spread(Elfouhaily::from_wind(10.0).unwrap(), Spreading::Elfouhaily, deep)],
            deep,
        ),
        ("Phillips, 10 m/s", vec![Box::new(phillips.unwrap())], deep),
        (
            "JONSWAP, 10 m/s, 100 km, and a swell, 1 m, 12 s",
            vec![spread(jonswap(10.0, 100.0), cos2, deep), spread(swell, cos2s(20.0), deep)],
            deep,
        ),
        (
            "JONSWAP, 12 m/s, 20 km, Mitsuyasu",
            vec![spread(jonswap(12.0, 20.0), Spreading::Mitsuyasu, deep)],
            deep,
        ),
        (
            "JONSWAP, 12 m/s, 20 km, Donelan–Banner",
            vec![spread(jonswap(12.0, 20.0), Spreading::DonelanBanner, deep)],
            deep,
        ),
        (
            "JONSWAP, 12 m/s, 20 km, alike in all directions",
            vec![spread(jonswap(12.0, 20.0), cos2s(0.0), deep)],
            deep,
        ),
        (
            "JONSWAP, 12 m/s, 20 km, twice, against each other",
            vec![
                spread(jonswap(12.0, 20.0), cos2s(8.0), deep),
                spread_toward(-DVec2::from_angle(0.4), jonswap(12.0, 20.0), cos2s(8.0), deep),
            ],
            deep,
        ),
        ("a buoy's moments, by maximum entropy", vec![Box::new(buoy(deep))], deep),
    ];
    let mut text = "\n## Surfaces\n
Three planned tiles of 128² samples down to 0.1 m; amplitudes `deterministic`. The band is all waves that the tiles carry.
The surface is the one of seed 5 at 7 s; the difference is the largest of seeds 5, 6 and 7 at −1e6, 0 and 7 s. Bounds: the
surface is within 1 % of the band's Hs, and at most 0.5 % of the variance is left out.\n
| sea | Hs of the band, m | Hs on the surface, m | largest difference, % | variance left out, % | mean square slope, surface/spectrum |
| --- | --- | --- | --- | --- | --- |\n"
        .to_owned();
    for (name, systems, dispersion) in &seas {
        let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 0.1, cascades: 3, resolution: 128 };
        let cascades = Cascade::plan(systems, budget);
        let band = Band { from: 0.0, to: cascades.last().unwrap().band.to };
        let profiles: Vec<Profile> = systems.iter().map(Profile::of).collect();
        let m0: f64 = systems.iter().map(WaveSpectrum::variance_m2).sum();
        let in_band: f64 = profiles.iter().map(|profile| profile.variance_m2(band)).sum();
        let slope: f64 = profiles.iter().map(|profile| profile.mean_square_slope(Band::WHOLE)).sum();
        let asked_m = significant_height_m(in_band);
        let water = Water { dispersion: *dispersion, ..Water::STILL };
        let surfaces = [5, 6, 7].map(|seed| {
            let mut sea = sea(systems, cascades.clone(), *dispersion, seed);
            [7.0, 0.0, -1e6].map(|time_s| {
                let tiles = sea.tiles_mut().iter_mut().map(|tile| tile as &mut dyn WaveModel);
                SurfaceStatistics::measure(tiles, &water, time_s).sea
            })
        });
        let off = |found: &SeaStatistics| 100.0 * (found.significant_height_m() / asked_m - 1.0).abs();
        let difference = surfaces.iter().flatten().map(off).fold(0.0, f64::max);
        let found = &surfaces[0][0];
        let found_m = found.significant_height_m();
        let lost = 100.0 * (1.0 - in_band / m0);
        writeln!(
            text,
            "| {name} | {asked_m:.2} | {found_m:.2} | {} | {} | {:.3} / {slope:.3} |",
            percent(difference),
            percent(lost),
            found.slope.total()
        )
        .unwrap();
        assert!(difference < 1.0, "{name}: {asked_m} m asked, {found_m} m found");
        assert!(lost < 0.5, "{name}: {lost} % lost");
    }
    text
}

/// The error of height in metres, of the normal in radians and of velocity in m/s of an answer. The direct sum at
/// the water's rest point is brought to the place by its own slope.
fn error(sea: &SpectralSea, place_m: DVec2, found: &SurfacePoint, time_s: f64) -> (f64, f64, f64) {
    let along = |point: &SurfacePoint| DVec2::new(point.displacement_m.x, point.displacement_m.z);
    let nearly = place_m - along(&sea.sample(place_m - along(found), time_s));
    let direct = sea.sample(nearly, time_s);
    let rest = place_m - nearly - along(&direct);
    let climb = -(direct.normal.x * rest.x + direct.normal.z * rest.y) / direct.normal.y;
    let height = found.height_m() - direct.height_m() - climb;
    let angle = found.normal.angle_between(direct.normal);
    (height.abs(), angle, found.velocity_mps.distance(direct.velocity_mps))
}

/// Answers against the direct sum over all waves.
fn queries() -> String {
    let mut text = "\n## Queries\n
`Surface::query` at 200 places, from the origin to 1,000 km away, against the direct sum: fully developed Pierson–Moskowitz seas,
three planned tiles of 64² samples, at 100,000 s. The worst of each; places where the Jacobian is below 0.3 are left out.
Bounds: 1 mm or 0.1 % of Hs, whichever is larger, for velocities as much a second; normals 0.1°.\n
| wind, m/s | Hs, m | height, mm | height, % of Hs | normal, degrees | velocity, mm/s |
| --- | --- | --- | --- | --- | --- |\n"
        .to_owned();
    for wind_mps in [2.0, 8.0, 15.0, 25.0] {
        let spectrum = PiersonMoskowitz::from_wind(wind_mps).unwrap();
        let systems = [spread(spectrum, Spreading::Hasselmann, Dispersion::DEEP)];
        let shortest_wave_m = 0.002 * wind_mps * wind_mps;
        let budget = CascadeBudget { tile_size_m: None, shortest_wave_m, cascades: 3, resolution: 64 };
        let sea = sea(&systems, Cascade::plan(&systems, budget), Dispersion::DEEP, 5);
        let places: Vec<DVec2> = (0..200).map(place).collect();
        let answers = sea.query(&places, 1e5).unwrap();
        let compared: Vec<_> =
            places.iter().zip(&answers).filter(|(_, answer)| answer.jacobian >= 0.3).collect();
        assert!(compared.len() > 180, "{wind_mps} m/s: only {} compared", compared.len());
        let (mut height, mut angle, mut speed) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (place, answer) in compared {
            let found = error(&sea, *place, answer, 1e5);
            (height, angle, speed) = (height.max(found.0), angle.max(found.1), speed.max(found.2));
        }
        let asked_m = significant_height_m(sea.variance_m2());
        writeln!(
            text,
            "| {wind_mps} | {asked_m:.2} | {} | {} | {} | {} |",
            two_digits(1e3 * height),
            two_digits(100.0 * height / asked_m),
            two_digits(angle.to_degrees()),
            two_digits(1e3 * speed)
        )
        .unwrap();
        assert!(height < (1e-3 * asked_m).max(1e-3), "{wind_mps} m/s: {height} m");
        assert!(speed < (1e-3 * asked_m).max(1e-3), "{wind_mps} m/s: {speed} m/s");
        assert!(angle.to_degrees() < 0.1, "{wind_mps} m/s: {angle} rad");
    }
    text
}

/// Places all over, none twice.
fn place(i: u32) -> DVec2 {
    let far = [100.0, 3e4, 1e6][i as usize % 3];
    let i = f64::from(i + 1);
    far * DVec2::new((0.754_877_666 * i).fract() - 0.5, (0.569_840_291 * i).fract() - 0.5)
}

/// Numbers that have been published, or follow by hand.
fn known_values() -> String {
    let mut text = "\n## Known values\n
g = 9.81 m/s². To within 0.1 %.\n
| value | expected | calculated |
| --- | --- | --- |\n"
        .to_owned();
    let sea = PiersonMoskowitz::from_wind_at_19_5_m(10.0).unwrap();
    let jonswap = Jonswap::from_wind_and_fetch(10.0, 1e5, 3.3).unwrap();
    let wavelength = |water: Dispersion, period_s: f64| TAU / water.wave_number(TAU / period_s);
    let shallow = Dispersion::at_depth(10.0).unwrap();
    let capillary = Dispersion::DEEP.with_surface_tension();
    for (name, expected, found) in [
        ("Pierson–Moskowitz, U19.5 = 10 m/s: Hs, m", 2.1330, sea.significant_height_m()),
        ("the same: Tp, s", 7.302, sea.peak_period_s()),
        ("the same: Tz, s", 5.187, sea.zero_crossing_period_s()),
        ("JONSWAP, 10 m/s, 100 km: α", 0.076 * 9810.0_f64.powf(-0.22), energy_scale(10.0, 1e5)),
        ("the same: Tp, s", TAU / 22.0 * (10.0 * 1e5 / 9.81_f64.powi(2)).cbrt(), jonswap.peak_period_s()),
        (
            "the same: Hs by the law of fetch, m",
            0.0016 * 9810.0_f64.sqrt() * 100.0 / 9.81,
            fetch_law_height_m(10.0, 1e5),
        ),
        ("TMA: Φ at kd = 1", 0.5800 / (1.0 + 2.0 / 3.6269), whitecap_waves::spectrum::tma::depth_factor(1.0)),
        ("wavelength of 10 s in deep water, m", 156.131, wavelength(Dispersion::DEEP, 10.0)),
        ("wavelength of 10 s over 10 m, m", 92.374, wavelength(shallow, 10.0)),
        ("group speed of 10 s over 10 m, m/s", 8.0699, shallow.group_speed(TAU / 92.374)),
        ("phase speed of 17.26 mm with surface tension, m/s", 0.23213, capillary.phase_speed(TAU / 0.01726)),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-3, "{name}: {found}, not {expected}");
        writeln!(text, "| {name} | {expected:.4} | {found:.4} |").unwrap();
    }
    text
}

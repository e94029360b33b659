use super::*;
use crate::GRAVITY_MPS2;
use crate::direction::{nautical_from_toward, toward_from_nautical};
use crate::dispersion::Dispersion;
use crate::model::spectral::{
    Amplitudes, Band, Cascade, SpectralSea, SpectralSeaParameters, SpectralTile, SpectralTileParameters,
    Water,
};
use crate::model::{Surface, SurfacePoint, TileFields, WaveModel};
use crate::spectrum::WaveSpectrum;
use crate::spectrum::phillips::{Phillips, PhillipsParameters};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

/// Gaussian in the wave-number plane, as in the documentation of the trait.
struct Swell {
    peak: DVec2,
    width: f64,
    variance_m2: f64,
}

impl WaveSpectrum for Swell {
    fn density_m4(&self, k: DVec2) -> f64 {
        let spread = 2.0 * self.width * self.width;
        self.variance_m2 / (PI * spread) * libm::exp(-k.distance_squared(self.peak) / spread)
    }
    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }
}

/// Peaked as JONSWAP's with γ, spread as cos^2s, with α = 0.01 and deep water.
struct Peaked {
    peak_omega: f64,
    gamma: f64,
    s: f64,
    toward: DVec2,
}

impl WaveSpectrum for Peaked {
    fn density_m4(&self, k: DVec2) -> f64 {
        let length = k.length();
        let omega = (GRAVITY_MPS2 * length).sqrt();
        let x = omega / self.peak_omega;
        let sigma = if x <= 1.0 { 0.07 } else { 0.09 };
        let peak = libm::pow(self.gamma, libm::exp(-0.5 * ((x - 1.0) / sigma).powi(2)));
        let density =
            0.01 * GRAVITY_MPS2.powi(2) * libm::pow(omega, -5.0) * libm::exp(-1.25 / x.powi(4)) * peak;
        let gammas = libm::lgamma(self.s + 1.0) - libm::lgamma(self.s + 0.5);
        let cos2_half = 0.5 * (1.0 + (k / length).dot(self.toward)).max(0.0);
        let spread = libm::exp(gammas) / (2.0 * PI.sqrt()) * libm::pow(cos2_half, self.s);
        density * spread * 0.5 * GRAVITY_MPS2 / omega / length
    }
    fn variance_m2(&self) -> f64 {
        0.01 * GRAVITY_MPS2.powi(2) / (5.0 * self.peak_omega.powi(4)) * 2.2252
    }
}

fn west_wind(wind_speed_mps: f64) -> Phillips {
    wind(wind_speed_mps, DVec2::X)
}

fn wind(wind_speed_mps: f64, toward: DVec2) -> Phillips {
    Phillips::new(PhillipsParameters {
        wind_speed_mps,
        toward,
        significant_height_m: None,
        opposing_energy: 0.0,
        small_wave_cutoff_m: 0.0,
    })
    .unwrap()
}

fn statistics<S: WaveSpectrum>(spectra: &[S]) -> SeaStatistics {
    SeaStatistics::of(spectra, Dispersion::DEEP, Band::WHOLE).unwrap()
}

/// E|k|² of a plane Gaussian is its peak's plus its width's, in each direction.
#[test]
fn a_gaussian_swell_however_narrow() {
    for (width, tolerance) in [(0.01, 1e-4), (0.005, 1e-4), (0.0005, 1e-3)] {
        let toward = toward_from_nautical(200.0);
        let sea = statistics(&[Swell { peak: 0.05 * toward, width, variance_m2: 0.25 }]);
        near(sea.moments.m0, 0.25, tolerance);
        near(sea.significant_height_m(), 2.0, tolerance);
        near(sea.slope.total(), 0.25 * (0.0025 + 2.0 * width * width), tolerance);
        let (along, across) = sea.slope_along_and_across().unwrap();
        near(along, 0.25 * (0.0025 + width * width), tolerance);
        near(across, 0.25 * width * width, 2e-3);
        assert!((nautical_from_toward(sea.mean_toward().unwrap()) - 200.0).abs() < 1e-6);
        assert!((nautical_from_toward(sea.peak_toward().unwrap()) - 200.0).abs() < 1e-6);
        if width < 0.001 {
            near(sea.spread_rad().unwrap(), width / 0.05, 2e-3);
            near(sea.peak_period_s.unwrap(), TAU / (GRAVITY_MPS2 * 0.05).sqrt(), 1e-3);
        }
    }
}

/// S = A ω⁻⁵ exp(−(g/U)⁴ ω⁻⁴), whose moments are gamma functions: mₙ = A/4 Γ(1 − n/4) (g/U)^(n − 4), and cos²
/// over half the compass: r1 = (4/3)/(π/2), and a slope three times as steep along the wind as across, in squares.
#[test]
fn phillips_sea_has_gamma_functions_for_moments() {
    for wind_speed_mps in [5.0, 10.0, 20.0] {
        let spectrum = west_wind(wind_speed_mps);
        let sea = statistics(&[spectrum]);
        let m0 = spectrum.variance_m2();
        let ratio = GRAVITY_MPS2 / wind_speed_mps;
        near(sea.moments.m0, m0, 2e-4);
        near(sea.moments.minus_1, m0 * libm::tgamma(1.25) / ratio, 2e-4);
        near(sea.moments.m1, m0 * libm::tgamma(0.75) * ratio, 2e-4);
        // The tail of m2 beyond the band.
        near(sea.moments.m2, m0 * PI.sqrt() * ratio * ratio, 4e-3);
        near(sea.peak_period_s.unwrap(), TAU / (libm::pow(0.8, 0.25) * ratio), 2e-4);
        near(sea.zero_crossing_period_s().unwrap(), TAU / (libm::pow(PI, 0.25) * ratio), 2e-3);
        near(sea.mean_period_s().unwrap(), TAU / (libm::tgamma(0.75) * ratio), 2e-4);
        near(sea.energy_period_s().unwrap(), TAU * libm::tgamma(1.25) / ratio, 2e-4);
        near(sea.directions.r1(), 8.0 / (3.0 * PI), 2e-4);
        let (along, across) = sea.slope_along_and_across().unwrap();
        near(along / across, 3.0, 1e-3);
        assert!((nautical_from_toward(sea.mean_toward().unwrap()) - 270.0).abs() < 1e-9);
    }
}

/// ∫ of the peaked form over that of Pierson and Moskowitz is 2.2252 for γ = 7; r1 of cos^2s is s/(s + 1).
#[test]
fn a_narrow_peak_is_integrated_to_a_thousandth() {
    for s in [10.0, 100.0, 1000.0] {
        let spectrum = Peaked { peak_omega: 0.5, gamma: 7.0, s, toward: toward_from_nautical(30.0) };
        let expected = spectrum.variance_m2();
        let sea = statistics(&[spectrum]);
        near(sea.moments.m0, expected, 2e-4);
        near(sea.directions.r1(), s / (s + 1.0), 1e-5);
        near(sea.spread_rad().unwrap(), (2.0 / (s + 1.0)).sqrt(), 1e-3);
        near(sea.peak_period_s.unwrap(), TAU / 0.5, 2e-3);
        assert!((nautical_from_toward(sea.mean_toward().unwrap()) - 30.0).abs() < 1e-6);
    }
}

#[test]
fn variances_of_systems_add_and_opposite_ones_have_no_direction() {
    let swell = |sign: f64| Swell { peak: DVec2::X * 0.05 * sign, width: 0.005, variance_m2: 0.25 };
    let sea = statistics(&[swell(1.0), swell(-1.0)]);
    near(sea.moments.m0, 0.5, 1e-4);
    assert_eq!(sea.mean_toward(), None);
    assert_eq!(statistics::<Swell>(&[]), SeaStatistics::default());
}

#[test]
fn bands_share_out_the_energy() {
    let sea = PolarSpectrum::of(&[west_wind(10.0)], Dispersion::DEEP, Band::WHOLE).unwrap();
    let within = |band| {
        let (variance_m2, slope) = sea.within(band);
        (variance_m2, slope.total(), slope.xz)
    };
    let band = |from, to| within(Band { from, to });
    let (m0, slope, diagonal) = band(1e-4, 1e4);
    near(m0, sea.total().energy_m2, 1e-9);
    near(slope, sea.slope().total(), 1e-9);
    assert!((diagonal - sea.slope().xz).abs() < 1e-9 * slope);
    near(within(Band::WHOLE).0, m0, 1e-9);
    near(within(Band::WHOLE).1, slope, 1e-9);
    let (low, high) = (band(1e-4, 0.123), band(0.123, 1e4));
    near(low.0 + high.0, m0, 1e-9);
    near(low.1 + high.1, slope, 1e-9);
    // Below k the sea has exp(−1/(kL)²) of its energy.
    near(low.0 / m0, libm::exp(-(GRAVITY_MPS2 / (0.123 * 100.0)).powi(2)), 1e-3);
}

#[test]
fn what_charts_show_integrates_to_the_variance() {
    let toward = toward_from_nautical(120.0);
    let spectrum = Peaked { peak_omega: 0.7, gamma: 3.3, s: 12.0, toward };
    // A bottom changes frequencies, and no energy.
    let dispersion = Dispersion::at_depth(15.0).unwrap();
    let sea = PolarSpectrum::of(&[spectrum], dispersion, Band::WHOLE).unwrap();
    let m0 = sea.total().energy_m2;
    let samples = sea.frequency_spectrum();
    let area: f64 = samples.windows(2).map(|w| 0.5 * (w[0].1 + w[1].1) * (w[1].0 - w[0].0)).sum();
    near(area, m0, 1e-3);
    let around = sea.direction_spectrum();
    let width = TAU / around.len() as f64;
    near(around.iter().map(|sample| sample.1 * width).sum(), m0, 1e-9);
    let strongest = around.iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    assert!(strongest.0.dot(toward) > 0.999);
    // One frequency, all directions.
    let (frequency_hz, density) = samples[samples.len() / 2];
    let mean = (0..720)
        .map(|j| sea.directional_density(frequency_hz, DVec2::from_angle(f64::from(j) * TAU / 720.0)));
    near(mean.sum::<f64>() * TAU / 720.0, density, 1e-3);
    assert_eq!(sea.directional_density(1e-9, DVec2::X), 0.0);
}

#[test]
fn bands_and_densities_are_checked() {
    struct Broken;
    impl WaveSpectrum for Broken {
        fn density_m4(&self, k: DVec2) -> f64 {
            if k.x > 1.0 { f64::NAN } else { 0.0 }
        }
        fn variance_m2(&self) -> f64 {
            1.0
        }
    }
    assert!(SeaStatistics::of(&[Broken], Dispersion::DEEP, Band::WHOLE).is_err());
    for (from, to) in
        [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (1.0, f64::NAN), (1e4, f64::INFINITY), (0.0, 1e-4)]
    {
        let band = Band { from, to };
        assert!(SeaStatistics::of(&[west_wind(5.0)], Dispersion::DEEP, band).is_err(), "{band:?}");
    }
}

fn tile<S: WaveSpectrum>(tile_size_m: f64, resolution: usize, spectrum: S) -> SpectralTile {
    let parameters = SpectralTileParameters {
        tile_size_m,
        resolution,
        band: Band::WHOLE,
        choppiness: 1.0,
        water: Water::STILL,
        seed: 5,
        amplitudes: Amplitudes::Deterministic,
    };
    SpectralTile::new(parameters, &[spectrum]).unwrap()
}

/// The surface says what the spectrum says, and where its waves go: one look could not tell.
#[test]
fn a_synthesised_surface_is_the_sea_of_its_spectrum() {
    for from_deg in [20.0, 115.0, 250.0, 350.0] {
        let spectrum = wind(8.0, toward_from_nautical(from_deg));
        let mut tile = tile(500.0, 128, spectrum);
        let theory = PolarSpectrum::of(&[spectrum], Dispersion::DEEP, Band::WHOLE).unwrap();
        let surface = SurfaceStatistics::measure([&mut tile as &mut dyn WaveModel], &Water::STILL, 12.5);
        let (expected, found) = (theory.statistics(), &surface.sea);
        near(found.significant_height_m(), significant_height_m(tile.variance_m2()), 1e-3);
        near(found.significant_height_m(), expected.significant_height_m(), 0.02);
        let turn = nautical_from_toward(found.mean_toward().unwrap()) - from_deg;
        assert!(turn.abs() < 1.0, "{turn}° off");
        near(found.spread_rad().unwrap(), expected.spread_rad().unwrap(), 0.03);
        near(found.energy_period_s().unwrap(), expected.energy_period_s().unwrap(), 0.02);
        near(found.peak_period_s.unwrap(), expected.peak_period_s.unwrap(), 0.06);
        // The lattice reaches into its corners.
        let (_, resolved) = theory.within(Band::of_tile(500.0, 128));
        near(found.slope.total(), resolved.total(), 0.15);
        assert!(surface.skewness.abs() < 0.2 && (surface.kurtosis - 3.0).abs() < 0.5);
    }
}

#[test]
fn rings_of_the_lattice_follow_the_spectrum() {
    let spectrum = west_wind(10.0);
    let mut tile = tile(1500.0, 256, spectrum);
    let surface = SurfaceStatistics::measure([&mut tile as &mut dyn WaveModel], &Water::STILL, 0.0);
    let samples = PolarSpectrum::of(&[spectrum], Dispersion::DEEP, Band::WHOLE).unwrap().frequency_spectrum();
    let mut compared = 0;
    for bin in surface.bins.iter().filter(|bin| (0.13..0.36).contains(&bin.frequency_hz)) {
        let after = samples.partition_point(|sample| sample.0 < bin.frequency_hz);
        near(bin.density_m2phz, samples[after].1, 0.12);
        near(bin.filled, 1.0, 0.2);
        compared += 1;
    }
    assert!(compared > 15, "{compared}");
    // In the corners of the lattice some directions are missing.
    assert!(surface.bins.iter().any(|bin| bin.frequency_hz > 0.38 && bin.filled < 0.5));
    let sum: f64 = surface.bins.iter().map(|bin| bin.sum.energy_m2).sum();
    near(sum, tile.variance_m2(), 2e-3);
    let sectors = surface.sectors(24);
    near(sectors.iter().sum::<f64>() * TAU / 24.0, tile.variance_m2(), 2e-3);
    // cos² at the sectors' middles: most to the east, half of that at 45°, nothing to the west.
    near(sectors[0], spectrum.variance_m2() * 2.0 / PI, 0.08);
    near(sectors[3] / sectors[0], 0.5, 0.15);
    assert!(sectors[12] < 1e-6 * sectors[0], "{sectors:?}");
}

/// Where a tile hands over to the next, rings hold cells of both, and what they measure is the spectrum all the same.
#[test]
fn rings_across_the_borders_of_tiles_follow_the_spectrum() {
    let spectrum = west_wind(10.0);
    let cascades = Cascade::split(&[(1000.0, 128), (210.0, 128), (37.0, 64)]);
    let borders: Vec<f64> = cascades[1..].iter().map(|cascade| cascade.band.from).collect();
    let parameters = SpectralSeaParameters {
        cascades,
        choppiness: 1.0,
        water: Water::STILL,
        seed: 4,
        amplitudes: Amplitudes::Deterministic,
    };
    let mut tiles = SpectralSea::new(parameters, &[spectrum]).unwrap().into_tiles();
    let surface = SurfaceStatistics::measure(
        tiles.iter_mut().map(|tile| tile as &mut dyn WaveModel),
        &Water::STILL,
        0.0,
    );
    let samples = PolarSpectrum::of(&[spectrum], Dispersion::DEEP, Band::WHOLE).unwrap().frequency_spectrum();
    let mut at_borders = 0;
    for bin in surface.bins.iter().filter(|bin| (0.5..2.0).contains(&bin.filled) && bin.frequency_hz > 0.12) {
        let wave_number = Dispersion::DEEP.wave_number(TAU * bin.frequency_hz);
        let is_near = borders.iter().any(|border| (wave_number / border - 1.0).abs() < 0.15);
        let after = samples.partition_point(|sample| sample.0 < bin.frequency_hz);
        if is_near {
            near(bin.density_m2phz, samples[after].1, 0.12);
            at_borders += 1;
        }
    }
    assert!(at_borders >= 6, "{at_borders}");
}

/// One sine of amplitude 1 m, 20 m long.
struct Sine {
    speed: f64,
}

impl Surface for Sine {
    fn variance_m2(&self) -> f64 {
        0.5
    }
    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        let k = TAU / 20.0;
        let (sin, cos) = (k * rest_m.y - self.speed * time_s).sin_cos();
        SurfacePoint::upright(cos, DVec2::new(0.0, -k * sin), self.speed * sin)
    }
}

impl WaveModel for Sine {
    fn tile_size_m(&self) -> f64 {
        20.0
    }
    fn resolution(&self) -> usize {
        32
    }
    fn evaluate(&mut self, time_s: f64, fields: &mut TileFields) {
        fields.resize(32);
        for i in 0..1024 {
            let point = self.sample(DVec2::new(0.0, (i / 32) as f64 * 20.0 / 32.0), time_s);
            fields.height[i] = point.displacement_m.y as f32;
            (fields.slope_x[i], fields.slope_z[i]) = (0.0, point.slope.y as f32);
        }
    }
}

#[test]
fn a_sine_goes_where_it_goes() {
    let omega = Dispersion::DEEP.angular_frequency(TAU / 20.0);
    for (speed, toward) in [(omega, DVec2::Y), (-omega, -DVec2::Y)] {
        let mut sine = Sine { speed };
        let surface = SurfaceStatistics::measure([&mut sine as &mut dyn WaveModel], &Water::STILL, 3.0);
        near(surface.sea.moments.m0, 0.5, 1e-6);
        near(surface.kurtosis, 1.5, 1e-5);
        near(surface.sea.slope.zz, 0.5 * (TAU / 20.0).powi(2), 1e-5);
        near(surface.sea.zero_crossing_period_s().unwrap(), TAU / omega, 1e-5);
        assert!(surface.sea.mean_toward().unwrap().distance(toward) < 1e-6);
        assert!(surface.sea.spread_rad().unwrap() < 1e-2);
    }
    // Two independent sines: variances and cumulants add, and opposite ones have no direction.
    let (mut there, mut back) = (Sine { speed: omega }, Sine { speed: -omega });
    let tiles = [&mut there as &mut dyn WaveModel, &mut back];
    let surface = SurfaceStatistics::measure(tiles, &Water::STILL, 0.0);
    near(surface.sea.moments.m0, 1.0, 1e-6);
    near(surface.kurtosis, 2.25, 1e-5);
    assert!(surface.sea.directions.r1() < 1e-4, "{}", surface.sea.directions.r1());
}

/// A current that is faster than the waves carries them backwards over the ground, and they are still what they are.
#[test]
fn a_current_does_not_change_where_waves_go_in_the_water() {
    let k = TAU / 20.0;
    let omega = Dispersion::DEEP.angular_frequency(k);
    for current in [-12.0, -3.0, 3.0, 12.0] {
        let mut sine = Sine { speed: omega + k * current };
        let current_mps = DVec2::new(5.0, current);
        let surface = SurfaceStatistics::measure(
            [&mut sine as &mut dyn WaveModel],
            &Water { current_mps, ..Water::STILL },
            3.0,
        );
        near(surface.sea.moments.m0, 0.5, 1e-6);
        assert!(surface.sea.mean_toward().unwrap().distance(DVec2::Y) < 1e-6);
        assert!(surface.sea.spread_rad().unwrap() < 1e-2, "{current} m/s");
    }
}

#[test]
fn calm_water_has_nothing() {
    let still: [&mut dyn WaveModel; 0] = [];
    let surface = SurfaceStatistics::measure(still, &Water::STILL, 0.0);
    assert_eq!((surface.sea, surface.kurtosis, surface.bins.len()), (SeaStatistics::default(), 0.0, 0));
    let nothing: [Phillips; 0] = [];
    let parameters = SpectralTileParameters {
        tile_size_m: 100.0,
        resolution: 16,
        band: Band::WHOLE,
        choppiness: 1.0,
        water: Water::STILL,
        seed: 5,
        amplitudes: Amplitudes::Deterministic,
    };
    let mut tile = SpectralTile::new(parameters, &nothing).unwrap();
    let surface = SurfaceStatistics::measure([&mut tile as &mut dyn WaveModel], &Water::STILL, 0.0);
    assert_eq!((surface.sea, surface.kurtosis, surface.bins.len()), (SeaStatistics::default(), 0.0, 0));
}

/// What a loop makes of frequencies is not taken for waves that run the other way.
#[test]
fn a_loop_is_measured_as_it_runs() {
    for loop_s in [60.0, 20.0, 5.0] {
        let water = Water { loop_s: Some(loop_s), ..Water::STILL };
        let spectrum = west_wind(8.0);
        let parameters = SpectralTileParameters {
            tile_size_m: 400.0,
            resolution: 64,
            band: Band::WHOLE,
            choppiness: 1.0,
            water,
            seed: 5,
            amplitudes: Amplitudes::Deterministic,
        };
        let mut tile = SpectralTile::new(parameters, &[spectrum]).unwrap();
        let surface = SurfaceStatistics::measure([&mut tile as &mut dyn WaveModel], &water, 3.0);
        let sum: f64 = surface.waves.iter().flat_map(LatticeWaves::waves).map(|(_, energy)| energy).sum();
        near(sum, tile.variance_m2(), 5e-3);
        near(surface.sea.spread_rad().unwrap(), 0.55, 0.02);
    }
}

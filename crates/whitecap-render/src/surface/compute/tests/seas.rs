//! Both backends on every kind of sea: fields and maps alike within 1e-4 of the significant height, everywhere.

use super::maps::{floats, maps_of, texels};
use super::*;
use crate::surface::Backend;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::Surface;
use whitecap_waves::model::spectral::{Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters};
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::elfouhaily::Elfouhaily;
use whitecap_waves::spectrum::jonswap::Jonswap;
use whitecap_waves::spectrum::tma::Tma;
use whitecap_waves::spreading::{Spread, Spreading};
use whitecap_waves::statistics::significant_height_m;

const TIMES_S: [f64; 4] = [-1e6, 0.0, 3.7, 1e6];

const OPPOSED: Spread = Spread { spreading: Spreading::Hasselmann, swell: 0.0 };

fn tiles<S: WaveSpectrum>(
    spectrum: &S,
    cascades: Vec<Cascade>,
    choppiness: f64,
    water: Water,
    amplitudes: Amplitudes,
) -> Vec<SpectralTile> {
    let parameters = SpectralSeaParameters { cascades, choppiness, water, seed: 5, amplitudes };
    SpectralSea::new(parameters, &[spectrum]).unwrap().into_tiles()
}

/// The tiles of each kind of sea; of equal calls the same.
fn seas(choppiness: f64) -> Vec<(&'static str, Vec<SpectralTile>)> {
    let toward = DVec2::from_angle(2.1);
    let current_mps = DVec2::new(-0.4, 0.9);
    let jonswap = || Jonswap::from_height_and_period(2.0, 7.0, 3.3).unwrap();

    let shallow = Dispersion::at_depth(8.0).unwrap();
    let parameters = DirectionalParameters { spread: OPPOSED, toward, dispersion: shallow };
    let tma = Directional::new(Tma::over(jonswap(), 8.0).unwrap(), parameters).unwrap();
    let over_a_bottom = Water { dispersion: shallow, ..Water::STILL };

    let capillary = Dispersion::DEEP.with_surface_tension();
    let spread = Spread { spreading: Spreading::Cos2s { exponent: 2.0 }, swell: 0.0 };
    let parameters = DirectionalParameters { spread, toward, dispersion: capillary };
    let ripples = Directional::new(Elfouhaily::from_wind(1.5).unwrap(), parameters).unwrap();
    let with_tension = Water { dispersion: capillary, current_mps, ..Water::STILL };

    let parameters = DirectionalParameters { spread: OPPOSED, toward, dispersion: Dispersion::DEEP };
    let deep = Directional::new(jonswap(), parameters).unwrap();
    let in_a_loop = Water { current_mps, loop_s: Some(90.0), ..Water::STILL };
    let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 0.3, cascades: 3, resolution: 128 };
    let planned = Cascade::plan(&[&deep], budget);
    assert_eq!(planned.len(), 3);

    let whole = |tile_size_m| vec![Cascade::whole(tile_size_m, 128)];
    let (exact, normal) = (Amplitudes::Deterministic, Amplitudes::Gaussian);
    vec![
        ("finite depth", tiles(&tma, whole(300.0), choppiness, over_a_bottom, normal)),
        ("surface tension", tiles(&ripples, whole(3.0), choppiness, with_tension, exact)),
        ("a loop", tiles(&deep, whole(500.0), choppiness, in_a_loop, normal)),
        ("bands", tiles(&deep, planned, choppiness, Water::STILL, exact)),
        (
            "bands over a bottom",
            tiles(&tma, Cascade::split(&[(300.0, 64), (41.0, 64)]), choppiness, over_a_bottom, exact),
        ),
    ]
}

/// Lengths to 1e-4 of the significant height of the tile; slopes and gradients, which grow with the shortest waves and not
/// with the height, to as much of four times the slopes' r.m.s.
#[test]
fn both_backends_agree_on_every_kind_of_sea() {
    let Some(gpu) = gpu() else { return };
    for choppiness in [0.0, 1.5] {
        for (kind, tiles) in seas(choppiness) {
            for (i, mut tile) in tiles.into_iter().enumerate() {
                let height_m = significant_height_m(tile.variance_m2());
                assert!(height_m > 0.0, "{kind}");
                let [samples, coefficients] = [ON_SAMPLES, Vertices::Anywhere].map(|vertices| {
                    SpectralFields::new(&gpu.device, &gpu.queue, &WaveConstants::of(&tile, vertices))
                });
                let mut expected = TileFields::new(tile.resolution());
                for time_s in TIMES_S {
                    let mut agree = |evaluated: fn(&mut SpectralTile, f64, &mut TileFields), fields| {
                        evaluated(&mut tile, time_s, &mut expected);
                        let seen = evaluate(gpu, fields, time_s);
                        let both = arrays(&expected).into_iter().zip(arrays(&seen));
                        let squares = mean_square(&expected.slope_x) + mean_square(&expected.slope_z);
                        for (number, ((name, expected), (_, seen))) in both.enumerate() {
                            let whole = if number < 3 { height_m } else { 4.0 * squares.sqrt() };
                            let worst = worst(expected, seen);
                            assert!(
                                worst <= 1e-4 * whole,
                                "{name} of {kind}, tile {i}, λ {choppiness}, at {time_s}: {worst} of {whole}"
                            );
                        }
                    };
                    agree(SpectralTile::evaluate, &samples);
                    agree(SpectralTile::evaluate_coefficients, &coefficients);
                }
            }
        }
    }
}

/// The same of the maps that are drawn.
#[test]
fn both_backends_make_the_same_maps_of_every_kind_of_sea() {
    let Some(gpu) = gpu() else { return };
    for choppiness in [0.0, 1.5] {
        let kinds = seas(choppiness).into_iter().zip(seas(choppiness));
        for ((kind, on_processor), (_, on_device)) in kinds {
            for (i, (one, other)) in on_processor.into_iter().zip(on_device).enumerate() {
                let height_m = significant_height_m(one.variance_m2());
                let levels = one.resolution().ilog2();
                let mut both = [(Backend::Cpu, one), (Backend::Gpu, other)]
                    .map(|(backend, tile)| maps_of(gpu, backend, Box::new(tile), ON_SAMPLES));
                for time_s in [-1e6, 1e6] {
                    let mut encoder = gpu.device.create_command_encoder(&Default::default());
                    both.iter_mut().for_each(|maps| maps.update(&gpu.queue, &mut encoder, time_s));
                    gpu.queue.submit([encoder.finish()]);
                    let at = format!("{kind}, tile {i}, λ {choppiness}, at {time_s}");
                    let [expected, seen] = [0, 1].map(|m| floats(gpu, &both[m].textures.displacement));
                    let off = worst(&expected, &seen);
                    assert!(off <= 1e-4 * height_m, "displacement of {at}: {off} of {height_m}");
                    let [expected, seen] = [0, 1].map(|m| floats(gpu, &both[m].textures.slopes));
                    let off = worst(&expected, &seen);
                    assert!(off <= 4e-4 * mean_square(&expected).sqrt(), "slopes of {at}: {off}");
                    for mip in 0..=levels {
                        let [expected, seen] = [0, 1].map(|m| texels(gpu, &both[m], mip));
                        for (expected, seen) in expected.iter().flatten().zip(seen.iter().flatten()) {
                            // A half float that is rounded the other way.
                            let allowed = expected.abs() / 1000.0 + 1e-4;
                            assert!(
                                (expected - seen).abs() < allowed,
                                "level {mip} of {at}: {expected} {seen}"
                            );
                        }
                    }
                }
            }
        }
    }
}

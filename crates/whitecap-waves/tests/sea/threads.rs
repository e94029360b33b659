//! Equal bits, however a sea is computed.

use crate::{TILE, WIND, wind_sea};
use glam::DVec2;
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, SpectralSea, SpectralSeaParameters, SpectralTileParameters, Water,
};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::phillips::Phillips;

fn evaluated(resolution: usize) -> TileFields {
    let mut fields = TileFields::default();
    wind_sea(SpectralTileParameters { resolution, ..TILE }, WIND).evaluate(33.25, &mut fields);
    fields
}

fn bits(fields: &TileFields) -> Vec<u32> {
    let arrays = [
        &fields.height,
        &fields.displacement_x,
        &fields.displacement_z,
        &fields.slope_x,
        &fields.slope_z,
        &fields.gradient_xx,
        &fields.gradient_xz,
        &fields.gradient_zz,
    ];
    arrays.into_iter().flatten().map(|v| v.to_bits()).collect()
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    for resolution in [64, 128, 256] {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            bits(&pool.install(|| evaluated(resolution)))
        };
        let alone = on(1);
        assert!(on(2) == alone && on(3) == alone, "{resolution}");
    }
}

/// A query has the same bits too, whoever asks for which part of it.
#[test]
fn queries_are_the_same_on_any_number_of_threads() {
    let cascades = Cascade::split(&[(400.0, 128), (60.0, 128)]);
    let places: Vec<DVec2> =
        (0..2000).map(|i| DVec2::new(0.37 * f64::from(i), -1.9 * f64::from(i))).collect();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let parameters = SpectralSeaParameters {
                cascades: cascades.clone(),
                choppiness: 1.0,
                water: Water::STILL,
                seed: 3,
                amplitudes: Amplitudes::Deterministic,
            };
            let sea = SpectralSea::new(parameters, &[Phillips::new(WIND).unwrap()]).unwrap();
            sea.query(&places, 5.0).unwrap()
        })
    };
    let alone = on(1);
    assert!(on(2) == alone && on(3) == alone);
}

#[test]
fn neither_do_earlier_moments_nor_used_fields() {
    let mut sea = wind_sea(SpectralTileParameters { resolution: 64, ..TILE }, WIND);
    let mut fields = TileFields::new(128);
    sea.evaluate(-700.0, &mut fields);
    sea.evaluate(33.25, &mut fields);
    assert_eq!(fields.resolution(), 64);
    assert!(bits(&fields) == bits(&evaluated(64)));
}

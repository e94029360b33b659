//! What a sea takes of memory, and that moving it takes none.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use glam::DVec2;
use whitecap_waves::model::spectral::foam::{DECAY_S, Foam, FoamLevel, FoamParameters};
use whitecap_waves::model::spectral::{
    Amplitudes, Band, Cascade, SpectralSea, SpectralSeaParameters, SpectralTile, SpectralTileParameters,
    Water,
};
use whitecap_waves::model::{TileFields, WaveModel};
use whitecap_waves::query::Snapshot;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};

const WIND: PhillipsParameters = PhillipsParameters {
    wind_speed_mps: 10.0,
    toward: DVec2::X,
    significant_height_m: None,
    opposing_energy: 0.0,
    small_wave_cutoff_m: 0.0,
};

fn tile(resolution: usize) -> SpectralTile {
    let parameters = SpectralTileParameters {
        tile_size_m: 400.0,
        resolution,
        band: Band::WHOLE,
        choppiness: 1.0,
        water: Water { current_mps: DVec2::ONE, ..Water::STILL },
        seed: 7,
        amplitudes: Amplitudes::Deterministic,
    };
    SpectralTile::new(parameters, &[Phillips::new(WIND).unwrap()]).unwrap()
}

/// Counts are those of one thread.
fn alone<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(work)
}

#[test]
fn moving_a_sea_allocates_nothing() {
    let counts = alone(|| {
        let mut tile = tile(64);
        let mut fields = TileFields::new(64);
        let cascades = Cascade::split(&[(400.0, 64), (60.0, 64)]);
        let sea = SpectralSea::new(
            SpectralSeaParameters {
                cascades,
                choppiness: 1.0,
                water: Water::STILL,
                seed: 7,
                amplitudes: Amplitudes::Deterministic,
            },
            &[Phillips::new(WIND).unwrap()],
        )
        .unwrap();
        let parameters = FoamParameters { wind_speed_mps: Some(10.0), decay_s: DECAY_S };
        let mut foam = Foam::new(&sea, parameters).unwrap().unwrap();
        let mut snapshot = Snapshot::new(&sea);
        // The first run may make room.
        tile.evaluate(0.0, &mut fields);
        tile.evaluate_coefficients(0.0, &mut fields);
        snapshot.take(&sea, 0.0).unwrap();
        foam.evaluate(0.0);
        let mut level = FoamLevel::of(foam.tiles()[0].field(), foam.resolution());
        [
            allocation_counter::measure(|| tile.evaluate(1.0, &mut fields)),
            allocation_counter::measure(|| tile.evaluate_coefficients(1.0, &mut fields)),
            allocation_counter::measure(|| snapshot.take(&sea, 1.0).unwrap()),
            allocation_counter::measure(|| foam.evaluate(1.0)),
            allocation_counter::measure(|| {
                level.begin(foam.tiles()[0].field(), foam.resolution());
                while level.size() > 1 {
                    level.halve();
                }
            }),
            allocation_counter::measure(|| drop(vec![0_u8; 8])),
        ]
    });
    assert_eq!(
        counts.each_ref().map(|count| count.count_total),
        [0, 0, 0, 0, 0, 1],
        "the last shows that it counts"
    );
}

/// At most 80 bytes for each point of the grid, beside the fields, when all is set up and while it is.
#[test]
fn a_tile_takes_eighty_bytes_a_point() {
    for n in [256, 512] {
        let mut kept = None;
        let counts = alone(|| {
            allocation_counter::measure(|| {
                kept = Some(tile(n));
            })
        });
        let per_point = |bytes: i64| bytes as f64 / (n * n) as f64;
        let (now, most) = (per_point(counts.bytes_current), per_point(counts.bytes_max as i64));
        println!("{n}²: {now:.1} bytes a point, {most:.1} while it is set up");
        assert!(now > 20.0 && now < 80.0, "{now}");
        assert!(most < 80.0, "{most} while it is set up");
    }
}

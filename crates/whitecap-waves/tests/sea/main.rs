//! The laws that a spectral sea obeys, one file for each kind.

mod cascades;
mod chances;
mod energy;
mod fitting;
mod geometry;
mod patches;
mod threads;
mod travel;
mod water;

use glam::DVec2;
use std::f64::consts::TAU;
use whitecap_waves::model::spectral::{Amplitudes, Band, SpectralTile, SpectralTileParameters, Water};
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};

/// A fresh breeze from the west and a tile that holds its sea.
const WIND: PhillipsParameters = PhillipsParameters {
    wind_speed_mps: 10.0,
    toward: DVec2::X,
    significant_height_m: None,
    opposing_energy: 0.0,
    small_wave_cutoff_m: 0.0,
};
const TILE: SpectralTileParameters = SpectralTileParameters {
    tile_size_m: 400.0,
    resolution: 64,
    band: Band::WHOLE,
    choppiness: 1.0,
    water: Water::STILL,
    seed: 7,
    amplitudes: Amplitudes::Deterministic,
};

fn wind_sea(tile: SpectralTileParameters, wind: PhillipsParameters) -> SpectralTile {
    let spectrum = Phillips::new(wind).expect("a spectrum within its ranges");
    SpectralTile::new(tile, &[spectrum]).expect("a sea that fits its tile")
}

/// All the energy in the one cell of the lattice of `tile_size_m` at (p, q): a single wave of amplitude
/// √(2 m0).
struct OneWave {
    tile_size_m: f64,
    lattice: DVec2,
    variance_m2: f64,
}

impl OneWave {
    fn k(&self) -> DVec2 {
        TAU / self.tile_size_m * self.lattice
    }
}

impl WaveSpectrum for OneWave {
    fn density_m4(&self, k: DVec2) -> f64 {
        let spacing = TAU / self.tile_size_m;
        let inside = (k - self.k()).abs().max_element() < 0.5 * spacing;
        if inside { self.variance_m2 / (spacing * spacing) } else { 0.0 }
    }
    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }
}

/// The wave at lattice point (p, q) of a 100 m tile, half a metre high.
fn one_wave(p: f64, q: f64) -> (OneWave, SpectralTile) {
    let wave = OneWave { tile_size_m: 100.0, lattice: DVec2::new(p, q), variance_m2: 0.125 };
    let tile = SpectralTileParameters { tile_size_m: 100.0, resolution: 32, ..TILE };
    let sea = SpectralTile::new(tile, &[&wave]).expect("one wave always fits");
    (wave, sea)
}

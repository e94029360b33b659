//! The surface that the scene shows, measured.

use glam::DVec2;
use whitecap_scene::sea::SeaSurface;
use whitecap_waves::model::spectral::Water;
use whitecap_waves::model::{Surface, WaveModel};
use whitecap_waves::statistics::{Moments, SeaStatistics, SlopeVariance, SpectralMoments, SurfaceStatistics};

/// Where a surface without a tile is looked at: this many places over a square of so many metres.
const PLACES: u32 = 16_384;
const SQUARE_M: f64 = 10_000.0;

/// What was found.
pub(super) enum Measured {
    /// On the tiles of a sea that has such: all there is to know.
    Tiles(SurfaceStatistics),
    /// At places of any other sea: heights and slopes.
    Places { sea: SeaStatistics, skewness: f64, kurtosis: f64 },
}

impl Measured {
    pub(super) fn of(sea: &mut SeaSurface, water: &Water, time_s: f64) -> Self {
        let mut tiles = tiles(sea);
        if tiles.is_empty() {
            return Self::at_places(&**sea, time_s);
        }
        let tiles = tiles.iter_mut().map(|tile| &mut **tile);
        Self::Tiles(SurfaceStatistics::measure(tiles, water, time_s))
    }

    /// At places that fill the square evenly and on no lattice: multiples of the powers of the plastic number
    /// (Roberts 2018), the root of x³ = x + 1.
    fn at_places(surface: &dyn Surface, time_s: f64) -> Self {
        const PLASTIC: f64 = 1.324_717_957_244_746;
        let step = DVec2::new(1.0 / PLASTIC, 1.0 / (PLASTIC * PLASTIC));
        let points = (0..PLACES).map(|i| surface.sample((f64::from(i) * step).fract() * SQUARE_M, time_s));
        let (mut heights, mut slope) = (Vec::new(), SlopeVariance::default());
        for point in points {
            heights.push(point.displacement_m.y as f32);
            let share = point.slope / f64::from(PLACES).sqrt();
            slope += SlopeVariance { xx: share.x * share.x, xz: share.x * share.y, zz: share.y * share.y };
        }
        let height = Moments::of(&heights);
        let moments = SpectralMoments { m0: height.variance, ..SpectralMoments::default() };
        let sea = SeaStatistics { moments, slope, ..SeaStatistics::default() };
        Self::Places { sea, skewness: height.skewness, kurtosis: height.kurtosis }
    }

    pub(super) fn sea(&self) -> &SeaStatistics {
        match self {
            Self::Tiles(surface) => &surface.sea,
            Self::Places { sea, .. } => sea,
        }
    }

    /// Skewness and kurtosis.
    pub(super) fn shape(&self) -> (f64, f64) {
        match self {
            Self::Tiles(surface) => (surface.skewness, surface.kurtosis),
            Self::Places { skewness, kurtosis, .. } => (*skewness, *kurtosis),
        }
    }
}

/// The tiles whose sum the surface is.
fn tiles(sea: &mut SeaSurface) -> Vec<&mut dyn WaveModel> {
    match sea {
        SeaSurface::Tile(tile) => vec![&mut **tile],
        SeaSurface::Spectral(sea) => {
            sea.tiles_mut().iter_mut().map(|tile| tile as &mut dyn WaveModel).collect()
        }
        _ => Vec::new(),
    }
}

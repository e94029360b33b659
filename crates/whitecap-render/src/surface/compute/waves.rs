//! The constants of a tile's waves and the time, as the shaders read them.

use crate::surface::tile_maps::Vertices;
use std::f64::consts::TAU;
use whitecap_waves::model::WaveModel;
use whitecap_waves::model::spectral::SpectralTile;

/// Ticks of time in a second. A frequency may be up to half a turn per tick; over 10⁶ s the rounding of its
/// 64 bits sums up to 2⁻²⁹ turns.
const TICKS_PER_S: f64 = 65_536.0;

/// A turn per tick, 2⁶⁴, over ticks per second.
const FIXED_PER_TURN_PER_S: f64 = 281_474_976_710_656.0;

/// Layout twin of `GpuTile` in `tile.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuTile {
    pub(super) resolution: u32,
    pub(super) log2_resolution: u32,
    pub(super) spacing_rad_per_m: f32,
}

impl GpuTile {
    pub(super) fn new(resolution: usize, tile_size_m: f64) -> GpuTile {
        GpuTile {
            resolution: resolution as u32,
            log2_resolution: resolution.ilog2(),
            spacing_rad_per_m: (TAU / tile_size_m) as f32,
        }
    }
}

/// Layout twin of `GpuMoment` in `phase.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuMoment {
    pub(super) ticks: [u32; 2],
    pub(super) part_of_tick: f32,
    pub(super) padding: u32,
}

impl GpuMoment {
    /// Exact but for the rounding of the part of a tick to f32, for any time whose ticks f64 can count.
    pub(super) fn at(time_s: f64) -> GpuMoment {
        let ticks = time_s * TICKS_PER_S;
        let whole = ticks.floor();
        GpuMoment { ticks: words(whole as i64), part_of_tick: (ticks - whole) as f32, padding: 0 }
    }
}

/// A frequency as `turns_at` in `phase.wesl` takes it.
pub(super) fn fixed_point(turns_per_s: f64) -> [u32; 2] {
    words((turns_per_s * FIXED_PER_TURN_PER_S).round() as i64)
}

/// Low and high word.
fn words(value: i64) -> [u32; 2] {
    [value as u32, (value >> 32) as u32]
}

/// What is known of a tile's waves once and for all, for the half plane p ≥ 0.
pub(super) struct WaveConstants {
    pub(super) tile: GpuTile,
    /// Re P, Im P, Re Q, Im Q at p N + q.
    pub(super) amplitudes: Vec<[f32; 4]>,
    /// ν and δ at p N + q, see [`fixed_point`].
    pub(super) frequencies: Vec<[u32; 4]>,
    /// λ coth(kd)/|k| at p N/2 + |q|.
    pub(super) lean: Vec<f32>,
    /// By what the displacement of the wave (p, q) is multiplied: the number at |p| times the one at |q|, to N/2.
    pub(super) displacement_factors: Vec<f32>,
}

impl WaveConstants {
    pub(super) fn of(tile: &SpectralTile, vertices: Vertices) -> WaveConstants {
        let n = tile.resolution();
        let mut constants = WaveConstants {
            tile: GpuTile::new(n, tile.tile_size_m()),
            amplitudes: Vec::with_capacity(n * n / 2),
            frequencies: Vec::with_capacity(n * n / 2),
            lean: Vec::with_capacity(n * n / 4),
            displacement_factors: match vertices {
                Vertices::OnSamples { .. } => vec![1.0; n / 2 + 1],
                Vertices::Anywhere => tile.spline_factors().to_vec(),
            },
        };
        for column in (0..n / 2).map(|p| tile.column(p)) {
            constants.amplitudes.extend((0..n).map(|q| column.amplitudes.map(|part| part[q])));
            constants.frequencies.extend(frequencies(column.turns_per_s, column.drift_turns_per_s));
            constants.lean.extend(column.lean);
        }
        constants
    }
}

/// ν and δ of one column over q, from ν over |q| and δ over q. The place q = N/2 is empty.
pub(super) fn frequencies(
    turns_per_s: &[f64],
    drift_turns_per_s: Option<&[f64]>,
) -> impl Iterator<Item = [u32; 4]> {
    let half = turns_per_s.len();
    (0..2 * half).map(move |q| {
        let distance = q.min(2 * half - q);
        let [low, high] = fixed_point(turns_per_s.get(distance).copied().unwrap_or(0.0));
        let [drift_low, drift_high] = fixed_point(drift_turns_per_s.map_or(0.0, |drift| drift[q]));
        [low, high, drift_low, drift_high]
    })
}

/// exp(2πi j/n) for j in 0..n.
pub(super) fn twiddles(n: u32) -> Vec<[f32; 2]> {
    (0..n)
        .map(|j| {
            let (sin, cos) = (TAU * f64::from(j) / f64::from(n)).sin_cos();
            [cos as f32, sin as f32]
        })
        .collect()
}

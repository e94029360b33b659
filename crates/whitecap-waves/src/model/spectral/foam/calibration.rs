//! The threshold that gives a sea the cover of its wind.
//!
//! Symbols as in the [module above](super).

use super::{Foam, FoamLevel};
use crate::error::ParameterError;
use crate::optics::foam_cover;

/// Moments at which mᵢ is looked at, spread over a block.
const MOMENTS: i64 = 8;

/// Bins of a histogram to an e-fold.
const FINENESS: f64 = 16.0;

/// How often m of a tile has each value: counts in bins of 1/FINENESS, the first of which is at `from`.
struct Histogram {
    from: i64,
    shares: Vec<f64>,
}

impl Histogram {
    fn of(values: &[f32]) -> Self {
        let bin = |value: f32| (f64::from(value) * FINENESS).floor() as i64;
        let from = values.iter().copied().map(bin).min().unwrap_or(0);
        let to = values.iter().copied().map(bin).max().unwrap_or(0);
        let mut shares = vec![0.0; (to - from + 1) as usize];
        let one = 1.0 / values.len() as f64;
        values.iter().for_each(|&value| shares[(bin(value) - from) as usize] += one);
        Self { from, shares }
    }

    /// That of the sum of two independent numbers.
    fn convolved(&self, other: &Self) -> Self {
        let mut shares = vec![0.0; self.shares.len() + other.shares.len() - 1];
        for (i, a) in self.shares.iter().enumerate() {
            for (j, b) in other.shares.iter().enumerate() {
                shares[i + j] += a * b;
            }
        }
        Self { from: self.from + other.from, shares }
    }

    /// Values and their shares; `count` of them were added up, each the middle of a bin.
    fn values(&self, count: usize) -> impl Iterator<Item = (f64, f64)> + '_ {
        let middle = 0.5 * count as f64;
        self.shares
            .iter()
            .enumerate()
            .map(move |(i, share)| (((self.from + i as i64) as f64 + middle) / FINENESS, *share))
    }
}

/// Sets means, threshold and gain of `foam`.
pub(super) fn calibrate(foam: &mut Foam) -> Result<(), ParameterError> {
    // A tile of a sea of several has four samples to its shortest wave: half as many hold all waves, and points of a
    // coarser grid have the same values as those of a finer one.
    let coarse = (foam.resolution / 2).max(16);
    let clock = foam.clock;
    let mut sum: Option<Histogram> = None;
    let mut variance = 0.0;
    let mut texels: Vec<Vec<[f32; 2]>> = Vec::new();
    for tile in &mut foam.tiles {
        let mut convergence = tile.convergence.on_grid(coarse)?;
        let mut memory = tile.memory.on_grid(coarse);
        let mut values = vec![0.0; MOMENTS as usize * coarse * coarse];
        for (i, field) in values.chunks_exact_mut(coarse * coarse).enumerate() {
            // A moment is on the mean half a step after one of the grid.
            let part = (i as f64 + 0.5) / MOMENTS as f64 + 0.5 / clock.steps() as f64;
            memory.recall(&clock, &clock.moment(part * clock.block_s()), &mut convergence, field);
        }
        let moments = crate::statistics::Moments::of(&values);
        tile.mean = moments.mean;
        let averaged = values.chunks_exact(coarse * coarse).flat_map(|field| {
            let centred: Vec<f32> = field.iter().map(|m| m - moments.mean as f32).collect();
            let mut level = FoamLevel::of(&centred, coarse);
            level.halve();
            level.halve();
            between_texels(&level)
        });
        texels.push(averaged.collect());
        variance += moments.variance;
        let drawn: Vec<f32> =
            values.chunks_exact(coarse * coarse).flat_map(|field| interpolated(field, coarse)).collect();
        let histogram = Histogram::of(&drawn);
        sum = Some(match sum {
            Some(sum) => sum.convolved(&histogram),
            None => histogram,
        });
    }
    let Some(sum) = sum else { return Ok(()) };
    let count = foam.tiles.len();
    let mean: f64 = foam.tiles.iter().map(|tile| tile.mean).sum();
    let cover = |threshold: f64| -> f64 {
        sum.values(count).map(|(m, share)| share * foam_cover(m - mean - threshold, 0.0)).sum()
    };
    // Cover falls as the threshold rises, and is 1 below all m.
    let reach = 50.0 + 2.0 * (sum.shares.len() as f64) / FINENESS;
    foam.threshold = bisect(-reach, reach, |threshold| cover(threshold) > foam.cover);
    // Cover rises with the variance of what is averaged away.
    let all = bisect(0.0, 16.0, |gain| foam_cover(-foam.threshold, gain * variance) < foam.cover);
    let (some, within) = some_averaged(foam, &texels);
    let slope = (all - some) / (variance - within).max(1e-9);
    foam.variance_gain = [some - slope * within, slope];
    Ok(())
}

/// The gain that keeps the cover where each tile's texels are four coarse samples wide, and the variance within them:
/// `texels` has means and variances of each tile. Tiles are independent, so any texel meets any other.
fn some_averaged(foam: &Foam, texels: &[Vec<[f32; 2]>]) -> (f64, f64) {
    const STRIDES: [usize; Foam::MOST_TILES] = [1, 4_099, 2_053, 7_919];
    let count = texels.iter().map(Vec::len).max().unwrap_or(0);
    let met: Vec<(f64, f64)> = (0..count)
        .map(|i| {
            let each = texels.iter().zip(STRIDES).map(|(texels, stride)| texels[i * stride % texels.len()]);
            each.fold((-foam.threshold, 0.0), |(m, variance), [mean, within]| {
                (m + f64::from(mean), variance + f64::from(within))
            })
        })
        .collect();
    let cover = |gain: f64| {
        met.iter().map(|&(m, variance)| foam_cover(m, gain * variance)).sum::<f64>() / count as f64
    };
    let within = met.iter().map(|there| there.1).sum::<f64>() / count as f64;
    let mut gain = [0.0, 2.0];
    for _ in 0..10 {
        let middle = 0.5 * (gain[0] + gain[1]);
        gain[usize::from(cover(middle) >= foam.cover)] = middle;
    }
    (0.5 * (gain[0] + gain[1]), within)
}

/// What a texture gives for places all over a level, one for each texel, at offsets without pattern (Roberts's R2).
fn between_texels(level: &FoamLevel) -> Vec<[f32; 2]> {
    let (n, texels) = (level.size(), level.texels().collect::<Vec<_>>());
    let place = |i: usize| {
        let offset = |by: f64| ((i as f64 * by).fract()) as f32;
        let (t, u) = (offset(0.754_877_666), offset(0.569_840_291));
        std::array::from_fn(|channel| {
            let at = |dx: usize, dz: usize| texels[(i / n + dz) % n * n + (i + dx) % n][channel];
            let row = |dz: usize| at(0, dz) * (1.0 - t) + at(1, dz) * t;
            row(0) * (1.0 - u) + row(1) * u
        })
    };
    (0..n * n).map(place).collect()
}

/// From samples of a field on half of the grid, `n` a side, what linear interpolation makes of the field there on the
/// whole one: between samples Δ apart it is off by ½ t(1 − t) Δ² m″ in each direction, on the mean Δ² m″/12. Differences
/// of the fourth order, (−m₂ + 16 m₁ − 30 m₀ + 16 m₋₁ − m₋₂)/12, are 4 Δ² m″ on a grid of 2Δ.
fn interpolated(field: &[f32], n: usize) -> impl Iterator<Item = f32> + '_ {
    field.iter().enumerate().map(move |(i, value)| {
        let (row, x) = (i / n * n, i % n);
        let beside = |by: usize| field[row + (x + by) % n] + field[row + (x + n - by) % n];
        let along = |by: usize| field[(i + by * n) % (n * n)] + field[(i + (n - by) * n) % (n * n)];
        let differences = 16.0 * (beside(1) + along(1)) - (beside(2) + along(2)) - 60.0 * value;
        value + differences / (12.0 * 48.0)
    })
}

/// Where `below` turns from true to false.
fn bisect(mut low: f64, mut high: f64, below: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..48 {
        let middle = 0.5 * (low + high);
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

//! Random numbers at places: the same seed and place give the same number.

use glam::DVec2;

/// Numbers that a seed chooses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noise {
    seed: u64,
}

impl Noise {
    /// `purpose` keeps the numbers of one use apart from those of another.
    pub(super) fn new(seed: u64, purpose: u64) -> Self {
        Noise { seed: mix(seed ^ mix(purpose)) }
    }

    /// A number in 0 to 1 for each index.
    pub(super) fn uniform(self, index: u64) -> f64 {
        // 53 bits: what an f64 holds.
        (mix(self.seed ^ mix(index)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number between `low` and `high` for each index.
    pub(super) fn between(self, index: u64, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform(index)
    }

    /// Smooth noise in −1 to 1: random values on the corners of unit squares, joined by a quintic.
    pub(super) fn smooth(self, place: DVec2) -> f64 {
        let corner = place.floor();
        let within = place - corner;
        let weight = within * within * within * (within * (within * 6.0 - 15.0) + 10.0);
        let (x, y) = (corner.x as i64, corner.y as i64);
        let value = |i: i64, j: i64| {
            let index = ((x + i) as u64) << 32 ^ ((y + j) as u64 & 0xffff_ffff);
            2.0 * self.uniform(index) - 1.0
        };
        let row = |j| value(0, j) + weight.x * (value(1, j) - value(0, j));
        row(0) + weight.y * (row(1) - row(0))
    }

    /// Octaves of smooth noise, each half as long and half as high as the one before; in −1 to 1.
    pub(super) fn octaves(self, place: DVec2, count: u32) -> f64 {
        let (mut sum, mut total, mut height, mut place) = (0.0, 0.0, 1.0, place);
        for octave in 0..count {
            sum += height * Noise::new(self.seed, u64::from(octave)).smooth(place);
            total += height;
            height *= 0.5;
            // A turn keeps the lattices of the octaves from lining up.
            place = DVec2::new(0.8, 0.6).rotate(place) * 2.0;
        }
        sum / total
    }
}

/// The finaliser of SplitMix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA
/// 2014.
fn mix(value: u64) -> u64 {
    let value = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let value = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let value = (value ^ (value >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    value ^ (value >> 31)
}

/// 0 up to `from`, 1 beyond `to`, a smooth cubic between.
pub(super) fn smooth_step(from: f64, to: f64, value: f64) -> f64 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_smooth_bounded_and_of_its_seed() {
        let noise = Noise::new(1, 2);
        let mut different = 0;
        for step in 0..4000 {
            let place = DVec2::new(-7.3 + 0.01 * f64::from(step), 0.37 * f64::from(step));
            let value = noise.octaves(place, 4);
            assert!((-1.0..=1.0).contains(&value));
            assert!((noise.octaves(place + 1e-6, 4) - value).abs() < 1e-4, "a jump at {place}");
            different += usize::from(Noise::new(2, 2).octaves(place, 4) != value);
        }
        assert!(different > 3900);
        let mean = (0..10_000).map(|index| noise.uniform(index)).sum::<f64>() / 10_000.0;
        assert!((mean - 0.5).abs() < 0.02, "{mean}");
    }
}

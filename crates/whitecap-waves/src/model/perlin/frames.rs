//! The noise itself: 256 images, smoothed, and how three of them make one moment.

use super::{Mix, ONE};
use crate::random::uniform;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;
use std::f64::consts::FRAC_PI_3;

/// How many images there are; the last is followed by the first.
pub const FRAMES: usize = 256;

/// What the centre of the smoothing kernel counts; each of its eight neighbours counts 1.
const CENTRE: f64 = 6.0;

/// What the kernel counts altogether.
const KERNEL_SUM: f64 = CENTRE + 8.0;

/// The weights of three successive frames at the fraction `f` (0 to 1) of the way from one to the next:
/// sin²((f+2)π/3)/1.5, sin²((f+1)π/3)/1.5, sin²(fπ/3)/1.5 (Johanson 2004).
///
/// Their sum is 1 and the sum of their squares ½ for every `f`: three points of a cosine, evenly spread. At
/// f = 1 they are those of f = 0 one frame on.
pub fn frame_weights(f: f64) -> [f64; 3] {
    [2.0, 1.0, 0.0].map(|ahead| {
        let sine = libm::sin((f + ahead) * FRAC_PI_3);
        sine * sine / 1.5
    })
}

/// The images, one after the other, n² whole numbers each.
pub(super) struct Frames {
    n: usize,
    texels: Vec<i32>,
}

impl Frames {
    /// Noise for `seed`, n a power of two. Numbers are drawn frame by frame and row by row; the order is part
    /// of what a seed means and never changes.
    pub(super) fn new(n: usize, seed: u64) -> Frames {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut texels = Vec::with_capacity(FRAMES * n * n);
        let mut raw = vec![0.0; n * n];
        for _ in 0..FRAMES {
            raw.fill_with(|| 4.0 * (uniform(&mut rng) - 0.5));
            texels.extend((0..n * n).map(|i| (ONE * smoothed(&raw, n, i % n, i / n)) as i32));
        }
        Frames { n, texels }
    }

    /// The side of an image in texels.
    pub(super) fn side(&self) -> usize {
        self.n
    }

    /// One image.
    pub(super) fn image(&self, frame: usize) -> &[i32] {
        let len = self.n * self.n;
        &self.texels[frame * len..][..len]
    }

    /// The mixed and weighted noise at one texel.
    pub(super) fn mixed(&self, mix: &Mix, i: usize) -> i32 {
        let [a, b, c] = mix.frames.map(|frame| self.image(frame)[i]);
        mixed([a, b, c], mix.amounts)
    }

    /// The largest number of any image, in absolute value.
    pub(super) fn largest(&self) -> i32 {
        self.texels.iter().map(|texel| texel.abs()).max().unwrap_or(0)
    }

    /// The variance of an image, read bilinearly at all places and not at its texels alone.
    ///
    /// Across one step the weights 1 − t and t have mean squares ⅓ and mean product ⅙, so a row keeps ⅔ of its
    /// variance and gains ⅓ of the covariance of neighbours, and the same again down the columns.
    pub(super) fn bilinear_variance(&self) -> f64 {
        let (n, count) = (self.n, self.texels.len() as f64);
        let mean = self.texels.iter().map(|&texel| f64::from(texel)).sum::<f64>() / count;
        let covariance = |du: usize, dv: usize| {
            let products = (0..FRAMES).map(|frame| {
                let image = self.image(frame);
                let at = |u: usize, v: usize| f64::from(image[(v % n) * n + u % n]) - mean;
                (0..n * n).map(|i| at(i % n, i / n) * at(i % n + du, i / n + dv)).sum::<f64>()
            });
            products.sum::<f64>() / count
        };
        let level = covariance(0, 0);
        let across = covariance(1, 0) + covariance(0, 1);
        let diagonal = 0.5 * (covariance(1, 1) + covariance(1, n - 1));
        (4.0 * level + 2.0 * across + diagonal) / 9.0
    }
}

/// Σ amount · noise, shifted right by 15.
#[inline(always)]
pub(super) fn mixed(noise: [i32; 3], amounts: [i32; 3]) -> i32 {
    (noise[0] * amounts[0] + noise[1] * amounts[1] + noise[2] * amounts[2]) >> 15
}

/// The 3 × 3 kernel at one texel of an image that wraps around.
fn smoothed(raw: &[f64], n: usize, u: usize, v: usize) -> f64 {
    let mut sum = (CENTRE - 1.0) * raw[v * n + u];
    for dv in [n - 1, 0, 1] {
        for du in [n - 1, 0, 1] {
            sum += raw[(v + dv) % n * n + (u + du) % n];
        }
    }
    sum / KERNEL_SUM
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn golden_weights() {
        for (f, expected) in
            [(0.0, [0.5, 0.5, 0.0]), (0.25, [0.33333, 0.62201, 0.04466]), (1.0, [0.0, 0.5, 0.5])]
        {
            for (seen, expected) in frame_weights(f).iter().zip(expected) {
                assert!((seen - expected).abs() < 5.1e-6, "{f}: {seen}");
            }
        }
    }

    #[test]
    fn weights_sum_to_one_and_their_squares_to_a_half() {
        for i in 0..=100 {
            let weights = frame_weights(f64::from(i) / 100.0);
            assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            assert!((weights.iter().map(|w| w * w).sum::<f64>() - 0.5).abs() < 1e-14);
        }
    }

    /// A single 1 in a corner spreads over nine texels, around the border, and keeps its sum.
    #[test]
    fn the_kernel_sums_to_one_and_wraps() {
        let n = 8;
        let mut raw = vec![0.0; n * n];
        raw[0] = 1.0;
        let seen: Vec<f64> = (0..n * n).map(|i| smoothed(&raw, n, i % n, i / n)).collect();
        assert!((seen.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        assert!((seen[0] - 6.0 / 14.0).abs() < 1e-15);
        for i in [1, 7, 8, 9, 15, 56, 57, 63] {
            assert!((seen[i] - 1.0 / 14.0).abs() < 1e-15, "{i}");
        }
    }

    /// Uniform noise over ±2 has the variance 4/3; the kernel leaves (36 + 8)/196 of it.
    #[test]
    fn frames_have_the_moments_of_smoothed_uniform_noise() {
        let frames = Frames::new(16, 5);
        let values: Vec<f64> = frames.texels.iter().map(|&texel| f64::from(texel) / ONE).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let variance = values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64;
        assert!(mean.abs() < 0.01, "{mean}");
        assert!((variance / (4.0 / 3.0 * 44.0 / 196.0) - 1.0).abs() < 0.02, "{variance}");
        assert!(frames.largest() <= 32_768);
    }

    /// A seed in a scene file means the same sea in every version: these numbers never change.
    #[test]
    fn seed_seven_begins_like_this() {
        let frames = Frames::new(32, 7);
        assert_eq!(frames.image(0)[..4], SEED_SEVEN);
        assert_ne!(frames.image(0), Frames::new(32, 8).image(0));
    }

    const SEED_SEVEN: [i32; 4] = [-14_823, -11_381, 4_272, 8_228];
}

//! How much two pictures differ to an eye.
//!
//! Adapters round differently, so equal bytes cannot be asked for: a software rasteriser differs from itself on
//! another processor by a few levels in a few pixels. Three measures together tell that from a real change:
//!
//! - structure, by the `image-compare` crate: SSIM of the luma with the chroma's deviation. It sees what moved,
//!   blurred or broke, and hardly sees a change of brightness;
//! - the mean difference, which sees a change of brightness or colour over the whole picture;
//! - the share of pixels with a large difference, which sees a small thing that is there or is not.

use image::RgbImage;

/// A channel that differs by more levels than this, of 255, is a large difference.
pub const LARGE_LEVELS: u8 = 24;

/// How far a picture may be from its golden.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The least structural similarity; 1 is equal.
    pub similarity: f64,
    /// The most mean difference over all channels, levels of 255.
    pub mean_levels: f64,
    /// The most share of pixels in which a channel differs by more than [`LARGE_LEVELS`].
    pub large_share: f64,
}

impl Default for Tolerance {
    /// Between software rasterisers on two processors the measures are about .999, .1 and .0005.
    fn default() -> Self {
        Tolerance { similarity: 0.98, mean_levels: 2.0, large_share: 0.01 }
    }
}

/// The measured differences of two pictures of one size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// Structural similarity; 1 is equal.
    pub similarity: f64,
    /// Mean difference over all channels, levels of 255.
    pub mean_levels: f64,
    /// Share of pixels in which a channel differs by more than [`LARGE_LEVELS`].
    pub large_share: f64,
}

impl Report {
    /// Whether every measure is within `tolerance`.
    pub fn is_within(&self, tolerance: &Tolerance) -> bool {
        self.similarity >= tolerance.similarity
            && self.mean_levels <= tolerance.mean_levels
            && self.large_share <= tolerance.large_share
    }
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "similarity {:.4}, mean difference {:.2} levels, {:.2} % of pixels differ by more than {LARGE_LEVELS}",
            self.similarity,
            self.mean_levels,
            100.0 * self.large_share
        )
    }
}

/// Measures how much `picture` differs from `golden`; `None` if their sizes do.
pub fn compare(golden: &RgbImage, picture: &RgbImage) -> Option<Report> {
    let similarity = image_compare::rgb_hybrid_compare(golden, picture).ok()?.score;
    let mut sum_levels = 0;
    let mut large = 0;
    for (golden, picture) in golden.pixels().zip(picture.pixels()) {
        let levels: [u8; 3] = std::array::from_fn(|channel| golden[channel].abs_diff(picture[channel]));
        sum_levels += levels.iter().map(|&levels| u64::from(levels)).sum::<u64>();
        large += u32::from(levels.iter().any(|&levels| levels > LARGE_LEVELS));
    }
    let pixels = f64::from(golden.width()) * f64::from(golden.height());
    Some(Report {
        similarity,
        mean_levels: sum_levels as f64 / (3.0 * pixels),
        large_share: f64::from(large) / pixels,
    })
}

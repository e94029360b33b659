//! Animated noise in octaves, as Johanson moves his sea (*Real-time water rendering: introducing the projected
//! grid concept*, Lund 2004).
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | n | side of an octave's image | texels |
//! | 8n | side of a chunk, in which four octaves are packed | texels |
//! | o | number of the octave, 0 the longest, to 7 | |
//! | w | falloff^o / Σ falloff^j, weight of an octave | |
//! | f | fraction of the way from one frame to the next | |
//!
//! The thesis says 32² texels an octave and 256² a chunk, which is the default; the demo that came with it
//! has half of both.
//!
//! # Steps
//!
//! 1. **Frames.** 256 images of uniform noise 4(u − ½), smoothed by (1,1,1; 1,6,1; 1,1,1)/14 around their
//!    borders and stored as whole numbers × 16384.
//! 2. **Time.** Octave o runs at `animation_speed` · `time_multiplier`^o frames a second. Three successive frames are
//!    mixed with weights sin²((f+2)π/3)/1.5, sin²((f+1)π/3)/1.5 and sin²(fπ/3)/1.5, whose sum is exactly 1.
//!    Each is multiplied by w and rounded down to 1/16384; the sum is then shifted right by **15**, not 14: all
//!    octaves are halved by that, as in the demo, and `strength_m` is measured against it.
//! 3. **Packing.** A chunk's texel is its fourth octave, repeated, plus the third, second and first stretched
//!    2, 4 and 8 times, bilinearly.
//! 4. **Height.** Bilinear in the first chunk at `scale_per_m` · (x, z) and in the second at 16 times that, times
//!    `strength_m` / 16384.
//!
//! The demo smooths its time step from frame to frame. Here time is time, so that a sea can be asked at any
//! moment; its speed is the same.

use super::{Surface, SurfacePoint};
use crate::error::{ParameterError, check};
use glam::DVec2;

mod chunks;
mod frames;
#[cfg(test)]
mod tests;

pub use chunks::Chunks;
pub use frames::{FRAMES, frame_weights};

use frames::Frames;

/// How many octaves there are.
pub const OCTAVES: usize = 8;

/// How many octaves are packed in a chunk.
const PACKED: usize = 4;

/// How many times finer the second chunk is laid over the water than the first.
const SECOND_CHUNK: f64 = 16.0;

/// What stands for 1 in whole numbers.
const ONE: f64 = 16_384.0;

/// What a [`PerlinNoise`] is made from. The defaults are those of the demo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PerlinNoiseParameters {
    /// n, a power of two from 8 to 64.
    pub octave_size: usize,
    /// Metres for a noise of 1 after halving, from 0 to 1e3: no wave is higher than about this.
    pub strength_m: f64,
    /// Texels of the first chunk to a metre, above 0 and at most 1e3.
    pub scale_per_m: f64,
    /// Each octave's weight over that of the one before, above 0 and at most 2.
    pub falloff: f64,
    /// Frames that octave 0 runs through in a second, from 0 to 100.
    pub animation_speed: f64,
    /// Each octave's speed over that of the one before, from 0.1 to 4.
    pub time_multiplier: f64,
    /// Which noise.
    pub seed: u64,
}

impl Default for PerlinNoiseParameters {
    fn default() -> Self {
        Self {
            octave_size: 32,
            strength_m: 0.9,
            scale_per_m: 0.38,
            falloff: 0.607,
            animation_speed: 1.4,
            time_multiplier: 1.27,
            seed: 0,
        }
    }
}

/// A sea of animated noise; see the [module](self).
pub struct PerlinNoise {
    parameters: PerlinNoiseParameters,
    weights: [f64; OCTAVES],
    frames: Frames,
}

/// Three frames and the whole numbers they are mixed with.
#[derive(Debug, Clone, Copy)]
struct Mix {
    frames: [usize; 3],
    amounts: [i32; 3],
}

impl PerlinNoise {
    /// The noise for `parameters`, or which of them is out of its range.
    pub fn new(parameters: PerlinNoiseParameters) -> Result<Self, ParameterError> {
        let PerlinNoiseParameters { octave_size: n, strength_m, scale_per_m, falloff, .. } = parameters;
        check("octave_size", n as f64, "a power of two from 8 to 64", |_| {
            n.is_power_of_two() && (8..=64).contains(&n)
        })?;
        check("strength_m", strength_m, "from 0 to 1e3", |s| (0.0..=1e3).contains(&s))?;
        check("scale_per_m", scale_per_m, "above 0 and at most 1e3", |s| s > 0.0 && s <= 1e3)?;
        check("falloff", falloff, "above 0 and at most 2", |f| f > 0.0 && f <= 2.0)?;
        check("animation_speed", parameters.animation_speed, "from 0 to 100", |s| {
            (0.0..=100.0).contains(&s)
        })?;
        check("time_multiplier", parameters.time_multiplier, "from 0.1 to 4", |m| (0.1..=4.0).contains(&m))?;
        Ok(Self { parameters, weights: octave_weights(falloff), frames: Frames::new(n, parameters.seed) })
    }

    /// The parameters that the noise was made from.
    pub fn parameters(&self) -> &PerlinNoiseParameters {
        &self.parameters
    }

    /// The side of a chunk in texels, 8n.
    pub fn chunk_size(&self) -> usize {
        8 * self.parameters.octave_size
    }

    /// The distance after which the surface repeats in x and in z, in metres: 8n texels of the first chunk.
    pub fn period_m(&self) -> f64 {
        self.chunk_size() as f64 / self.parameters.scale_per_m
    }

    /// A height in metres that |height| never passes, at any place and time: every octave at the largest number
    /// of any frame.
    pub fn max_height_m(&self) -> f64 {
        // A mix of frames is no larger than the largest of them; rounding down happens once in the mix and once
        // in the stretching, each by less than 1.
        let largest = f64::from(self.frames.largest());
        let texels: f64 = self.weights.iter().map(|w| 0.5 * w * largest + 2.0).sum();
        texels * self.parameters.strength_m / ONE
    }

    /// Fills both chunks for `time_s` (|`time_s`| ≤ 1e6). Makes room in `chunks` where it needs to, and
    /// allocates nothing otherwise.
    pub fn evaluate(&self, time_s: f64, chunks: &mut Chunks) {
        chunks.resize(self.parameters.octave_size);
        for chunk in 0..2 {
            let mixes = std::array::from_fn(|i| self.mix(PACKED * chunk + i, time_s));
            chunks.fill(chunk, &self.frames, mixes);
        }
    }

    /// The height in metres that `chunks` give the rest point: what [`Surface::sample`] calculates without
    /// them, once [`evaluate`](Self::evaluate) has filled them for the same time.
    pub fn height_m(&self, chunks: &Chunks, rest_m: DVec2) -> f64 {
        self.patches(rest_m, |chunk, u, v| chunks.texel(chunk, u, v)).0
    }

    /// How octave `o` is mixed at `time_s`.
    fn mix(&self, o: usize, time_s: f64) -> Mix {
        let speed = self.parameters.animation_speed * self.parameters.time_multiplier.powi(o as i32);
        let frame = (time_s * speed).rem_euclid(FRAMES as f64);
        let first = frame.floor();
        let amounts = frame_weights(frame - first).map(|weight| (ONE * self.weights[o] * weight) as i32);
        // rem_euclid may round up to 256 itself.
        let frames = [0, 1, 2].map(|later| (first as usize + later) % FRAMES);
        Mix { frames, amounts }
    }

    /// Height in metres and slope at a rest point, from whatever knows the chunks' texels.
    fn patches(&self, rest_m: DVec2, texel: impl Fn(usize, usize, usize) -> i32) -> (f64, DVec2) {
        let size = self.chunk_size();
        let metres = self.parameters.strength_m / ONE;
        let (mut height, mut slope) = (0.0, DVec2::ZERO);
        for (chunk, finer) in [1.0, SECOND_CHUNK].into_iter().enumerate() {
            let per_m = finer * self.parameters.scale_per_m;
            let (u0, u1, fu) = wrapped(per_m * rest_m.x, size);
            let (v0, v1, fv) = wrapped(per_m * rest_m.y, size);
            let at = |u, v| f64::from(texel(chunk, u, v));
            let (a, b, c, d) = (at(u0, v0), at(u1, v0), at(u0, v1), at(u1, v1));
            let (north, south) = (a + fu * (b - a), c + fu * (d - c));
            height += metres * (north + fv * (south - north));
            let along_u = (b - a) + fv * ((d - c) - (b - a));
            slope += metres * per_m * DVec2::new(along_u, south - north);
        }
        (height, slope)
    }
}

impl Surface for PerlinNoise {
    /// Over all places and times. By what the frames are: each octave's mean square between texels follows from
    /// the frames' covariances at neighbouring texels, and three frames mixed have half the variance of one
    /// (the squares of the weights sum to ½ for every f).
    fn variance_m2(&self) -> f64 {
        let one = self.frames.bilinear_variance();
        let unit = 0.5 * self.parameters.strength_m / ONE;
        self.weights.iter().map(|w| 0.5 * one * (w * unit) * (w * unit)).sum()
    }

    /// The bilinear patch that a drawn vertex lies on, and its derivatives: slopes jump from one texel to the
    /// next. It rises by the difference of two moments 2 ms apart, which is far less than a frame of noise lasts.
    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        const STEP_S: f64 = 1e-3;
        let at = |time_s: f64| {
            let mixes: [Mix; OCTAVES] = std::array::from_fn(|o| self.mix(o, time_s));
            self.patches(rest_m, |chunk, u, v| {
                let packed = &mixes[PACKED * chunk..PACKED * (chunk + 1)];
                chunks::packed_texel(&self.frames, packed, u, v)
            })
        };
        let (height, slope) = at(time_s);
        let rise = (at(time_s + STEP_S).0 - at(time_s - STEP_S).0) / (2.0 * STEP_S);
        SurfacePoint::upright(height, slope, rise)
    }
}

/// w for every octave: falloff^o over the sum of all, so that they sum to 1.
pub fn octave_weights(falloff: f64) -> [f64; OCTAVES] {
    let powers: [f64; OCTAVES] = std::array::from_fn(|o| falloff.powi(o as i32));
    let sum: f64 = powers.iter().sum();
    powers.map(|power| power / sum)
}

/// The texels on either side of a coordinate on a ring of `size` texels, and how far it is between them.
fn wrapped(coordinate: f64, size: usize) -> (usize, usize, f64) {
    let floor = coordinate.floor();
    let low = floor.rem_euclid(size as f64) as usize % size;
    (low, (low + 1) % size, coordinate - floor)
}

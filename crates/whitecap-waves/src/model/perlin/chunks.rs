//! Four octaves packed into one image.
//!
//! Octave 3 lies at the texels themselves, octaves 2, 1 and 0 between them by 2, 4 and 8. All sums are of
//! whole numbers, so a texel calculated by itself is the one that a whole chunk has.

use super::frames::{Frames, mixed};
use super::{Mix, PACKED};

/// Two chunks of four octaves each, (8n)² whole numbers a chunk, row by row: what the CPU calculates for a
/// frame and a renderer uploads.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Chunks {
    side: usize,
    texels: [Vec<i32>; 2],
    octaves: [Vec<i32>; PACKED],
    /// One row of each stretched octave.
    rows: [Vec<i32>; PACKED],
    columns: Vec<i32>,
}

impl Chunks {
    /// Empty chunks; [`PerlinNoise::evaluate`](super::PerlinNoise::evaluate) fills them.
    pub fn new() -> Chunks {
        Chunks::default()
    }

    /// Texels along a side, 8n.
    pub fn side(&self) -> usize {
        self.side
    }

    /// All texels of chunk 0 (octaves 0 to 3) or 1 (octaves 4 to 7), in 1/16384, within ±32767.
    pub fn texels(&self, chunk: usize) -> &[i32] {
        &self.texels[chunk]
    }

    /// The texel in column `u` and row `v`, both below [`side`](Self::side): u runs with x, v with z.
    pub fn texel(&self, chunk: usize, u: usize, v: usize) -> i32 {
        self.texels[chunk][v * self.side + u]
    }

    /// The texels as the demo uploads them to a 16-bit luminance texture: 32768 + value.
    pub fn encode_unorm16(&self, chunk: usize) -> impl ExactSizeIterator<Item = u16> + '_ {
        self.texels[chunk].iter().map(|&texel| (32_768 + texel).clamp(0, 65_535) as u16)
    }

    pub(super) fn resize(&mut self, n: usize) {
        if self.side == 8 * n {
            return;
        }
        self.side = 8 * n;
        for (power, (octave, row)) in (0..PACKED).rev().zip(self.octaves.iter_mut().zip(&mut self.rows)) {
            octave.resize(n * n, 0);
            row.resize(n << power, 0);
        }
        self.columns.resize(n, 0);
        for chunk in &mut self.texels {
            chunk.resize(self.side * self.side, 0);
        }
    }

    /// Fills one chunk with four octaves, the longest first.
    pub(super) fn fill(&mut self, chunk: usize, frames: &Frames, mixes: [Mix; PACKED]) {
        let n = frames.side();
        for (octave, mix) in self.octaves.iter_mut().zip(mixes) {
            let [a, b, c] = mix.frames.map(|frame| frames.image(frame));
            for (i, texel) in octave.iter_mut().enumerate() {
                *texel = mixed([a[i], b[i], c[i]], mix.amounts);
            }
        }
        let side = self.side;
        for (v, out) in self.texels[chunk].chunks_exact_mut(side).enumerate() {
            for (power, (octave, row)) in (0..PACKED).rev().zip(self.octaves.iter().zip(&mut self.rows)) {
                stretch_row(octave, n, power, v, &mut self.columns, row);
            }
            out.copy_from_slice(&self.rows[0]);
            // Octave 3 repeats eight times along the row, octave 2 four times, octave 1 twice.
            for row in &self.rows[1..] {
                for run in out.chunks_exact_mut(row.len()) {
                    for (texel, addend) in run.iter_mut().zip(row) {
                        *texel += addend;
                    }
                }
            }
        }
    }
}

/// Row `v` of a chunk in one octave, stretched 2^power times: 2^power n texels, after which it repeats.
fn stretch_row(octave: &[i32], n: usize, power: usize, v: usize, columns: &mut [i32], out: &mut [i32]) {
    let step = 1 << power;
    let north = &octave[(v >> power) % n * n..][..n];
    let south = &octave[((v >> power) + 1) % n * n..][..n];
    let below = (v & (step - 1)) as i32;
    for ((column, north), south) in columns.iter_mut().zip(north).zip(south) {
        *column = (step as i32 - below) * north + below * south;
    }
    for (u, run) in out.chunks_exact_mut(step).enumerate() {
        let (west, east) = (columns[u], columns[(u + 1) % n]);
        for (right, texel) in (0..).zip(run) {
            *texel = ((step as i32 - right) * west + right * east) >> (2 * power);
        }
    }
}

/// One texel of a chunk, from the frames alone: `mixes` are those of its four octaves.
pub(super) fn packed_texel(frames: &Frames, mixes: &[Mix], u: usize, v: usize) -> i32 {
    let n = frames.side();
    let stretched = |(power, mix): (usize, &Mix)| {
        let step = 1 << power;
        let at = |u: usize, v: usize| frames.mixed(mix, v % n * n + u % n);
        let (west, north) = (u >> power, v >> power);
        let (right, below) = ((u & (step - 1)) as i32, (v & (step - 1)) as i32);
        let column = |u: usize| (step as i32 - below) * at(u, north) + below * at(u, north + 1);
        ((step as i32 - right) * column(west) + right * column(west + 1)) >> (2 * power)
    };
    (0..PACKED).rev().zip(mixes).map(stretched).sum()
}

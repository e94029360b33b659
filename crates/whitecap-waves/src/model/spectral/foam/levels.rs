//! A foam field's mips: means, and what they average away.

/// One level: for each texel the mean of mᵢ, and the variance within it.
#[derive(Default)]
pub struct FoamLevel {
    size: usize,
    mean: Vec<f32>,
    /// Mean of the squares.
    square: Vec<f32>,
}

impl FoamLevel {
    /// The first level, of a field with `size` samples a side.
    pub fn of(field: &[f32], size: usize) -> Self {
        let mut level = Self::default();
        level.begin(field, size);
        level
    }

    /// Becomes the first level of `field`, as [`FoamLevel::of`] makes it. Allocates nothing where it has been as large
    /// before.
    pub fn begin(&mut self, field: &[f32], size: usize) {
        self.size = size;
        self.mean.clear();
        self.mean.extend_from_slice(field);
        self.square.clear();
        self.square.extend(field.iter().map(|m| m * m));
    }

    /// Texels along a side.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Becomes the next level, of half the size.
    pub fn halve(&mut self) {
        let (n, half) = (self.size, self.size / 2);
        for values in [&mut self.mean, &mut self.square] {
            // Each mean lies at or before the first of the four values that it is of, the last one that has been read.
            for i in 0..half * half {
                let (upper, lower) = (2 * n * (i / half) + 2 * (i % half), n);
                let row = |at: usize| values[at] + values[at + 1];
                values[i] = 0.25 * (row(upper) + row(upper + lower));
            }
            values.truncate(half * half);
        }
        self.size = half;
    }

    /// Mean and variance of each texel.
    pub fn texels(&self) -> impl Iterator<Item = [f32; 2]> + '_ {
        self.mean.iter().zip(&self.square).map(|(&mean, square)| [mean, (square - mean * mean).max(0.0)])
    }
}

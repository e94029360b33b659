//! A foam field's mips: means, and what they average away.

/// One level: for each texel the mean of mᵢ, and the variance within it.
pub struct FoamLevel {
    size: usize,
    mean: Vec<f32>,
    /// Mean of the squares.
    square: Vec<f32>,
}

impl FoamLevel {
    /// The first level, of a field with `size` samples a side.
    pub fn of(field: &[f32], size: usize) -> Self {
        Self { size, mean: field.to_vec(), square: field.iter().map(|m| m * m).collect() }
    }

    /// Texels along a side.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The next level, of half the size.
    pub fn halved(&self) -> Self {
        let size = self.size / 2;
        let quarter = |values: &[f32]| {
            let mut out = Vec::with_capacity(size * size);
            for rows in values.chunks_exact(2 * self.size) {
                let (upper, lower) = rows.split_at(self.size);
                let both = upper.chunks_exact(2).zip(lower.chunks_exact(2));
                out.extend(both.map(|(a, b)| 0.25 * ((a[0] + a[1]) + (b[0] + b[1]))));
            }
            out
        };
        Self { size, mean: quarter(&self.mean), square: quarter(&self.square) }
    }

    /// Mean and variance of each texel.
    pub fn texels(&self) -> impl Iterator<Item = [f32; 2]> + '_ {
        self.mean.iter().zip(&self.square).map(|(&mean, square)| [mean, (square - mean * mean).max(0.0)])
    }
}

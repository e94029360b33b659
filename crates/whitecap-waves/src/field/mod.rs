//! Still fields, made from a seed: the height maps, normal maps and mips that the classic techniques take as
//! artwork, and the structure of foam.
//!
//! A [`HeightField`] is square and repeats: its last row is followed by its first. u runs along a row and v
//! from row to row.

mod foam;
mod gradient_noise;
mod normals;
mod ripples;

pub use foam::FoamStructure;
pub use normals::{encode_unorm8, mip_chain, normal_map};
pub use ripples::WindRippleParameters;

use crate::error::{ParameterError, check};

/// Heights on a square of `size` × `size` texels that repeats.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightField {
    size: usize,
    heights: Vec<f32>,
}

impl HeightField {
    /// The field of these heights, row by row. Fails when they are not `size`² finite numbers, `size` a power
    /// of two from 1 to 4096.
    pub fn new(size: usize, heights: Vec<f32>) -> Result<Self, ParameterError> {
        check("size", size as f64, "a power of two from 1 to 4096", |_| {
            size.is_power_of_two() && size <= 4096
        })?;
        check("heights", heights.len() as f64, "size × size numbers", |_| heights.len() == size * size)?;
        if let Some(&height) = heights.iter().find(|height| !height.is_finite()) {
            check("heights", f64::from(height), "finite", |_| true)?;
        }
        Ok(Self { size, heights })
    }

    /// Texels along a side.
    pub fn size(&self) -> usize {
        self.size
    }

    /// All heights, row by row.
    pub fn heights(&self) -> &[f32] {
        &self.heights
    }

    /// The height in column `u` and row `v`, both taken around the border.
    pub fn at(&self, u: usize, v: usize) -> f32 {
        self.heights[v % self.size * self.size + u % self.size]
    }

    /// Takes off the mean and divides by the standard deviation. A level field becomes 0.
    fn normalised(size: usize, heights: &[f32]) -> Self {
        let moments = crate::statistics::Moments::of(heights);
        let scale = if moments.variance > 0.0 { 1.0 / moments.variance.sqrt() } else { 0.0 };
        let heights =
            heights.iter().map(|&height| ((f64::from(height) - moments.mean) * scale) as f32).collect();
        Self { size, heights }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_wrap() {
        let field = HeightField::new(2, vec![0.0, 1.0, 2.0, 3.0]).unwrap();
        assert_eq!((field.at(0, 0), field.at(3, 2), field.at(2, 5)), (0.0, 1.0, 2.0));
    }

    #[test]
    fn what_is_no_field_is_refused() {
        for (size, heights) in
            [(3, vec![0.0; 9]), (2, vec![0.0; 3]), (0, vec![]), (1, vec![f32::NAN]), (8192, vec![])]
        {
            assert!(HeightField::new(size, heights).is_err());
        }
    }
}

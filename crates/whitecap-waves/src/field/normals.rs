//! Normal maps from heights, in the tangent space of the classics: x along u, y along v, z up.
//!
//! # What the techniques make of a texel
//!
//! A normal n is stored as 0.5 + 0.5 n, so level water is (128, 128, 255). The classics read that each in a way
//! of their own:
//!
//! - ATI's ocean (ShaderX 2002) expands red and green to −1..1 but takes **blue as it is**: level water has
//!   n.z = 1, and a steep normal's z shrinks half as fast as its encoding says.
//! - ATI's lake expands all three.
//! - Berglund subtracts 0.5 from all three and normalises the sum of five: the same direction as expanding.
//!
//! No encoding of 0 exists between 127 and 128: level water leans by 1/255 in x and y. That is part of how the
//! originals look, and cancels nowhere.

use super::HeightField;
use glam::Vec3;

/// The unit normals of `field`, row by row: (−∂h/∂u, −∂h/∂v, 1) normalised, by central differences over two
/// texels around the border, with heights multiplied by `strength` (in texels).
pub fn normal_map(field: &HeightField, strength: f32) -> Vec<[f32; 3]> {
    let n = field.size();
    let half = 0.5 * strength;
    (0..n * n)
        .map(|i| {
            let (u, v) = (i % n, i / n);
            let along_u = half * (field.at(u + 1, v) - field.at(u + n - 1, v));
            let along_v = half * (field.at(u, v + 1) - field.at(u, v + n - 1));
            Vec3::new(-along_u, -along_v, 1.0).normalize().to_array()
        })
        .collect()
}

/// Normals as 8-bit texels: 0.5 + 0.5 n, alpha 1. A channel is rounded to the nearest of 255 levels, and halves
/// upwards: 0 becomes 128.
pub fn encode_unorm8(normals: &[[f32; 3]]) -> Vec<[u8; 4]> {
    let level = |channel: f32| ((0.5 + 0.5 * channel) * 255.0 + 0.5).clamp(0.0, 255.0) as u8;
    normals.iter().map(|&[x, y, z]| [level(x), level(y), level(z), 255]).collect()
}

/// All levels of a texture of `size` × `size` texels, a power of two, from `texels` itself down to a single one:
/// each texel the mean over its square of the first level, rounded once, halves upwards. Not renormalised: a
/// shorter mean normal is what filtering leaves of a rough surface, and what the classics read.
///
/// Empty when `texels` are not `size`² or `size` is no power of two.
pub fn mip_chain(texels: Vec<[u8; 4]>, size: usize) -> Vec<Vec<[u8; 4]>> {
    if !size.is_power_of_two() || texels.len() != size * size {
        return Vec::new();
    }
    // Sums, not means, go from level to level, so that nothing is rounded twice.
    let mut sums: Vec<[u64; 4]> = texels.iter().map(|texel| texel.map(u64::from)).collect();
    let mut levels = vec![texels];
    let mut side = size;
    while side > 1 {
        side /= 2;
        sums = (0..side * side)
            .map(|i| {
                let at = i / side * 4 * side + i % side * 2;
                let four = [at, at + 1, at + 2 * side, at + 2 * side + 1];
                std::array::from_fn(|channel| four.iter().map(|&j| sums[j][channel]).sum())
            })
            .collect();
        let count = ((size / side) * (size / side)) as u64;
        levels.push(sums.iter().map(|sum| sum.map(|s| ((s + count / 2) / count) as u8)).collect());
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::WindRippleParameters;

    #[test]
    fn level_water_is_128_128_255() {
        let level = HeightField::new(4, vec![3.5; 16]).unwrap();
        let normals = normal_map(&level, 2.0);
        assert!(normals.iter().all(|&normal| normal == [0.0, 0.0, 1.0]));
        assert!(encode_unorm8(&normals).iter().all(|&texel| texel == [128, 128, 255, 255]));
        assert_eq!(encode_unorm8(&[[1.0, -1.0, 0.0]]), [[255, 0, 128, 255]]);
    }

    /// One raised texel at the corner tilts its four neighbours, two of them across the border.
    #[test]
    fn differences_wrap_around_the_border() {
        let mut heights = vec![0.0; 16];
        heights[0] = 1.0;
        let normals = normal_map(&HeightField::new(4, heights).unwrap(), 2.0);
        let tilt = std::f32::consts::FRAC_1_SQRT_2;
        for (i, expected) in [
            (0, [0.0, 0.0, 1.0]),
            (1, [tilt, 0.0, tilt]),
            (3, [-tilt, 0.0, tilt]),
            (4, [0.0, tilt, tilt]),
            (12, [0.0, -tilt, tilt]),
            (5, [0.0, 0.0, 1.0]),
        ] {
            assert!(Vec3::from(normals[i]).distance(expected.into()) < 1e-6, "{i}: {:?}", normals[i]);
        }
    }

    #[test]
    fn normals_are_of_length_one_and_up_on_the_mean() {
        let ripples = HeightField::wind_ripples(WindRippleParameters::new(64, 9)).unwrap();
        let noise = HeightField::perlin(64, 9, 4, 0.5).unwrap();
        for field in [ripples, noise] {
            let normals = normal_map(&field, 0.5);
            assert!(normals.iter().all(|&n| (Vec3::from(n).length() - 1.0).abs() < 1e-6 && n[2] > 0.0));
            let mean = normals.iter().map(|&n| Vec3::from(n)).sum::<Vec3>() / normals.len() as f32;
            assert!(mean.truncate().length() < 0.05 && mean.z > 0.5, "{mean}");
            // Slopes themselves, undone from the normals, sum to nothing at all.
            let slope: f32 = normals.iter().map(|n| n[0] / n[2]).sum();
            assert!(slope.abs() < 1e-2, "{slope}");
            // Twice the strength, twice the slope.
            let steeper = normal_map(&field, 1.0);
            for (a, b) in normals.iter().zip(&steeper) {
                assert!((2.0 * a[0] / a[2] - b[0] / b[2]).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn mips_keep_the_mean() {
        let field = HeightField::wind_ripples(WindRippleParameters::new(64, 9)).unwrap();
        let texels = encode_unorm8(&normal_map(&field, 0.5));
        let levels = mip_chain(texels.clone(), 64);
        assert_eq!(levels.len(), 7);
        assert_eq!(levels[0], texels);
        let mean = |level: &[[u8; 4]], channel: usize| {
            level.iter().map(|texel| f64::from(texel[channel])).sum::<f64>() / level.len() as f64
        };
        for (i, level) in levels.iter().enumerate() {
            assert_eq!(level.len(), 4096 >> (2 * i));
            for channel in 0..4 {
                assert!((mean(level, channel) - mean(&texels, channel)).abs() <= 0.5, "level {i}");
            }
        }
        // A texel is the rounded mean of its own square and no other.
        let square: u32 = [0, 1, 64, 65].iter().map(|&j| u32::from(texels[2 * 64 + 6 + j][0])).sum();
        assert_eq!(u32::from(levels[1][32 + 3][0]), (square + 2) / 4);
    }

    #[test]
    fn what_is_no_texture_has_no_levels() {
        assert!(mip_chain(vec![[0; 4]; 9], 3).is_empty());
        assert!(mip_chain(vec![[0; 4]; 3], 2).is_empty());
        assert_eq!(mip_chain(vec![[7; 4]], 1), [[[7; 4]]]);
    }
}

//! Noise from random gradients on a lattice (Perlin, *Improving Noise*, 2002: the quintic fade), which repeats.
//!
//! The gradients are unit vectors at any angle where Perlin's are twelve fixed ones: in a plane, few directions
//! show.

use super::HeightField;
use crate::error::{ParameterError, check};
use crate::random::uniform;
use crate::turns::cos_sin_exact;
use glam::DVec2;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;

/// Cells along the tile in the longest octave.
const FIRST_CELLS: usize = 4;

impl HeightField {
    /// The sum of `octaves` of gradient noise, mean 0 and variance 1.
    ///
    /// The first octave has 4 cells along the side and each next one twice as many, with `falloff` times its
    /// predecessor's height. `size` is a power of two from 16 to 2048, `octaves` from 1 to as many as leave two
    /// texels to a cell (7 at 512), `falloff` from 0 to 1. More octaves leave those that were there as they
    /// are, but for the common scale.
    pub fn perlin(size: usize, seed: u64, octaves: usize, falloff: f64) -> Result<Self, ParameterError> {
        check("size", size as f64, "a power of two from 16 to 2048", |_| {
            size.is_power_of_two() && (16..=2048).contains(&size)
        })?;
        let most = (size / (2 * FIRST_CELLS)).ilog2() as usize + 1;
        check("octaves", octaves as f64, "at least 1, with two texels or more to a cell", |_| {
            (1..=most).contains(&octaves)
        })?;
        check("falloff", falloff, "from 0 to 1", |f| (0.0..=1.0).contains(&f))?;
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut sum = vec![0.0_f32; size * size];
        for octave in 0..octaves {
            let cells = FIRST_CELLS << octave;
            let lattice = Lattice::new(cells, &mut rng);
            let height = falloff.powi(octave as i32);
            let texels_per_cell = (size / cells) as f64;
            for (i, texel) in sum.iter_mut().enumerate() {
                let place = DVec2::new((i % size) as f64, (i / size) as f64) / texels_per_cell;
                *texel += (height * lattice.noise(place)) as f32;
            }
        }
        Ok(Self::normalised(size, &sum))
    }
}

/// Random unit vectors at the corners of cells, which repeat.
struct Lattice {
    cells: usize,
    gradients: Vec<DVec2>,
}

impl Lattice {
    fn new(cells: usize, rng: &mut ChaCha8Rng) -> Lattice {
        let mut gradient = || {
            let (cos, sin) = cos_sin_exact(uniform(rng));
            DVec2::new(cos, sin)
        };
        Lattice { cells, gradients: (0..cells * cells).map(|_| gradient()).collect() }
    }

    /// The noise at `place`, in cells, at least 0: 0 at every corner, where its derivative is the gradient.
    fn noise(&self, place: DVec2) -> f64 {
        let corner = place.floor();
        let within = place - corner;
        let ramp = |du: usize, dv: usize| {
            let (u, v) = ((corner.x as usize + du) % self.cells, (corner.y as usize + dv) % self.cells);
            self.gradients[v * self.cells + u].dot(within - DVec2::new(du as f64, dv as f64))
        };
        let mix = |a: f64, b: f64, t: f64| a + t * (b - a);
        let fade = within * within * within * (within * (within * 6.0 - 15.0) + 10.0);
        mix(mix(ramp(0, 0), ramp(1, 0), fade.x), mix(ramp(0, 1), ramp(1, 1), fade.x), fade.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statistics::Moments;

    #[test]
    fn noise_is_zero_at_corners_with_the_gradient_as_slope() {
        let lattice = Lattice::new(4, &mut ChaCha8Rng::seed_from_u64(2));
        for (i, gradient) in lattice.gradients.iter().enumerate() {
            // One period further, so that there is a cell on every side.
            let corner = DVec2::new((4 + i % 4) as f64, (4 + i / 4) as f64);
            assert_eq!(lattice.noise(corner), 0.0);
            let step = 1e-5;
            let along = |axis: DVec2| {
                (lattice.noise(corner + step * axis) - lattice.noise(corner - step * axis)) / (2.0 * step)
            };
            assert!(DVec2::new(along(DVec2::X), along(DVec2::Y)).distance(*gradient) < 1e-4);
            assert!((gradient.length() - 1.0).abs() < 1e-12);
        }
    }

    /// Across every cell's border, that of the tile too, value and slope go on.
    #[test]
    fn noise_wraps_smoothly() {
        let lattice = Lattice::new(4, &mut ChaCha8Rng::seed_from_u64(2));
        for y in [0.3, 1.7, 3.9] {
            for x in [1.0, 2.0, 4.0] {
                let at = |dx: f64| lattice.noise(DVec2::new(x + dx, y));
                assert!((at(1e-9) - at(-1e-9)).abs() < 1e-8);
                assert!((at(2e-5) - 2.0 * at(0.0) + at(-2e-5)).abs() < 1e-8);
            }
            assert!((lattice.noise(DVec2::new(0.25, y)) - lattice.noise(DVec2::new(4.25, y))).abs() < 1e-12);
        }
    }

    #[test]
    fn fields_have_unit_variance_and_follow_their_seed() {
        let make = |seed, octaves| HeightField::perlin(64, seed, octaves, 0.5).unwrap();
        let moments = Moments::of(make(1, 4).heights());
        assert!(moments.mean.abs() < 1e-6 && (moments.variance - 1.0).abs() < 1e-5);
        assert_eq!(make(1, 3), make(1, 3));
        assert_ne!(make(1, 3), make(2, 3));
        // Every eighth texel is a corner of the octave with 8 cells, which adds nothing there.
        let (one, two) = (make(1, 1), make(1, 2));
        let scale = one.at(8, 0) / two.at(8, 0);
        for (u, v) in [(8, 8), (24, 40), (56, 8)] {
            // Both means are off 0 a little, and taken off.
            assert!((one.at(u, v) - scale * two.at(u, v)).abs() < 0.2);
        }
    }

    #[test]
    fn what_is_out_of_range_is_named() {
        for (size, octaves, falloff, name) in [
            (20, 1, 0.5, "size is 20"),
            (64, 0, 0.5, "octaves is 0"),
            (64, 5, 0.5, "octaves is 5"),
            (64, 4, 1.5, "falloff is 1.5"),
        ] {
            let error = HeightField::perlin(size, 0, octaves, falloff).unwrap_err().to_string();
            assert!(error.starts_with(name), "{error}");
        }
    }
}

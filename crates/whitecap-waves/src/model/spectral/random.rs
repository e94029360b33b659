//! The random numbers of a sea, in an order that a finer grid continues.
//!
//! The lattice is walked ring by ring, |(p, q)|∞ = 1, 2, 3 …, and every point draws two numbers whether they
//! are used or not. A lattice of more rings therefore begins with the same draws.

use crate::random::uniform;
use crate::turns::cos_sin_exact;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;
use rustfft::num_complex::Complex;

/// One point's draw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Draw {
    /// e^{iφ} with φ uniform over the circle.
    pub(super) direction: Complex<f64>,
    /// Uniform over (0, 1).
    pub(super) uniform: f64,
}

/// A point of the lattice with its draw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) p: i32,
    pub(super) q: i32,
    pub(super) draw: Draw,
}

impl Draw {
    /// √(−ln u): the modulus of a complex normal number with E|z|² = 1. With `direction` this is the transform of
    /// Box and Muller (1958).
    pub(super) fn modulus(&self) -> f64 {
        (-libm::log(self.uniform)).sqrt()
    }
}

/// Calls `visit` with the points of each ring |(p, q)|∞ = 1, 2 … `rings`, in the order of their directions: the one
/// opposite to the `i`-th of a ring is half a ring further. Streams of the same seed are independent of each other.
pub(super) fn for_each_ring(seed: u64, stream: u64, rings: i32, mut visit: impl FnMut(&[Point])) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(stream);
    let mut points = Vec::with_capacity(8 * rings.max(0) as usize);
    for ring in 1..=rings {
        points.clear();
        for_each_on_ring(ring, |p, q| {
            let (uniform, turns) = (uniform(&mut rng), uniform(&mut rng));
            let (cos, sin) = cos_sin_exact(turns);
            points.push(Point { p, q, draw: Draw { direction: Complex::new(cos, sin), uniform } });
        });
        visit(&points);
    }
}

/// Walks the 8 `r` points with |(p, q)|∞ = `r`: east side southwards, south side westwards, west side
/// northwards, north side eastwards. The order is part of what a seed means and never changes.
fn for_each_on_ring(r: i32, mut visit: impl FnMut(i32, i32)) {
    for step in 1 - r..=r {
        visit(r, step);
    }
    for step in 1 - r..=r {
        visit(-step, r);
    }
    for step in 1 - r..=r {
        visit(-r, -step);
    }
    for step in 1 - r..=r {
        visit(step, -r);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    fn points(seed: u64, stream: u64, rings: i32) -> Vec<Point> {
        let mut all = Vec::new();
        for_each_ring(seed, stream, rings, |ring| all.extend_from_slice(ring));
        all
    }

    #[test]
    fn every_point_is_visited_once() {
        let places: HashSet<_> = points(1, 0, 5).iter().map(|point| (point.p, point.q)).collect();
        assert_eq!(points(1, 0, 5).len(), 11 * 11 - 1);
        assert_eq!(places.len(), 11 * 11 - 1);
        assert!(places.iter().all(|&(p, q)| p.abs().max(q.abs()) <= 5 && (p, q) != (0, 0)));
    }

    #[test]
    fn more_rings_continue_the_same_walk() {
        let (few, many) = (points(9, 0, 4), points(9, 0, 12));
        assert_eq!(few[..], many[..few.len()]);
        assert_ne!(points(9, 0, 1), points(10, 0, 1));
    }

    #[test]
    fn opposite_points_are_half_a_ring_apart() {
        for_each_ring(1, 0, 6, |ring| {
            let (first, second) = ring.split_at(ring.len() / 2);
            for (a, b) in first.iter().zip(second) {
                assert_eq!((a.p, a.q), (-b.p, -b.q));
            }
        });
    }

    #[test]
    fn streams_of_a_seed_differ() {
        assert_ne!(points(9, 0, 1), points(9, 1, 1));
    }

    /// A seed in a scene file means the same sea in every version: these numbers never change.
    #[test]
    fn seed_seven_begins_like_this() {
        let all = points(7, 0, 2);
        for (i, p, q, re, im, modulus) in [
            (0, 1, 0, 0.49278549976552355, 0.8701508209620004, 1.3588420086919166),
            (7, 1, -1, -0.9861308118490391, -0.1659699428268718, 0.9229351320686195),
            (8, 2, -1, 0.8888024225457327, 0.4582905777744473, 1.0927529477541296),
        ] {
            let Point { draw, .. } = all[i];
            assert_eq!((all[i].p, all[i].q), (p, q));
            assert!((draw.direction - Complex::new(re, im)).norm() < 1e-12);
            assert!((draw.modulus() - modulus).abs() < 1e-12);
        }
    }

    /// E|z|² = 1, E z = 0, E z² = 0 and E|z|⁴ = 2, as for a complex normal number.
    #[test]
    fn draws_are_complex_normal() {
        let all = points(3, 0, 60);
        let n = all.len() as f64;
        let values: Vec<Complex<f64>> =
            all.iter().map(|point| point.draw.direction * point.draw.modulus()).collect();
        let mean = values.iter().sum::<Complex<f64>>() / n;
        let second = values.iter().map(|z| z.norm_sqr()).sum::<f64>() / n;
        let pseudo = values.iter().map(|z| z * z).sum::<Complex<f64>>() / n;
        let fourth = values.iter().map(|z| z.norm_sqr().powi(2)).sum::<f64>() / n;
        assert!(mean.norm() < 0.03 && pseudo.norm() < 0.04, "{mean} {pseudo}");
        assert!((second - 1.0).abs() < 0.03 && (fourth - 2.0).abs() < 0.15, "{second} {fourth}");
    }
}

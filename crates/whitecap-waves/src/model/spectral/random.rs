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
    uniform: f64,
}

impl Draw {
    /// √(−ln u): the modulus of a complex normal number with E|z|² = 1. With `direction` this is the transform of
    /// Box and Muller (1958).
    pub(super) fn modulus(&self) -> f64 {
        (-libm::log(self.uniform)).sqrt()
    }
}

/// Calls `visit(p, q, draw)` for every lattice point with 1 ≤ |(p, q)|∞ ≤ `rings`. Streams of the same seed are
/// independent of each other.
pub(super) fn for_each_draw(seed: u64, stream: u64, rings: i32, mut visit: impl FnMut(i32, i32, Draw)) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(stream);
    for ring in 1..=rings {
        for_each_on_ring(ring, |p, q| {
            let (uniform, turns) = (uniform(&mut rng), uniform(&mut rng));
            let (cos, sin) = cos_sin_exact(turns);
            visit(p, q, Draw { direction: Complex::new(cos, sin), uniform });
        });
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

    fn draws(seed: u64, rings: i32) -> Vec<(i32, i32, Draw)> {
        let mut all = Vec::new();
        for_each_draw(seed, 0, rings, |p, q, draw| all.push((p, q, draw)));
        all
    }

    #[test]
    fn every_point_is_visited_once() {
        let points: HashSet<_> = draws(1, 5).iter().map(|&(p, q, _)| (p, q)).collect();
        assert_eq!(draws(1, 5).len(), 11 * 11 - 1);
        assert_eq!(points.len(), 11 * 11 - 1);
        assert!(points.iter().all(|&(p, q)| p.abs().max(q.abs()) <= 5 && (p, q) != (0, 0)));
    }

    #[test]
    fn more_rings_continue_the_same_walk() {
        let (few, many) = (draws(9, 4), draws(9, 12));
        assert_eq!(few[..], many[..few.len()]);
        assert_ne!(draws(9, 1), draws(10, 1));
    }

    #[test]
    fn streams_of_a_seed_differ() {
        let stream = |stream: u64| {
            let mut all = Vec::new();
            for_each_draw(9, stream, 1, |_, _, draw| all.push(draw));
            all
        };
        assert_ne!(stream(0), stream(1));
    }

    /// A seed in a scene file means the same sea in every version: these numbers never change.
    #[test]
    fn seed_seven_begins_like_this() {
        let all = draws(7, 2);
        for (i, p, q, re, im, modulus) in [
            (0, 1, 0, 0.49278549976552355, 0.8701508209620004, 1.3588420086919166),
            (7, 1, -1, -0.9861308118490391, -0.1659699428268718, 0.9229351320686195),
            (8, 2, -1, 0.8888024225457327, 0.4582905777744473, 1.0927529477541296),
        ] {
            let (at_p, at_q, draw) = all[i];
            assert_eq!((at_p, at_q), (p, q));
            assert!((draw.direction - Complex::new(re, im)).norm() < 1e-12);
            assert!((draw.modulus() - modulus).abs() < 1e-12);
        }
    }

    /// E|z|² = 1, E z = 0, E z² = 0 and E|z|⁴ = 2, as for a complex normal number.
    #[test]
    fn draws_are_complex_normal() {
        let all = draws(3, 60);
        let n = all.len() as f64;
        let values: Vec<Complex<f64>> = all.iter().map(|(_, _, d)| d.direction * d.modulus()).collect();
        let mean = values.iter().sum::<Complex<f64>>() / n;
        let second = values.iter().map(|z| z.norm_sqr()).sum::<f64>() / n;
        let pseudo = values.iter().map(|z| z * z).sum::<Complex<f64>>() / n;
        let fourth = values.iter().map(|z| z.norm_sqr().powi(2)).sum::<f64>() / n;
        assert!(mean.norm() < 0.03 && pseudo.norm() < 0.04, "{mean} {pseudo}");
        assert!((second - 1.0).abs() < 0.03 && (fourth - 2.0).abs() < 0.15, "{second} {fourth}");
    }
}

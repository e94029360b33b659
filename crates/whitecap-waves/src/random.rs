//! Uniform random numbers from a seeded generator, the same on every machine.

use rand_chacha::ChaCha8Rng;
use rand_core::Rng;

/// A multiple of 2⁻⁵³ and a half, strictly between 0 and 1: a logarithm of it is finite.
pub(crate) fn uniform(rng: &mut ChaCha8Rng) -> f64 {
    const STEP: f64 = 1.0 / (1_u64 << 53) as f64;
    ((rng.next_u64() >> 11) as f64 + 0.5) * STEP
}

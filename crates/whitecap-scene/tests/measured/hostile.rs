//! Any bytes, and good files that were damaged: a record of a sound sea or an error on one line, never a
//! panic.

use proptest::prelude::*;
use whitecap_scene::measured::{Directions, Energy};
use whitecap_waves::dispersion::Dispersion;

use super::*;

/// What every record promises: densities that are some, and a spectrum of finite variance or a reason.
fn check(read: Result<Vec<MeasuredSea>, whitecap_scene::measured::MeasuredError>) {
    match read {
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
        Ok(seas) => {
            assert!(!seas.is_empty());
            for sea in seas.iter().take(5) {
                assert!(sea.variance_m2() >= 0.0 && sea.variance_m2().is_finite());
                let has_none =
                    matches!(sea.energy, Energy::Omnidirectional { .. } | Energy::Undirected { .. });
                let from_deg = has_none.then_some(200.0);
                match sea.spectrum(&Directions { from_deg, ..Directions::default() }, &Dispersion::DEEP) {
                    Ok(spectrum) => assert!(variance(&spectrum) >= 0.0 && variance(&spectrum).is_finite()),
                    Err(problem) => assert!(!sea.has_waves(), "{problem}"),
                }
            }
        }
    }
}

/// What a good file gets in place of a piece of it.
const WORDS: [&str; 12] =
    ["", " ", "\n", "-1", "1e300", "999", "NaN", "0", "99999999999999999999", "'", "ZERO\n", "é"];

proptest! {
    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400), start in 0..4_usize) {
        let start = [DATA_SPEC, HISTORY, WW3, SWAN][start].lines().next().unwrap();
        check(from_bytes(&bytes, "file"));
        check(from_bytes(&[start.as_bytes(), b"\n", &bytes].concat(), "file"));
    }

    #[test]
    fn damaged_files(
        which in 0..4_usize, at in 0.0..1.0_f64, cut in 0..40_usize, word in prop::sample::select(WORDS.to_vec()),
    ) {
        let text = [DATA_SPEC, HISTORY, WW3, SWAN][which];
        let at = (at * text.len() as f64) as usize;
        let end = (at + cut).min(text.len());
        let damaged = [&text[..at], word, &text[end..]].concat();
        check(from_bytes(damaged.as_bytes(), "file"));
        check(from_bytes(&text.as_bytes()[..at], "file"));
        let directions = DIRECTIONS.map(str::as_bytes);
        check(from_bytes_with_directions(damaged.as_bytes(), directions, "file"));
    }

    #[test]
    fn damaged_directions(
        which in 0..4_usize, at in 0.0..1.0_f64, cut in 0..40_usize, digit in "[0-9.() ]{0,3}",
    ) {
        let text = DIRECTIONS[which];
        let at = (at * text.len() as f64) as usize;
        let end = (at + cut).min(text.len());
        let damaged = [&text[..at], &digit, &text[end..]].concat();
        let mut directions = DIRECTIONS.map(str::as_bytes);
        directions[which] = damaged.as_bytes();
        check(from_bytes_with_directions(DATA_SPEC.as_bytes(), directions, "file"));
    }
}

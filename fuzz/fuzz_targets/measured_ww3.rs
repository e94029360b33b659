//! Any bytes read as WAVEWATCH III point spectra: sound records or an error on one line, never a panic.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitecap_scene::measured::{MeasuredError, MeasuredSea, from_bytes};

fuzz_target!(|bytes: &[u8]| {
    check(from_bytes(&[b"'WAVEWATCH III SPECTRA' 2 3 ".as_slice(), bytes].concat(), "fuzz"));
    check(from_bytes(bytes, "fuzz"));
});

fn check(read: Result<Vec<MeasuredSea>, MeasuredError>) {
    match read {
        Ok(seas) => assert!(seas.iter().all(|sea| sea.variance_m2() >= 0.0 && sea.variance_m2().is_finite())),
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}

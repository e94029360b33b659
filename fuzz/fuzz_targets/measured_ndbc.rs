//! Any bytes read as NDBC spectra, real-time and historical: sound records or an error on one line, never a panic.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitecap_scene::measured::{MeasuredError, MeasuredSea, from_bytes, from_bytes_with_directions};

fuzz_target!(|bytes: &[u8]| {
    // One byte chooses the format; real-time bytes are their own four files of directions, too.
    let Some((choice, rest)) = bytes.split_first() else { return };
    let start: &[u8] =
        if choice % 2 == 0 { b"#YY MM DD hh mm Sep_Freq < spec_1\n" } else { b"YYYY MM DD hh .1 .2 .3\n" };
    let file = [start, rest].concat();
    check(from_bytes(&file, "fuzz"));
    check(from_bytes_with_directions(&file, [rest; 4], "fuzz"));
});

fn check(read: Result<Vec<MeasuredSea>, MeasuredError>) {
    match read {
        Ok(seas) => assert!(seas.iter().all(|sea| sea.variance_m2() >= 0.0 && sea.variance_m2().is_finite())),
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}

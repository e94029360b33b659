//! Any bytes read as a year of NDBC spectral wave density: sound records or an error on one line, never a panic.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitecap_fuzz::check;
use whitecap_scene::measured::from_bytes;

fuzz_target!(|bytes: &[u8]| {
    check(from_bytes(&[b"YYYY MM DD hh .1 .2 .3\n".as_slice(), bytes].concat(), "fuzz"));
    check(from_bytes(&[b"YYYY MM DD hh mm ".as_slice(), bytes].concat(), "fuzz"));
});

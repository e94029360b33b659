//! Any bytes read as WAVEWATCH III point spectra: sound records or an error on one line, never a panic.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitecap_fuzz::check;
use whitecap_scene::measured::from_bytes;

fuzz_target!(|bytes: &[u8]| {
    check(from_bytes(&[b"'WAVEWATCH III SPECTRA' 2 3 ".as_slice(), bytes].concat(), "fuzz"));
    check(from_bytes(bytes, "fuzz"));
});

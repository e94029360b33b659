//! Any bytes read as NDBC real-time spectra, alone and with themselves as their four files of directions: sound records or an
//! error on one line, never a panic.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitecap_fuzz::check;
use whitecap_scene::measured::{from_bytes, from_bytes_with_directions};

fuzz_target!(|bytes: &[u8]| {
    let file = [b"#YY MM DD hh mm Sep_Freq < spec_1\n".as_slice(), bytes].concat();
    check(from_bytes(&file, "fuzz"));
    check(from_bytes_with_directions(&file, [bytes; 4], "fuzz"));
});

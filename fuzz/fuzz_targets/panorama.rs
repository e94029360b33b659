//! Any bytes read as a panorama: a picture of light or an error, never a panic or more memory than is allowed.

#![no_main]

use std::sync::Once;

use libfuzzer_sys::fuzz_target;
use whitecap_scene::panorama::Panorama;

/// The fuzzer aborts on every panic; those inside decoders are caught and are none of its business. One that
/// gets out still ends the run.
static KEEP_CAUGHT_PANICS: Once = Once::new();

fuzz_target!(|bytes: &[u8]| {
    KEEP_CAUGHT_PANICS.call_once(|| std::panic::set_hook(Box::new(|_| ())));
    if let Ok(panorama) = Panorama::from_bytes(bytes, "fuzz") {
        assert_eq!(panorama.pixels.len(), panorama.width * panorama.height);
        let is_light = |value: &f32| value.is_finite() && *value >= 0.0;
        assert!(panorama.pixels.iter().flatten().all(is_light));
    }
});

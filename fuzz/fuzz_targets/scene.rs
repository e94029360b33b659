//! Any text read as a scene: a scene or an error on one line, never a panic; a scene can be written and read back.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitecap_scene::Scene;

fuzz_target!(|text: &str| {
    match Scene::from_toml(text, "fuzz.toml") {
        Ok(scene) => {
            let written = scene.to_toml().expect("a scene that was read can be written");
            assert_eq!(Scene::from_toml(&written, "written").expect("and read again"), scene);
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
});

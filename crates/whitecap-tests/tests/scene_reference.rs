//! `docs/scene-files.md` lists the keys that scene files accept, as the reader itself declares them.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use whitecap_tests::repository::{root, updates};

const INTRODUCTION: &str = "\
# Scene files

A scene is one TOML file: how the water is drawn, the sea, the sky and the camera. Every key says its unit in its name; an
unknown key, a wrong type or a number out of range is refused with the file's line. Directions named `from_deg` are nautical:
weather from the west has `from_deg = 270`. Places are `[x, y, z]`, x east, y up, z south. Relative files are looked for beside
the scene file. `whitecap check FILE` reads a scene without drawing it, `whitecap scenes meshuggah` prints one to start from.

This page is written by `cargo xtask docs` from the declarations that the reader uses.

";

#[test]
fn the_page_lists_the_keys_that_the_reader_accepts() {
    let path = root().join("docs/scene-files.md");
    let expected = format!("{INTRODUCTION}{}", whitecap_scene::reference::markdown());
    if updates() {
        std::fs::write(&path, &expected).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(found == expected, "docs/scene-files.md is not what the reader says; run `cargo xtask docs`");
}

//! Every named scene, at two moments, against the pictures that somebody looked at.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use std::collections::BTreeSet;
use whitecap_render::picture::{PictureRequest, render_picture};
use whitecap_scene::named;
use whitecap_tests::adapter::gpu;
use whitecap_tests::golden::{Goldens, MOST_BYTES, MOST_PIXELS};

/// Somewhat less than a golden may have, so that a livelier sea still fits its file.
const SIZE: [u32; 2] = [256, 144];

/// The moments, seconds: the start, and one that no round phase can hide behind.
const TIMES_S: [f64; 2] = [0.0, 3.7];

fn name(scene: &str, time_s: f64) -> String {
    if time_s == 0.0 { scene.to_owned() } else { format!("{scene}-{time_s}s") }
}

#[test]
fn every_named_scene_looks_as_it_did() {
    let Some(gpu) = gpu() else { return };
    let goldens = Goldens::of_repository();
    let [width, height] = SIZE;
    let mut mismatches = Vec::new();
    for named in named::ALL {
        let scene = whitecap_scene::open(named.name).unwrap();
        for time_s in TIMES_S {
            let request = PictureRequest { backend: None, width, height, time_s };
            let picture = render_picture(gpu, &scene, &request, &mut |_| {}).unwrap();
            let checked = goldens.check(&name(named.name, time_s), &picture);
            mismatches.extend(checked.err().map(|mismatch| mismatch.to_string()));
        }
    }
    assert!(mismatches.is_empty(), "{}", mismatches.join("\n"));
}

#[test]
fn there_is_a_small_golden_for_every_scene_and_moment_and_none_besides() {
    let goldens = Goldens::of_repository();
    if std::env::var_os(whitecap_tests::golden::UPDATE).is_some() {
        return; // they are being made
    }
    let expected: BTreeSet<String> = named::ALL
        .iter()
        .flat_map(|scene| TIMES_S.map(|time_s| format!("{}.png", name(scene.name, time_s))))
        .collect();
    let entries = goldens.folder().read_dir().expect("there are goldens; `cargo xtask goldens` makes them");
    let mut found = BTreeSet::new();
    for entry in entries {
        let path = entry.unwrap().path();
        let bytes = std::fs::metadata(&path).unwrap().len();
        assert!(bytes <= MOST_BYTES as u64, "{} has {bytes} bytes", path.display());
        let (width, height) = image::image_dimensions(&path).unwrap();
        assert!(width <= MOST_PIXELS[0] && height <= MOST_PIXELS[1], "{}", path.display());
        found.insert(path.file_name().unwrap().to_string_lossy().into_owned());
    }
    assert_eq!(found, expected);
}

//! `whitecap view` in a real window, by its pixels, keys and files.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop
#![allow(clippy::print_stderr)] // and one that is skipped says so

mod keys;
mod screen;

use assert_cmd::Command;
use screen::{SIZE, Screen, Viewer};
use std::fs;
use std::path::Path;

const SHALLOW: &str = "spectral-ocean-shallow";

/// Mean level of a channel over some rows.
fn mean(pixels: &[[u8; 4]], channel: usize, rows: std::ops::Range<usize>) -> f64 {
    let width = usize::from(SIZE[0]);
    let part = &pixels[rows.start * width..rows.end * width];
    part.iter().map(|pixel| f64::from(pixel[channel])).sum::<f64>() / part.len() as f64
}

/// Mean difference in levels.
fn difference(one: &[[u8; 4]], other: &[[u8; 4]]) -> f64 {
    let pairs = one.iter().flat_map(|pixel| &pixel[..3]).zip(other.iter().flat_map(|pixel| &pixel[..3]));
    pairs.map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / (3 * one.len()) as f64
}

#[test]
fn a_window_shows_the_sea_under_the_sky_and_keys_move_it() {
    let Some(screen) = Screen::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut viewer = Viewer::open(&screen, folder.path(), &[SHALLOW, "--paused"]);
    let first = viewer.still();
    let (sky, sea) = (mean(&first, 1, 90..140), mean(&first, 1, 200..340));
    assert!(sky > 120.0 && sky > 1.5 * sea && sea > 10.0, "sky {sky}, sea {sea}");

    // Up: the same time from higher, a picture that stands still as well.
    viewer.down("KeyE");
    std::thread::sleep(std::time::Duration::from_millis(1200));
    viewer.up("KeyE");
    let higher = viewer.still();
    assert!(difference(&first, &higher) > 2.0, "{}", difference(&first, &higher));

    // Time goes on when it is asked to.
    viewer.press("Space");
    let before = screen.pixels();
    viewer.wait("another picture", |_| (difference(&before, &screen.pixels()) > 1.0).then_some(()));
}

/// What is saved and rendered is what the window shows; the window has one sample a pixel, the picture four.
#[test]
fn what_is_saved_renders_as_it_was_seen() {
    let Some(screen) = Screen::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut viewer = Viewer::open(&screen, folder.path(), &[SHALLOW, "--paused", "--time", "2.5"]);
    viewer.down("KeyD");
    std::thread::sleep(std::time::Duration::from_millis(700));
    viewer.up("KeyD");
    let seen = viewer.still();
    viewer.down("Control");
    viewer.press("KeyS");
    viewer.up("Control");
    let saved = folder.path().join(format!("{SHALLOW}-001.toml"));
    viewer.wait("a saved scene", |_| saved.exists().then_some(()));
    drop(viewer);

    Command::new(env!("CARGO_BIN_EXE_whitecap"))
        .args(["render", "--time", "2.5", "--size", "640x360", "-o", "saved.png"])
        .arg(&saved)
        .current_dir(folder.path())
        .assert()
        .success();
    let picture = image::open(folder.path().join("saved.png")).unwrap().to_rgba8();
    let rendered: Vec<[u8; 4]> = picture.pixels().map(|image::Rgba([r, g, b, a])| [*b, *g, *r, *a]).collect();
    let off = difference(&seen, &rendered);
    assert!(off < 6.0, "{off} levels");
}

#[test]
fn a_broken_file_is_said_and_the_last_good_water_stays() {
    let Some(screen) = Screen::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sea.toml");
    let good = whitecap_scene::open(SHALLOW).unwrap().to_toml().unwrap();
    fs::write(&path, &good).unwrap();
    let mut viewer = Viewer::open(&screen, folder.path(), &["sea.toml", "--paused"]);
    let first = viewer.still();

    rewrite(&path, "technique = \"spectral-ocean\"\n[sea\n");
    // The sentence lies over the top of the picture, and the sea below is as it was.
    let middle = usize::from(SIZE[0]) * 250;
    viewer.wait("a sentence", |_| (difference(&first, &screen.pixels()) > 0.2).then_some(()));
    let broken = viewer.still();
    assert_eq!(broken[middle..], first[middle..]);

    let elsewhere = good.replace("seed = ", "seed = 1");
    assert_ne!(elsewhere, good);
    rewrite(&path, &elsewhere);
    viewer.wait("another sea", |_| {
        (difference(&first[middle..], &screen.pixels()[middle..]) > 1.0).then_some(())
    });
}

/// With another time of change, whatever the file system's clock.
fn rewrite(path: &Path, text: &str) {
    let before = fs::metadata(path).unwrap().modified().unwrap();
    while fs::metadata(path).unwrap().modified().unwrap() == before {
        fs::write(path, text).unwrap();
    }
}

#[test]
fn a_window_without_a_size_comes_back() {
    let Some(screen) = Screen::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut viewer = Viewer::open(&screen, folder.path(), &[SHALLOW, "--paused"]);
    let first = viewer.still();
    viewer.resize(1, 1);
    viewer.wait("a small window", |_| (difference(&first, &screen.pixels()) > 20.0).then_some(()));
    viewer.resize(u32::from(SIZE[0]), u32::from(SIZE[1]));
    viewer.wait("the picture again", |_| (difference(&first, &screen.pixels()) < 0.5).then_some(()));
}

#[test]
fn without_a_display_it_says_so_and_names_render() {
    let output = Command::new(env!("CARGO_BIN_EXE_whitecap"))
        .arg("view")
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .assert()
        .code(1)
        .get_output()
        .clone();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("no display") && said.contains("whitecap render"), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
}

//! The means of testing, tested: a comparison that lets everything pass would make every golden worthless.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use image::{Rgb, RgbImage};
use std::path::Path;
use whitecap_render::picture::Picture;
use whitecap_tests::compare::{Report, Tolerance, compare};
use whitecap_tests::golden::{Goldens, MOST_PIXELS, Mismatch};

/// A sky over waves that grow towards the viewer.
fn sea() -> RgbImage {
    RgbImage::from_fn(320, 180, |x, y| {
        let (x, y) = (f64::from(x), f64::from(y));
        if y < 60.0 {
            let level = 150.0 + y;
            return Rgb([level as u8, (level + 15.0) as u8, 235]);
        }
        let distance = 2000.0 / (y - 55.0);
        let wave = (0.15 * (x - 160.0) * distance / 100.0).sin() + (1.3 * distance + 0.02 * x).sin();
        let level = 70.0 + 28.0 * wave;
        Rgb([(0.6 * level) as u8, level as u8, (level + 30.0) as u8])
    })
}

fn map(picture: &RgbImage, mut change: impl FnMut(u32, u32, u8) -> u8) -> RgbImage {
    RgbImage::from_fn(picture.width(), picture.height(), |x, y| {
        Rgb(picture.get_pixel(x, y).0.map(|level| change(x, y, level)))
    })
}

/// Numbers without a pattern, the same in every run.
fn noise() -> impl FnMut() -> u32 {
    let mut state = 0x2545_f491_u32;
    move || {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        state
    }
}

fn report(changed: &RgbImage) -> Report {
    compare(&sea(), changed).expect("the sizes are equal")
}

fn passes(changed: &RgbImage) -> bool {
    report(changed).is_within(&Tolerance::default())
}

#[test]
fn a_picture_is_like_itself() {
    let report = report(&sea());
    assert!(report.similarity > 0.9999, "{report}");
    assert_eq!((report.mean_levels, report.large_share), (0.0, 0.0));
}

#[test]
fn what_another_processor_changes_is_let_through() {
    let mut next = noise();
    let rounded = map(&sea(), |_, _, level| match next() % 100 {
        0..10 => level.saturating_add(1),
        10..20 => level.saturating_sub(1),
        20 => level.saturating_add(6),
        _ => level,
    });
    assert!(passes(&rounded), "{}", report(&rounded));
}

#[test]
fn a_shift_is_noticed() {
    let sea = sea();
    for pixels in [2, 5] {
        let shifted =
            RgbImage::from_fn(320, 180, |x, y| *sea.get_pixel(x.saturating_sub(pixels), y.saturating_sub(1)));
        assert!(!passes(&shifted), "{pixels}: {}", report(&shifted));
    }
}

#[test]
fn a_darker_and_a_brighter_picture_are_noticed() {
    let darker = map(&sea(), |_, _, level| level.saturating_sub(12));
    let brighter = map(&sea(), |_, _, level| level.saturating_add(4));
    assert!(!passes(&darker), "{}", report(&darker));
    assert!(!passes(&brighter), "{}", report(&brighter));
}

#[test]
fn noise_and_blackness_are_noticed() {
    let mut next = noise();
    let all_noise = map(&sea(), |_, _, _| next() as u8);
    let some_noise = map(&sea(), |_, _, level| level.saturating_add((next() % 13) as u8));
    let black = map(&sea(), |_, _, _| 0);
    for changed in [&all_noise, &some_noise, &black] {
        assert!(!passes(changed), "{}", report(changed));
    }
}

#[test]
fn a_hole_is_noticed() {
    let holed = map(
        &sea(),
        |x, y, level| if (100..140).contains(&x) && (90..110).contains(&y) { 255 } else { level },
    );
    assert!(!passes(&holed), "{}", report(&holed));
}

fn picture(image: &RgbImage) -> Picture {
    let rgba8 = image.pixels().flat_map(|Rgb([r, g, b])| [*r, *g, *b, 255]).collect();
    Picture { width: image.width(), height: image.height(), rgba8 }
}

fn names_in(folder: &Path) -> Vec<String> {
    folder.read_dir().unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

#[test]
fn a_missing_golden_fails_and_does_not_make_itself() {
    let folder = tempfile::tempdir().unwrap();
    let goldens = Goldens::in_folder(folder.path(), folder.path());
    let mismatch = goldens.check("sea", &picture(&sea())).unwrap_err();
    assert!(matches!(mismatch, Mismatch::Missing { .. }));
    assert!(mismatch.to_string().contains("cargo xtask goldens"), "{mismatch}");
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn a_golden_that_was_made_is_compared_with() {
    let folder = tempfile::tempdir().unwrap();
    let differing = folder.path().join("differing");
    let goldens = Goldens::in_folder(folder.path(), &differing);
    goldens.clone().updating().check("sea", &picture(&sea())).unwrap();
    goldens.check("sea", &picture(&sea())).unwrap();

    let darker = picture(&map(&sea(), |_, _, level| level.saturating_sub(12)));
    let mismatch = goldens.check("sea", &darker).unwrap_err();
    assert!(matches!(mismatch, Mismatch::Different { .. }), "{mismatch}");
    assert_eq!(names_in(&differing), ["sea.png"]);

    let small = Picture { width: 1, height: 1, rgba8: vec![0; 4] };
    assert!(matches!(goldens.check("sea", &small), Err(Mismatch::Size { .. })));
}

#[test]
fn what_is_too_large_to_keep_does_not_become_a_golden() {
    let folder = tempfile::tempdir().unwrap();
    let goldens = Goldens::in_folder(folder.path(), folder.path()).updating();
    let wide =
        Picture { width: MOST_PIXELS[0] + 1, height: 1, rgba8: vec![0; 4 * (MOST_PIXELS[0] as usize + 1)] };
    assert!(matches!(goldens.check("wide", &wide), Err(Mismatch::TooLarge { .. })));
    let mut next = noise();
    let heavy = picture(&map(&sea(), |_, _, _| next() as u8));
    assert!(matches!(goldens.check("heavy", &heavy), Err(Mismatch::TooLarge { .. })));
    assert!(names_in(folder.path()).is_empty());
}

//! `gallery`: pictures, a sheet and a page, and everything that keeps them from being written.

use crate::{has_adapter, json, names_in, sentence, size_of, stderr, stdout, whitecap};

/// Small, and quick to time.
const SMALL: [&str; 6] = ["--size", "32x18", "--timing-size", "32x18", "--runs", "1"];

#[test]
fn a_folder_is_filled_with_pictures_a_sheet_and_a_page() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["gallery", "-o", "gallery", "meshuggah", "meshuggah"];
    let told = stdout(&whitecap(folder.path()).args(arguments).args(SMALL).assert().success());
    let gallery = folder.path().join("gallery");
    assert_eq!(names_in(&gallery), ["contact-sheet.png", "index.html", "meshuggah.png"]);
    assert_eq!(size_of(&gallery.join("meshuggah.png")), (32, 18));
    assert!(size_of(&gallery.join("contact-sheet.png")) > (32, 18));
    assert!(told.starts_with("gallery/index.html\n"), "{told}");
    for words in ["contact-sheet.png", "1 scene of 32 × 18", "meshuggah.png", "ms a frame"] {
        assert!(told.contains(words), "{words} is missing from:\n{told}");
    }
    let page = std::fs::read_to_string(gallery.join("index.html")).unwrap();
    for words in
        ["src=\"meshuggah.png\"", "Carsten Wenzel", "meshuggah.visibility_km", "Passes", "water", "sky"]
    {
        assert!(page.contains(words), "{words} is missing from:\n{page}");
    }
}

/// Every picture that the page shows is there, for all named scenes.
#[test]
fn the_page_shows_every_named_scene() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["gallery", "-o", ".", "--size", "16x9", "--runs", "0", "--time", "-2.5", "--json"];
    let report = json(&whitecap(folder.path()).args(arguments).assert().success());
    let page = std::fs::read_to_string(folder.path().join("index.html")).unwrap();
    let scenes = report["scenes"].as_array().unwrap();
    assert_eq!(scenes.len(), whitecap_scene::named::ALL.len());
    for (scene, named) in scenes.iter().zip(whitecap_scene::named::ALL) {
        assert_eq!(scene["scene"], named.name);
        assert_eq!(size_of(&folder.path().join(scene["picture"].as_str().unwrap())), (16, 9));
        assert!(page.contains(&format!("src=\"{}.png\"", named.name)));
        assert!(scene["passes"].as_array().unwrap().is_empty() && scene["sum_ms"].is_null());
        for difference in scene["differences"].as_array().unwrap() {
            assert!(page.contains(difference["key"].as_str().unwrap()), "{difference}");
        }
    }
    assert_eq!((&report["width"], &report["time_s"]), (&16.into(), &(-2.5).into()));
    assert!(!page.contains("Passes"));
}

#[test]
fn an_existing_gallery_is_replaced_and_other_files_are_left_alone() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for name in ["meshuggah.png", "index.html", "notes.txt"] {
        std::fs::write(folder.path().join(name), "old").unwrap();
    }
    whitecap(folder.path()).args(["gallery", "-o", ".", "meshuggah"]).args(SMALL).assert().success();
    assert_eq!(size_of(&folder.path().join("meshuggah.png")), (32, 18));
    assert_ne!(std::fs::read(folder.path().join("index.html")).unwrap(), b"old");
    assert_eq!(std::fs::read(folder.path().join("notes.txt")).unwrap(), b"old");
    assert_eq!(names_in(folder.path()).len(), 4);
}

/// These are found before an adapter is looked for.
#[test]
fn places_where_no_gallery_can_be_are_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "").unwrap();
    std::fs::create_dir_all(folder.path().join("taken/index.html")).unwrap();
    let long = "x".repeat(300);
    let cases: &[(&str, &str)] = &[
        ("file", "file is a file; name a folder"),
        ("file/gallery", "a part of file/gallery that should be a folder is a file"),
        ("absent/gallery", "the folder absent does not exist"),
        ("taken", "taken/index.html is a folder"),
        (&long, "name is too long"),
    ];
    for (output, expected) in cases {
        let assert = whitecap(folder.path())
            .args(["gallery", "--adapter", "none is asked", "-o", output])
            .assert()
            .code(2);
        let sentence = sentence(&assert);
        assert!(sentence.contains(expected), "{output}: {sentence}");
    }
    assert_eq!(names_in(folder.path()), ["file", "taken"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_place_that_takes_no_folder_is_the_machines_refusal() {
    let folder = tempfile::tempdir().unwrap();
    // Not even root makes anything there.
    for output in ["/proc/gallery", "/proc"] {
        let assert = whitecap(folder.path()).args(["gallery", "-o", output]).assert().code(1);
        assert!(sentence(&assert).starts_with("cannot write /proc/"), "{}", stderr(&assert));
    }
}

/// A limit on the size of files stands in for a full disk.
#[cfg(unix)]
#[test]
fn a_gallery_that_does_not_fit_leaves_no_half_file_and_no_empty_folder() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("old")).unwrap();
    std::fs::write(folder.path().join("old/meshuggah.png"), "old").unwrap();
    for output in ["old", "new"] {
        let mut shell = assert_cmd::Command::new("sh");
        shell.current_dir(folder.path()).args([
            "-c",
            r#"trap "" XFSZ; ulimit -f 4; exec "$0" gallery -o "$1" --size 320x180 --runs 0 meshuggah"#,
            env!("CARGO_BIN_EXE_whitecap"),
            output,
        ]);
        let assert = shell.assert().code(1);
        assert!(sentence(&assert).starts_with(&format!("cannot write {output}/")), "{}", stderr(&assert));
    }
    assert_eq!(std::fs::read(folder.path().join("old/meshuggah.png")).unwrap(), b"old");
    assert_eq!(names_in(&folder.path().join("old")), ["meshuggah.png"]);
    assert_eq!(names_in(folder.path()), ["old"]);
}

#[test]
fn a_failed_run_leaves_the_gallery_that_was_there() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("index.html"), "old").unwrap();
    for output in [".", "new"] {
        let arguments = ["gallery", "-o", output, "--adapter", "abacus", "--json"];
        let assert = whitecap(folder.path()).args(arguments).assert().failure();
        assert_eq!(json(&assert)["error"], sentence(&assert).as_str());
    }
    assert_eq!(std::fs::read(folder.path().join("index.html")).unwrap(), b"old");
    assert_eq!(names_in(folder.path()), ["index.html"]);
}

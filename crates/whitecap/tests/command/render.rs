//! `render`: pictures, and everything that keeps one from being written.

use crate::{has_adapter, json, names_in, sentence, size_of, stderr, stdout, whitecap};
use exr::meta::header::Header;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

#[test]
fn a_picture_is_made_and_told_about() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let told = stdout(&whitecap(folder.path()).args(["render", "--size", "64x36"]).assert().success());
    assert_eq!(names_in(folder.path()), ["spectral-ocean.png"]);
    assert_eq!(size_of(&folder.path().join("spectral-ocean.png")), (64, 36));
    for words in ["spectral-ocean.png", "64 × 36", "seed 11", "adapter", "total", " ms"] {
        assert!(told.contains(words), "{words} is missing from:\n{told}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_screen_nothing_is_missed_aloud() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut render = whitecap(folder.path());
    for variable in ["XDG_RUNTIME_DIR", "DISPLAY", "WAYLAND_DISPLAY"] {
        render.env_remove(variable);
    }
    let assert = render.args(["render", "--size", "16x9"]).assert().success();
    assert_eq!(stderr(&assert), "");
}

#[test]
fn programs_get_every_figure() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let arguments =
        ["render", "-o", "sea.png", "--size", "48x32", "--time", "-2.5", "--seed", "11", "--json"];
    let assert = whitecap(folder.path()).args(arguments).assert().success();
    let report = json(&assert);
    assert_eq!(report["scene"], "spectral-ocean");
    assert_eq!(report["picture"], "sea.png");
    assert_eq!((&report["width"], &report["height"]), (&48.into(), &32.into()));
    assert_eq!((&report["time_s"], &report["seed"]), (&(-2.5).into(), &11.into()));
    for key in ["name", "backend", "device_type", "driver"] {
        assert!(report["adapter"][key].is_string(), "{report}");
    }
    let stages = report["stages"].as_array().unwrap();
    let names: Vec<&str> = stages.iter().map(|stage| stage["name"].as_str().unwrap()).collect();
    assert_eq!(names.first(), Some(&"scene"));
    assert_eq!(names.last(), Some(&"file"));
    let sum: f64 = stages.iter().map(|stage| stage["ms"].as_f64().unwrap()).sum();
    let total = report["total_ms"].as_f64().unwrap();
    assert!(sum > 0.0 && sum <= total, "stages of {sum} ms in {total} ms");
    if cfg!(target_os = "linux") {
        assert!(report["peak_memory_mib"].as_f64().unwrap() > 1.0, "{report}");
    }
    assert!(!stderr(&assert).contains("whitecap:"));
}

#[test]
fn the_picture_follows_from_scene_seed_and_time_alone() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let picture = |arguments: &[&str]| {
        let path = folder.path().join("sea.png");
        whitecap(folder.path())
            .args(["render", "-o", "sea.png", "--size", "96x54"])
            .args(arguments)
            .assert()
            .success();
        std::fs::read(path).unwrap()
    };
    let first = picture(&[]);
    assert!(first == picture(&[]), "the same request gave another picture");
    assert!(first == picture(&["--time", "0", "--seed", "11"]), "defaults spelled out change the picture");
    assert!(first != picture(&["--time", "1.5"]), "time changes nothing");
    assert!(first != picture(&["--seed", "8"]), "the seed changes nothing");
}

#[test]
fn a_picture_of_a_scene_file_is_called_like_it() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let toml = stdout(&whitecap(folder.path()).args(["scenes", "meshuggah"]).assert().success());
    std::fs::create_dir(folder.path().join("seas")).unwrap();
    std::fs::write(folder.path().join("seas/storm.toml"), toml).unwrap();
    whitecap(folder.path()).args(["render", "seas/storm.toml", "--size", "16x9"]).assert().success();
    assert_eq!(names_in(folder.path()), ["seas", "storm.png"]);
    assert_eq!(names_in(&folder.path().join("seas")), ["storm.toml"]);
}

#[test]
fn a_size_beyond_the_adapter_is_refused_with_both_figures() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let assert = whitecap(folder.path()).args(["render", "--size", "4000000000x1"]).assert().code(2);
    let sentence = sentence(&assert);
    assert!(sentence.contains("4000000000") && sentence.contains("1 to "), "{sentence}");
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn an_adapter_that_is_not_there_is_refused_with_those_that_are() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let adapters = json(&whitecap(folder.path()).args(["adapters", "--json"]).assert().success());
    let arguments = ["render", "--adapter", "abacus", "--json"];
    let assert = whitecap(folder.path()).args(arguments).assert().code(2);
    let sentence = sentence(&assert);
    assert!(sentence.contains("\"abacus\""), "{sentence}");
    assert!(sentence.contains(adapters[0]["name"].as_str().unwrap()), "{sentence}");
    assert_eq!(json(&assert)["error"], sentence.as_str());
}

/// These are found before an adapter is looked for: nobody waits for a picture that has no place.
#[test]
fn places_where_no_picture_can_be_are_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("folder.png")).unwrap();
    std::fs::write(folder.path().join("file"), "").unwrap();
    let long = format!("{}.png", "x".repeat(300));
    let cases: &[(&str, i32, &str)] = &[
        ("absent/sea.png", 2, "the folder absent does not exist"),
        ("absent/sea.exr", 2, "the folder absent does not exist"),
        ("folder.png", 2, "folder.png is a folder"),
        ("file/sea.png", 2, "a part of file/sea.png that should be a folder is a file"),
        (&long, 2, "name is too long"),
    ];
    for (output, code, expected) in cases {
        let assert = whitecap(folder.path())
            .args(["render", "--adapter", "none is asked", "-o", output])
            .assert()
            .code(*code);
        let sentence = sentence(&assert);
        assert!(sentence.contains(expected), "{output}: {sentence}");
    }
    assert_eq!(names_in(folder.path()), ["file", "folder.png"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_place_that_takes_no_files_is_the_machines_refusal() {
    let folder = tempfile::tempdir().unwrap();
    // Not even root makes files there.
    let assert = whitecap(folder.path()).args(["render", "-o", "/proc/sea.png"]).assert().code(1);
    assert!(sentence(&assert).starts_with("cannot write /proc/sea.png: "), "{}", stderr(&assert));
}

#[cfg(unix)]
#[test]
fn a_device_is_not_replaced_by_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let link = folder.path().join("null.png");
    std::os::unix::fs::symlink("/dev/null", &link).unwrap();
    let assert = whitecap(folder.path()).args(["render", "-o", "null.png"]).assert().code(2);
    assert!(sentence(&assert).contains("null.png is not a regular file"), "{}", stderr(&assert));
    assert!(link.is_symlink());
}

#[test]
fn a_failed_run_leaves_the_picture_that_was_there() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("sea.png"), "old").unwrap();
    std::fs::write(folder.path().join("wrong.toml"), "colour = 1").unwrap();
    for arguments in
        [["wrong.toml", "--seed=1"], ["absent.toml", "--seed=1"], ["meshuggah", "--adapter=abacus"]]
    {
        whitecap(folder.path()).args(["render", "-o", "sea.png"]).args(arguments).assert().failure();
    }
    assert_eq!(std::fs::read(folder.path().join("sea.png")).unwrap(), b"old");
    assert_eq!(names_in(folder.path()), ["sea.png", "wrong.toml"]);
}

/// A limit on the size of files stands in for a full disk: it, too, strikes in the middle of writing.
#[cfg(unix)]
#[test]
fn a_picture_that_does_not_fit_leaves_the_old_one_whole() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("sea.png"), "old").unwrap();
    let mut shell = assert_cmd::Command::new("sh");
    shell.current_dir(folder.path()).args([
        "-c",
        r#"trap "" XFSZ; ulimit -f 4; exec "$0" render -o sea.png --size 320x180"#,
        env!("CARGO_BIN_EXE_whitecap"),
    ]);
    let assert = shell.assert().code(1);
    assert!(sentence(&assert).starts_with("cannot write sea.png: "), "{}", stderr(&assert));
    assert_eq!(std::fs::read(folder.path().join("sea.png")).unwrap(), b"old");
    assert_eq!(names_in(folder.path()), ["sea.png"]);
}

#[test]
fn a_reader_that_leaves_early_still_gets_the_picture_written() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_whitecap"))
        .args(["render", "-o", "sea.png", "--size", "64x36"])
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert!(child.wait().unwrap().success());
    assert_eq!(size_of(&folder.path().join("sea.png")), (64, 36));
}

#[test]
fn a_killed_run_leaves_the_old_picture_or_the_new_one() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("sea.png");
    for milliseconds in [1, 30, 100, 200, 400] {
        std::fs::write(&picture, "old").unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_whitecap"))
            .args(["render", "-o", "sea.png", "--size", "320x180"])
            .current_dir(folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(milliseconds));
        child.kill().unwrap();
        child.wait().unwrap();
        if std::fs::read(&picture).unwrap() != b"old" {
            assert_eq!(size_of(&picture), (320, 180));
        }
        let strays = names_in(folder.path()).into_iter().filter(|name| name != "sea.png");
        let strays: Vec<String> = strays.collect();
        let known = |name: &String| name.starts_with(".whitecap-") && name.ends_with(".png.part");
        assert!(strays.iter().all(known), "{strays:?}");
    }
}

#[test]
fn two_runs_at_once_do_not_mix() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let start = |size: &str| {
        Command::new(env!("CARGO_BIN_EXE_whitecap"))
            .args(["render", "-o", "sea.png", "--size", size])
            .current_dir(folder.path())
            .stdout(Stdio::null())
            .spawn()
            .unwrap()
    };
    let mut runs = [start("64x36"), start("96x54")];
    assert!(runs.iter_mut().all(|run| run.wait().unwrap().success()));
    assert!([(64, 36), (96, 54)].contains(&size_of(&folder.path().join("sea.png"))));
    assert_eq!(names_in(folder.path()), ["sea.png"]);
}

/// An OpenEXR file's header and its channels by name.
fn read_exr(path: &Path) -> (Header, BTreeMap<String, Vec<f32>>) {
    use exr::prelude::{ReadChannels, ReadLayers, read};
    let header = exr::meta::MetaData::read_from_file(path, true).unwrap().headers.remove(0);
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_file(path)
        .unwrap();
    let channels = image.layer_data.channel_data.list.into_iter();
    let channels = channels
        .map(|channel| (channel.name.to_string(), channel.sample_data.values_as_f32().collect()))
        .collect();
    (header, channels)
}

#[test]
fn light_is_written_linear_and_says_what_it_is() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let render = |arguments: &[&str]| {
        whitecap(folder.path()).args(["render", "--size", "64x36"]).args(arguments).assert().success()
    };
    let report = json(&render(&["spectral-ocean", "-o", "sea.exr", "--json"]));
    assert_eq!(report["samples"], 4);
    render(&["spectral-ocean", "-o", "again.exr"]);
    assert_eq!(names_in(folder.path()), ["again.exr", "sea.exr"]);
    let [first, again] =
        ["sea.exr", "again.exr"].map(|name| std::fs::read(folder.path().join(name)).unwrap());
    assert!(first == again, "the same request gave another file");

    let (header, channels) = read_exr(&folder.path().join("sea.exr"));
    assert_eq!(channels.keys().collect::<Vec<_>>(), ["B", "G", "R"]);
    assert_eq!(header.layer_size, exr::math::Vec2(64, 36));
    assert_eq!(header.own_attributes.white_luminance, Some(1000.0));
    let comments = header.own_attributes.comments.unwrap().to_string();
    assert!(comments.contains("spectral-ocean") && comments.contains("4 samples"), "{comments}");
    // A sunlit sea: some kcd/m², and nothing that a display would have cut off.
    let green = &channels["G"];
    assert!(green.iter().all(|light| light.is_finite() && *light > 0.0));
    assert!(green.iter().copied().fold(0.0, f32::max) > 1.0, "cut off at white");

    render(&["meshuggah", "-o", "classic.exr", "--samples", "2"]);
    let (header, channels) = read_exr(&folder.path().join("classic.exr"));
    assert_eq!(header.own_attributes.white_luminance, None);
    assert!(channels.values().flatten().all(|light| (0.0..=1.0).contains(light)));
}

#[test]
fn stills_of_many_samples_are_told_and_repeat() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let render = |name: &str, samples: &str| {
        let arguments = ["render", "spectral-ocean", "--size", "64x36", "-o", name, "--samples", samples];
        let told = stdout(&whitecap(folder.path()).args(arguments).assert().success());
        assert!(told.contains(&format!("{samples} samples a pixel")), "{told}");
        std::fs::read(folder.path().join(name)).unwrap()
    };
    let first = render("first.png", "9");
    assert!(first == render("again.png", "9"), "the same request gave another picture");
    assert!(first != render("other.png", "3"), "their number changes nothing");
}

#[test]
fn what_a_picture_shows_is_written_beside_it() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let render = |arguments: &[&str]| {
        let render = ["render", "--size", "64x36", "--aux", "--json"];
        json(&whitecap(folder.path()).args(render).args(arguments).assert().success())
    };
    assert_eq!(render(&["spectral-ocean"])["aux"], "spectral-ocean.aux.exr");
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    let first = read("spectral-ocean.aux.exr");
    render(&["spectral-ocean", "-o", "sea.exr", "--samples", "2"]);
    assert_eq!(
        names_in(folder.path()),
        ["sea.aux.exr", "sea.exr", "spectral-ocean.aux.exr", "spectral-ocean.png"]
    );
    assert!(read("sea.aux.exr") == first, "it depends on the picture beside it");

    let (header, channels) = read_exr(&folder.path().join("sea.aux.exr"));
    let names = "N.X N.Y N.Z P.X P.Y P.Z Z distance.Z glint.X object.X sky.X water.X";
    assert_eq!(channels.keys().map(String::as_str).collect::<Vec<_>>().join(" "), names);
    // Vectors are rows: the device's x and y run from the top left corner to 1.
    let device = header.own_attributes.world_to_normalized_device.unwrap();
    let camera = header.own_attributes.world_to_camera.unwrap();
    let at = |name: &str, i: usize| channels[name][i];
    for i in 0..64 * 36 {
        let masks = ["water.X", "object.X", "sky.X"].map(|name| at(name, i));
        assert!(masks.iter().sum::<f32>() == 1.0 && masks.contains(&1.0), "{masks:?}");
        assert_eq!(at("Z", i) == f32::INFINITY, at("sky.X", i) == 1.0);
        assert!((0.0..=1.0).contains(&at("glint.X", i)));
        if at("sky.X", i) == 0.0 {
            let place = ["P.X", "P.Y", "P.Z"].map(|name| at(name, i));
            let column = |matrix: &[f32; 16], c: usize| {
                (0..3).map(|r| place[r] * matrix[4 * r + c]).sum::<f32>() + matrix[12 + c]
            };
            let found = [64.0, 36.0].map(|pixels| pixels / column(&device, 3));
            let found = [found[0] * column(&device, 0), found[1] * column(&device, 1)];
            let centre = [(i % 64) as f32 + 0.5, (i / 64) as f32 + 0.5];
            assert!((0..2).all(|axis| (found[axis] - centre[axis]).abs() < 0.01), "{found:?}, {centre:?}");
            let depth = column(&camera, 2);
            assert!((depth / at("Z", i) - 1.0).abs() < 1e-3, "{depth} m");
        }
    }

    render(&["meshuggah"]);
    let (_, channels) = read_exr(&folder.path().join("meshuggah.aux.exr"));
    let names = "P.X P.Y P.Z Z distance.Z object.X sky.X water.X";
    assert_eq!(channels.keys().map(String::as_str).collect::<Vec<_>>().join(" "), names);
}

#[test]
fn a_place_that_the_second_file_cannot_have_is_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("sea.aux.exr")).unwrap();
    let arguments = ["render", "--adapter", "none is asked", "-o", "sea.png", "--aux"];
    let assert = whitecap(folder.path()).args(arguments).assert().code(2);
    assert!(sentence(&assert).contains("sea.aux.exr is a folder"), "{}", stderr(&assert));
    assert_eq!(names_in(folder.path()), ["sea.aux.exr"]);
}

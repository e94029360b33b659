//! `render --frames`: what is made, what is kept, and what an end in the middle leaves.

use crate::{contents, has_adapter, kill_at_any_moment, names_in, sentence, stderr, stdout, whitecap};
use assert_cmd::assert::Assert;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// A scene that is quickly drawn.
const QUICK: &str = "five-sample";

fn lines(assert: &Assert) -> Vec<serde_json::Value> {
    stdout(assert).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// Frames of a sequence are the pictures that `render` makes of their moments, kept where they are there already.
#[test]
fn frames_are_the_pictures_of_their_moments() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (scene, ending) in [("meshuggah", "png"), ("spectral-ocean", "exr")] {
        let render = |arguments: &[&str]| {
            let mut command = whitecap(folder.path());
            command.args(["render", scene, "--size", "32x18"]).args(arguments).assert().success()
        };
        let pattern = format!("out/{scene}.%03d.{ending}");
        let made =
            lines(&render(&["--time", "3", "--frames", "2..5", "--fps", "4", "-o", &pattern, "--json"]));
        let kept = |of: &[serde_json::Value]| -> Vec<bool> {
            of[..of.len() - 1].iter().map(|line| line["kept"].as_bool().unwrap()).collect()
        };
        assert_eq!(kept(&made), [false; 3]);
        for (line, (number, time)) in made.iter().zip([(2, "3.5"), (3, "3.75"), (4, "4")]) {
            assert_eq!(
                (&line["frame"], &line["time_s"]),
                (&number.into(), &time.parse::<f64>().unwrap().into())
            );
            let alone = format!("alone.{ending}");
            render(&["--time", time, "-o", &alone]);
            let frame = folder.path().join(line["picture"].as_str().unwrap());
            let same = fs::read(folder.path().join(&alone)).unwrap() == fs::read(&frame).unwrap();
            assert!(same, "{}", frame.display());
        }
        let (first, third) =
            (folder.path().join(format!("out/{scene}.002.{ending}")), format!("out/{scene}.004.{ending}"));
        let whole = fs::read(&first).unwrap();
        fs::remove_file(folder.path().join(&third)).unwrap();
        fs::write(&first, "as it was").unwrap();
        let again =
            lines(&render(&["--time", "3", "--frames", "2..5", "--fps", "4", "-o", &pattern, "--json"]));
        assert_eq!(kept(&again), [true, true, false]);
        assert_eq!((&again[3]["made"], &again[3]["kept"]), (&1.into(), &2.into()));
        assert_eq!(fs::read(&first).unwrap(), b"as it was");
        let told = stdout(&render(&[
            "--time",
            "3",
            "--frames",
            "2..5",
            "--fps",
            "4",
            "-o",
            &pattern,
            "--overwrite",
        ]));
        assert!(told.contains("3 frames") && told.contains("3 made\n"), "{told}");
        assert_eq!(fs::read(&first).unwrap(), whole);
    }
}

/// Beside each frame what it shows, for those frames that lack it, too.
#[test]
fn frames_have_what_they_show_beside_them() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let render = || {
        let mut command = whitecap(folder.path());
        let arguments = ["render", QUICK, "--size", "16x9", "--frames", "0..2", "--aux", "-o", "f.%d.png"];
        command.args(arguments).assert().success()
    };
    render();
    assert_eq!(names_in(folder.path()), ["f.0.aux.exr", "f.0.png", "f.1.aux.exr", "f.1.png"]);
    fs::remove_file(folder.path().join("f.1.aux.exr")).unwrap();
    render();
    assert_eq!(names_in(folder.path()).len(), 4);
}

/// Two halves at once, and both as a whole beside them: every frame once, whole, and the same as from one process.
#[test]
fn machines_share_a_folder() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let start = |out: &str, chunk: Option<&str>| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_whitecap"));
        let pattern = format!("{out}/f.%04d.png");
        command
            .current_dir(&folder)
            .args(["render", QUICK, "--size", "16x9", "--frames", "3..33", "-o", &pattern]);
        command.args(chunk.iter().flat_map(|chunk| ["--chunk", chunk]));
        command.stdout(Stdio::null()).spawn().unwrap()
    };
    assert!(start("alone", None).wait().unwrap().success());
    let together = [Some("1/2"), Some("2/2"), None].map(|chunk| start("together", chunk));
    for mut child in together {
        assert!(child.wait().unwrap().success());
    }
    let [alone, together] = ["alone", "together"].map(|out| contents(&folder.path().join(out)));
    assert_eq!(alone.len(), 30);
    assert!(alone == together);
}

/// Killed fifty times at any moment, the sequence never has a partial file under a final name, and in the end is that of an
/// undisturbed run, with nothing else in its folder.
#[test]
fn a_killed_sequence_goes_on_where_it_was() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let render = |out: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_whitecap"));
        let pattern = format!("{out}/f.%04d.png");
        command
            .current_dir(&folder)
            .args(["render", QUICK, "--size", "64x36", "--frames", "0..400", "-o", &pattern]);
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command
    };
    assert!(render("whole").status().unwrap().success());
    let (whole, killed) = (folder.path().join("whole"), folder.path().join("killed"));
    let mut grew = 0;
    for i in 0..50 {
        let before = if killed.is_dir() { names_in(&killed).len() } else { 0 };
        let mut child = render("killed").spawn().unwrap();
        let count = || fs::read_dir(&killed).map_or(0, Iterator::count);
        kill_at_any_moment(&mut child, i, 0.9, count);
        if !killed.is_dir() {
            continue;
        }
        let there: Vec<String> =
            names_in(&killed).into_iter().filter(|name| name.starts_with("f.")).collect();
        grew += usize::from(there.len() > before && there.len() < 400);
        for name in there {
            let same = fs::read(killed.join(&name)).unwrap() == fs::read(whole.join(&name)).unwrap();
            assert!(same, "{name} is not whole");
        }
    }
    assert!(grew >= 5, "only {grew} runs were killed while they wrote");
    assert!(render("killed").status().unwrap().success());
    assert!(contents(&killed) == contents(&whole));
}

/// A small disk: the frames that fit are whole, and the sentence says what is to be done.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_whole_frames() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("disk")).unwrap();
    let script = format!(
        "mount -t tmpfs -o size=64k tmpfs disk || exit 99; \
         {} render {QUICK} --size 64x36 --frames 0..400 -o disk/f.%04d.png; code=$?; cp -r disk kept; exit $code",
        env!("CARGO_BIN_EXE_whitecap")
    );
    let mut command = assert_cmd::Command::new("unshare");
    let assert =
        command.current_dir(&folder).args(["--map-root-user", "--mount", "sh", "-c", &script]).assert();
    let assert = assert.code(1);
    let said = sentence(&assert);
    assert!(said.contains("cannot write disk/f.") && said.contains("free some space"), "{said}");
    let kept = contents(&folder.path().join("kept"));
    assert!(kept.len() > 5, "{}", kept.len());
    for (name, bytes) in kept {
        let is_whole = image::load_from_memory(&bytes).is_ok_and(|picture| picture.width() == 64);
        assert!(is_whole && name.starts_with("f."), "{name}");
    }
}

/// Ten thousand frames take no more memory than a thousand.
#[test]
fn memory_does_not_grow_with_frames() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let peak_mib = |frames: u32| {
        let (range, pattern) = (format!("0..{frames}"), format!("out{frames}/f.%05d.png"));
        let mut command = whitecap(folder.path());
        let arguments = ["render", QUICK, "--size", "16x9", "--frames", &range, "-o", &pattern, "--json"];
        let whole = lines(&command.args(arguments).assert().success()).pop().unwrap();
        assert_eq!(whole["made"], frames);
        whole["peak_memory_mib"].as_f64().unwrap()
    };
    let (few, many) = (peak_mib(1000), peak_mib(10_000));
    assert!(many < few + 8.0, "{few} MiB for 1,000, {many} for 10,000");
}

/// A loop's end is its beginning: the frame after the last is the first.
#[test]
fn a_loop_closes() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let text = stdout(&whitecap(folder.path()).args(["scenes", "spectral-ocean"]).assert().success());
    let looped = text.replacen("[sea]\n", "[sea]\nloop_s = 20.0\n", 1);
    assert_ne!(looped, text);
    fs::write(folder.path().join("loop.toml"), looped).unwrap();
    let frame = |number: u32| {
        let range = format!("{number}..{}", number + 1);
        let arguments = ["render", "loop.toml", "--size", "32x18", "--frames", &range, "-o", "f.%d.png"];
        whitecap(folder.path()).args(arguments).assert().success();
        image::open(folder.path().join(format!("f.{number}.png"))).unwrap().to_rgb8()
    };
    let difference = |a: &image::RgbImage, b: &image::RgbImage| {
        let levels = a.iter().zip(b.iter()).map(|(a, b)| f64::from(a.abs_diff(*b)));
        levels.sum::<f64>() / a.len() as f64
    };
    let (first, second, last, after) = (frame(0), frame(1), frame(479), frame(480));
    assert!(difference(&first, &after) < 0.05, "{}", difference(&first, &after));
    // The last is as near to the first as any frame is to the next.
    let (step, seam) = (difference(&first, &second), difference(&last, &first));
    assert!(step > 0.0 && (0.5..2.0).contains(&(seam / step)), "{step}, over the seam {seam}");
}

#[test]
fn frames_that_cannot_be_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let render = |arguments: &[&str]| {
        let assert = whitecap(folder.path()).arg("render").args(arguments).assert().code(2);
        stderr(&assert)
    };
    for (arguments, words) in [
        (&["--frames", "240..0"][..], "the last comes before the first"),
        (&["--frames", "7..7"], "no frame"),
        (&["--frames", "0..1000000000"], "1000000000 frames; accepted: up to 1000000"),
        (&["--frames", "-3..5"], "such as 0..240"),
        (&["--frames", "0..5", "-o", "sea.png"], "sea.png: no counter; accepted: one counter"),
        (&["--frames", "0..5", "-o", "sea.%d.%d.png"], "2 counters"),
        (&["--frames", "0..5", "-o", "no/where/sea.%d.png"], "the folder no does not exist"),
        (&["--frames", "0..5", "--chunk", "5/4"], "there are 4 parts"),
        (&["--frames", "0..5", "--chunk", "0/4"], "such as 2/5"),
        (&["--frames", "0..5", "--fps", "0"], "such as 24 or 30000/1001"),
        (&["--frames", "0..1000000", "--fps", "0.1"], "accepted: moments up to 1000000 s"),
        (&["--chunk", "1/2"], "--frames"),
        (&["--overwrite"], "--frames"),
        (&["-o", "sea.%04d.png"], "counts frames; say which --frames"),
        (&["-o", "sea.mp4"], "is a film; say which --frames"),
        (&["--frames", "0..5", "-o", "sea.avi"], "in .mp4 or .webm"),
    ] {
        let said = render(arguments);
        assert!(said.contains(words), "{arguments:?}: {said}");
    }
    assert!(names_in(folder.path()).is_empty());
    fs::write(folder.path().join("file"), "").unwrap();
    assert!(render(&["--frames", "0..5", "-o", "file/sea.%d.png"]).contains("file is a file; name a folder"));
}

/// A stand-in for the user's ffmpeg: `body` is what it does with the arguments.
#[cfg(unix)]
fn with_ffmpeg(folder: &Path, body: &str) -> assert_cmd::Command {
    use std::os::unix::fs::PermissionsExt;
    let bin = folder.join("bin");
    fs::create_dir_all(&bin).unwrap();
    let script = bin.join("ffmpeg");
    fs::write(&script, format!("#!/bin/sh\n[ \"$1\" = -version ] && exit 0\nfor last; do :; done\n{body}\n"))
        .unwrap();
    fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).unwrap();
    let mut command = whitecap(folder);
    let path = std::env::var("PATH").unwrap_or_default();
    command.env("PATH", format!("{}:{path}", bin.display()));
    command
}

#[cfg(unix)]
#[test]
fn films_are_made_by_ffmpeg() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let film = |body: &str| {
        let mut command = with_ffmpeg(folder.path(), body);
        command.args(["render", QUICK, "--size", "16x9", "--frames", "4..7", "--fps", "30000/1001"]);
        command.args(["-o", "sea.mp4"]).assert()
    };
    // One that dies half-way.
    let died =
        film("echo half > \"$last\"; echo 'header missing' >&2; echo 'Conversion failed!' >&2; exit 69");
    let said = sentence(&died.code(1));
    for words in ["sea.mp4", "header missing; Conversion failed!", "the frames are kept in sea.mp4.frames"] {
        assert!(said.contains(words), "{said}");
    }
    assert_eq!(names_in(folder.path()), ["bin", "sea.mp4.frames"]);
    assert_eq!(names_in(&folder.path().join("sea.mp4.frames")).len(), 3);
    // One that works takes the frames that are there.
    let made = film("echo \"$@\" > \"$last\"; ls sea.mp4.frames >> \"$last\"").success();
    assert!(stdout(&made).contains("0 made, 3 were there already"), "{}", stdout(&made));
    assert_eq!(names_in(folder.path()), ["bin", "sea.mp4"]);
    let told = fs::read_to_string(folder.path().join("sea.mp4")).unwrap();
    for words in [
        "-framerate 30000/1001 -start_number 4 -i sea.mp4.frames/frame.%06d.png",
        "libx264",
        "frame.000006.png",
    ] {
        assert!(told.contains(words), "{told}");
    }
}

#[cfg(unix)]
#[test]
fn without_ffmpeg_films_are_refused_before_anything_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = whitecap(folder.path());
    command.env("PATH", folder.path()).args(["render", "--frames", "0..5", "-o", "sea.webm"]);
    let said = sentence(&command.assert().code(1));
    assert!(said.contains("ffmpeg, which is not on the path; install it, or render frames"), "{said}");
    assert!(names_in(folder.path()).is_empty());
    let chunk = with_ffmpeg(folder.path(), "exit 0")
        .args(["render", "--frames", "0..5", "--chunk", "1/2", "-o", "sea.webm"])
        .assert();
    assert!(sentence(&chunk.code(2)).contains("a film has all of its frames"));
}

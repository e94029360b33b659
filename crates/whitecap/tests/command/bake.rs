//! `bake`: maps that are the surface that `probe` tells of, whole or not at all.

use crate::{contents, json, kill_at_any_moment, names_in, sentence, stderr, stdout, whitecap};
use assert_cmd::assert::Assert;
use exr::prelude::{ReadChannels, ReadLayers};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// A quick sea that loops, of two tiles.
const LOOP: &str = "\
technique = \"spectral-ocean\"
seed = 5
[sea]
resolution = 64
cascades = 2
loop_s = 12.0
[[sea.system]]
spectrum = \"jonswap\"
significant_height_m = 2.5
peak_period_s = 8.0
from_deg = 250.0
[camera]
position_m = [0.0, 8.0, 0.0]
look_at_m = [100.0, 0.0, 0.0]
";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("loop.toml"), LOOP).unwrap();
    folder
}

fn bake(folder: &Path, arguments: &[&str]) -> Assert {
    whitecap(folder).args(["bake", "loop.toml"]).args(arguments).assert()
}

/// Shape and numbers of a NumPy file.
fn npy(path: &Path) -> (Vec<usize>, Vec<f32>) {
    let bytes = fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let length = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let header = std::str::from_utf8(&bytes[10..length]).unwrap();
    let shape = header.split(['(', ')']).nth(1).unwrap();
    let shape = shape.split(',').filter_map(|side| side.trim().parse().ok()).collect();
    let numbers = bytes[length..].chunks_exact(4).map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()));
    (shape, numbers.collect())
}

/// Water that rests at a sample is where its displacement says; over that place `probe` finds the same height, normal and velocity.
#[test]
fn baked_maps_are_the_surface_that_probe_tells_of() {
    let folder = folder();
    let arguments = [
        "--maps",
        "displacement,normal,velocity,jacobian",
        "--format",
        "npy",
        "--area",
        "1000000..1000050/26,-20..20/21",
        "--time",
        "3",
        "-o",
        "maps",
    ];
    bake(folder.path(), &arguments).success();
    let map = |name: &str| npy(&folder.path().join(format!("maps/area.{name}.0000.npy")));
    let (shape, displacement) = map("displacement");
    assert_eq!(shape, [21, 26, 3]);
    let (jacobian_shape, jacobian) = map("jacobian");
    assert_eq!(jacobian_shape, [21, 26]);
    let [normal, velocity] = ["normal", "velocity"].map(|name| map(name).1);
    let mut points = "x_m,z_m\n".to_owned();
    for i in 0..21 * 26 {
        let (x, z) = (1e6 + 2.0 * (i % 26) as f64, -20.0 + 2.0 * (i / 26) as f64);
        points +=
            &format!("{},{}\n", x + f64::from(displacement[3 * i]), z + f64::from(displacement[3 * i + 2]));
    }
    fs::write(folder.path().join("points.csv"), points).unwrap();
    let probed = whitecap(folder.path())
        .args(["probe", "loop.toml", "--points", "points.csv", "--time", "3", "--json"])
        .assert()
        .success();
    let probed = json(&probed);
    let rows = probed.as_array().unwrap();
    assert_eq!(rows.len(), 21 * 26);
    let mut compared = 0;
    for (i, row) in rows.iter().enumerate().filter(|(i, _)| jacobian[*i] > 0.3) {
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        let height = number(&row["height_m"]);
        assert!((height - f64::from(displacement[3 * i + 1])).abs() < 1e-3, "{i}: {height}");
        for axis in 0..3 {
            let baked = f64::from(normal[3 * i + axis]);
            assert!((number(&row["normal"][axis]) - baked).abs() < 2e-3, "{i}");
            let baked = f64::from(velocity[3 * i + axis]);
            assert!((number(&row["velocity_mps"][axis]) - baked).abs() < 2e-3, "{i}");
        }
        compared += 1;
    }
    assert!(compared > 500, "{compared}");
}

/// Every format holds the same numbers, to its own grain, and says what they are.
#[test]
fn formats_hold_the_same_numbers() {
    let folder = folder();
    for format in ["npy", "exr", "exr16", "png16"] {
        bake(
            folder.path(),
            &["--maps", "displacement,slope,jacobian,foam", "--format", format, "-o", format],
        )
        .success();
    }
    let facts: serde_json::Value =
        serde_json::from_slice(&fs::read(folder.path().join("png16/bake.json")).unwrap()).unwrap();
    assert_eq!(
        (&facts["loop_s"], &facts["seed"], &facts["of"][1]["resolution"]),
        (&12.0.into(), &5.into(), &64.into())
    );
    assert_eq!(facts["of"][0]["files"], "cascade0.{map}.%04d.png");
    for (map, channels) in [("displacement", 3), ("slope", 2), ("jacobian", 1), ("foam", 1)] {
        let (shape, numbers) = npy(&folder.path().join(format!("npy/cascade0.{map}.0000.npy")));
        assert_eq!(shape[..2], [64, 64]);
        let most = numbers.iter().fold(0.0_f32, |most, number| most.max(number.abs()));
        assert!(most > 0.0, "{map}");
        for (format, grain) in [("exr", 0.0), ("exr16", 5e-4)] {
            let image = exr::prelude::read()
                .no_deep_data()
                .largest_resolution_level()
                .all_channels()
                .first_valid_layer()
                .all_attributes()
                .from_file(folder.path().join(format!("{format}/cascade0.{map}.0000.exr")))
                .unwrap();
            let list = &image.layer_data.channel_data.list;
            assert_eq!(list.len(), channels);
            let said = &image.layer_data.attributes.other[&exr::prelude::Text::from("whitecap")];
            let exr::prelude::AttributeValue::Text(said) = said else { panic!("{said:?}") };
            let said: serde_json::Value = serde_json::from_str(&said.to_string()).unwrap();
            assert_eq!((&said["of"]["cascade"], &said["loop_s"]), (&0.into(), &12.0.into()));
            assert_eq!(said["map"]["unit"], if map == "displacement" { "m" } else { "1" });
            for (c, name) in ["R", "G", "B"].into_iter().enumerate().take(channels) {
                let name = if channels == 1 { "Y" } else { name };
                let channel = list.iter().find(|channel| channel.name == *name).unwrap();
                for (i, value) in channel.sample_data.values_as_f32().enumerate() {
                    let expected = numbers[channels * i + c];
                    assert!(
                        (value - expected).abs() <= grain * expected.abs().max(0.1),
                        "{format} {map} {i}"
                    );
                }
            }
        }
        let bounds = ["black", "white"].map(|bound| facts["maps"][map][bound].as_f64().unwrap());
        let picture =
            image::open(folder.path().join(format!("png16/cascade0.{map}.0000.png"))).unwrap().into_rgb16();
        if map != "foam" {
            for (i, pixel) in picture.pixels().enumerate() {
                for c in 0..channels {
                    let value = bounds[0] + (bounds[1] - bounds[0]) * f64::from(pixel.0[c]) / 65_535.0;
                    let step = (bounds[1] - bounds[0]) / 65_535.0;
                    assert!((value - f64::from(numbers[channels * i + c])).abs() < step, "{map} {i}");
                }
            }
        }
    }
}

/// The frame after a loop's last is the first, to the bit; parts of several machines make the whole; threads change nothing.
#[test]
fn loops_close_and_parts_make_the_whole() {
    let folder = folder();
    let render = |out: &str, more: &[&str], threads: &str| {
        let mut command = whitecap(folder.path());
        command.env("RAYON_NUM_THREADS", threads);
        command.args(["bake", "loop.toml", "--frames", "0..13", "--fps", "1", "--format", "npy", "-o", out]);
        command.args(more).assert().success()
    };
    let told = stdout(&render("whole", &["--json"], "2"));
    let lines: Vec<serde_json::Value> =
        told.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 14);
    assert_eq!((&lines[13]["frames"], &lines[13]["made"]), (&13.into(), &52.into()));
    let whole = folder.path().join("whole");
    for name in ["cascade0.displacement", "cascade1.normal"] {
        let frame = |number: u32| fs::read(whole.join(format!("{name}.{number:04}.npy"))).unwrap();
        assert!(frame(0) == frame(12) && frame(0) != frame(11));
    }
    for chunk in ["2/3", "1/3", "3/3"] {
        render("parts", &["--chunk", chunk], "1");
    }
    assert!(contents(&whole) == contents(&folder.path().join("parts")));
    // What is there is kept.
    fs::write(whole.join("cascade0.normal.0003.npy"), "mine").unwrap();
    fs::remove_file(whole.join("cascade0.normal.0004.npy")).unwrap();
    assert!(stdout(&render("whole", &[], "2")).contains("1 files made, 51 were there already"));
    assert_eq!(fs::read(whole.join("cascade0.normal.0003.npy")).unwrap(), b"mine");
    render("whole", &["--overwrite"], "2");
    assert!(contents(&whole) == contents(&folder.path().join("parts")));
}

/// As for a sequence of pictures.
#[test]
fn a_killed_bake_goes_on_where_it_was() {
    let folder = folder();
    let start = |out: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_whitecap"));
        command.current_dir(&folder).args([
            "bake",
            "loop.toml",
            "--frames",
            "0..300",
            "--maps",
            "displacement",
            "-o",
            out,
        ]);
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command
    };
    assert!(start("whole").status().unwrap().success());
    let (whole, killed) = (folder.path().join("whole"), folder.path().join("killed"));
    let mut grew = 0;
    for i in 0..50 {
        let before = if killed.is_dir() { names_in(&killed).len() } else { 0 };
        let mut child = start("killed").spawn().unwrap();
        let count = || fs::read_dir(&killed).map_or(0, Iterator::count);
        kill_at_any_moment(&mut child, i, 0.1, count);
        if !killed.is_dir() {
            continue;
        }
        let there: Vec<String> =
            names_in(&killed).into_iter().filter(|name| !name.starts_with('.')).collect();
        grew += usize::from(there.len() > before && there.len() < 601);
        for name in there {
            assert!(
                fs::read(killed.join(&name)).unwrap() == fs::read(whole.join(&name)).unwrap(),
                "{name} is not whole"
            );
        }
    }
    assert!(grew >= 5, "only {grew} runs were killed while they wrote");
    assert!(start("killed").status().unwrap().success());
    assert!(contents(&killed) == contents(&whole));
}

#[test]
fn bakes_that_cannot_be_are_refused() {
    let folder = folder();
    let refused = |arguments: &[&str], words: &str| {
        let assert = whitecap(folder.path()).arg("bake").args(arguments).assert().code(2);
        assert!(stderr(&assert).contains(words), "{arguments:?}: {}", stderr(&assert));
    };
    refused(&[], "--output <DIR>");
    refused(
        &["-o", "maps", "--maps", "displacement,colour"],
        "[possible values: displacement, normal, slope, jacobian, foam, velocity]",
    );
    refused(&["-o", "maps", "--format", "tiff"], "[possible values: exr, exr16, png16, npy]");
    refused(&["-o", "maps", "--frames", "9..3"], "the last comes before the first");
    refused(&["-o", "maps", "--frames", "0..1000000000"], "accepted: up to 1000000");
    refused(&["-o", "maps", "--chunk", "5/4"], "there are 4 parts");
    refused(
        &["-o", "maps", "--area", "0..1/100000,0..1/100000"],
        "10000000000 samples; accepted: up to 16777216",
    );
    refused(&["ocean-water", "-o", "maps"], "no sea of spectra to bake, but one of model \"sines\"");
    refused(&["-o", "no/maps"], "the folder no does not exist");
    refused(&["-o", "loop.toml"], "loop.toml is a file; name a folder");
    assert_eq!(names_in(folder.path()), ["loop.toml"]);
}

/// A small disk: files that fit are whole, and the sentence says what is to be done.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_whole_maps() {
    let folder = folder();
    fs::create_dir(folder.path().join("disk")).unwrap();
    let script = format!(
        "mount -t tmpfs -o size=500k tmpfs disk || exit 99; \
         {} bake loop.toml --frames 0..100 --format npy -o disk; code=$?; cp -r disk kept; exit $code",
        env!("CARGO_BIN_EXE_whitecap")
    );
    let mut command = assert_cmd::Command::new("unshare");
    let assert =
        command.current_dir(&folder).args(["--map-root-user", "--mount", "sh", "-c", &script]).assert();
    let said = sentence(&assert.code(1));
    assert!(said.contains("cannot write disk/cascade") && said.contains("free some space"), "{said}");
    let kept = names_in(&folder.path().join("kept"));
    assert!(kept.len() > 5, "{kept:?}");
    for name in kept.into_iter().filter(|name| name != "bake.json") {
        let (shape, numbers) = npy(&folder.path().join("kept").join(&name));
        assert_eq!((shape[0], numbers.len()), (64, 64 * 64 * 3), "{name}");
    }
}

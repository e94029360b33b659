//! `probe`: the surface as numbers, without an adapter.

use crate::{json, sentence, stderr, stdout, whitecap};
use serde_json::Value;
use std::path::Path;

fn probe(folder: &Path, arguments: &[&str]) -> Vec<Value> {
    let assert = whitecap(folder).arg("probe").args(arguments).arg("--json").assert().success();
    json(&assert).as_array().unwrap().clone()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (found_one, expected_one) in found.iter().zip(expected) {
        assert!((found_one - expected_one).abs() <= tolerance, "{found:?} instead of {expected:?}");
    }
}

/// A scene with the text's own waves, whatever the named scenes are like.
fn drawn_by(folder: &Path, technique: &str) -> String {
    let name = format!("{technique}.toml");
    let camera = "[camera]\nposition_m = [0.0, 4.0, 0.0]\nlook_at_m = [100.0, 0.0, 0.0]\n";
    std::fs::write(folder.join(&name), format!("technique = \"{technique}\"\n{camera}")).unwrap();
    name
}

/// The golden numbers of ATI's vertex shader (ShaderX 2002), through the whole command.
#[test]
fn the_four_sines_are_the_texts() {
    let folder = tempfile::tempdir().unwrap();
    let scene = drawn_by(folder.path(), "ocean-water");
    for (uv, time, height, normal) in [
        ("--uv=0,0", "0", -106.35375, [0.036576, 0.004033, 0.999323]),
        ("--uv=0.3,0.7", "1", -102.12166, [-0.010223, -0.041323, 0.999094]),
        ("--uv=2.5,1.25", "3.7", -17.81397, [-0.040023, 0.034756, 0.998594]),
    ] {
        let answer = probe(folder.path(), &[&scene, uv, "--time", time]);
        near(&[answer[0]["height"].as_f64().unwrap()], &[height], 1e-5);
        near(&numbers(&answer[0]["normal"]), &normal, 1e-6);
    }
}

#[test]
fn a_place_and_its_texture_coordinates_have_the_same_height() {
    let folder = tempfile::tempdir().unwrap();
    let scene = drawn_by(folder.path(), "ocean-water");
    // By default a unit of height is 1 cm and a unit of u is 2π/0.003 of them.
    let uv_size_m = std::f64::consts::TAU / 0.003 * 0.01;
    let at = format!("{},{}", 0.3 * uv_size_m, -0.7 * uv_size_m);
    let answers = probe(folder.path(), &[&scene, "--uv", "0.3,-0.7", "--at", &at, "--time", "-12.5"]);
    let (world, text) = (&answers[0], &answers[1]);
    assert!(world.get("u").is_none() && text.get("x_m").is_none(), "places come first: {answers:?}");
    near(&[world["height_m"].as_f64().unwrap()], &[0.01 * text["height"].as_f64().unwrap()], 1e-9);
}

#[test]
fn every_place_has_exactly_the_promised_keys_and_its_own_answer() {
    let folder = tempfile::tempdir().unwrap();
    let answers =
        probe(folder.path(), &["meshuggah", "--at", "-3,4", "--at=12.5,-7", "--at", "-3,4", "--time", "2.5"]);
    assert_eq!(answers.len(), 3);
    for answer in &answers {
        let keys: Vec<&String> = answer.as_object().unwrap().keys().collect();
        let mut expected = ["x_m", "z_m", "time_s", "height_m", "displacement_m", "normal", "velocity_mps"];
        expected.sort_unstable();
        let mut keys: Vec<&str> = keys.into_iter().map(String::as_str).collect();
        keys.sort_unstable();
        assert_eq!(keys, expected);
        assert_eq!(answer["time_s"], 2.5);
        let normal = numbers(&answer["normal"]);
        near(&[normal.iter().map(|n| n * n).sum::<f64>()], &[1.0], 1e-9);
        assert!(normal[1] > 0.5, "y is up: {normal:?}");
        assert_eq!(numbers(&answer["displacement_m"])[1], answer["height_m"].as_f64().unwrap());
    }
    assert_eq!((&answers[0]["x_m"], &answers[0]["z_m"]), (&Value::from(-3.0), &Value::from(4.0)));
    assert_eq!(answers[0], answers[2]);
    assert_ne!(answers[0]["height_m"], answers[1]["height_m"]);
}

/// The water over a place lies a displacement away from where it rests, and is as the library says.
#[test]
fn the_answer_is_the_surface_over_the_place() {
    let folder = tempfile::tempdir().unwrap();
    let scene = whitecap_scene::open("meshuggah").unwrap();
    let sea = scene.sea.build(11).unwrap();
    let answers = probe(folder.path(), &["meshuggah", "--at=40,-25", "--seed", "11", "--time", "-3"]);
    let displacement_m = numbers(&answers[0]["displacement_m"]);
    assert!(displacement_m[0] != 0.0 && displacement_m[2] != 0.0, "choppy waves move sideways");
    let rest_m = glam::DVec2::new(40.0 - displacement_m[0], -25.0 - displacement_m[2]);
    let point = sea.sample(rest_m, -3.0);
    // A query is within 0.1 % of the significant height, 1.7 m here.
    near(&displacement_m, &point.displacement_m.to_array(), 2e-3);
    near(&numbers(&answers[0]["normal"]), &point.normal.to_array(), 5e-3);
    near(&numbers(&answers[0]["velocity_mps"]), &point.velocity_mps.to_array(), 1e-2);
}

#[test]
fn seed_and_time_change_the_answer_and_nothing_else_does() {
    let folder = tempfile::tempdir().unwrap();
    let ask = |more: &[&str]| probe(folder.path(), &[&["meshuggah", "--at", "5,5"], more].concat());
    assert_eq!(ask(&[]), ask(&["--time", "0", "--seed", "7"]));
    assert_ne!(ask(&[])[0]["height_m"], ask(&["--seed", "8"])[0]["height_m"]);
    assert_ne!(ask(&[])[0]["height_m"], ask(&["--time", "1"])[0]["height_m"]);
}

#[test]
fn a_calm_sea_is_level_and_says_that_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let scene = drawn_by(folder.path(), "five-sample");
    let arguments = ["probe", &scene, "--at", "-10000000,1e7", "--json"];
    let assert = whitecap(folder.path()).args(arguments).assert().success();
    assert_eq!(json(&assert)[0]["height_m"], 0.0);
    assert_eq!(json(&assert)[0]["normal"], serde_json::json!([0.0, 1.0, 0.0]));
    assert!(stderr(&assert).contains("five-sample does not move its surface"), "{}", stderr(&assert));
    assert_eq!(stderr(&assert).lines().count(), 1);
}

#[test]
fn texture_coordinates_are_for_seas_that_have_them() {
    let folder = tempfile::tempdir().unwrap();
    for scene in ["meshuggah".to_owned(), drawn_by(folder.path(), "five-sample")] {
        let arguments = ["probe", &scene, "--at", "0,0", "--uv", "0,0", "--json"];
        let assert = whitecap(folder.path()).args(arguments).assert().code(2);
        let sentence = sentence(&assert);
        assert!(sentence.contains("ocean-water and rippling-lake"), "{sentence}");
        assert_eq!(json(&assert)["error"], sentence.as_str());
    }
}

#[test]
fn people_get_a_table() {
    let folder = tempfile::tempdir().unwrap();
    let scene = drawn_by(folder.path(), "rippling-lake");
    let arguments = ["probe", &scene, "--at", "-3,4", "--at", "1,2", "--uv", "0,0"];
    let told = stdout(&whitecap(folder.path()).args(arguments).assert().success());
    assert_eq!(told.lines().count(), 5, "two heads and three rows:\n{told}");
    for words in ["height, m", "normal", "-106.3537", "0.036576"] {
        assert!(told.contains(words), "{words} is missing from:\n{told}");
    }
}

#[test]
fn a_scene_that_is_not_there_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let assert = whitecap(folder.path()).args(["probe", "absent.toml", "--at", "0,0"]).assert().code(2);
    assert!(sentence(&assert).starts_with("absent.toml: "), "{}", stderr(&assert));
}

/// Where the ground calms the waves, the answer is calm too: nothing rides over the island.
#[test]
fn a_shore_calms_what_is_asked_there() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["probe", "ocean-water-shore", "--at=0,0", "--at=900,900", "--time=3.7", "--json"];
    let answer = json(&whitecap(folder.path()).args(arguments).assert().success());
    assert_eq!(answer[0]["height_m"], 0.0);
    assert_ne!(answer[1]["height_m"], 0.0);
}

/// The rows of CSV under the names of its first line.
fn csv(text: &str) -> Vec<std::collections::BTreeMap<String, f64>> {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let values: Vec<f64> = line.split(',').map(|value| value.parse().unwrap()).collect();
        assert_eq!(values.len(), names.len(), "{line}");
        names.iter().map(|&name| name.to_owned()).zip(values).collect()
    };
    lines.map(row).collect()
}

fn told(folder: &Path, arguments: &[&str]) -> String {
    stdout(&whitecap(folder).arg("probe").args(arguments).assert().success())
}

#[test]
fn csv_json_and_the_table_say_the_same() {
    // serde_json reads a number to the last bit but one.
    const ROUNDED: f64 = 1e-14;
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["meshuggah", "--at=-3.25,4", "--grid=-1..1/2,1e3..7/2", "--times=0..2.5/2", "--csv"];
    let text = told(folder.path(), &arguments);
    let head = "x_m,z_m,time_s,height_m,displacement_x_m,displacement_y_m,displacement_z_m,\
                normal_x,normal_y,normal_z,velocity_x_mps,velocity_y_mps,velocity_z_mps";
    assert_eq!(text.lines().next().unwrap(), head);
    let rows = csv(&text);
    let answers = probe(folder.path(), &arguments[..4]);
    let table = told(folder.path(), &arguments[..4]);
    assert_eq!((rows.len(), answers.len(), table.lines().count()), (10, 10, 11));
    for ((row, answer), line) in rows.iter().zip(&answers).zip(table.lines().skip(1)) {
        for key in ["x_m", "z_m", "time_s", "height_m"] {
            near(&[row[key]], &[answer[key].as_f64().unwrap()], ROUNDED);
        }
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            near(
                &[row[&format!("displacement_{name}_m")]],
                &numbers(&answer["displacement_m"])[axis..=axis],
                ROUNDED,
            );
            near(&[row[&format!("normal_{name}")]], &numbers(&answer["normal"])[axis..=axis], ROUNDED);
            near(
                &[row[&format!("velocity_{name}_mps")]],
                &numbers(&answer["velocity_mps"])[axis..=axis],
                ROUNDED,
            );
        }
        let printed: Vec<f64> = line.split_whitespace().map(|word| word.parse().unwrap()).collect();
        let values: Vec<f64> = head.split(',').map(|name| row[name]).collect();
        near(&printed, &values, 6e-4);
    }
    // Moment by moment, --at before the grid, x before z.
    let order: Vec<[f64; 3]> = rows.iter().map(|row| [row["time_s"], row["x_m"], row["z_m"]]).collect();
    let places = [[-3.25, 4.0], [-1.0, 1e3], [1.0, 1e3], [-1.0, 7.0], [1.0, 7.0]];
    let expected: Vec<[f64; 3]> = [0.0, 2.5].iter().flat_map(|&t| places.map(|[x, z]| [t, x, z])).collect();
    assert_eq!(order, expected);
}

#[test]
fn a_series_of_moments_is_each_of_them_alone() {
    let folder = tempfile::tempdir().unwrap();
    let series = probe(folder.path(), &["meshuggah", "--at=3,-8", "--at=0,1", "--times=-2..3/3"]);
    let alone = ["-2", "0.5", "3"]
        .iter()
        .flat_map(|time| probe(folder.path(), &["meshuggah", "--at=3,-8", "--at=0,1", "--time", time]));
    assert_eq!(series, alone.collect::<Vec<_>>());
    let first = probe(folder.path(), &["meshuggah", "--at=3,-8", "--times=-2..3/1"]);
    assert_eq!(first, series[..1]);
}

#[test]
fn places_come_from_a_file_or_from_standard_input() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("track.csv"), "name,z_m,x_m\nbuoy,4,-3\nship,-7,12.5\n").unwrap();
    let expected = probe(folder.path(), &["--at=-3,4", "--at=12.5,-7", "--times=0..1/2"]);
    assert_eq!(probe(folder.path(), &["--points", "track.csv", "--times=0..1/2"]), expected);
    for times in ["--times=0..1/2", "--time=0"] {
        let piped = whitecap(folder.path())
            .args(["probe", "--points", "-", times, "--json"])
            .write_stdin("-3,4\r\n12.5,-7")
            .assert()
            .success();
        let found = json(&piped);
        let found = found.as_array().unwrap();
        assert_eq!(found[..], expected[..found.len()]);
    }
    // What probe writes, it reads: the answers are places again.
    let arguments = ["--points", "track.csv", "--csv", "-o", "once.csv"];
    assert_eq!(told(folder.path(), &arguments), "");
    let once = std::fs::read_to_string(folder.path().join("once.csv")).unwrap();
    assert_eq!(told(folder.path(), &["--points", "once.csv", "--csv"]), once);
    assert_eq!(csv(&once).len(), 2);
}

#[test]
fn a_bad_line_is_refused_by_its_number_and_nothing_is_left_half() {
    let folder = tempfile::tempdir().unwrap();
    for (text, expected) in [
        ("1,2\n3\n", "bad.csv, line 2: column 2 (z_m) is missing"),
        ("x_m,z_m\n1,2\n3,NaN\n", "bad.csv, line 3: column 2 (z_m) is \"NaN\""),
        ("inf,2\n", "bad.csv, line 1: column 1 (x_m) is \"inf\""),
        ("1,2\n1,10000001\n", "accepted: metres from -10000000 to 10000000"),
    ] {
        std::fs::write(folder.path().join("bad.csv"), text).unwrap();
        let arguments = ["probe", "five-sample", "--points", "bad.csv"];
        for more in [&["--csv"][..], &["--times=0..1/2", "--csv"], &["-o", "out.json"]] {
            let assert = whitecap(folder.path()).args(arguments).args(more).assert().code(2);
            assert!(sentence(&assert).contains(expected), "{}", stderr(&assert));
        }
        assert_eq!(crate::names_in(folder.path()), ["bad.csv"]);
        // A list ends whole, with the reason as its last entry where it had begun.
        let assert = whitecap(folder.path()).args(arguments).arg("--json").assert().code(2);
        let list = json(&assert);
        let last = list.as_array().unwrap().last().unwrap();
        assert_eq!(last["error"], sentence(&assert).as_str());
    }
    for (file, code, expected) in [("absent.csv", 2, "absent.csv: cannot be read"), (".", 2, "is a folder")] {
        let assert = whitecap(folder.path()).args(["probe", "--points", file]).assert().code(code);
        assert!(sentence(&assert).contains(expected), "{}", stderr(&assert));
    }
}

#[test]
fn a_file_is_written_whole_in_the_format_that_its_name_says() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["five-sample", "--grid=0..1/2,0..1/2"];
    for (name, option) in [("a.csv", "--csv"), ("a.json", "--json")] {
        assert_eq!(told(folder.path(), &[&arguments[..], &["-o", name]].concat()), "");
        let written = std::fs::read_to_string(folder.path().join(name)).unwrap();
        assert_eq!(written, told(folder.path(), &[&arguments[..], &[option]].concat()));
    }
    assert_eq!(told(folder.path(), &[&arguments[..], &["-o", "a.csv", "--json"]].concat()), "");
    assert!(std::fs::read_to_string(folder.path().join("a.csv")).unwrap().starts_with("[\n  {"));
    let assert = whitecap(folder.path()).args(["probe", "--at=0,0", "-o", "absent/a.csv"]).assert().code(2);
    assert!(sentence(&assert).contains("the folder absent does not exist"), "{}", stderr(&assert));
}

#[test]
fn a_name_that_says_no_format_is_refused_before_any_work() {
    let folder = tempfile::tempdir().unwrap();
    let scene = drawn_by(folder.path(), "ocean-water");
    let left = crate::names_in(folder.path());
    for (place, name, expected) in [
        (
            "--at=0,0",
            "sea.xyz",
            "the name sea.xyz says no format; accepted: a file name that ends in .csv, .json or .txt",
        ),
        ("--at=0,0", "csv", "the name csv says no format"),
        (
            "--uv=0,0",
            "sea.csv",
            "accepted: a file name that ends in .json or .txt with --uv, or any with --json",
        ),
    ] {
        let assert = whitecap(folder.path()).args(["probe", &scene, place, "-o", name]).assert().code(2);
        assert!(sentence(&assert).contains(expected), "{}", stderr(&assert));
        assert_eq!(crate::names_in(folder.path()), left);
    }
    // An option says it for any name, and a table for people has an ending of its own.
    for (name, more, begins) in [("sea.xyz", &["--csv"][..], "x_m,"), ("sea.TXT", &[], "        x, m")] {
        told(folder.path(), &[&[&scene, "--at=0,0", "-o", name], more].concat());
        assert!(std::fs::read_to_string(folder.path().join(name)).unwrap().starts_with(begins));
    }
}

/// Whoever ends a long run finds no half file, hidden or not, and sees that it was the signal.
#[cfg(unix)]
#[test]
fn a_run_that_is_told_to_end_leaves_nothing() {
    use std::os::unix::process::ExitStatusExt;
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};
    for (name, number) in [("INT", 2), ("TERM", 15)] {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("sea.csv"), "old").unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_whitecap"))
            .args(["probe", "five-sample", "--grid=0..9/30000,0..9/30000", "-o", "sea.csv"])
            .current_dir(folder.path())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let half = || {
            let entries = std::fs::read_dir(folder.path()).unwrap().flatten();
            entries.filter_map(|entry| entry.metadata().ok()).any(|about| about.len() > 1000)
        };
        let started = Instant::now();
        while !half() {
            assert!(started.elapsed() < Duration::from_secs(60), "no rows are written");
            std::thread::sleep(Duration::from_millis(5));
        }
        Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status().unwrap();
        assert_eq!(child.wait().unwrap().signal(), Some(number));
        assert_eq!(crate::names_in(folder.path()), ["sea.csv"]);
        assert_eq!(std::fs::read_to_string(folder.path().join("sea.csv")).unwrap(), "old");
    }
}

#[test]
fn absurd_numbers_of_rows_are_refused_before_any_work() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [
        &["--grid=0..1/40000,0..1/40000"][..],
        &["--grid=0..1/18446744073709551615,0..1/2"],
        &["--at=0,0", "--times=0..1/1000000001"],
    ] {
        let assert = whitecap(folder.path()).arg("probe").args(arguments).assert().code(2);
        assert!(sentence(&assert).contains("the 1000000000 rows"), "{}", stderr(&assert));
    }
}

/// A hundred million rows would take minutes and gigabytes; one of them is there at once.
#[cfg(target_os = "linux")]
#[test]
fn rows_stream_and_a_closed_pipe_ends_them_quietly() {
    use std::io::{BufRead, BufReader, Read};
    use std::process::{Command, Stdio};
    for format in ["--csv", "--json"] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_whitecap"))
            .args(["probe", "five-sample", "--grid=0..9/10000,0..9/10000", format])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut rows = BufReader::new(child.stdout.take().unwrap());
        let resident_kib = |id: u32| -> u64 {
            let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap();
            let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap().to_owned();
            line.trim().trim_end_matches(" kB").parse().unwrap()
        };
        let mut line = String::new();
        let mut early_kib = 0;
        for i in 0..200_000 {
            line.clear();
            rows.read_line(&mut line).unwrap();
            assert!(line.len() > 1, "row {i}: {line:?}");
            early_kib = if i == 20_000 { resident_kib(child.id()) } else { early_kib };
        }
        let grown_kib = resident_kib(child.id()).saturating_sub(early_kib);
        assert!(grown_kib < 4096, "{format}: {grown_kib} KiB more for 180000 rows");
        drop(rows);
        assert_eq!(child.wait().unwrap().code(), Some(0));
        let mut told = String::new();
        child.stderr.take().unwrap().read_to_string(&mut told).unwrap();
        assert!(told.lines().all(|line| line.starts_with("note: ")), "{told}");
    }
}

/// Somebody who asks and waits for each answer gets it before asking again.
#[test]
fn standard_input_is_answered_line_by_line() {
    use std::io::{BufRead, BufReader, Write};
    use std::process::{Command, Stdio};
    let mut child = Command::new(env!("CARGO_BIN_EXE_whitecap"))
        .args(["probe", "five-sample", "--points", "-", "--csv"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut places = child.stdin.take().unwrap();
    let mut rows = BufReader::new(child.stdout.take().unwrap()).lines();
    for i in 0..3 {
        writeln!(places, "{i},7").unwrap();
        if i == 0 {
            assert!(rows.next().unwrap().unwrap().starts_with("x_m,z_m"));
        }
        assert!(rows.next().unwrap().unwrap().starts_with(&format!("{i}.0,7.0,0.0,0.0,")));
    }
    drop(places);
    assert!(rows.next().is_none());
    assert!(child.wait().unwrap().success());
}

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
        let mut expected = ["x_m", "z_m", "time_s", "height_m", "displacement_m", "normal"];
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
    near(&displacement_m, &point.displacement_m.to_array(), 1e-3);
    near(&numbers(&answers[0]["normal"]), &point.normal.to_array(), 1e-3);
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

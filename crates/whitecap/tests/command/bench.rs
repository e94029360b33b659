//! `bench`: times of passes, in small frames.

use crate::{has_adapter, json, names_in, sentence, stderr, stdout, whitecap};

#[test]
fn programs_get_every_pass_and_the_sum() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("pond.toml"),
        stdout(&whitecap(folder.path()).args(["scenes", "meshuggah"]).assert().success()),
    )
    .unwrap();
    let arguments = ["bench", "pond.toml", "meshuggah", "--size", "32x18", "--runs", "2", "--json"];
    let frames = json(&whitecap(folder.path()).args(arguments).assert().success());
    let frames = frames.as_array().unwrap();
    let scenes: Vec<&str> = frames.iter().map(|frame| frame["scene"].as_str().unwrap()).collect();
    assert_eq!(scenes, ["pond.toml", "meshuggah"]);
    for frame in frames {
        assert_eq!(frame["technique"], "meshuggah");
        assert_eq!((&frame["width"], &frame["height"], &frame["runs"]), (&32.into(), &18.into(), &2.into()));
        assert!(frame["adapter"]["name"].is_string());
        let passes = frame["passes"].as_array().unwrap();
        let names: Vec<&str> = passes.iter().map(|pass| pass["name"].as_str().unwrap()).collect();
        assert!(names.contains(&"water") && names.contains(&"sky"), "{names:?}");
        let sum: f64 = passes.iter().map(|pass| pass["ms"].as_f64().unwrap()).sum();
        assert!(sum > 0.0 && (sum - frame["sum_ms"].as_f64().unwrap()).abs() < 1e-2, "{frame}");
    }
    assert_eq!(names_in(folder.path()), ["pond.toml"]);
}

#[test]
fn without_a_scene_each_techniques_own_is_timed() {
    if !has_adapter() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["bench", "--size", "16x9", "--runs", "1"];
    let told = stdout(&whitecap(folder.path()).args(arguments).assert().success());
    let timed: Vec<&str> = told.lines().skip(1).filter(|line| !line.starts_with(' ')).collect();
    let words = whitecap_scene::technique::ALL.iter().map(|technique| technique.word);
    let own: Vec<&str> = words.filter(|word| whitecap_scene::named::find(word).is_some()).collect();
    assert_eq!(timed, own);
    assert_eq!(told.matches("  sum ").count(), own.len(), "{told}");
    assert!(told.starts_with("16 × 9 pixels, median of 1, on "), "{told}");
}

#[test]
fn a_scene_with_a_mistake_is_found_before_anything_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["bench", "meshuggah", "absent.toml", "--adapter", "none is asked"];
    let assert = whitecap(folder.path()).args(arguments).assert().code(2);
    assert!(sentence(&assert).starts_with("absent.toml: "), "{}", stderr(&assert));
}

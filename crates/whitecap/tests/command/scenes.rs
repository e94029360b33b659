//! `scenes` and `check`: no adapter needed.

use crate::{json, sentence, stderr, stdout, whitecap};

#[test]
fn the_list_of_scenes_names_each_and_marks_the_default() {
    let folder = tempfile::tempdir().unwrap();
    let list = stdout(&whitecap(folder.path()).arg("scenes").assert().success());
    let entries = json(&whitecap(folder.path()).args(["scenes", "--json"]).assert().success());
    let entries = entries.as_array().unwrap();
    assert_eq!(list.lines().count(), entries.len());
    assert_eq!(list.matches("(the default)").count(), 1);
    for entry in entries {
        for key in ["name", "title", "technique"] {
            assert!(entry[key].as_str().is_some_and(|word| !word.is_empty()), "{entry}");
        }
        assert!(list.contains(entry["name"].as_str().unwrap()));
    }
}

#[test]
fn a_scene_that_is_printed_is_a_scene_file() {
    let folder = tempfile::tempdir().unwrap();
    let entries = json(&whitecap(folder.path()).args(["scenes", "--json"]).assert().success());
    for entry in entries.as_array().unwrap() {
        let name = entry["name"].as_str().unwrap();
        let toml = stdout(&whitecap(folder.path()).args(["scenes", name]).assert().success());
        std::fs::write(folder.path().join("copy.toml"), &toml).unwrap();
        whitecap(folder.path()).args(["check", "copy.toml"]).assert().success();

        let in_json = json(&whitecap(folder.path()).args(["scenes", name, "--json"]).assert().success());
        assert_eq!(in_json["toml"], toml);
    }
}

#[test]
fn a_mistake_is_told_with_file_line_key_and_what_is_accepted() {
    let folder = tempfile::tempdir().unwrap();
    let toml = stdout(&whitecap(folder.path()).args(["scenes", "meshuggah"]).assert().success());
    let line = 1 + toml.lines().position(|line| line.starts_with("wind_speed_mps")).unwrap();
    let mut lines: Vec<&str> = toml.lines().collect();
    lines[line - 1] = "wind_speed_mps = -3.0";
    std::fs::write(folder.path().join("storm.toml"), lines.join("\n")).unwrap();

    // `render` says the same, before it looks for an adapter.
    for verb in ["check", "render"] {
        let assert = whitecap(folder.path()).args([verb, "storm.toml"]).assert().code(2);
        let sentence = sentence(&assert);
        assert!(sentence.starts_with(&format!("storm.toml:{line}")), "{sentence}");
        for words in ["wind_speed_mps", "-3.0", "accepted"] {
            assert!(sentence.contains(words), "{words} is missing from: {sentence}");
        }
    }
}

#[test]
fn one_bad_scene_among_good_ones_fails_the_check_and_all_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["check", "meshuggah", "absent.toml", "meshuggah"];
    let assert = whitecap(folder.path()).args(arguments).assert().code(2);
    assert_eq!(stdout(&assert), "meshuggah: ok\nmeshuggah: ok\n");
    assert!(sentence(&assert).starts_with("absent.toml: "), "{}", stderr(&assert));

    let verdicts = json(&whitecap(folder.path()).args(arguments).arg("--json").assert().code(2));
    let ok: Vec<_> = verdicts.as_array().unwrap().iter().map(|v| v["ok"].as_bool().unwrap()).collect();
    assert_eq!(ok, [true, false, true]);
    assert!(verdicts[1]["error"].as_str().unwrap().starts_with("absent.toml: "));
    assert!(verdicts[0].get("error").is_none());
}

#[test]
fn files_that_are_no_scenes_are_refused_in_one_sentence() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    file("empty.toml", b"");
    file("noise.toml", &[0xff, 0xfe, 0x00, 0x80]);
    file("prose.toml", b"Call me Ishmael.");
    file("unknown.toml", b"colour = \"blue\"\n");
    std::fs::create_dir(folder.path().join("folder.toml")).unwrap();
    for name in ["noise.toml", "prose.toml", "unknown.toml", "folder.toml", "absent.toml", "absent"] {
        let assert = whitecap(folder.path()).args(["check", name]).assert().code(2);
        assert!(sentence(&assert).starts_with(name), "{}", stderr(&assert));
    }
    // Whether nothing at all is a scene is for the scene reader to say; it must not be a crash.
    let empty = whitecap(folder.path()).args(["check", "empty.toml"]).assert();
    assert!(matches!(empty.get_output().status.code(), Some(0 | 2)));
}

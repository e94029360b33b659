//! A machine without any graphics driver.

use crate::{json, names_in, sentence, stdout, whitecap};
use std::path::Path;

/// The command on a machine whose drivers are out of sight. Metal and Direct3D cannot be hidden.
fn whitecap_without_drivers(folder: &Path) -> assert_cmd::Command {
    let mut command = whitecap(folder);
    for variable in
        ["VK_DRIVER_FILES", "VK_ICD_FILENAMES", "__EGL_VENDOR_LIBRARY_FILENAMES", "LIBGL_DRIVERS_PATH"]
    {
        command.env(variable, "/nonexistent");
    }
    command
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_driver_the_sentence_says_what_to_install() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("sea.png"), "old").unwrap();
    let render = whitecap_without_drivers(folder.path()).args(["render", "-o", "sea.png"]).assert().code(1);
    let adapters = whitecap_without_drivers(folder.path()).arg("adapters").assert().code(1);
    let gallery = whitecap_without_drivers(folder.path()).args(["gallery", "-o", "new"]).assert().code(1);
    let bench = whitecap_without_drivers(folder.path()).arg("bench").assert().code(1);
    for assert in [&render, &adapters, &gallery, &bench] {
        let sentence = sentence(assert);
        assert!(sentence.starts_with("no graphics adapter found"), "{sentence}");
        assert!(sentence.contains("apt-get install libvulkan1 mesa-vulkan-drivers"), "{sentence}");
        assert_eq!(stdout(assert), "");
    }
    assert_eq!(std::fs::read(folder.path().join("sea.png")).unwrap(), b"old");
    assert_eq!(names_in(folder.path()), ["sea.png"]);
}

#[cfg(target_os = "linux")]
#[test]
fn programs_learn_it_as_an_error_and_as_an_empty_list() {
    let folder = tempfile::tempdir().unwrap();
    let render = whitecap_without_drivers(folder.path()).args(["render", "--json"]).assert().code(1);
    assert!(json(&render)["error"].as_str().unwrap().starts_with("no graphics adapter found"));
    let adapters = whitecap_without_drivers(folder.path()).args(["adapters", "--json"]).assert().code(1);
    assert_eq!(json(&adapters), serde_json::json!([]));
}

#[test]
fn scenes_are_listed_checked_and_probed_all_the_same() {
    let folder = tempfile::tempdir().unwrap();
    whitecap_without_drivers(folder.path()).arg("scenes").assert().success();
    whitecap_without_drivers(folder.path()).args(["check", "meshuggah"]).assert().success();
    whitecap_without_drivers(folder.path()).args(["probe", "--at", "0,0"]).assert().success();
}

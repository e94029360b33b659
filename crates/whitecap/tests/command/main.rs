//! The `whitecap` command from outside: what goes in, what comes out, and with which exit code.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

mod bake;
mod bench;
mod docs;
mod gallery;
mod no_adapter;
mod probe;
mod render;
mod scenes;
mod sequence;
mod spectrum;
mod usage;

use assert_cmd::Command;
use assert_cmd::assert::Assert;
use std::io::Write;
use std::path::Path;

/// The command, started in `folder`.
fn whitecap(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_whitecap"));
    command.current_dir(folder);
    command
}

fn stdout(assert: &Assert) -> String {
    String::from_utf8(assert.get_output().stdout.clone()).expect("standard output is text")
}

fn stderr(assert: &Assert) -> String {
    String::from_utf8(assert.get_output().stderr.clone()).expect("standard error is text")
}

/// The one sentence that the command stopped with. Drivers, too, write to standard error.
fn sentence(assert: &Assert) -> String {
    let stderr = stderr(assert);
    let ours: Vec<&str> = stderr.lines().filter_map(|line| line.strip_prefix("whitecap: ")).collect();
    assert_eq!(ours.len(), 1, "one sentence was expected:\n{stderr}");
    ours[0].to_owned()
}

fn json(assert: &Assert) -> serde_json::Value {
    serde_json::from_slice(&assert.get_output().stdout).expect("standard output is one JSON document")
}

/// Kills a process at a moment that `i` chooses: an odd one in the first `seconds`, an even one soon after `count` of its
/// files has grown.
fn kill_at_any_moment(child: &mut std::process::Child, i: u32, seconds: f64, count: impl Fn() -> usize) {
    use std::time::Duration;
    // Fractions of the golden ratio fill a time evenly and never come back to a moment.
    let part = (f64::from(i) * 0.618_033_988_75).fract();
    if i.is_multiple_of(2) {
        let before = count();
        while count() == before && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_secs_f64(0.03 * seconds * part));
    } else {
        std::thread::sleep(Duration::from_secs_f64(seconds * part));
    }
    child.kill().unwrap();
    child.wait().unwrap();
}

/// What is in `folder`, hidden files too.
fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Names and bytes of all files in `folder`.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    names_in(folder)
        .into_iter()
        .map(|name| (name.clone(), std::fs::read(folder.join(name)).unwrap()))
        .collect()
}

/// Whether there is an adapter to draw with. Says loudly that the test is skipped where there is none, and
/// fails where one is required.
fn has_adapter() -> bool {
    let folder = tempfile::tempdir().unwrap();
    let adapters = json(&whitecap(folder.path()).args(["adapters", "--json"]).assert());
    let found = adapters.as_array().is_some_and(|list| list.iter().any(|a| a["webgpu_compliant"] == true));
    if !found {
        let required = std::env::var_os("WHITECAP_REQUIRE_ADAPTER").is_some();
        assert!(!required, "WHITECAP_REQUIRE_ADAPTER is set, and this machine has no WebGPU adapter");
        // Past libtest's capture, which would hide it.
        let reason =
            "SKIPPED a test that draws: this machine has no WebGPU adapter; `cargo xtask setup` installs one";
        let _ = writeln!(std::io::stderr(), "{reason}");
    }
    found
}

fn size_of(picture: &Path) -> (u32, u32) {
    let picture = image::open(picture).expect("the picture is a whole PNG");
    (picture.width(), picture.height())
}

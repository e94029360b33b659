//! What the documentation says is so: its commands run, its paths exist, its versions are the ones in use.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use whitecap_scene::Scene;
use whitecap_tests::repository::{Page, pages, root};

/// Commands that the README may show and this test does not run, and why.
const NOT_RUN: &[(&str, &str)] = &[
    ("cargo xtask test", "it is what runs this test"),
    ("cargo xtask bench", "it takes minutes and asserts nothing"),
    ("cargo xtask goldens", "it would replace what is tested"),
    ("cargo install ", "it would change the user's machine"),
    ("git clone ", "we are in the clone"),
    ("cd ", "we are in the clone"),
    ("sudo ", "it would change the user's machine"),
];

/// Names of crates that are also words, before which a number means nothing.
const WORDS: &[&str] = &["half", "image"];

fn readme() -> Page {
    pages().unwrap().into_iter().find(|page| page.path.ends_with("README.md")).unwrap()
}

fn toml_file(path: &str) -> toml::Table {
    std::fs::read_to_string(root().join(path)).unwrap().parse().unwrap()
}

/// The commands in the README's shell blocks, one a line, with continued lines joined.
fn commands() -> Vec<String> {
    let blocks = readme().blocks("sh").join("\n").replace("\\\n", " ");
    let lines = blocks.lines().map(|line| line.split(" #").next().unwrap_or_default().trim());
    lines.filter(|line| !line.is_empty() && !line.starts_with('#')).map(str::to_owned).collect()
}

/// One test for all of them: two cargos at once would wait for each other.
#[test]
fn the_commands_in_the_readme_run_and_leave_nothing_behind() {
    let commands = commands();
    for expected in ["cargo xtask demo", "cargo xtask test", "cargo run --release -- "] {
        assert!(commands.iter().any(|c| c.starts_with(expected)), "the README does not show `{expected}`");
    }
    let before = names_in_root();
    for command in commands {
        if NOT_RUN.iter().any(|(start, _)| command.starts_with(start)) {
            continue;
        }
        let output = shell(&command).output().unwrap();
        assert!(
            output.status.success(),
            "`{command}` failed ({}):\n{}\n{}",
            output.status,
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr)
        );
    }
    let left: Vec<_> = names_in_root().difference(&before).cloned().collect();
    assert!(left.is_empty(), "the README's commands left {left:?} in the repository; use out/");
}

fn names_in_root() -> BTreeSet<String> {
    let entries = root().read_dir().unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name != "out" && name != "target").collect()
}

/// A shell in the repository, without what cargo told this very test about itself.
fn shell(command: &str) -> Command {
    let mut shell = Command::new("sh");
    shell.args(["-ec", command]).current_dir(root());
    for (name, _) in std::env::vars_os() {
        let name = name.to_string_lossy().into_owned();
        let about_this_test =
            ["CARGO_PKG_", "CARGO_MANIFEST_", "CARGO_BIN_", "CARGO_CRATE_", "CARGO_PRIMARY_"];
        if about_this_test.iter().any(|start| name.starts_with(start)) {
            shell.env_remove(&name);
        }
    }
    shell
}

#[test]
fn links_and_pictures_point_to_files_that_exist() {
    for page in pages().unwrap() {
        for target in page.targets() {
            let elsewhere = ["http:", "https:", "mailto:", "#"].iter().any(|start| target.starts_with(start));
            if elsewhere {
                continue;
            }
            let file = target.split('#').next().unwrap_or_default();
            let path = page.path.with_file_name(file);
            assert!(path.exists(), "{} points to {target}, which does not exist", page.path.display());
        }
    }
}

#[test]
fn paths_that_are_named_exist() {
    let tops: Vec<PathBuf> = root().read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    for page in pages().unwrap() {
        for span in page.code_spans().into_iter().filter(|span| is_path(span, &tops)) {
            let file = span.split(':').next().unwrap_or_default();
            assert!(
                root().join(file).exists(),
                "{} speaks of {span}, which does not exist",
                page.path.display()
            );
        }
    }
}

/// Whether `span` names a file from the repository's root: it begins with something that is there, and has
/// no blanks and no placeholders such as `<name>` or `NAME`.
fn is_path(span: &str, tops: &[PathBuf]) -> bool {
    let Some((top, _)) = span.split_once('/') else { return false };
    let made = ["out", "target"];
    let plain =
        !span.contains(|c: char| c.is_whitespace() || "*<>{}$…|".contains(c)) && !span.contains("NAME");
    plain && !made.contains(&top) && tops.iter().any(|path| path.file_name().is_some_and(|name| name == top))
}

/// The numbers that follow `name` in `text`, such as `30.0` in "on wgpu 30.0.": with a point, since a bare
/// number after a word is seldom a version.
fn versions_after<'t>(text: &'t str, name: &str) -> Vec<&'t str> {
    let begins_a_word = |at: usize| {
        !text[..at].ends_with(|before: char| before.is_alphanumeric() || matches!(before, '-' | '_' | '/'))
    };
    text.match_indices(name)
        .filter(|(at, _)| begins_a_word(*at))
        .filter_map(|(at, _)| {
            let rest = text[at + name.len()..].strip_prefix(['`', ' '])?.trim_start_matches(['`', ' ', 'v']);
            let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
            let version = rest[..end].trim_end_matches('.');
            version.contains('.').then_some(version)
        })
        .collect()
}

/// Whether `found` is `named`, as precisely as that is named: 30.0.1 is a 30.0, and 30.01 is not.
fn is_version(named: &str, found: &str) -> bool {
    found.strip_prefix(named).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

#[test]
fn versions_that_are_named_are_those_in_the_lock_file() {
    let lock = toml_file("Cargo.lock");
    let workspace = toml_file("Cargo.toml");
    let used = workspace["workspace"]["dependencies"].as_table().unwrap();
    let pages = pages().unwrap();
    for name in used.keys().filter(|name| !WORDS.contains(&name.as_str())) {
        let locked: Vec<&str> = lock["package"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|package| package["name"].as_str() == Some(name))
            .filter_map(|package| package["version"].as_str())
            .collect();
        for page in &pages {
            for version in versions_after(&page.text, name) {
                assert!(
                    locked.iter().any(|locked| is_version(version, locked)),
                    "{} says {name} {version}; the lock file says {locked:?}",
                    page.path.display()
                );
            }
        }
    }
}

#[test]
fn the_rust_that_is_asked_for_is_the_one_in_the_manifest() {
    let manifest = toml_file("Cargo.toml");
    let rust_version = manifest["workspace"]["package"]["rust-version"].as_str().unwrap();
    assert!(!versions_after(&readme().text, "Rust").is_empty(), "the README names no Rust version");
    for page in pages().unwrap() {
        for name in ["Rust", "rustc"] {
            for version in versions_after(&page.text, name) {
                assert_eq!(version, rust_version, "{} says {name} {version}", page.path.display());
            }
        }
    }
}

#[test]
fn scene_files_that_are_shown_can_be_used() {
    for page in pages().unwrap() {
        for block in page.blocks("toml").iter().filter(|block| block.contains("technique =")) {
            if let Err(error) = Scene::from_toml(block, "the scene shown") {
                panic!("{}: {error}\n{block}", page.path.display());
            }
        }
    }
}

#[test]
fn both_licences_are_there() {
    for name in ["LICENSE-MIT", "LICENSE-APACHE"] {
        assert!(root().join(name).metadata().is_ok_and(|file| file.len() > 1000), "{name}");
    }
}

#[test]
fn versions_are_read_out_of_prose() {
    let text = "on wgpu 30.0.1, not `wgpu` 29.0 nor egui-wgpu 0.37; wgpu 30 and `wgpu 30.0`. Rust 1.95.";
    assert_eq!(versions_after(text, "wgpu"), ["30.0.1", "29.0", "30.0"]);
    assert_eq!(versions_after(text, "Rust"), ["1.95"]);
    assert!(is_version("30.0", "30.0.1") && is_version("30.0.1", "30.0.1"));
    assert!(!is_version("30.0", "30.01.0") && !is_version("29.0", "30.0.1"));
}

#[test]
fn paths_are_told_from_other_code() {
    let tops = [Path::new("/r/docs").to_owned(), Path::new("/r/out").to_owned()];
    assert!(is_path("docs/architecture.md", &tops));
    for other in ["docs", "S(f)/2", "out/sea.png", "docs/NAME.md", "docs/<topic>.md", "docs/*.md", "a docs/b"]
    {
        assert!(!is_path(other, &tops), "{other}");
    }
}

//! Help, manual, completions, and arguments that are wrong.

use crate::{json, names_in, sentence, stderr, stdout, whitecap};

const VERBS: [&str; 12] = [
    "render",
    "view",
    "gallery",
    "bake",
    "probe",
    "spectrum",
    "bench",
    "check",
    "scenes",
    "adapters",
    "completions",
    "man",
];

#[test]
fn every_verb_is_listed_and_explains_itself_with_an_example() {
    let folder = tempfile::tempdir().unwrap();
    let overview = stdout(&whitecap(folder.path()).arg("--help").assert().success());
    for verb in VERBS {
        assert!(overview.contains(&format!("\n  {verb} ")), "{verb} is missing from:\n{overview}");
        let help = stdout(&whitecap(folder.path()).args([verb, "--help"]).assert().success());
        assert!(help.contains(&format!("Usage: whitecap {verb}")), "{help}");
        assert!(help.contains(&format!("Examples:\n  whitecap {verb}")), "{help}");
    }
    let listed = overview.lines().skip_while(|line| *line != "Commands:").skip(1);
    let listed = listed.take_while(|line| !line.is_empty()).count();
    assert_eq!(listed, VERBS.len() + 1, "a verb without a test, or gone:\n{overview}");
}

#[test]
fn help_says_what_is_taken_by_default() {
    let folder = tempfile::tempdir().unwrap();
    let help = stdout(&whitecap(folder.path()).args(["render", "--help"]).assert().success());
    for default in ["[default: spectral-ocean]", "[default: 1280x720]", "[default: 0]", "current folder"] {
        assert!(help.contains(default), "{default} is missing from:\n{help}");
    }
}

#[test]
fn the_version_is_the_package_version() {
    let folder = tempfile::tempdir().unwrap();
    let version = stdout(&whitecap(folder.path()).arg("--version").assert().success());
    assert_eq!(version.trim(), format!("whitecap {}", env!("CARGO_PKG_VERSION")));
}

#[test]
fn wrong_arguments_are_refused_with_what_was_found_and_what_is_accepted() {
    let folder = tempfile::tempdir().unwrap();
    let cases: &[(&[&str], &[&str])] = &[
        (&[], &["Usage: whitecap"]),
        (&["rendr"], &["'rendr'", "'render'"]),
        (&["render", "--sise", "1x1"], &["'--sise'", "'--size'"]),
        (&["render", "meshuggah", "another"], &["'another'"]),
        (&["render", "--size", "0x0"], &["'0x0'", "1280x720"]),
        (&["render", "--size", "-5x5"], &["'-5x5'", "1280x720"]),
        (&["render", "--size", "1280"], &["'1280'", "1280x720"]),
        (&["render", "--size", "4294967296x1"], &["'4294967296x1'", "1280x720"]),
        (&["render", "--time", "NaN"], &["'NaN'", "-1000000 to 1000000"]),
        (&["render", "--time", "-inf"], &["'-inf'", "-1000000 to 1000000"]),
        (&["render", "--time", "1000000.1"], &["'1000000.1'", "-1000000 to 1000000"]),
        (&["render", "--seed", "-1"], &["-1"]),
        (&["render", "--seed", "9223372036854775808"], &["9223372036854775808", "9223372036854775807"]),
        (&["render", "-o", "sea.jpg"], &["'sea.jpg'", ".png or .exr"]),
        (&["render", "--samples", "0"], &["0 is not in 1..=1024"]),
        (&["render", "--samples", "1025"], &["1025 is not in 1..=1024"]),
        (&["render", "--samples", "99999999999"], &["99999999999", "1..=1024"]),
        (&["render", "--samples", "4.5"], &["'4.5'"]),
        (&["render", "-o", ""], &["--output", "value is required"]),
        (&["gallery"], &["--output <DIR>"]),
        (&["gallery", "-o", "x", "meshugah"], &["'meshugah'", "meshuggah"]),
        (&["gallery", "-o", "x", "--runs", "1001"], &["1001", "0..=1000"]),
        (&["bench", "--runs", "0"], &["0 is not in 1..=1000"]),
        (&["bench", "--size", "0x1"], &["'0x1'", "1280x720"]),
        (&["probe"], &["--at <X,Z>"]),
        (&["probe", "--at", "1"], &["'1'", "12.5,-3"]),
        (&["probe", "--at", "NaN,0"], &["'NaN,0'", "-10000000 to 10000000"]),
        (&["probe", "--at=0,10000001"], &["'0,10000001'", "-10000000 to 10000000"]),
        (&["probe", "--uv", "0.3 0.7"], &["'0.3 0.7'", "0.3,0.7"]),
        (&["probe", "--at", "0,0", "--time", "1000000.1"], &["'1000000.1'", "-1000000 to 1000000"]),
        (&["probe", "--at", "0,0", "--seed", "-1"], &["-1"]),
        (&["probe", "--grid", "0..1/2"], &["'0..1/2'", "-50..50/101,0..20/21"]),
        (&["probe", "--grid", "0..NaN/2,0..1/2"], &["'0..NaN/2,0..1/2'", "-10000000 to 10000000"]),
        (&["probe", "--at", "0,0", "--times", "0..1/0"], &["'0..1/0'", "0..60/601"]),
        (&["probe", "--at", "0,0", "--times", "0..1/2", "--time", "1"], &["--times", "cannot be used with"]),
        (&["probe", "--at", "0,0", "--csv", "--uv", "0,0"], &["--csv", "cannot be used with"]),
        (&["spectrum", "-o", "sea.pdf"], &["'sea.pdf'", ".svg or .png"]),
        (&["spectrum", "-o", "svg"], &["'svg'", ".svg or .png"]),
        (&["spectrum", "--time", "NaN"], &["'NaN'", "-1000000 to 1000000"]),
        (&["check"], &["<SCENE>"]),
        (&["scenes", "meshugah"], &["'meshugah'", "meshuggah"]),
        (&["completions", "cobol"], &["'cobol'", "bash", "fish", "zsh"]),
    ];
    for (arguments, expected) in cases {
        let assert = whitecap(folder.path()).args(*arguments).assert().code(2);
        let message = stderr(&assert);
        for words in *expected {
            assert!(message.contains(words), "{arguments:?} does not say {words:?}:\n{message}");
        }
        assert_eq!(stdout(&assert), "", "{arguments:?}");
    }
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn programs_get_wrong_arguments_as_json_too() {
    let folder = tempfile::tempdir().unwrap();
    let assert = whitecap(folder.path()).args(["render", "--size", "0x0", "--json"]).assert().code(2);
    let error = json(&assert)["error"].as_str().unwrap().to_owned();
    assert!(error.starts_with("invalid value '0x0'"), "{error}");
}

#[test]
fn completions_know_the_verbs_in_every_shell() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = stdout(&whitecap(folder.path()).args(["completions", shell]).assert().success());
        for verb in VERBS {
            assert!(script.contains(verb), "{shell} does not complete {verb}");
        }
        assert!(script.contains("--adapter") || script.contains("adapter"), "{shell}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn bash_accepts_its_completions() {
    let folder = tempfile::tempdir().unwrap();
    let script = stdout(&whitecap(folder.path()).args(["completions", "bash"]).assert().success());
    let checked = assert_cmd::Command::new("bash").arg("-n").write_stdin(script).output().unwrap();
    assert!(checked.status.success(), "{}", String::from_utf8_lossy(&checked.stderr));
}

#[test]
fn there_is_a_manual_page_for_the_command_and_for_each_verb() {
    let folder = tempfile::tempdir().unwrap();
    let all = stdout(&whitecap(folder.path()).arg("man").assert().success());
    let written = whitecap(folder.path()).args(["man", "-o", "."]).assert().success();

    let mut expected: Vec<String> = VERBS.iter().map(|verb| format!("whitecap-{verb}.1")).collect();
    expected.push("whitecap.1".into());
    expected.sort();
    assert_eq!(names_in(folder.path()), expected);
    assert_eq!(stdout(&written).lines().count(), expected.len());
    for name in expected {
        let page = std::fs::read_to_string(folder.path().join(&name)).unwrap();
        let title = format!(".TH {} 1 ", name.trim_end_matches(".1"));
        assert!(page.contains(&title), "{name}:\n{page}");
        assert!(all.contains(&page), "{name} is not among the pages on standard output");
    }
}

#[test]
fn manual_pages_go_only_into_a_folder_that_exists() {
    let folder = tempfile::tempdir().unwrap();
    let absent = whitecap(folder.path()).args(["man", "-o", "absent"]).assert().code(2);
    assert!(sentence(&absent).contains("the folder absent does not exist"), "{}", stderr(&absent));

    std::fs::write(folder.path().join("file"), "").unwrap();
    let file = whitecap(folder.path()).args(["man", "-o", "file"]).assert().code(2);
    assert!(sentence(&file).contains("file is a file"), "{}", stderr(&file));
    assert_eq!(names_in(folder.path()), ["file"]);
}

/// Starts the command with a standard output that `shell` has prepared, and gives its exit code.
#[cfg(unix)]
fn code_behind(shell: &str, arguments: &str) -> (i32, String) {
    let script = shell.replace("WHITECAP", &format!("'{}' {arguments}", env!("CARGO_BIN_EXE_whitecap")));
    let output = assert_cmd::Command::new("bash").args(["-c", &script]).output().unwrap();
    (output.status.code().unwrap_or(-1), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[cfg(unix)]
#[test]
fn a_reader_that_leaves_early_is_no_failure() {
    for arguments in [
        "--help",
        "man",
        "completions zsh",
        "scenes meshuggah",
        "scenes --json",
        "check meshuggah",
        "probe --at 0,0",
        "probe --grid 0..1/300,0..1/300 --csv",
        "spectrum",
    ] {
        // The right side is gone before the left side writes.
        let (code, stderr) = code_behind("(sleep 0.3; WHITECAP) | true; exit ${PIPESTATUS[0]}", arguments);
        assert_eq!((code, stderr.as_str()), (0, ""), "{arguments}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_standard_output_is_noticed() {
    for arguments in ["scenes", "scenes --json", "probe --at 0,0", "man", "completions bash", "--help"] {
        let (code, stderr) = code_behind("WHITECAP > /dev/full", arguments);
        assert_eq!(code, 1, "{arguments}: {stderr}");
        assert!(stderr.starts_with("whitecap: cannot write to standard output: No space"), "{stderr}");
    }
}

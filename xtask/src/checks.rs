//! Every check that a change must pass, in one go. Each runs whatever became of the others, so that one run
//! shows everything there is to mend.

use crate::{process, product, setup, web};
use anyhow::Result;
use std::path::Path;
use std::process::Command;

/// Whether every crate that is published can be packed. All at once, since they need each other and are on no
/// registry; offline, since everything they need has been fetched by then; without building them once more.
const PACKAGE: [&str; 12] = [
    "package",
    "--workspace",
    "--exclude",
    "xtask",
    "--exclude",
    "whitecap-tests",
    "--exclude",
    "whitecap-web",
    "--no-verify",
    "--allow-dirty",
    "--offline",
    "--quiet",
];

pub(crate) fn run() -> Result<()> {
    let mut tally = Tally::default();
    tally.check("format", process::cargo().args(["fmt", "--all", "--check"]));
    tally.check(
        "lints",
        process::cargo().args(["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]),
    );
    tally.check(
        "docs",
        process::cargo().args(["doc", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings"),
    );
    if Path::new("fuzz/Cargo.toml").exists() {
        tally.check("fuzz targets", process::cargo().args(["check", "--manifest-path", "fuzz/Cargo.toml"]));
    }
    tally.check("packages", process::cargo().args(PACKAGE));
    if has_cargo_deny() {
        tally.check("licences and advisories", process::cargo().args(["deny", "check"]));
    } else {
        process::say(
            "\n(cargo-deny is not installed, so advisories were not checked; a test checks licences)",
        );
    }

    match product::build_tests() {
        Ok(whitecap) => {
            if let Err(error) = setup::ensure_adapter(&whitecap) {
                tally.fail("set-up", &format!("{error:#}"));
            }
            if let Err(error) = setup::ensure_screen() {
                tally.fail("set-up", &format!("{error:#}"));
            }
            tests(&mut tally)?;
        }
        Err(error) => tally.fail("build of the tests", &format!("{error:#}")),
    }
    page(&mut tally);
    if tally.close() {
        Ok(())
    } else {
        std::process::exit(1) // without a word more: the sum stays the last line
    }
}

/// Unit, integration and doc tests. Without an adapter they fail rather than skip.
fn tests(tally: &mut Tally) -> Result<()> {
    process::heading("tests");
    let mut test = process::cargo();
    test.args(["test", "--workspace", "--no-fail-fast"]).env("WHITECAP_REQUIRE_ADAPTER", "1");
    let failed_before = tally.failed;
    let succeeded = process::watch(&mut test, |line| tally.count(line))?;
    if !succeeded && tally.failed == failed_before {
        tally.fail("tests", "cargo test failed without a failing test; its output says why");
    }
    Ok(())
}

/// The page for browsers: built, weighed, and tested in one.
fn page(tally: &mut Tally) {
    let failed_before = tally.failed;
    match web::page_test(&mut |line| tally.count(line)) {
        Ok(succeeded) if succeeded || tally.failed > failed_before => {}
        Ok(_) => tally.fail("page", "its test failed without a failing case; its output says why"),
        Err(error) => tally.fail("page", &format!("{error:#}")),
    }
}

fn has_cargo_deny() -> bool {
    let mut deny = process::cargo();
    deny.args(["deny", "--version"]).output().is_ok_and(|output| output.status.success())
}

/// What passed and what did not: a check counts like a test.
#[derive(Debug, Default, PartialEq, Eq)]
struct Tally {
    passed: u64,
    failed: u64,
    failures: Vec<String>,
}

impl Tally {
    /// Runs `command` as the check called `name`.
    fn check(&mut self, name: &str, command: &mut Command) {
        process::heading(&format!("{name}: {}", process::shown(command)));
        match process::run(command) {
            Ok(()) => self.passed += 1,
            Err(error) => self.fail(name, &format!("{error:#}")),
        }
    }

    fn fail(&mut self, name: &str, why: &str) {
        self.failed += 1;
        self.failures.push(format!("{name}: {why}"));
    }

    /// Takes in a line of cargo's output. Every test binary closes with one such as
    /// `test result: ok. 12 passed; 0 failed; 0 ignored; …`.
    fn count(&mut self, line: &str) {
        if let Some(counts) = line.strip_prefix("test result: ") {
            let number_of = |what: &str| {
                let words: Vec<&str> =
                    counts.split([' ', ';', '.']).filter(|word| !word.is_empty()).collect();
                let place = words.iter().position(|word| *word == what)?;
                words.get(place.checked_sub(1)?)?.parse::<u64>().ok()
            };
            self.passed += number_of("passed").unwrap_or(0);
            self.failed += number_of("failed").unwrap_or(0);
        } else if let Some(name) =
            line.strip_prefix("test ").and_then(|rest| rest.strip_suffix(" ... FAILED"))
        {
            self.failures.push(name.to_owned());
        }
    }

    /// Prints what failed and, as the last line, the sum. The answer is whether everything passed.
    fn close(&self) -> bool {
        process::heading("result");
        for failure in &self.failures {
            process::say(&format!("failed: {failure}"));
        }
        process::say(&format!("{} passed, {} failed", self.passed, self.failed));
        self.failed == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closing_lines_of_test_binaries_are_summed() {
        let mut tally = Tally::default();
        for line in [
            "running 3 tests",
            "test a ... ok",
            "test b::c ... FAILED",
            "test result: FAILED. 2 passed; 1 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s",
            "test result: ok. 40 passed; 0 failed; 2 ignored; 0 measured; 0 filtered out; finished in 1.00s",
        ] {
            tally.count(line);
        }
        assert_eq!(tally, Tally { passed: 42, failed: 1, failures: vec!["b::c".into()] });
        assert!(!tally.close());
    }

    #[test]
    fn a_check_that_fails_is_counted_and_named() {
        let mut tally = Tally::default();
        tally.check("nothing", &mut Command::new("whitecap-has-no-such-program"));
        assert_eq!((tally.passed, tally.failed), (0, 1));
        assert!(tally.failures[0].starts_with("nothing: "), "{:?}", tally.failures);
    }
}

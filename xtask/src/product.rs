//! The `whitecap` binary: building it, and asking it for JSON.

use crate::process;
use anyhow::{Context, Result, bail};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The command as users get it.
pub(crate) fn build_release() -> Result<PathBuf> {
    process::heading("build: the command, optimised");
    executable(process::cargo().args(["build", "--release", "--package", "whitecap"]))
}

/// The command as its tests run it, and every test with it.
///
/// Building the whole workspace at once gives the dependencies the same features as `cargo test
/// --workspace`; building the command alone would compile most of them a second time.
pub(crate) fn build_tests() -> Result<PathBuf> {
    process::heading("build: everything and its tests");
    executable(process::cargo().args(["test", "--workspace", "--no-run"]))
}

/// A call of `whitecap` at `path` whose answer is JSON.
pub(crate) fn command(path: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(path);
    command.args(arguments).arg("--json");
    command
}

/// Runs a call that [`command`] made and reads the answer.
///
/// The exit code is not looked at: an answer that is none says so itself, and an empty list of adapters is
/// an answer.
pub(crate) fn ask(command: &mut Command) -> Result<Value> {
    let shown = process::shown(command);
    let output = command.output().with_context(|| format!("cannot start `{shown}`"))?;
    let answer: Value = serde_json::from_slice(&output.stdout)
        .with_context(|| String::from_utf8_lossy(&output.stderr).trim().to_owned())
        .with_context(|| format!("`{shown}` did not answer in JSON ({})", output.status))?;
    match answer["error"].as_str() {
        Some(error) => bail!("`{shown}`: {error}"),
        None => Ok(answer),
    }
}

/// Builds, and finds the command among what was built.
fn executable(build: &mut Command) -> Result<PathBuf> {
    let messages = process::output(build.arg("--message-format=json-render-diagnostics"))?;
    find_executable(&messages).context("cargo built no whitecap binary")
}

fn find_executable(messages: &str) -> Option<PathBuf> {
    messages
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .filter(|message| {
            message["reason"] == "compiler-artifact"
                && message["target"]["name"] == "whitecap"
                && message["target"]["kind"][0] == "bin"
                && message["profile"]["test"] == false
        })
        .find_map(|message| message["executable"].as_str().map(PathBuf::from))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_is_told_from_its_own_unit_tests() {
        let message = |test: bool, path: &str| {
            serde_json::json!({
                "reason": "compiler-artifact",
                "target": { "name": "whitecap", "kind": ["bin"] },
                "profile": { "test": test },
                "executable": path,
            })
        };
        let messages = format!("{}\n{}\n", message(true, "deps/whitecap-1"), message(false, "whitecap"));
        assert_eq!(find_executable(&messages), Some(PathBuf::from("whitecap")));
        assert_eq!(find_executable("no json"), None);
    }
}

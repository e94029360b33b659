//! `whitecap check`: is a scene file right?

use crate::failure::Failure;
use crate::stdout;
use clap::ValueHint;
use std::io::Write;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  whitecap check storm.toml
  whitecap check scenes/*.toml --json

Each scene is read and checked as `render` would, without a graphics adapter. The exit code is 2 if any has \
an error.";

/// Check scenes without rendering them
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Check {
    /// Named scenes, or paths of scene files
    #[arg(required = true, value_name = "SCENE", value_hint = ValueHint::FilePath)]
    scenes: Vec<String>,

    /// Print a JSON list with scene, ok and, where there are any, error and warnings
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(serde::Serialize)]
struct Verdict<'a> {
    scene: &'a str,
    ok: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
}

impl Check {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let verdicts: Vec<Verdict<'_>> = self.scenes.iter().map(|scene| verdict(scene)).collect();
        if self.json {
            stdout::write_json(&verdicts)?;
        } else {
            for Verdict { scene, error, warnings, .. } in &verdicts {
                super::print_warnings(warnings);
                match error {
                    None => stdout::write(format!("{scene}: ok\n").as_bytes())?,
                    // Nobody is left to tell if standard error is closed; the exit code still does.
                    Some(error) => drop(writeln!(std::io::stderr(), "whitecap: {error}")),
                }
            }
        }
        let all_ok = verdicts.iter().all(|verdict| verdict.ok);
        Ok(if all_ok { ExitCode::SUCCESS } else { ExitCode::from(2) })
    }
}

fn verdict(scene: &str) -> Verdict<'_> {
    match whitecap_scene::open(scene) {
        Ok(opened) => Verdict { scene, ok: true, error: None, warnings: opened.warnings },
        Err(error) => Verdict { scene, ok: false, error: Some(error.to_string()), warnings: Vec::new() },
    }
}

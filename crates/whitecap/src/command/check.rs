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

    /// Print a JSON list with scene, ok and, where there is one, error
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(serde::Serialize)]
struct Verdict<'a> {
    scene: &'a str,
    ok: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
}

impl Check {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let verdicts: Vec<Verdict<'_>> = self.scenes.iter().map(|scene| verdict(scene)).collect();
        if self.json {
            stdout::write_json(&verdicts)?;
        } else {
            for Verdict { scene, error, .. } in &verdicts {
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
    let error = whitecap_scene::open(scene).err().map(|error| error.to_string());
    Verdict { scene, ok: error.is_none(), error }
}

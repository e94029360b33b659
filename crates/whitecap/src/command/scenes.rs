//! `whitecap scenes`: what there is to render.

use crate::failure::Failure;
use crate::stdout;
use clap::builder::PossibleValuesParser;
use std::process::ExitCode;
use whitecap_scene::named::{self, NamedScene};

const EXAMPLES: &str = "\
Examples:
  whitecap scenes                          list them
  whitecap scenes meshuggah > storm.toml   start a scene file of your own
  whitecap render storm.toml               and see it";

/// List the named scenes, or print one as a scene file
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Scenes {
    /// The scene to print, as TOML
    #[arg(value_parser = PossibleValuesParser::new(named::ALL.iter().map(|scene| scene.name)))]
    name: Option<String>,

    /// Print JSON: a list with name, title and technique; with NAME, that scene's entry and its toml
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(serde::Serialize)]
struct Entry {
    name: &'static str,
    title: &'static str,
    technique: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    toml: Option<&'static str>,
}

impl Scenes {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let chosen = self.name.as_deref().and_then(named::find);
        match (chosen, self.json) {
            (Some(scene), true) => {
                stdout::write_json(&Entry { toml: Some(scene.toml), ..entry(scene)? })?;
            }
            (Some(scene), false) => stdout::write(scene.toml.as_bytes())?,
            (None, true) => {
                let entries: Vec<Entry> = named::ALL.iter().map(entry).collect::<Result<_, _>>()?;
                stdout::write_json(&entries)?;
            }
            (None, false) => stdout::write(list().as_bytes())?,
        }
        Ok(ExitCode::SUCCESS)
    }
}

fn entry(scene: &'static NamedScene) -> Result<Entry, Failure> {
    let technique = whitecap_scene::open(scene.name)?.technique.word().to_owned();
    Ok(Entry { name: scene.name, title: scene.title, technique, toml: None })
}

fn list() -> String {
    let width = named::ALL.iter().map(|scene| scene.name.len()).max().unwrap_or(0);
    let line = |scene: &NamedScene| {
        let default = if scene.name == named::DEFAULT { " (the default)" } else { "" };
        format!("{:width$}  {}{default}\n", scene.name, scene.title)
    };
    named::ALL.iter().map(line).collect()
}

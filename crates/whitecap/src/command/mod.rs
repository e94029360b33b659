//! The verbs: one file each, and one line each in [`Verb`].

mod adapters;
mod bench;
mod check;
mod completions;
mod gallery;
mod man;
mod options;
mod probe;
mod render;
mod scenes;
mod spectrum;
mod view;

use crate::failure::Failure;
use std::io::Write as _;
use std::process::ExitCode;
use std::time::Instant;
use whitecap_scene::Scene;

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the machine could not do it: no graphics adapter, no space, no permission
  2  wrong usage or input: a bad option, a scene with an error, a folder that does not exist

Data goes to standard output, everything else to standard error. With --json, standard output holds one \
JSON document: the result, or {\"error\": \"…\"} beside the same sentence on standard error. Of a sequence it \
holds a line of JSON for each frame and one for the whole.";

/// A calibrated sea, from a scene file to a picture
#[derive(Debug, clap::Parser)]
#[command(name = "whitecap", version, after_help = EXIT_CODES, max_term_width = 100)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) verb: Verb,
}

/// What can be asked for.
#[derive(Debug, clap::Subcommand)]
pub(crate) enum Verb {
    Render(render::Render),
    View(view::View),
    Gallery(gallery::Gallery),
    Probe(probe::Probe),
    Spectrum(spectrum::Spectrum),
    Bench(bench::Bench),
    Check(check::Check),
    Scenes(scenes::Scenes),
    Adapters(adapters::Adapters),
    Completions(completions::Completions),
    Man(man::Man),
}

impl Verb {
    /// Does the work; `started` is when the process did.
    pub(crate) fn run(&self, started: Instant) -> Result<ExitCode, Failure> {
        match self {
            Verb::Render(render) => render.run(started),
            Verb::View(view) => view.run(),
            Verb::Gallery(gallery) => gallery.run(started),
            Verb::Probe(probe) => probe.run(),
            Verb::Spectrum(spectrum) => spectrum.run(),
            Verb::Bench(bench) => bench.run(),
            Verb::Check(check) => check.run(),
            Verb::Scenes(scenes) => scenes.run(),
            Verb::Adapters(adapters) => adapters.run(),
            Verb::Completions(completions) => completions.run(),
            Verb::Man(man) => man.run(),
        }
    }

    /// Whether errors, too, should be readable by a program.
    pub(crate) fn wants_json(&self) -> bool {
        match self {
            Verb::Render(render) => render.json,
            Verb::Gallery(gallery) => gallery.json,
            Verb::Probe(probe) => probe.json,
            Verb::Spectrum(spectrum) => spectrum.json,
            Verb::Bench(bench) => bench.json,
            Verb::Check(check) => check.json,
            Verb::Scenes(scenes) => scenes.json,
            // Its answer is always a list, if an empty one.
            Verb::View(_) | Verb::Adapters(_) | Verb::Completions(_) | Verb::Man(_) => false,
        }
    }
}

/// Reads a scene, and says on standard error where its sea bends what it asks for.
fn open(name_or_path: &str) -> Result<Scene, Failure> {
    let scene = whitecap_scene::open(name_or_path)?;
    print_warnings(&scene.warnings);
    Ok(scene)
}

fn print_warnings(warnings: &[String]) {
    for warning in warnings {
        // Nobody is left to tell if standard error is closed.
        let _ = writeln!(std::io::stderr(), "warning: {warning}");
    }
}

#[cfg(test)]
mod tests {
    use super::Cli;

    #[test]
    fn the_arguments_are_well_formed() {
        <Cli as clap::CommandFactory>::command().debug_assert();
    }
}

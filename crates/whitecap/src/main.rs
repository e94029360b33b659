//! `whitecap`: a calibrated sea, from a scene file to a picture.
//!
//! Data goes to standard output and everything else to standard error. The exit code is 0 when the work
//! is done, 1 when the machine could not do it and 2 when what was asked for is wrong.

mod command;
mod failure;
mod headless;
mod memory;
mod openexr;
mod part;
mod png;
mod sheet;
mod stages;
mod stdout;
mod whole_file;
mod whole_folder;

use clap::Parser;
use command::Cli;
use failure::Failure;
use std::io::Write;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let started = Instant::now();
    headless::hush_device_selection();
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(usage) => return answer_usage(&usage),
    };
    match cli.verb.run(started) {
        Ok(code) => code,
        Err(failure) => report(&failure, cli.verb.wants_json()),
    }
}

/// Prints help and version where they were asked for, and what is wrong with the arguments otherwise.
fn answer_usage(usage: &clap::Error) -> ExitCode {
    // The arguments did not parse, so `--json` can only be looked for by hand.
    if usage.use_stderr() && std::env::args_os().any(|argument| argument == "--json") {
        let text = usage.render().to_string();
        // The first paragraph: clap lists what is missing on lines of their own.
        let paragraph = text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim);
        let sentence = paragraph.collect::<Vec<_>>().join(" ");
        let _ = stdout::error_as_json(sentence.trim_start_matches("error: "));
    }
    match usage.print().map_err(stdout::failure) {
        Err(failure) => report(&failure, false),
        // The numbers are clap's: 0 for help and version, 2 for anything wrong.
        Ok(()) => ExitCode::from(u8::try_from(usage.exit_code()).unwrap_or(1)),
    }
}

/// Says once, in one sentence, why there is no result.
pub(crate) fn report(failure: &Failure, json: bool) -> ExitCode {
    if let Some(sentence) = failure.sentence() {
        // Nobody is left to tell if either stream is closed.
        let _ = writeln!(std::io::stderr(), "whitecap: {sentence}");
        if json {
            let _ = stdout::error_as_json(&sentence);
        }
    }
    failure.exit_code()
}

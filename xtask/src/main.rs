//! whitecap's chores. `cargo xtask` lists them.

mod bench;
mod checks;
mod demo;
mod docs;
mod goldens;
mod process;
mod product;
mod setup;

use std::process::ExitCode;

/// A chore: its word, what it does, and the function that does it.
struct Chore {
    word: &'static str,
    summary: &'static str,
    run: fn() -> anyhow::Result<()>,
}

const ALL: &[Chore] = &[
    Chore {
        word: "demo",
        summary: "set up, build, render the default scene and the gallery into out/",
        run: demo::run,
    },
    Chore { word: "test", summary: "set up, then run every check that a change must pass", run: checks::run },
    Chore { word: "setup", summary: "see to it that there is an adapter to draw with", run: setup::run },
    Chore { word: "goldens", summary: "render the golden pictures anew, to be looked at", run: goldens::run },
    Chore {
        word: "docs",
        summary: "write the list of scene keys and render the pages' pictures anew",
        run: docs::run,
    },
    Chore {
        word: "bench",
        summary: "measure the sea, the command and the frames against their goals",
        run: bench::run,
    },
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let chore = match arguments.as_slice() {
        [] => return help(ExitCode::SUCCESS),
        [flag] if ["help", "--help", "-h"].contains(&flag.as_str()) => return help(ExitCode::SUCCESS),
        [word] => ALL.iter().find(|chore| chore.word == word),
        _ => None,
    };
    let Some(chore) = chore else {
        process::complain(&format!("no such chore: {}", arguments.join(" ")));
        return help(ExitCode::from(2));
    };
    match process::enter_repository().and_then(|()| (chore.run)()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            process::complain(&format!("{error:#}"));
            ExitCode::FAILURE
        }
    }
}

fn help(code: ExitCode) -> ExitCode {
    process::say("Usage: cargo xtask <chore>\n");
    for chore in ALL {
        process::say(&format!("  {:8} {}", chore.word, chore.summary));
    }
    code
}

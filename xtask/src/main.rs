//! whitecap's chores. `cargo xtask` lists them.

mod bench;
mod checks;
mod demo;
mod docs;
mod goldens;
mod process;
mod product;
mod setup;
mod web;

use std::process::ExitCode;

/// A chore: its words, what it does, and the function that does it.
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
    Chore { word: "web", summary: "build the page for browsers, and weigh it", run: web::run },
    Chore { word: "web --serve", summary: "the same, and serve it on this machine", run: web::serve },
    Chore { word: "web --test", summary: "the same, and test it in Chromium", run: web::test },
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words = arguments.join(" ");
    if ["", "help", "--help", "-h"].contains(&words.as_str()) {
        return help(ExitCode::SUCCESS);
    }
    let Some(chore) = ALL.iter().find(|chore| chore.word == words) else {
        process::complain(&format!("no such chore: {words}"));
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
        process::say(&format!("  {:11} {}", chore.word, chore.summary));
    }
    code
}

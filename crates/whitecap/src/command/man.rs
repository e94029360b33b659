//! `whitecap man`: manual pages, made from the same words as `--help`.

use super::Cli;
use crate::failure::Failure;
use crate::stdout;
use crate::whole_file::WholeFile;
use anyhow::anyhow;
use clap::{CommandFactory, ValueHint};
use std::path::PathBuf;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  whitecap man | man -l -                        read them all
  whitecap man -o ~/.local/share/man/man1        install them";

/// Print the manual pages of whitecap and each of its verbs
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Man {
    /// A folder that exists, to write one file per page into [default: standard output, one after the
    /// other]
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    output: Option<PathBuf>,
}

impl Man {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let pages = pages()?;
        let Some(folder) = &self.output else {
            stdout::write(&pages.into_iter().flat_map(|page| page.roff).collect::<Vec<u8>>())?;
            return Ok(ExitCode::SUCCESS);
        };
        if folder.is_file() {
            return Err(Failure::Input(anyhow!("{} is a file; name a folder", folder.display())));
        }
        for page in pages {
            let path = folder.join(page.name);
            WholeFile::plan(&path)?.write(&page.roff)?;
            stdout::write(format!("{}\n", path.display()).as_bytes())?;
        }
        Ok(ExitCode::SUCCESS)
    }
}

/// A manual page and its file's name, such as `whitecap-render.1`.
struct Page {
    name: String,
    roff: Vec<u8>,
}

fn pages() -> Result<Vec<Page>, Failure> {
    let mut whitecap = Cli::command().disable_help_subcommand(true);
    whitecap.build(); // gives the verbs their full names
    let verbs: Vec<clap::Command> = whitecap.get_subcommands().cloned().collect();
    std::iter::once(whitecap).chain(verbs).map(page).collect()
}

fn page(command: clap::Command) -> Result<Page, Failure> {
    let man = clap_mangen::Man::new(command).source(concat!("whitecap ", env!("CARGO_PKG_VERSION")));
    let mut roff = Vec::new();
    man.render(&mut roff).map_err(|e| Failure::Machine(e.into()))?;
    Ok(Page { name: man.get_filename(), roff })
}

//! `whitecap completions`: what a shell needs to complete our arguments.

use super::Cli;
use crate::failure::Failure;
use crate::stdout;
use clap::CommandFactory;
use clap_complete::Shell;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  whitecap completions bash > ~/.local/share/bash-completion/completions/whitecap
  whitecap completions zsh > ~/.zfunc/_whitecap
  whitecap completions fish > ~/.config/fish/completions/whitecap.fish";

/// Print shell completions
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Completions {
    /// The shell to complete in
    shell: Shell,
}

impl Completions {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        // Into memory first: the generator panics when a write fails.
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Cli::command(), "whitecap", &mut script);
        stdout::write(&script)?;
        Ok(ExitCode::SUCCESS)
    }
}

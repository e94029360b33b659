//! `whitecap adapters`: what there is to draw with.

use crate::failure::Failure;
use crate::stdout;
use std::fmt::Write;
use std::process::ExitCode;
use whitecap_render::{AdapterDescription, Gpu, list_adapters};

const NOTES: &str = "\
Examples:
  whitecap adapters
  whitecap render --adapter vulkan

The first is what `render` takes by default: Vulkan, Metal and Direct3D 12 before OpenGL, real graphics \
cards before software. The exit code is 1 if there is none at all; with --json the list is then empty.";

/// List the graphics adapters, the default first
#[derive(Debug, clap::Args)]
#[command(after_help = NOTES)]
pub(crate) struct Adapters {
    /// Print a JSON list with name, backend, device_type, driver and webgpu_compliant
    #[arg(long)]
    json: bool,
}

impl Adapters {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let adapters = list_adapters();
        if self.json {
            stdout::write_json(&adapters)?;
        } else {
            stdout::write(for_people(&adapters).as_bytes())?;
        }
        if adapters.is_empty() {
            // Opening says why there is none and what to install.
            Gpu::open(None)?;
        }
        Ok(ExitCode::SUCCESS)
    }
}

fn for_people(adapters: &[AdapterDescription]) -> String {
    let mut text = String::new();
    for adapter in adapters {
        let lacking = if adapter.webgpu_compliant { "" } else { "; lacks some of what WebGPU asks for" };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{adapter}{lacking}");
    }
    text
}

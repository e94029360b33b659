//! The first pictures: set up, build, render, say where they are.

use crate::{process, product, setup};
use anyhow::{Context, Result};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder for pictures that are made by hand; git does not see it.
const FOLDER: &str = "out";

pub(crate) fn run() -> Result<()> {
    let whitecap = product::build_release()?;
    setup::ensure_adapter(&whitecap)?;

    process::heading("the default scene");
    std::fs::create_dir_all(FOLDER).with_context(|| format!("cannot make the folder {FOLDER}/"))?;
    let mut render = product::command(&whitecap, &["render"]);
    let report = product::ask(render.current_dir(FOLDER))?;
    process::say(&told(&report));

    process::heading("every scene side by side");
    let gallery = Path::new(FOLDER).join("gallery");
    process::run(Command::new(&whitecap).arg("gallery").arg("-o").arg(&gallery))?;
    process::say(&format!("\nThe gallery is {}", whole(&gallery.join("index.html")).display()));
    process::say(&format!("The first picture is {}", picture(&report).display()));
    Ok(())
}

/// The report of `whitecap render --json` in words.
fn told(report: &Value) -> String {
    let word = |value: &Value| value.as_str().unwrap_or("?").to_owned();
    let ms = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let adapter = &report["adapter"];
    let mut lines = vec![
        format!("{} × {} pixels of {}", report["width"], report["height"], word(&report["scene"])),
        format!(
            "on {} ({}, {})",
            word(&adapter["name"]),
            word(&adapter["backend"]),
            word(&adapter["driver"])
        ),
    ];
    let stages = report["stages"].as_array().map_or(&[][..], Vec::as_slice);
    let stages = stages.iter().map(|stage| (word(&stage["name"]), ms(&stage["ms"])));
    for (name, ms) in stages.chain([("total".to_owned(), ms(&report["total_ms"]))]) {
        lines.push(format!("  {name:24} {ms:8.1} ms"));
    }
    lines.push(format!("\nThe picture is {}", picture(report).display()));
    lines.join("\n")
}

/// Where the picture of the report is.
fn picture(report: &Value) -> PathBuf {
    whole(&Path::new(FOLDER).join(report["picture"].as_str().unwrap_or("?")))
}

/// The path from the root, to be opened from anywhere.
fn whole(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_place_the_adapter_and_every_stage_are_told() {
        let report = serde_json::json!({
            "scene": "calm", "picture": "calm.png", "width": 1280, "height": 720,
            "adapter": { "name": "card", "backend": "vulkan", "driver": "driver 1" },
            "stages": [{ "name": "sea", "ms": 12.34 }, { "name": "draw", "ms": 5.0 }],
            "total_ms": 20.0,
        });
        let told = told(&report);
        for expected in
            ["1280 × 720", "out/calm.png", "card (vulkan, driver 1)", "sea", "12.3 ms", "draw", "20.0 ms"]
        {
            assert!(told.contains(expected), "{expected} is missing from:\n{told}");
        }
    }
}

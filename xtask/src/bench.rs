//! The speeds that are promised, measured on this machine and printed as Markdown tables.

use crate::{process, product, setup};
use anyhow::{Context, Result};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The sides of the synthesised tiles.
const SIDES: [u32; 3] = [64, 256, 512];
/// A whole sea may cost this many times what its eight bare inverse transforms do with realfft.
const MOST_TIMES_BARE: f64 = 1.5;

/// How often the whole command is run.
const RUNS: usize = 9;
/// From the start of the process to its end, for the default scene at 1280×720.
const MOST_SECONDS: f64 = 2.0;
const MOST_MEMORY_MB: f64 = 300.0;

pub(crate) fn run() -> Result<()> {
    let whitecap = product::build_release()?;
    setup::ensure_adapter(&whitecap)?;
    let synthesis = synthesis()?;
    let command = whole_command(&whitecap)?;
    process::heading("results");
    process::say(&synthesis);
    process::say(&command);
    Ok(())
}

fn synthesis() -> Result<String> {
    process::heading("synthesis of a sea");
    process::run(process::cargo().args(["bench", "--package", "whitecap-waves", "--bench", "synthesis"]))?;
    let folder = target_folder()?.join("criterion");
    let mut table = String::from(
        "| tile | sea, ms | realfft, ms | ratio | goal | own transforms, ms |\n| --- | --- | --- | --- | --- | --- |\n",
    );
    for side in SIDES {
        let sea = median_ms(&folder.join("sea").join(side.to_string()))?;
        let bare = median_ms(&folder.join("bare").join(side.to_string()))?;
        let realfft = median_ms(&folder.join("realfft").join(side.to_string()))?;
        let ratio = sea / realfft;
        table += &format!(
            "| {side}² | {sea:.3} | {realfft:.3} | {ratio:.2} | {} | {bare:.3} |\n",
            verdict(ratio, MOST_TIMES_BARE, "")
        );
    }
    Ok(table)
}

fn whole_command(whitecap: &Path) -> Result<String> {
    process::heading("render of the default scene, start to end");
    let folder = target_folder()?.join("bench");
    std::fs::create_dir_all(&folder)?;
    let mut seconds = Vec::new();
    let mut megabytes = Vec::new();
    for run in 1..=RUNS {
        let mut render = product::command(whitecap, &["render", "--size", "1280x720"]);
        let start = Instant::now();
        let report = product::ask(render.current_dir(&folder))?;
        let elapsed = start.elapsed().as_secs_f64();
        process::say(&format!("run {run} of {RUNS}: {elapsed:.3} s, {}", report["adapter"]["name"]));
        seconds.push(elapsed);
        megabytes.push(report["peak_memory_mib"].as_f64().map_or(f64::NAN, mb_from_mib));
    }
    let (least, middle, most) = spread(&mut seconds).context("at least one run")?;
    let (.., memory_mb) = spread(&mut megabytes).context("at least one run")?;
    Ok(format!(
        "| render, 1280×720 | median | fastest | slowest | goal |\n| --- | --- | --- | --- | --- |\n\
         | wall time, s | {middle:.3} | {least:.3} | {most:.3} | {} |\n\
         | peak memory, MB | | | {memory_mb:.0} | {} |\n",
        verdict(middle, MOST_SECONDS, " s"),
        verdict(memory_mb, MOST_MEMORY_MB, " MB"),
    ))
}

fn verdict(measured: f64, most: f64, unit: &str) -> String {
    let met = if measured <= most { "met" } else { "**missed**" };
    format!("≤ {most}{unit}: {met}")
}

/// The median that criterion measured for the benchmark kept in `folder`.
fn median_ms(folder: &Path) -> Result<f64> {
    let path = folder.join("new").join("estimates.json");
    let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    median_ms_in(&text).with_context(|| format!("{} holds no median", path.display()))
}

fn median_ms_in(estimates: &str) -> Option<f64> {
    let estimates: Value = serde_json::from_str(estimates).ok()?;
    Some(estimates["median"]["point_estimate"].as_f64()? / 1e6)
}

/// Where cargo builds, and criterion keeps its figures.
fn target_folder() -> Result<PathBuf> {
    let mut metadata = process::cargo();
    let text = process::output(metadata.args(["metadata", "--format-version", "1", "--no-deps"]))?;
    let metadata: Value = serde_json::from_str(&text)?;
    metadata["target_directory"].as_str().map(PathBuf::from).context("cargo metadata names no target folder")
}

/// The least, the middle and the largest.
fn spread(values: &mut [f64]) -> Option<(f64, f64, f64)> {
    values.sort_by(f64::total_cmp);
    Some((*values.first()?, *values.get(values.len() / 2)?, *values.last()?))
}

fn mb_from_mib(mib: f64) -> f64 {
    mib * 1024.0 * 1024.0 / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn criterions_median_is_read_in_milliseconds() {
        let estimates = r#"{ "mean": { "point_estimate": 9e6 }, "median": { "point_estimate": 2.5e6 } }"#;
        assert_eq!(median_ms_in(estimates), Some(2.5));
        assert_eq!(median_ms_in("{}"), None);
    }

    #[test]
    fn the_spread_is_by_size() {
        assert_eq!(spread(&mut [3.0, 1.0, 2.0]), Some((1.0, 2.0, 3.0)));
        assert_eq!(spread(&mut []), None);
    }

    #[test]
    fn a_goal_is_met_up_to_its_limit_and_an_unknown_figure_misses_it() {
        assert!(verdict(1.5, 1.5, "").ends_with(": met"));
        assert!(verdict(1.51, 1.5, "").ends_with("**missed**"));
        assert!(verdict(f64::NAN, 1.5, "").ends_with("**missed**"));
    }
}

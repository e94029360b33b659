//! The speeds that are promised, measured on this machine and printed as Markdown tables.

use crate::{process, product, setup};
use anyhow::{Context, Result};
use serde_json::Value;
use std::path::Path;
use std::time::Instant;

/// The sides of the synthesised tiles.
const SIDES: [u32; 5] = [64, 256, 512, 1024, 2048];
/// A whole sea may cost this many times what its eight bare inverse transforms do with realfft.
const MOST_TIMES_BARE: f64 = 1.3;
/// Two threads are this many times as fast as one, from tiles of this side up.
const LEAST_BY_TWO_THREADS: (u32, f64) = (512, 1.7);
/// The most that the making of a sea of four tiles of 256² may take, ms.
const MOST_SETUP_MS: f64 = 50.0;
/// The seas that are made, by the names of their benchmarks.
const SETUPS: [(&str, &str); 3] = [
    ("setup", "set-up, Phillips"),
    ("setup-default", "set-up, wind sea and swell, spectra included"),
    ("setup-dearest", "set-up, Donelan and Banner with swell, spectra included"),
];
/// Places that are asked of such a sea in one run of its benchmark, and the fewest to a second.
const PLACES: f64 = 100_000.0;
const LEAST_PLACES_PER_S: f64 = 1e6;

/// How often the whole command is run.
const RUNS: usize = 9;
/// From the start of the process to its end, for the default scene at 1280×720.
const MOST_SECONDS: f64 = 2.0;
const MOST_MEMORY_MB: f64 = 300.0;

/// The most that a frame of each technique's own scene may cost, at 1280×720 on a software adapter of two
/// cores, ms.
const MOST_FRAME_MS: [(&str, f64); 6] = [
    ("ocean-water", 120.0),
    ("five-sample", 120.0),
    ("meshuggah", 120.0),
    ("rippling-lake", 200.0),
    ("projected-grid", 200.0),
    ("spectral-ocean", 220.0),
];
/// The pass that makes a sea of noise on the processor, and the most that it may cost, ms.
const MOST_NOISE_MS: (&str, f64) = ("noise", 2.0);

pub(crate) fn run() -> Result<()> {
    let whitecap = product::build_release()?;
    setup::ensure_adapter(&whitecap)?;
    let synthesis = synthesis()?;
    let sea = sea()?;
    let command = whole_command(&whitecap)?;
    let frames = frames(&whitecap)?;
    process::heading("results");
    process::say(&synthesis);
    process::say(&sea);
    process::say(&command);
    process::say(&frames);
    Ok(())
}

fn synthesis() -> Result<String> {
    process::heading("synthesis of a sea");
    process::run(process::cargo().args(["bench", "--package", "whitecap-waves", "--bench", "synthesis"]))?;
    let folder = process::target_folder()?.join("criterion");
    let mut table = String::from(
        "| tile | sea, ms | realfft, ms | ratio | goal | own transforms, ms | two threads, ms | faster | goal |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for side in SIDES {
        let sea = median_ms(&folder.join("sea").join(side.to_string()))?;
        let bare = median_ms(&folder.join("bare").join(side.to_string()))?;
        let realfft = median_ms(&folder.join("realfft").join(side.to_string()))?;
        let two_threads = median_ms(&folder.join("sea-two-threads").join(side.to_string()))?;
        let (ratio, faster) = (sea / realfft, sea / two_threads);
        let (from_side, least) = LEAST_BY_TWO_THREADS;
        let by_two = if side >= from_side { verdict_at_least(faster, least) } else { String::new() };
        table += &format!(
            "| {side}² | {sea:.3} | {realfft:.3} | {ratio:.2} | {} | {bare:.3} | {two_threads:.3} | {faster:.2} | {by_two} |\n",
            verdict(ratio, MOST_TIMES_BARE, "")
        );
    }
    Ok(table)
}

fn sea() -> Result<String> {
    process::heading("a sea of four tiles of 256², and questions to it");
    process::run(process::cargo().args(["bench", "--package", "whitecap-waves", "--bench", "sea"]))?;
    let of = |name: &str| {
        Ok::<_, anyhow::Error>(process::target_folder()?.join("criterion/four-tiles").join(name))
    };
    let ms = |name: &str| median_ms(&of(name)?);
    let (snapshot, query) = (ms("snapshot")?, ms("query")?);
    let mut setups = String::new();
    for (name, what) in SETUPS {
        let setup = ms(name)?;
        setups += &format!("| {what}, ms | {setup:.1} | {} |\n", verdict(setup, MOST_SETUP_MS, " ms"));
    }
    let per_s = PLACES / (query / 1e3);
    Ok(format!(
        "| four tiles of 256², two threads | median | goal |\n| --- | --- | --- |\n\
         {setups}| snapshot for queries, ms | {snapshot:.1} | |\n\
         | places a second | {:.2} million | {} |\n",
        per_s / 1e6,
        verdict_at_least(per_s / 1e6, LEAST_PLACES_PER_S / 1e6),
    ))
}

fn whole_command(whitecap: &Path) -> Result<String> {
    process::heading("render of the default scene, start to end");
    let folder = process::target_folder()?.join("bench");
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

fn frames(whitecap: &Path) -> Result<String> {
    process::heading("a frame of each technique, pass by pass");
    Ok(frames_told(&product::ask(&mut product::command(whitecap, &["bench", "--size", "1280x720"]))?))
}

/// The report of `whitecap bench --json` as a table.
fn frames_told(report: &Value) -> String {
    let mut table =
        String::from("| frame, 1280×720 | pass | median, ms | goal |\n| --- | --- | --- | --- |\n");
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    for frame in list(report) {
        let scene = frame["scene"].as_str().unwrap_or("?");
        let mut row = |pass: &str, ms: &Value, most: Option<f64>| {
            let ms = ms.as_f64().unwrap_or(f64::NAN);
            let goal = most.map_or_else(String::new, |most| verdict(ms, most, " ms"));
            table += &format!("| {scene} | {pass} | {ms:.2} | {goal} |\n");
        };
        for pass in list(&frame["passes"]) {
            let name = pass["name"].as_str().unwrap_or("?");
            let (noise, most_ms) = MOST_NOISE_MS;
            row(name, &pass["ms"], (name == noise).then_some(most_ms));
        }
        let most_ms = MOST_FRAME_MS.iter().find(|(name, _)| *name == scene).map(|(_, most_ms)| *most_ms);
        row("sum", &frame["sum_ms"], most_ms);
    }
    for (scene, _) in MOST_FRAME_MS {
        if !list(report).iter().any(|frame| frame["scene"] == scene) {
            table += &format!("| {scene} | | | **missing**: no scene of this name |\n");
        }
    }
    table
}

fn verdict(measured: f64, most: f64, unit: &str) -> String {
    let met = if measured <= most { "met" } else { "**missed**" };
    format!("≤ {most}{unit}: {met}")
}

fn verdict_at_least(measured: f64, least: f64) -> String {
    let met = if measured >= least { "met" } else { "**missed**" };
    format!("≥ {least}: {met}")
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
    fn frames_are_held_against_their_goals_and_none_goes_missing() {
        let report = serde_json::json!([
            { "scene": "projected-grid", "sum_ms": 150.0,
              "passes": [{ "name": "noise", "ms": 2.5 }, { "name": "water", "ms": 147.5 }] },
            { "scene": "ocean-water", "sum_ms": 150.0, "passes": [{ "name": "water", "ms": 150.0 }] },
        ]);
        let told = frames_told(&report);
        for row in [
            "| projected-grid | noise | 2.50 | ≤ 2 ms: **missed** |",
            "| projected-grid | water | 147.50 |  |",
            "| projected-grid | sum | 150.00 | ≤ 200 ms: met |",
            "| ocean-water | sum | 150.00 | ≤ 120 ms: **missed** |",
            "| meshuggah | | | **missing**",
        ] {
            assert!(told.contains(row), "{row} is missing from:\n{told}");
        }
        assert!(!told.contains("| ocean-water | | |"));
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
        assert!(verdict_at_least(1.7, 1.7).ends_with(": met"));
        assert!(verdict_at_least(1.69, 1.7).ends_with("**missed**"));
        assert!(verdict_at_least(f64::NAN, 1.7).ends_with("**missed**"));
    }
}

//! Which stage the work is in, how long each took, and a line about it on a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// How long one stage took.
#[derive(Clone, Debug, serde::Serialize)]
pub(crate) struct StageTime {
    pub(crate) name: &'static str,
    pub(crate) ms: f64,
}

/// A stopwatch for consecutive stages.
///
/// The line on the terminal is gone when this is dropped, so it never stands beside an error.
pub(crate) struct Stages {
    line: ProgressBar,
    running: Option<(&'static str, Instant)>,
    done: Vec<StageTime>,
}

impl Stages {
    /// Starts with no stage. A line is shown only if `quiet` is false and standard error is a terminal.
    pub(crate) fn new(quiet: bool) -> Self {
        let shown = !quiet && std::io::stderr().is_terminal();
        let target = if shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let style = ProgressStyle::default_spinner();
        let style = style.clone().template("{spinner} {msg} {elapsed}").unwrap_or(style);
        let line = ProgressBar::with_draw_target(None, target).with_style(style);
        if shown {
            line.enable_steady_tick(Duration::from_millis(100));
        }
        Stages { line, running: None, done: Vec::new() }
    }

    /// Ends the running stage and begins the one called `name`.
    pub(crate) fn begin(&mut self, name: &'static str) {
        self.end();
        self.line.set_message(name);
        self.running = Some((name, Instant::now()));
    }

    /// Begins the stage called `name`, and says `about` what it is on the terminal.
    pub(crate) fn begin_about(&mut self, name: &'static str, about: &str) {
        self.begin(name);
        self.line.set_message(format!("{about}: {name}"));
    }

    /// Says on the terminal how far the running stage is.
    pub(crate) fn tell(&self, progress: &str) {
        if let Some((name, _)) = self.running {
            self.line.set_message(format!("{name}: {progress}"));
        }
    }

    /// Ends the last stage and hands out all of them, in order.
    pub(crate) fn finish(mut self) -> Vec<StageTime> {
        self.end();
        std::mem::take(&mut self.done)
    }

    fn end(&mut self) {
        if let Some((name, since)) = self.running.take() {
            self.done.push(StageTime { name, ms: milliseconds(since.elapsed()) });
        }
    }
}

impl Drop for Stages {
    fn drop(&mut self) {
        self.line.finish_and_clear();
    }
}

/// A duration in milliseconds, to the microsecond.
pub(crate) fn milliseconds(duration: Duration) -> f64 {
    (duration.as_secs_f64() * 1e6).round() / 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_follow_each_other_and_each_has_a_time() {
        let mut stages = Stages::new(true);
        stages.begin("first");
        std::thread::sleep(Duration::from_millis(2));
        stages.begin("second");
        let done = stages.finish();
        assert_eq!(done.iter().map(|s| s.name).collect::<Vec<_>>(), ["first", "second"]);
        assert!(done[0].ms >= 2.0 && done[1].ms >= 0.0, "{done:?}");
    }
}

//! The scene's time: it runs, stands still, runs slowly, or goes on by single frames.

/// Frames that a single step goes on by, a second.
const STEPS_PER_S: f64 = 60.0;

/// The longest that a frame may take to count in full, s: after a stall the sea goes on where it was.
const LONGEST_FRAME_S: f64 = 0.25;

/// How fast time may run, of real time.
const SPEEDS: [f64; 7] = [0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0];

/// The scene's time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    time_s: f64,
    start_s: f64,
    speed: usize,
    is_paused: bool,
}

impl Clock {
    /// A clock that runs from `start_s`, seconds from the scene's start.
    pub fn from(start_s: f64) -> Clock {
        Clock { time_s: start_s, start_s, speed: 4, is_paused: false }
    }

    /// The scene's time, s.
    pub fn time_s(&self) -> f64 {
        self.time_s
    }

    /// Whether it stands still.
    pub fn is_paused(&self) -> bool {
        self.is_paused
    }

    /// Seconds of the scene in a real second, while it runs.
    pub fn speed(&self) -> f64 {
        SPEEDS[self.speed]
    }

    /// Lets `real_s` seconds pass.
    pub fn pass(&mut self, real_s: f64) {
        if !self.is_paused {
            self.time_s += real_s.clamp(0.0, LONGEST_FRAME_S) * self.speed();
        }
    }

    /// Stands still, or goes on.
    pub fn toggle_pause(&mut self) {
        self.is_paused = !self.is_paused;
    }

    /// Goes on by one frame of 1/60 s and stands still.
    pub fn step(&mut self) {
        self.is_paused = true;
        self.time_s += 1.0 / STEPS_PER_S;
    }

    /// Twice as fast (1) or half as fast (−1), from 1/16 to 4.
    pub fn change_speed(&mut self, by: isize) {
        self.speed = self.speed.saturating_add_signed(by).min(SPEEDS.len() - 1);
    }

    /// Begins again.
    pub fn reset(&mut self) {
        self.time_s = self.start_s;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_passes_stands_and_steps() {
        let mut clock = Clock::from(10.0);
        clock.pass(0.1);
        assert!((clock.time_s() - 10.1).abs() < 1e-12);
        clock.change_speed(-1);
        clock.pass(0.1);
        assert!((clock.time_s() - 10.15).abs() < 1e-12);
        clock.step();
        assert!(clock.is_paused());
        let stepped = clock.time_s();
        clock.pass(0.1);
        assert_eq!(clock.time_s(), stepped);
        clock.toggle_pause();
        clock.pass(60.0);
        assert!((clock.time_s() - stepped - 0.125).abs() < 1e-12, "a stall is not made up for");
        clock.reset();
        assert_eq!(clock.time_s(), 10.0);
    }

    #[test]
    fn speed_stays_within_its_range() {
        let mut clock = Clock::from(0.0);
        for _ in 0..20 {
            clock.change_speed(1);
        }
        assert_eq!(clock.speed(), 4.0);
        for _ in 0..20 {
            clock.change_speed(-1);
        }
        assert_eq!(clock.speed(), 0.0625);
    }
}

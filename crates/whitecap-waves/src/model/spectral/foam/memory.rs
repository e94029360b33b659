//! What a place remembers of its breakers.

use super::convergence::Convergence;

/// Length of a block in e-folding times.
const BLOCK: f64 = 5.0;

/// Steps of the grid to an e-folding time.
const STEPS: f64 = 16.0;

/// From this part of a block on, what is of the block before fades away.
const FADES_FROM: f64 = 0.75;

/// The grid of times: blocks of so many steps.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clock {
    block_s: f64,
    steps: i64,
}

/// A time on the grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment {
    time_s: f64,
    block: i64,
    /// The last step of the block that is not after the time.
    step: i64,
    /// How far the block is, 0..=1.
    part: f64,
}

impl Clock {
    /// For foam that decays in `decay_s`. Where the sea loops, a whole number of blocks to a loop or of loops to a
    /// block closes the foam as well.
    pub(super) fn new(decay_s: f64, loop_s: Option<f64>) -> Self {
        let least_s = BLOCK * decay_s;
        let block_s = match loop_s {
            None => least_s,
            Some(loop_s) if loop_s >= least_s => loop_s / (loop_s / least_s).floor(),
            Some(loop_s) => loop_s * (least_s / loop_s).ceil(),
        };
        Self { block_s, steps: (STEPS * block_s / decay_s).ceil() as i64 }
    }

    pub(super) fn moment(&self, time_s: f64) -> Moment {
        let blocks = time_s / self.block_s;
        let part = (blocks - blocks.floor()).clamp(0.0, 1.0);
        let step = ((part * self.steps as f64).floor() as i64).min(self.steps - 1);
        Moment { time_s, block: blocks.floor() as i64, step, part }
    }

    /// The time of a step.
    pub(super) fn time_s(&self, block: i64, step: i64) -> f64 {
        (block as f64 + step as f64 / self.steps as f64) * self.block_s
    }

    pub(super) fn block_s(&self) -> f64 {
        self.block_s
    }

    pub(super) fn steps(&self) -> i64 {
        self.steps
    }

    fn step_s(&self) -> f64 {
        self.block_s / self.steps as f64
    }
}

/// mᵢ of one tile: that of the block up to a step, and that of the block before at its end.
#[derive(Default)]
pub(super) struct Memory {
    /// ρ in e-folds per second.
    per_s: f64,
    /// The last step that was taken.
    at: Option<(i64, i64)>,
    current: Vec<f32>,
    before: Vec<f32>,
}

impl Memory {
    pub(super) fn new(resolution: usize, per_s: f64) -> Self {
        let empty = vec![f32::NEG_INFINITY; resolution * resolution];
        Self { per_s, at: None, current: empty.clone(), before: empty }
    }

    /// The same on another grid, knowing nothing.
    pub(super) fn on_grid(&self, resolution: usize) -> Self {
        Self::new(resolution, self.per_s)
    }

    /// Writes mᵢ at `moment` into `field`.
    pub(super) fn recall(
        &mut self,
        clock: &Clock,
        moment: &Moment,
        convergence: &mut Convergence,
        field: &mut [f32],
    ) {
        self.advance(clock, moment, convergence, field);
        convergence.evaluate(moment.time_s, field);
        let lost = |block, step| (self.per_s * (moment.time_s - clock.time_s(block, step)).max(0.0)) as f32;
        let since_step = lost(moment.block, moment.step);
        let u = ((moment.part - FADES_FROM) / (1.0 - FADES_FROM)).clamp(0.0, 1.0);
        let faded = libm::log(1.0 - u * u * (3.0 - 2.0 * u)) as f32;
        let since_block = lost(moment.block - 1, clock.steps - 1) - faded;
        for ((value, current), before) in field.iter_mut().zip(&self.current).zip(&self.before) {
            *value = value.max(current - since_step).max(before - since_block);
        }
    }

    /// Takes the steps up to `moment`: from where it stands if that is on the way, otherwise from the start of the
    /// block before.
    fn advance(
        &mut self,
        clock: &Clock,
        moment: &Moment,
        convergence: &mut Convergence,
        scratch: &mut [f32],
    ) {
        let goal = (moment.block, moment.step);
        let on_the_way = |at: &(i64, i64)| *at <= goal && at.0 >= goal.0 - 1;
        let (mut block, mut step) = match self.at.filter(on_the_way) {
            Some((block, step)) => (block, step + 1),
            None => (goal.0 - 1, 0),
        };
        let lost = (self.per_s * clock.step_s()) as f32;
        loop {
            if step == clock.steps {
                (block, step) = (block + 1, 0);
            }
            if (block, step) > goal {
                break;
            }
            convergence.evaluate(clock.time_s(block, step), scratch);
            if step == 0 {
                std::mem::swap(&mut self.current, &mut self.before);
                self.current.copy_from_slice(scratch);
            } else {
                for (current, now) in self.current.iter_mut().zip(&*scratch) {
                    *current = (*current - lost).max(*now);
                }
            }
            step += 1;
        }
        self.at = Some(goal);
    }
}

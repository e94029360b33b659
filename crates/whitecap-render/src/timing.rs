//! How long each pass of a frame takes.
//!
//! By the wall: each pass is submitted alone and the device waited for. On a processor that draws this is what
//! the pass costs, and it does not depend on timestamps, which such adapters do not answer reliably. On a GPU it
//! holds the submission too, some hundredths of a millisecond.

use web_time::Instant;

/// The time of one pass.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct PassTime {
    /// The pass, in a word or two.
    pub name: &'static str,
    /// Wall-clock time, milliseconds.
    pub ms: f64,
}

/// What a part of the light adds to the pass that draws the water.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct FeatureTime {
    /// The part, in a word or two.
    pub name: &'static str,
    /// By how much the pass is shorter without it, milliseconds; below 0 where noise is larger.
    pub ms: f64,
}

/// A stopwatch for the passes of one frame.
pub(crate) struct PassTimer {
    since: Instant,
    passes: Vec<PassTime>,
}

impl PassTimer {
    pub(crate) fn start() -> PassTimer {
        PassTimer { since: Instant::now(), passes: Vec::new() }
    }

    /// Submits what is encoded, waits for it, and takes the time since the last call. `encoder` is a new one
    /// afterwards. A pass that ends several times, once for each view, is summed.
    pub(crate) fn end_of_pass(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        name: &'static str,
    ) {
        let done = std::mem::replace(encoder, device.create_command_encoder(&Default::default()));
        queue.submit([done.finish()]);
        // A lost device is told by the frame's own submission.
        let _ = device.poll(wgpu::PollType::wait_indefinitely());
        let ms = self.since.elapsed().as_secs_f64() * 1e3;
        match self.passes.iter_mut().find(|pass| pass.name == name) {
            Some(pass) => pass.ms += ms,
            None => self.passes.push(PassTime { name, ms }),
        }
        self.since = Instant::now();
    }

    pub(crate) fn passes(self) -> Vec<PassTime> {
        self.passes
    }
}

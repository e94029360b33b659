//! What each step takes, for whoever wants to know: `cargo test --release -p whitecap-render --lib -- --ignored
//! --nocapture timing`.

use super::*;
use crate::surface::{Backend, TileMaps};
use std::io::Write;
use std::time::Instant;

const RUNS: usize = 15;

/// The median time of `work`, submitted and waited for, in milliseconds.
fn median_ms(gpu: &crate::Gpu, mut work: impl FnMut(&mut wgpu::CommandEncoder)) -> f64 {
    let mut times: Vec<f64> = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            work(&mut encoder);
            gpu.queue.submit([encoder.finish()]);
            gpu.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[RUNS / 2]
}

#[test]
#[ignore = "measures, asserts nothing"]
fn timing() {
    let Some(gpu) = gpu() else { return };
    let mut out = std::io::stderr();
    writeln!(out, "{}, ms", gpu.adapter).unwrap();
    for n in [64, 128, 256, 512, 1024] {
        let sea = || sea(n, 1.0);
        let fields = SpectralFields::new(&gpu.device, &gpu.queue, &WaveConstants::of(&sea()));
        let [evolve, columns, rows] = [&fields.evolve, &fields.columns, &fields.rows].map(|step| {
            median_ms(gpu, |encoder| step.dispatch(&mut encoder.begin_compute_pass(&Default::default())))
        });
        let [cpu, device] = [Backend::Cpu, Backend::Gpu].map(|backend| {
            let mut maps = TileMaps::new(&gpu.device, &gpu.queue, Some(backend), Box::new(sea()), 1).unwrap();
            median_ms(gpu, |encoder| maps.update(&gpu.queue, encoder, 3.7))
        });
        writeln!(
            out,
            "{n}²: evolve {evolve:.2}, columns {columns:.2}, rows {rows:.2}; all of it {device:.2}, on the CPU {cpu:.2}"
        )
        .unwrap();
    }
}

//! Sharing out a slice among threads, each with working memory of its own.

/// Tiles below this many samples a side are done before a second thread has woken up.
#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
const SMALLEST_SHARED_TILE: usize = 128;

/// How many workers a tile of `n` samples a side is shared among: with the feature `parallel` the threads of
/// the current rayon pool, otherwise one.
pub(crate) fn thread_count(n: usize) -> usize {
    #[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
    if n >= SMALLEST_SHARED_TILE {
        return rayon::current_num_threads().min(n / 16);
    }
    let _ = n;
    1
}

/// Calls `work(i, run, worker)` for every run of `run_len` items, the i-th run of `items`.
///
/// Each worker gets one contiguous share of the runs. What a run's result is does not depend on which worker
/// it fell to, so it does not depend on their number either.
pub(crate) fn for_each_run<T: Send, W: Send>(
    items: &mut [T],
    run_len: usize,
    workers: &mut [W],
    work: impl Fn(usize, &mut [T], &mut W) + Sync,
) {
    let runs_per_worker = (items.len() / run_len).div_ceil(workers.len());
    let do_share = |(share, (items, worker)): (usize, (&mut [T], &mut W))| {
        for (i, run) in items.chunks_exact_mut(run_len).enumerate() {
            work(share * runs_per_worker + i, run, worker);
        }
    };
    #[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
    if workers.len() > 1 {
        use rayon::prelude::*;
        let shares = items.par_chunks_mut(runs_per_worker * run_len);
        return shares.zip(workers.par_iter_mut()).enumerate().for_each(do_share);
    }
    items.chunks_mut(runs_per_worker * run_len).zip(workers).enumerate().for_each(do_share);
}

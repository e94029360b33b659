//! The adapter that GPU tests share, ours and those of programs that embed the water.

use std::io::Write;
use std::sync::OnceLock;

use super::Gpu;

/// Set by `cargo xtask test`: a machine without an adapter then fails the GPU tests instead of skipping them.
pub const REQUIRE: &str = "WHITECAP_REQUIRE_ADAPTER";

/// The machine's best adapter, opened once per process.
///
/// Where there is none, or only one that lacks what WebGPU asks for, the answer is `None` and the reason
/// stands on standard error, past libtest's capture.
///
/// # Panics
///
/// Without such an adapter, if [`REQUIRE`] is set.
pub fn gpu() -> Option<&'static Gpu> {
    static GPU: OnceLock<Result<Gpu, String>> = OnceLock::new();
    match GPU.get_or_init(open) {
        Ok(gpu) => Some(gpu),
        Err(reason) => {
            assert!(std::env::var_os(REQUIRE).is_none(), "{REQUIRE} is set, and {reason}");
            let _ = writeln!(
                std::io::stderr(),
                "SKIPPED a test that draws: {reason}. `cargo xtask setup` installs a software adapter."
            );
            None
        }
    }
}

fn open() -> Result<Gpu, String> {
    let gpu = Gpu::open(None).map_err(|error| error.to_string())?;
    if gpu.adapter.webgpu_compliant {
        Ok(gpu)
    } else {
        Err(format!("the only adapter, {}, lacks some of what WebGPU asks for", gpu.adapter))
    }
}

//! Who compiles for browsers: the compiler that runs this, if its target is there; else Debian's, which comes with the source
//! of its library.

use crate::{process, setup};
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const TARGET: &str = "wasm32-unknown-unknown";

/// Debian's names for a compiler with its library's source, and for the linker that it needs.
const DEBIAN_PACKAGES: [&str; 4] = ["rustc-web", "cargo-web", "rust-web-src", "lld-19"];

const DEBIAN_COMPILER: &str = "/usr/bin/rustc";
const DEBIAN_CARGO: &str = "/usr/bin/cargo";
const DEBIAN_LINKER: &str = "/usr/bin/wasm-ld-19";

const BY_HAND: &str = "With rustup:      rustup target add wasm32-unknown-unknown
Debian:           sudo apt-get update && sudo apt-get install -y rustc-web cargo-web rust-web-src lld-19";

/// A compiler for browsers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Compiler {
    /// The cargo that runs us; the target's library is installed.
    Own,
    /// Debian's, which builds the library as well. It is another version: nothing native is built with it.
    Debians,
}

impl Compiler {
    /// Finds one, or installs the target or Debian's packages.
    pub(super) fn find_or_install() -> Result<Compiler> {
        process::heading("set-up: a compiler for browsers");
        if let Some(found) = Compiler::find() {
            process::say(&format!("found: {}", found.told()));
            return Ok(found);
        }
        process::say(&format!("The library for {TARGET} is not installed. Trying `rustup target add` ..."));
        let added = process::run(Command::new("rustup").args(["target", "add", TARGET]));
        if let (Ok(()), Some(found)) = (&added, Compiler::find()) {
            return Ok(found);
        }
        if let Err(error) = added {
            process::complain(&format!("{error:#}"));
        }
        setup::install_or_say(&DEBIAN_PACKAGES, BY_HAND)?;
        Compiler::find().with_context(|| {
            format!("the packages are installed, but nothing compiles for {TARGET}. By hand:\n{BY_HAND}")
        })
    }

    fn find() -> Option<Compiler> {
        if own_library().is_some_and(|folder| holds_library(&folder)) {
            return Some(Compiler::Own);
        }
        let has_source = library_source().is_some_and(|folder| folder.join("std/Cargo.toml").is_file());
        let is_there =
            [DEBIAN_COMPILER, DEBIAN_CARGO, DEBIAN_LINKER].iter().all(|path| Path::new(path).exists());
        (has_source && is_there).then_some(Compiler::Debians)
    }

    fn told(self) -> &'static str {
        match self {
            Compiler::Own => "this toolchain's own target",
            Compiler::Debians => "Debian's rustc with its library's source",
        }
    }

    /// Compiles the viewer into `folder` and returns the module.
    pub(super) fn build(self, folder: &Path) -> Result<PathBuf> {
        let mut build = match self {
            Compiler::Own => process::cargo(),
            Compiler::Debians => {
                let mut debians = Command::new(DEBIAN_CARGO);
                debians
                    .env("RUSTC", DEBIAN_COMPILER)
                    .env("RUSTC_BOOTSTRAP", "1")
                    .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", DEBIAN_LINKER)
                    .args(["-Zbuild-std=std,panic_abort"]);
                debians
            }
        };
        build
            // Vectors of four are in every browser that has WebGPU.
            .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-Ctarget-feature=+simd128")
            .args(["build", "--package", "whitecap-web", "--profile", "web", "--target", TARGET])
            .arg("--target-dir")
            .arg(folder);
        process::run(&mut build)?;
        let module = folder.join(TARGET).join("web/whitecap_web.wasm");
        if !module.is_file() {
            bail!("cargo built no {}", module.display());
        }
        Ok(module)
    }
}

/// Where this toolchain has libraries for the target.
fn own_library() -> Option<PathBuf> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    Some(sysroot(Command::new(rustc))?.join("lib/rustlib").join(TARGET).join("lib"))
}

/// Where Debian puts the library's source.
fn library_source() -> Option<PathBuf> {
    Some(sysroot(Command::new(DEBIAN_COMPILER))?.join("lib/rustlib/src/rust/library"))
}

fn sysroot(mut rustc: Command) -> Option<PathBuf> {
    let output = rustc.args(["--print", "sysroot"]).stderr(Stdio::null()).output().ok()?;
    output.status.success().then(|| PathBuf::from(String::from_utf8_lossy(&output.stdout).trim()))
}

fn holds_library(folder: &Path) -> bool {
    let entries = folder.read_dir().into_iter().flatten().flatten();
    entries.map(|entry| entry.file_name()).any(|name| name.to_string_lossy().starts_with("libstd-"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_to_type_names_the_packages_that_we_would_install() {
        assert!(DEBIAN_PACKAGES.iter().all(|package| BY_HAND.contains(package)));
    }

    #[test]
    fn an_empty_folder_holds_no_library() {
        assert!(!holds_library(Path::new(env!("CARGO_MANIFEST_DIR"))));
        assert!(!holds_library(Path::new("/nowhere")));
    }
}

//! `bindings MODULE FOLDER`: the JavaScript that loads a WebAssembly module, made by the library that belongs to the
//! module's own version of wasm-bindgen. Apart from xtask, which a fresh machine compiles first.
//!
//! Then it prints, for each file of the folder, its name, its bytes and its bytes as a server sends them, compressed by gzip.
#![allow(clippy::print_stdout)]

use anyhow::{Context, Result, bail};
use flate2::{Compression, write::GzEncoder};
use std::io::Write;
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, folder] = arguments.as_slice() else { bail!("usage: bindings MODULE FOLDER") };
    Bindgen::new()
        .input_path(module)
        .web(true)?
        .typescript(false)
        .omit_default_module_path(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(folder)
        .with_context(|| format!("no bindings can be made for {module}"))?;
    for entry in Path::new(folder).read_dir()? {
        let path = entry?.path();
        if path.is_file() {
            let bytes = std::fs::read(&path)?;
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            println!("{name} {} {}", bytes.len(), gzipped(&bytes)?);
        }
    }
    Ok(())
}

fn gzipped(bytes: &[u8]) -> std::io::Result<usize> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?.len())
}

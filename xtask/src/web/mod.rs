//! The page: the viewer as WebAssembly, with what is in `web/`, in one folder that any server can serve.

mod compiler;
mod page_test;
mod server;

pub(crate) use page_test::{run as test, test as page_test};

use crate::process;
use anyhow::{Context, Result, bail};
use compiler::Compiler;
use std::path::{Path, PathBuf};

/// What the page is loaded from, compressed as servers send it, may weigh at most so many bytes.
const MOST_GZIPPED: u64 = 1_500_000;

/// What lies in `web/` beside its tests.
const SOURCES: [&str; 4] = ["index.html", "noscript.css", "page.css", "page.js"];

/// The pictures that a browser without WebGPU shows.
const PICTURES: [&str; 2] = ["classics.png", "ocean.png"];

/// The chore: builds the page and says where it is.
pub(crate) fn run() -> Result<()> {
    let folder = build()?;
    process::say(&format!("\nThe page is {}", folder.display()));
    process::say("`cargo xtask web --serve` shows it; any server of static files can.");
    Ok(())
}

/// Builds the page and serves it until somebody stops it.
pub(crate) fn serve() -> Result<()> {
    let folder = build()?;
    let server = server::Server::open(&folder, server::PORT)?;
    process::say(&format!("\nThe page is at {} (Ctrl+C ends)", server.address()));
    server.serve();
    Ok(())
}

/// Builds the page and returns its folder.
fn build() -> Result<PathBuf> {
    let target = process::target_folder()?;
    let compiler = Compiler::find_or_install()?;
    process::heading("build: the viewer as WebAssembly");
    let module = compiler.build(&target.join("wasm"))?;

    process::heading("build: the page");
    let folder = target.join("web");
    if folder.exists() {
        std::fs::remove_dir_all(&folder)
            .with_context(|| format!("cannot make room in {}", folder.display()))?;
    }
    std::fs::create_dir_all(folder.join("pictures"))
        .with_context(|| format!("cannot make the folder {}", folder.display()))?;
    for source in SOURCES {
        copy(&Path::new("web").join(source), &folder.join(source))?;
    }
    for picture in PICTURES {
        copy(&Path::new("docs/images").join(picture), &folder.join("pictures").join(picture))?;
    }
    let mut bindings = process::cargo();
    bindings.args([
        "run",
        "--quiet",
        "--package",
        "xtask",
        "--features",
        "bindings",
        "--bin",
        "bindings",
        "--",
    ]);
    let sizes = Sizes::read(&process::output(bindings.arg(&module).arg(&folder))?)?;
    process::say(&sizes.told());
    if sizes.gzipped() > MOST_GZIPPED {
        bail!("the page weighs {} bytes gzipped; accepted: up to {MOST_GZIPPED}", sizes.gzipped());
    }

    // What has been loaded is shown against this.
    let index = folder.join("index.html");
    let text = std::fs::read_to_string(&index)?;
    let told = text.replacen("data-bytes=\"0\"", &format!("data-bytes=\"{}\"", sizes.module()?), 1);
    if told == text {
        bail!("web/index.html has no place for the module's size");
    }
    std::fs::write(&index, told).with_context(|| format!("cannot write {}", index.display()))?;
    Ok(folder)
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    std::fs::copy(from, to).with_context(|| format!("cannot copy {} to {}", from.display(), to.display()))?;
    Ok(())
}

/// The files that a page is loaded from: names, bytes, and bytes gzipped.
struct Sizes(Vec<(String, u64, u64)>);

impl Sizes {
    fn read(text: &str) -> Result<Sizes> {
        let line = |line: &str| {
            let (rest, gzipped) = line.rsplit_once(' ')?;
            let (name, raw) = rest.rsplit_once(' ')?;
            Some((name.to_owned(), raw.parse().ok()?, gzipped.parse().ok()?))
        };
        let files: Option<Vec<_>> = text.lines().map(line).collect();
        files.map(Sizes).with_context(|| format!("no list of sizes: {text}"))
    }

    fn gzipped(&self) -> u64 {
        self.0.iter().map(|(.., gzipped)| gzipped).sum()
    }

    fn module(&self) -> Result<u64> {
        let module = self.0.iter().find(|(name, ..)| name.ends_with(".wasm"));
        Ok(module.context("the bindings came without a module")?.1)
    }

    fn told(&self) -> String {
        let mut files = self.0.clone();
        files.sort_by_key(|(.., gzipped)| std::cmp::Reverse(*gzipped));
        let row = |name: &str, raw, gzipped| format!("  {name:24} {raw:9} bytes {gzipped:9} gzipped\n");
        let rows: String = files.iter().map(|(name, raw, gzipped)| row(name, *raw, *gzipped)).collect();
        let sum = row("together", files.iter().map(|(_, raw, _)| raw).sum(), self.gzipped());
        format!("{rows}{sum}  at most {:32} gzipped", MOST_GZIPPED)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_summed_and_a_list_that_is_none_is_refused() {
        let sizes = Sizes::read("page.js 100 40\na_bg.wasm 3000000 900000\n").unwrap();
        assert_eq!((sizes.gzipped(), sizes.module().unwrap()), (900_040, 3_000_000));
        assert!(sizes.told().contains("a_bg.wasm") && sizes.told().contains("900040"));
        assert!(Sizes::read("error: no module").is_err());
        assert!(Sizes::read("page.js 1 1").unwrap().module().is_err());
    }

    #[test]
    fn every_source_and_picture_is_there() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        assert!(SOURCES.iter().all(|source| root.join("web").join(source).is_file()));
        assert!(PICTURES.iter().all(|picture| root.join("docs/images").join(picture).is_file()));
    }
}

//! The page in a real browser: `web/tests/page.mjs` drives it.

use super::server::Server;
use crate::{process, setup};
use anyhow::{Context, Result, bail};
use std::path::Path;
use std::process::Command;

/// Debian's names for a browser, and for what runs the test.
const DEBIAN_PACKAGES: [&str; 3] = ["chromium", "nodejs", "npm"];

const BY_HAND: &str = "Install Chromium, Node.js 18 or newer and npm by hand, and name another browser's program in \
                       CHROMIUM. Debian: sudo apt-get update && sudo apt-get install -y chromium nodejs npm";

/// The browsers' names.
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/// Builds the page and tests it.
pub(crate) fn run() -> Result<()> {
    if test(&mut |_| {})? { Ok(()) } else { bail!("the page does not pass its tests") }
}

/// Builds the page, tests it, and shows each line of the tests to `see`. The result is whether they passed.
pub(crate) fn test(see: &mut dyn FnMut(&str)) -> Result<bool> {
    let folder = super::build()?;
    let browser = ensure_browser()?;
    let modules = process::target_folder()?.join("web-tests");
    std::fs::create_dir_all(&modules)
        .with_context(|| format!("cannot make the folder {}", modules.display()))?;
    for file in ["package.json", "package-lock.json", "page.mjs", "png.mjs"] {
        super::copy(&Path::new("web/tests").join(file), &modules.join(file))?;
    }
    let mut install = Command::new("npm");
    install.args(["ci", "--no-audit", "--no-fund", "--loglevel=error"]).current_dir(&modules);
    setup::twice(|| process::run(&mut install)).context("the browser's driver could not be fetched")?;

    process::heading("the page in a browser");
    let server = Server::open(&folder, 0)?;
    let address = server.address();
    server.serve_aside();
    let mut test = Command::new("node");
    test.arg("page.mjs").arg(address).arg(browser).current_dir(&modules);
    process::watch(&mut test, see)
}

/// Finds a browser and what drives it, or installs them, and returns the browser's program.
fn ensure_browser() -> Result<String> {
    process::heading("set-up: a browser");
    if let Some(found) = browser_with_node() {
        process::say(&format!("found: {found}"));
        return Ok(found);
    }
    let missing = |program: &&str| !answers(program);
    let packages: Vec<&str> = DEBIAN_PACKAGES
        .into_iter()
        .filter(|package| match *package {
            "chromium" => browser().is_none(),
            "nodejs" => missing(&"node"),
            other => missing(&other),
        })
        .collect();
    setup::install_or_say(&packages, BY_HAND)?;
    browser_with_node().context("the browser is installed, but it or node or npm does not answer")
}

fn browser_with_node() -> Option<String> {
    browser().filter(|_| answers("node") && answers("npm"))
}

fn browser() -> Option<String> {
    let named = std::env::var("CHROMIUM").ok();
    named.into_iter().chain(BROWSERS.map(str::to_owned)).find(|program| answers(program)).and_then(
        |program| {
            // Whole paths alone can be started by the driver.
            let found = Command::new("sh").args(["-c", "command -v \"$0\"", &program]).output().ok()?;
            Some(String::from_utf8_lossy(&found.stdout).trim().to_owned()).filter(|path| !path.is_empty())
        },
    )
}

fn answers(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

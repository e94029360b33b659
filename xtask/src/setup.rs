//! What has to be on the machine before anything is drawn: one adapter that can do what WebGPU asks for.
//!
//! The product itself is asked what it finds. Only if that is nothing is something installed, after saying
//! so; where we cannot install, the user gets the exact line to type.

use crate::{process, product};
use anyhow::{Context, Result, bail};
use serde_json::Value;
use std::io::IsTerminal;
use std::path::Path;
use std::process::{Command, Stdio};

/// Debian's names for the Vulkan loader and Mesa's drivers, a software one among them.
const DEBIAN_PACKAGES: [&str; 2] = ["libvulkan1", "mesa-vulkan-drivers"];

/// Debian's names for a screen in memory, and for what a window on one loads when it opens.
const SCREEN_PACKAGES: [&str; 7] =
    ["xvfb", "libx11-6", "libx11-xcb1", "libxcursor1", "libxi6", "libxkbcommon0", "libxkbcommon-x11-0"];

const BY_HAND: &str =
    "Debian, Ubuntu:  sudo apt-get update && sudo apt-get install -y libvulkan1 mesa-vulkan-drivers
Fedora:          sudo dnf install -y vulkan-loader mesa-vulkan-drivers
Arch:            sudo pacman -S --needed vulkan-icd-loader vulkan-swrast
Homebrew:        brew install vulkan-loader mesa";

/// The chore: builds the command and sees to it that it finds an adapter.
pub(crate) fn run() -> Result<()> {
    ensure_adapter(&product::build_release()?)
}

/// Returns once `whitecap` finds a WebGPU-compliant adapter, having installed a driver if need be.
///
/// OpenGL alone does not count: it lacks formats that the techniques use.
pub(crate) fn ensure_adapter(whitecap: &Path) -> Result<()> {
    process::heading("set-up: an adapter to draw with");
    if let Some(name) = compliant_adapter(whitecap)? {
        process::say(&format!("found: {name}"));
        return Ok(());
    }
    process::say("There is no Vulkan, Metal or Direct3D 12 adapter on this machine, and whitecap needs one.");
    process::say("Mesa's drivers bring a software adapter, which works without a graphics card.");
    match way_to_install() {
        Way::Apt { sudo } => install(sudo, &DEBIAN_PACKAGES)
            .with_context(|| format!("the driver could not be installed. By hand:\n{BY_HAND}\nThe cause"))?,
        Way::ByHand { reason } => bail!("{reason}. Install a driver by hand, then try again:\n{BY_HAND}"),
    }
    match compliant_adapter(whitecap)? {
        Some(name) => process::say(&format!("found: {name}")),
        None => bail!("the driver is installed, but whitecap still finds no adapter{}", hidden_drivers()),
    }
    Ok(())
}

/// The first adapter that can do all that WebGPU asks for: the one that `render` takes by default.
fn compliant_adapter(whitecap: &Path) -> Result<Option<String>> {
    Ok(first_compliant(&product::ask(&mut product::command(whitecap, &["adapters"]))?))
}

fn first_compliant(adapters: &Value) -> Option<String> {
    let adapter = adapters.as_array()?.iter().find(|adapter| adapter["webgpu_compliant"] == true)?;
    let word = |key: &str| adapter[key].as_str().unwrap_or("?").to_owned();
    Some(format!("{} ({}, {})", word("name"), word("backend"), word("driver")))
}

/// How a driver can come onto this machine.
#[derive(Debug, PartialEq, Eq)]
enum Way {
    Apt { sudo: bool },
    ByHand { reason: &'static str },
}

/// What decides the way.
struct Machine {
    has_apt: bool,
    is_root: bool,
    /// `sudo` works, with or without a password that somebody is there to type.
    has_sudo: bool,
}

fn way_to_install() -> Way {
    let succeeds = |program: &str, arguments: &[&str]| {
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    let somebody_is_there = std::io::stdin().is_terminal() && std::io::stderr().is_terminal();
    Machine {
        has_apt: cfg!(target_os = "linux") && succeeds("apt-get", &["--version"]),
        is_root: is_root(),
        has_sudo: succeeds("sudo", &["-n", "true"])
            || (somebody_is_there && succeeds("sudo", &["--version"])),
    }
    .way()
}

impl Machine {
    fn way(&self) -> Way {
        match self {
            Machine { has_apt: false, .. } => Way::ByHand { reason: "apt-get is not here to install one" },
            Machine { is_root: true, .. } => Way::Apt { sudo: false },
            Machine { has_sudo: true, .. } => Way::Apt { sudo: true },
            _ => Way::ByHand { reason: "installing one takes root's rights, and sudo does not grant them" },
        }
    }
}

/// Whether we are root, asked without C: `id` is on every system that has apt.
fn is_root() -> bool {
    Command::new("id").arg("-u").output().is_ok_and(|id| id.stdout.trim_ascii() == b"0")
}

/// Returns once windows can be tested: on Linux, with a screen in memory and the libraries that a window loads.
pub(crate) fn ensure_screen() -> Result<()> {
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    process::heading("set-up: a screen in memory");
    let output = |program: &str, argument: &str| Command::new(program).arg(argument).output();
    let libraries = output("ldconfig", "-p").map(|found| String::from_utf8_lossy(&found.stdout).into_owned());
    let has_libraries = libraries.is_ok_and(|list| {
        ["libX11-xcb.so.1", "libXcursor.so.1", "libXi.so.6", "libxkbcommon-x11.so.0"]
            .iter()
            .all(|name| list.contains(name))
    });
    if has_libraries && output("Xvfb", "-help").is_ok() {
        process::say("found: Xvfb");
        return Ok(());
    }
    install_or_say(&SCREEN_PACKAGES, &format!("Install by hand: {}", SCREEN_PACKAGES.join(" ")))
}

/// Installs packages where that can be done; elsewhere says `by_hand`, what there is to do instead.
pub(crate) fn install_or_say(packages: &[&str], by_hand: &str) -> Result<()> {
    match way_to_install() {
        Way::Apt { sudo } => install(sudo, packages)
            .with_context(|| format!("{} could not be installed. {by_hand}\nThe cause", packages.join(", "))),
        Way::ByHand { reason } => bail!("{reason}. {by_hand}"),
    }
}

fn install(sudo: bool, packages: &[&str]) -> Result<()> {
    let names = packages.join(", ");
    let through = if sudo { " (through sudo)" } else { "" };
    process::say(&format!("Installing {names} with apt-get{through} ..."));
    let apt = |arguments: &[&str]| {
        let mut command = Command::new(if sudo { "sudo" } else { "apt-get" });
        if sudo {
            command.args(["env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]);
        }
        command.env("DEBIAN_FRONTEND", "noninteractive").args(arguments);
        command
    };
    twice(|| process::run(&mut apt(&["update"]))).context("the list of packages could not be fetched")?;
    let install = ["install", "-y", "--no-install-recommends"];
    twice(|| process::run(apt(&install).args(packages)))
}

/// Mirrors fail now and then, half-way; a second try nearly always helps.
pub(crate) fn twice(mut attempt: impl FnMut() -> Result<()>) -> Result<()> {
    attempt().or_else(|error| {
        process::complain(&format!("{error:#}; trying once more"));
        attempt()
    })
}

/// A word about variables that keep the Vulkan loader from its drivers.
fn hidden_drivers() -> String {
    ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"]
        .into_iter()
        .filter_map(|name| Some(format!("; {name} is set to {:?}", std::env::var_os(name)?)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opengl_alone_counts_as_nothing() {
        let gl =
            serde_json::json!({ "name": "a", "backend": "gl", "driver": "x", "webgpu_compliant": false });
        let vulkan =
            serde_json::json!({ "name": "b", "backend": "vulkan", "driver": "y", "webgpu_compliant": true });
        assert_eq!(first_compliant(&serde_json::json!([])), None);
        assert_eq!(first_compliant(&serde_json::json!([gl])), None);
        assert_eq!(first_compliant(&serde_json::json!([gl, vulkan])).as_deref(), Some("b (vulkan, y)"));
    }

    #[test]
    fn nothing_is_installed_without_apt_and_the_right_to_use_it() {
        let way = |has_apt, is_root, has_sudo| Machine { has_apt, is_root, has_sudo }.way();
        assert_eq!(way(true, true, false), Way::Apt { sudo: false });
        assert_eq!(way(true, true, true), Way::Apt { sudo: false });
        assert_eq!(way(true, false, true), Way::Apt { sudo: true });
        assert!(matches!(way(true, false, false), Way::ByHand { .. }));
        assert!(matches!(way(false, true, true), Way::ByHand { .. }));
    }

    #[test]
    fn what_fails_once_is_tried_once_more() {
        let mut attempts = 0;
        let mut fail_before = |success: i32| {
            attempts = 0;
            let result = twice(|| {
                attempts += 1;
                if attempts < success { bail!("mirror away") } else { Ok(()) }
            });
            (attempts, result.is_ok())
        };
        assert_eq!(fail_before(1), (1, true));
        assert_eq!(fail_before(2), (2, true));
        assert_eq!(fail_before(3), (2, false));
    }

    #[test]
    fn the_line_to_type_names_the_packages_that_we_would_install() {
        assert!(DEBIAN_PACKAGES.iter().all(|package| BY_HAND.contains(package)));
    }
}

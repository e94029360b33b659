//! The parts of the documentation that are made, not written: the list of scene keys and the picture.

use crate::{process, product, setup};
use anyhow::{Context, Result};

const PICTURE: &str = "docs/images/meshuggah.png";

pub(crate) fn run() -> Result<()> {
    process::heading("scene keys");
    let mut test = process::cargo();
    test.args(["test", "--workspace", "--test", "scene_reference"]);
    process::run(test.env("WHITECAP_UPDATE_DOCS", "1"))?;

    let whitecap = product::build_release()?;
    setup::ensure_adapter(&whitecap)?;
    process::heading("picture");
    std::fs::create_dir_all("docs/images").context("cannot make the folder docs/images")?;
    product::ask(&mut product::command(&whitecap, &["render", "meshuggah", "-o", PICTURE]))?;
    process::say(&format!("{PICTURE} and docs/scene-files.md are new. Look at both before you commit them."));
    Ok(())
}

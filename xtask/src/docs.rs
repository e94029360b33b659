//! The parts of the documentation that are made, not written: the list of scene keys, what is measured, the
//! pictures.

use crate::{process, product, setup};
use anyhow::{Context, Result};
use std::path::Path;

pub(crate) fn run() -> Result<()> {
    process::heading("scene keys, accuracies, keys and what commands print");
    // Each is a test that writes what it would compare.
    for arguments in [
        &["--test", "scene_reference", "--test", "accuracy"][..],
        &["--test", "command", "--", "docs::"],
        &["--test", "view", "--", "keys::"],
    ] {
        let mut test = process::cargo();
        test.args(["test", "--workspace"]).args(arguments);
        process::run(test.env("WHITECAP_UPDATE_DOCS", "1"))?;
    }

    let whitecap = product::build_release()?;
    setup::ensure_adapter(&whitecap)?;
    process::heading("pictures");
    std::fs::create_dir_all("docs/images").context("cannot make the folder docs/images")?;
    let scenes = product::ask(&mut product::command(&whitecap, &["scenes"]))?;
    let names = scenes.as_array().map_or(&[][..], Vec::as_slice);
    let text = pages()?;
    for name in names.iter().filter_map(|scene| scene["name"].as_str()) {
        let picture = picture_of(name);
        if is_shown(&text, &picture) {
            let path = Path::new("docs").join(&picture);
            let path = path.to_string_lossy();
            product::ask(&mut product::command(&whitecap, &["render", name, "-o", &path]))?;
            process::say(&path);
        }
    }
    for (sheet, scenes) in SHEETS {
        contact_sheet(&whitecap, sheet, scenes)?;
    }
    const CHART: &str = "docs/images/spectrum.png";
    product::ask(&mut product::command(&whitecap, &["spectrum", "spectral-ocean", "-o", CHART]))?;
    process::say(CHART);
    process::say(
        "These pictures, docs/scene-files.md, docs/accuracy.md and what pages show as printed are new. Look at all of \
         them before you commit them.",
    );
    Ok(())
}

/// The contact sheets that the README shows: our ocean's scenes, and one or two of each classic technique.
const SHEETS: [(&str, &[&str]); 2] = [
    (
        "docs/images/ocean.png",
        &[
            "spectral-ocean",
            "spectral-ocean-storm",
            "spectral-ocean-swell",
            "spectral-ocean-shallow",
            "spectral-ocean-dawn",
            "spectral-ocean-crossing",
            "spectral-ocean-tropical",
            "spectral-ocean-aircraft",
            "spectral-ocean-buoy",
        ],
    ),
    (
        "docs/images/classics.png",
        &["ocean-water", "ocean-water-shore", "rippling-lake", "projected-grid", "meshuggah", "five-sample"],
    ),
];

/// Writes the contact sheet of `scenes` into the file `sheet`.
fn contact_sheet(whitecap: &Path, sheet: &str, scenes: &[&str]) -> Result<()> {
    let folder = Path::new("out").join("sheet-for-docs");
    std::fs::create_dir_all("out").context("cannot make the folder out")?;
    let folder_name = folder.to_string_lossy();
    let arguments = [&["gallery", "-o", &folder_name, "--size", "640x360", "--runs", "0"], scenes].concat();
    product::ask(&mut product::command(whitecap, &arguments))?;
    std::fs::copy(folder.join("contact-sheet.png"), sheet)
        .with_context(|| format!("cannot write {sheet}"))?;
    process::say(sheet);
    Ok(())
}

/// The text of every page in docs/.
fn pages() -> Result<String> {
    let mut text = String::new();
    for entry in std::fs::read_dir("docs").context("cannot read the folder docs")? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "md") {
            text +=
                &std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        }
    }
    Ok(text)
}

/// The picture of the scene called `name`, as a page in docs/ refers to it.
fn picture_of(name: &str) -> String {
    format!("images/{name}.png")
}

/// Whether a page points to `picture`.
fn is_shown(pages: &str, picture: &str) -> bool {
    pages.contains(&format!("({picture})")) || pages.contains(&format!("\"{picture}\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_made_where_a_page_shows_it() {
        let pages = "![a sea](images/sea.png) and <img src=\"images/lake.png\"> but images/pond.png";
        assert!(is_shown(pages, &picture_of("sea")) && is_shown(pages, &picture_of("lake")));
        assert!(!is_shown(pages, &picture_of("pond")) && !is_shown(pages, &picture_of("ea")));
    }
}

//! What pages of documentation show as printed is what the command prints.

use crate::{stdout, whitecap};
use whitecap_tests::repository::{Page, alike, pages, updates};

const FENCE: &str = "```console\n$ whitecap ";

/// The page with what its console blocks print, for the scene that a page shows as `sea.toml`.
fn printed(page: &Page, scene: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("sea.toml"), scene).unwrap();
    let mut parts = page.text.split(FENCE);
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (command, rest) = part.split_once('\n').unwrap();
        let (_, after) = rest.split_once("```").unwrap();
        let output = stdout(&whitecap(folder.path()).args(command.split_whitespace()).assert().success());
        let lines: String = output.lines().map(|line| format!("{}\n", line.trim_end())).collect();
        text += &format!("{FENCE}{command}\n{lines}```{after}");
    }
    text
}

#[test]
fn console_blocks_show_what_is_printed() {
    let pages = pages().unwrap();
    let spectra = pages.iter().find(|page| page.path.ends_with("docs/spectra.md")).unwrap();
    let scene = &spectra.blocks("toml")[0];
    let mut blocks = 0;
    for page in pages.iter().filter(|page| page.text.contains(FENCE)) {
        let expected = printed(page, scene);
        if updates() {
            std::fs::write(&page.path, &expected).unwrap();
        } else {
            let path = page.path.display();
            assert!(
                alike(&page.text, &expected),
                "{path} does not show what is printed; run `cargo xtask docs`"
            );
        }
        blocks += expected.matches(FENCE).count();
    }
    assert!(blocks >= 2, "the documentation shows nothing that is printed");
}

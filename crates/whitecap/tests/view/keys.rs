//! `docs/viewer.md` lists the keys that the window knows.

use whitecap_tests::repository::{root, updates};
use whitecap_viewer::actions;

const HEAD: &str = "| key | what it does |\n";

#[test]
fn the_page_lists_the_keys_of_the_window() {
    let path = root().join("docs/viewer.md");
    let page = std::fs::read_to_string(&path).unwrap();
    let start = page.find(HEAD).expect("the page has a table of keys");
    let end = page[start..].find("\n\n").map_or(page.len(), |end| start + end + 1);
    let expected = format!("{}{}{}", &page[..start], actions::markdown(), &page[end..]);
    if updates() {
        std::fs::write(&path, &expected).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap();
    assert!(found == expected, "docs/viewer.md has other keys than the window; run `cargo xtask docs`");
}

//! The files that the documentation speaks of.

use std::path::{Path, PathBuf};

/// The repository's root.
pub fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).unwrap_or(here)
}

/// A page of documentation.
#[derive(Clone, Debug)]
pub struct Page {
    /// Its file.
    pub path: PathBuf,
    /// What it says.
    pub text: String,
}

/// The pages that users read: `README.md`, `CONTRIBUTING.md` and those in `docs/`.
///
/// # Errors
///
/// If one of them cannot be read.
pub fn pages() -> std::io::Result<Vec<Page>> {
    let mut paths = vec![root().join("README.md")];
    paths.extend(Some(root().join("CONTRIBUTING.md")).filter(|path| path.exists()));
    if let Ok(entries) = root().join("docs").read_dir() {
        let is_page = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "md");
        paths.extend(entries.flatten().map(|entry| entry.path()).filter(is_page));
    }
    paths.sort();
    paths.into_iter().map(|path| Ok(Page { text: std::fs::read_to_string(&path)?, path })).collect()
}

impl Page {
    /// The contents of the blocks fenced as `language`, in order.
    pub fn blocks(&self, language: &str) -> Vec<String> {
        let mut blocks = Vec::new();
        let mut lines = self.text.lines();
        while let Some(line) = lines.next() {
            if let Some(found) = line.trim_start().strip_prefix("```") {
                let block: Vec<&str> =
                    lines.by_ref().take_while(|line| !line.trim_start().starts_with("```")).collect();
                if found.trim() == language {
                    blocks.push(block.join("\n"));
                }
            }
        }
        blocks
    }

    /// What links and pictures point to: `[words](target)` and `src="target"` or `href="target"`.
    pub fn targets(&self) -> Vec<&str> {
        let between = |open: &'static str, close: char| {
            self.text.split(open).skip(1).filter_map(move |rest| Some(rest.split_once(close)?.0))
        };
        let markdown = between("](", ')').filter_map(|target| target.split_whitespace().next());
        markdown.chain(between("src=\"", '"')).chain(between("href=\"", '"')).collect()
    }

    /// What stands between single backticks, outside of fenced blocks.
    pub fn code_spans(&self) -> Vec<&str> {
        let prose = self.text.split("```").step_by(2);
        prose.flat_map(|part| part.split('`').skip(1).step_by(2)).collect()
    }
}

/// Whether two texts say the same but for blanks and for the last digit of what was rounded: a page is no more alike from
/// one machine to another.
pub fn alike(found: &str, expected: &str) -> bool {
    let found: Vec<&str> = found.split_whitespace().collect();
    let expected: Vec<&str> = expected.split_whitespace().collect();
    let same = |(a, b): (&&str, &&str)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(x), Ok(y)) => {
            let decimals = |text: &str| text.split_once('.').map_or(0, |(_, after)| after.len() as i32);
            let last = 10.0_f64.powi(-decimals(a).min(decimals(b)));
            (x - y).abs() < 1.5 * last
        }
        _ => a == b,
    };
    found.len() == expected.len() && found.iter().zip(&expected).all(same)
}

/// Whether `cargo xtask docs` is at work: what is made is written instead of compared.
pub fn updates() -> bool {
    std::env::var_os("WHITECAP_UPDATE_DOCS").is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_last_digit_may_differ() {
        assert!(alike("| 0.31 mm |", "| 0.32 mm |") && alike("| 0.099 |", "| 0.10 |"));
        assert!(!alike("| 0.31 mm |", "| 0.34 mm |") && !alike("| 0.31 mm |", "| 0.31 m |"));
        assert!(!alike("| 1 |", "| 1 | 2 |"));
    }

    fn page(text: &str) -> Page {
        Page { path: "page.md".into(), text: text.into() }
    }

    #[test]
    fn blocks_are_told_by_their_language() {
        let page = page("a\n```sh\none\ntwo\n```\nb\n```toml\nx = 1\n```\n```sh\nthree\n```\n");
        assert_eq!(page.blocks("sh"), ["one\ntwo", "three"]);
        assert_eq!(page.blocks("toml"), ["x = 1"]);
    }

    #[test]
    fn targets_are_found_in_links_pictures_and_html() {
        let page = page("[a](b.md#c) ![d](e.png \"f\") <img src=\"g.png\"> <a href=\"h\">i</a>");
        assert_eq!(page.targets(), ["b.md#c", "e.png", "g.png", "h"]);
    }

    #[test]
    fn code_spans_are_those_of_the_prose() {
        assert_eq!(page("`a` b `c`\n```sh\n`d`\n```\n`e`").code_spans(), ["a", "c", "e"]);
    }
}

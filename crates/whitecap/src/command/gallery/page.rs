//! The page: one file that needs nothing but the pictures beside it.

use super::super::options::Size;
use super::{CONTACT_SHEET, Exhibit};
use std::fmt::Write;
use whitecap_render::PassTime;
use whitecap_scene::reference::Difference;

/// What holds for every scene of the page.
pub(super) struct Setting {
    pub(super) adapter: String,
    pub(super) time_s: f64,
    pub(super) timing_size: Size,
    pub(super) runs: u16,
}

const STYLE: &str = "\
:root { color-scheme: light dark; --ink: #1c2126; --ground: #f7f8f9; --faint: #5b6570; --line: #d5dade; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e2e6eb; --ground: #181b20; --faint: #98a2ad; --line: #343b43; }
}
body { margin: 0 auto; max-width: 76rem; padding: 1rem; color: var(--ink); background: var(--ground);
  font: 1rem/1.5 system-ui, sans-serif; }
article { margin: 2.5rem 0; padding-top: 1.5rem; border-top: 1px solid var(--line); }
h2 { margin: 0; font-size: 1.3rem; }
article > p { margin: 0.2rem 0 0.8rem; }
.faint, cite { color: var(--faint); font-style: normal; }
.parts { display: flex; flex-wrap: wrap; gap: 1.5rem; }
.parts > a { flex: 3 1 24rem; }
.parts > div { flex: 2 1 18rem; min-width: 0; }
img { display: block; max-width: 100%; height: auto; }
table { border-collapse: collapse; width: 100%; margin-bottom: 1rem; font-size: 0.9rem; }
caption { text-align: left; font-weight: 600; }
th, td { padding: 0.15rem 0.6rem 0.15rem 0; text-align: left; vertical-align: top; border-top: 1px solid var(--line);
  overflow-wrap: anywhere; }
.ms { text-align: right; font-variant-numeric: tabular-nums; }
pre { overflow-x: auto; padding: 0.8rem; border: 1px solid var(--line); font-size: 0.85rem; }
";

/// The page of the gallery.
pub(super) fn html(exhibits: &[Exhibit], setting: &Setting) -> String {
    let mut page = String::new();
    // Writing to a string cannot fail.
    let _ = write!(
        page,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>whitecap: the gallery</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>whitecap: the gallery</h1>\n<p>{}. <a href=\"{CONTACT_SHEET}\">All on one sheet</a></p>\n<ul>\n",
        escaped(&setting.sentence(exhibits.len()))
    );
    for Exhibit { named, .. } in exhibits {
        let (name, title) = (escaped(named.name), escaped(named.title));
        let _ = writeln!(page, "<li><a href=\"#{name}\">{name}</a>: {title}</li>");
    }
    page.push_str("</ul>\n");
    for exhibit in exhibits {
        page.push_str(&article(exhibit, setting));
    }
    page.push_str("</body>\n</html>\n");
    page
}

impl Setting {
    fn sentence(&self, count: usize) -> String {
        let Size { width, height } = self.timing_size;
        let timing = match self.runs {
            0 => String::new(),
            runs => format!("; passes timed at {width} × {height} pixels, median of {runs}"),
        };
        let scenes = if count == 1 { "scene" } else { "scenes" };
        format!("{count} {scenes} at {} s, drawn on {}{timing}", self.time_s, self.adapter)
    }
}

fn article(exhibit: &Exhibit, setting: &Setting) -> String {
    let Exhibit { named, scene, picture, passes, sum_ms, differences } = exhibit;
    let (name, title, file) = (escaped(named.name), escaped(named.title), escaped(&exhibit.file_name()));
    let mut text = format!(
        "<article id=\"{name}\">\n<h2>{title}</h2>\n\
         <p><code>{name}</code> <span class=\"faint\">follows</span> <cite>{}</cite></p>\n\
         <div class=\"parts\">\n\
         <a href=\"{file}\"><img src=\"{file}\" width=\"{}\" height=\"{}\" alt=\"{title}\"></a>\n<div>\n",
        escaped(scene.technique.source()),
        picture.width,
        picture.height
    );
    if setting.runs > 0 {
        text += &times(passes, *sum_ms);
    }
    text += &changes(differences);
    let notes = scene.technique.differs();
    if !notes.is_empty() {
        text.push_str("<p>Whatever the settings, other than the text:</p>\n<ul>\n");
        for note in notes {
            let _ = writeln!(text, "<li>{}</li>", escaped(note));
        }
        text.push_str("</ul>\n");
    }
    let _ = write!(
        text,
        "</div>\n</div>\n<details>\n<summary>The scene file</summary>\n<pre><code>{}</code></pre>\n</details>\n\
         </article>\n",
        escaped(named.toml)
    );
    text
}

fn times(passes: &[PassTime], sum_ms: f64) -> String {
    let row = |name: &str, ms: f64| {
        format!("<tr><th>{}</th><td class=\"ms\">{ms:.2} ms</td></tr>\n", escaped(name))
    };
    let rows: String = passes.iter().map(|PassTime { name, ms }| row(name, *ms)).collect();
    format!("<table>\n<caption>Passes</caption>\n{rows}{}</table>\n", row("sum", sum_ms))
}

fn changes(differences: &[Difference]) -> String {
    if differences.is_empty() {
        return "<p>All settings of technique and sea are the defaults.</p>\n".to_owned();
    }
    let row = |Difference { key, value, default }: &Difference| {
        let (key, value, default) = (escaped(key), escaped(value), escaped(default));
        format!("<tr><td><code>{key}</code></td><td>{value}</td><td>{default}</td></tr>\n")
    };
    let rows: String = differences.iter().map(row).collect();
    format!(
        "<table>\n<caption>Settings that differ</caption>\n\
         <tr><th>setting</th><th>here</th><th>by default</th></tr>\n{rows}</table>\n"
    )
}

/// `text` as it reads in HTML, in an attribute too.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;
    use whitecap_render::picture::Picture;
    use whitecap_scene::named::NamedScene;

    const HOSTILE: NamedScene = NamedScene {
        name: "storm",
        title: "\"Fish & <chips>\"",
        toml: "# </pre><script>alert('sea')</script> & more\n",
    };

    fn page(runs: u16) -> String {
        let exhibit = Exhibit {
            named: &HOSTILE,
            scene: whitecap_scene::open("meshuggah").unwrap(),
            picture: Picture { width: 2, height: 1, rgba8: vec![0; 8] },
            passes: vec![PassTime { name: "water", ms: 12.345 }],
            sum_ms: 12.345,
            differences: vec![Difference {
                key: "sea.choppiness".into(),
                value: "<2.0>".into(),
                default: "1.0".into(),
            }],
        };
        let timing_size = Size { width: 1280, height: 720 };
        html(&[exhibit], &Setting { adapter: "a <card>".into(), time_s: 1.5, timing_size, runs })
    }

    #[test]
    fn whatever_a_scene_says_is_text_on_the_page() {
        let page = page(3);
        for foreign in ["<script", "</pre><", "<chips>", "<2.0>", "<card>"] {
            assert!(!page.contains(foreign), "{foreign}");
        }
        assert!(page.contains("&lt;script&gt;alert(&#39;sea&#39;)&lt;/script&gt; &amp; more"));
        assert!(page.contains("alt=\"&quot;Fish &amp; &lt;chips&gt;&quot;\""));
    }

    #[test]
    fn the_page_shows_everything_about_a_scene_and_fetches_nothing_from_elsewhere() {
        let page = page(3);
        for expected in [
            "src=\"storm.png\"",
            "Carsten Wenzel",
            "<code>sea.choppiness</code>",
            "12.35 ms",
            "<details>",
            "1280 × 720",
            "at 1.5 s",
            "contact-sheet.png",
            "prefers-color-scheme: dark",
        ] {
            assert!(page.contains(expected), "{expected} is missing from:\n{page}");
        }
        assert!(!page.contains("http") && !page.contains("<link") && !page.contains("@import"));
    }

    #[test]
    fn elements_close_in_order() {
        let page = page(3);
        let mut open = Vec::new();
        for tag in page.split('<').skip(1).filter_map(|rest| rest.split_once('>')).map(|(tag, _)| tag) {
            let name = tag.trim_start_matches('/').split_whitespace().next().unwrap();
            if ["!doctype", "meta", "img"].contains(&name) {
                continue;
            }
            if tag.starts_with('/') {
                assert_eq!(open.pop(), Some(name), "</{name}>");
            } else {
                open.push(name);
            }
        }
        assert!(open.is_empty(), "{open:?}");
    }

    #[test]
    fn times_that_were_not_taken_are_not_shown() {
        assert!(!page(0).contains("Passes") && !page(0).contains("1280"));
    }
}

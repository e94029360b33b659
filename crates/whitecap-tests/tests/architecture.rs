//! Who may know whom, and whose licence we can live with, from the dependency graph that cargo resolves.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;
use whitecap_tests::repository::root;

/// For each crate: the whitecap crates that it may use, and others that must not even be among its
/// dependencies' dependencies.
const RULES: &[(&str, &[&str], &[&str])] = &[
    ("whitecap-waves", &[], &["wgpu", "naga", "clap", "toml", "serde", "image", "pollster", "getrandom"]),
    ("whitecap-scene", &["whitecap-waves"], &["wgpu", "naga", "clap", "anyhow"]),
    ("whitecap-render", &["whitecap-waves", "whitecap-scene"], &["clap", "anyhow", "indicatif"]),
    ("whitecap-viewer", &["whitecap-waves", "whitecap-scene", "whitecap-render"], &["clap", "anyhow"]),
    (
        "whitecap-web",
        &["whitecap-waves", "whitecap-scene", "whitecap-render", "whitecap-viewer"],
        &["clap", "anyhow"],
    ),
    ("whitecap", &["whitecap-waves", "whitecap-scene", "whitecap-render", "whitecap-viewer"], &[]),
    ("whitecap-tests", &["whitecap-waves", "whitecap-scene", "whitecap-render"], &["clap"]),
    ("xtask", &[], &["clap", "wgpu"]),
];

fn metadata() -> Value {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--all-features"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn text<'v>(value: &'v Value, key: &str) -> &'v str {
    value[key].as_str().unwrap_or_default()
}

/// The resolved graph: names by package id, and the ids of what each package uses at run time.
struct Graph {
    name: BTreeMap<String, String>,
    uses: BTreeMap<String, Vec<String>>,
}

impl Graph {
    fn read(metadata: &Value) -> Self {
        let packages = metadata["packages"].as_array().unwrap();
        let nodes = metadata["resolve"]["nodes"].as_array().unwrap();
        let at_run_time =
            |dep: &&Value| dep["dep_kinds"].as_array().unwrap().iter().any(|k| k["kind"].is_null());
        let uses = |node: &Value| {
            let deps = node["deps"].as_array().unwrap().iter().filter(at_run_time);
            deps.map(|dep| text(dep, "pkg").to_owned()).collect()
        };
        Graph {
            name: packages.iter().map(|p| (text(p, "id").to_owned(), text(p, "name").to_owned())).collect(),
            uses: nodes.iter().map(|node| (text(node, "id").to_owned(), uses(node))).collect(),
        }
    }

    /// Everything that `id` needs at run time, however far away.
    fn needs(&self, id: &str) -> BTreeSet<&str> {
        let mut seen = BTreeSet::new();
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            for used in &self.uses[id] {
                if seen.insert(used.as_str()) {
                    open.push(used);
                }
            }
        }
        seen.into_iter().map(|id| self.name[id].as_str()).collect()
    }
}

#[test]
fn the_arrows_between_the_crates_point_one_way() {
    let metadata = metadata();
    let graph = Graph::read(&metadata);
    let members: Vec<&str> =
        metadata["workspace_members"].as_array().unwrap().iter().map(|id| id.as_str().unwrap()).collect();
    let ours: BTreeSet<&str> = members.iter().map(|id| graph.name[*id].as_str()).collect();
    let ruled: BTreeSet<&str> = RULES.iter().map(|(name, ..)| *name).collect();
    assert_eq!(ours, ruled, "a crate without a rule, or a rule without a crate");

    for id in members {
        let name = graph.name[id].as_str();
        let (_, allowed, banned) = RULES.iter().find(|(ruled, ..)| *ruled == name).unwrap();
        for needed in graph.needs(id) {
            assert!(!ours.contains(needed) || allowed.contains(&needed), "{name} must not know {needed}");
            assert!(!banned.contains(&needed), "{name} must not need {needed}");
        }
    }
}

#[test]
fn every_licence_is_one_that_deny_toml_allows() {
    let deny: toml::Table = std::fs::read_to_string(root().join("deny.toml")).unwrap().parse().unwrap();
    let allowed: Vec<&str> =
        deny["licenses"]["allow"].as_array().unwrap().iter().map(|l| l.as_str().unwrap()).collect();
    let metadata = metadata();
    let mut used = BTreeSet::<&str>::new();
    for package in metadata["packages"].as_array().unwrap() {
        let licence = text(package, "license");
        assert!(
            is_allowed(licence, &allowed),
            "{} {} is under {licence:?}",
            text(package, "name"),
            text(package, "version")
        );
        used.extend(allowed.iter().copied().filter(|allowed| licence.contains(allowed)));
    }
    let unused: Vec<_> = allowed.iter().filter(|allowed| !used.contains(*allowed)).collect();
    assert!(unused.is_empty(), "deny.toml allows {unused:?}, which nothing needs");
}

/// Whether an SPDX expression can be met with the `allowed` licences. `A/B` is an old form of `A OR B`;
/// `AND` binds before `OR`.
fn is_allowed(expression: &str, allowed: &[&str]) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    either(&words, &mut at, allowed) && at == words.len()
}

fn either(words: &[&str], at: &mut usize, allowed: &[&str]) -> bool {
    let mut met = both(words, at, allowed);
    while words.get(*at) == Some(&"OR") {
        *at += 1;
        met |= both(words, at, allowed);
    }
    met
}

fn both(words: &[&str], at: &mut usize, allowed: &[&str]) -> bool {
    let mut met = one(words, at, allowed);
    while words.get(*at) == Some(&"AND") {
        *at += 1;
        met &= one(words, at, allowed);
    }
    met
}

fn one(words: &[&str], at: &mut usize, allowed: &[&str]) -> bool {
    let Some(word) = words.get(*at) else { return false };
    *at += 1;
    if *word == "(" {
        let met = either(words, at, allowed);
        *at += 1; // the closing one
        return met;
    }
    if words.get(*at) == Some(&"WITH") {
        *at += 2;
        let with_exception = words[*at - 3..*at].join(" ");
        return allowed.contains(word) || allowed.contains(&with_exception.as_str());
    }
    allowed.contains(word)
}

#[test]
fn licence_expressions_are_weighed_correctly() {
    let allowed = ["MIT", "Zlib"];
    for met in [
        "MIT",
        "MIT OR GPL-3.0",
        "GPL-3.0/MIT",
        "MIT AND Zlib",
        "(MIT OR GPL-3.0) AND Zlib",
        "GPL-3.0 AND X OR MIT",
    ] {
        assert!(is_allowed(met, &allowed), "{met}");
    }
    for unmet in
        ["", "GPL-3.0", "MIT AND GPL-3.0", "(GPL-3.0 OR X) AND MIT", "MIT)", "Apache-2.0 WITH LLVM-exception"]
    {
        assert!(!is_allowed(unmet, &allowed), "{unmet}");
    }
}

//! Meshes that need no file: each a formula and a seed.

mod duck;
mod implicit;
mod island;
mod lake_bed;
mod noise;
mod posts;
mod solid;
mod terrain;
mod trees;

use super::Mesh;

pub use island::Island;
pub use lake_bed::LakeBed;

/// A mesh that is found by a word.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// The word that scene files say for it.
    pub word: &'static str,
    /// What it is, in one sentence without a full stop.
    pub summary: &'static str,
    /// Makes it; the same seed makes the same mesh.
    pub make: fn(seed: u64) -> Mesh,
}

/// Every built-in mesh.
pub const BUILT_IN: &[BuiltIn] = &[
    BuiltIn {
        word: "island",
        summary: "an island of 40 m radius, 9 m high, whose flank goes on down to 12 m below the water",
        make: |seed| Island::new(seed).mesh(),
    },
    BuiltIn {
        word: "duck",
        summary: "the rubber duck of bathtubs, 1 m long, its beak to the north, afloat at y = 0",
        make: |_| duck::mesh(),
    },
    BuiltIn {
        word: "lake-bed",
        summary: "a lake's bed 5 m deep, an uneven shore 50 m from its middle, hills around it",
        make: |seed| LakeBed::new(seed).mesh(),
    },
    BuiltIn {
        word: "posts",
        summary: "the wooden posts of a jetty that lost its planks, from 3 m below the water to 1.5 m above",
        make: posts::mesh,
    },
    BuiltIn {
        word: "trees",
        summary: "conifers on the shore of the lake-bed of the same seed, some of them in the shallows",
        make: trees::mesh,
    },
];

/// The built-in mesh of this word.
pub fn built_in(word: &str) -> Option<&'static BuiltIn> {
    BUILT_IN.iter().find(|mesh| mesh.word == word)
}

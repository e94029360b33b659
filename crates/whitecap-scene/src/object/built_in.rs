//! The words for the meshes that come with the library.

use crate::key::{Words, words};
use crate::mesh::{BUILT_IN, Mesh};

words! {
    /// A mesh that comes with the library; [`crate::mesh::BUILT_IN`] makes it.
    pub enum BuiltInMesh {
        /// An island of sand, grass and rock, 80 m across.
        Island = "island",
        /// A rubber duck, 1 m long.
        Duck = "duck",
        /// A lake's bed and shores, 300 m across.
        LakeBed = "lake-bed",
        /// Wooden posts that stand in the water.
        Posts = "posts",
        /// Conifers.
        Trees = "trees",
    }
}

impl BuiltInMesh {
    /// Makes the mesh. Equal seeds give equal meshes.
    pub fn make(self, seed: u64) -> Mesh {
        let word = <Self as Words>::WORDS.iter().find(|word| word.value == self).map(|word| word.word);
        let built_in = BUILT_IN.iter().find(|built_in| Some(built_in.word) == word);
        built_in.map_or_else(Mesh::default, |built_in| (built_in.make)(seed))
    }
}

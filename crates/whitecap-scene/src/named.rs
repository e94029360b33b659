//! The scenes that come with the library, each a file that can be copied and changed.

/// A scene that is found by name.
#[derive(Clone, Copy, Debug)]
pub struct NamedScene {
    /// The name: the file's name without `.toml`.
    pub name: &'static str,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// The scene file.
    pub toml: &'static str,
}

/// The scene that is shown when none is asked for.
pub const DEFAULT: &str = "meshuggah";

/// Every named scene.
pub const ALL: &[NamedScene] = &[
    NamedScene {
        name: "rippling-lake",
        title: "ATI's lake of 2002: a clear lake that mirrors its shore",
        toml: include_str!("../scenes/rippling-lake.toml"),
        name: "ocean-water",
        title: "ATI's ocean of 2002: four sines under a bright sky",
        toml: include_str!("../scenes/ocean-water.toml"),
    },
    NamedScene {
        name: "ocean-water-glow",
        title: "the same towards evening, its sparkles from a glow map",
        toml: include_str!("../scenes/ocean-water-glow.toml"),
    },
    NamedScene {
        name: "ocean-water-shore",
        title: "the same round an island, whose shore calms the waves",
        toml: include_str!("../scenes/ocean-water-shore.toml"),
    },
    NamedScene {
        name: "meshuggah",
        title: "Wenzel's ocean of 2002: a low sun, a fresh breeze",
        toml: include_str!("../scenes/meshuggah.toml"),
    },
    NamedScene {
        name: "projected-grid",
        title: "Johanson's projected grid of 2004: an island and ducks on animated noise",
        toml: include_str!("../scenes/projected-grid.toml"),
    },
    NamedScene {
        name: "projected-grid-coherent",
        title: "the same sea with normals of its own surface",
        toml: include_str!("../scenes/projected-grid-coherent.toml"),
    },
    NamedScene {
        name: "projected-grid-simple",
        title: "Johanson's simpler variant: normals at the vertices, no local reflections",
        toml: include_str!("../scenes/projected-grid-simple.toml"),
    },
];

/// The named scene of this name.
pub fn find(name: &str) -> Option<&'static NamedScene> {
    ALL.iter().find(|scene| scene.name == name)
}

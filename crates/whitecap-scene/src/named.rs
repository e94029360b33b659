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
        name: "five-sample",
        title: "Berglund's shader of five samples, as it was published",
        toml: include_str!("../scenes/five-sample.toml"),
    },
    NamedScene {
        name: "five-sample-01-blinn-phong",
        title: "Berglund's stage 01: Blinn-Phong on three samples of Perlin noise, over a coarse plane",
        toml: include_str!("../scenes/five-sample-01-blinn-phong.toml"),
    },
    NamedScene {
        name: "five-sample-02-gridded",
        title: "Berglund's stage 02: the same on a plane divided into a grid",
        toml: include_str!("../scenes/five-sample-02-gridded.toml"),
    },
    NamedScene {
        name: "five-sample-03-phong-sky",
        title: "Berglund's stage 03: a better map, Phong, and the sky reflected by the level surface",
        toml: include_str!("../scenes/five-sample-03-phong-sky.toml"),
    },
    NamedScene {
        name: "five-sample-04-softer-map",
        title: "Berglund's stage 04: a map of wave heights, softly filtered: a liquid, if not water",
        toml: include_str!("../scenes/five-sample-04-softer-map.toml"),
    },
    NamedScene {
        name: "five-sample-05-lower-ambient",
        title: "Berglund's stage 05: less ambient and diffuse light: a tropical sea, if one squints",
        toml: include_str!("../scenes/five-sample-05-lower-ambient.toml"),
    },
    NamedScene {
        name: "five-sample-06-absorption",
        title: "Berglund's stage 06: absorption in place of ambient light, and the colours of a real sky",
        toml: include_str!("../scenes/five-sample-06-absorption.toml"),
    },
    NamedScene {
        name: "five-sample-07-four-samples",
        title: "Berglund's stage 07: no diffuse light, a map of its own, a fourth sample",
        toml: include_str!("../scenes/five-sample-07-four-samples.toml"),
    },
    NamedScene {
        name: "five-sample-08-fresnel-fifth-layer",
        title: "Berglund's stage 08: Fresnel as (1 - N.V)^2 and a fifth sample",
        toml: include_str!("../scenes/five-sample-08-fresnel-fifth-layer.toml"),
    },
    NamedScene {
        name: "five-sample-08-less-green",
        title: "Berglund's stage 08: the same with less green near the viewer",
        toml: include_str!("../scenes/five-sample-08-less-green.toml"),
    },
    NamedScene {
        name: "five-sample-09-broken-sun",
        title: "Berglund's stage 09: an example of breakage on the last night",
        toml: include_str!("../scenes/five-sample-09-broken-sun.toml"),
    },
    NamedScene {
        name: "five-sample-island",
        title: "Berglund's sea with what he left for later: a clear shallow, reflections, a beach",
        toml: include_str!("../scenes/five-sample-island.toml"),
    },
];

/// The named scene of this name.
pub fn find(name: &str) -> Option<&'static NamedScene> {
    ALL.iter().find(|scene| scene.name == name)
}

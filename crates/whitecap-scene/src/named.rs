//! The scenes that come with the library, each a file that can be copied and changed, and the files that they need.

use std::path::Path;

use crate::reader::quoted_list;

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

/// What begins the name of a file that comes with the library, where a scene says a file.
const PREFIX: &str = "named:";

/// Every file that named scenes need, and what it is called after `named:`.
const FILES: &[(&str, &[u8])] = &[("buoy.spec", include_bytes!("../data/buoy.spec"))];

/// What is in the file that a scene calls `named:…`; `None` for a path. An unknown name has no bytes.
pub(crate) fn file(path: &Path) -> Option<Option<&'static [u8]>> {
    let name = path.to_str()?.strip_prefix(PREFIX)?;
    Some(FILES.iter().find(|file| file.0 == name).map(|file| file.1))
}

/// The names of those files as scenes say them.
pub(crate) fn files() -> String {
    let names: Vec<_> = FILES.iter().map(|file| format!("{PREFIX}{}", file.0)).collect();
    quoted_list(&names.iter().map(String::as_str).collect::<Vec<_>>())
}

/// The scene that is shown when none is asked for.
pub const DEFAULT: &str = "spectral-ocean";

/// A line for each scene: the name of its file in `scenes/`, and its title.
macro_rules! scenes {
    ($($name:literal: $title:literal,)*) => {
        /// Every named scene.
        pub const ALL: &[NamedScene] = &[$(NamedScene {
            name: $name,
            title: $title,
            toml: include_str!(concat!("../scenes/", $name, ".toml")),
        }),*];
    };
}

scenes! {
    "ocean-water": "ATI's ocean of 2002: four sines under a bright sky",
    "ocean-water-glow": "ATI's ocean towards evening, its sparkles from a glow map",
    "ocean-water-shore": "ATI's ocean round an island, whose shore calms the waves",
    "rippling-lake": "ATI's lake of 2002: a clear lake that mirrors its shore",
    "projected-grid": "Johanson's projected grid of 2004: an island and ducks on animated noise",
    "projected-grid-coherent": "Johanson's projected grid with normals of the surface that is drawn",
    "projected-grid-simple": "Johanson's simpler variant: normals at the vertices, no local reflections",
    "meshuggah": "Wenzel's ocean of 2002: a low sun, a fresh breeze",
    "five-sample": "Berglund's shader of five samples, as it was published",
    "five-sample-01-blinn-phong": "Berglund's stage 01: Blinn-Phong on three samples of Perlin noise, over a coarse plane",
    "five-sample-02-gridded": "Berglund's stage 02: the same on a plane divided into a grid",
    "five-sample-03-phong-sky": "Berglund's stage 03: a better map, Phong, and the sky reflected by the level surface",
    "five-sample-04-softer-map": "Berglund's stage 04: a map of wave heights, softly filtered: a liquid, if not water",
    "five-sample-05-lower-ambient": "Berglund's stage 05: less ambient and diffuse light: a tropical sea, if one squints",
    "five-sample-06-absorption": "Berglund's stage 06: absorption in place of ambient light, and the colours of a real sky",
    "five-sample-07-four-samples": "Berglund's stage 07: no diffuse light, a map of its own, a fourth sample",
    "five-sample-08-fresnel-fifth-layer": "Berglund's stage 08: Fresnel as (1 - N.V)^2 and a fifth sample",
    "five-sample-08-less-green": "Berglund's stage 08: with less green near the viewer",
    "five-sample-09-broken-sun": "Berglund's stage 09: an example of breakage on the last night",
    "five-sample-island": "Berglund's sea with what he left for later: a clear shallow, reflections, a beach",
    "spectral-ocean": "Our ocean: a fresh trade wind and a swell, from 5 m",
    "spectral-ocean-storm": "Our ocean in a gale, from a ship's deck",
    "spectral-ocean-swell": "Our ocean with a long swell towards evening",
    "spectral-ocean-shallow": "Our ocean over a shelf 8 m deep, waves against the tide",
    "spectral-ocean-dawn": "Our ocean at sunrise, all but calm",
    "spectral-ocean-crossing": "Our ocean where two seas cross at right angles",
    "spectral-ocean-tropical": "Our ocean in a lagoon of 5 m over white sand",
    "spectral-ocean-aircraft": "Our ocean from 1500 m, with the sun's glitter and whitecaps",
    "spectral-ocean-buoy": "Our ocean as a directional record has it, a wind sea under a swell",
}

/// The named scene of this name.
pub fn find(name: &str) -> Option<&'static NamedScene> {
    ALL.iter().find(|scene| scene.name == name)
}

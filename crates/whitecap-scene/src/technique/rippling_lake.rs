//! Settings of ATI's lake (ShaderX 2002): mirror and refraction maps disturbed by scrolling bump maps.
//!
//! The text gives the size of the maps and no other number; the defaults of its constants c1 to c6 and c24 to c27
//! are ours, but for the scroll, which is that of its twin on the ocean.

use crate::key::{Colour, Count, Flag, OneOf, Pair, PowerOfTwo, Real, or, table, words};
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

/// What it follows.
pub(super) const SOURCE: &str = "Alex Vlachos, John Isidoro and Chris Oat (ATI), \"Rippling Reflective and Refractive \
     Water\", in Direct3D ShaderX, 2002";

/// Where it departs from that, whatever the settings.
pub(super) const DIFFERS: &[&str] = &[
    "The altered projection is the one that the prose means; its listing is damaged.",
    "The light is the sun's direction instead of a place.",
    "The text publishes no scrolls, tilings, perturbations and tints; all of them are chosen.",
];

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "rippling-lake",
    summary: "ATI's lake (ShaderX 2002): mirror and refraction maps disturbed by scrolling bump maps",
    keys: RipplingLake::keys,
    read: |table| RipplingLake::read(table).map(Technique::RipplingLake),
};

words! {
    /// Which coordinates are read as (v, u) instead of (u, v).
    pub enum SwapUv {
        /// None, as the text's listing has it.
        None = "none",
        /// Those of the refraction map, to the letter of the text's prose, which turns it over its diagonal.
        Refraction = "refraction",
        /// Those of the second bump map, as on the ocean of the same authors: what keeps the two bump maps from
        /// aligning.
        Bump = "bump",
    }
}

table! {
    /// How the lake is drawn: the table `[rippling-lake]`.
    pub struct RipplingLake {
        /// The side of the square of water.
        size_m: f64 = or(Real { unit: "m", min: 1.0, max: 10_000.0 }, 120.0);
        /// The middle of the square: east, south.
        centre_m: [f64; 2] = or(Pair { unit: "m", min: -1e7, max: 1e7 }, [0.0, 0.0]);
        /// Squares of the mesh along a side.
        cells: u32 = or(Count { min: 1, max: 1024 }, 64);
        /// The width of the mirror map and of the refraction map, in pixels.
        map_width_px: u32 = or(Count { min: 1, max: 4096 }, 512);
        /// The height of both maps, in pixels.
        map_height_px: u32 = or(Count { min: 1, max: 4096 }, 256);
        /// How far above the water's level the refraction map still shows what is there, so that no seam opens
        /// where a look-up is moved across the shore. The text has none.
        refraction_margin_m: f64 = or(Real { unit: "m", min: 0.0, max: 1.0 }, 0.0);
        /// Texels along a side of the bump map.
        bump_resolution: u32 = or(PowerOfTwo { min: 64, max: 2048 }, 256);
        /// The slope of the bump map, root mean square.
        bump_slope: f64 = or(Real { unit: "", min: 0.0, max: 2.0 }, 0.2);
        /// How often the first bump map is repeated in a unit of the texture coordinate (c26).
        bump_tiling_0: [f64; 2] = or(TILING, [2.0, 2.0]);
        /// The same for the second (c27).
        bump_tiling_1: [f64; 2] = or(TILING, [2.7, 2.7]);
        /// How fast the first bump map scrolls, in repeats (c24).
        bump_scroll_0: [f64; 2] = or(SCROLL, [0.031, 0.04]);
        /// The same for the second (c25).
        bump_scroll_1: [f64; 2] = or(SCROLL, [-0.03, 0.02]);
        /// How far the bump moves the look-up in the mirror map, in widths and heights of it (c1).
        reflection_perturbation: [f64; 2] = or(PERTURBATION, [0.05, 0.05]);
        /// The same for the refraction map (c2).
        refraction_perturbation: [f64; 2] = or(PERTURBATION, [0.03, 0.03]);
        /// What reflections are multiplied by (c3).
        reflection_tint: [f64; 3] = or(COLOUR, [1.0, 1.0, 1.0]);
        /// What refractions are multiplied by: the colour of the water (c4).
        refraction_tint: [f64; 3] = or(COLOUR, [0.4, 0.55, 0.5]);
        /// The colour of highlights (c6).
        highlight_color: [f64; 3] = or(COLOUR, [0.8, 0.76, 0.62]);
        /// What the refraction map holds where no bottom is seen, before it is tinted.
        deep_color: [f64; 3] = or(COLOUR, [0.1, 0.2, 0.2]);
        /// Which coordinates are read as (v, u) instead of (u, v).
        swap_uv: SwapUv = or(OneOf::<SwapUv>::WORDS, SwapUv::None);
        /// Whether the interpolated vectors to eye and light are brought back to length 1 at each pixel. The text
        /// leaves them as they come, which brightens the middle of large triangles.
        normalised_vectors: bool = or(Flag, false);
    }
}

const COLOUR: Colour = Colour { unit: "", min: 0.0, max: 1.0 };
const TILING: Pair = Pair { unit: "", min: -1000.0, max: 1000.0 };
const SCROLL: Pair = Pair { unit: "1/s", min: -100.0, max: 100.0 };
// Constants of pixel shaders of that time are held to ±1.
const PERTURBATION: Pair = Pair { unit: "", min: -1.0, max: 1.0 };

impl Default for RipplingLake {
    /// The settings of an empty `[rippling-lake]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}

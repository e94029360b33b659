//! Settings of ATI's ocean (ShaderX 2002): four sines at the vertices, two bump maps, a squared reflection.
//!
//! Constants that the text gives are the defaults; its artwork (height map, gradient, sky) is not printed, and what
//! stands for it here is chosen.

use crate::key::{Colour, Count, OneOf, Pair, PowerOfTwo, Real, optional, or, table, words};
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

/// What it follows.
pub(super) const SOURCE: &str = "John Isidoro, Alex Vlachos and Chris Brennan (ATI), \"Rendering Ocean Water\", in Direct3D \
     ShaderX, 2002";

/// Where it departs from that, whatever the settings.
pub(super) const DIFFERS: &[&str] = &[
    "The text gives its plane no size: one of its units of height is 1 cm unless `unit_m` says \
     otherwise.",
    "The plane goes on to the horizon, and far waves are damped before its cells get too wide for \
     them.",
    "Shores damp the waves by the depth of the ground; the text's artists painted them.",
    "Bump maps are filtered trilinearly, and the water's colours dim after sunset.",
];

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "ocean-water",
    summary: "ATI's ocean (ShaderX 2002): four sines at the vertices, two bump maps, a squared reflection",
    keys: OceanWater::keys,
    read: |table| OceanWater::read(table).map(Technique::OceanWater),
};

words! {
    /// Which derivative tilts the tangent along v.
    pub enum Tangent {
        /// The one along u, as the text's listing has it.
        Printed = "printed",
        /// The one along v, so that the tangent lies in the surface.
        Mended = "mended",
    }
}

words! {
    /// Where the sparkles come from.
    pub enum Highlights {
        /// The green of the sky's reflection to the eighth power.
        GreenPower = "green-power",
        /// A glow map in the alpha channel of the sky's map, the other approach that the text names.
        GlowMap = "glow-map",
    }
}

table! {
    /// How ATI's ocean is drawn: the table `[ocean-water]`.
    pub struct OceanWater {
        /// Cells along each side of the coarse input grid.
        grid_cells: u32 = or(PowerOfTwo { min: 8, max: 128 }, 32);
        /// The width of the coarse cells round the viewer; the grid follows in steps of it.
        cell_m: f64 = or(Real { unit: "m", min: 0.01, max: 1000.0 }, 8.0);
        /// How much wider each further cell is than the one before it, outside of the 4 nearest.
        cell_growth: f64 = or(Real { unit: "", min: 1.0, max: 1.5 }, 1.2);
        /// Into how many parts N-patches divide each edge of the coarse grid.
        refinement: Option<u32> =
            optional(Count { min: 1, max: 16 }, "3 where a processor draws, 8 on a graphics card");
        /// The depth of the ground from which on waves have their full height; towards the shore they shrink.
        shore_depth_m: f64 = or(Real { unit: "m", min: 0.01, max: 1000.0 }, 4.0);
        /// Which derivative tilts the tangent along v.
        tangent: Tangent = or(OneOf::<Tangent>::WORDS, Tangent::Printed);
        /// Texels along each side of the generated bump map.
        bump_resolution: u32 = or(PowerOfTwo { min: 128, max: 1024 }, 256);
        /// How many of the longest ripples fit along the bump map.
        bump_ripples: f64 = or(Real { unit: "", min: 2.0, max: 16.0 }, 5.0);
        /// How steep the ripples of the bump map are: the root mean square of their slopes, along both axes.
        bump_steepness: f64 = or(Real { unit: "", min: 0.0, max: 2.0 }, 0.6);
        /// How many times the bump map is repeated along one unit of the texture coordinate.
        bump_repeats: f64 = or(Real { unit: "", min: 0.01, max: 100.0 }, 1.0);
        /// How fast the first bump map scrolls along u and v.
        first_scroll_per_s: [f64; 2] = or(SCROLL, [0.031, 0.04]);
        /// How fast the second bump map, which has u and v swapped, scrolls along u and v.
        second_scroll_per_s: [f64; 2] = or(SCROLL, [-0.03, 0.02]);
        /// The water's colour where one looks along it: the gradient's first.
        edge_color: [f64; 3] = or(COLOUR, [0.06, 0.22, 0.42]);
        /// The water's colour half-way along the gradient.
        middle_color: [f64; 3] = or(COLOUR, [0.05, 0.27, 0.38]);
        /// The water's colour where one looks down into it: the gradient's last.
        deep_color: [f64; 3] = or(COLOUR, [0.02, 0.26, 0.26]);
        /// Where the sparkles come from.
        highlights: Highlights = or(OneOf::<Highlights>::WORDS, Highlights::GreenPower);
        /// The colour of the sparkles.
        highlight_color: [f64; 3] = or(COLOUR, [0.8, 0.76, 0.62]);
    }
}

const COLOUR: Colour = Colour { unit: "", min: 0.0, max: 1.0 };
const SCROLL: Pair = Pair { unit: "1/s", min: -10.0, max: 10.0 };

/// v5.x over ground that lies `depth_m` under the level (`None` where there is none): 0 for full waves, from
/// `shore_depth_m` on; 1 for none, at the waterline and on land; linear between.
pub fn shore_damping(depth_m: Option<f64>, shore_depth_m: f64) -> f64 {
    depth_m.map_or(0.0, |depth_m| 1.0 - (depth_m / shore_depth_m).clamp(0.0, 1.0))
}

impl Default for OceanWater {
    /// The settings of an empty `[ocean-water]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}

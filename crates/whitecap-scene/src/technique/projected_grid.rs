//! Settings of Johanson's projected grid (2004): the mesh that always lies before the camera, on Perlin noise.
//!
//! Grid, maps and what is mixed are the thesis's. It gives no numbers for sun, water and distortion; those here are
//! the ones that its demo starts with.

use crate::key::{Colour, Count, Flag, OneOf, PowerOfTwo, Real, optional, or, table, words};
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

/// What it follows.
pub(super) const SOURCE: &str = "Claes Johanson, \"Real-time water rendering: Introducing the projected grid concept\", \
     master's thesis, Lund University, 2004";

/// Where it departs from that, whatever the settings.
pub(super) const DIFFERS: &[&str] = &[
    "The far plane is cut at `far_km`, and wide views aim the projector more steeply than the \
     text.",
    "Noise reaches the device as half floats instead of 16-bit integers.",
    "The sun is the sky's unless the text's angles are set.",
    "The text's z runs north, ours south.",
];

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "projected-grid",
    summary: "Johanson's projected grid (2004): the mesh that always lies before the camera, on Perlin noise",
    keys: ProjectedGrid::keys,
    read: |table| ProjectedGrid::read(table).map(Technique::ProjectedGrid),
};

words! {
    /// How the normals' surface relates to the mesh's.
    pub enum Pairing {
        /// As published: the normal map's waves are half as high and, with chunks of 256 texels, a quarter as long.
        Faithful = "faithful",
        /// Both are the same surface.
        Coherent = "coherent",
    }
}

words! {
    /// Where the normals come from.
    pub enum Normals {
        /// A map that is made of the noise for each view.
        Map = "map",
        /// The mesh itself, as in the text's simpler second implementation.
        PerVertex = "per-vertex",
    }
}

words! {
    /// What is seen in the water.
    pub enum RefractedColor {
        /// One colour.
        Constant = "constant",
        /// A picture of what lies under water, as in the line that the text leaves commented out.
        Map = "map",
    }
}

words! {
    /// Along which axes slopes shift what is mirrored and refracted.
    pub enum OffsetAxes {
        /// The world's, whichever way one looks, as the text has it.
        World = "world",
        /// The picture's.
        View = "view",
    }
}

table! {
    /// How the projected grid is drawn: the table `[projected-grid]`.
    pub struct ProjectedGrid {
        /// Vertices of the grid across the picture.
        grid_across: u32 = or(Count { min: 2, max: 1025 }, 65);
        /// Vertices of the grid from the near side to the far one.
        grid_down: u32 = or(Count { min: 2, max: 1025 }, 129);
        /// How far away water is drawn.
        far_km: f64 = or(Real { unit: "km", min: 0.1, max: 1e4 }, 100.0);
        /// The least height of the projector over the highest wave.
        elevation_m: f64 = or(Real { unit: "m", min: 0.1, max: 1000.0 }, 7.0);
        /// By how much the grid reaches further than the highest wave makes necessary.
        slab_margin_m: f64 = or(Real { unit: "m", min: 0.0, max: 100.0 }, 0.0);
        /// Whether each vertex takes the mean height of itself and its four neighbours, an option of the demo.
        smooth: bool = or(Flag, false);
        /// Where the normals come from.
        normals: Normals = or(OneOf::<Normals>::WORDS, Normals::Map);
        /// How the normals' surface relates to the mesh's, for `normals = "map"`.
        pairing: Pairing = or(OneOf::<Pairing>::WORDS, Pairing::Faithful);
        /// Texels of the height map and the normal map across the picture.
        map_across: u32 = or(PowerOfTwo { min: 16, max: 4096 }, 512);
        /// Texels of the height map and the normal map from the near side to the far one.
        map_down: u32 = or(PowerOfTwo { min: 16, max: 4096 }, 1024);
        /// Whether the water mirrors the objects and not the sky alone.
        local_reflections: bool = or(Flag, true);
        /// What is seen in the water.
        refraction: RefractedColor = or(OneOf::<RefractedColor>::WORDS, RefractedColor::Constant);
        /// Texels along a side of the maps of what is mirrored and refracted.
        local_map_size: u32 = or(PowerOfTwo { min: 64, max: 4096 }, 1024);
        /// How far slopes shift what is mirrored and refracted, in widths of the picture.
        distortion: f64 = or(Real { unit: "", min: 0.0, max: 1.0 }, 0.1);
        /// Along which axes they do.
        offset_axes: OffsetAxes = or(OneOf::<OffsetAxes>::WORDS, OffsetAxes::World);
        /// The water's own colour.
        water_color: [f64; 3] = or(Colour { unit: "", min: 0.0, max: 1.0 }, [0.17, 0.27, 0.26]);
        /// How bright the sun's glint is.
        sun_strength: f64 = or(Real { unit: "", min: 0.0, max: 100.0 }, 12.0);
        /// How narrow the sun's glint is: Phong's exponent.
        sun_shininess: f64 = or(Real { unit: "", min: 1.0, max: 10000.0 }, 84.0);
        /// The angle of the glint's sun around, from north towards east: 79.07 (1.38 rad) in the demo.
        sun_alfa_deg: Option<f64> = optional(Real { unit: "deg", min: -360.0, max: 360.0 }, "the sky's sun");
        /// The height of the glint's sun: 62.45 (1.09 rad) in the demo.
        sun_theta_deg: Option<f64> = optional(Real { unit: "deg", min: 0.0, max: 90.0 }, "the sky's sun");
    }
}

impl Default for ProjectedGrid {
    /// The settings of an empty `[projected-grid]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}

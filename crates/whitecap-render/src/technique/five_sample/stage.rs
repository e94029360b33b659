//! The stages of Berglund's work log: what the log says of each, and the numbers that it leaves to us.
//!
//! From its text: the kind of lighting, how many samples there are, what the map is made of, what of the sky is
//! reflected, which form of Fresnel there is. Chosen here: the colours, factors and maps, since they went with the
//! pictures.

use super::maps::MapRecipe;
use glam::Vec3;
use whitecap_scene::technique::Variant;

/// How the sun's glint is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Glint {
    /// Blinn–Phong, the half vector interpolated between vertices.
    BlinnPhong,
    /// Phong with the sign of the light forgotten: "my R vector had been inverted, as I had forgotten to negate the
    /// light vector".
    InvertedPhong,
}

/// What of the sky is reflected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SkyReflection {
    /// Nothing.
    None,
    /// What the level surface reflects, looked up from the wrong end. The log says only that the reflection was
    /// "fairly broken", and better at the next stage.
    UpsideDown,
    /// "a bug that was making the entire surface reflect the part of the sky just above the horizon".
    JustAboveHorizon,
    /// What the level surface reflects.
    AsSeen,
}

/// How the water takes light away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Absorption {
    /// It does not.
    None,
    /// A blend of `near` and `far` by 1 − (N·V)²: "a slightly broken approximation of Fresnel".
    Broken { near: [f32; 3], far: [f32; 3] },
    /// The same by (1 − N·V)², which the glint is multiplied by as well.
    Fresnel { near: [f32; 3], far: [f32; 3] },
}

/// A stage before the last form of the shader.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stage {
    pub(super) glint: Glint,
    pub(super) sky: SkyReflection,
    /// What the sky's reflection is multiplied by.
    pub(super) sky_share: f32,
    /// The "hard-coded blue diffuse colour".
    pub(super) diffuse_color: [f32; 3],
    /// Its share of light from all around, and from the sun.
    pub(super) ambient: f32,
    pub(super) diffuse: f32,
    pub(super) absorption: Absorption,
    /// How many of [`EARLY_LAYERS`] there are.
    pub(super) layer_count: u32,
}

/// How a layer reads the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layer {
    /// Tiles in one unit of the texture coordinate.
    pub(super) scale: f64,
    /// Whether it is turned by 45°, which stretches it by √2.
    pub(super) is_turned: bool,
    /// The time in which it scrolls by one tile, seconds, along u and v.
    pub(super) seconds_per_tile: [f64; 2],
}

const fn layer(scale: f64, is_turned: bool, seconds_per_tile: [f64; 2]) -> Layer {
    Layer { scale, is_turned, seconds_per_tile }
}

/// The layers of the published shader, in its order.
pub(super) const LAYERS: [Layer; 5] = [
    layer(5.0, false, [200.0, 166.0]),
    layer(31.0, false, [94.0, 70.0]),
    layer(67.0, true, [56.0, 34.0]),
    layer(203.0, false, [100.0, 20.0]),
    layer(123.0, true, [60.0, 57.0]),
];

/// The same in the order in which the log adds them: three, then "tiny ripples", then "larger waves".
pub(super) const EARLY_LAYERS: [Layer; 5] = [LAYERS[1], LAYERS[2], LAYERS[4], LAYERS[3], LAYERS[0]];

/// What is special about a variant.
pub(super) struct Form {
    pub(super) map: MapRecipe,
    /// The stage, or `None` for the shader's last form.
    pub(super) stage: Option<Stage>,
    /// Whether the plane consists of few, large triangles.
    pub(super) is_coarse: bool,
    /// Whether the sun is where no sun should be.
    pub(super) is_sun_broken: bool,
}

/// The blue of the first stages.
const BLUE: [f32; 3] = [0.08, 0.24, 0.62];

const FIRST: Stage = Stage {
    glint: Glint::BlinnPhong,
    sky: SkyReflection::None,
    sky_share: 0.0,
    diffuse_color: BLUE,
    ambient: 0.45,
    diffuse: 0.75,
    absorption: Absorption::None,
    layer_count: 3,
};

const PHONG_SKY: Stage = Stage {
    glint: Glint::InvertedPhong,
    sky: SkyReflection::UpsideDown,
    sky_share: 0.35,
    ambient: 0.4,
    diffuse: 0.6,
    ..FIRST
};

const SOFTER: Stage = Stage { sky: SkyReflection::JustAboveHorizon, sky_share: 0.3, ..PHONG_SKY };

const LOWER: Stage = Stage { ambient: 0.15, diffuse: 0.45, ..SOFTER };

const FAR: [f32; 3] = [0.55, 0.66, 0.74];
const NEAR: [f32; 3] = [0.12, 0.36, 0.30];
const NEAR_LESS_GREEN: [f32; 3] = [0.12, 0.27, 0.30];

const ABSORBED: Stage = Stage {
    ambient: 0.0,
    diffuse: 0.45,
    sky_share: 0.85,
    absorption: Absorption::Broken { near: NEAR, far: FAR },
    ..LOWER
};

const SHINY: Stage = Stage { diffuse: 0.0, sky_share: 1.0, layer_count: 4, ..ABSORBED };

const FIFTH: Stage = Stage {
    sky: SkyReflection::AsSeen,
    absorption: Absorption::Fresnel { near: NEAR, far: FAR },
    layer_count: 5,
    ..SHINY
};

const LESS_GREEN: Stage =
    Stage { absorption: Absorption::Fresnel { near: NEAR_LESS_GREEN, far: FAR }, ..FIFTH };

/// The form of each variant.
pub(super) fn form(variant: Variant) -> Form {
    let form = |map, stage| Form { map, stage, is_coarse: false, is_sun_broken: false };
    match variant {
        Variant::BlinnPhong => Form { is_coarse: true, ..form(MapRecipe::Perlin, Some(FIRST)) },
        Variant::Gridded => form(MapRecipe::Perlin, Some(FIRST)),
        Variant::PhongSky => form(MapRecipe::BetterPerlin, Some(PHONG_SKY)),
        Variant::SofterMap => form(MapRecipe::SoftWaves, Some(SOFTER)),
        Variant::LowerAmbient => form(MapRecipe::SoftWaves, Some(LOWER)),
        Variant::Absorption => form(MapRecipe::SoftWaves, Some(ABSORBED)),
        Variant::FourSamples => form(MapRecipe::HandMade, Some(SHINY)),
        Variant::FifthLayer => form(MapRecipe::HandMade, Some(FIFTH)),
        Variant::LessGreen => form(MapRecipe::HandMade, Some(LESS_GREEN)),
        Variant::BrokenSun => Form { is_sun_broken: true, ..form(MapRecipe::HandMade, None) },
        Variant::Final => form(MapRecipe::HandMade, None),
    }
}

/// Where the sun of the example of breakage is: mirrored below the sea, and twice as far away as a direction may be.
/// The log says only "where no respectable sun vector should ever go".
pub(super) fn broken_sun(toward_sun: Vec3) -> Vec3 {
    2.0 * Vec3::new(toward_sun.x, -toward_sun.y, toward_sun.z)
}

impl Stage {
    /// The option bits that `stages.wesl` names.
    pub(super) fn options(&self) -> u32 {
        let glint = match self.glint {
            Glint::BlinnPhong => 1,
            Glint::InvertedPhong => 0,
        };
        let sky = match self.sky {
            SkyReflection::None => 0,
            SkyReflection::UpsideDown => 2,
            SkyReflection::JustAboveHorizon => 4,
            SkyReflection::AsSeen => 8,
        };
        let absorption = match self.absorption {
            Absorption::None => 0,
            Absorption::Broken { .. } => 16,
            Absorption::Fresnel { .. } => 16 | 32,
        };
        glint | sky | absorption
    }
}

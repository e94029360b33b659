//! Parts of the pixel stage that can be left out, to measure what each costs.

/// A part of the light that the spectral ocean draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// Whitecaps.
    Foam,
    /// The sun in the waves.
    Glitter,
    /// The sky in the waves: what it reads, not the directions, of which the water's share follows.
    Surroundings,
    /// The light out of the water and through crests.
    WaterLight,
    /// The air between.
    Air,
}

impl Feature {
    /// All of them, in the order in which a pixel has them.
    pub const ALL: &[Feature] =
        &[Feature::Surroundings, Feature::Glitter, Feature::WaterLight, Feature::Foam, Feature::Air];

    /// In a word or two.
    pub fn label(self) -> &'static str {
        match self {
            Feature::Foam => "foam",
            Feature::Glitter => "glitter",
            Feature::Surroundings => "surroundings",
            Feature::WaterLight => "water's light",
            Feature::Air => "air",
        }
    }

    /// The shader's constant that leaves it out when it is 0.
    pub(super) fn constant(self) -> &'static str {
        match self {
            Feature::Foam => "FOAM_TILES",
            Feature::Glitter => "GLITTER",
            Feature::Surroundings => "SURROUNDINGS",
            Feature::WaterLight => "WATER_LIGHT",
            Feature::Air => "AIR",
        }
    }
}

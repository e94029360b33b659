//! Settings of Berglund's shader of five samples: emission against reflection on a flat sea.
//!
//! The source is a work log. It gives the final shader with its parameters, and tells of the stages before it in
//! words. The unit of the texture coordinates, the normal maps and the colours of the sky are lost with its
//! pictures; those here are chosen.

use crate::error::SceneError;
use crate::key::{Colour, Flag, OneOf, Real, or, table, words};
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

/// What it follows.
pub(super) const SOURCE: &str = "Berglund, work log of an ocean shader with five samples of one normal map";

/// Where it departs from that, whatever the settings.
pub(super) const DIFFERS: &[&str] = &[
    "The texture coordinate's unit, the normal maps and the sky's gradient are not in the text; \
     they are chosen and made.",
    "Colours, factors and maps of the stages are chosen by the log's words.",
    "Sky, emission and sun dim with daylight.",
];

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "five-sample",
    summary: "Berglund's shader of five samples: emission against reflection on a flat sea",
    keys: FiveSample::keys,
    read: |table| FiveSample::read_checked(table).map(Technique::FiveSample),
};

words! {
    /// The stages of the work log, in its order.
    pub enum Variant {
        /// Blinn–Phong on three samples of Perlin noise, its half vector interpolated over a coarse plane.
        BlinnPhong = "01-blinn-phong",
        /// The same on a plane that is divided into a grid.
        Gridded = "02-gridded",
        /// A better map, Phong, and a sky that the level surface reflects, upside down.
        PhongSky = "03-phong-sky",
        /// A map made of wave heights by a subtle filter; the sky just above the horizon everywhere.
        SofterMap = "04-softer-map",
        /// Less ambient and diffuse light.
        LowerAmbient = "05-lower-ambient",
        /// Absorption in place of ambient light, blended by 1 − (N·V)²; the colours of a real sky.
        Absorption = "06-absorption",
        /// No diffuse light, a map of its own, and a fourth sample for tiny ripples.
        FourSamples = "07-four-samples",
        /// Fresnel as (1 − N·V)², on the sun's glint too; the right part of the sky; a fifth sample.
        FifthLayer = "08-fresnel-fifth-layer",
        /// The same with an absorption that lets out less green near the viewer.
        LessGreen = "08-less-green",
        /// The example of breakage: the sun where no sun should be.
        BrokenSun = "09-broken-sun",
        /// The shader as it was published: emission against partly absorbed reflection.
        Final = "final",
    }
}

table! {
    /// How it is drawn: the table `[five-sample]`.
    pub struct FiveSample {
        /// The stage of the work log.
        variant: Variant = or(OneOf::<Variant>::WORDS, Variant::Final);
        /// The length that one unit of the texture coordinate stands for. The map repeats after a 5th of it in the
        /// largest waves and after a 203rd in the smallest.
        uv_size_m: f64 = or(Real { unit: "m", min: 1.0, max: 100_000.0 }, 600.0);
        /// How steep the waves of the map are, relative to the map of the stage.
        wave_strength: f64 = or(Real { unit: "", min: 0.0, max: 8.0 }, 1.0);
        /// The power of the sun's glint.
        exponent: f64 = or(Real { unit: "", min: 1.0, max: 1000.0 }, 40.0);
        /// The light that comes out of the water; for `final` and `09-broken-sun`.
        emission: [f64; 3] = or(COLOUR, [0.1, 0.15, 0.12]);
        /// What of the reflection is not absorbed; for `final` and `09-broken-sun`.
        reflection: [f64; 3] = or(COLOUR, [0.65, 0.65, 0.65]);
        /// The brightness of the sun's glint, the text's "fake HDR"; for `final` and `09-broken-sun`.
        sun_brightness: f64 = or(Real { unit: "", min: 0.0, max: 100.0 }, 7.0);
        /// The colour of the sky overhead, and of its reflection where one looks straight down.
        zenith_color: [f64; 3] = or(COLOUR, [0.27, 0.45, 0.70]);
        /// The colour of the sky 14° over the horizon, where a quarter of the gradient is left.
        middle_color: [f64; 3] = or(COLOUR, [0.53, 0.69, 0.84]);
        /// The colour of the sky at the horizon.
        horizon_color: [f64; 3] = or(COLOUR, [0.80, 0.87, 0.91]);
        /// Whether the dome shows the sun's disc, which the text's does not.
        sun_disc: bool = or(Flag, false);
        /// Whether the bottom shows through shallow water (Beer and Lambert); for `final`. The bottom is that of
        /// the scene's objects.
        depth_fog: bool = or(Flag, false);
        /// How much light a metre of water takes away, for `depth_fog`.
        extinction_per_m: [f64; 3] = or(Colour { unit: "1/m", min: 0.0, max: 100.0 }, [0.55, 0.20, 0.22]);
        /// Whether the water reflects the scene's objects; for `final`.
        reflected_geometry: bool = or(Flag, false);
        /// How far waves push what they reflect and what is seen through them, in heights of the picture for a
        /// slope of 1; for `depth_fog` and `reflected_geometry`.
        distortion: f64 = or(Real { unit: "", min: 0.0, max: 1.0 }, 0.25);
        /// Whether waves change where they meet land: they calm down, and run up the beach as a line of foam; for
        /// `final`.
        waves_meet_land: bool = or(Flag, false);
        /// The depth from which on waves calm down towards the shore, for `waves_meet_land`.
        shore_depth_m: f64 = or(Real { unit: "m", min: 0.01, max: 100.0 }, 1.2);
        /// How far the water's edge falls and rises, for `waves_meet_land`.
        swash_height_m: f64 = or(Real { unit: "m", min: 0.0, max: 2.0 }, 0.12);
        /// The time from one wave on the beach to the next, for `waves_meet_land`.
        swash_period_s: f64 = or(Real { unit: "s", min: 0.5, max: 120.0 }, 7.0);
    }
}

const COLOUR: Colour = Colour { unit: "", min: 0.0, max: 1.0 };

/// What the shader has only from its last form on.
const OF_LAST_FORM: &[&str] = &["emission", "reflection", "sun_brightness"];

/// What the author left for later.
const LATER: &[&str] = &["depth_fog", "reflected_geometry", "waves_meet_land"];

impl FiveSample {
    /// Settings that a stage does not have yet are refused: the user would change them and nothing would happen.
    fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        let settings = Self::read(table)?;
        let missing: &[&[&str]] = match settings.variant {
            Variant::Final => &[],
            Variant::BrokenSun => &[LATER],
            _ => &[OF_LAST_FORM, LATER],
        };
        // A scene that is written has every key; those with their defaults say nothing.
        let (read, defaults) = (settings.as_table(), Self::default().as_table());
        let is_set = |key: &&&str| table.has(key) && read.get(**key) != defaults.get(**key);
        match missing.iter().copied().flatten().find(is_set) {
            None => Ok(settings),
            Some(key) => Err(table.error(
                Some(key),
                "the stage that `variant` names does not have it yet; accepted: variant = \"final\"",
            )),
        }
    }

    fn as_table(&self) -> toml::Table {
        // Numbers, words and flags always are a table.
        toml::Table::try_from(self).unwrap_or_default()
    }

    /// Whether any of what the author left for later is on.
    pub fn has_later(&self) -> bool {
        self.depth_fog || self.reflected_geometry || self.waves_meet_land
    }
}

impl Default for FiveSample {
    /// The settings of an empty `[five-sample]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}

#[cfg(test)]
mod tests {
    use crate::Scene;

    fn read(settings: &str) -> Result<Scene, String> {
        let camera = "[camera]\nposition_m = [0, 2, 0]\nlook_at_m = [9, 0, 0]\n";
        let toml = format!("technique = \"five-sample\"\n[five-sample]\n{settings}\n{camera}");
        Scene::from_toml(&toml, "sea.toml").map_err(|error| error.to_string())
    }

    #[test]
    fn a_stage_that_does_not_exist_names_those_that_do() {
        let error = read("variant = \"01-blin-phong\"").unwrap_err();
        assert!(error.contains("did you mean \"01-blinn-phong\""), "{error}");
        let error_of_scenes_name = read("variant = \"five-sample-01-blinn-fong\"").unwrap_err();
        assert!(error_of_scenes_name.contains("did you mean \"01-blinn-phong\""), "{error_of_scenes_name}");
        assert!(error.contains("\"08-fresnel-fifth-layer\"") && error.contains("\"final\""), "{error}");
    }

    #[test]
    fn what_a_stage_does_not_have_yet_is_refused() {
        for (variant, key) in [
            ("03-phong-sky", "emission = [0, 0, 0]"),
            ("08-less-green", "sun_brightness = 3.0"),
            ("09-broken-sun", "depth_fog = true"),
        ] {
            let error = read(&format!("variant = \"{variant}\"\n{key}")).unwrap_err();
            assert!(error.starts_with("sea.toml:4: five-sample.") && error.contains("final"), "{error}");
        }
        let scene = read("variant = \"09-broken-sun\"\nemission = [0, 0, 0]").unwrap();
        assert!(Scene::from_toml(&scene.to_toml().unwrap(), "again").is_ok());
        assert!(read("waves_meet_land = true\ndepth_fog = true").is_ok());
    }
}

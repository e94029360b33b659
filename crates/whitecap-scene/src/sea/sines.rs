//! Settings of a sea of four sines.

use whitecap_waves::model::sines::{self, SineWave, SumOfSines, SumOfSinesParameters};

use super::wave::{WAVES, Wave};
use super::{SeaModel, SeaSurface};
use crate::error::SceneError;
use crate::key::{OneOf, Real, optional, or, table, words};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<SeaModel> = Registered {
    word: "sines",
    summary: "a sum of four sines by a Taylor series (ATI, ShaderX 2002)",
    keys: SinesSettings::keys,
    read: |table| SinesSettings::read_keys(table).map(SeaModel::Sines),
};

words! {
    /// How sine and cosine are calculated.
    pub enum Taylor {
        /// With the text's constants, whose −0.16161616 and 1.02 belong together.
        Printed = "printed",
        /// With the series' true coefficients, without the factor 1.02, and with arguments folded to within a
        /// quarter turn of 0, where four terms suffice: true to 2e-4, and no wave jumps where its period ends.
        Mended = "mended",
    }
}

table! {
    /// A sum of four sines: the table `[sea]` with `model = "sines"`.
    pub struct SinesSettings {
        /// The waves, `[[sea.wave]]`.
        wave: Option<Vec<Wave>> = optional(WAVES, "those of the text");
        /// How sine and cosine are calculated.
        taylor: Taylor = or(OneOf::<Taylor>::WORDS, Taylor::Printed);
        /// How far the waves tilt the normal, for each unit of height.
        slope_factor: f64 = or(Real { unit: "", min: 0.0, max: 1.0 }, 0.003);
        /// The length that one of the text's units of height stands for.
        unit_m: f64 = or(Real { unit: "m", min: 1e-6, max: 10.0 }, 0.01);
        /// The length that one unit of the texture coordinate stands for; by default the one at which
        /// `slope_factor` is the true slope.
        uv_size_m: Option<f64> =
            optional(Real { unit: "m", min: 0.01, max: 10_000.0 }, "2π `unit_m` / `slope_factor`");
    }
}

impl SinesSettings {
    /// The parameters of the model, with the text's waves where the file has none.
    pub fn parameters(&self) -> SumOfSinesParameters {
        let texts = SumOfSinesParameters::default();
        let uv_size_m = self.uv_size_m.unwrap_or_else(|| {
            // At a slope factor of 0 no scale is true; the text's own serves.
            let factor = if self.slope_factor > 0.0 { self.slope_factor } else { texts.slope_factor };
            std::f64::consts::TAU * self.unit_m / factor
        });
        let mut waves = texts.waves;
        for (wave, settings) in waves.iter_mut().zip(self.wave.iter().flatten()) {
            *wave = SineWave {
                height: settings.height,
                offset_turns: settings.offset_turns,
                speed_turns_per_s: settings.speed_turns_per_s,
                direction_per_uv: settings.direction_per_uv.into(),
            };
        }
        let taylor = match self.taylor {
            Taylor::Printed => sines::Taylor::Printed,
            Taylor::Mended => sines::Taylor::Mended,
        };
        SumOfSinesParameters {
            waves,
            slope_factor: self.slope_factor,
            taylor,
            uv_size_m,
            unit_m: self.unit_m,
        }
    }

    pub(super) fn build(&self) -> Result<SeaSurface, SceneError> {
        let sines = SumOfSines::new(self.parameters());
        sines.map(SeaSurface::Sines).map_err(|error| SceneError::about_key("sea", error.to_string()))
    }
}

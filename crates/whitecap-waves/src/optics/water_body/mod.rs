//! The colour of water from what is in it.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | a, b, b_b | absorption, scattering, and scattering backwards | 1/m |
//! | Kd | diffuse attenuation of downward irradiance | 1/m |
//! | E | irradiance on a level plane just below the surface | any |
//! | R | upward over downward irradiance just below the surface | |
//! | Q | upward irradiance over upward radiance | sr |
//! | A | albedo of the bottom | |
//! | n | refractive index | |
//!
//! Colours are linear sRGB. Reflectances and scattering are averaged over a channel with [`channel_weights`]; light of
//! many wavelengths fades by no single exponential, so Kd of a channel is the one with which the channel falls to 1/e
//! where its light does.

mod jerlov;
mod light;
mod spectrum;
#[cfg(test)]
mod tests;

pub use jerlov::{Constituents, JerlovType, MEAN_COSINE, PURE_ABSORPTION_PER_M};
pub use light::{Daylight, WaterLight, crest_light, water_radiance};
pub use spectrum::{BANDS, WAVELENGTHS_NM, channel_weights, linear_srgb};

/// Water's optics by colour, linear sRGB.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaterOptics {
    /// Kd.
    pub attenuation_per_m: [f64; 3],
    /// b.
    pub scattering_per_m: [f64; 3],
    /// R of water without a bottom, 0.33 b_b/(a + b_b) (Gordon, Brown and Jacobs 1975; Morel and Prieur 1977).
    pub reflectance: [f64; 3],
}

/// R of water without a bottom.
fn reflectance(absorption: f64, backscattering: f64) -> f64 {
    0.33 * backscattering / (absorption + backscattering).max(1e-9)
}

impl From<JerlovType> for WaterOptics {
    fn from(kind: JerlovType) -> WaterOptics {
        let c = kind.constituents();
        let spectrum =
            std::array::from_fn(|band| reflectance(c.absorption_per_m[band], c.backscattering_per_m[band]));
        WaterOptics {
            attenuation_per_m: channel_attenuation_per_m(&kind.attenuation_per_m()),
            scattering_per_m: linear_srgb(&c.scattering_per_m),
            reflectance: linear_srgb(&spectrum),
        }
    }
}

impl WaterOptics {
    /// From a and b by colour. Of the scattering 1.83 % goes backwards, as measured in most natural water (Petzold
    /// 1972).
    pub fn from_coefficients(absorption_per_m: [f64; 3], scattering_per_m: [f64; 3]) -> WaterOptics {
        let back = scattering_per_m.map(|b| 0.0183 * b);
        WaterOptics {
            attenuation_per_m: std::array::from_fn(|i| (absorption_per_m[i] + back[i]) / MEAN_COSINE),
            scattering_per_m,
            reflectance: std::array::from_fn(|i| reflectance(absorption_per_m[i], back[i])),
        }
    }
}

/// Kd of each channel: 1/d, d where the channel's part of white light has fallen to 1/e.
fn channel_attenuation_per_m(attenuation_per_m: &[f64; BANDS]) -> [f64; 3] {
    channel_weights().map(|weights| {
        let left = |depth_m: f64| -> f64 {
            weights.iter().zip(attenuation_per_m).map(|(w, k)| w * libm::exp(-k * depth_m)).sum()
        };
        // By halves, from where everything is left to where nothing is.
        let (mut near, mut far) =
            (0.0, 10.0 / attenuation_per_m.iter().copied().fold(f64::INFINITY, f64::min));
        for _ in 0..60 {
            let middle = 0.5 * (near + far);
            if left(middle) > libm::exp(-1.0) { near = middle } else { far = middle }
        }
        1.0 / far
    })
}

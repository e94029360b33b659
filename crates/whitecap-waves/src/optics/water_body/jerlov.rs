//! Kinds of sea water by how fast daylight fades in them, and what they are made of.

use super::spectrum::{BANDS, WAVELENGTHS_NM};

/// Jerlov's types of water: I to III are oceans, from the clearest on, 1C to 9C are coasts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JerlovType {
    /// The clearest ocean.
    I,
    /// Clear ocean.
    IA,
    /// Clear ocean, a little greener.
    IB,
    /// Ocean with some life in it.
    II,
    /// Ocean rich in life.
    III,
    /// 1C, the clearest coast.
    C1,
    /// 3C, a green coast.
    C3,
    /// 5C, a turbid coast.
    C5,
    /// 7C, a very turbid coast.
    C7,
    /// 9C, the most turbid coast, brown.
    C9,
}

impl JerlovType {
    /// All of them, from clear to turbid.
    pub const ALL: [JerlovType; 10] = [
        JerlovType::I,
        JerlovType::IA,
        JerlovType::IB,
        JerlovType::II,
        JerlovType::III,
        JerlovType::C1,
        JerlovType::C3,
        JerlovType::C5,
        JerlovType::C7,
        JerlovType::C9,
    ];

    /// Kd, the diffuse attenuation of downward irradiance in 1/m, by band.
    ///
    /// I to 1C: Austin and Petzold, *SPIE* 489, 1984, their revision of Jerlov's table. The others: Jerlov, *Marine
    /// Optics*, 1976, table XXVII.
    pub fn attenuation_per_m(self) -> [f64; BANDS] {
        match self {
            JerlovType::I => [
                0.0217, 0.0185, 0.0176, 0.0184, 0.0280, 0.0504, 0.0640, 0.0931, 0.2408, 0.3174, 0.3559,
                0.4372, 0.6513,
            ],
            JerlovType::IA => [
                0.0316, 0.0280, 0.0257, 0.0250, 0.0332, 0.0545, 0.0674, 0.0960, 0.2437, 0.3206, 0.3601,
                0.4410, 0.6530,
            ],
            JerlovType::IB => [
                0.0438, 0.0395, 0.0355, 0.0330, 0.0396, 0.0596, 0.0715, 0.0995, 0.2471, 0.3245, 0.3652,
                0.4457, 0.6550,
            ],
            JerlovType::II => [
                0.0878, 0.0814, 0.0714, 0.0620, 0.0627, 0.0779, 0.0863, 0.1122, 0.2595, 0.3389, 0.3837,
                0.4626, 0.6623,
            ],
            JerlovType::III => [
                0.1697, 0.1594, 0.1381, 0.1160, 0.1056, 0.1120, 0.1139, 0.1359, 0.2826, 0.3655, 0.4181,
                0.4942, 0.6760,
            ],
            JerlovType::C1 => [
                0.2516, 0.2374, 0.2048, 0.1700, 0.1486, 0.1461, 0.1415, 0.1596, 0.3057, 0.3922, 0.4525,
                0.5257, 0.6896,
            ],
            JerlovType::C3 => [0.78, 0.54, 0.39, 0.29, 0.22, 0.20, 0.19, 0.21, 0.33, 0.40, 0.46, 0.56, 0.71],
            JerlovType::C5 => [1.1, 0.78, 0.56, 0.43, 0.36, 0.31, 0.30, 0.33, 0.40, 0.48, 0.54, 0.65, 0.80],
            JerlovType::C7 => [1.6, 1.2, 0.89, 0.71, 0.58, 0.49, 0.46, 0.46, 0.48, 0.54, 0.63, 0.78, 0.92],
            JerlovType::C9 => [2.4, 1.9, 1.6, 1.23, 0.99, 0.78, 0.63, 0.58, 0.60, 0.65, 0.76, 0.92, 1.1],
        }
    }

    /// What the water is made of.
    pub fn constituents(self) -> Constituents {
        let attenuation = self.attenuation_per_m();
        let chlorophyll = chlorophyll_mg_per_m3(attenuation[3] + 0.6 * (attenuation[4] - attenuation[3]));
        let mut out = Constituents {
            absorption_per_m: [0.0; BANDS],
            scattering_per_m: [0.0; BANDS],
            backscattering_per_m: [0.0; BANDS],
        };
        for (band, nm) in WAVELENGTHS_NM.into_iter().enumerate() {
            let water = pure_scattering_per_m(nm);
            let (particles, backward) = particle_scattering_per_m(chlorophyll, nm);
            let back = 0.5 * water + backward;
            out.scattering_per_m[band] = water + particles;
            out.backscattering_per_m[band] = back;
            out.absorption_per_m[band] =
                (MEAN_COSINE * attenuation[band] - back).max(PURE_ABSORPTION_PER_M[band]);
        }
        out
    }
}

/// What water does to light, by band, 1/m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constituents {
    /// a.
    pub absorption_per_m: [f64; BANDS],
    /// b, in all directions.
    pub scattering_per_m: [f64; BANDS],
    /// The part of scattering that turns light back, by more than a right angle.
    pub backscattering_per_m: [f64; BANDS],
}

/// (a + b_b)/Kd. Gordon, *Limnol. Oceanogr.* 34, 1989: Kd = 1.04 D (a + b_b), where D, the mean path per metre of
/// depth just below the surface, is 1.08 with the sun 30° from the zenith.
pub const MEAN_COSINE: f64 = 1.0 / (1.04 * 1.08);

/// Absorption of pure water, 1/m (Pope and Fry, *Appl. Opt.* 36, 1997).
pub const PURE_ABSORPTION_PER_M: [f64; BANDS] =
    [0.00663, 0.00478, 0.00922, 0.0114, 0.0204, 0.0417, 0.0565, 0.0772, 0.2224, 0.2834, 0.340, 0.448, 0.624];

/// Scattering of pure sea water, 1/m, half of it backwards (Morel 1974, as Mobley, *Light and Water*, 1994, has it).
fn pure_scattering_per_m(nm: f64) -> f64 {
    16.06 * 4.72e-4 * libm::pow(400.0 / nm, 4.32)
}

/// Chlorophyll from Kd at 490 nm, Kd = 0.0166 + 0.07242 C^0.68955 (Morel and Maritorena, *J. Geophys. Res.* 106,
/// 2001). It stands here for all that floats in the water, at coasts beyond what it was measured for.
fn chlorophyll_mg_per_m3(attenuation_490_per_m: f64) -> f64 {
    libm::pow((attenuation_490_per_m - 0.0166).max(1e-4) / 0.07242, 1.0 / 0.68955)
}

/// Scattering of particles, and the part of it that goes backwards, 1/m (Morel and Maritorena 2001, equations 12
/// to 14).
fn particle_scattering_per_m(chlorophyll: f64, nm: f64) -> (f64, f64) {
    let log = libm::log10(chlorophyll);
    let at_550 = 0.416 * libm::pow(chlorophyll, 0.766);
    let exponent = (0.5 * (log - 0.3)).min(0.0);
    let backward = 0.002 + 0.01 * (0.5 - 0.25 * log).max(0.0) * libm::pow(nm / 550.0, exponent);
    (at_550 * 550.0 / nm, at_550 * backward)
}

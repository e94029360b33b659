//! What the air is made of, and how it turns light away.
//!
//! Constants after Hillaire 2020 (table 1), for red, green and blue.

use glam::DVec3;
use std::f64::consts::PI;

/// Scattering by molecules at sea level, 1/km; it falls to 1/e over 8 km.
const RAYLEIGH_PER_KM: DVec3 = DVec3::new(0.005_802, 0.013_558, 0.033_1);
const RAYLEIGH_HEIGHT_KM: f64 = 8.0;

/// Scattering and extinction by aerosols at sea level on a clear maritime day, 1/km; they fall to 1/e over 1.2 km.
const MIE_SCATTERING_PER_KM: f64 = 0.003_996;
const MIE_EXTINCTION_PER_KM: f64 = 0.004_44;
const MIE_HEIGHT_KM: f64 = 1.2;

/// Asymmetry of the aerosols' phase function: the mean cosine that the formula's exponent is made for.
const MIE_ASYMMETRY: f64 = 0.8;

/// Absorption by ozone where it is densest, 1/km: at 25 km, falling evenly to nothing at 10 and 40 km.
pub(super) const OZONE_PER_KM: DVec3 = DVec3::new(0.000_650, 0.001_881, 0.000_085);
const OZONE_HEIGHT_KM: f64 = 25.0;
const OZONE_HALF_WIDTH_KM: f64 = 15.0;

/// Where its density has corners, km.
pub(super) const OZONE_EDGES_KM: [f64; 3] =
    [OZONE_HEIGHT_KM - OZONE_HALF_WIDTH_KM, OZONE_HEIGHT_KM, OZONE_HEIGHT_KM + OZONE_HALF_WIDTH_KM];

/// Its density at a height, as a share of the greatest.
pub(super) fn ozone(height_km: f64) -> f64 {
    (1.0 - (height_km - OZONE_HEIGHT_KM).abs() / OZONE_HALF_WIDTH_KM).max(0.0)
}

/// Coefficients at one height, 1/km.
#[derive(Clone, Copy, Debug)]
pub(super) struct Medium {
    /// Scattering by molecules.
    pub(super) rayleigh: DVec3,
    /// Scattering by aerosols.
    pub(super) mie: f64,
    /// Scattering and absorption by molecules and aerosols: what has no corners over the height.
    pub(super) smooth_extinction: DVec3,
    /// Ozone, as a share of its greatest density.
    pub(super) ozone: f64,
}

impl Medium {
    /// The air at `height_km`, with `haze` times the aerosols of a clear day.
    pub(super) fn at(height_km: f64, haze: f64) -> Medium {
        let rayleigh = RAYLEIGH_PER_KM * (-height_km / RAYLEIGH_HEIGHT_KM).exp();
        let aerosols = haze * (-height_km / MIE_HEIGHT_KM).exp();
        Medium {
            rayleigh,
            mie: MIE_SCATTERING_PER_KM * aerosols,
            smooth_extinction: rayleigh + MIE_EXTINCTION_PER_KM * aerosols,
            ozone: ozone(height_km),
        }
    }

    /// Scattering and absorption by all, 1/km.
    pub(super) fn extinction(&self) -> DVec3 {
        self.smooth_extinction + OZONE_PER_KM * self.ozone
    }

    /// Scattering by all, 1/km.
    pub(super) fn scattering(&self) -> DVec3 {
        self.rayleigh + self.mie
    }
}

/// The share of light, per steradian, that molecules turn by the angle whose cosine is `cos`.
pub fn rayleigh_phase(cos: f64) -> f64 {
    3.0 / (16.0 * PI) * (1.0 + cos * cos)
}

/// The same for aerosols: Cornette and Shanks 1992, the form that Hillaire uses.
pub fn mie_phase(cos: f64) -> f64 {
    let g = MIE_ASYMMETRY;
    let k = 3.0 / (8.0 * PI) * (1.0 - g * g) / (2.0 + g * g);
    k * (1.0 + cos * cos) / (1.0 + g * g - 2.0 * g * cos).powf(1.5)
}

//! Light at a rough sea: what a surface reflects whose slopes are finer than a pixel.
//!
//! Slopes that a pixel does not resolve are Gaussian about its mean slope, with a covariance that may differ by
//! direction. Waves hide one another as Smith has it: independently of their slope, by the mean slope and the
//! variance along the ray alone.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | ζ | slope of a facet, (dh/dx, dh/dz) |
//! | ñ | (−ζx, 1, −ζz): a facet's normal, as long as the facet is large over a unit of level area |
//! | m, C | mean and covariance of ζ |
//! | V, L, H | unit vectors towards the eye and the light, and half-way between them |
//! | v, c | V·ñ, what a facet shows the eye, and its mean |
//! | τ | standard deviation of v: √(Vₕᵀ C Vₕ), Vₕ the level part of V |
//! | z | c/τ |
//! | a, b | slope towards the eye and across it (to the left of one who looks from the eye) |
//! | Φ, φ | the normal distribution and its density |
//! | F | Fresnel reflectance |
//! | Λ | Smith's auxiliary function: what waves hide over what they show |
//!
//! Sources: Smith, *IEEE Trans. Antennas Propag.* 15, 1967 (masking); Ross, Dion and Potvin, *JOSA A* 22, 2005
//! (the same for two rays, with heights correlated); Bruneton, Neyret and Holzschuch, *Computer Graphics Forum*
//! 29, 2010 (the sea's reflection with both); Heitz, *JCGT* 3, 2014 (visible facets).

mod glitter;
mod masking;
mod reflection;
#[cfg(test)]
mod tests;
mod visible;

pub use glitter::sun_glitter;
pub use masking::{hidden_projection, shown_share};
pub use reflection::{ReflectionTap, SeaReflection, sea_reflection};
pub use visible::{VisibleFacets, visible_facets};

use glam::{DVec2, DVec3};

/// Refractive index of sea water at visible wavelengths, relative to air.
pub const SEA_REFRACTIVE_INDEX: f64 = 1.34;

/// Slopes of a piece of sea, (dh/dx, dh/dz).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// m.
    pub mean: DVec2,
    /// C.
    pub covariance: SlopeCovariance,
}

/// How slopes vary about their mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlopeCovariance {
    /// Variance of dh/dx.
    pub xx: f64,
    /// Covariance of dh/dx and dh/dz.
    pub xz: f64,
    /// Variance of dh/dz.
    pub zz: f64,
}

impl SlopeCovariance {
    /// uᵀ C w.
    pub fn between(&self, u: DVec2, w: DVec2) -> f64 {
        u.x * (self.xx * w.x + self.xz * w.y) + u.y * (self.xz * w.x + self.zz * w.y)
    }
}

/// The level part of a vector.
fn level(v: DVec3) -> DVec2 {
    DVec2::new(v.x, v.z)
}

//! What the water's surface, its volume and the air do to light.
//!
//! Each function is the f64 twin of a shader function of the same name, so that a test can hold one against
//! the other.

pub mod atmosphere;
pub mod classics;
mod color;
mod exposure;
mod foam;
mod fresnel;
mod geometry;
pub mod surface;
mod tone_map;
pub mod water_body;

pub use color::{WATER_REFRACTIVE_INDEX, WaterBody, water_color_lerp, water_color_single_scatter};
pub use exposure::{MAX_EXPOSURE, exposure_split};
pub use foam::{FOAM_ALBEDO, foam_cover, foam_drawn, foam_radiance, foam_rank};
pub use fresnel::{fresnel_exact, fresnel_jensen_golias};
pub use geometry::{curvature_drop_m, visible_cosine};
pub use tone_map::{tone_map_aces, tone_map_agx, tone_map_pbr_neutral};

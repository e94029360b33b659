//! Surfaces in time: the trait that every wave model implements, and the models.

use crate::query::{self, QueryError};
use crate::spline;
use glam::{DVec2, DVec3};
use std::any::Any;

mod calm;
mod fields;
pub mod perlin;
pub mod sines;
pub mod spectral;
pub mod trochoidal;

pub use calm::Calm;
pub use fields::TileFields;

/// A moving water surface that can be asked for any place and any time.
///
/// A surface maps a *rest point*, a place on the flat sea, and a time to a displaced point: the water that
/// lies at (x, z) when the sea is calm is at (x + dx, height, z + dz) at time `t`. Everything is a function of
/// the surface's parameters and the time alone: no clock, no state carried from one call to the next.
pub trait Surface: Send + Sync {
    /// The expected variance m0 of the height in m²: for a sum of waves of amplitudes a, ½Σa². The
    /// significant height is 4√m0.
    fn variance_m2(&self) -> f64;

    /// The surface over the rest point `rest_m` (`.x` east, `.y` south) at `time_s`: exact at any place,
    /// independent of any grid.
    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint;

    /// The water over each of `places_m` (`.x` east, `.y` south) at `time_s`, in their order: the horizontal
    /// displacement is undone. See [`query`] for how exactly.
    ///
    /// # Errors
    ///
    /// If a place or the time is not finite.
    fn query(&self, places_m: &[DVec2], time_s: f64) -> Result<Vec<SurfacePoint>, QueryError> {
        query::one_by_one(self, places_m, time_s)
    }
}

/// A surface that repeats over a square tile and can fill one.
///
/// The displaced point of [`Surface`], its slopes and its gradients have the period of the tile in x and in
/// z.
///
/// # Implementing
///
/// A model answers the same question in two ways, and they must agree: [`evaluate`](Self::evaluate) fills a
/// whole tile in f32, as fast as it can; [`sample`](Surface::sample) answers for one point in f64, exactly.
/// Everything is a function of the model's parameters and the time alone: no clock, no state carried from
/// one call to the next. `evaluate` allocates nothing when `fields` already has the right size.
///
/// The whole of a model, one sine that runs east along the tile's side:
///
/// ```
/// use glam::{DVec2, DVec3};
/// use std::f64::consts::TAU;
/// use whitecap_waves::dispersion::Dispersion;
/// use whitecap_waves::model::{Surface, SurfacePoint, TileFields, WaveModel};
///
/// struct SingleSine { wavelength_m: f64, amplitude_m: f64, resolution: usize }
///
/// impl SingleSine {
///     /// Height, its slope along x and its rate of change.
///     fn wave(&self, x: f64, time_s: f64) -> (f64, f64, f64) {
///         let k = TAU / self.wavelength_m;
///         let omega = Dispersion::DEEP.angular_frequency(k);
///         let (sin, cos) = (k * x - omega * time_s).sin_cos();
///         (self.amplitude_m * cos, -self.amplitude_m * k * sin, self.amplitude_m * omega * sin)
///     }
/// }
///
/// impl Surface for SingleSine {
///     fn variance_m2(&self) -> f64 {
///         0.5 * self.amplitude_m * self.amplitude_m
///     }
///     fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
///         let (height, slope, rise) = self.wave(rest_m.x, time_s);
///         SurfacePoint {
///             displacement_m: DVec3::new(0.0, height, 0.0),
///             normal: DVec3::new(-slope, 1.0, 0.0).normalize(),
///             jacobian: 1.0,
///             slope: DVec2::new(slope, 0.0),
///             velocity_mps: DVec3::new(0.0, rise, 0.0),
///         }
///     }
/// }
///
/// impl WaveModel for SingleSine {
///     fn tile_size_m(&self) -> f64 {
///         self.wavelength_m
///     }
///     fn resolution(&self) -> usize {
///         self.resolution
///     }
///     fn evaluate(&mut self, time_s: f64, fields: &mut TileFields) {
///         let n = self.resolution;
///         fields.resize(n);
///         for i in 0..n * n {
///             let x = (i % n) as f64 * self.wavelength_m / n as f64;
///             let (height, slope, _) = self.wave(x, time_s);
///             fields.height[i] = height as f32;
///             fields.slope_x[i] = slope as f32;
///         }
///         // This model only moves water up and down and is level along z.
///         for flat in [
///             &mut fields.displacement_x, &mut fields.displacement_z, &mut fields.slope_z,
///             &mut fields.gradient_xx, &mut fields.gradient_xz, &mut fields.gradient_zz,
///         ] {
///             flat.fill(0.0);
///         }
///     }
/// }
///
/// let mut sine = SingleSine { wavelength_m: 20.0, amplitude_m: 0.5, resolution: 16 };
/// let mut fields = TileFields::new(16);
/// sine.evaluate(3.0, &mut fields);
/// let point = sine.sample(DVec2::new(5.0 * 20.0 / 16.0, 0.0), 3.0);
/// assert!((f64::from(fields.height[5]) - point.displacement_m.y).abs() < 1e-6);
/// ```
pub trait WaveModel: Surface + Any {
    /// The side of the tile in metres: the surface repeats with this period in x and in z.
    fn tile_size_m(&self) -> f64;

    /// Samples along a side of the tile, at least 1. Renderers draw up to 2048.
    fn resolution(&self) -> usize;

    /// All fields of the tile at `time_s`, equal to [`Surface::sample`] within their f32 rounding. Resizes
    /// `fields` where needed; allocates nothing otherwise.
    fn evaluate(&mut self, time_s: f64, fields: &mut TileFields);

    /// As [`evaluate`](Self::evaluate), but with coefficients of uniform cubic B-splines in place of the height's and
    /// the displacement's samples, for who draws the surface between them.
    ///
    /// At (x, z), counted in samples, a displacement is then Σ b(x − i) b(z − j) c(i, j), where b is the cubic B-spline:
    /// ⅔ − u² + ½|u|³ for |u| ≤ 1 and ⅙ (2 − |u|)³ from there to 2. Slopes and gradients stay samples. Without a better
    /// way the spline passes through the samples.
    fn evaluate_coefficients(&mut self, time_s: f64, fields: &mut TileFields) {
        self.evaluate(time_s, fields);
        let n = fields.resolution();
        for field in [&mut fields.height, &mut fields.displacement_x, &mut fields.displacement_z] {
            spline::interpolate(field, n);
        }
    }
}

/// The surface over one rest point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Where the water is, relative to its rest point: x east, y up, z south, in metres.
    pub displacement_m: DVec3,
    /// The unit normal of the displaced surface. Its y has the sign of the Jacobian: above 0 unless the
    /// surface folds over itself.
    pub normal: DVec3,
    /// The area of the displaced surface, seen from above, per area at rest: 1 on calm water, small where
    /// waves crowd into a crest, below 0 where the surface folds over itself.
    pub jacobian: f64,
    /// The derivatives of the height by the rest coordinates x and z.
    pub slope: DVec2,
    /// How the water moves, in m/s: x east, y up, z south.
    pub velocity_mps: DVec3,
}

impl SurfacePoint {
    /// The point of a surface that only rises and falls, at this height in metres, with these slopes and rising at
    /// `rise_mps`.
    pub(crate) fn upright(height_m: f64, slope: DVec2, rise_mps: f64) -> Self {
        Self {
            displacement_m: DVec3::new(0.0, height_m, 0.0),
            normal: DVec3::new(-slope.x, 1.0, -slope.y).normalize(),
            jacobian: 1.0,
            slope,
            velocity_mps: DVec3::new(0.0, rise_mps, 0.0),
        }
    }

    /// The height over the calm sea in metres.
    pub fn height_m(&self) -> f64 {
        self.displacement_m.y
    }
}

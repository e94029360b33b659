//! The sum of four sines of "Rendering Ocean Water" (Isidoro, Vlachos and Brennan, in *Direct3D ShaderX*, ATI
//! 2002), to the letter of its vertex shader.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | u, v | texture coordinates of the plane, which are also its map | uv |
//! | p | phase of a wave | turns |
//! | f | fract(p) | turns |
//! | x | f carried to the range of the series | rad |
//! | s, q | the Taylor polynomials of sine and cosine at x | |
//! | H | height of a wave | text units |
//! | h | ΣsH, what the plane is raised by | text units |
//! | nx, ny | −Σ q H ∂p/∂u, −Σ q H ∂p/∂v | |
//! | N, T, Bi | normal, tangent along v, and T × N | |
//!
//! # Two spaces
//!
//! The text's space has x and y along u and v and z up. Here its x (u) is the world's x (east), its y (v) the
//! world's z (south) and its z the world's y (up), and uv = rest / `uv_size_m`, height = h · `unit_m`.
//! [`SumOfSines::at_uv`] answers in the text's space and units, [`Surface::sample`] in the world's.
//!
//! # The scale
//!
//! The text gives neither the size of its plane nor that of its unit. One relation between the two is implied.
//! Height over place has the derivative 2π (`unit_m` / `uv_size_m`) Σ q H ∂p/∂u (by the chain rule, since the
//! series runs over 2π a turn), and the text takes 0.003 Σ q H ∂p/∂u. Both agree for `uv_size_m` =
//! 2π · `unit_m` / 0.003, the default scale: with a unit of 1 cm it is 20.94395 m, the waves of height 80 and
//! 100 are then 0.8 m and 1 m of amplitude, 84 m and 140 m long. What is left between the text's normal and
//! the true one is the factor 1.02 and the error of the printed series.

use super::{Surface, SurfacePoint};
use crate::error::{ParameterError, check};
use glam::{DVec2, DVec3};

mod taylor;
#[cfg(test)]
mod tests;

pub use taylor::{Series, Taylor, range_reduced, taylor_cosine, taylor_sine};

/// One of the four waves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SineWave {
    /// H in the text's units, within ±1e6; c11.
    pub height: f64,
    /// The phase at the origin and time 0, in turns, within ±1e6; c12.
    pub offset_turns: f64,
    /// How the phase grows, in turns per second, within ±1e3; c13. A phase that grows moves the wave *against*
    /// `direction_per_uv`.
    pub speed_turns_per_s: f64,
    /// (∂p/∂u, ∂p/∂v): direction and frequency at once, in turns per unit of u and v, each within ±1e3; c14
    /// and c15.
    pub direction_per_uv: DVec2,
}

/// What a [`SumOfSines`] is made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SumOfSinesParameters {
    /// The four waves.
    pub waves: [SineWave; 4],
    /// What tilts normal and tangent per unit of nx and ny, from 0 to 1; c10.y.
    pub slope_factor: f64,
    /// Which series stands for sine and cosine.
    pub taylor: Taylor,
    /// Metres along which u or v grow by 1, above 0 and at most 1e6.
    pub uv_size_m: f64,
    /// Metres of the text's unit of height, above 0 and at most 1e3.
    pub unit_m: f64,
}

impl SumOfSinesParameters {
    /// The constants of the text (c10 to c15), at the scale at which its slopes are true.
    pub const OCEAN_WATER: Self = Self {
        waves: [
            wave(80.0, 0.0, 0.2, 0.25, 0.0),
            wave(100.0, 0.2, 0.15, 0.0, 0.15),
            wave(5.0, 0.0, 0.4, -0.7, -0.7),
            wave(5.0, 0.0, 0.4, -0.8, 0.1),
        ],
        slope_factor: 0.003,
        taylor: Taylor::Printed,
        uv_size_m: std::f64::consts::TAU / 0.003 * 0.01,
        unit_m: 0.01,
    };
}

impl Default for SumOfSinesParameters {
    fn default() -> Self {
        Self::OCEAN_WATER
    }
}

const fn wave(
    height: f64,
    offset_turns: f64,
    speed_turns_per_s: f64,
    along_u: f64,
    along_v: f64,
) -> SineWave {
    SineWave { height, offset_turns, speed_turns_per_s, direction_per_uv: DVec2::new(along_u, along_v) }
}

/// What the vertex shader of the text makes of a vertex, in the text's axes (x along u, y along v, z up) and
/// units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TextSurface {
    /// h, by which the vertex is raised.
    pub height: f64,
    /// (nx, ny), before the slope factor.
    pub derivatives: DVec2,
    /// N, of length 1; the text's oT5.
    pub normal: DVec3,
    /// T, of length 1, the tangent along v; the text's oT4. It is tilted by nx, as printed, where the
    /// derivative along v would be ny; N and T are therefore not at right angles.
    pub tangent: DVec3,
    /// T × N, not normalised; the text's oT3.
    pub binormal: DVec3,
}

/// Four sines of a plane's texture coordinates; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SumOfSines {
    parameters: SumOfSinesParameters,
}

impl SumOfSines {
    /// The surface for `parameters`, or which of them is out of its range.
    pub fn new(parameters: SumOfSinesParameters) -> Result<Self, ParameterError> {
        for SineWave { height, offset_turns, speed_turns_per_s, direction_per_uv } in parameters.waves {
            check("height", height, "within ±1e6", |h| h.abs() <= 1e6)?;
            check("offset_turns", offset_turns, "within ±1e6", |o| o.abs() <= 1e6)?;
            check("speed_turns_per_s", speed_turns_per_s, "within ±1e3", |s| s.abs() <= 1e3)?;
            for component in direction_per_uv.to_array() {
                check("direction_per_uv", component, "within ±1e3", |d| d.abs() <= 1e3)?;
            }
        }
        check("slope_factor", parameters.slope_factor, "from 0 to 1", |s| (0.0..=1.0).contains(&s))?;
        check("uv_size_m", parameters.uv_size_m, "above 0 and at most 1e6", |l| l > 0.0 && l <= 1e6)?;
        check("unit_m", parameters.unit_m, "above 0 and at most 1e3", |u| u > 0.0 && u <= 1e3)?;
        Ok(Self { parameters })
    }

    /// The parameters that the surface was made from.
    pub fn parameters(&self) -> &SumOfSinesParameters {
        &self.parameters
    }

    /// The texture coordinates of a rest point (`.x` east, `.y` south).
    pub fn uv(&self, rest_m: DVec2) -> DVec2 {
        rest_m / self.parameters.uv_size_m
    }

    /// The four phases at `uv`, from 0 to below 1 turn.
    ///
    /// A shader that is handed those of an origin near the eye adds ∂p/∂u Δu + ∂p/∂v Δv to them and
    /// sees small numbers only, wherever the eye is and whatever the time: for |`time_s`| ≤ 1e6 and 1,000 km of
    /// the default scale they are good to 1e-9 turns.
    pub fn phases(&self, uv: DVec2, time_s: f64) -> [f64; 4] {
        self.parameters.waves.map(|wave| {
            // Whole turns are dropped from each term by itself, before the terms can hide each other's digits.
            let terms = [wave.offset_turns, wave.speed_turns_per_s * time_s, wave.direction_per_uv.dot(uv)];
            fract(terms.map(fract).iter().sum())
        })
    }

    /// Steps 1 to 9 of the vertex shader at a vertex of the plane: what it makes of height, normal and tangent
    /// frame. `damp` (v5.x) is 0 for full waves and 1 for none, as at a shore.
    pub fn at_uv(&self, uv: DVec2, time_s: f64, damp: f64) -> TextSurface {
        let SumOfSinesParameters { waves, slope_factor, taylor, .. } = &self.parameters;
        let series = taylor.series();
        let mut height = 0.0;
        let mut derivatives = DVec2::ZERO;
        for (wave, phase) in waves.iter().zip(self.phases(uv, time_s)) {
            let x = series.range_reduced(phase);
            height += series.sine(x) * (1.0 - damp) * wave.height;
            derivatives -= series.cosine(x) * (1.0 - damp) * wave.height * wave.direction_per_uv;
        }
        let normal = DVec3::Z + (slope_factor * derivatives).extend(0.0);
        let tangent = DVec3::new(0.0, 1.0, -derivatives.x * slope_factor);
        let (normal, tangent) = (normal.normalize(), tangent.normalize());
        TextSurface { height, derivatives, normal, tangent, binormal: tangent.cross(normal) }
    }

    /// The highest that |height| can get, in metres: every wave at its extreme at once.
    pub fn max_height_m(&self) -> f64 {
        let heights: f64 = self.parameters.waves.iter().map(|wave| wave.height.abs()).sum();
        heights * self.parameters.taylor.series().max_sine() * self.parameters.unit_m
    }
}

impl Surface for SumOfSines {
    /// For four waves that differ in direction or speed. Waves without both, that stand still everywhere,
    /// count as if they moved.
    fn variance_m2(&self) -> f64 {
        let one = self.parameters.taylor.series().sine_variance();
        let unit = self.parameters.unit_m;
        self.parameters.waves.iter().map(|wave| one * (wave.height * unit) * (wave.height * unit)).sum()
    }

    /// The surface that the shader draws, undamped: slope and normal are the derivatives of the polynomial
    /// itself, not the text's shading normal, which is [`SumOfSines::at_uv`]'s.
    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        let SumOfSinesParameters { waves, taylor, uv_size_m, unit_m, .. } = &self.parameters;
        let series = taylor.series();
        let (mut height, mut slope, mut rise) = (0.0, DVec2::ZERO, 0.0);
        for (wave, phase) in waves.iter().zip(self.phases(self.uv(rest_m), time_s)) {
            let x = series.range_reduced(phase);
            let per_turn = wave.height * series.sine_derivative(x) * series.radians_per_turn();
            height += wave.height * series.sine(x);
            slope += per_turn * wave.direction_per_uv;
            rise += per_turn * wave.speed_turns_per_s;
        }
        SurfacePoint::upright(unit_m * height, unit_m / uv_size_m * slope, unit_m * rise)
    }
}

/// x − floor(x), as `frc` and the shader language's `fract`.
fn fract(x: f64) -> f64 {
    x - x.floor()
}

//! The sea as numbers: wave spectra, dispersion, surface synthesis, its statistics, and the optics of water.
//!
//! Everything here runs on the CPU and is a pure function of its parameters, a seed and a time in seconds.
//! Nothing reads a file, asks a clock or knows of a graphics card.
//!
//! | module | what it holds |
//! | --- | --- |
//! | [`spectrum`] | how the sea's energy is spread over wave lengths and directions |
//! | [`spreading`] | how waves of one frequency are spread over directions |
//! | [`dispersion`] | how fast a wave of a given length runs |
//! | [`model`] | surfaces in time: the [`Surface`](model::Surface) trait, the spectral sea, four sines, animated noise |
//! | [`query`] | the surface over any places, in batches |
//! | [`field`] | still fields from a seed: heights, normal maps and their mips |
//! | [`statistics`] | what a surface turned out to be: moments and significant height |
//! | [`optics`] | what its interface and its volume do to light |
//! | [`transform`] | the inverse Fourier transform underneath |
//! | [`direction`] | nautical bearings to vectors |
//!
//! # Conventions
//!
//! The world is right-handed with y up, x east and z south; lengths are metres, times seconds, angles
//! radians. A horizontal point or vector is a [`glam::DVec2`] whose `.x` is x (east) and whose `.y` is **z
//! (south)**. Directions are those a wave travels *towards*; [`direction::toward_from_nautical`] converts
//! the seaman's "wind from the west". The undisturbed surface is y = 0.
//!
//! # Example
//!
//! A fully developed sea under a 10 m/s wind from the west, and its significant wave height:
//!
//! ```
//! use whitecap_waves::direction::toward_from_nautical;
//! use whitecap_waves::model::spectral::{Amplitudes, Band, SpectralTile, SpectralTileParameters, Water};
//! use whitecap_waves::model::{TileFields, WaveModel};
//! use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
//! use whitecap_waves::statistics::{Moments, significant_height_m};
//!
//! let wind_sea = Phillips::new(PhillipsParameters {
//!     wind_speed_mps: 10.0,
//!     toward: toward_from_nautical(270.0),
//!     significant_height_m: None,
//!     opposing_energy: 0.0,
//!     small_wave_cutoff_m: 0.0,
//! })?;
//! let mut sea = SpectralTile::new(
//!     SpectralTileParameters {
//!         tile_size_m: 400.0,
//!         resolution: 256,
//!         band: Band::WHOLE,
//!         choppiness: 1.0,
//!         water: Water::STILL,
//!         seed: 7,
//!         amplitudes: Amplitudes::Deterministic,
//!     },
//!     &[wind_sea],
//! )?;
//!
//! let mut fields = TileFields::new(sea.resolution());
//! sea.evaluate(12.5, &mut fields);
//! let height_m = significant_height_m(Moments::of(&fields.height).variance);
//! println!("significant height {height_m:.2} m");
//! assert!((height_m - 2.133).abs() < 0.02);
//! # Ok::<(), whitecap_waves::ParameterError>(())
//! ```
//!
//! # Determinism
//!
//! The same parameters, seed and time give the same bits on every run and for every number of threads, with
//! the `parallel` feature and without. Between machines with different vector instructions the transform may
//! round differently, by about one part in 10⁷ of the significant height; the random phases and amplitudes
//! of the waves are the same everywhere.

pub mod direction;
pub mod dispersion;
mod error;
pub mod field;
pub mod model;
pub mod optics;
pub mod query;
mod random;
pub mod spectrum;
mod spline;
pub mod spreading;
pub mod statistics;
pub mod transform;
mod turns;

pub use error::{ParameterError, Remedy};

/// The acceleration of gravity in m/s², the value every formula of this crate uses.
pub const GRAVITY_MPS2: f64 = 9.81;

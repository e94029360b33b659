//! What a whitecap scene file says.
//!
//! A scene file is TOML: a technique, a sea, a sky and a camera. [`open`] reads one by name or by path,
//! [`Scene::from_toml`] from text. Whatever it says is checked before anything is built: numbers against their
//! ranges, words against the registries, the waves against their tile. A mistake is one sentence that names the
//! file, the line, the key, what was found and what is accepted.
//!
//! ```
//! use whitecap_scene::{Scene, Sky};
//!
//! let scene = whitecap_scene::open("meshuggah")?;
//! assert!(matches!(scene.sky, Sky::Atmosphere(_)));
//! let sea = scene.sea.build(scene.seed)?;
//! assert!(sea.variance_m2() > 0.0);
//!
//! let error = Scene::from_toml("seed = 7\n[sea]\ntile_size_m = -3\n", "storm.toml").unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "storm.toml:3: sea.tile_size_m = -3: out of range; accepted: 1 to 100000 m"
//! );
//! # Ok::<(), whitecap_scene::SceneError>(())
//! ```
//!
//! Every key is declared once, in the table that it belongs to, with its range, unit, default and meaning;
//! [`reference::reference`] lists them all. The choices a file makes by a word are registries:
//! [`technique::ALL`], [`sea::MODELS`], [`sea::system::SPECTRA`] and [`sky::ALL`]; [`named::ALL`] holds the
//! scenes that come with the library.
//!
//! [`panorama::Panorama`] reads the pictures that a sky can be made of; [`mesh`] makes and reads solid things.

mod camera;
mod error;
mod key;
pub mod measured;
pub mod mesh;
pub mod named;
pub mod object;
pub mod panorama;
mod picture;
mod reader;
pub mod reference;
mod registry;
mod scene;
pub mod sea;
pub mod sky;
mod surface;
pub mod technique;

pub use camera::Camera;
pub use error::SceneError;
pub use picture::{Picture, ToneMap};
pub use registry::Registered;
pub use scene::{Scene, open, open_named};
pub use sea::Sea;
pub use sky::Sky;
pub use surface::SceneSurface;
pub use technique::Technique;

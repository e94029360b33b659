//! The water on screen: whitecap's techniques on wgpu.
//!
//! [`Water`] is water for your own frame, in wgpu's middleware pattern. [`picture::render_picture`]
//! makes a picture without a window. The folders are the parts of a frame:
//!
//! - [`gpu`]: a device without a window, errors, read-back;
//! - [`environment`]: the light around, as a prefiltered cube map;
//! - [`surface`]: how a wave model reaches the GPU;
//! - [`geometry`]: the meshes it is drawn on;
//! - [`technique`]: the ways to draw it;
//! - `pass`: what techniques share: the sky, the objects, mirror and refraction maps;
//! - [`shader_lib`]: the shaders, linked from WESL when the crate is built.

pub mod environment;
pub mod geometry;
pub mod gpu;
mod pass;
pub mod picture;
pub mod shader_lib;
pub mod surface;
mod target;
pub mod technique;
mod threads;
mod timing;
mod uniforms;
mod view;
mod water;

#[cfg(not(target_arch = "wasm32"))]
pub use gpu::list_adapters;
pub use gpu::{AdapterDescription, Gpu, RenderError};
pub use target::{Stores, TargetFormat};
pub use timing::{FeatureTime, PassTime};
pub use uniforms::MAX_VIEWS;
pub use view::View;
pub use water::{Water, WaterOptions};

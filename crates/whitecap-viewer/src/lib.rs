//! A window on whitecap's water.
//!
//! [`view`] opens a scene in a window, with cameras, a clock and every setting of the scene, and returns when the window is
//! closed. The parts:
//!
//! - [`document`]: the scene as its file says it, changed key by key, with undo;
//! - [`camera`]: ways to move through it;
//! - [`clock`]: the scene's time;
//! - [`link`]: a view as the fragment of an address;
//! - [`actions`]: what keys do, the list that help and docs are made of;
//! - `stage`: the water that is drawn; `window`: the surface it is drawn on; `panel`: the settings; `app`: their events;
//!   `host`: the desktop or the page that the window is on.
//!
//! Compiled to WebAssembly, `view_on` takes the place of [`view`]: the same viewer on a canvas of a page.

pub mod actions;
mod app;
pub mod camera;
pub mod clock;
pub mod document;
mod error;
#[cfg(target_arch = "wasm32")]
mod fonts;
mod host;
pub mod link;
mod panel;
mod stage;
mod window;

pub use error::ViewError;
#[cfg(target_arch = "wasm32")]
pub use host::{Page, Remote, view_on};
#[cfg(not(target_arch = "wasm32"))]
pub use host::{ViewOptions, view};

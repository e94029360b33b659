//! A window on whitecap's water.
//!
//! [`view`] opens a scene in a window, with cameras, a clock and every setting of the scene, and returns when the window is
//! closed. The parts:
//!
//! - [`document`]: the scene as its file says it, changed key by key, with undo;
//! - [`camera`]: ways to move through it;
//! - [`clock`]: the scene's time;
//! - [`actions`]: what keys do, the list that help and docs are made of;
//! - `stage`: the water that is drawn; `window`: the surface it is drawn on; `panel`: the settings; `app`: their events.

pub mod actions;
mod app;
pub mod camera;
pub mod clock;
pub mod document;
mod error;
mod panel;
mod stage;
mod window;

pub use app::{ViewOptions, view};
pub use error::ViewError;

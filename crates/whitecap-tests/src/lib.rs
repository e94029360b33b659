//! What whitecap's crates promise together, and the means to test it.
//!
//! - [`adapter`]: the adapter that GPU tests share, and what happens where there is none;
//! - [`compare`]: how much two pictures differ to an eye;
//! - [`golden`]: pictures that somebody looked at and every change is measured against;
//! - [`repository`]: the files that the documentation speaks of.

pub mod compare;
pub mod golden;
pub mod repository;

pub use whitecap_render::gpu::for_tests as adapter;

/// Compiles and runs the Rust that the README shows.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
pub struct Readme;

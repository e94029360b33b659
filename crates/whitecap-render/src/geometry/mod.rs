//! Meshes that the water is drawn on.

pub mod projected_grid;
mod tiled_grid;

pub use projected_grid::ProjectedGrid;
pub use tiled_grid::TiledGrid;

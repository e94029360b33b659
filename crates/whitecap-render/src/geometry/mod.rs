//! Meshes that the water is drawn on.

mod tiled_grid;

pub use tiled_grid::TiledGrid;

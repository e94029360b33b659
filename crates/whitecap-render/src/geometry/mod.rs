//! Meshes that the water is drawn on.

mod square_grid;
mod tiled_grid;

pub use square_grid::SquareGrid;
pub use tiled_grid::TiledGrid;

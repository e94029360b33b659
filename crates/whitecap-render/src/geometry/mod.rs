//! Meshes that the water is drawn on.

mod n_patches;
mod nested_grid;
pub mod projected_grid;
mod square_grid;
mod tiled_grid;

pub use n_patches::NPatches;
pub use nested_grid::{NestedGrid, Part};
pub use projected_grid::ProjectedGrid;
pub use square_grid::SquareGrid;
pub use tiled_grid::TiledGrid;

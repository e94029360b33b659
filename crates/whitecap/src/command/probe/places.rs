//! Where the surface is asked for, a chunk at a time.

use super::super::options::Place;
use super::super::series::Grid;
use super::points::Points;
use crate::failure::Failure;

/// The most places in a chunk.
pub(super) const CHUNK: usize = 4096;

/// Of the first chunk of a grid: small, so that whoever waits sees rows at once. Each one after it has twice as
/// many, up to [`CHUNK`].
const FIRST_CHUNK: usize = 64;

/// The places of one moment, in their order.
pub(super) struct Places<'a> {
    /// Those that are in memory.
    pub(super) held: Vec<Place>,
    /// Those that are read once, where there is only one moment to answer for.
    pub(super) points: Option<Points>,
    pub(super) grid: Option<&'a Grid>,
}

impl Places<'_> {
    /// Hands all places to `use_chunk`, until it or the reading fails.
    pub(super) fn for_each_chunk(
        &mut self,
        mut use_chunk: impl FnMut(&[Place]) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        self.held.chunks(CHUNK).try_for_each(&mut use_chunk)?;
        let mut chunk = Vec::new();
        if let Some(points) = &mut self.points {
            while points.read_chunk(&mut chunk)? {
                use_chunk(&chunk)?;
            }
        }
        let Some(grid) = self.grid else { return Ok(()) };
        let (mut places, mut size) = (grid.places(), FIRST_CHUNK);
        loop {
            chunk.clear();
            chunk.extend(places.by_ref().take(size));
            if chunk.is_empty() {
                return Ok(());
            }
            use_chunk(&chunk)?;
            size = CHUNK.min(2 * size);
        }
    }
}

//! Tables over two coordinates and how they are read.

use crate::transform::{for_each_run, thread_count};
use glam::DVec3;

/// A table of colours, row by row, read bilinearly; its outermost entries lie on the edges of its range.
#[derive(Clone, Debug)]
pub struct Table {
    size: [usize; 2],
    values: Vec<DVec3>,
}

impl Table {
    /// Calculates every entry from its column and row.
    pub(super) fn fill(size: [usize; 2], value: impl Fn(usize, usize) -> DVec3 + Sync) -> Table {
        let mut values = vec![DVec3::ZERO; size[0] * size[1]];
        let mut workers = vec![(); thread_count(values.len())];
        for_each_run(&mut values, size[0], &mut workers, |row, entries, ()| {
            for (column, entry) in entries.iter_mut().enumerate() {
                *entry = value(column, row);
            }
        });
        Table { size, values }
    }

    /// Columns and rows.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The entries, row by row.
    pub fn values(&self) -> &[DVec3] {
        &self.values
    }

    /// Between the four entries around a column and row, which need not be whole; what lies outside is the edge.
    pub(super) fn sample(&self, column: f64, row: f64) -> DVec3 {
        let place = |c: f64, n: usize| {
            let c = c.clamp(0.0, (n - 1) as f64);
            let low = (c as usize).min(n.saturating_sub(2));
            (low, c - low as f64)
        };
        let ((x, fx), (y, fy)) = (place(column, self.size[0]), place(row, self.size[1]));
        let at = |x: usize, y: usize| self.values[y * self.size[0] + x];
        at(x, y).lerp(at(x + 1, y), fx).lerp(at(x, y + 1).lerp(at(x + 1, y + 1), fx), fy)
    }
}

/// What a table of fourth roots stands for. Light that falls by ten powers of ten while the sun sinks or a ray grows has a
/// fourth root that is nearly straight between entries, and that a half float holds.
pub(super) fn fourth_power(root: DVec3) -> DVec3 {
    let square = root * root;
    square * square
}

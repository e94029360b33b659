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
        Table::fill_rows(size, |row, entries| {
            for (column, entry) in entries.iter_mut().enumerate() {
                *entry = value(column, row);
            }
        })
    }

    /// Lets `fill` calculate the entries of every row.
    pub(super) fn fill_rows(size: [usize; 2], fill: impl Fn(usize, &mut [DVec3]) + Sync) -> Table {
        let mut values = vec![DVec3::ZERO; size[0] * size[1]];
        let mut workers = vec![(); thread_count(values.len())];
        for_each_run(&mut values, size[0], &mut workers, |row, entries, ()| fill(row, entries));
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
        self.sample_row(column, place(row, self.size[1]))
    }

    /// The same where the row's [`place`] is known.
    pub(super) fn sample_row(&self, column: f64, (y, fy): (usize, f64)) -> DVec3 {
        let (x, fx) = place(column, self.size[0]);
        let at = |x: usize, y: usize| self.values[y * self.size[0] + x];
        at(x, y).lerp(at(x + 1, y), fx).lerp(at(x, y + 1).lerp(at(x + 1, y + 1), fx), fy)
    }

    /// A table of the same range with `times` as many intervals each way, between the entries by Catmull and Rom's cubic;
    /// nothing falls below 0.
    pub(super) fn refined(&self, times: usize) -> Table {
        let finer = |n: usize| (n - 1) * times + 1;
        let wide = Table::fill([finer(self.size[0]), self.size[1]], |column, row| {
            cubic(self.size[0], column, times, |x| self.values[row * self.size[0] + x])
        });
        Table::fill([wide.size[0], finer(self.size[1])], |column, row| {
            cubic(self.size[1], row, times, |y| wide.values[y * wide.size[0] + column]).max(DVec3::ZERO)
        })
    }
}

/// The entry below a place in a row or column of `n`, and how far beyond it the place is.
pub(super) fn place(at: f64, n: usize) -> (usize, f64) {
    let at = at.clamp(0.0, (n - 1) as f64);
    let low = (at as usize).min(n.saturating_sub(2));
    (low, at - low as f64)
}

/// Between `n` entries, `index` `times`-th parts of an interval from the first; beyond the ends they go on straight.
fn cubic(n: usize, index: usize, times: usize, at: impl Fn(usize) -> DVec3) -> DVec3 {
    let low = (index / times).min(n - 2);
    let part = (index - low * times) as f64 / times as f64;
    let (a, b) = (at(low), at(low + 1));
    let rise = b - a;
    let before = if low == 0 { rise } else { 0.5 * (b - at(low - 1)) };
    let after = if low + 2 == n { rise } else { 0.5 * (at(low + 2) - a) };
    a + part * (before + part * (3.0 * rise - 2.0 * before - after + part * (before + after - 2.0 * rise)))
}

/// What a table of fourth roots stands for. Light that falls by ten powers of ten while the sun sinks or a ray grows has a
/// fourth root that is nearly straight between entries, and that a half float holds.
pub(super) fn fourth_power(root: DVec3) -> DVec3 {
    let square = root * root;
    square * square
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refining_keeps_entries_and_parabolas() {
        let value = |x: f64, y: f64| DVec3::new(1.0 + x * x, y * y, x * y);
        let coarse = Table::fill([6, 5], |x, y| value(x as f64, y as f64));
        let fine = coarse.refined(3);
        assert_eq!(fine.size(), [16, 13]);
        for (x, y) in [(0, 0), (3, 6), (15, 12)] {
            assert_eq!(fine.values()[y * 16 + x], coarse.values()[y / 3 * 6 + x / 3]);
        }
        // Away from the ends.
        let found = fine.values()[5 * 16 + 7];
        assert!((found - value(7.0 / 3.0, 5.0 / 3.0)).abs().max_element() < 1e-12, "{found}");
    }
}

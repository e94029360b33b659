//! Finds the two grid points around a value without searching the whole grid.

/// The points of one side of a table, ascending, with an index over buckets of equal width.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Axis {
    points: Vec<f64>,
    /// For each bucket the number of points in those before it, and at last the number of all.
    before: Vec<usize>,
    buckets_per_unit: f64,
}

impl Axis {
    /// At least two points, strictly ascending and finite.
    pub(super) fn new(points: Vec<f64>) -> Self {
        // Four buckets for a point: most hold none or one, whatever the spacing.
        let buckets = 4 * points.len();
        let span = points.last().copied().unwrap_or(0.0) - points.first().copied().unwrap_or(0.0);
        let mut axis = Self { points, before: vec![0; buckets + 1], buckets_per_unit: buckets as f64 / span };
        for i in 0..axis.points.len() {
            let bucket = axis.bucket(axis.points[i]);
            axis.before[bucket + 1] += 1;
        }
        for bucket in 0..buckets {
            axis.before[bucket + 1] += axis.before[bucket];
        }
        axis
    }

    pub(super) fn points(&self) -> &[f64] {
        &self.points
    }

    /// The interval that holds `x` and where in it, 0..=1; `None` outside the axis and for NaN.
    #[inline]
    pub(super) fn find(&self, x: f64) -> Option<(usize, f64)> {
        let last = self.points.len() - 1;
        if !(self.points[0]..=self.points[last]).contains(&x) {
            return None;
        }
        // Buckets follow the order of the points, so every point of an earlier bucket is below x, and every
        // one of a later bucket above.
        let bucket = self.bucket(x);
        let (low, high) = (self.before[bucket], self.before[bucket + 1]);
        let not_above = low + self.points[low..high].partition_point(|&point| point <= x);
        let interval = not_above.saturating_sub(1).min(last - 1);
        let (from, to) = (self.points[interval], self.points[interval + 1]);
        Some((interval, (x - from) / (to - from)))
    }

    fn bucket(&self, x: f64) -> usize {
        (((x - self.points[0]) * self.buckets_per_unit) as usize).min(self.before.len() - 2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn ends_belong_to_the_axis_and_nothing_beyond() {
        let axis = Axis::new(vec![1.0, 2.0, 4.0]);
        assert_eq!(axis.find(1.0), Some((0, 0.0)));
        assert_eq!(axis.find(3.0), Some((1, 0.5)));
        assert_eq!(axis.find(4.0), Some((1, 1.0)));
        for x in [0.999, 4.001, f64::NAN, f64::INFINITY] {
            assert_eq!(axis.find(x), None);
        }
    }

    proptest! {
        /// Also where points crowd together, so that many share a bucket.
        #[test]
        fn the_interval_is_that_of_a_linear_search(
            mut points in prop::collection::vec((-6.0..3.0_f64).prop_map(libm::exp10), 2..40),
            share in 0.0..1.0_f64,
        ) {
            points.sort_by(f64::total_cmp);
            points.dedup();
            prop_assume!(points.len() >= 2);
            let axis = Axis::new(points.clone());
            let last = points.len() - 1;
            for x in points.iter().copied().chain([points[0] + share * (points[last] - points[0])]) {
                let expected = (0..last).rev().find(|&i| points[i] <= x).unwrap();
                let (interval, within) = axis.find(x).unwrap();
                prop_assert_eq!(interval, expected);
                prop_assert!((0.0..=1.0).contains(&within));
                let back = points[interval] + within * (points[interval + 1] - points[interval]);
                prop_assert!((back - x).abs() <= 1e-12 * x.abs().max(points[last]));
            }
        }
    }
}

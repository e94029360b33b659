//! Evenly spaced numbers, `A..B/N`: moments, and the two sides of a grid.

use super::options::{MAX_FAR, MAX_TIME_S, Place, whole_number, within};

/// `count` numbers from `from` to `to`, both included; `from` alone where there is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Series {
    pub(super) from: f64,
    pub(super) to: f64,
    /// At least 1.
    pub(super) count: u64,
}

impl Series {
    pub(super) fn values(self) -> impl Iterator<Item = f64> {
        (0..self.count).map(move |i| self.value(i))
    }

    fn value(self, i: u64) -> f64 {
        // The last is the end itself, without rounding.
        if i > 0 && i + 1 == self.count {
            return self.to;
        }
        let steps = self.count.saturating_sub(1).max(1);
        self.from + (self.to - self.from) * (i as f64 / steps as f64)
    }

    fn parse(text: &str, most: f64) -> Option<Self> {
        let (range, count) = text.split_once('/')?;
        let (from, to) = range.split_once("..")?;
        let count = whole_number(count).filter(|&count| count > 0)?;
        Some(Self { from: within(from, most)?, to: within(to, most)?, count })
    }
}

/// Places on a rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grid {
    pub(super) x_m: Series,
    pub(super) z_m: Series,
}

impl Grid {
    pub(super) fn count(self) -> u64 {
        self.x_m.count.saturating_mul(self.z_m.count)
    }

    /// From the first z to the last, x running fastest.
    pub(super) fn places(self) -> impl Iterator<Item = Place> {
        self.z_m.values().flat_map(move |z_m| self.x_m.values().map(move |x_m| [x_m, z_m]))
    }
}

pub(super) fn parse_times(text: &str) -> Result<Series, String> {
    Series::parse(text, MAX_TIME_S).ok_or_else(|| {
        format!(
            "accepted: A..B/N, N moments from A to B seconds, each from -{MAX_TIME_S} to {MAX_TIME_S}, such as \
             0..60/601"
        )
    })
}

pub(super) fn parse_grid(text: &str) -> Result<Grid, String> {
    let sides = text
        .split_once(',')
        .and_then(|(x, z)| Some(Grid { x_m: Series::parse(x, MAX_FAR)?, z_m: Series::parse(z, MAX_FAR)? }));
    sides.ok_or_else(|| {
        format!(
            "accepted: X0..X1/NX,Z0..Z1/NZ, NX places from X0 to X1 and NZ from Z0 to Z1 metres, each from \
             -{MAX_FAR} to {MAX_FAR}, such as -50..50/101,0..20/21"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_are_hit_exactly_and_the_steps_are_even() {
        let values: Vec<f64> = parse_times("-0.1..0.3/5").unwrap().values().collect();
        assert_eq!((values[0], values[4]), (-0.1, 0.3));
        for (i, value) in (0..).zip(&values) {
            assert!((value - (0.1 * f64::from(i) - 0.1)).abs() < 1e-15, "{values:?}");
        }
        assert!(parse_times("7..9/1").unwrap().values().eq([7.0]));
        assert!(parse_times("7..7/2").unwrap().values().eq([7.0, 7.0]));
        assert!(parse_times("3..1/3").unwrap().values().eq([3.0, 2.0, 1.0]), "backwards is a direction too");
    }

    #[test]
    fn a_grid_runs_along_x_first() {
        let grid = parse_grid("0..2/3,-1e1..10/2").unwrap();
        assert_eq!(grid.count(), 6);
        let expected = [[0.0, -10.0], [1.0, -10.0], [2.0, -10.0], [0.0, 10.0], [1.0, 10.0], [2.0, 10.0]];
        assert!(grid.places().eq(expected));
        assert_eq!(parse_grid("0..1/99999999999,0..1/99999999999").unwrap().count(), u64::MAX);
    }

    #[test]
    fn what_is_no_series_is_refused_with_an_example() {
        for text in [
            "",
            "1",
            "0..1",
            "0..1/",
            "0..1/0",
            "0..1/-3",
            "0..1/+3",
            "0..1/2.5",
            "a..b/2",
            "NaN..1/2",
            "0..inf/2",
            "0..1000001/2",
            "0..1/2/3",
            "0,1/2",
            "0..1/99999999999999999999",
        ] {
            assert!(parse_times(text).is_err_and(|message| message.contains("0..60/601")), "{text:?}");
            let grid = format!("{text},0..1/2");
            assert!(text == "0..1000001/2" || parse_grid(&grid).is_err(), "{grid:?}");
        }
        for text in ["0..1/2", "0..1/2,", "0..1/2,0..1/2,0..1/2", "0..10000001/2,0..1/2"] {
            assert!(
                parse_grid(text).is_err_and(|message| message.contains("-50..50/101,0..20/21")),
                "{text:?}"
            );
        }
    }
}

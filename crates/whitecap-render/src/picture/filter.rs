//! Where a supersampled still is sampled, in and around a pixel.
//!
//! Samples lie as dense as the filter is high and count alike (Ernst, Stamminger and Greiner 2006, "Filter Importance
//! Sampling"), so their weights add up to 1 and a flat field stays flat. The filter is the window of Blackman and Harris
//! with four terms (Harris 1978, table I), 3 pixels wide in each direction: film's filter in Blender's Cycles. It is
//! nowhere negative, so that the sun, a million times as bright as its sky, leaves no rings in linear light, as filters
//! with lobes (Mitchell, Lanczos) would.

use glam::DVec2;
use std::f64::consts::TAU;

/// The most samples a pixel.
pub const MAX_SAMPLES: u32 = 1024;

/// Half the filter's width, pixels.
pub const FILTER_RADIUS_PX: f64 = 1.5;

/// Its cosines' weights, from the constant on.
const TERMS: [f64; 4] = [0.35875, 0.48829, 0.14128, 0.01168];

/// 1 over the golden ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Offsets of `samples` samples from the pixel's centre, pixels right and down.
///
/// Before the filter bends them they are a Latin square: each of `samples` columns and rows holds one, in the order of
/// the golden ratio's multiples. Four of them are a rotated grid. So the picture is not shifted (the mean offset is 0),
/// one sample is the centre, and level and upright edges get as many shades as there are samples.
pub fn sample_offsets_px(samples: u32) -> Vec<DVec2> {
    let multiples: Vec<f64> = (0..samples).map(|i| (0.5 + f64::from(i) * GOLDEN).fract()).collect();
    let mut by_row: Vec<usize> = (0..multiples.len()).collect();
    by_row.sort_by(|&a, &b| multiples[a].total_cmp(&multiples[b]));
    let place = |i: usize| offset_px((i as f64 + 0.5) / f64::from(samples));
    let mut offsets = vec![DVec2::ZERO; multiples.len()];
    for (row, &column) in by_row.iter().enumerate() {
        offsets[column] = DVec2::new(place(column), place(row));
    }
    offsets
}

/// The filter's integral from its left end to `x`, which is in its widths from the middle.
fn share_left_of(x: f64) -> f64 {
    let wave = |k: usize| TERMS[k] * (TAU * k as f64 * x).sin() / (TAU * k as f64);
    0.5 + x + (wave(1) + wave(2) + wave(3)) / TERMS[0]
}

/// The offset that this share of the filter lies left of, pixels.
fn offset_px(share: f64) -> f64 {
    // One half of a symmetric filter: both halves then have the same digits.
    let (mut near, mut far) = (0.0, 0.5);
    let outside = share.min(1.0 - share);
    if outside == 0.5 {
        return 0.0;
    }
    for _ in 0..52 {
        let middle = 0.5 * (near + far);
        if share_left_of(-middle) > outside { near = middle } else { far = middle }
    }
    (2.0 * FILTER_RADIUS_PX * 0.5 * (near + far)).copysign(share - 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNTS: [u32; 9] = [1, 2, 3, 4, 7, 16, 64, 100, MAX_SAMPLES];

    #[test]
    fn the_filter_is_a_density() {
        assert!((share_left_of(-0.5)).abs() < 1e-15 && (share_left_of(0.5) - 1.0).abs() < 1e-15);
        let steps: Vec<f64> = (0..=1000).map(|i| share_left_of(f64::from(i) / 1000.0 - 0.5)).collect();
        assert!(steps.windows(2).all(|pair| pair[1] >= pair[0]), "it is negative somewhere");
        for i in 1..100 {
            let share = f64::from(i) / 100.0;
            let found = share_left_of(offset_px(share) / (2.0 * FILTER_RADIUS_PX));
            assert!((found - share).abs() < 1e-12, "{share}: {found}");
        }
    }

    #[test]
    fn one_sample_is_the_centre() {
        assert_eq!(sample_offsets_px(1), [DVec2::ZERO]);
        assert!(sample_offsets_px(0).is_empty());
    }

    #[test]
    fn samples_are_inside_apart_and_centred() {
        for count in COUNTS {
            let offsets = sample_offsets_px(count);
            assert_eq!(offsets.len(), count as usize);
            let mean = offsets.iter().sum::<DVec2>() / f64::from(count);
            assert!(mean.abs().max_element() < 1e-12, "{count} samples shift the picture by {mean}");
            assert!(offsets.iter().all(|offset| offset.abs().max_element() < FILTER_RADIUS_PX));
            let columns = |axis: fn(&DVec2) -> f64| {
                let mut sorted: Vec<f64> = offsets.iter().map(axis).collect();
                sorted.sort_by(f64::total_cmp);
                sorted.windows(2).all(|pair| pair[0] < pair[1])
            };
            assert!(columns(|o| o.x) && columns(|o| o.y), "{count}: two in one row or column");
        }
    }

    /// Second moments, which set how soft the picture is.
    #[test]
    fn samples_have_the_filters_spread_alike_in_all_directions() {
        let width = 2.0 * FILTER_RADIUS_PX;
        let steps = 10_000;
        let variance: f64 = (0..steps)
            .map(|i| {
                let x = (f64::from(i) + 0.5) / f64::from(steps) - 0.5;
                let height: f64 = (0..4).map(|k| TERMS[k] * (TAU * k as f64 * x).cos()).sum();
                (width * x).powi(2) * height / TERMS[0] / f64::from(steps)
            })
            .sum();
        for (count, within) in [(16, 0.12), (64, 0.04), (256, 0.015), (MAX_SAMPLES, 0.005)] {
            let offsets = sample_offsets_px(count);
            let moment = |f: fn(&DVec2) -> f64| offsets.iter().map(f).sum::<f64>() / f64::from(count);
            let (xx, yy, xy) = (moment(|o| o.x * o.x), moment(|o| o.y * o.y), moment(|o| o.x * o.y));
            assert!((xx / variance - 1.0).abs() < within, "{count}: {xx} of {variance}");
            assert!((yy / xx - 1.0).abs() < 1e-9, "{count}: {xx} and {yy}");
            assert!(xy.abs() < 0.1 * variance, "{count}: leans by {}", xy / variance);
        }
    }

    /// An edge of any direction and place: what the samples make of it against the filter itself.
    #[test]
    fn edges_get_better_with_every_sample() {
        let exact = sample_offsets_px(MAX_SAMPLES);
        let covered = |offsets: &[DVec2], toward: DVec2, place: f64| {
            offsets.iter().filter(|offset| offset.dot(toward) < place).count() as f64 / offsets.len() as f64
        };
        let error = |count: u32| {
            let offsets = sample_offsets_px(count);
            let mut sum = 0.0;
            for direction in 0..40 {
                let toward = DVec2::from_angle(f64::from(direction) * TAU / 40.0 + 0.03);
                for place in -8..=8 {
                    let place = 0.13 * f64::from(place);
                    sum += (covered(&offsets, toward, place) - covered(&exact, toward, place)).powi(2);
                }
            }
            (sum / (40.0 * 17.0)).sqrt()
        };
        let errors = [1, 4, 16, 64, 256].map(error);
        assert!(errors.windows(2).all(|pair| pair[1] < 0.5 * pair[0]), "{errors:?}");
        // Random samples would leave 0.5/√64.
        assert!(errors[3] < 0.02, "{errors:?}");
    }
}

//! Tone maps: from exposed, scene-referred linear Rec. 709 to display-referred linear Rec. 709 in [0, 1].
//!
//! Twins of `shader_lib/tone_map.wesl`. Constants are those that each curve was published with.

use glam::{DMat3, DVec3};

/// Rows of the matrix from linear Rec. 709 to the primaries in which AgX compresses.
const AGX_INSET: [[f64; 3]; 3] = [
    [0.842_479_062_253_094, 0.078_433_599_999_999_2, 0.079_223_745_147_764_3],
    [0.042_328_242_261_012_3, 0.878_468_636_469_772, 0.079_166_127_460_543],
    [0.042_375_654_905_705_1, 0.078_433_6, 0.879_142_973_793_104],
];
/// The range of log₂ of light that AgX maps to [0, 1].
const AGX_MIN_EV: f64 = -12.473_93;
const AGX_MAX_EV: f64 = 4.026_069;
/// AgX's base contrast as a polynomial of degree six, constant term first; off the published sigmoid by 6e-3 at most.
const AGX_CONTRAST: [f64; 7] = [-0.002_32, 0.119_1, 0.429_8, -6.868, 31.96, -40.14, 15.5];
/// The exponent of the display that AgX is encoded for.
const AGX_GAMMA: f64 = 2.2;

/// Rows of the matrices of Hill's fit: from linear Rec. 709 to the rendering's primaries and back.
const ACES_INPUT: [[f64; 3]; 3] =
    [[0.597_19, 0.354_58, 0.048_23], [0.076_00, 0.908_34, 0.015_66], [0.028_40, 0.133_83, 0.837_77]];
const ACES_OUTPUT: [[f64; 3]; 3] =
    [[1.604_75, -0.531_08, -0.073_67], [-0.102_08, 1.108_13, -0.006_05], [-0.003_27, -0.072_76, 1.076_02]];

fn matrix(rows: [[f64; 3]; 3]) -> DMat3 {
    DMat3::from_cols_array_2d(&rows).transpose()
}

/// AgX, the base look without grading: Sobotka, *AgX* (2022), in the polynomial form of Wrensch, "Minimal AgX
/// Implementation" (2023).
pub fn tone_map_agx(light: DVec3) -> DVec3 {
    let inset = matrix(AGX_INSET);
    let log = (inset * light).map(|c| c.max(1e-10).log2());
    let x = ((log - AGX_MIN_EV) / (AGX_MAX_EV - AGX_MIN_EV)).clamp(DVec3::ZERO, DVec3::ONE);
    let curve = AGX_CONTRAST.iter().rev().fold(DVec3::ZERO, |sum, c| sum * x + *c);
    let encoded = inset.inverse() * curve;
    encoded.clamp(DVec3::ZERO, DVec3::ONE).map(|c| c.powf(AGX_GAMMA))
}

/// The ACES reference rendering and output transform for Rec. 709, as fitted by S. Hill (2017).
///
/// The fit takes light that is brighter by 1/0.6 than the others do; that factor is in it, so that the curves can be
/// exchanged without a new exposure.
pub fn tone_map_aces(light: DVec3) -> DVec3 {
    let v = matrix(ACES_INPUT) * (light.max(DVec3::ZERO) / 0.6);
    let a = v * (v + 0.024_578_6) - 0.000_090_537;
    let b = v * (0.983_729 * v + 0.432_951_0) + 0.238_081;
    (matrix(ACES_OUTPUT) * (a / b)).clamp(DVec3::ZERO, DVec3::ONE)
}

/// Khronos PBR Neutral Tone Mapper, specification 1.0 (2024).
pub fn tone_map_pbr_neutral(light: DVec3) -> DVec3 {
    /// Reflectance of a dielectric facing the viewer, which the specification takes away again.
    const F90: f64 = 0.04;
    const START: f64 = 0.8 - F90;
    const DESATURATION: f64 = 0.15;
    let light = light.max(DVec3::ZERO);
    let least = light.min_element();
    let offset = if least < 2.0 * F90 { least - least * least / (4.0 * F90) } else { F90 };
    let color = light - offset;
    let peak = color.max_element();
    if peak < START {
        return color;
    }
    let room = 1.0 - START;
    let new_peak = 1.0 - room * room / (peak + room - START);
    let share = 1.0 - 1.0 / (DESATURATION * (peak - new_peak) + 1.0);
    (color * (new_peak / peak)).lerp(DVec3::splat(new_peak), share)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Map = fn(DVec3) -> DVec3;

    const ALL: [(&str, Map); 3] =
        [("agx", tone_map_agx), ("aces", tone_map_aces), ("pbr-neutral", tone_map_pbr_neutral)];

    #[test]
    fn greys_stay_grey_and_rise_from_black_to_white() {
        for (name, map) in ALL {
            let mut last = -1.0;
            for i in 0..400 {
                let light = 1e-4 * 1.05_f64.powi(i);
                let mapped = map(DVec3::splat(light));
                assert!(
                    mapped.max_element() - mapped.min_element() < 0.01,
                    "{name}: {light} became {mapped}"
                );
                assert!(mapped.y >= last - 1e-9, "{name} falls at {light}");
                assert!((0.0..=1.0).contains(&mapped.y), "{name}: {light} became {mapped}");
                last = mapped.y;
            }
            assert!(last > 0.97, "{name} ends at {last}");
            assert!(map(DVec3::ZERO).max_element() < 2e-3, "{name}: {}", map(DVec3::ZERO));
        }
    }

    /// Middle grey is shown as middle grey, within two thirds of a stop.
    #[test]
    fn middle_grey_stays_in_the_middle() {
        for (name, map) in ALL {
            let mapped = map(DVec3::splat(0.18)).y;
            assert!((0.11..0.29).contains(&mapped), "{name}: {mapped}");
        }
    }

    #[test]
    fn bright_colours_run_into_white() {
        for (name, map) in ALL {
            for color in [DVec3::new(1.0, 0.2, 0.05), DVec3::new(0.05, 0.2, 1.0)] {
                let saturation = |c: DVec3| (c.max_element() - c.min_element()) / c.max_element();
                let (dim, bright) = (saturation(map(color * 0.3)), saturation(map(color * 300.0)));
                assert!(bright < 0.7 * dim, "{name}: {dim} {bright}");
            }
        }
    }

    /// Below its shoulder PBR Neutral gives back the colour less what a dielectric reflects.
    #[test]
    fn pbr_neutral_keeps_colours() {
        let color = DVec3::new(0.5, 0.3, 0.2);
        assert!((tone_map_pbr_neutral(color) - (color - 0.04)).length() < 1e-12);
        assert!((tone_map_pbr_neutral(DVec3::splat(0.04)).x - 0.01).abs() < 1e-12);
    }

    /// The polynomial against the sigmoid that it stands for: slope 2 through middle grey, powers of 3 below and 3.25
    /// above.
    #[test]
    fn agx_follows_its_sigmoid() {
        let pivot = (0.18_f64.log2() - AGX_MIN_EV) / (AGX_MAX_EV - AGX_MIN_EV);
        for i in 0..=1000 {
            let x = f64::from(i) / 1000.0;
            let polynomial = AGX_CONTRAST.iter().rev().fold(0.0, |sum, c| sum * x + c);
            let (a, power) = if x < pivot { (59.507_875, 3.0) } else { (69.862_789, 3.25) };
            let sigmoid =
                0.5 + 2.0 * (x - pivot) * (1.0 + a * (x - pivot).abs().powf(power)).powf(-1.0 / power);
            assert!((polynomial - sigmoid).abs() < 6e-3, "{x}: {polynomial} {sigmoid}");
        }
    }
}

//! What of a wave system can be drawn, but is not found at sea.

use std::f64::consts::TAU;

use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::jonswap::fully_developed_fetch_m;

use super::asked::{Asked, Way};

/// γ of the sharpest peaks of the JONSWAP experiment.
const SHARPEST: f64 = 7.0;

/// The significant height over the depth beyond which waves break on the bottom faster than wind raises them
/// (Nelson, *Appl. Ocean Res.* 16, 1994, finds 0.55 for single waves on a level bottom).
const HIGHEST_OVER_DEPTH: f64 = 0.6;

/// The highest significant height that an instrument has measured: a buoy between Iceland and Britain in February 2013 (World
/// Meteorological Organization, 2016).
const HIGHEST_M: f64 = 19.0;

/// Where on the way between JONSWAP's short fetches and the open ocean growth ends is not known to better than a
/// factor: only beyond so many times the fetch of the fully developed sea is something said.
const FULL_FETCHES: f64 = 2.0;

/// How far the peak of a spectrum may lie from where it was asked to be before something is said.
const MOVED: f64 = 0.03;

/// What is unusual about a sea: how it was asked for, its significant height, its peak period and its γ.
pub(super) fn about(
    asked: &Asked,
    height_m: f64,
    period_s: f64,
    gamma: Option<f64>,
    water: &Dispersion,
) -> Vec<String> {
    let remedy = " (set a longer peak_period_s or a lower significant_height_m)";
    let mut warnings = about_waves(height_m, water.wave_number(TAU / period_s), water, remedy);
    if let Some(gamma) = gamma.filter(|&gamma| gamma > SHARPEST) {
        warnings
            .push(format!("gamma = {gamma} is a sharper peak than any measured; 1 to 7 are found at sea"));
    }
    if let Ok(Way::Wind { speed_mps, fetch_m: Some(fetch_m) }) = asked.way() {
        let full_m = fully_developed_fetch_m(speed_mps);
        if fetch_m > FULL_FETCHES * full_m {
            warnings.push(format!(
                "fetch_km = {}: a wind of {speed_mps:.1} m/s has raised its sea in full after about {:.0} km; over more \
                 water the formulas go on growing, the sea does not",
                fetch_m / 1000.0,
                full_m / 1000.0
            ));
        }
    }
    warnings
}

/// Where the greatest S(ω) is not at the period that was asked for, as where a bottom or a cutoff takes the energy
/// about the peak away.
pub(super) fn about_period(asked: &Asked, spectrum: &dyn WaveSpectrum, water: &Dispersion) -> Option<String> {
    const STEPS: u32 = 1500;
    let (asked_s, _) = asked.peak_period_s.zip(Some(spectrum.variance_m2()).filter(|m0| *m0 > 0.0))?;
    // From a quarter to four times the period, in steps of a fifth of a per cent.
    let period_s = |i: u32| asked_s * (4.0 * f64::from(i) / f64::from(STEPS) - 2.0).exp2();
    let density = |period_s: f64| {
        let k = water.wave_number(TAU / period_s);
        spectrum.omnidirectional_m3(k) / water.group_speed(k)
    };
    let found = (0..=STEPS).map(|i| (period_s(i), density(period_s(i)))).max_by(|a, b| a.1.total_cmp(&b.1));
    let found_s = found.map_or(asked_s, |(period_s, _)| period_s);
    ((found_s / asked_s - 1.0).abs() > MOVED).then(|| {
        format!(
            "peak_period_s = {asked_s}: the spectrum has its peak at {found_s:.2} s, as this depth, gamma or cutoff moves \
             it"
        )
    })
}

/// What is unusual about waves of this significant height and wave number of the peak; `remedy` is what can be done about
/// their steepness.
pub(super) fn about_waves(height_m: f64, wave_number: f64, water: &Dispersion, remedy: &str) -> Vec<String> {
    let mut warnings = Vec::new();
    let length_m = TAU / wave_number;
    let highest_m = steepest(TAU / water.angular_frequency(wave_number)) * length_m;
    if height_m > highest_m {
        warnings.push(format!(
            "steeper than a sea can be: {} m of significant height on waves {} m long; up to {} m would not break all \
             at once{remedy}",
            metres(height_m, 2),
            metres(length_m, 1),
            metres(highest_m, 2)
        ));
    }
    if height_m > HIGHEST_M {
        warnings.push(format!(
            "higher than any sea that was measured: {height_m:.1} m of significant height; the highest had {HIGHEST_M} m"
        ));
    }
    if height_m > HIGHEST_OVER_DEPTH * water.depth_m() {
        warnings.push(format!(
            "higher than the water can carry: {height_m:.2} m of significant height over depth_m = {}; waves \
             above {:.2} m break on the bottom",
            water.depth_m(),
            HIGHEST_OVER_DEPTH * water.depth_m()
        ));
    }
    warnings
}

/// So many decimals, or below a metre three digits.
pub(in crate::sea) fn metres(length_m: f64, decimals: usize) -> String {
    let digits = 2.0 - length_m.max(1e-9).log10().floor();
    let decimals = if length_m < 1.0 { digits as usize } else { decimals };
    format!("{length_m:.decimals$}")
}

/// The greatest significant height over the length of the peak's waves: 1/15 up to 8 s, 1/25 from 15 s, linear
/// between (DNV-RP-C205, *Environmental conditions and environmental loads*, section 3.5.5, there for waves of
/// deep water).
fn steepest(period_s: f64) -> f64 {
    let part = ((period_s - 8.0) / 7.0).clamp(0.0, 1.0);
    (1.0 - part) / 15.0 + part / 25.0
}

//! Measured seas: small files of every format with sums that can be done by hand, the choice of a record,
//! and files that lie, end early or hold what is no sea.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

mod bad;
mod formats;
mod hostile;
mod selection;

use whitecap_scene::measured::{Directions, MeasuredSea, from_bytes, from_bytes_with_directions};
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::tabulated::Tabulated;

/// Two hours of a buoy, newest first. By bands: Hs = 4√(0.01 · (1 + 4 + 2)) and 4√(0.01 · (1 + 0 + 2)).
pub(crate) const DATA_SPEC: &str = "\
#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) spec_3 (freq_3) ... >
2020 06 08 03 50 0.225 1.000 (0.100) 4.000 (0.110) 2.000 (0.120)
2020 06 08 02 50 9.999 1.000 (0.100) 999.0 (0.110) 2.000 (0.120)
2020 06 08 01 50 9.999 999.0 (0.100) 999.0 (0.110) MM (0.120)
2020 06 08 00 50 9.999 0.000 (0.100) 0.000 (0.110) 0.000 (0.120)
";

/// α₁, α₂, r₁, r₂ of the newest hour; the first frequency has no directions, the others come from the west.
pub(crate) const DIRECTIONS: [&str; 4] = [
    "#YY  MM DD hh mm alpha1_1 (freq_1) ... >\n2020 06 08 03 50 999.0 (0.100) 270.0 (0.110) 270.0 (0.120)\n",
    "#YY  MM DD hh mm alpha2_1 (freq_1) ... >\n2020 06 08 03 50 999.0 (0.100) 270.0 (0.110) 90.0 (0.120)\n",
    "#YY  MM DD hh mm r1_1 (freq_1) ... >\n2020 06 08 03 50 999.00 (0.100) 0.80 (0.110) 0.80 (0.120)\n",
    "#YY  MM DD hh mm r2_1 (freq_1) ... >\n2020 06 08 03 50 999.00 (0.100) 0.64 (0.110) 0.64 (0.120)\n",
];

/// As NDBC writes years of an hour a line: m0 = 0.01 · (0.5 + 3 + 1.5) and 0.01 · 1.
pub(crate) const HISTORY: &str = "\
YYYY MM DD hh   .090   .100   .110
2000 01 01 00    .50   3.00   1.50
2000 01 01 01    .00 999.00   1.00
";

/// Two points, two times. E = 2 everywhere at the first point: m0 = 2 · 2π · (0.2 − 0.1); later half of it.
/// At the second all waves of 0.15 Hz go towards the north-east.
pub(crate) const WW3: &str = "\
'WAVEWATCH III SPECTRA'      3     4     2 'points of a test'
  0.100E+00 0.150E+00
  0.200E+00
  0.785E+00  0.000E+00  0.471E+01  0.314E+01
20220912 060000
'first     '  40.98-171.12      46.6   1.45 225.6   0.18  94.1
  0.200E+01  0.200E+01  0.200E+01  0.200E+01  0.200E+01  0.200E+01  0.200E+01
  0.200E+01  0.200E+01  0.200E+01  0.200E+01  0.200E+01
'buoy 2    '  41.00 -71.00      46.6   1.45 225.6   0.18  94.1
  0.000E+00  0.300E+01  0.000E+00  0.000E+00  0.000E+00  0.000E+00  0.000E+00
  0.000E+00  0.000E+00  0.000E+00  0.000E+00  0.100-100
20220912 070000
'first     '  40.98-171.12      46.6   1.45 225.6   0.18  94.1
  0.100E+01  0.100E+01  0.100E+01  0.100E+01  0.100E+01  0.100E+01  0.100E+01
  0.100E+01  0.100E+01  0.100E+01  0.100E+01  0.100E+01
'buoy 2    '  41.00 -71.00      46.6   1.45 225.6   0.18  94.1
  0.000E+00  0.000E+00  0.000E+00  0.000E+00  0.000E+00  0.000E+00  0.000E+00
  0.000E+00  0.000E+00  0.000E+00  0.000E+00  0.000E+00
";

/// Two places, two times, with every kind of table. The first: 0.02 m²/Hz/degr at 0.1 Hz from the south.
pub(crate) const SWAN: &str = "\
SWAN   1                                Swan standard spectral file
$   a comment
TIME                                    time-dependent data
     1                                  time coding option
LONLAT                                  locations in spherical coordinates
     2                                  number of locations
  174.672501  -38.173599
  175.0 -39.0
AFREQ                                   absolute frequencies in Hz
     3                                  number of frequencies
    0.0800
    0.1000
    0.1250
NDIR                                    spectral nautical directions in degr
     4                                  number of directions
     0.0
    90.0
   180.0
   270.0
QUANT
     1                                  number of quantities in table
VaDens                                  variance densities in m2/Hz/degr
m2/Hz/degr                              unit
   -99                                  exception value
20161011.000000                         date and time
FACTOR
    1.0E-03
    0    0    0    0
    0  -99   20    0
    0    0    0    0
NODATA
20161012.000000                         date and time
ZERO
FACTOR
    0.5E-03
    0    0    0    0
    0    0   20    0
    0    0    0    0
";

pub(crate) fn read(text: &str) -> Vec<MeasuredSea> {
    from_bytes(text.as_bytes(), "44097.spec").unwrap()
}

pub(crate) fn with_directions() -> Vec<MeasuredSea> {
    let directions = DIRECTIONS.map(str::as_bytes);
    from_bytes_with_directions(DATA_SPEC.as_bytes(), directions, "44097.data_spec").unwrap()
}

pub(crate) fn problem(text: &str) -> String {
    from_bytes(text.as_bytes(), "file").unwrap_err().to_string()
}

pub(crate) fn spectrum(sea: &MeasuredSea, directions: Directions) -> Tabulated {
    sea.spectrum(&directions, &Dispersion::DEEP).unwrap()
}

/// The mean direction that waves come from, degrees, and r₁, by a sum over the table's own points and
/// between.
pub(crate) fn mean_from_deg(spectrum: &Tabulated) -> (f64, f64) {
    let frequencies_hz = spectrum.frequencies_hz();
    let (low, high) = (frequencies_hz[0], frequencies_hz[frequencies_hz.len() - 1]);
    let mut sums = [0.0; 3];
    for i in 0..200 {
        let hz = low + (high - low) * (f64::from(i) + 0.5) / 200.0;
        for degree in 0..360 {
            let theta = f64::from(degree).to_radians();
            let e = spectrum.density_m2phzprad(hz, theta);
            sums = [sums[0] + e, sums[1] + e * theta.cos(), sums[2] + e * theta.sin()];
        }
    }
    let [all, east, south] = sums;
    // Where they come from is opposite to where they go: the bearing of (−east, north = south).
    ((-east).atan2(south).to_degrees().rem_euclid(360.0), east.hypot(south) / all)
}

pub(crate) fn variance(spectrum: &Tabulated) -> f64 {
    spectrum.variance_m2()
}

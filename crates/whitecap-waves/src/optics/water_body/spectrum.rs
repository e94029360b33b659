//! From spectra in thirteen bands to linear sRGB.

/// Bands in every spectrum here.
pub const BANDS: usize = 13;

/// Their wavelengths, nm.
pub const WAVELENGTHS_NM: [f64; BANDS] =
    [400.0, 425.0, 450.0, 475.0, 500.0, 525.0, 550.0, 575.0, 600.0, 625.0, 650.0, 675.0, 700.0];

/// CIE standard illuminant D65, relative power (CIE 15:2004, table T.1).
const DAYLIGHT: [f64; BANDS] = [
    82.7549, 90.0570, 117.008, 115.392, 109.354, 106.239, 104.046, 96.0611, 90.0062, 85.4937, 80.0268,
    80.2810, 71.6091,
];

/// Linear sRGB from CIE XYZ (IEC 61966-2-1).
const SRGB_FROM_XYZ: [[f64; 3]; 3] =
    [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];

/// What each band counts in each channel: a reflectance r seen in daylight has the colour Σ weight × r, and a white
/// one is (1, 1, 1). Weights may be negative, since sRGB's primaries do not span all colours.
///
/// Between bands spectra are straight; the colour matching functions are taken every 5 nm.
pub fn channel_weights() -> [[f64; BANDS]; 3] {
    let mut weights = [[0.0; BANDS]; 3];
    let steps = 5 * (BANDS - 1);
    for step in 0..=steps {
        let (band, part) = ((step / 5).min(BANDS - 2), step as f64 / 5.0);
        let part = part - band as f64;
        let ends = if step == 0 || step == steps { 0.5 } else { 1.0 };
        let mix = |values: &[f64; BANDS]| values[band] * (1.0 - part) + values[band + 1] * part;
        let xyz = color_matching(mix(&WAVELENGTHS_NM)).map(|response| ends * response * mix(&DAYLIGHT));
        for (channel, row) in weights.iter_mut().zip(SRGB_FROM_XYZ) {
            let response = row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2];
            channel[band] += response * (1.0 - part);
            channel[band + 1] += response * part;
        }
    }
    weights.map(|channel| {
        let white: f64 = channel.iter().sum();
        channel.map(|weight| weight / white)
    })
}

/// The colour of a spectrum of reflectance or of scattering, none of it below 0: what lies outside sRGB is moved to
/// its edge.
pub fn linear_srgb(spectrum: &[f64; BANDS]) -> [f64; 3] {
    channel_weights().map(|channel| channel.iter().zip(spectrum).map(|(w, s)| w * s).sum::<f64>().max(0.0))
}

/// The CIE 1931 standard observer, fitted with Gaussians (Wyman, Sloan and Shirley, *JCGT* 2, 2013).
fn color_matching(nm: f64) -> [f64; 3] {
    let lobe = |height: f64, centre: f64, below: f64, above: f64| {
        let t = (nm - centre) * if nm < centre { below } else { above };
        height * libm::exp(-0.5 * t * t)
    };
    [
        lobe(0.362, 442.0, 0.0624, 0.0374)
            + lobe(1.056, 599.8, 0.0264, 0.0323)
            + lobe(-0.065, 501.1, 0.0490, 0.0382),
        lobe(0.821, 568.8, 0.0213, 0.0247) + lobe(0.286, 530.9, 0.0613, 0.0322),
        lobe(1.217, 437.0, 0.0845, 0.0278) + lobe(0.681, 459.0, 0.0385, 0.0725),
    ]
}

//! The slopes that a picture does not resolve, by direction.
//!
//! A tile's normal map tells, level by level, how much variance of slope it has averaged away, both axes together. Which
//! way those slopes lie is the band's: its spectrum gives the tensor. Waves shorter than the last band are in no map; their
//! whole tensor is the spectrum's.

use glam::Vec3;
use whitecap_scene::{Scene, SceneError};
use whitecap_waves::model::spectral::{Band, SpectralSea};
use whitecap_waves::statistics::{PolarSpectrum, SlopeVariance};

/// Waves shorter than this belong to surface tension, which damps them: where Cox and Munk (1954) found the slopes to end.
/// Spectra of gravity waves go on, and their slopes would grow without bound. rad/m, 17 mm.
const SHORTEST: f64 = 370.0;

/// Slopes that are smaller than the picture.
pub(super) struct Roughness {
    /// Of each tile's band: xx, xz and zz of the tensor, with xx + zz = 1.
    pub(super) tiles: Vec<Vec3>,
    /// Of waves beyond the last band: the variances and the covariance of slope.
    pub(super) beyond: Vec3,
    /// Of all waves.
    pub(super) whole: Vec3,
    /// How sharp the crests of the longest band are: the root of its variance of slope over that of height, 1/m.
    pub(super) crest_wavenumber_per_m: f64,
}

impl Roughness {
    /// Of the scene's spectra, shared out as `sea` has them.
    pub(super) fn of(scene: &Scene, sea: &SpectralSea) -> Result<Roughness, SceneError> {
        let spectra = scene.sea.spectra()?;
        let dispersion = scene.sea.water()?.dispersion;
        let bands: Vec<Band> = sea.parameters().cascades.iter().map(|cascade| cascade.band).collect();
        let Ok(spectrum) = PolarSpectrum::of(&spectra, dispersion, Band::WHOLE) else {
            // Nothing to sample: a flat sea.
            return Ok(Roughness {
                tiles: vec![shape(SlopeVariance::default()); bands.len()],
                beyond: Vec3::ZERO,
                whole: Vec3::ZERO,
                crest_wavenumber_per_m: 1.0,
            });
        };
        let last = bands.iter().map(|band| band.to).fold(0.0, f64::max);
        let tiles: Vec<SlopeVariance> = bands.iter().map(|band| spectrum.within(*band).1).collect();
        let beyond = match last < SHORTEST {
            true => spectrum.within(Band { from: last, to: SHORTEST }).1,
            false => SlopeVariance::default(),
        };
        let longest = bands.first().map(|band| spectrum.within(*band));
        let (variance_m2, slope) = longest.unwrap_or_default();
        Ok(Roughness {
            crest_wavenumber_per_m: (slope.total() / variance_m2.max(1e-12)).sqrt().max(1e-3),
            whole: tiles.iter().map(|tile| tensor(*tile)).sum::<Vec3>() + tensor(beyond),
            tiles: tiles.into_iter().map(shape).collect(),
            beyond: tensor(beyond),
        })
    }
}

fn tensor(slope: SlopeVariance) -> Vec3 {
    glam::DVec3::new(slope.xx, slope.xz, slope.zz).as_vec3()
}

/// The tensor with a trace of 1; alike in all directions where there are no slopes.
fn shape(slope: SlopeVariance) -> Vec3 {
    let total = slope.total();
    if total > 0.0 { (tensor(slope).as_dvec3() / total).as_vec3() } else { Vec3::new(0.5, 0.0, 0.5) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use whitecap_scene::sea::SeaSurface;

    fn of(toml: &str) -> (Roughness, f64) {
        let scene = Scene::from_toml(toml, "test.toml").unwrap();
        let SeaSurface::Spectral(sea) = scene.sea.build(scene.seed).unwrap() else { panic!() };
        let spectra = scene.sea.spectra().unwrap();
        let whole = PolarSpectrum::of(&spectra, scene.sea.water().unwrap().dispersion, Band::WHOLE).unwrap();
        (Roughness::of(&scene, &sea).unwrap(), whole.within(Band { from: 0.0, to: SHORTEST }).1.total())
    }

    const WEST_WIND: &str = "technique = \"spectral-ocean\"\n[[sea.system]]\nspectrum = \"jonswap\"\n\
        wind_speed_mps = 8.0\nfetch_km = 100.0\nfrom_deg = 270.0\nspreading = { cos2s = 8.0 }\n\
        [camera]\nposition_m = [0, 5, 0]\nlook_at_m = [100, 0, 0]";

    #[test]
    fn slopes_lie_along_the_wind_and_turn_with_it() {
        let (west, whole) = of(WEST_WIND);
        for shape in &west.tiles {
            assert!((shape.x + shape.z - 1.0).abs() < 1e-6, "{shape}");
            assert!(shape.x > 0.55 && shape.y.abs() < 1e-3, "{shape}");
        }
        assert!(west.beyond.x > west.beyond.z && west.beyond.z > 0.0, "{}", west.beyond);
        assert!((f64::from(west.whole.x + west.whole.z) / whole - 1.0).abs() < 0.01, "{}", west.whole);
        // What is beyond decimetres is a good part of all slopes, and not most of them.
        let share = f64::from(west.beyond.x + west.beyond.z) / whole;
        assert!((0.1..0.7).contains(&share), "{share}");
        let (south, _) = of(&WEST_WIND.replace("270.0", "180.0"));
        for (west, south) in west.tiles.iter().zip(&south.tiles) {
            assert!((west.x - south.z).abs() < 1e-3 && (west.z - south.x).abs() < 1e-3);
        }
        // A diagonal wind has covariance: from the south-west, east and north together, and north is −z.
        let (diagonal, _) = of(&WEST_WIND.replace("270.0", "225.0"));
        assert!(diagonal.tiles.iter().all(|shape| shape.y < -0.05));
    }
}

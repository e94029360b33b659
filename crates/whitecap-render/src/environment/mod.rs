//! Sky and light around the water, as every technique gets it.
//!
//! Whatever the scene names (an atmosphere that is computed, a panorama that was photographed)
//! becomes an [`Environment`]: a prefiltered cube map, and the sun where it is known apart.

mod clear_sky;
mod clouds;
mod cube;
mod display;
mod exposure;
mod light;
mod panorama_sun;

pub use cube::{CubeMap, FACE_SIZE, glow};
pub use display::{display_from_linear, exposed, linear_from_display};
pub(crate) use exposure::Meter;
pub(crate) use light::{Air, SUN_KLX};
pub use light::{Light, SunLight};

use crate::RenderError;
use clear_sky::ClearSky;
use clouds::Clouds;
use glam::{DVec3, Vec3};
use panorama_sun::PanoramaSun;
use std::f32::consts::PI;
use whitecap_scene::panorama::Panorama;
use whitecap_scene::sky::{Atmosphere as AtmosphereSky, PanoramaSky};
use whitecap_scene::technique::SpectralOcean;
use whitecap_scene::{Picture, Scene, Sky, Technique};
use whitecap_waves::optics::atmosphere;

/// Mean radiance of the sky that exposure 0 EV maps to: a little above middle grey, so that the sky
/// keeps its colour and the sun's surroundings alone run into white.
const KEY: f32 = 0.2;

/// Mean luminance of the sky, of the sun's irradiance, from which on it is day: a sun some degrees high.
const DAYLIGHT: f32 = 0.02;

/// How much of the way exposure follows the light below that.
const ADAPTATION: f32 = 0.7;

/// The light around the water, ready for upload.
pub struct Environment {
    /// Radiance from all directions: display-referred with the sun, values above 1 included, or where there is
    /// [`Environment::light`] in its units without the sun.
    pub cube: CubeMap,
    /// The sun's disc, where it is known apart from the map.
    pub sun: Option<Sun>,
    /// Light that falls on a level sea, sun and sky together, linear.
    pub irradiance: Vec3,
    /// Mean radiance of the sky without the sun, weighted by its height, linear: what a level white surface in
    /// the sun's shadow returns. Under a panorama, whose sun is not known apart, with it.
    pub skylight: Vec3,
    /// Display brightness of the sky against a day's: 1 by day, less from sunset on. Colours that a scene
    /// gives as they look by day are dimmed by it.
    pub daylight: f32,
    /// What belongs to the map for techniques that draw in linear light; `None` where it holds display values.
    pub light: Option<Light>,
}

/// The sun's disc as seen from the water.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// Unit vector towards its centre.
    pub toward: Vec3,
    /// Radiance of the disc in the cube map's units, linear.
    pub radiance: Vec3,
}

/// The sun's angular radius seen from Earth, radians (0.2666°).
pub const SUN_RADIUS_RAD: f32 = atmosphere::SUN_RADIUS_RAD as f32;

impl Environment {
    /// Computes the light of a scene's sky, in linear light or in display values as its technique draws. Takes some tenths
    /// of a second on two cores.
    ///
    /// # Errors
    ///
    /// When the scene has not read its panorama and the file cannot be read now.
    pub fn new(scene: &Scene) -> Result<Environment, RenderError> {
        if scene.technique.is_scene_linear() {
            return Environment::linear(scene);
        }
        of_sky(scene, |settings| Environment::of_atmosphere(settings, scene.seed), Environment::of_panorama)
    }

    /// As [`Environment::new`] for techniques that draw in linear light: the map holds radiance, and what display values
    /// were in `irradiance` and `skylight` is in its units.
    ///
    /// # Errors
    ///
    /// As [`Environment::new`].
    pub(crate) fn linear(scene: &Scene) -> Result<Environment, RenderError> {
        let visibility_km = match &scene.technique {
            Technique::SpectralOcean(settings) => settings.visibility_km,
            _ => SpectralOcean::default().visibility_km,
        };
        of_sky(
            scene,
            |settings| Environment::linear_of_atmosphere(settings, &scene.picture, scene.seed),
            |settings, panorama| {
                Environment::linear_of_panorama(settings, &scene.picture, panorama, visibility_km)
            },
        )
    }

    fn linear_of_atmosphere(settings: &AtmosphereSky, picture: &Picture, seed: u64) -> Environment {
        let clear = ClearSky::new(settings);
        let clouds = Clouds::new(&clear, settings.cloud_cover as f32, seed);
        let cube = CubeMap::bake_linear(|d| SUN_KLX * cloudy(&clear, &clouds, d), 1);
        let sun = SunLight {
            toward: clear.toward_sun,
            illuminance_klx: SUN_KLX * clear.sun_transmittance(0.0),
            radius_rad: SUN_RADIUS_RAD,
        };
        let sun = (sun.illuminance_klx.max_element() > 0.0).then_some(sun);
        let has_clouds = settings.cloud_cover > 0.0;
        let ClearSky { air, sky, .. } = clear;
        let air = Air::Computed { atmosphere: Box::new(air), sea_level: Box::new(sky), has_clouds };
        Environment::of_light(cube, sun, air, picture, settings.exposure_ev)
    }

    fn linear_of_panorama(
        settings: &PanoramaSky,
        picture: &Picture,
        panorama: &Panorama,
        visibility_km: f64,
    ) -> Environment {
        let panorama_from_world = glam::DQuat::from_rotation_y(settings.yaw_deg.to_radians());
        let sun = PanoramaSun::find(panorama);
        let radiance = |d: Vec3| {
            let d = panorama_from_world * d.as_dvec3();
            let seen = Vec3::from(panorama.sample(d));
            sun.as_ref().map_or(seen, |sun| sun.without(d, seen))
        };
        let cube = CubeMap::bake_linear(radiance, 2);
        let sun = sun.as_ref().map(|sun| sun.light(panorama_from_world.inverse()));
        let air = Air::Photographed { visibility_m: (1000.0 * visibility_km) as f32 };
        Environment::of_light(cube, sun, air, picture, settings.exposure_ev)
    }

    fn of_light(cube: CubeMap, sun: Option<SunLight>, air: Air, picture: &Picture, ev: f64) -> Environment {
        let sky_illuminance_klx = cube.irradiance();
        let from_sun = sun.map_or(Vec3::ZERO, |sun| sun.illuminance_klx * sun.toward.y.max(0.0));
        let irradiance = sky_illuminance_klx + from_sun;
        let exposure = exposure::exposure(picture, f64::from(irradiance.dot(LUMINANCE)), ev);
        let meter = picture
            .exposure_ev100
            .is_none()
            .then(|| Meter::new(exposure, f64::from(sky_illuminance_klx.dot(LUMINANCE)), sun.as_ref()));
        Environment {
            cube,
            sun: None,
            irradiance,
            skylight: sky_illuminance_klx / PI,
            daylight: 1.0,
            light: Some(Light { sun, sky_illuminance_klx, exposure, meter, tone_map: picture.tone_map, air }),
        }
    }

    fn of_atmosphere(settings: &AtmosphereSky, seed: u64) -> Environment {
        let clear = ClearSky::new(settings);
        let (toward_sun, mean) = (clear.toward_sun, clear.mean);
        let clouds = Clouds::new(&clear, settings.cloud_cover as f32, seed);
        // Eyes and cameras follow the light of evening only part of the way down.
        let dimming = (mean.dot(LUMINANCE).max(1e-9) / DAYLIGHT).min(1.0).powf(1.0 - ADAPTATION);
        let exposure = exposure(mean, settings.exposure_ev) * dimming;
        let sun = Sun { toward: toward_sun, radiance: clear.sun_radiance() * exposure };
        let sun = (sun.radiance.max_element() > 0.0).then_some(sun);
        let from_sun = clear.sun_transmittance(0.0) * toward_sun.y.max(0.0);
        Environment {
            cube: CubeMap::bake(|d| expose(cloudy(&clear, &clouds, d) * exposure), sun.as_ref(), 1),
            sun,
            irradiance: (from_sun + PI * mean) * exposure,
            skylight: mean * exposure,
            daylight: display_from_linear(KEY * dimming) / display_from_linear(KEY),
            light: None,
        }
    }

    fn of_panorama(settings: &PanoramaSky, panorama: &Panorama) -> Environment {
        let yaw = glam::DQuat::from_rotation_y(settings.yaw_deg.to_radians());
        let radiance = |d: Vec3| Vec3::from(panorama.sample(yaw * d.as_dvec3()));
        let (all, without_sun) = means_of_upper_half(&radiance);
        let exposure = exposure(without_sun, settings.exposure_ev);
        // Two by two samples a texel: panoramas are finer than the cube, and the sun is small.
        let cube = CubeMap::bake(|d| expose(radiance(d) * exposure), None, 2);
        Environment {
            cube,
            sun: None,
            irradiance: PI * all * exposure,
            skylight: all * exposure,
            daylight: 1.0,
            light: None,
        }
    }
}

/// The environment of the scene's kind of sky, with the panorama that the scene holds, or read now.
fn of_sky(
    scene: &Scene,
    of_atmosphere: impl FnOnce(&AtmosphereSky) -> Environment,
    of_panorama: impl FnOnce(&PanoramaSky, &Panorama) -> Environment,
) -> Result<Environment, RenderError> {
    match (&scene.sky, &scene.panorama) {
        (Sky::Atmosphere(settings), _) => Ok(of_atmosphere(settings)),
        (Sky::Panorama(settings), Some(panorama)) => Ok(of_panorama(settings, panorama)),
        (Sky::Panorama(settings), None) => Ok(of_panorama(settings, &settings.load()?)),
        _ => Err(RenderError::Unsupported { what: "this kind of sky".into() }),
    }
}

/// The sky with its clouds, and under the horizon what reflections find there.
fn cloudy(clear: &ClearSky, clouds: &Clouds, direction: Vec3) -> Vec3 {
    if direction.y < 0.0 {
        below_horizon(direction.y, clear.radiance(direction), clear.mean)
    } else {
        clouds.over(direction, clear.radiance(direction))
    }
}

/// Unit vector towards a nautical bearing and elevation (x east, y up, z south).
fn toward(azimuth_deg: f64, elevation_deg: f64) -> Vec3 {
    let (azimuth, elevation) = (azimuth_deg.to_radians(), elevation_deg.to_radians());
    DVec3::new(azimuth.sin() * elevation.cos(), elevation.sin(), -azimuth.cos() * elevation.cos()).as_vec3()
}

fn exposure(mean: Vec3, ev: f64) -> f32 {
    let luminance = mean.dot(LUMINANCE).max(1e-9);
    KEY / luminance * (ev as f32).exp2()
}

fn expose(radiance: Vec3) -> Vec3 {
    Vec3::from(radiance.to_array().map(exposed))
}

/// Rec. 709 luminance weights.
const LUMINANCE: Vec3 = Vec3::new(0.2126, 0.7152, 0.0722);

/// What a reflection finds that points under the horizon: the flank of another wave. It mirrors the middle of
/// the sky rather than its edge, and less of it the further down one looks.
fn below_horizon(y: f32, horizon: Vec3, sky: Vec3) -> Vec3 {
    let down = y.abs();
    let flank = Vec3::new(0.75, 0.85, 0.95) * sky * (1.0 - 0.6 * down.min(1.0));
    horizon.lerp(flank, 1.0 - (1.0 + 7.0 * down).powi(-2))
}

/// Cosine-weighted mean radiance of the upper half: of all of it, and without its brightest fiftieth,
/// which holds the sun.
fn means_of_upper_half(radiance: &dyn Fn(Vec3) -> Vec3) -> (Vec3, Vec3) {
    const RINGS: u32 = 24;
    const SPOKES: u32 = 96;
    let mut samples = Vec::with_capacity((RINGS * SPOKES) as usize);
    for ring in 0..RINGS {
        // Equal steps of sin² give every sample the same cosine-weighted solid angle.
        let sin = ((ring as f32 + 0.5) / RINGS as f32).sqrt();
        let cos = (1.0 - sin * sin).sqrt();
        for spoke in 0..SPOKES {
            let (s, c) = (std::f32::consts::TAU * spoke as f32 / SPOKES as f32).sin_cos();
            samples.push(radiance(Vec3::new(sin * c, cos, sin * s)));
        }
    }
    samples.sort_by(|a, b| a.dot(LUMINANCE).total_cmp(&b.dot(LUMINANCE)));
    let mean = |s: &[Vec3]| s.iter().sum::<Vec3>() / s.len() as f32;
    (mean(&samples), mean(&samples[..samples.len() * 98 / 100]))
}

#[cfg(test)]
mod tests;

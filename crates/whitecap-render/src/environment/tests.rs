use super::*;

fn of_toml(sky: &str) -> Scene {
    let base = whitecap_scene::named::find("meshuggah").unwrap().toml;
    let without = &base[..base.find("[sky]").unwrap()];
    let camera = &base[base.find("[camera]").unwrap()..];
    Scene::from_toml(&format!("{without}[sky]\n{sky}\n{camera}"), "test.toml").unwrap()
}

/// Display value (green) of a level of the cube where a direction falls.
fn seen(environment: &Environment, direction: Vec3, level: usize) -> f32 {
    let size = FACE_SIZE >> level;
    let (face, x, y) = cube::locate(direction, size);
    environment.cube.levels[level][(face * size as usize + y as usize) * size as usize + x as usize][1]
        .to_f32()
}

/// The sum over the finest level of the cube, whose texels stand for the linear light `light_of` them.
fn irradiance_of(environment: &Environment, light_of: impl Fn([f32; 3]) -> [f32; 3]) -> DVec3 {
    let size = FACE_SIZE as usize;
    let texels = environment.cube.levels[0].iter().enumerate();
    let light = texels.map(|(i, texel)| {
        let place = glam::Vec2::new((i % size) as f32 + 0.5, (i / size % size) as f32 + 0.5);
        let share = cube::level_share(i / (size * size), place, FACE_SIZE);
        let [r, g, b, _] = texel.map(f32::from);
        (Vec3::from(light_of([r, g, b])) * share).as_dvec3()
    });
    light.sum()
}

#[test]
fn bearings_run_clockwise_from_north() {
    assert!((toward(0.0, 0.0) - Vec3::NEG_Z).length() < 1e-6);
    assert!((toward(90.0, 0.0) - Vec3::X).length() < 1e-6);
    assert!((toward(180.0, 30.0) - Vec3::new(0.0, 0.5, 0.866_025_4)).length() < 1e-6);
}

#[test]
fn the_sun_is_where_the_scene_says_and_keeps_its_range() {
    let environment =
        Environment::new(&of_toml("sun_azimuth_deg = 120.0\nsun_elevation_deg = 25.0\ncloud_cover = 0.0"))
            .unwrap();
    let sun = environment.sun.unwrap();
    assert!((sun.toward - toward(120.0, 25.0)).length() < 1e-6);
    assert!(seen(&environment, sun.toward, 0) > 20.0);
    for (azimuth, elevation) in [(115.0, 25.0), (120.0, 30.0), (300.0, 25.0)] {
        assert!(seen(&environment, toward(azimuth, elevation), 0) <= 1.0);
    }
}

/// From noon to after sunset the sky is neither black nor blown out, and stops of exposure double it.
#[test]
fn exposure_holds_at_every_height_of_the_sun() {
    // The median leaves out a direction that happens to meet the sun or a cloud.
    let typical = |environment: &Environment| {
        let mut values = [20.0, 90.0, 160.0, 230.0, 300.0].map(|a| seen(environment, toward(a, 35.0), 0));
        values.sort_by(f32::total_cmp);
        values[2]
    };
    for elevation in [80.0, 45.0, 20.0, 5.0, 0.5, -4.0] {
        let environment = Environment::new(&of_toml(&format!("sun_elevation_deg = {elevation:?}"))).unwrap();
        let typical = typical(&environment);
        assert!((0.18..0.95).contains(&typical), "{typical} with the sun at {elevation}°");
        assert_eq!(environment.sun.is_some(), elevation > -1.0);
    }
    let dark = Environment::new(&of_toml("exposure_ev = -2.0\ncloud_cover = 0.0")).unwrap();
    let darker = Environment::new(&of_toml("exposure_ev = -3.0\ncloud_cover = 0.0")).unwrap();
    let at = |e: &Environment| linear_from_display(seen(e, Vec3::Y, 0));
    assert!((at(&dark) / at(&darker) - 2.0).abs() < 0.02);
    assert!((dark.irradiance.y / darker.irradiance.y - 2.0).abs() < 1e-3);
}

/// The irradiance that colours the water is that of the sky that it mirrors, sun included.
#[test]
fn irradiance_is_that_of_the_map() {
    // Dark enough that no part of the sky meets the shoulder.
    let environment =
        Environment::new(&of_toml("exposure_ev = -6.0\ncloud_cover = 0.0\nsun_elevation_deg = 40.0"))
            .unwrap();
    let sum = irradiance_of(&environment, |texel| texel.map(linear_from_display)).y;
    assert!(
        (sum / f64::from(environment.irradiance.y) - 1.0).abs() < 0.04,
        "{sum} {}",
        environment.irradiance
    );
}

/// The middle of a panorama is north; `yaw_deg` turns it clockwise.
#[test]
fn panoramas_turn_with_the_compass() {
    let (width, height) = (64, 32);
    let mut pixels = vec![[0.2; 3]; width * height];
    for row in pixels.chunks_mut(width) {
        row[width / 2 - 2..width / 2 + 2].fill([0.6; 3]);
    }
    let panorama = Panorama { width, height, pixels, repaired: 0 };
    for (yaw_deg, bearing) in [(0.0, 0.0), (90.0, 90.0), (-120.0, 240.0)] {
        let settings = PanoramaSky { file: "sky.hdr".into(), yaw_deg, exposure_ev: 0.0 };
        let environment = Environment::of_panorama(&settings, &panorama);
        let bright = seen(&environment, toward(bearing, 5.0), 0);
        for other in [45.0, 135.0, 180.0, 300.0] {
            assert!(bright > 1.2 * seen(&environment, toward(other, 5.0), 0), "yaw {yaw_deg}");
        }
    }
}

/// A thousand lux of sky light is a thousand lux of the map, under clouds too.
#[test]
fn linear_light_is_that_of_the_map() {
    for sky in ["sun_elevation_deg = 40.0\ncloud_cover = 0.0", "sun_elevation_deg = 5.0\ncloud_cover = 0.6"] {
        let environment = Environment::linear(&of_toml(sky)).unwrap();
        let light = environment.light.as_ref().unwrap();
        let sum = irradiance_of(&environment, |texel| texel);
        let error = (light.sky_illuminance_klx.as_dvec3() / sum - 1.0).abs().max_element();
        assert!(error < 0.02, "{error}");
        assert!(environment.sun.is_none());
    }
    // Photometers of a clear day: some 60 klx of sun and 15 of sky with the sun at 40°.
    let clear = Environment::linear(&of_toml("sun_elevation_deg = 40.0\ncloud_cover = 0.0")).unwrap();
    let light = clear.light.unwrap();
    let sky_klx = light.sky_illuminance_klx.dot(LUMINANCE);
    assert!((5.0..20.0).contains(&sky_klx), "{sky_klx}");
    let sun_klx = light.sun.unwrap().illuminance_klx.dot(LUMINANCE);
    assert!((70.0..115.0).contains(&sun_klx), "{sun_klx}");
    assert!(Environment::linear(&of_toml("sun_elevation_deg = -2.0")).unwrap().light.unwrap().sun.is_none());
}

/// The sea's edge is soft: no step from the sky to what a reflection finds under it.
#[test]
fn the_map_is_smooth_across_the_horizon() {
    let environment = Environment::linear(&of_toml("sun_elevation_deg = 20.0")).unwrap();
    for bearing in [0.0, 100.0, 240.0] {
        let [above, below] = [0.1, -0.1].map(|e| seen(&environment, toward(bearing, e), 0));
        assert!((above / below - 1.0).abs() < 0.05, "{above} {below}");
    }
}

/// Turned with the panorama, the sun goes where the picture of it goes.
#[test]
fn the_sun_of_a_panorama_turns_with_the_compass() {
    let panorama = panorama_sun::with_disc(toward(10.0, 30.0).as_dvec3(), 2.0, 5e4);
    for (yaw_deg, bearing) in [(0.0, 10.0), (90.0, 100.0), (-130.0, 240.0)] {
        let settings = PanoramaSky { file: "sky.hdr".into(), yaw_deg, exposure_ev: 0.0 };
        let environment = Environment::linear_of_panorama(&settings, &Picture::default(), &panorama, 25.0);
        let light = environment.light.as_ref().unwrap();
        let off_rad = light.sun.unwrap().toward.distance(toward(bearing, 30.0));
        assert!(off_rad < 0.2_f32.to_radians(), "{off_rad}");
        assert!(seen(&environment, toward(bearing, 30.0), 0) < 17.0);
        // The sky of radiance 2 remains.
        assert!((light.sky_illuminance_klx / (2.0 * PI) - 1.0).abs().max_element() < 0.02);
    }
}

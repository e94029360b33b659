//! Scenes as wholes: the named ones, files, writing and reading back, and text that is no scene.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use std::fs;
use std::path::Path;
use std::sync::Arc;

use proptest::prelude::*;
use whitecap_scene::panorama::Panorama;
use whitecap_scene::sea::system::{PhillipsSystem, System};
use whitecap_scene::sea::{Amplitudes, SeaModel, SpectralSettings, Tiling};
use whitecap_scene::sky::{Atmosphere, PanoramaSky};
use whitecap_scene::technique::{FresnelForm, Meshuggah};
use whitecap_scene::{Camera, Picture, Scene, Sea, Sky, Technique, named};

#[test]
fn a_scene_says_what_its_file_says() {
    let text = r#"
        technique = "meshuggah"
        seed = 7
        [sea]
        tile_size_m = 120
        resolution = 0x80
        amplitudes = "gaussian"
        [[sea.system]]
        spectrum = "phillips"
        wind_speed_mps = 8
        from_deg = 250.0
        significant_height_m = 0.5
        [meshuggah]
        tile_repeats = 3
        fresnel = "per-pixel"
        bottom_depth_m = 12
        [sky]
        sun_azimuth_deg = 255.0
        [camera]
        position_m = [0, 4.5, 0]
        look_at_m = [-200.0, 0.0, 50.0]
    "#;
    let expected = Scene {
        technique: Technique::Meshuggah(Meshuggah {
            tile_repeats: 3,
            fresnel: FresnelForm::PerPixel,
            bottom_depth_m: Some(12.0),
            ..Meshuggah::default()
        }),
        seed: 7,
        sea: Sea {
            model: SeaModel::Spectral(SpectralSettings {
                depth_m: None,
                surface_tension: false,
                current_mps: 0.0,
                current_toward_deg: 0.0,
                loop_s: None,
                cascades: None,
                tile_size_m: Some(120.0),
                resolution: Some(128),
                shortest_wave_m: None,
                cascade: None,
                choppiness: 1.0,
                amplitudes: Amplitudes::Gaussian,
                system: vec![System::Phillips(PhillipsSystem {
                    wind_speed_mps: Some(8.0),
                    peak_period_s: None,
                    sea_state: None,
                    beaufort: None,
                    from_deg: 250.0,
                    significant_height_m: Some(0.5),
                    opposing_energy: 0.0,
                    small_wave_cutoff_m: 0.0,
                })],
            }),
            tiling: Tiling { cascades: 1, resolution: 64, shortest_wave_m: 0.1, sewn: 0 },
        },
        sky: Sky::Atmosphere(Atmosphere { sun_azimuth_deg: 255.0, ..Atmosphere::default() }),
        picture: Picture::default(),
        camera: Camera {
            position_m: [0.0, 4.5, 0.0],
            look_at_m: [-200.0, 0.0, 50.0],
            vertical_fov_deg: 45.0,
        },
        panorama: None,
        objects: Vec::new(),
        models: None,
        warnings: Vec::new(),
    };
    assert_eq!(Scene::from_toml(text, "small").unwrap(), expected);
    assert!(named::find(named::DEFAULT).is_some());
}

#[test]
fn every_named_scene_is_a_file_that_builds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> =
        files.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    let mut names: Vec<_> = named::ALL.iter().map(|scene| scene.name).collect();
    files.sort();
    names.sort();
    assert_eq!(files, names, "the files in scenes/ and the names in named::ALL");

    for name in names {
        let scene = whitecap_scene::open(name).unwrap();
        let is_calm = matches!(scene.sea.model, SeaModel::Calm(_));
        assert_eq!(scene.sea.build(scene.seed).unwrap().variance_m2() > 0.0, !is_calm, "{name}");
        scene.read_objects().unwrap();
        assert_eq!(Scene::from_toml(&scene.to_toml().unwrap(), "").unwrap(), scene);
    }
}

#[test]
fn a_miss_lists_the_names() {
    let message = |name| whitecap_scene::open(name).unwrap_err().to_string();
    let names: Vec<String> = named::ALL.iter().map(|scene| format!("{:?}", scene.name)).collect();
    let accepted = format!("accepted: {}, or the path of a scene file", names.join(", "));
    for (asked, nearest) in [("meshugah", "meshuggah"), ("five-sample-01-blin", "five-sample-01-blinn-phong")]
    {
        assert_eq!(message(asked), format!("{asked}: no such scene; did you mean {nearest:?}? {accepted}"));
    }
    assert_eq!(message("puddle"), format!("puddle: no such scene; {accepted}"));
    assert!(message("no/such/pond.toml").starts_with("no/such/pond.toml: cannot be read: "));
}

#[test]
fn files_that_cannot_be_scenes() {
    let folder = tempfile::tempdir().unwrap();
    let message = |path: &Path| {
        let message = Scene::load(path).unwrap_err().to_string();
        message.strip_prefix(&format!("{}: ", path.display())).unwrap().to_owned()
    };
    let file = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    };
    assert_eq!(message(folder.path()), "this is a folder; accepted: a scene file");
    assert_eq!(
        message(&file("latin1.toml", b"seed = 1\n# caf\xe9\n")),
        "line 2 is not UTF-8 text; accepted: TOML, saved as UTF-8"
    );
    assert_eq!(
        message(&file("long.toml", &vec![b'#'; (1 << 20) + 1])),
        "longer than a scene file may be; accepted: up to 1 MiB"
    );
    assert_eq!(
        message(&file("empty.toml", b"")),
        "sea.system: missing; required: 1 or more tables [[sea.system]]"
    );
}

#[test]
fn files_in_a_scene_are_relative_to_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("evening.toml");
    let mut scene = whitecap_scene::open(named::DEFAULT).unwrap();
    scene.sky = panorama("skies/sunset.exr");
    fs::write(&path, scene.to_toml().unwrap()).unwrap();
    assert_eq!(Scene::from_toml(&scene.to_toml().unwrap(), "").unwrap(), scene);

    // A picture that cannot be read is the scene's mistake, at its line.
    let error = Scene::load(&path).unwrap_err();
    assert_eq!(error.key(), Some("sky.file"));
    let line =
        fs::read_to_string(&path).unwrap().lines().position(|line| line.starts_with("file =")).unwrap();
    assert_eq!(error.line(), Some(line + 1));
    assert!(error.problem().contains("cannot be read"), "{error}");

    let picture = folder.path().join("skies/sunset.exr");
    fs::create_dir(folder.path().join("skies")).unwrap();
    exr::prelude::write_rgb_file(&picture, 8, 4, |x, _| (x as f32, 1.0_f32, 0.5_f32)).unwrap();
    scene.sky = panorama(picture.to_str().unwrap());
    scene.panorama = Some(Arc::new(Panorama::load(&picture).unwrap()));
    assert_eq!(Scene::load(&path).unwrap(), scene);
}

fn panorama(file: &str) -> Sky {
    Sky::Panorama(PanoramaSky { file: file.into(), yaw_deg: -30.0, exposure_ev: 1.5 })
}

#[test]
fn a_scene_out_of_range_is_not_written() {
    let mut scene = whitecap_scene::open(named::DEFAULT).unwrap();
    scene.camera.vertical_fov_deg = f64::NAN;
    let error = scene.to_toml().unwrap_err();
    assert_eq!(error.key(), Some("camera.vertical_fov_deg"));
    scene.camera.vertical_fov_deg = 45.0;
    scene.seed = u64::MAX;
    scene.to_toml().unwrap_err();
}

/// Lines that are right, nearly right or wrong, to be put together at random.
const LINES: &[&str] = &[
    "technique = \"meshuggah\"",
    "seed = 7",
    "seed = -7",
    "[sea]",
    "[[sea.system]]",
    "[sea.system]",
    "spectrum = \"phillips\"",
    "wind_speed_mps = 8",
    "wind_speed_mps = nan",
    "from_deg = 250.0",
    "from_deg = [[{}]]",
    "[meshuggah]",
    "tile_repeats = 0x4",
    "deep_color = [0, 1, 0.5]",
    "deep_color = [{}, 1]",
    "[sky]",
    "kind = \"panorama\"",
    "kind = \"atmosphere\"",
    "file = \"sky\\u0000.exr\"",
    "file = 'ü.hdr'",
    "[camera]",
    "position_m = [0, 4, 0]",
    "look_at_m = [0, 4, 1]",
    "a.b.c = {d = 1979-05-27}",
    "\"\" = 1",
];

proptest! {
    #[test]
    fn no_text_panics(text in "\\PC{0,200}") {
        let _ = Scene::from_toml(&text, "any");
    }

    #[test]
    fn no_lines_panic(lines in prop::collection::vec(prop::sample::select(LINES), 0..20)) {
        if let Err(error) = Scene::from_toml(&lines.join("\n"), "any") {
            prop_assert!(!error.to_string().contains('\n'));
        }
    }

    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = Scene::from_toml(&String::from_utf8_lossy(&bytes), "any");
    }
}

/// From above one sees no ripples: the tiles end at four pixels of a picture of 720 lines. Below 22 m they reach down to
/// 0.1 m, and a scene may say another length itself.
#[test]
fn tiles_end_where_the_view_does() {
    let shortest_m = |height_m: f64, more: &str| {
        let text = format!(
            "technique = 'spectral-ocean'\n[sea]\n{more}\n[[sea.system]]\nspectrum = 'jonswap'\nwind_speed_mps = 9.0\n\
             from_deg = 9.0\n[camera]\nposition_m = [0, {height_m}, 0]\nlook_at_m = [900, 0, 0]\n"
        );
        let scene = Scene::from_toml(&text, "view").unwrap();
        let SeaModel::Spectral(settings) = &scene.sea.model else { panic!() };
        let tiles = settings.cascades(&scene.sea.spectra().unwrap(), &scene.sea.tiling);
        std::f64::consts::TAU / tiles.last().unwrap().band.to
    };
    let near =
        |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected}");
    for height_m in [-3.0, 2.0, 22.0] {
        near(shortest_m(height_m, ""), 0.1);
    }
    near(shortest_m(300.0, ""), 1.35);
    near(shortest_m(300.0, "shortest_wave_m = 0.2"), 0.2);
    // However high the view, each system keeps its height.
    assert!((2.0..8.0).contains(&shortest_m(1e5, "")), "{}", shortest_m(1e5, ""));
    for named in named::ALL {
        let scene = whitecap_scene::open(named.name).unwrap();
        let is_near = scene.camera.position_m[1] < 22.0;
        assert_eq!(scene.sea.tiling.shortest_wave_m == 0.1, is_near, "{}", named.name);
        assert_eq!(scene.warnings, Vec::<String>::new(), "{}", named.name);
    }
}

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use super::*;
use crate::gpu::for_tests::gpu;
use crate::gpu::read_buffer;
use crate::gpu::resources::{buffer, linear_sampler};
use crate::shader_lib::{self, layout::assert_layout};
use whitecap_scene::Scene;
use whitecap_scene::sea::SeaSurface;
use whitecap_waves::model::spectral::Patch;
use whitecap_waves::model::spectral::foam::{DECAY_S, FoamParameters};
use whitecap_waves::optics::foam_cover;

const WIND_MPS: f64 = 12.0;
const SCENE: &str = r#"
technique = "spectral-ocean"
seed = 11
[sea]
model = "spectral"
[[sea.system]]
spectrum = "jonswap"
wind_speed_mps = 12.0
fetch_km = 300.0
from_deg = 250.0
spreading = "hasselmann"
[camera]
position_m = [0.0, 5.0, 0.0]
look_at_m = [100.0, 0.0, 0.0]
"#;

fn foam() -> Foam {
    let scene = Scene::from_toml(SCENE, "foam").unwrap();
    let SeaSurface::Spectral(sea) = scene.sea.build(scene.seed).unwrap() else { unreachable!() };
    Foam::new(&sea, FoamParameters { wind_speed_mps: Some(WIND_MPS), decay_s: DECAY_S }).unwrap().unwrap()
}

/// Runs `cs_foam` on places (x, z, footprint) from an eye.
fn drawn(gpu: &crate::Gpu, maps: &FoamMaps, eye_m: DVec2, places: &[[f32; 4]]) -> Vec<[f32; 2]> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let shader = &shader_lib::FOAM_TWINS;
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(shader.name),
        layout: None,
        module: &shader.module(device),
        entry_point: Some("cs_foam"),
        compilation_options: wgpu::PipelineCompilationOptions {
            constants: &[
                ("FOAM_TILES", maps.tile_count() as f64),
                ("SEWN_FOAM_TILES", maps.sewn_count() as f64),
            ],
            ..Default::default()
        },
        cache: None,
    });
    let input = buffer(device, queue, "places", bytemuck::cast_slice(places), wgpu::BufferUsages::STORAGE);
    let zeroes = vec![[0.0f32; 2]; places.len()];
    let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
    let output = buffer(device, queue, "foam", bytemuck::cast_slice(&zeroes), usage);
    let uniforms = maps.uniforms(eye_m);
    let uniform = buffer(device, queue, "foam", bytemuck::bytes_of(&uniforms), wgpu::BufferUsages::UNIFORM);
    let sampler = linear_sampler(device, "repeating", wgpu::AddressMode::Repeat);
    let (layers, structure) = (maps.maps(), maps.structure());
    let resources = [
        input.as_entire_binding(),
        output.as_entire_binding(),
        uniform.as_entire_binding(),
        wgpu::BindingResource::TextureView(&layers),
        wgpu::BindingResource::TextureView(&structure),
        wgpu::BindingResource::Sampler(&sampler),
    ];
    let group =
        crate::gpu::resources::bind_group(device, "foam", &pipeline.get_bind_group_layout(0), resources);
    let mut encoder = device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups((places.len() as u32).div_ceil(64), 1, 1);
    }
    queue.submit([encoder.finish()]);
    bytemuck::pod_collect_to_vec(&read_buffer(device, queue, &output).unwrap())
}

#[test]
fn layouts_agree() {
    let wgsl = shader_lib::FOAM_TWINS.wgsl;
    assert_layout!(GpuFoamTile, wgsl, "GpuFoamTile", [eye_in_tile, tiles_per_m, half_texel, patchwork]);
    assert_layout!(
        GpuFoam,
        wgsl,
        "GpuFoam",
        [tiles, eye_in_structure, structures_per_m, variance_gain, threshold]
    );
}

/// Counts are those of one thread.
#[test]
fn the_next_frame_allocates_nothing() {
    let Some(gpu) = gpu() else { return };
    let mut maps = FoamMaps::new(&gpu.device, &gpu.queue, Some(foam())).unwrap();
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let count = alone.install(|| {
        maps.evaluate(33.3);
        allocation_counter::measure(|| maps.evaluate(33.3 + 1.0 / 30.0))
    });
    assert_eq!(count.count_total, 0);
    let n = maps.foam.as_ref().unwrap().resolution();
    for chain in &maps.chains {
        let sizes: Vec<usize> = chain.levels().map(<[_]>::len).collect();
        assert_eq!(sizes, (0..=n.ilog2()).map(|level| (n >> level).pow(2)).collect::<Vec<_>>());
    }
}

/// The shader's cover is that of the fields, sewn from their patches.
#[test]
fn the_cover_drawn_is_that_of_the_fields() {
    let Some(gpu) = gpu() else { return };
    let mut cpu = foam();
    cpu.evaluate(33.3);
    let n = cpu.resolution();
    let mut maps = FoamMaps::new(&gpu.device, &gpu.queue, Some(foam())).unwrap();
    maps.update(&gpu.queue, 33.3);
    // The eye 1,000 km away sees the same foam.
    let far = DVec2::splat(1e6);
    let spacing_m = cpu.tiles()[0].tile_size_m() / n as f64;
    let places: Vec<[f32; 4]> = (0..2000)
        .map(|i| {
            let place = spacing_m * DVec2::new(f64::from(i * 7 % 251), f64::from(i * 13 % 241));
            [place.x as f32, place.y as f32, 0.001, 0.0]
        })
        .collect();
    let excess = |place: DVec2| -> f64 {
        let tile = |tile: &whitecap_waves::model::spectral::foam::FoamTile| {
            let of_copy = |patch: Patch| {
                let at = (place / tile.tile_size_m() + patch.shift).fract_gl() * n as f64;
                let (corner, t) = (at.floor(), at.fract());
                let (x, z) = (corner.x as usize, corner.y as usize);
                let sample = |i: usize, j: usize| f64::from(tile.field()[(z + j) % n * n + (x + i) % n]);
                let row = |j: usize| sample(0, j) * (1.0 - t.x) + sample(1, j) * t.x;
                patch.weight.powi(2) * (row(0) * (1.0 - t.y) + row(1) * t.y).exp()
            };
            let alone = Patch { shift: DVec2::ZERO, weight: 1.0, slope_per_m: DVec2::ZERO };
            let patches =
                tile.patchwork().map_or(vec![alone], |patchwork| patchwork.patches_at(place).to_vec());
            patches.into_iter().map(of_copy).sum::<f64>().ln()
        };
        cpu.tiles().iter().map(tile).sum::<f64>() - cpu.threshold()
    };
    let (mut worst, mut white) = (0.0f64, 0);
    for (place, [cover, _]) in places.iter().zip(drawn(gpu, &maps, far, &places)) {
        let at = far + DVec2::new(place[0].into(), place[1].into());
        let expected = foam_cover(excess(at), 0.0);
        worst = worst.max((f64::from(cover) - expected).abs());
        white += usize::from(expected > 0.1);
    }
    println!("cover is off by {worst:.4} at worst, {white} places are white");
    // Textures interpolate with eight bits between texels.
    assert!(white > 20 && worst < 0.05, "{worst}, {white} places");
}

/// Near and far, smooth or broken up, as much of the sea is white.
#[test]
fn the_mean_is_the_cover_at_every_distance() {
    let Some(gpu) = gpu() else { return };
    let mut maps = FoamMaps::new(&gpu.device, &gpu.queue, Some(foam())).unwrap();
    maps.update(&gpu.queue, 33.3);
    let wanted = foam().cover();
    for footprint_m in [0.002, 0.05, 0.5, 4.0, 30.0, 250.0, 4000.0] {
        let places: Vec<[f32; 4]> = (0..200_000)
            .map(|i| {
                let place = f64::from(i) * DVec2::new(0.754_877_666, 0.569_840_291) * 77.7;
                [(place.x % 20_000.0) as f32, (place.y % 20_000.0) as f32, footprint_m, 0.0]
            })
            .collect();
        let drawn = drawn(gpu, &maps, DVec2::ZERO, &places);
        let mean = |i: usize| drawn.iter().map(|there| f64::from(there[i])).sum::<f64>() / drawn.len() as f64;
        let (cover, white) = (mean(0), mean(1));
        println!(
            "{footprint_m} m: cover {:.3} %, white {:.3} % of {:.3} %",
            1e2 * cover,
            1e2 * white,
            1e2 * wanted
        );
        assert!((cover / wanted - 1.0).abs() < 0.25, "{footprint_m} m: {cover} for {wanted}");
        assert!((white / cover - 1.0).abs() < 0.15, "{footprint_m} m: {white} of {cover}");
    }
}

/// A sea without foam binds the same textures and has none.
#[test]
fn no_foam_is_no_foam() {
    let Some(gpu) = gpu() else { return };
    let mut maps = FoamMaps::new(&gpu.device, &gpu.queue, None).unwrap();
    maps.update(&gpu.queue, 1.0);
    let there = drawn(gpu, &maps, DVec2::ZERO, &[[1.0, 2.0, 0.01, 0.0]]);
    assert_eq!(there, [[0.0, 0.0]]);
}

/// Writes what one sees from above, 5 m and 80 m across, for whoever wants to look.
#[test]
fn foam_from_near_is_neither_bare_nor_even() {
    let Some(gpu) = gpu() else { return };
    let mut maps = FoamMaps::new(&gpu.device, &gpu.queue, Some(foam())).unwrap();
    maps.update(&gpu.queue, 33.3);
    const SIDE: usize = 640;
    let view = |across_m: f32, from: [f32; 2]| {
        let cell_m = across_m / SIDE as f32;
        let at = |i: usize| {
            [from[0] + cell_m * (i % SIDE) as f32, from[1] + cell_m * (i / SIDE) as f32, cell_m, 0.0]
        };
        drawn(gpu, &maps, DVec2::ZERO, &(0..SIDE * SIDE).map(at).collect::<Vec<_>>())
    };
    let wide = view(320.0, [0.0; 2]);
    let whitest = wide.iter().enumerate().max_by(|a, b| a.1[0].total_cmp(&b.1[0])).unwrap().0;
    let there = [(whitest % SIDE) as f32 * 0.5, (whitest / SIDE) as f32 * 0.5];
    for (name, across_m) in [("wide", 320.0), ("patch", 60.0), ("lace", 8.0)] {
        let from = if name == "wide" { [0.0; 2] } else { there.map(|at| at - 0.5 * across_m) };
        let foam = view(across_m, from);
        let grey: Vec<u8> = foam.iter().map(|there| (255.0 * there[1]) as u8).collect();
        let path = std::env::temp_dir().join(format!("whitecap-foam-{name}.png"));
        let side = SIDE as u32;
        image::save_buffer(path, &grey, side, side, image::ExtendedColorType::L8).unwrap();
        let share = |of: &dyn Fn(f32) -> bool| foam.iter().filter(|there| of(there[1])).count();
        let (white, bare) = (share(&|white| white > 0.6), share(&|white| white < 0.2));
        println!("{name}: {white} white, {bare} bare of {}", SIDE * SIDE);
        assert!(white > 50 && bare > 1000, "{name}: {white} white, {bare} bare");
    }
}

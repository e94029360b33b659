//! Johanson's projected grid (*Real-time water rendering: introducing the projected grid concept*, Lund 2004).
//!
//! A grid in the picture plane, thrown onto the sea by a projector ([`crate::geometry::projected_grid`]); animated
//! noise on the CPU, which lifts its vertices and is uploaded; a height map and a normal map for each view; sky,
//! sun and mirrored objects by Fresnel over a constant colour.
//!
//! docs/projected-grid.md says what the text leaves open and what is done here.

mod chunk_maps;
mod gpu;
mod maps;
mod mesh;
#[cfg(test)]
mod tests;

use super::{Build, Frame, Technique, wrong_sea};
use crate::geometry::ProjectedGrid as Grid;
use crate::geometry::projected_grid::GridRequest;
use crate::gpu::resources::buffer;
use crate::pass::{PlanarPass, PlanarSettings};
use crate::uniforms::{Role, ViewSlots};
use crate::{RenderError, View};
use chunk_maps::ChunkMaps;
use glam::{Vec2, Vec3};
use gpu::{GpuProjectedGrid, Pipeline, ViewMaps};
use maps::{GpuMaps, MapPasses, NormalMap};
use mesh::{GpuVertex, MeshSettings};
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::technique as settings;
use whitecap_scene::technique::{Normals, OffsetAxes, RefractedColor};
use whitecap_waves::model::perlin::{Chunks, PerlinNoise};
use whitecap_waves::optics::classics::sun_vector;

/// How far the mirrored and refracted objects reach past the level, as a share of the highest wave.
const LOCAL_MARGIN: f32 = 0.25;

pub(super) struct ProjectedGrid {
    settings: settings::ProjectedGrid,
    mesh: MeshSettings,
    toward_sun: Vec3,
    daylight: f32,
    noise: PerlinNoise,
    chunks: Chunks,
    chunk_maps: ChunkMaps,
    map_passes: Option<MapPasses>,
    reflection: Option<PlanarPass>,
    refraction: Option<PlanarPass>,
    pipeline: Pipeline,
    indices: wgpu::Buffer,
    index_count: u32,
    vertices: Vec<GpuVertex>,
    views: Vec<ViewState>,
}

/// What is kept for a view from frame to frame: memory, nothing that is seen.
struct ViewState {
    vertices: wgpu::Buffer,
    normals: Option<NormalMap>,
    group: wgpu::BindGroup,
    sees_water: bool,
}

impl ProjectedGrid {
    pub(super) fn new(
        build: &Build<'_>,
        settings: &settings::ProjectedGrid,
    ) -> Result<ProjectedGrid, RenderError> {
        let SeaSurface::Noise(noise) = build.scene.sea.build(build.scene.seed)? else {
            return Err(wrong_sea(build));
        };
        let device = build.device;
        let mesh =
            MeshSettings { across: settings.grid_across, down: settings.grid_down, smooth: settings.smooth };
        let indices = mesh::indices(&mesh);
        let chunk_maps = ChunkMaps::new(device, noise.chunk_size() as u32);
        let with_map = settings.normals == Normals::Map;
        let local = |role, background| {
            let size_px = [settings.local_map_size; 2];
            let margin_m = LOCAL_MARGIN * noise.max_height_m() as f32;
            PlanarPass::new(build, PlanarSettings { role, size_px, sky: false, background, margin_m })
        };
        let local_reflections = settings.local_reflections && !build.objects.is_empty();
        let [r, g, b] = settings.water_color.map(|channel| channel * f64::from(build.daylight));
        Ok(ProjectedGrid {
            mesh,
            toward_sun: toward_sun(build, settings),
            daylight: build.daylight,
            map_passes: with_map.then(|| MapPasses::new(device, settings, &chunk_maps)),
            reflection: local_reflections.then(|| local(Role::Mirror, [0.0; 4])),
            refraction: (settings.refraction == RefractedColor::Map)
                .then(|| local(Role::Refraction, [r, g, b, 1.0])),
            pipeline: Pipeline::new(build),
            index_count: indices.len() as u32,
            indices: buffer(
                device,
                build.queue,
                "projected grid",
                bytemuck::cast_slice(&indices),
                wgpu::BufferUsages::INDEX,
            ),
            settings: settings.clone(),
            chunks: Chunks::new(),
            vertices: Vec::new(),
            views: Vec::new(),
            chunk_maps,
            noise,
        })
    }

    fn grid(&self, view: &View) -> Option<Grid> {
        let settings = &self.settings;
        Grid::new(&GridRequest {
            clip_from_eye_world: view.clip_from_eye_world(),
            eye_height_m: view.eye_m.y,
            slab_m: self.noise.max_height_m() + settings.slab_margin_m,
            far_m: settings.far_km * 1000.0,
            elevation_m: settings.elevation_m,
        })
    }

    fn uniforms(&self, view: &View, mirrors: bool) -> GpuProjectedGrid {
        let settings = &self.settings;
        let option = |chosen: bool, bit: u32| if chosen { bit } else { 0 };
        GpuProjectedGrid {
            toward_sun: self.toward_sun.to_array(),
            // A sun under the horizon throws no glint.
            sun_strength: if self.toward_sun.y < 0.0 { 0.0 } else { settings.sun_strength as f32 },
            water_color: settings.water_color.map(|channel| channel as f32 * self.daylight),
            sun_shininess: settings.sun_shininess as f32,
            offset_axes: offset_axes(settings.offset_axes, view),
            level_m: -view.eye_m.y as f32,
            distortion: settings.distortion as f32,
            options: option(self.map_passes.is_some(), gpu::NORMAL_MAP)
                | option(mirrors, gpu::LOCAL_REFLECTIONS)
                | option(self.refraction.is_some(), gpu::REFRACTION_MAP),
            padding: 0,
        }
    }

    fn make_views(&mut self, device: &wgpu::Device, count: usize) {
        while self.views.len() < count {
            let index = self.views.len();
            let normals = self.map_passes.as_ref().map(|passes| passes.normal_map(device));
            let whole = normals.as_ref().map(|map| map.texture.create_view(&Default::default()));
            let maps = ViewMaps {
                normals: whole.as_ref(),
                reflection: self.reflection.as_mut().map(|pass| pass.map(device, index)),
                refraction: self.refraction.as_mut().map(|pass| pass.map(device, index)),
            };
            let group = self.pipeline.view_group(device, &maps);
            let vertices = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("projected grid"),
                size: u64::from(self.mesh.across) * u64::from(self.mesh.down) * size_of::<GpuVertex>() as u64,
                usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            self.views.push(ViewState { vertices, normals, group, sees_water: false });
        }
    }

    /// Lays the grid for one view and makes its maps.
    fn prepare_view(&mut self, frame: &mut Frame<'_>, index: usize, view: &View) {
        let grid = self.grid(view);
        self.views[index].sees_water = grid.is_some();
        let Some(grid) = grid else { return };
        mesh::fill(&mut self.vertices, &self.mesh, &grid, view.eye_m, &self.noise, &self.chunks);
        frame.queue.write_buffer(&self.views[index].vertices, 0, bytemuck::cast_slice(&self.vertices));
        frame.end_of_pass("grid");

        let state = &self.views[index];
        if let (Some(passes), Some(normals)) = (&self.map_passes, &state.normals) {
            let uniforms = GpuMaps::new(&self.settings, &self.noise, &grid, view.eye_m);
            passes.render(frame, index, &uniforms, normals, |pass| self.draw_grid(pass, state));
            frame.end_of_pass("normal map");
        }
        // From under water there is nothing over the level that the surface could mirror.
        let mirrors = view.eye_m.y > 0.0 && self.reflection.is_some();
        if let (true, Some(reflection)) = (mirrors, &mut self.reflection) {
            reflection.render(frame, index);
            frame.end_of_pass("local reflections");
        }
        if let Some(refraction) = &mut self.refraction {
            refraction.render(frame, index);
            frame.end_of_pass("refraction");
        }
        self.pipeline.slots.write(frame.queue, index, &self.uniforms(view, mirrors));
    }

    fn draw_grid(&self, pass: &mut wgpu::RenderPass<'_>, state: &ViewState) {
        pass.set_vertex_buffer(0, state.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }
}

impl Technique for ProjectedGrid {
    fn prepare(&mut self, frame: &mut Frame<'_>) -> Result<(), RenderError> {
        self.noise.evaluate(frame.time_s, &mut self.chunks);
        if self.map_passes.is_some() {
            self.chunk_maps.update(frame.queue, &self.chunks);
        }
        frame.end_of_pass("noise");
        self.make_views(frame.device, frame.views.len());
        for (index, view) in frame.views.iter().enumerate() {
            self.prepare_view(frame, index, view);
        }
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        let Some(state) = self.views.get(view).filter(|state| state.sees_water) else { return };
        pass.set_pipeline(&self.pipeline.pipeline);
        pass.set_bind_group(2, &state.group, &[ViewSlots::<GpuProjectedGrid>::offset(view)]);
        self.draw_grid(pass, state);
    }
}

/// The sky's sun, or either of the text's angles in its place. Their z runs north, ours south.
fn toward_sun(build: &Build<'_>, settings: &settings::ProjectedGrid) -> Vec3 {
    let sky = build.toward_sun.as_dvec3();
    if (settings.sun_alfa_deg, settings.sun_theta_deg) == (None, None) {
        return build.toward_sun;
    }
    let alfa = settings.sun_alfa_deg.map_or_else(|| sky.x.atan2(-sky.z), f64::to_radians);
    let theta = settings.sun_theta_deg.map_or_else(|| sky.y.clamp(-1.0, 1.0).asin(), f64::to_radians);
    sun_vector(alfa, theta).as_vec3() * Vec3::new(1.0, 1.0, -1.0)
}

/// The horizontal axes (x, z) whose slopes shift look-ups along the picture's x and y. The text's are those of its
/// left-handed world: east and north.
fn offset_axes(axes: OffsetAxes, view: &View) -> [f32; 4] {
    let [right, ahead] = match axes {
        OffsetAxes::World => [Vec2::X, Vec2::NEG_Y],
        OffsetAxes::View => {
            let right = view.view_from_world.inverse() * Vec3::X;
            let right = Vec2::new(right.x, right.z).normalize_or(Vec2::X);
            [right, Vec2::new(right.y, -right.x)]
        }
    };
    [right.x, right.y, ahead.x, ahead.y]
}

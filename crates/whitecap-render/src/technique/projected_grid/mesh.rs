//! The grid's vertices on the sea.

use crate::geometry::ProjectedGrid;
use glam::{DVec2, DVec3, Vec3};
use whitecap_waves::model::perlin::{Chunks, PerlinNoise};

/// A vertex as the technique's shaders read it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuVertex {
    /// From the eye, metres.
    pub(super) position: [f32; 3],
    /// From the neighbours in the grid; unit length, upwards.
    pub(super) normal: [f32; 3],
    /// In the grid: to the right, and away from the viewer.
    pub(super) uv: [f32; 2],
}

/// How many vertices, and whether their heights are smoothed.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeshSettings {
    pub(super) across: u32,
    pub(super) down: u32,
    pub(super) smooth: bool,
}

/// Two triangles a cell, the nearest row first.
pub(super) fn indices(settings: &MeshSettings) -> Vec<u32> {
    let MeshSettings { across, down, .. } = *settings;
    let mut indices = Vec::with_capacity(6 * (across as usize - 1) * (down as usize - 1));
    for row in 0..down - 1 {
        for column in 0..across - 1 {
            let a = row * across + column;
            let (b, c, d) = (a + 1, a + across, a + across + 1);
            indices.extend([a, b, c, c, b, d]);
        }
    }
    indices
}

/// Fills `vertices`, row by row from the near side, with the grid on the sea that `chunks` hold. Heights are read
/// bilinearly and without mips, as the text says.
pub(super) fn fill(
    vertices: &mut Vec<GpuVertex>,
    settings: &MeshSettings,
    grid: &ProjectedGrid,
    eye_m: DVec3,
    noise: &PerlinNoise,
    chunks: &Chunks,
) {
    let (across, down) = (settings.across as usize, settings.down as usize);
    let place =
        |i: usize| [(i % across) as f64 / (across - 1) as f64, (i / across) as f64 / (down - 1) as f64];
    let eye = DVec2::new(eye_m.x, eye_m.z);
    let mut points: Vec<DVec3> = (0..across * down)
        .map(|i| {
            let [u, v] = place(i);
            let from_eye = grid.point(u, v);
            DVec3::new(from_eye.x, noise.height_m(chunks, eye + from_eye), from_eye.y)
        })
        .collect();
    if settings.smooth {
        smooth(&mut points, across);
    }
    vertices.clear();
    vertices.extend((0..points.len()).map(|i| GpuVertex {
        position: (points[i] - DVec3::Y * eye_m.y).as_vec3().to_array(),
        normal: normal(&points, across, i).to_array(),
        uv: place(i).map(|along| along as f32),
    }));
}

/// A vertex and its neighbours to the left, to the right, nearer and farther. On the border it is its own.
fn neighbours(i: usize, across: usize, count: usize) -> [usize; 4] {
    let column = i % across;
    let left = if column > 0 { i - 1 } else { i };
    let right = if column + 1 < across { i + 1 } else { i };
    let near = if i >= across { i - across } else { i };
    let far = if i + across < count { i + across } else { i };
    [left, right, near, far]
}

/// The demo's option: the mean of five heights.
fn smooth(points: &mut [DVec3], across: usize) {
    let heights: Vec<f64> = points.iter().map(|point| point.y).collect();
    for (i, point) in points.iter_mut().enumerate() {
        let around: f64 = neighbours(i, across, heights.len()).iter().map(|&n| heights[n]).sum();
        point.y = 0.2 * (heights[i] + around);
    }
}

fn normal(points: &[DVec3], across: usize, i: usize) -> Vec3 {
    let [left, right, near, far] = neighbours(i, across, points.len()).map(|n| points[n]);
    (right - left).cross(far - near).normalize_or(DVec3::Y).as_vec3()
}

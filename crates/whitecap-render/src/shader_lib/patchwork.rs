//! What shaders need to sew tiles from patches.

use glam::{DVec2, IVec2};
use whitecap_waves::model::spectral::Patchwork;

/// Layout twin of `GpuPatchwork` in `patchwork.wesl`. Zeroed it leaves the tile as it is, which repeats.
#[repr(C)]
#[derive(Clone, Copy, Default, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct GpuPatchwork {
    lattice_per_m: [f32; 4],
    eye_within: [f32; 2],
    eye_corner: [i32; 2],
    eye_kind: f32,
    seed: u32,
    sewn: f32,
    padding: u32,
}

impl GpuPatchwork {
    /// For an eye over this place, metres.
    pub fn new(patchwork: Option<Patchwork>, eye_m: DVec2) -> Self {
        let Some(patchwork) = patchwork else { return Self::default() };
        let lattice_per_m = patchwork.lattice_per_m();
        let place = lattice_per_m * eye_m;
        let corner = place.floor();
        // Whole numbers far beyond the world's end wrap around, as the lattice's hash does.
        let [i, j] = corner.to_array().map(|number| number as i64);
        Self {
            lattice_per_m: lattice_per_m.to_cols_array().map(|steps| steps as f32),
            eye_within: (place - corner).as_vec2().to_array(),
            eye_corner: IVec2::new(i as i32, j as i32).to_array(),
            eye_kind: (i - j).rem_euclid(3) as f32,
            seed: patchwork.seed(),
            sewn: 1.0,
            padding: 0,
        }
    }
}

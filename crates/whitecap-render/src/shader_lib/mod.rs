//! The shaders as linked WGSL, and the WESL modules that they share.
//!
//! Each function in a shared module is the twin of a Rust function of the same name; `twins.wesl` runs
//! them all on a buffer of inputs so that a test can hold one against the other.

#[cfg(test)]
pub(crate) mod layout;
mod patchwork;
mod water_light;

pub use patchwork::GpuPatchwork;
pub use water_light::GpuWaterLight;

/// A linked shader.
#[derive(Clone, Copy, Debug)]
pub struct Shader {
    /// Its name, also its label on the device.
    pub name: &'static str,
    /// Plain WGSL.
    pub wgsl: &'static str,
}

macro_rules! shaders {
    ($($(#[$doc:meta])* $id:ident = $name:literal;)*) => {
        $($(#[$doc])* pub const $id: Shader =
            Shader { name: $name, wgsl: include_str!(concat!(env!("OUT_DIR"), "/", $name, ".wgsl")) };)*
        /// Every shader of the crate; tests validate each of them.
        pub const ALL: &[Shader] = &[$($id),*];
    };
}

shaders! {
    /// The sky behind everything.
    SKY = "sky";
    /// The sky in linear light.
    LINEAR_SKY = "linear_sky";
    /// A view's table of the sky.
    ATMOSPHERE_SKY_VIEW = "atmosphere_sky_view";
    /// A view's table of the air before things.
    ATMOSPHERE_AERIAL = "atmosphere_aerial";
    /// What pixel stages ask the sky for, on a buffer of inputs.
    ATMOSPHERE_TWINS = "atmosphere_twins";
    /// The mean light of several samples a pixel.
    MEAN = "mean";
    /// A picture from a display's light.
    DEVELOP = "develop";
    /// A picture from radiance.
    LINEAR_DEVELOP = "linear_develop";
    /// What stands or floats in the water.
    OBJECTS = "objects";
    /// The same in linear light.
    LINEAR_OBJECTS = "linear_objects";
    /// Their normals.
    OBJECTS_AUX = "objects_aux";
    /// ATI's lake.
    RIPPLING_LAKE = "rippling_lake";
    /// Both stages of the lake on buffers of inputs.
    RIPPLING_LAKE_TWINS = "rippling_lake_twins";
    /// The Meshuggah ocean.
    MESHUGGAH = "meshuggah";
    /// The same, shaded once for each sample instead of once for each pixel.
    MESHUGGAH_PER_SAMPLE = "meshuggah_per_sample";
    /// The Meshuggah ocean's vertex stage as a compute shader, for reading its results back.
    MESHUGGAH_VERTICES = "meshuggah_vertices";
    /// ATI's ocean.
    OCEAN_WATER = "ocean_water";
    /// The same, shaded once for each sample instead of once for each pixel.
    OCEAN_WATER_PER_SAMPLE = "ocean_water_per_sample";
    /// Cuts the environment off at white, into 8 bits.
    OCEAN_WATER_SKY = "ocean_water_sky";
    /// The vertex stage of ATI's ocean as a compute shader, for reading its results back.
    OCEAN_WATER_VERTICES = "ocean_water_vertices";
    /// The functions of ATI's ocean on a buffer of inputs.
    OCEAN_WATER_TWINS = "ocean_water_twins";
    /// Johanson's projected grid.
    PROJECTED_GRID = "projected_grid";
    /// Its height map.
    PROJECTED_GRID_HEIGHTS = "projected_grid_heights";
    /// Its normal map.
    PROJECTED_GRID_NORMALS = "projected_grid_normals";
    /// Its normal map's mips.
    PROJECTED_GRID_MIP = "projected_grid_mip";
    /// Its functions on a buffer of inputs.
    PROJECTED_GRID_TWINS = "projected_grid_twins";
    /// Berglund's shader of five samples.
    FIVE_SAMPLE = "five_sample";
    /// The same with what its author left for later.
    FIVE_SAMPLE_LATER = "five_sample_later";
    /// The stages before it.
    FIVE_SAMPLE_STAGES = "five_sample_stages";
    /// The dome over it.
    FIVE_SAMPLE_DOME = "five_sample_dome";
    /// Its functions on a buffer of inputs.
    FIVE_SAMPLE_TWINS = "five_sample_twins";
    /// The spectral sea: its waves at a moment.
    SPECTRAL_EVOLVE = "spectral_evolve";
    /// Its spectra, transformed along the columns.
    SPECTRAL_COLUMNS = "spectral_columns";
    /// Its fields.
    SPECTRAL_ROWS = "spectral_rows";
    /// Its displacement and slopes for vertices.
    SPECTRAL_MESH_MAPS = "spectral_mesh_maps";
    /// Its normal map.
    SPECTRAL_NORMAL_MAP = "spectral_normal_map";
    /// Its normal map's mips.
    SPECTRAL_MIPS = "spectral_mips";
    /// What the mips have lost.
    SPECTRAL_LOST_VARIANCE = "spectral_lost_variance";
    /// Its phases and points on buffers of inputs.
    SPECTRAL_TWINS = "spectral_twins";
    /// Our own ocean.
    SPECTRAL_OCEAN = "spectral_ocean";
    /// The same, shaded once for each sample instead of once for each pixel.
    SPECTRAL_OCEAN_PER_SAMPLE = "spectral_ocean_per_sample";
    /// Its normals, and how much of its light is the sun's glitter.
    SPECTRAL_OCEAN_AUX = "spectral_ocean_aux";
    /// Its vertex stage as a compute shader, for reading its results back.
    SPECTRAL_OCEAN_VERTICES = "spectral_ocean_vertices";
    /// Every shared function on a buffer of inputs.
    TWINS = "twins";
    /// The tone maps on a buffer of inputs.
    TONE_MAP_TWINS = "tone_map_twins";
    /// The sea's optics on a buffer of inputs.
    OPTICS_TWINS = "optics_twins";
    /// The sum of sines on a buffer of inputs.
    SINES_TWINS = "sines_twins";
    /// Foam as it is drawn, on a buffer of places.
    FOAM_TWINS = "foam_twins";
    /// How tiles are sewn from patches, on a buffer of places.
    PATCHWORK_TWINS = "patchwork_twins";
}

impl Shader {
    /// The module on a device.
    pub fn module(&self, device: &wgpu::Device) -> wgpu::ShaderModule {
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.name),
            source: wgpu::ShaderSource::Wgsl(self.wgsl.into()),
        })
    }
}

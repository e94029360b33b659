//! The water's own light as the shaders take it.

use whitecap_waves::optics::water_body::WaterLight;

/// Layout twin of `GpuWaterLight` in `water_light.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct GpuWaterLight {
    deep: [f32; 3],
    crest_wavenumber_per_m: f32,
    bottom: [f32; 3],
    padding_0: f32,
    attenuation_per_m: [f32; 3],
    padding_1: f32,
    scattering_per_m: [f32; 3],
    padding_2: f32,
    sun: [f32; 3],
    padding_3: f32,
}

impl From<&WaterLight> for GpuWaterLight {
    fn from(light: &WaterLight) -> GpuWaterLight {
        let single = |color: [f64; 3]| color.map(|channel| channel as f32);
        GpuWaterLight {
            deep: single(light.deep),
            crest_wavenumber_per_m: light.crest_wavenumber_per_m as f32,
            bottom: single(light.bottom),
            padding_0: 0.0,
            attenuation_per_m: single(light.attenuation_per_m),
            padding_1: 0.0,
            scattering_per_m: single(light.scattering_per_m),
            padding_2: 0.0,
            sun: single(light.sun),
            padding_3: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::GpuWaterLight;
    use crate::shader_lib::{OPTICS_TWINS, layout::assert_layout};

    #[test]
    fn the_layout_is_the_shaders() {
        assert_layout!(
            GpuWaterLight,
            OPTICS_TWINS.wgsl,
            "GpuWaterLight",
            [deep, crest_wavenumber_per_m, bottom, attenuation_per_m, scattering_per_m, sun]
        );
    }
}

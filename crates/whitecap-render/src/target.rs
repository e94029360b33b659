//! What the water is drawn into.

/// The formats of the pass that the water joins, and the sense of its depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TargetFormat {
    /// The colour attachment. Its format decides what it holds, see [`Stores`]: the display values of
    /// the classics are decoded for `…Srgb` and float, so that they look the same.
    pub color: wgpu::TextureFormat,
    /// The depth attachment.
    pub depth: wgpu::TextureFormat,
    /// [`wgpu::CompareFunction::Greater`] for a reversed depth, `Less` for the usual one.
    pub depth_compare: wgpu::CompareFunction,
    /// Samples per pixel, 1 or 4.
    pub sample_count: u32,
    /// Whether the water is shaded for each sample instead of each pixel. It smooths the sun's glints
    /// as multisampling alone smooths edges, at four times the cost: for stills. With a `sample_count` of 1 each frame
    /// counts as one of four such samples, a quarter of a pixel apart or more, whose mean is the picture.
    pub sample_shading: bool,
}

/// What a colour attachment holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stores {
    /// Display values (sRGB) as they are.
    DisplayValues = 0,
    /// Linear light of a display, which the device encodes.
    DisplayLight = 1,
    /// Radiance of the scene in kcd/m², without exposure and tone map: up to 65,000, beyond which small floats overflow, or
    /// in 32 bits all of it, the sun's disc too. Techniques that work on display values write the linear light of a
    /// display, white being 1.
    Radiance = 2,
}

impl Default for TargetFormat {
    /// Raw 8-bit colour and a reversed 32-bit depth, one sample.
    fn default() -> Self {
        TargetFormat {
            color: wgpu::TextureFormat::Rgba8Unorm,
            depth: wgpu::TextureFormat::Depth32Float,
            depth_compare: wgpu::CompareFunction::Greater,
            sample_count: 1,
            sample_shading: false,
        }
    }
}

impl TargetFormat {
    /// What the colour attachment holds.
    pub fn stores(&self) -> Stores {
        use wgpu::TextureFormat as F;
        match self.color {
            F::Rgba16Float | F::Rgba32Float | F::Rg11b10Ufloat => Stores::Radiance,
            color if color.is_srgb() => Stores::DisplayLight,
            _ => Stores::DisplayValues,
        }
    }

    /// The most radiance that the colour attachment can hold, kcd/m².
    pub(crate) fn most_radiance(&self) -> f32 {
        if self.color == wgpu::TextureFormat::Rgba32Float { 1e9 } else { 65_000.0 }
    }

    /// The depth of what is infinitely far away.
    pub fn far_depth(&self) -> f32 {
        if self.is_reversed() { 0.0 } else { 1.0 }
    }

    pub(crate) fn is_reversed(&self) -> bool {
        matches!(self.depth_compare, wgpu::CompareFunction::Greater | wgpu::CompareFunction::GreaterEqual)
    }

    pub(crate) fn depth_state(&self, write: bool) -> wgpu::DepthStencilState {
        // The sky lies at the far depth itself, where a strict comparison would reject it.
        let compare = match (write, self.is_reversed()) {
            (true, _) => self.depth_compare,
            (false, true) => wgpu::CompareFunction::GreaterEqual,
            (false, false) => wgpu::CompareFunction::LessEqual,
        };
        wgpu::DepthStencilState {
            format: self.depth,
            depth_write_enabled: Some(write),
            depth_compare: Some(compare),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }
    }

    pub(crate) fn multisample(&self) -> wgpu::MultisampleState {
        wgpu::MultisampleState { count: self.sample_count, ..Default::default() }
    }
}

//! What can be baked of a surface.

use clap::builder::PossibleValue;

/// A field of numbers over the water at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Map {
    Displacement,
    Normal,
    Slope,
    Jacobian,
    Foam,
    Velocity,
}

impl clap::ValueEnum for Map {
    fn value_variants<'a>() -> &'a [Self] {
        &[Map::Displacement, Map::Normal, Map::Slope, Map::Jacobian, Map::Foam, Map::Velocity]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.word()).help(self.doc()))
    }
}

impl Map {
    pub(super) fn word(self) -> &'static str {
        match self {
            Map::Displacement => "displacement",
            Map::Normal => "normal",
            Map::Slope => "slope",
            Map::Jacobian => "jacobian",
            Map::Foam => "foam",
            Map::Velocity => "velocity",
        }
    }

    pub(super) fn doc(self) -> &'static str {
        match self {
            Map::Displacement => "from where the water rests: east, up, south",
            Map::Normal => "unit normal of the displaced surface: east, up, south",
            Map::Slope => "of the height by the rest coordinates: by x (east), by z (south)",
            Map::Jacobian => "area seen from above per area at rest; below 0 where the surface folds",
            Map::Foam => {
                "share that foam covers; of a single cascade e-folds, of which the share follows by the threshold"
            }
            Map::Velocity => "of the water: east, up, south",
        }
    }

    pub(super) fn unit(self) -> &'static str {
        match self {
            Map::Displacement => "m",
            Map::Velocity => "m/s",
            Map::Normal | Map::Slope | Map::Jacobian | Map::Foam => "1",
        }
    }

    /// Names of its channels, as programs for pictures know them.
    pub(super) fn channels(self) -> &'static [&'static str] {
        match self {
            Map::Displacement | Map::Normal | Map::Velocity => &["R", "G", "B"],
            Map::Slope => &["R", "G"],
            Map::Jacobian | Map::Foam => &["Y"],
        }
    }
}

/// Numbers over a rectangle, row by row from north to south, a plane for each channel.
pub(super) struct Raster {
    pub(super) size: [usize; 2],
    pub(super) planes: Vec<Vec<f32>>,
}

impl Raster {
    /// Of `size`, with channels from `of` a sample.
    pub(super) fn new<const N: usize>(size: [usize; 2], of: impl Fn(usize) -> [f32; N]) -> Raster {
        let count = size[0] * size[1];
        let mut planes = vec![Vec::with_capacity(count); N];
        for i in 0..count {
            for (plane, value) in planes.iter_mut().zip(of(i)) {
                plane.push(value);
            }
        }
        Raster { size, planes }
    }
}

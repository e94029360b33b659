//! What stands or floats in the water.

mod built_in;
mod model;

pub use built_in::BuiltInMesh;
pub use model::{Model, ground};

use std::path::PathBuf;

use crate::error::SceneError;
use crate::key::{File, Flag, OneOf, Point, Real, Tables, optional, or, table};
use crate::reader::TableReader;

table! {
    /// An object: a table `[[object]]`. It has either a `mesh` or a `file`.
    pub struct Object {
        /// A mesh that comes with the library.
        mesh: Option<BuiltInMesh> = optional(OneOf::<BuiltInMesh>::WORDS, "see `file`");
        /// A mesh of your own: glTF 2.0, as `.gltf` or `.glb`.
        file: Option<PathBuf> = optional(File, "see `mesh`");
        /// Where the mesh's origin stands: x east, y up, z south.
        position_m: [f64; 3] = or(Point { far: 1e7, min_y: -1000.0, max_y: 1e5 }, [0.0, 0.0, 0.0]);
        /// The bearing that its front faces, clockwise from north. The front of a file is its +z, as glTF has it.
        heading_deg: f64 = or(Real { unit: "deg", min: -360.0, max: 360.0 }, 0.0);
        /// How many times its own size it is.
        scale: f64 = or(Real { unit: "", min: 1e-3, max: 1e3 }, 1.0);
        /// Whether it rides on the waves: it takes their height, and tilts with them.
        floats: bool = or(Flag, false);
        /// The radius of the circle that it travels about `position_m`; at 0 it stays.
        circle_radius_m: f64 = or(Real { unit: "m", min: 0.0, max: 1e5 }, 0.0);
        /// The time that it takes for the circle, clockwise seen from above.
        circle_period_s: f64 = or(Real { unit: "s", min: 1.0, max: 1e6 }, 60.0);
    }
}

impl Object {
    fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        let object = Self::read(table)?;
        match (&object.mesh, &object.file) {
            (None, None) => Err(table.error(None, "has neither mesh nor file; accepted: one of the two")),
            (Some(_), Some(_)) => {
                Err(table.error(Some("file"), "beside mesh; accepted: one of the two, mesh or file"))
            }
            _ => Ok(object),
        }
    }
}

/// The objects of a scene, `[[object]]`.
pub(crate) const OBJECTS: Tables<Object> =
    Tables { name: "object", min: 0, max: 64, read: Object::read_checked };

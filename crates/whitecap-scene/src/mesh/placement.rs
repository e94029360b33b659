//! Where a mesh stands in the world.

use glam::{DAffine3, DQuat, DVec3};

/// Where a mesh stands, which way it heads and how large it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Where the origin of the mesh is in the world, metres: x east, y up, z south.
    pub position_m: DVec3,
    /// Where its bow, the mesh's −z, points: degrees clockwise from north as seen from above. 0 leaves the mesh
    /// as it is, 90 turns its bow to the east.
    pub heading_deg: f64,
    /// How many times larger than in its own units it is.
    pub scale: f64,
}

impl Default for Placement {
    /// At the origin, heading north, as large as it is.
    fn default() -> Self {
        Placement { position_m: DVec3::ZERO, heading_deg: 0.0, scale: 1.0 }
    }
}

impl Placement {
    /// Turns places in the mesh into places in the world.
    pub fn world_from_mesh(&self) -> DAffine3 {
        // Seen from above, y towards the eye, positive angles run counter-clockwise; bearings run clockwise.
        // Reducing in degrees keeps large headings exact.
        let turn = DQuat::from_rotation_y(-(self.heading_deg % 360.0).to_radians());
        DAffine3::from_scale_rotation_translation(DVec3::splat(self.scale), turn, self.position_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_are_bearings() {
        let bow = DVec3::NEG_Z;
        for (heading_deg, toward) in [
            (0.0, DVec3::NEG_Z),
            (90.0, DVec3::X),
            (180.0, DVec3::Z),
            (270.0, DVec3::NEG_X),
            (-90.0, DVec3::NEG_X),
            (360.0 * 1e6 + 90.0, DVec3::X),
        ] {
            let placement = Placement { heading_deg, ..Placement::default() };
            let heads = placement.world_from_mesh().transform_vector3(bow);
            assert!(heads.distance(toward) < 1e-12, "{heading_deg}: {heads}");
        }
    }

    #[test]
    fn a_mesh_is_scaled_then_turned_then_moved() {
        let placement =
            Placement { position_m: DVec3::new(100.0, 2.0, -50.0), heading_deg: 90.0, scale: 3.0 };
        let place = placement.world_from_mesh().transform_point3(DVec3::new(0.0, 1.0, -2.0));
        assert!(place.distance(DVec3::new(106.0, 5.0, -50.0)) < 1e-12, "{place}");
    }
}

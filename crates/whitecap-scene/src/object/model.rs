//! An object with its mesh, and where it is at a moment.

use std::sync::Arc;

use glam::{DAffine3, DQuat, DVec2, DVec3};
use whitecap_waves::model::Surface;
use whitecap_waves::query::rest_under;

use super::Object;
use crate::mesh::{Ground, Mesh, MeshError, Placement};

/// An object that is ready to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// What the scene says of it.
    pub object: Object,
    /// Its mesh.
    pub mesh: Arc<Mesh>,
}

impl Object {
    /// The object with its mesh: a built-in one is made, a file is read.
    ///
    /// # Errors
    ///
    /// When [`Mesh::load`] cannot read the file.
    pub fn model(&self, seed: u64) -> Result<Model, MeshError> {
        let mesh = match (self.mesh, &self.file) {
            (Some(built_in), _) => built_in.make(seed),
            (None, Some(file)) => Mesh::load(file)?,
            (None, None) => Mesh::default(),
        };
        Ok(Model { object: self.clone(), mesh: Arc::new(mesh) })
    }

    /// Whether it is always in the same place.
    pub fn stands_still(&self) -> bool {
        !self.floats && self.circle_radius_m == 0.0
    }

    /// World from mesh at `time_s` on the water `surface`: a function of the time alone.
    ///
    /// What travels faces along its circle; what floats takes the surface's height and leans with its normal.
    pub fn world_from_mesh(&self, surface: &dyn Surface, time_s: f64) -> DAffine3 {
        let mut position_m = DVec3::from(self.position_m);
        let mut heading_rad = self.mesh_heading_deg().to_radians();
        if self.circle_radius_m > 0.0 {
            // Clockwise from above: north, east, south, west; the front is a quarter turn ahead.
            let turn = std::f64::consts::TAU * (time_s / self.circle_period_s).rem_euclid(1.0);
            position_m += self.circle_radius_m * DVec3::new(turn.sin(), 0.0, -turn.cos());
            heading_rad += turn + std::f64::consts::FRAC_PI_2;
        }
        let mut lean = DQuat::IDENTITY;
        if self.floats {
            let rest_m = rest_under(surface, DVec2::new(position_m.x, position_m.z), time_s);
            let water = surface.sample(rest_m, time_s);
            position_m.y += water.displacement_m.y;
            lean = DQuat::from_rotation_arc(DVec3::Y, water.normal);
        }
        // Bearings run clockwise seen from above, rotations about y the other way.
        let rotation = lean * DQuat::from_rotation_y(-heading_rad);
        DAffine3::from_scale_rotation_translation(DVec3::splat(self.scale), rotation, position_m)
    }

    /// The bearing of the mesh's −z. The front of our meshes; that of a glTF file is its +z (glTF 2.0, section
    /// 3.3).
    fn mesh_heading_deg(&self) -> f64 {
        self.heading_deg + if self.file.is_some() { 180.0 } else { 0.0 }
    }

    /// Where it stands if it stands still.
    pub fn placement(&self) -> Placement {
        Placement {
            position_m: self.position_m.into(),
            heading_deg: self.mesh_heading_deg(),
            scale: self.scale,
        }
    }
}

/// Texels along the longer side of the ground.
const GROUND_RESOLUTION: usize = 512;

/// The ground that the models which stand still make; `None` where none does.
pub fn ground(models: &[Model]) -> Option<Ground> {
    let still = models.iter().filter(|model| model.object.stands_still());
    let placed = still.map(|model| (&model.mesh, model.object.placement()));
    let triangles: Vec<_> = placed
        .flat_map(|(mesh, placement)| mesh.triangles_in_world(&placement).collect::<Vec<_>>())
        .collect();
    Ground::new(triangles.into_iter(), GROUND_RESOLUTION)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scene;
    use whitecap_waves::model::Calm;

    fn object(toml: &str) -> Object {
        let base = crate::named::find("meshuggah").unwrap().toml;
        let scene = Scene::from_toml(&format!("{base}\n[[object]]\n{toml}\n"), "test.toml").unwrap();
        scene.objects[0].clone()
    }

    #[test]
    fn a_heading_is_a_bearing_of_the_front() {
        // The front of a mesh is its −z: north at heading 0.
        for (heading_deg, front) in
            [(0.0, DVec3::NEG_Z), (90.0, DVec3::X), (180.0, DVec3::Z), (270.0, DVec3::NEG_X)]
        {
            let object = object(&format!("mesh = \"duck\"\nheading_deg = {heading_deg}\nscale = 2.0"));
            let world_from_mesh = object.world_from_mesh(&Calm, 0.0);
            assert!((world_from_mesh.transform_vector3(DVec3::NEG_Z) - 2.0 * front).length() < 1e-12);
        }
    }

    #[test]
    fn the_front_of_a_gltf_file_is_its_plus_z() {
        let object = object("file = \"boat.glb\"\nheading_deg = 90.0");
        assert!((object.world_from_mesh(&Calm, 0.0).transform_vector3(DVec3::Z) - DVec3::X).length() < 1e-12);
        let placed = object.placement().world_from_mesh();
        assert!((placed.transform_vector3(DVec3::Z) - DVec3::X).length() < 1e-12);
    }

    #[test]
    fn a_circle_is_travelled_clockwise_facing_ahead() {
        let object = object("mesh = \"duck\"\ncircle_radius_m = 10.0\ncircle_period_s = 40.0");
        let at = |time_s: f64| object.world_from_mesh(&Calm, time_s);
        assert!((at(0.0).translation - DVec3::new(0.0, 0.0, -10.0)).length() < 1e-9);
        assert!((at(10.0).translation - DVec3::new(10.0, 0.0, 0.0)).length() < 1e-9);
        for time_s in [0.0, 7.0, 23.0] {
            let ahead = (at(time_s + 1e-4).translation - at(time_s).translation).normalize();
            assert!(at(time_s).transform_vector3(DVec3::NEG_Z).distance(ahead) < 1e-3);
        }
        assert!((at(1e6).translation - at(0.0).translation).length() < 1e-6);
    }

    #[test]
    fn what_stands_still_stands_where_its_placement_says() {
        let object =
            object("mesh = \"posts\"\nheading_deg = 35.0\nscale = 3.0\nposition_m = [4.0, 1.0, -9.0]");
        let corner = DVec3::new(1.0, 2.0, 3.0);
        let placed = object.placement().world_from_mesh().transform_point3(corner);
        assert!(object.world_from_mesh(&Calm, 12.0).transform_point3(corner).distance(placed) < 1e-12);
    }

    #[test]
    fn what_floats_rides_on_the_surface() {
        let scene = crate::open("meshuggah").unwrap();
        let sea = scene.sea.build(scene.seed).unwrap();
        let object = object("mesh = \"duck\"\nfloats = true\nposition_m = [12.0, 0.0, -7.0]");
        for time_s in [0.0, 3.7, 100.0] {
            let placed = object.world_from_mesh(&*sea, time_s);
            let rest = rest_under(&*sea, DVec2::new(12.0, -7.0), time_s);
            let water = sea.sample(rest, time_s).displacement_m;
            assert!((rest.x + water.x - 12.0).abs() < 1e-3 && (rest.y + water.z + 7.0).abs() < 1e-3);
            assert!((placed.translation.y - water.y).abs() < 1e-9);
            assert!(placed.transform_vector3(DVec3::Y).y > 0.7);
        }
    }
}

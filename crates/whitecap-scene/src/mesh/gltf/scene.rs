//! The nodes of a scene, all made into one mesh (section 3.5).

use std::borrow::Cow;

use glam::{DMat4, DQuat, DVec3, Mat4, Quat, Vec3};
use gltf::json::Root;
use gltf::json::scene::Node;

use super::Mesh;
use super::accessor::Source;
use super::primitive;
use crate::mesh::error::MeshProblem;

/// The meshes of all nodes in the default scene.
pub(super) fn flatten(root: &Root, buffers: &[Cow<'_, [u8]>]) -> Result<Mesh, MeshProblem> {
    let source = Source { root, buffers };
    let mut mesh = Mesh::default();
    let mut open: Vec<(usize, DMat4)> =
        roots(root)?.into_iter().map(|node| (node, DMat4::IDENTITY)).collect();
    // The first root is taken first.
    open.reverse();
    let mut reached = vec![false; root.nodes.len()];
    while let Some((index, world_from_parent)) = open.pop() {
        let faulty = |part, index, explanation: &str| MeshProblem::Faulty {
            part,
            index,
            explanation: explanation.to_owned(),
        };
        let node = root.nodes.get(index).ok_or_else(|| faulty("node", index, "there is no such node"))?;
        // Without this a circle of nodes would never end.
        if std::mem::replace(&mut reached[index], true) {
            return Err(faulty("node", index, "reached twice; accepted: nodes that form trees"));
        }
        let world_from_node = world_from_parent * parent_from_node(node);
        if let Some(number) = node.mesh.map(|mesh| mesh.value()) {
            let shown =
                root.meshes.get(number).ok_or_else(|| faulty("mesh", number, "there is no such mesh"))?;
            for part in &shown.primitives {
                primitive::append(&mut mesh, &source, part, number, &world_from_node)?;
            }
        }
        let children = node.children.iter().flatten().rev();
        open.extend(children.map(|child| (child.value(), world_from_node)));
    }
    // A node scaled to nothing would be drawn as nothing, and nobody would know why.
    let is_a_point = mesh.bounds().is_none_or(|[low, high]| low == high);
    if mesh.indices.is_empty() || is_a_point { Err(MeshProblem::NoTriangles) } else { Ok(mesh) }
}

/// The roots of the default scene: the one that the file names, or else the first, or else all nodes that are no
/// node's child.
fn roots(root: &Root) -> Result<Vec<usize>, MeshProblem> {
    let default = root.scene.map(|scene| scene.value());
    match root.scenes.get(default.unwrap_or(0)) {
        Some(scene) => Ok(scene.nodes.iter().map(|node| node.value()).collect()),
        None => match default {
            Some(index) => {
                let explanation = "there is no such scene".to_owned();
                Err(MeshProblem::Faulty { part: "scene", index, explanation })
            }
            None => {
                let mut is_root = vec![true; root.nodes.len()];
                for child in root.nodes.iter().flat_map(|node| node.children.iter().flatten()) {
                    if let Some(is_root) = is_root.get_mut(child.value()) {
                        *is_root = false;
                    }
                }
                Ok((0..root.nodes.len()).filter(|node| is_root[*node]).collect())
            }
        },
    }
}

fn parent_from_node(node: &Node) -> DMat4 {
    if let Some(columns) = &node.matrix {
        return Mat4::from_cols_array(columns).as_dmat4();
    }
    let vector =
        |values: Option<[f32; 3]>, absent| values.map_or(absent, |values| Vec3::from(values).as_dvec3());
    let turn = node.rotation.as_ref().map_or(DQuat::IDENTITY, |turn| Quat::from_array(turn.0).as_dquat());
    // A quaternion of no length turns nothing.
    let turn = if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY };
    DMat4::from_scale_rotation_translation(
        vector(node.scale, DVec3::ONE),
        turn,
        vector(node.translation, DVec3::ZERO),
    )
}

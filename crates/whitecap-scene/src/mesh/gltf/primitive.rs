//! A primitive of a glTF mesh: vertices, colours and triangles (section 3.7.2).

use glam::{DMat3, DMat4, DVec3, Vec3, Vec4};
use gltf::json::accessor::Type;
use gltf::json::material::Material;
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};

use super::Mesh;
use super::accessor::Source;
use super::container::at_most;
use crate::mesh::error::MeshProblem;

/// Adds a primitive of mesh number `of_mesh` to `mesh`, transformed.
pub(super) fn append(
    mesh: &mut Mesh,
    source: &Source<'_>,
    primitive: &Primitive,
    of_mesh: usize,
    world_from_primitive: &DMat4,
) -> Result<(), MeshProblem> {
    let problem = |explanation: &str| MeshProblem::Faulty {
        part: "mesh",
        index: of_mesh,
        explanation: explanation.to_owned(),
    };
    let Checked::Valid(mode) = primitive.mode else {
        return Err(problem("a primitive of an unknown mode"));
    };
    if !matches!(mode, Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
        return Err(problem("points or lines; accepted: triangles, triangle strips and fans"));
    }
    let attribute = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).copied();
    let Some(positions) = attribute(Semantic::Positions) else {
        return Err(problem("a primitive without positions"));
    };

    // Counted before anything is read: a few bytes can claim any number.
    let vertices = source.count(positions)?;
    at_most("vertices", vertices.saturating_add(mesh.positions.len() as u64), Mesh::MAX_VERTICES as u64)?;
    let corners = primitive.indices.map_or(Ok(vertices), |indices| source.count(indices))?;
    let triangles = if mode == Mode::Triangles { corners / 3 } else { corners.saturating_sub(2) };
    let all = triangles.saturating_add(mesh.indices.len() as u64 / 3);
    at_most("triangles", all, Mesh::MAX_TRIANGLES as u64)?;
    let optional = [attribute(Semantic::Normals), attribute(Semantic::Colors(0))];
    for index in optional.into_iter().flatten() {
        let count = source.count(index)?;
        if count != vertices {
            return Err(problem(&format!("{vertices} positions, but {count} in accessor {}", index.value())));
        }
    }

    let mut places = Vec::new();
    for position in source.rows::<3>(positions, &[Type::Vec3])? {
        let place = world_from_primitive.transform_point3(Vec3::from(position).as_dvec3());
        // NaN is beyond it too.
        if !place.abs().cmple(DVec3::splat(Mesh::MAX_REACH_M)).all() {
            return Err(problem(&format!(
                "a vertex that is infinite, not a number or far away; accepted: up to {} m from the origin",
                Mesh::MAX_REACH_M
            )));
        }
        places.push(place);
    }
    let base = base_color(source.root, primitive.material)?;
    let colors: Vec<Vec3> = match optional[1] {
        Some(index) => {
            let rows = source.rows::<4>(index, &[Type::Vec3, Type::Vec4])?;
            rows.into_iter().map(|row| displayed(base * Vec4::from(row).truncate())).collect()
        }
        None => vec![displayed(base); places.len()],
    };
    let corners = match primitive.indices {
        Some(index) => source.indices(index)?,
        None => (0..places.len() as u32).collect(),
    };
    if let Some(corner) = corners.iter().find(|corner| **corner as usize >= places.len()) {
        return Err(problem(&format!("index {corner} among {} vertices", places.len())));
    }

    // A transform that mirrors turns the triangles round (section 3.7.4).
    let linear = DMat3::from_mat4(*world_from_primitive);
    let mirrors = linear.determinant() < 0.0;
    let mut faces = faces(&corners, mode);
    if mirrors {
        faces.iter_mut().for_each(|face| face.swap(1, 2));
    }
    let normals = match optional[0] {
        Some(index) => whole_normals(source.rows::<3>(index, &[Type::Vec3])?),
        None => None,
    };
    if let Some(normals) = normals {
        let world_from_normal = cofactors(linear) * if mirrors { -1.0 } else { 1.0 };
        let first = mesh.positions.len() as u32;
        for ((place, normal), color) in places.iter().zip(normals).zip(colors) {
            mesh.push(*place, (world_from_normal * normal).normalize_or_zero(), color);
        }
        mesh.indices.extend(faces.iter().flatten().map(|corner| first + corner));
    } else {
        // Flat, as section 3.7.2.1 asks for: no vertex is shared.
        at_most("vertices", (mesh.positions.len() + 3 * faces.len()) as u64, Mesh::MAX_VERTICES as u64)?;
        for face in faces {
            let [a, b, c] = face.map(|corner| places[corner as usize]);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            for corner in face {
                let index = mesh.push(places[corner as usize], normal, colors[corner as usize]);
                mesh.indices.push(index);
            }
        }
    }
    Ok(())
}

/// The corners of each triangle (section 3.7.2.1).
fn faces(corners: &[u32], mode: Mode) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => {
            let turned = |(index, corners): (usize, &[u32])| {
                let [odd, even] = if index % 2 == 0 { [1, 2] } else { [2, 1] };
                [corners[0], corners[odd], corners[even]]
            };
            corners.windows(3).enumerate().map(turned).collect()
        }
        Mode::TriangleFan => {
            let edges = corners.get(1..).unwrap_or_default().windows(2);
            edges.map(|edge| [edge[0], edge[1], corners[0]]).collect()
        }
        _ => corners.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]]).collect(),
    }
}

/// The normals, unless one of them points nowhere.
fn whole_normals(rows: Vec<[f32; 3]>) -> Option<Vec<DVec3>> {
    let normals: Vec<DVec3> = rows.into_iter().map(|row| Vec3::from(row).as_dvec3()).collect();
    normals.iter().all(|normal| normal.try_normalize().is_some()).then_some(normals)
}

/// What normals are transformed by, but for length and sign. Unlike the inverse's transpose it is there for
/// transforms that flatten.
fn cofactors(linear: DMat3) -> DMat3 {
    let DMat3 { x_axis, y_axis, z_axis } = linear;
    DMat3::from_cols(y_axis.cross(z_axis), z_axis.cross(x_axis), x_axis.cross(y_axis))
}

/// The base colour of a material, linear.
fn base_color(root: &Root, material: Option<Index<Material>>) -> Result<Vec3, MeshProblem> {
    let Some(index) = material.map(|material| material.value()) else { return Ok(Vec3::ONE) };
    let material = root.materials.get(index).ok_or_else(|| {
        let explanation = "there is no such material".to_owned();
        MeshProblem::Faulty { part: "material", index, explanation }
    })?;
    Ok(Vec4::from(material.pbr_metallic_roughness.base_color_factor.0).truncate())
}

/// A linear colour as a display shows it (IEC 61966-2-1). What is outside 0 to 1 or not a number is brought inside.
fn displayed(linear: Vec3) -> Vec3 {
    let encode = |value: f32| {
        let value = if value > 0.0 { f64::from(value.min(1.0)) } else { 0.0 };
        let encoded =
            if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
        encoded as f32
    };
    Vec3::new(encode(linear.x), encode(linear.y), encode(linear.z))
}

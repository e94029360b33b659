//! Smooth bodies from fields: negative inside, zero on the surface, about the distance to it.

use glam::{DVec3, IVec3, Vec3};

use super::Mesh;

/// About the distance to an ellipsoid around `center` with half-axes `radii`: the value over the gradient's length
/// (Taubin, "Estimation of planar curves, surfaces, and nonplanar space curves", PAMI 1991).
pub(super) fn ellipsoid(place: DVec3, center: DVec3, radii: DVec3) -> f64 {
    let scaled = (place - center) / radii;
    let length = scaled.length();
    let gradient = (scaled / radii).length();
    if gradient < 1e-9 { -radii.min_element() } else { length * (length - 1.0) / gradient }
}

/// About the distance to a rod from `a` to `b` whose radius goes from `radius_a` to `radius_b`.
pub(super) fn rod(place: DVec3, [a, b]: [DVec3; 2], radius_a: f64, radius_b: f64) -> f64 {
    let along = ((place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    place.distance(a.lerp(b, along)) - (radius_a + along * (radius_b - radius_a))
}

/// The union of two bodies, with a fillet about `blend` wide: the minimum, rounded by a parabola where the two are
/// nearly equal.
pub(super) fn blend(a: f64, b: f64, blend: f64) -> f64 {
    let overlap = (blend - (a - b).abs()).max(0.0);
    a.min(b) - overlap * overlap / (4.0 * blend)
}

/// The surface of a field within a box, by surface nets (Gibson, "Constrained elastic surface nets", MICCAI 1998):
/// a vertex in each cell of the grid that the surface crosses, a square across each edge that it crosses. The
/// vertices are then moved onto the surface.
pub(super) fn surface(
    field: impl Fn(DVec3) -> f64,
    [low, high]: [DVec3; 2],
    cell_m: f64,
    color: Vec3,
) -> Mesh {
    let cells = ((high - low) / cell_m).ceil().as_ivec3() + IVec3::ONE;
    let place = |corner: IVec3| low + corner.as_dvec3() * cell_m;
    let index = |corner: IVec3| ((corner.z * cells.y + corner.y) * cells.x + corner.x) as usize;
    let corners = || {
        (0..cells.z)
            .flat_map(move |z| (0..cells.y).flat_map(move |y| (0..cells.x).map(move |x| IVec3::new(x, y, z))))
    };
    let values: Vec<f64> = corners().map(|corner| field(place(corner))).collect();

    let mut mesh = Mesh::default();
    let mut vertex_of = vec![None; values.len()];
    for corner in corners().filter(|corner| (*corner + 1).cmplt(cells).all()) {
        if let Some(start) = crossing(|step| values[index(corner + step)]) {
            let on_surface = settle(&field, place(corner) + start * cell_m, cell_m);
            vertex_of[index(corner)] = Some(mesh.push(on_surface, gradient(&field, on_surface), color));
        }
    }
    for corner in corners() {
        for (axis, u, v) in
            [(IVec3::X, IVec3::Y, IVec3::Z), (IVec3::Y, IVec3::Z, IVec3::X), (IVec3::Z, IVec3::X, IVec3::Y)]
        {
            let beside = [corner - u - v, corner - v, corner, corner - u];
            if (corner + axis).cmpge(cells).any() || beside.iter().any(|cell| cell.cmplt(IVec3::ZERO).any()) {
                continue;
            }
            let (from, to) = (values[index(corner)], values[index(corner + axis)]);
            if (from < 0.0) == (to < 0.0) {
                continue;
            }
            let [Some(a), Some(b), Some(c), Some(d)] = beside.map(|cell| vertex_of[index(cell)]) else {
                continue;
            };
            let [a, b, c, d] = if from < 0.0 { [a, b, c, d] } else { [a, d, c, b] };
            let between = |a: u32, b: u32| {
                Vec3::from(mesh.positions[a as usize]).distance(mesh.positions[b as usize].into())
            };
            if between(a, c) <= between(b, d) {
                mesh.indices.extend([a, b, c, a, c, d]);
            } else {
                mesh.indices.extend([a, b, d, b, c, d]);
            }
        }
    }
    mesh
}

/// The mean place, in cells, where the surface crosses the edges of a cell with these values at its corners.
fn crossing(value: impl Fn(IVec3) -> f64) -> Option<DVec3> {
    let (mut sum, mut count) = (DVec3::ZERO, 0.0);
    for [axis, u, v] in
        [[IVec3::X, IVec3::Y, IVec3::Z], [IVec3::Y, IVec3::Z, IVec3::X], [IVec3::Z, IVec3::X, IVec3::Y]]
    {
        for edge in [IVec3::ZERO, u, v, u + v] {
            let (from, to) = (value(edge), value(edge + axis));
            if (from < 0.0) != (to < 0.0) {
                sum += edge.as_dvec3() + axis.as_dvec3() * (from / (from - to));
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| sum / count)
}

fn gradient(field: impl Fn(DVec3) -> f64, place: DVec3) -> DVec3 {
    const STEP_M: f64 = 1e-4;
    let along = |axis: DVec3| field(place + axis * STEP_M) - field(place - axis * STEP_M);
    DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z)) / (2.0 * STEP_M)
}

/// Newton's steps from `start` to the surface, none longer than half a cell.
fn settle(field: impl Fn(DVec3) -> f64, start: DVec3, cell_m: f64) -> DVec3 {
    let mut place = start;
    for _ in 0..4 {
        let slope = gradient(&field, place);
        let step = slope * (field(place) / slope.length_squared().max(1e-6));
        place -= step.clamp_length_max(0.25 * cell_m);
    }
    place
}

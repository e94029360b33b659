//! Meshes from glTF files: what is read, what is refused and how, and that no bytes bring a panic.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use std::path::Path;

use base64::Engine as _;
use glam::Vec3;
use proptest::prelude::*;
use whitecap_scene::mesh::Mesh;

/// A triangle in the plane y = 1 that faces up: positions, indices, colours, normals.
fn blob() -> Vec<u8> {
    let mut blob = Vec::new();
    let floats =
        |blob: &mut Vec<u8>, values: &[f32]| blob.extend(values.iter().flat_map(|v| v.to_le_bytes()));
    floats(&mut blob, &[0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0]);
    blob.extend([0, 0, 1, 0, 2, 0, 0, 0]);
    blob.extend([255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255]);
    floats(&mut blob, &[0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
    blob
}

const JSON: &str = r#"{
    "asset": {"version": "2.0"},
    "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 3, "COLOR_0": 2}, "indices": 1}]}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
        {"bufferView": 2, "componentType": 5121, "count": 3, "type": "VEC4", "normalized": true},
        {"bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC3"}
    ],
    "bufferViews": [
        {"buffer": 0, "byteOffset": 0, "byteLength": 36},
        {"buffer": 0, "byteOffset": 36, "byteLength": 6},
        {"buffer": 0, "byteOffset": 44, "byteLength": 12},
        {"buffer": 0, "byteOffset": 56, "byteLength": 36}
    ],
    "buffers": [{"byteLength": 92}]
}"#;

/// A `.glb` file of this JSON and blob.
fn glb(json: &str, blob: &[u8]) -> Vec<u8> {
    let mut chunks = Vec::new();
    for (kind, data, padding) in [(b"JSON", json.as_bytes(), b' '), (b"BIN\0", blob, 0)] {
        let length = data.len().next_multiple_of(4);
        chunks.extend((length as u32).to_le_bytes());
        chunks.extend(kind);
        chunks.extend(data);
        chunks.resize(chunks.len() + length - data.len(), padding);
    }
    let length = 12 + chunks.len() as u32;
    [b"glTF", &2_u32.to_le_bytes()[..], &length.to_le_bytes(), &chunks].concat()
}

/// A `.gltf` file of this JSON, its blob inside.
fn embedded(json: &str, blob: &[u8]) -> String {
    let data = base64::engine::general_purpose::STANDARD.encode(blob);
    let uri = format!("\"uri\": \"data:application/octet-stream;base64,{data}\", \"byteLength\": 92");
    json.replace("\"byteLength\": 92", &uri)
}

/// The JSON with one place changed, which must be there.
fn with(from: &str, to: &str) -> String {
    assert!(JSON.contains(from), "{from}");
    JSON.replacen(from, to, 1)
}

fn read(json: &str) -> Mesh {
    let mesh = Mesh::from_gltf_bytes(&glb(json, &blob()), "duck.glb").unwrap();
    mesh.validate().unwrap();
    mesh
}

fn problem(json: &str) -> String {
    let message = Mesh::from_gltf_bytes(&glb(json, &blob()), "duck.glb").unwrap_err().to_string();
    let problem = message.strip_prefix("duck.glb: ").unwrap().to_owned();
    assert!(!problem.contains('\n'), "{problem}");
    problem
}

/// The normal of the first triangle by its corners' order.
fn face(mesh: &Mesh) -> Vec3 {
    let [a, b, c] = mesh.triangles().next().unwrap();
    (b - a).cross(c - a).normalize()
}

fn assert_is_triangle(mesh: &Mesh) {
    assert_eq!(mesh.positions, [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [1.0, 1.0, 0.0]]);
    assert_eq!(mesh.normals, [[0.0, 1.0, 0.0]; 3]);
    assert_eq!(mesh.colors, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(mesh.indices, [0, 1, 2]);
}

#[test]
fn a_triangle_is_read_from_every_form() {
    assert_is_triangle(&read(JSON));
    let json = embedded(JSON, &blob());
    assert_is_triangle(&Mesh::from_gltf_bytes(json.as_bytes(), "duck").unwrap());
    assert_is_triangle(&Mesh::from_gltf_bytes(format!("\u{feff}\n{json}").as_bytes(), "duck").unwrap());
    assert_is_triangle(&Mesh::from_gltf_bytes(json.replace('=', "").as_bytes(), "duck").unwrap());

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("duck.gltf");
    std::fs::create_dir(folder.path().join("data")).unwrap();
    std::fs::write(folder.path().join("data/the duck.bin"), blob()).unwrap();
    std::fs::write(&path, with("\"byteLength\": 92", "\"byteLength\": 92, \"uri\": \"data/the%20duck.bin\""))
        .unwrap();
    assert_is_triangle(&Mesh::load(&path).unwrap());
    std::fs::write(&path, glb(JSON, &blob())).unwrap();
    assert_is_triangle(&Mesh::load(&path).unwrap());
}

#[test]
fn nodes_are_placed_one_in_another() {
    let nodes = r#""nodes": [
        {"children": [1], "translation": [10, 0, 0], "rotation": [0, 0.70710678, 0, 0.70710678]},
        {"mesh": 0, "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,5,1]}
    ]"#;
    let mesh = read(&with(r#""nodes": [{"mesh": 0}]"#, nodes));
    // Twice as large, 5 m south; a quarter turn to the left takes south to east; then 10 m east.
    for (found, expected) in
        mesh.positions.iter().zip([[15.0, 2.0, 0.0], [17.0, 2.0, 0.0], [15.0, 2.0, -2.0]])
    {
        assert!(Vec3::from(*found).distance(expected.into()) < 1e-5, "{found:?} for {expected:?}");
    }
    assert!(mesh.normals.iter().all(|normal| Vec3::from(*normal).distance(Vec3::Y) < 1e-6));
}

#[test]
fn a_mirror_keeps_the_outside_out() {
    for (scale, up) in [("[-1, 1, 1]", Vec3::Y), ("[1, -1, 1]", Vec3::NEG_Y), ("[-2, -3, -4]", Vec3::NEG_Y)] {
        for normals in ["\"NORMAL\": 3, ", ""] {
            let json = with(r#"{"mesh": 0}"#, &format!(r#"{{"mesh": 0, "scale": {scale}}}"#));
            let mesh = read(&json.replace("\"NORMAL\": 3, ", normals));
            assert!(face(&mesh).distance(up) < 1e-6, "{scale}");
            assert!(mesh.normals.iter().all(|normal| Vec3::from(*normal).distance(up) < 1e-6), "{scale}");
        }
    }
}

#[test]
fn normals_that_lack_are_those_of_the_triangles() {
    let mesh = read(&with("\"NORMAL\": 3, ", ""));
    assert_eq!(mesh.normals, [[0.0, 1.0, 0.0]; 3]);
    // Normals that point nowhere are as good as none: here they are zeros.
    let mut broken = blob();
    broken[56..92].fill(0);
    assert_is_triangle(&Mesh::from_gltf_bytes(&glb(JSON, &broken), "duck").unwrap());
}

#[test]
fn base_colours_are_encoded_for_display() {
    let material =
        r#""materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.0, 1.0]}}], "nodes""#;
    let json = with("\"nodes\": [{", &format!("{material}: [{{"))
        .replace("\"indices\": 1", "\"indices\": 1, \"material\": 0");
    // sRGB of 0.5 is 0.735357.
    for (found, expected) in
        read(&json).colors.iter().zip([[0.735357, 0.0, 0.0], [0.0, 0.735357, 0.0], [0.0; 3]])
    {
        assert!(Vec3::from(*found).distance(expected.into()) < 1e-5, "{found:?} for {expected:?}");
    }
    let plain = read(&json.replace(", \"COLOR_0\": 2", ""));
    assert!(
        plain
            .colors
            .iter()
            .all(|color| Vec3::from(*color).distance(Vec3::new(0.735357, 0.735357, 0.0)) < 1e-5)
    );
    assert_eq!(read(&with(", \"COLOR_0\": 2", "")).colors, [[1.0; 3]; 3]);
}

#[test]
fn strips_and_fans_are_triangles() {
    for mode in [5, 6] {
        let mesh = read(&with("\"indices\": 1", &format!("\"indices\": 1, \"mode\": {mode}")));
        assert_eq!(mesh.indices.len(), 3);
        assert!(face(&mesh).distance(Vec3::Y) < 1e-6, "mode {mode}");
    }
}

#[test]
fn sparse_accessors_replace_elements() {
    // Element 0 (the first index) becomes the second normal: (0, 1, 0).
    let sparse = r#""count": 3, "type": "VEC3", "sparse": {"count": 1,
        "indices": {"bufferView": 1, "byteOffset": 2, "componentType": 5123},
        "values": {"bufferView": 3, "byteOffset": 12}}"#;
    let mesh = read(&with(r#""count": 3, "type": "VEC3""#, sparse));
    assert_eq!(mesh.positions[1], [0.0, 1.0, 0.0]);
    assert_eq!(mesh.positions[2], [1.0, 1.0, 0.0]);

    // Without a view the others are zero.
    let mesh = read(&with(
        r#"{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3""#,
        &format!(r#"{{"componentType": 5126, {sparse}"#),
    ));
    assert_eq!(mesh.positions, [[0.0; 3], [0.0, 1.0, 0.0], [0.0; 3]]);
}

#[test]
fn quantized_vertices_are_read() {
    let json = with(
        r#""componentType": 5126, "count": 3, "type": "VEC3""#,
        r#""componentType": 5120, "count": 3, "type": "VEC3""#,
    );
    let json = json.replace(r#""asset""#, r#""extensionsRequired": ["KHR_mesh_quantization"], "asset""#);
    let json = json.replace(
        r#""byteOffset": 0, "byteLength": 36"#,
        r#""byteOffset": 44, "byteLength": 12, "byteStride": 4"#,
    );
    assert_eq!(read(&json).positions, [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]);
}

#[test]
fn a_file_that_names_no_scene_shows_its_first_or_all() {
    assert_is_triangle(&read(&with("\"scene\": 0, ", "")));
    let json = with("\"scene\": 0, \"scenes\": [{\"nodes\": [0]}],", "");
    assert_is_triangle(&read(&json));
    // A node that is another's child is shown once.
    let json = json.replace("[{\"mesh\": 0}]", "[{\"mesh\": 0}, {\"children\": [0]}]");
    assert_eq!(read(&json).indices.len(), 3);
}

#[test]
fn what_cannot_be_read_is_said_in_a_sentence() {
    for (from, to, expected) in [
        ("\"2.0\"", "\"1.0\"", "glTF version \"1.0\"; accepted: 2.0"),
        (
            "\"asset\": {\"version\": \"2.0\"},",
            "",
            "damaged or not supported glTF: missing field `asset` at line 19 column 1",
        ),
        ("\"scene\": 0", "\"scene\": 5", "scene 5: there is no such scene"),
        ("\"nodes\": [0]", "\"nodes\": [9]", "node 9: there is no such node"),
        ("\"nodes\": [0]", "\"nodes\": []", "no triangles of any size in its scene"),
        ("{\"mesh\": 0}", "{\"mesh\": 0, \"scale\": [0, 0, 0]}", "no triangles of any size in its scene"),
        ("{\"mesh\": 0}", "{\"mesh\": 7}", "mesh 7: there is no such mesh"),
        (
            "{\"mesh\": 0}",
            "{\"mesh\": 0, \"children\": [0]}",
            "node 0: reached twice; accepted: nodes that form trees",
        ),
        ("\"nodes\": [0]", "\"nodes\": [0, 0]", "node 0: reached twice; accepted: nodes that form trees"),
        ("\"POSITION\": 0, ", "", "mesh 0: a primitive without positions"),
        ("\"POSITION\": 0", "\"POSITION\": 8", "accessor 8: there is no such accessor"),
        ("\"POSITION\": 0", "\"POSITION\": 1", "accessor 1: of type Scalar; accepted: [Vec3]"),
        ("\"indices\": 1", "\"indices\": 2", "accessor 2: of type Vec4; accepted: [Scalar]"),
        (
            "\"componentType\": 5123",
            "\"componentType\": 5122",
            "accessor 1: indices that are no unsigned integers",
        ),
        ("\"componentType\": 5126", "\"componentType\": 1", "accessor 0: of an unknown componentType"),
        ("\"type\": \"SCALAR\"", "\"type\": \"ROW\"", "accessor 1: of an unknown type"),
        (
            "\"indices\": 1",
            "\"indices\": 1, \"mode\": 1",
            "mesh 0: points or lines; accepted: triangles, triangle strips and fans",
        ),
        ("\"indices\": 1", "\"indices\": 1, \"mode\": 77", "mesh 0: a primitive of an unknown mode"),
        ("\"indices\": 1", "\"indices\": 1, \"material\": 3", "material 3: there is no such material"),
        ("\"count\": 3", "\"count\": 4", "mesh 0: 4 positions, but 3 in accessor 3"),
        (
            "\"count\": 3, \"type\": \"SCALAR\"",
            "\"count\": 4, \"type\": \"SCALAR\"",
            "accessor 1: goes beyond the 6 bytes of bufferView 1",
        ),
        (
            "\"count\": 3, \"type\": \"SCALAR\"",
            "\"count\": 0, \"type\": \"SCALAR\"",
            "accessor 1: has no elements",
        ),
        (
            "\"count\": 3",
            "\"count\": 18446744073709551615",
            "18446744073709551615 vertices; accepted: up to 6000000",
        ),
        (
            "\"count\": 3, \"type\": \"SCALAR\"",
            "\"count\": 90000000, \"type\": \"SCALAR\"",
            "30000000 triangles; accepted: up to 2000000",
        ),
        (
            "\"bufferView\": 0,",
            "\"bufferView\": 0, \"byteOffset\": 18446744073709551615,",
            "accessor 0: goes beyond the 36 bytes of bufferView 0",
        ),
        ("\"bufferView\": 0", "\"bufferView\": 4", "accessor 0: there is no bufferView 4"),
        ("\"buffer\": 0", "\"buffer\": 1", "accessor 0: there is no buffer 1, which bufferView 0 shows"),
        (
            "\"byteOffset\": 56",
            "\"byteOffset\": 57",
            "accessor 3: bufferView 3 goes beyond the 92 bytes of buffer 0",
        ),
        (
            "\"byteLength\": 36",
            "\"byteLength\": 36, \"byteStride\": 8",
            "accessor 0: elements of 12 bytes, but the byteStride of bufferView 0 is 8",
        ),
        ("\"byteLength\": 92", "\"byteLength\": 96", "buffer 0: 92 bytes long, but its byteLength is 96"),
        (
            "{\"byteLength\": 92}",
            "{\"byteLength\": 92}, {\"byteLength\": 1}",
            "buffer 1: has no bytes; accepted: a uri, or the chunk of a .glb file",
        ),
        (
            "\"asset\"",
            "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"asset\"",
            "needs the extension KHR_draco_mesh_compression; accepted: files without compression or other extensions to geometry",
        ),
        (
            "{\"mesh\": 0}",
            "{\"mesh\": 0, \"scale\": [1e9, 1, 1]}",
            "mesh 0: a vertex that is infinite, not a number or far away; accepted: up to 10000000 m from the origin",
        ),
        (
            "{\"mesh\": 0}",
            "{\"mesh\": 0, \"rotation\": [1e39, 1, 1, 1]}",
            "mesh 0: a vertex that is infinite, not a number or far away; accepted: up to 10000000 m from the origin",
        ),
    ] {
        assert_eq!(problem(&with(from, to)), expected, "{from} -> {to}");
    }
}

#[test]
fn odd_numbers_in_the_blob_are_refused() {
    let problem = |offset: usize, bytes: [u8; 4]| {
        let mut blob = blob();
        blob[offset..offset + 4].copy_from_slice(&bytes);
        Mesh::from_gltf_bytes(&glb(JSON, &blob), "duck").unwrap_err().to_string()
    };
    for value in [f32::NAN, f32::NEG_INFINITY, 1.1e7] {
        assert!(
            problem(16, value.to_le_bytes()).contains("a vertex that is infinite, not a number or far away")
        );
    }
    assert_eq!(problem(36, [0, 0, 3, 0]), "duck: mesh 0: index 3 among 3 vertices");
}

#[test]
fn sparse_accessors_are_checked_as_well() {
    let sparse = |count: u32, offset: u32, place: u32| {
        let sparse = format!(
            r#""count": 3, "type": "VEC3", "sparse": {{"count": {count},
            "indices": {{"bufferView": 2, "byteOffset": {place}, "componentType": 5121}},
            "values": {{"bufferView": 3, "byteOffset": {offset}}}}}"#
        );
        problem(&with(r#""count": 3, "type": "VEC3""#, &sparse))
    };
    assert_eq!(sparse(4, 0, 0), "accessor 0: replaces 4 of its 3 elements");
    assert_eq!(sparse(2, 24, 1), "accessor 0: goes beyond the 36 bytes of bufferView 3");
    assert_eq!(sparse(2, 0, 11), "accessor 0: goes beyond the 12 bytes of bufferView 2");
    assert_eq!(sparse(1, 0, 0), "accessor 0: replaces element 255 of 3");
}

#[test]
fn too_much_is_refused_before_it_takes_memory() {
    let nodes = vec!["{}"; 10_001].join(",");
    let json = with("{\"mesh\": 0}", &format!("{{\"mesh\": 0}},{nodes}"));
    assert_eq!(problem(&json), "10002 nodes; accepted: up to 10000");
    let objects = vec!["{}"; 400_001].join(",");
    assert_eq!(problem(&format!("{{\"nodes\":[{objects}]}}")), "400002 JSON objects; accepted: up to 400000");
    let values = "[],".repeat(2_000_000);
    assert_eq!(problem(&format!("{{\"x\":[{values}0]}}")), "4000002 JSON values; accepted: up to 4000000");
    // A large mesh many times over.
    let zeros = with(
        "\"bufferView\": 0, \"componentType\": 5126, \"count\": 3",
        "\"componentType\": 5126, \"count\": 100000",
    );
    let zeros = zeros.replace("\"NORMAL\": 3, \"COLOR_0\": 2", "\"TANGENT\": 0");
    let nodes: Vec<String> = (0..100).map(|_| "{\"mesh\": 0}".to_owned()).collect();
    let roots: Vec<String> = (0..100).map(|node: u32| node.to_string()).collect();
    let zeros = zeros.replace("[{\"mesh\": 0}]", &format!("[{}]", nodes.join(",")));
    let zeros =
        zeros.replace("\"indices\": 1", "\"extras\": 1").replace("[0]", &format!("[{}]", roots.join(",")));
    assert_eq!(problem(&zeros), "6099940 vertices; accepted: up to 6000000");
}

#[test]
fn files_and_buffers_that_are_none_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("duck.gltf");
    let load = |path: &Path| {
        let message = Mesh::load(path).unwrap_err().to_string();
        message.strip_prefix(&format!("{}: ", path.display())).unwrap().to_owned()
    };
    assert!(load(&path).starts_with("cannot be read: "));
    assert_eq!(load(folder.path()), "this is a folder; accepted: a glTF 2.0 file, .gltf or .glb");
    std::fs::write(&path, "").unwrap();
    assert_eq!(load(&path), "empty; accepted: a glTF 2.0 file, .gltf or .glb");
    for other in [&b"solid cube"[..], b"\xff\xfe{\0", b"   "] {
        std::fs::write(&path, other).unwrap();
        assert_eq!(load(&path), "neither a .gltf nor a .glb file, by its first bytes");
    }
    std::fs::write(&path, b"{\"asset\": \"\xff\"}").unwrap();
    assert!(load(&path).starts_with("damaged or not supported glTF: "));

    std::fs::create_dir(folder.path().join("sub")).unwrap();
    std::fs::write(folder.path().join("short.bin"), [0; 10]).unwrap();
    let accepted =
        "no file in the mesh's own folder; accepted: a relative path without \"..\" and without a scheme";
    for (uri, expected) in [
        ("../duck.bin", format!("buffer 0: \"../duck.bin\": {accepted}")),
        ("/etc/passwd", format!("buffer 0: \"/etc/passwd\": {accepted}")),
        ("https://a.org/b.bin", format!("buffer 0: \"https://a.org/b.bin\": {accepted}")),
        ("sub", "buffer 0: \"sub\": is a folder; accepted: a file".to_owned()),
        ("short.bin", "buffer 0: 10 bytes long, but its byteLength is 92".to_owned()),
        (
            "data:,x",
            "buffer 0: a data URI that is not base64; accepted: data:application/octet-stream;base64,…"
                .to_owned(),
        ),
        ("data:x", "buffer 0: a data URI without a comma".to_owned()),
    ] {
        std::fs::write(&path, with("\"byteLength\": 92", &format!("\"byteLength\": 92, \"uri\": \"{uri}\"")))
            .unwrap();
        assert_eq!(load(&path), expected);
    }
    std::fs::write(&path, with("\"byteLength\": 92", "\"byteLength\": 92, \"uri\": \"none.bin\"")).unwrap();
    assert!(load(&path).starts_with("buffer 0: \"none.bin\": cannot be read: "));
    std::fs::write(&path, with("\"byteLength\": 92", "\"byteLength\": 92, \"uri\": \"data:;base64,A*\""))
        .unwrap();
    assert!(load(&path).starts_with("buffer 0: damaged base64: "));

    let json = with("\"byteLength\": 92", "\"byteLength\": 92, \"uri\": \"duck.bin\"");
    let beside = Mesh::from_gltf_bytes(json.as_bytes(), "duck").unwrap_err().to_string();
    assert_eq!(
        beside,
        "duck: buffer 0: \"duck.bin\": a file beside this one, which is not read from a folder"
    );
}

#[cfg(unix)]
#[test]
fn what_is_no_file_is_refused_before_it_is_opened() {
    let message = Mesh::load(Path::new("/dev/zero")).unwrap_err().to_string();
    assert_eq!(message, "/dev/zero: no ordinary file; accepted: a glTF 2.0 file, .gltf or .glb");

    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe.glb");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    assert!(
        Mesh::load(&pipe)
            .unwrap_err()
            .to_string()
            .ends_with("no ordinary file; accepted: a glTF 2.0 file, .gltf or .glb")
    );
    let path = folder.path().join("duck.gltf");
    std::fs::write(&path, with("\"byteLength\": 92", "\"byteLength\": 92, \"uri\": \"pipe.glb\"")).unwrap();
    let message = Mesh::load(&path).unwrap_err().to_string();
    assert!(message.ends_with("buffer 0: \"pipe.glb\": no ordinary file; accepted: a file"), "{message}");
}

#[test]
fn a_glb_that_ends_early_is_an_error() {
    let whole = glb(JSON, &blob());
    for length in 0..whole.len() {
        let mut cut = whole[..length].to_vec();
        assert!(Mesh::from_gltf_bytes(&cut, "cut").is_err(), "{length} bytes");
        // Even if its header says that this is all.
        if length >= 12 {
            cut[8..12].copy_from_slice(&(length as u32).to_le_bytes());
            assert!(Mesh::from_gltf_bytes(&cut, "cut").is_err(), "{length} bytes");
        }
    }
    let mut odd = whole.clone();
    odd[8..12].copy_from_slice(&3_u32.to_le_bytes());
    assert!(Mesh::from_gltf_bytes(&odd, "odd").is_err());
    odd[4] = 1;
    assert_eq!(
        Mesh::from_gltf_bytes(&odd, "old").unwrap_err().to_string(),
        "old: glTF version 1; accepted: 2.0"
    );
}

/// A mesh that keeps its promises, or an error of one line.
fn assert_is_harmless(bytes: &[u8]) {
    match Mesh::from_gltf_bytes(bytes, "duck") {
        Ok(mesh) => mesh.validate().unwrap(),
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}

proptest! {
    #[test]
    fn no_byte_brings_a_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        in_json in any::<bool>(),
    ) {
        let mut bytes = if in_json { embedded(JSON, &blob()).into_bytes() } else { glb(JSON, &blob()) };
        for (place, byte) in changes {
            *place.get_mut(&mut bytes) = byte;
        }
        assert_is_harmless(&bytes);
    }

    #[test]
    fn no_number_brings_a_panic(
        place in any::<prop::sample::Index>(),
        number in prop_oneof![
            (0..20_i64).prop_map(|n| n.to_string()),
            any::<i64>().prop_map(|n| n.to_string()),
            any::<u64>().prop_map(|n| n.to_string()),
            any::<f64>().prop_map(|n| format!("{n:e}")),
            Just("5121".to_owned()), Just("5125".to_owned()), Just("null".to_owned()), Just("[]".to_owned()),
        ],
    ) {
        // One of the numbers in the JSON is another.
        let is_start = |at: usize| {
            let bytes = JSON.as_bytes();
            bytes[at].is_ascii_digit() && bytes[at - 1] == b' '
        };
        let starts: Vec<usize> = (1..JSON.len()).filter(|at| is_start(*at)).collect();
        let start = *place.get(&starts);
        let length = JSON[start..].bytes().take_while(u8::is_ascii_digit).count();
        assert_is_harmless(&glb(&format!("{}{number}{}", &JSON[..start], &JSON[start + length..]), &blob()));
    }

    #[test]
    fn no_bytes_at_all_bring_a_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        assert_is_harmless(&bytes);
        assert_is_harmless(&[b"glTF\x02\0\0\0", &bytes[..]].concat());
        assert_is_harmless(&[b"{", &bytes[..]].concat());
        assert_is_harmless(&glb(JSON, &bytes));
    }
}

//! Meshes of the user's own, from the scene file to the model, and what is said where they cannot be used.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

use std::path::Path;
use whitecap_scene::Scene;

/// One triangle, 1 m along its sides, in a data URI: three positions, no normals.
const TRIANGLE: &str = r#"{
    "asset": { "version": "2.0" },
    "scene": 0,
    "scenes": [{ "nodes": [0] }],
    "nodes": [{ "mesh": 0 }],
    "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
    "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "min": [0, 0, 0], "max": [1, 0, 1] }],
    "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
    "buffers": [{ "byteLength": 36,
        "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAAAAAAAAAIA/AACAPwAAAAAAAAAA" }]
}"#;

fn scene_with(folder: &Path, file: &str) -> Result<Scene, String> {
    let base = whitecap_scene::named::find("meshuggah").unwrap().toml;
    let path = folder.join("harbour.toml");
    std::fs::write(&path, format!("{base}\n[[object]]\nfile = {file:?}\n")).unwrap();
    Scene::load(&path).map_err(|error| error.to_string())
}

#[test]
fn a_mesh_beside_the_scene_file_is_found_and_read() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("boats")).unwrap();
    std::fs::write(folder.path().join("boats/dinghy.gltf"), TRIANGLE).unwrap();
    let scene = scene_with(folder.path(), "boats/dinghy.gltf").unwrap();
    let models = scene.read_objects().unwrap();
    assert_eq!(models[0].mesh.indices.len(), 3);
    // x east, z south: the triangle's front looks up.
    assert_eq!(models[0].mesh.normals[0], [0.0, 1.0, 0.0]);
    assert_eq!(Scene::from_toml(&scene.to_toml().unwrap(), "again").unwrap().objects, scene.objects);
}

#[test]
fn what_is_no_mesh_is_one_sentence_with_line_key_and_file() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("empty.glb", b"");
    write("words.gltf", b"this is no JSON");
    write("cut.glb", b"glTF\x02\0\0\0\x40\0\0\0");
    write("lost.gltf", TRIANGLE.replace("data:application/octet-stream;base64,", "gone.bin#").as_bytes());
    write("short.gltf", TRIANGLE.replace("\"count\": 3", "\"count\": 3000000").as_bytes());
    write("ring.gltf", TRIANGLE.replace("{ \"mesh\": 0 }", "{ \"mesh\": 0, \"children\": [0] }").as_bytes());
    write(
        "nan.gltf",
        TRIANGLE.replace("AAAAAAAAAAAAAAAAAAAAAAAAAAAAAIA/", "AADAfwAAAAAAAAAAAAAAAAAAAAAAAIA/").as_bytes(),
    );
    std::fs::create_dir(folder.path().join("folder.glb")).unwrap();
    let names = [
        "missing.glb",
        "folder.glb",
        "empty.glb",
        "words.gltf",
        "cut.glb",
        "lost.gltf",
        "short.gltf",
        "ring.gltf",
        "nan.gltf",
    ];
    for name in names {
        let message = scene_with(folder.path(), name).unwrap_err();
        assert!(message.contains("harbour.toml:"), "{message}");
        assert!(message.contains("object[0].file") && message.contains(name), "{message}");
        assert!(!message.contains('\n'), "{message}");
        println!("{message}");
    }
}

//! Any bytes read as a glTF file: a sound mesh or an error, never a panic or more memory than is allowed.

#![no_main]

use libfuzzer_sys::fuzz_target;
use whitecap_scene::mesh::Mesh;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(mesh) = Mesh::from_gltf_bytes(bytes, "fuzz") {
        assert_eq!(mesh.validate(), Ok(()));
        assert!(mesh.indices.len() / 3 <= Mesh::MAX_TRIANGLES);
        assert!(mesh.positions.len() <= Mesh::MAX_VERTICES);
    }
});

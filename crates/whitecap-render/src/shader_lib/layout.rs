//! Holds GPU-layout structs against what naga says of their WGSL twins.

use naga::TypeInner;

/// Name and offset of each member of a struct in a linked shader, and the struct's size.
pub(crate) fn reflected(wgsl: &str, name: &str) -> (Vec<(String, u32)>, u32) {
    let module = naga::front::wgsl::parse_str(wgsl).expect("the shader parses");
    for (_, ty) in module.types.iter() {
        // The linker appends to names that it has to tell apart.
        let is_it = ty.name.as_deref().is_some_and(|n| n == name || n.ends_with(&format!("_{name}")));
        if let (true, TypeInner::Struct { members, span }) = (is_it, &ty.inner) {
            let members = members.iter().map(|m| (m.name.clone().expect("named"), m.offset)).collect();
            return (members, *span);
        }
    }
    panic!("no struct {name} in the shader");
}

/// Asserts that a Rust struct has the WGSL struct's members at its offsets, and reaches to its end.
macro_rules! assert_layout {
    ($rust:ty, $wgsl:expr, $name:literal, [$($field:ident),* $(,)?]) => {{
        let (members, size) = $crate::shader_lib::layout::reflected($wgsl, $name);
        let expected = vec![$((stringify!($field).to_owned(), std::mem::offset_of!($rust, $field) as u32)),*];
        assert_eq!(members, expected);
        assert_eq!(size_of::<$rust>() as u32, size, "size of {}", $name);
    }};
}
pub(crate) use assert_layout;

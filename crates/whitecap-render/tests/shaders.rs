//! Every shader stands on its own, without a GPU, and agrees with the Rust side about layout.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use whitecap_render::shader_lib::ALL;

fn parse(wgsl: &str) -> naga::Module {
    naga::front::wgsl::parse_str(wgsl).unwrap_or_else(|e| panic!("{}", e.emit_to_string(wgsl)))
}

#[test]
fn every_shader_is_valid_without_extensions() {
    assert!(!ALL.is_empty());
    for shader in ALL {
        let module = parse(shader.wgsl);
        // Sample interpolation is plain WebGPU; naga counts it as a capability.
        Validator::new(ValidationFlags::all(), Capabilities::MULTISAMPLED_SHADING)
            .validate(&module)
            .unwrap_or_else(|e| panic!("{}: {}", shader.name, e.emit_to_string(shader.wgsl)));
        assert!(!module.entry_points.is_empty(), "{} has no entry point", shader.name);
    }
}

#[test]
fn entry_points_are_named_by_stage() {
    for shader in ALL {
        for entry in &parse(shader.wgsl).entry_points {
            let name = entry.name.as_str();
            let fits = match entry.stage {
                naga::ShaderStage::Vertex => name == "vs_main",
                naga::ShaderStage::Fragment => name == "fs_main",
                naga::ShaderStage::Compute => name.starts_with("cs_"),
                _ => false,
            };
            assert!(fits, "{}: {name}", shader.name);
        }
    }
}

/// WebGPU's default limits hold 16 sampled textures and 16 samplers in a stage.
#[test]
fn shaders_stay_within_the_default_limits() {
    for shader in ALL {
        let module = parse(shader.wgsl);
        let textures = module
            .global_variables
            .iter()
            .filter(|(_, v)| matches!(module.types[v.ty].inner, naga::TypeInner::Image { .. }))
            .count();
        assert!(textures <= 16, "{} binds {textures} textures", shader.name);
        let groups = module.global_variables.iter().filter_map(|(_, v)| v.binding.as_ref()).map(|b| b.group);
        assert!(groups.max().unwrap_or(0) < 4, "{} uses more than four bind groups", shader.name);
    }
}

/// Some browsers reject pointers to workgroup memory as arguments, and the classics need no extension.
#[test]
fn shaders_keep_to_the_portable_subset() {
    for shader in ALL {
        for word in ["enable ", "requires ", "ptr<workgroup", "subgroup"] {
            assert!(!shader.wgsl.contains(word), "{} contains {word:?}", shader.name);
        }
    }
}

//! Links every WESL root into plain WGSL under `OUT_DIR`, one file per root.

/// Module path of each root, the name it is included by (`shader_lib::ALL` lists the same names) and
/// the features that it is linked with.
const ROOTS: &[(&str, &str, &[&str])] = &[
    ("package::pass::sky", "sky", &[]),
    ("package::pass::linear_sky", "linear_sky", &[]),
    ("package::pass::atmosphere::sky_view", "atmosphere_sky_view", &[]),
    ("package::pass::atmosphere::aerial", "atmosphere_aerial", &[]),
    ("package::pass::atmosphere::twins", "atmosphere_twins", &[]),
    ("package::pass::mean", "mean", &[]),
    ("package::pass::develop", "develop", &[]),
    ("package::pass::develop", "linear_develop", &["linear"]),
    ("package::pass::objects", "objects", &[]),
    ("package::pass::objects", "linear_objects", &["linear"]),
    ("package::pass::objects", "objects_aux", &["aux"]),
    ("package::technique::rippling_lake::rippling_lake", "rippling_lake", &[]),
    ("package::technique::rippling_lake::twins", "rippling_lake_twins", &[]),
    ("package::technique::meshuggah::meshuggah", "meshuggah", &[]),
    ("package::technique::meshuggah::meshuggah", "meshuggah_per_sample", &["per_sample"]),
    ("package::technique::meshuggah::vertices", "meshuggah_vertices", &[]),
    ("package::technique::ocean_water::ocean_water", "ocean_water", &[]),
    ("package::technique::ocean_water::ocean_water", "ocean_water_per_sample", &["per_sample"]),
    ("package::technique::ocean_water::sky_map", "ocean_water_sky", &[]),
    ("package::technique::ocean_water::vertices", "ocean_water_vertices", &[]),
    ("package::technique::ocean_water::twins", "ocean_water_twins", &[]),
    ("package::technique::projected_grid::projected_grid", "projected_grid", &[]),
    ("package::technique::projected_grid::height_map", "projected_grid_heights", &[]),
    ("package::technique::projected_grid::normal_map", "projected_grid_normals", &[]),
    ("package::technique::projected_grid::mip", "projected_grid_mip", &[]),
    ("package::technique::projected_grid::twins", "projected_grid_twins", &[]),
    ("package::technique::five_sample::final", "five_sample", &[]),
    ("package::technique::five_sample::later", "five_sample_later", &[]),
    ("package::technique::five_sample::stages", "five_sample_stages", &[]),
    ("package::technique::five_sample::dome", "five_sample_dome", &[]),
    ("package::technique::five_sample::twins", "five_sample_twins", &[]),
    ("package::surface::compute::evolve", "spectral_evolve", &[]),
    ("package::surface::compute::columns", "spectral_columns", &[]),
    ("package::surface::compute::rows", "spectral_rows", &[]),
    ("package::surface::compute::mesh_maps", "spectral_mesh_maps", &[]),
    ("package::surface::compute::normal_map", "spectral_normal_map", &[]),
    ("package::surface::compute::mips", "spectral_mips", &[]),
    ("package::surface::compute::lost_variance", "spectral_lost_variance", &[]),
    ("package::surface::compute::twins", "spectral_twins", &[]),
    ("package::technique::spectral_ocean::spectral_ocean", "spectral_ocean", &[]),
    ("package::technique::spectral_ocean::spectral_ocean", "spectral_ocean_per_sample", &["per_sample"]),
    ("package::technique::spectral_ocean::spectral_ocean", "spectral_ocean_aux", &["aux", "per_sample"]),
    ("package::technique::spectral_ocean::vertices", "spectral_ocean_vertices", &[]),
    ("package::shader_lib::twins", "twins", &[]),
    ("package::shader_lib::tone_map_twins", "tone_map_twins", &[]),
    ("package::shader_lib::optics_twins", "optics_twins", &[]),
    ("package::shader_lib::sines_twins", "sines_twins", &[]),
    ("package::shader_lib::foam_twins", "foam_twins", &[]),
    ("package::shader_lib::patchwork_twins", "patchwork_twins", &[]),
];

fn main() {
    println!("cargo::rerun-if-changed=src");
    for (root, name, features) in ROOTS {
        let mut linker = wesl::Wesl::new("src");
        for feature in ["per_sample", "linear", "aux"] {
            linker.set_feature(feature, false);
        }
        for feature in *features {
            linker.set_feature(feature, true);
        }
        let path = root.parse().unwrap_or_else(|e| panic!("{root} is no module path: {e}"));
        linker.build_artifact(&path, name);
    }
}

//! What stands or floats in the water.

use crate::gpu::resources::{IndexedMesh, PipelineRequest, bind_group};
use crate::shader_lib::{self, Shader};
use crate::uniforms::{MAX_VIEWS, Role, Shared, ViewSlots};
use crate::{RenderError, TargetFormat, View};
use glam::{DAffine3, Mat4};
use whitecap_scene::mesh::Ground;
use whitecap_scene::object::{self, Model};
use whitecap_scene::{Scene, SceneSurface};
use whitecap_waves::model::Surface;

/// Layout twin of `GpuObject` in `objects.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct GpuObject {
    eye_world_from_mesh: [[f32; 4]; 4],
}

/// A vertex as `objects.wesl` reads it.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct GpuVertex {
    position: [f32; 3],
    normal: [f32; 3],
    color: [f32; 3],
}

/// The scene's objects on the device. [`ObjectPass`] draws them into a target; their places are the same for
/// every role of a view.
pub(crate) struct Objects {
    drawn: Vec<Drawn>,
    /// A slot for each object of each view.
    slots: ViewSlots<GpuObject>,
    layout: wgpu::BindGroupLayout,
    group: wgpu::BindGroup,
    /// What carries those that float; `None` where nothing does.
    surface: Option<SceneSurface>,
}

struct Drawn {
    model: Model,
    mesh: IndexedMesh,
}

impl Objects {
    pub(crate) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        scene: &Scene,
    ) -> Result<Self, RenderError> {
        let models = scene.read_objects()?;
        let floats = models.iter().any(|model| model.object.floats);
        let surface = if floats { Some(scene.surface()?) } else { None };
        Ok(Objects::of_models(device, queue, models, surface))
    }

    /// These models, those that float on `surface`.
    pub(crate) fn of_models(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        models: Vec<Model>,
        surface: Option<SceneSurface>,
    ) -> Self {
        let drawn: Vec<Drawn> = models.into_iter().map(|model| Drawn::new(device, queue, model)).collect();
        let slots = ViewSlots::with_slots(device, "objects", MAX_VIEWS * drawn.len());
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("object"),
            entries: &[ViewSlots::<GpuObject>::layout_entry(0, wgpu::ShaderStages::VERTEX)],
        });
        let group = bind_group(device, "objects", &layout, [slots.binding()]);
        Objects { drawn, slots, layout, group, surface }
    }

    /// The ground that those which stand still make.
    pub(crate) fn ground(&self) -> Option<Ground> {
        object::ground(&self.drawn.iter().map(|drawn| drawn.model.clone()).collect::<Vec<_>>())
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.drawn.is_empty()
    }

    /// Puts every object where it is at `time_s`, as each view sees it.
    pub(crate) fn prepare(&self, queue: &wgpu::Queue, views: &[View], time_s: f64) {
        let calm = whitecap_waves::model::Calm;
        let surface: &dyn Surface = self.surface.as_ref().map_or(&calm, |surface| surface);
        for (i, drawn) in self.drawn.iter().enumerate() {
            let world_from_mesh = drawn.model.object.world_from_mesh(surface, time_s);
            for (v, view) in views.iter().enumerate() {
                let placed = DAffine3::from_translation(-view.eye_m) * world_from_mesh;
                let eye_world_from_mesh = Mat4::from(placed.as_affine3()).to_cols_array_2d();
                self.slots.write(queue, v * self.drawn.len() + i, &GpuObject { eye_world_from_mesh });
            }
        }
    }
}

impl Drawn {
    fn new(device: &wgpu::Device, queue: &wgpu::Queue, model: Model) -> Drawn {
        let mesh = &model.mesh;
        let corners = mesh.positions.iter().zip(&mesh.normals).zip(&mesh.colors);
        let vertices: Vec<GpuVertex> =
            corners.map(|((&position, &normal), &color)| GpuVertex { position, normal, color }).collect();
        let mesh = IndexedMesh::new(device, queue, "object", bytemuck::cast_slice(&vertices), &mesh.indices);
        Drawn { model, mesh }
    }
}

/// Draws the objects into one kind of target.
pub(crate) struct ObjectPass {
    pipeline: wgpu::RenderPipeline,
}

impl ObjectPass {
    pub(crate) fn new(
        device: &wgpu::Device,
        shared: &Shared,
        objects: &Objects,
        target: &TargetFormat,
    ) -> ObjectPass {
        let linear = shared.skies.is_some();
        let shader = if linear { &shader_lib::LINEAR_OBJECTS } else { &shader_lib::OBJECTS };
        Self::through(device, shared, objects, target, shader)
    }

    /// Their normals in place of their colours.
    pub(crate) fn aux(
        device: &wgpu::Device,
        shared: &Shared,
        objects: &Objects,
        target: &TargetFormat,
    ) -> ObjectPass {
        Self::through(device, shared, objects, target, &shader_lib::OBJECTS_AUX)
    }

    fn through(
        device: &wgpu::Device,
        shared: &Shared,
        objects: &Objects,
        target: &TargetFormat,
        shader: &Shader,
    ) -> ObjectPass {
        let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3];
        let request = PipelineRequest {
            label: "objects",
            shader,
            constants: &[],
            groups: &[Some(&shared.view_layout), Some(&shared.environment_layout), Some(&objects.layout)],
            vertices: &[Some(wgpu::VertexBufferLayout {
                array_stride: size_of::<GpuVertex>() as u64,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &attributes,
            })],
            color: target.color,
            depth: Some(target.depth_state(true)),
            multisample: target.multisample(),
        };
        ObjectPass { pipeline: request.create(device) }
    }

    pub(crate) fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        shared: &Shared,
        objects: &Objects,
        view: usize,
        role: Role,
    ) {
        if objects.is_empty() {
            return;
        }
        pass.set_pipeline(&self.pipeline);
        shared.bind(pass, view, role);
        for (i, drawn) in objects.drawn.iter().enumerate() {
            let offset = ViewSlots::<GpuObject>::offset(view * objects.drawn.len() + i);
            pass.set_bind_group(2, &objects.group, &[offset]);
            drawn.mesh.draw(pass);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shader_lib::layout::assert_layout;

    #[test]
    fn rust_and_wgsl_agree_about_layout() {
        assert_layout!(GpuObject, shader_lib::OBJECTS.wgsl, "GpuObject", [eye_world_from_mesh]);
    }
}

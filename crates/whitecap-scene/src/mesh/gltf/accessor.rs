//! The numbers that accessors give out (section 3.6.2).
//!
//! Every range is checked against its view and the view against its buffer before a byte is taken.

use std::borrow::Cow;

use gltf::json::accessor::{Accessor, ComponentType, Type};
use gltf::json::validation::{Checked, USize64};
use gltf::json::{Index, Root, buffer};

use crate::mesh::error::MeshProblem;

/// A file's JSON and the bytes of its buffers.
pub(super) struct Source<'a> {
    pub(super) root: &'a Root,
    pub(super) buffers: &'a [Cow<'a, [u8]>],
}

/// Elements of the same size, some bytes apart.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    count: usize,
}

impl<'a> Elements<'a> {
    fn iter(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        let size = self.size;
        // The last one may have fewer bytes than the stride.
        self.bytes.chunks(self.stride).take(self.count).map(move |element| &element[..size])
    }
}

/// What an accessor says about itself, checked.
#[derive(Clone, Copy)]
struct Form {
    component: ComponentType,
    /// Components in an element.
    width: usize,
    /// Elements.
    count: usize,
}

impl Form {
    fn element_bytes(self) -> usize {
        self.width * self.component.size()
    }
}

impl<'a> Source<'a> {
    /// How many elements the accessor has, before any is read.
    pub(super) fn count(&self, index: Index<Accessor>) -> Result<u64, MeshProblem> {
        Ok(self.accessor(index)?.count.0)
    }

    /// The elements of an accessor as rows of `W` numbers; components that it lacks are 1. `accepted` are the types
    /// that it may have.
    pub(super) fn rows<const W: usize>(
        &self,
        index: Index<Accessor>,
        accepted: &[Type],
    ) -> Result<Vec<[f32; W]>, MeshProblem> {
        let accessor = self.accessor(index)?;
        let problem = problem(index);
        let form = self.form(accessor, accepted).map_err(problem)?;
        let normalized = accessor.normalized;
        let row = |element: &[u8]| {
            let mut row = [1.0; W];
            for (value, bytes) in row.iter_mut().zip(element.chunks_exact(form.component.size())) {
                *value = number(bytes, form.component, normalized);
            }
            row
        };
        self.elements_of(accessor, form, row, [0.0; W]).map_err(problem)
    }

    /// The elements of an accessor of whole numbers.
    pub(super) fn indices(&self, index: Index<Accessor>) -> Result<Vec<u32>, MeshProblem> {
        let accessor = self.accessor(index)?;
        let problem = problem(index);
        let form = self.form(accessor, &[Type::Scalar]).map_err(problem)?;
        if !matches!(form.component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32) {
            return Err(problem("indices that are no unsigned integers".to_owned()));
        }
        self.elements_of(accessor, form, whole, 0).map_err(problem)
    }

    fn accessor(&self, index: Index<Accessor>) -> Result<&'a Accessor, MeshProblem> {
        let accessor = self.root.accessors.get(index.value());
        accessor.ok_or_else(|| problem(index)("there is no such accessor".to_owned()))
    }

    fn form(&self, accessor: &Accessor, accepted: &[Type]) -> Result<Form, String> {
        let Checked::Valid(component) = accessor.component_type else {
            return Err("of an unknown componentType".to_owned());
        };
        let Checked::Valid(kind) = accessor.type_ else {
            return Err("of an unknown type".to_owned());
        };
        if !accepted.contains(&kind) {
            return Err(format!("of type {kind:?}; accepted: {accepted:?}"));
        }
        let count = usize::try_from(accessor.count.0).map_err(|_| "has too many elements")?;
        if count == 0 {
            return Err("has no elements".to_owned());
        }
        Ok(Form { component: component.0, width: kind.multiplicity(), count })
    }

    /// All elements through `read`; `zero` is what they are where no view holds them.
    fn elements_of<T: Clone>(
        &self,
        accessor: &Accessor,
        form: Form,
        read: impl Fn(&[u8]) -> T,
        zero: T,
    ) -> Result<Vec<T>, String> {
        let mut values = match accessor.buffer_view {
            Some(view) => {
                let offset = accessor.byte_offset.unwrap_or_default();
                let elements = self.elements(view, offset, form.count, form.element_bytes())?;
                elements.iter().map(&read).collect()
            }
            None => vec![zero; form.count],
        };
        if let Some(sparse) = &accessor.sparse {
            let count = usize::try_from(sparse.count.0).unwrap_or(usize::MAX);
            if count > form.count {
                return Err(format!("replaces {count} of its {} elements", form.count));
            }
            let Checked::Valid(component) = sparse.indices.component_type else {
                return Err("sparse indices of an unknown componentType".to_owned());
            };
            let indices = &sparse.indices;
            let size = component.0.size();
            let places = self.elements(indices.buffer_view, indices.byte_offset, count, size)?;
            let (view, offset) = (sparse.values.buffer_view, sparse.values.byte_offset);
            let replacements = self.elements(view, offset, count, form.element_bytes())?;
            for (place, replacement) in places.iter().zip(replacements.iter()) {
                let place = whole(place);
                let value = values
                    .get_mut(place as usize)
                    .ok_or_else(|| format!("replaces element {place} of {}", form.count))?;
                *value = read(replacement);
            }
        }
        Ok(values)
    }

    /// `count` elements of `size` bytes from `offset` in a view.
    fn elements(
        &self,
        view: Index<buffer::View>,
        offset: USize64,
        count: usize,
        size: usize,
    ) -> Result<Elements<'a>, String> {
        let number = view.value();
        let view =
            self.root.buffer_views.get(number).ok_or_else(|| format!("there is no bufferView {number}"))?;
        let buffer = view.buffer.value();
        let bytes = self
            .buffers
            .get(buffer)
            .ok_or_else(|| format!("there is no buffer {buffer}, which bufferView {number} shows"))?;
        let bytes =
            slice(bytes, view.byte_offset.unwrap_or_default().0, view.byte_length.0).ok_or_else(|| {
                format!("bufferView {number} goes beyond the {} bytes of buffer {buffer}", bytes.len())
            })?;
        // 0 stands for elements without gaps.
        let stride = view.byte_stride.as_ref().map_or(0, |stride| stride.0);
        let stride = if stride == 0 { size } else { stride };
        if stride < size {
            return Err(format!(
                "elements of {size} bytes, but the byteStride of bufferView {number} is {stride}"
            ));
        }
        let length = match count.checked_sub(1) {
            Some(gaps) => gaps.checked_mul(stride).and_then(|length| length.checked_add(size)),
            None => Some(0),
        };
        let bytes = length
            .and_then(|length| slice(bytes, offset.0, length as u64))
            .ok_or_else(|| format!("goes beyond the {} bytes of bufferView {number}", bytes.len()))?;
        Ok(Elements { bytes, stride, size, count })
    }
}

fn problem(index: Index<Accessor>) -> impl Fn(String) -> MeshProblem + Copy {
    let index = index.value();
    move |explanation| MeshProblem::Faulty { part: "accessor", index, explanation }
}

fn slice(bytes: &[u8], offset: u64, length: u64) -> Option<&[u8]> {
    let start = usize::try_from(offset).ok()?;
    let end = start.checked_add(usize::try_from(length).ok()?)?;
    bytes.get(start..end)
}

/// A component's value; normalized integers become −1 to 1 (section 3.6.2.2, equations of section 3.11).
fn number(bytes: &[u8], component: ComponentType, normalized: bool) -> f32 {
    let (value, most) = match (component, bytes) {
        (ComponentType::I8, [a]) => (f32::from(*a as i8), f32::from(i8::MAX)),
        (ComponentType::U8, [a]) => (f32::from(*a), f32::from(u8::MAX)),
        (ComponentType::I16, [a, b]) => (f32::from(i16::from_le_bytes([*a, *b])), f32::from(i16::MAX)),
        (ComponentType::U16, [a, b]) => (f32::from(u16::from_le_bytes([*a, *b])), f32::from(u16::MAX)),
        (ComponentType::U32, [a, b, c, d]) => (u32::from_le_bytes([*a, *b, *c, *d]) as f32, u32::MAX as f32),
        (ComponentType::F32, [a, b, c, d]) => return f32::from_le_bytes([*a, *b, *c, *d]),
        // Components are cut to their size.
        _ => return f32::NAN,
    };
    if normalized { (value / most).max(-1.0) } else { value }
}

/// An unsigned integer of any size.
fn whole(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte))
}

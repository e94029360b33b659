//! The panel's letters on a page: the page's own fonts, since egui's are larger than all the rest.

use egui::{FontData, FontDefinitions, FontFamily};
use std::sync::Arc;

/// Letters of these fonts: what the first lacks is in those after it.
pub(crate) fn definitions(fonts: &[&'static [u8]]) -> FontDefinitions {
    let mut definitions = FontDefinitions::empty();
    let names: Vec<String> = (0..fonts.len()).map(|i| format!("font {i}")).collect();
    for (name, bytes) in names.iter().zip(fonts) {
        definitions.font_data.insert(name.clone(), Arc::new(FontData::from_static(bytes)));
    }
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        definitions.families.insert(family, names.clone());
    }
    definitions
}

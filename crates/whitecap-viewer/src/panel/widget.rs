//! One widget for each kind of value.

use crate::document::first_value;
use egui::{ComboBox, DragValue, Slider, Ui};
use toml::Value;
use whitecap_scene::reference::{Accepts, KeyDoc, WhenAbsent};

/// Shows a value and gives what it was changed to: `Some(None)` if it was left out.
pub(crate) fn edited(ui: &mut Ui, doc: &KeyDoc, value: Option<&Value>) -> Option<Option<Value>> {
    let Some(value) = value else {
        let mut given = None;
        ui.horizontal(|ui| {
            ui.weak(doc.when_absent.to_string());
            if let Some(first) = first_value(doc)
                && ui.small_button("+").on_hover_text("Give this key").clicked()
            {
                given = Some(Some(first));
            }
        });
        return given;
    };
    let may_go = matches!(doc.when_absent, WhenAbsent::Means(_));
    let mut changed = None;
    ui.horizontal(|ui| {
        changed = widget(ui, &doc.accepts, value).map(Some);
        if may_go && ui.small_button("−").on_hover_text("Leave this key out").clicked() {
            changed = Some(None);
        }
    });
    changed
}

fn widget(ui: &mut Ui, accepts: &Accepts, value: &Value) -> Option<Value> {
    match accepts {
        Accepts::Real { min, max, .. } => real(ui, number(value)?, *min, *max).map(Value::Float),
        Accepts::Integer { min, max } => {
            let mut edited = value.as_integer()?;
            let (min, max) = (i64::try_from(*min).ok()?, i64::try_from(*max).unwrap_or(i64::MAX));
            let drag = DragValue::new(&mut edited).range(min..=max).clamp_existing_to_range(false);
            ui.add(drag.update_while_editing(false)).changed().then_some(Value::Integer(edited))
        }
        Accepts::Integers(integers) => {
            let words: Vec<String> = integers.iter().map(u32::to_string).collect();
            let chosen = choice(ui, &words, &value.to_string())?;
            Some(Value::Integer(chosen.parse().ok()?))
        }
        Accepts::Words(words) => choice(ui, words, value.as_str()?).map(Value::String),
        Accepts::WordsOrTable { words, key, min, max } => words_or_table(ui, words, key, *min, *max, value),
        Accepts::Colour { min, max, .. } | Accepts::Pair { min, max, .. } => {
            numbers(ui, value, |_| (*min, *max))
        }
        Accepts::Point { min, max } => numbers(ui, value, |axis| (min[axis.min(2)], max[axis.min(2)])),
        Accepts::Flag => {
            let mut edited = value.as_bool()?;
            ui.checkbox(&mut edited, "").changed().then_some(Value::Boolean(edited))
        }
        _ => text(ui, value.as_str()?),
    }
}

fn number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|integer| integer as f64))
}

fn real(ui: &mut Ui, value: f64, min: f64, max: f64) -> Option<f64> {
    let mut edited = value;
    let slider = Slider::new(&mut edited, min..=max)
        .clamping(egui::SliderClamping::Never)
        .logarithmic(min >= 0.0 && max > 50.0 * min.max(1e-3))
        .smallest_positive((max * 1e-6).max(min).max(1e-9))
        .max_decimals(4);
    // What is typed counts once it is typed.
    ui.add(slider.update_while_editing(false)).changed().then_some(edited)
}

fn choice<W: AsRef<str>>(ui: &mut Ui, words: &[W], chosen: &str) -> Option<String> {
    let mut other = None;
    ComboBox::from_id_salt("word").selected_text(chosen).show_ui(ui, |ui| {
        for word in words {
            let word = word.as_ref();
            if ui.selectable_label(word == chosen, word).clicked() && word != chosen {
                other = Some(word.to_owned());
            }
        }
    });
    other
}

fn words_or_table(
    ui: &mut Ui,
    words: &[&str],
    key: &str,
    min: f64,
    max: f64,
    value: &Value,
) -> Option<Value> {
    let table = |number: f64| Value::Table([(key.to_owned(), Value::Float(number))].into_iter().collect());
    let inside = value.as_table().and_then(|table| number(table.get(key)?));
    let all: Vec<&str> = words.iter().copied().chain([key]).collect();
    let chosen = choice(ui, &all, if inside.is_some() { key } else { value.as_str()? });
    if let Some(word) = chosen {
        return Some(if word == key { table(8.0_f64.clamp(min, max)) } else { Value::String(word) });
    }
    real(ui, inside?, min, max).map(table)
}

fn numbers(ui: &mut Ui, value: &Value, range: impl Fn(usize) -> (f64, f64)) -> Option<Value> {
    let mut edited: Vec<f64> = value.as_array()?.iter().filter_map(number).collect();
    let mut changed = false;
    for (axis, number) in edited.iter_mut().enumerate() {
        let (min, max) = range(axis);
        let speed = 0.01 * number.abs().max(0.01);
        let drag = DragValue::new(number).range(min..=max).speed(speed).clamp_existing_to_range(false);
        changed |= ui.add(drag.update_while_editing(false)).changed();
    }
    changed.then(|| Value::Array(edited.into_iter().map(Value::Float).collect()))
}

/// Counts once Enter is pressed or the field is left.
fn text(ui: &mut Ui, value: &str) -> Option<Value> {
    let id = ui.scope_id().with("text");
    let mut edited = ui.data_mut(|data| data.get_temp::<String>(id)).unwrap_or_else(|| value.to_owned());
    let response = ui.text_edit_singleline(&mut edited);
    if response.lost_focus() {
        ui.data_mut(|data| data.remove::<String>(id));
        return (edited != value).then_some(Value::String(edited));
    }
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, edited));
    }
    None
}

//! The panel: every setting of the scene, grouped as in the file, and what the window knows beside it.

mod widget;

use crate::actions::{self, Action};
use crate::camera::{Mode, Rig};
use crate::clock::Clock;
use crate::document::{Document, KeyPath, Step};
use egui::{CollapsingHeader, Color32, RichText, ScrollArea, Ui};
use whitecap_scene::named;
use whitecap_scene::reference::KeyDoc;

/// What somebody asked for on the panel.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Wishes {
    /// The scene has other settings now.
    pub(crate) changed: bool,
    /// Another scene.
    pub(crate) open: Option<String>,
    /// The command of this view, on the clipboard.
    pub(crate) copy_command: bool,
    /// The address of this view, on the clipboard.
    pub(crate) copy_link: bool,
    /// What keys do as well.
    pub(crate) actions: Vec<Action>,
}

/// What the panel tells.
pub(crate) struct Told<'a> {
    pub(crate) adapter: String,
    /// The last frames' times, ms.
    pub(crate) frames_ms: &'a [f32],
    /// What went wrong last, and stays until it is mended.
    pub(crate) error: Option<&'a str>,
    /// What was done last.
    pub(crate) news: Option<&'a str>,
}

/// In points: the longest key with its slider.
const PANEL_WIDTH: f32 = 300.0;

/// Shows the panel at the right.
pub(crate) fn show(
    ui: &mut Ui,
    document: &mut Document,
    rig: &Rig,
    clock: &Clock,
    told: &Told<'_>,
) -> Wishes {
    let mut wishes = Wishes::default();
    egui::Panel::right("settings").exact_size(PANEL_WIDTH).show_separator_line(false).show(ui, |ui| {
        head(ui, document, &mut wishes);
        ui.separator();
        time_and_camera(ui, rig, clock, &mut wishes);
        frames(ui, told);
        if let Some(error) = told.error {
            ui.label(RichText::new(error).color(ui.visuals().error_fg_color));
        }
        for warning in &document.scene().warnings {
            ui.label(RichText::new(warning).color(ui.visuals().warn_fg_color).small());
        }
        if let Some(news) = told.news {
            ui.label(RichText::new(news).small());
        }
        ui.separator();
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| settings(ui, document, &mut wishes));
    });
    wishes
}

/// A button that does what a key does.
fn button(ui: &mut Ui, wishes: &mut Wishes, label: &str, hint: &str, action: Action) {
    if ui.button(label).on_hover_text(hint).clicked() {
        wishes.actions.push(action);
    }
}

fn head(ui: &mut Ui, document: &Document, wishes: &mut Wishes) {
    ui.horizontal(|ui| {
        let scenes = egui::ComboBox::from_id_salt("scene").selected_text(document.origin()).width(200.0);
        let scenes = scenes.show_ui(ui, |ui| {
            for scene in named::ALL {
                let is_shown = document.origin() == scene.name;
                if ui.selectable_label(is_shown, scene.name).on_hover_text(scene.title).clicked() {
                    wishes.open = Some(scene.name.to_owned());
                }
            }
        });
        scenes.response.on_hover_text("The named scenes; a file of your own: drop it on the window");
    });
    ui.horizontal_wrapped(|ui| {
        button(ui, wishes, "Save", "As a new TOML file, with this camera (Ctrl+S)", Action::Save);
        button(ui, wishes, "Undo", "Take the last change back (Ctrl+Z)", Action::Undo);
        button(ui, wishes, "Picture", "A PNG of this view (F12)", Action::Screenshot);
        wishes.copy_command |= ui
            .button("Copy command")
            .on_hover_text("The `whitecap render` that makes this picture")
            .clicked();
        if cfg!(target_arch = "wasm32") {
            let link = ui.button("Copy link").on_hover_text("The address of this view, changes included");
            wishes.copy_link |= link.clicked();
        }
    });
}

fn time_and_camera(ui: &mut Ui, rig: &Rig, clock: &Clock, wishes: &mut Wishes) {
    ui.horizontal_wrapped(|ui| {
        let (word, hint) = if clock.is_paused() { ("Go on", "Space") } else { ("Pause", "Space") };
        button(ui, wishes, word, hint, Action::Pause);
        button(ui, wishes, "Step", "One frame of 1/60 s (.)", Action::Step);
        button(ui, wishes, "Reset", "Time begins again (T)", Action::ResetTime);
        ui.label(format!("{:.2} s, × {}", clock.time_s(), clock.speed()));
    });
    ui.horizontal_wrapped(|ui| {
        let word = match rig.mode() {
            Mode::Fly => "Fly",
            Mode::Orbit => "Orbit",
        };
        button(ui, wishes, word, "Fly freely, or orbit (O)", Action::CameraMode);
        button(ui, wishes, "Scene's camera", "R", Action::ResetCamera);
        let [x, y, z] = rig.camera().position_m;
        ui.label(format!("{x:.1}, {y:.1}, {z:.1} m"));
    });
}

fn frames(ui: &mut Ui, told: &Told<'_>) {
    let mut sorted = told.frames_ms.to_vec();
    sorted.sort_by(f32::total_cmp);
    let median = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    ui.label(RichText::new(format!("{median:.0} ms a frame on {}", told.adapter)).small());
    let (response, painter) =
        ui.allocate_painter(egui::vec2(ui.available_width(), 28.0), egui::Sense::hover());
    let rect = response.rect;
    let most = sorted.last().copied().unwrap_or(1.0).max(1.0);
    let place = |(i, ms): (usize, &f32)| {
        let x = rect.left() + rect.width() * i as f32 / told.frames_ms.len().max(2) as f32;
        egui::pos2(x, rect.bottom() - rect.height() * ms / most)
    };
    let line: Vec<egui::Pos2> = told.frames_ms.iter().enumerate().map(place).collect();
    painter.line(line, egui::Stroke::new(1.0, ui.visuals().hyperlink_color));
    response.on_hover_text(format!("The last {} frames, up to {most:.0} ms", told.frames_ms.len()));
}

/// All tables with their keys.
fn settings(ui: &mut Ui, document: &mut Document, wishes: &mut Wishes) {
    let keys = document.keys();
    for group in keys.chunk_by(|(one, _), (other, _)| one.tables == other.tables) {
        // The camera is where one flies.
        let heading = heading(&group[0].0.tables);
        if heading == "camera" {
            continue;
        }
        let is_open = group[0].0.tables.len() < 2;
        CollapsingHeader::new(&heading).default_open(is_open).id_salt(&heading).show(ui, |ui| {
            for (path, doc) in group {
                wishes.changed |= row(ui, document, path, doc);
            }
        });
    }
}

fn heading(tables: &[Step]) -> String {
    if tables.is_empty() {
        return "scene".to_owned();
    }
    let name = |step: &Step| match step {
        Step::Table(name) => name.clone(),
        Step::Nth(name, index) => format!("{name} {}", index + 1),
    };
    tables.iter().map(name).collect::<Vec<_>>().join(".")
}

/// One key: its name, its value, a way back. The answer is whether it was changed.
fn row(ui: &mut Ui, document: &mut Document, path: &KeyPath, doc: &KeyDoc) -> bool {
    let mut changed = false;
    ui.push_id(path.to_string(), |ui| {
        ui.horizontal(|ui| {
            let unit = doc.accepts.unit();
            let name = if unit.is_empty() { doc.key.to_owned() } else { format!("{} [{unit}]", doc.key) };
            let is_new = !document.is_as_opened(path);
            let text = if is_new { RichText::new(&name).strong() } else { RichText::new(&name) };
            ui.label(text).on_hover_text(format!(
                "{}\n\naccepted: {}\nleft out: {}",
                doc.doc, doc.accepts, doc.when_absent
            ));
            if is_new && ui.small_button("↺").on_hover_text("As it was when the scene was opened").clicked()
            {
                changed |= document.reset(path);
            }
        });
        if let Some(value) = widget::edited(ui, doc, document.value(path)) {
            changed |= document.set(path, value);
        }
        if let Some(refusal) = document.refusal(path) {
            ui.label(RichText::new(refusal).color(ui.visuals().error_fg_color).small());
        }
    });
    changed
}

/// The keys, over the water.
pub(crate) fn help(ui: &Ui) {
    egui::Window::new("Keys").anchor(egui::Align2::LEFT_TOP, [12.0, 12.0]).resizable(false).show(
        ui.ctx(),
        |ui| {
            egui::Grid::new("keys").num_columns(2).striped(true).show(ui, |ui| {
                for binding in actions::labelled() {
                    ui.label(RichText::new(binding.label).strong());
                    ui.label(binding.doc);
                    ui.end_row();
                }
            });
        },
    );
}

/// Shown over the water when there is no panel: what is wrong.
pub(crate) fn notice(ui: &Ui, text: &str) {
    egui::Window::new("Error").anchor(egui::Align2::CENTER_TOP, [0.0, 12.0]).resizable(false).show(
        ui.ctx(),
        |ui| {
            ui.label(RichText::new(text).color(Color32::from_rgb(255, 110, 90)));
        },
    );
}

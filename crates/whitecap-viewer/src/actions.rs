//! What keys do: one list, from which the help sheet, the docs and the event loop are made.

/// What somebody can ask for by a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Move while the key is down.
    Forward,
    /// Move back.
    Back,
    /// Move left.
    Left,
    /// Move right.
    Right,
    /// Rise.
    Up,
    /// Sink.
    Down,
    /// Turn left.
    TurnLeft,
    /// Turn right.
    TurnRight,
    /// Look up.
    LookUp,
    /// Look down.
    LookDown,
    /// Fly or orbit.
    CameraMode,
    /// Back to the scene's camera.
    ResetCamera,
    /// Stand still or go on.
    Pause,
    /// One frame on.
    Step,
    /// Half as fast.
    Slower,
    /// Twice as fast.
    Faster,
    /// Time begins again.
    ResetTime,
    /// Show or hide the panel.
    Panel,
    /// Show or hide this list.
    Help,
    /// Write the scene's file.
    Save,
    /// Take the last change back.
    Undo,
    /// Write a picture of the view.
    Screenshot,
    /// Whole screen or window.
    FullScreen,
}

/// A key that does something.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// The key by its name in winit's `KeyCode`.
    pub code: &'static str,
    /// As keyboards label it.
    pub label: &'static str,
    /// With Ctrl held.
    pub with_ctrl: bool,
    /// What it does.
    pub action: Action,
    /// In words.
    pub doc: &'static str,
}

const fn key(code: &'static str, label: &'static str, action: Action, doc: &'static str) -> Binding {
    Binding { code, label, with_ctrl: false, action, doc }
}

const fn ctrl(code: &'static str, label: &'static str, action: Action, doc: &'static str) -> Binding {
    Binding { code, label, with_ctrl: true, action, doc }
}

/// Every key, by its place on the keyboard.
pub const ALL: &[Binding] = &[
    key("KeyW", "W", Action::Forward, "forward; in orbit nearer (Shift: ten times as fast, Alt: a tenth)"),
    key("KeyS", "S", Action::Back, "back; in orbit away"),
    key("KeyA", "A", Action::Left, "to the left"),
    key("KeyD", "D", Action::Right, "to the right"),
    key("KeyE", "E", Action::Up, "up"),
    key("KeyQ", "Q", Action::Down, "down"),
    key("ArrowLeft", "←", Action::TurnLeft, "turn left (or drag with the mouse)"),
    key("ArrowRight", "→", Action::TurnRight, "turn right"),
    key("ArrowUp", "↑", Action::LookUp, "look up"),
    key("ArrowDown", "↓", Action::LookDown, "look down"),
    key("KeyO", "O", Action::CameraMode, "fly freely, or orbit what is in the middle"),
    key("KeyR", "R", Action::ResetCamera, "back to the scene's camera"),
    key("Space", "Space", Action::Pause, "pause, or go on"),
    key("Period", ".", Action::Step, "one frame of 1/60 s"),
    key("BracketLeft", "[", Action::Slower, "half as fast, down to 1/16"),
    key("BracketRight", "]", Action::Faster, "twice as fast, up to 4 times"),
    key("KeyT", "T", Action::ResetTime, "time begins again"),
    key("KeyP", "P", Action::Panel, "show or hide the panel"),
    key("F1", "F1 or ?", Action::Help, "show or hide the keys"),
    key("Slash", "?", Action::Help, "show or hide the keys"),
    ctrl("KeyS", "Ctrl+S", Action::Save, "save the scene with this camera as a new TOML file"),
    ctrl("KeyZ", "Ctrl+Z", Action::Undo, "take the last change of a setting back"),
    key("F12", "F12", Action::Screenshot, "save a picture of the view, as `whitecap render` makes it"),
    key("F11", "F11", Action::FullScreen, "whole screen, or window"),
];

/// What a key does.
pub fn find(code: &str, with_ctrl: bool) -> Option<Action> {
    ALL.iter()
        .find(|binding| binding.code == code && binding.with_ctrl == with_ctrl)
        .map(|binding| binding.action)
}

/// Every label and what it does, once.
pub fn labelled() -> impl Iterator<Item = &'static Binding> {
    ALL.iter().filter(|binding| binding.code != "Slash")
}

/// The keys as a table in Markdown.
pub fn markdown() -> String {
    let row = |binding: &Binding| format!("| {} | {} |\n", binding.label, binding.doc);
    let rows: String = labelled().map(row).collect();
    format!("| key | what it does |\n| --- | --- |\n{rows}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_does_two_things() {
        for (i, one) in ALL.iter().enumerate() {
            let again =
                ALL[i + 1..].iter().any(|other| (one.code, one.with_ctrl) == (other.code, other.with_ctrl));
            assert!(!again, "{}", one.code);
        }
        assert_eq!(find("KeyS", true), Some(Action::Save));
        assert_eq!(find("KeyS", false), Some(Action::Back));
        assert_eq!(find("KeyX", false), None);
    }
}

//! Why a window cannot be had.

use whitecap_render::RenderError;
use whitecap_scene::SceneError;

/// What keeps the viewer from opening, or ends it.
#[derive(Debug, thiserror::Error)]
pub enum ViewError {
    /// Nothing to open a window on.
    #[error(
        "there is no display to open a window on ({reason}); on a machine without a screen `whitecap render` makes pictures"
    )]
    NoDisplay {
        /// What the window system says.
        reason: String,
    },

    /// The window system refuses a window or a surface in it.
    #[error("no window can be opened: {0}")]
    Window(String),

    /// The scene cannot be used.
    #[error(transparent)]
    Scene(#[from] SceneError),

    /// The adapter cannot do it.
    #[error(transparent)]
    Render(#[from] RenderError),
}

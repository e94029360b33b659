//! Why a command has no result, and whose turn it is to act.

use std::process::ExitCode;
use whitecap_render::RenderError;
use whitecap_scene::SceneError;

/// A command that stopped early.
#[derive(Debug)]
pub(crate) enum Failure {
    /// What was asked for is wrong, and asking differently helps: exit code 2.
    Input(anyhow::Error),
    /// The machine could not do it: no adapter, no space, no permission. Exit code 1.
    Machine(anyhow::Error),
    /// Whoever read our output has seen enough, as `head` does. That is success: exit code 0.
    ReaderGone,
}

impl Failure {
    /// What to tell the user, on one line; `None` where there is nothing to tell.
    pub(crate) fn sentence(&self) -> Option<String> {
        match self {
            // A driver's own words may come with line breaks.
            Failure::Input(error) | Failure::Machine(error) => Some(one_line(&format!("{error:#}"))),
            Failure::ReaderGone => None,
        }
    }

    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Failure::Input(_) => ExitCode::from(2),
            Failure::Machine(_) => ExitCode::from(1),
            Failure::ReaderGone => ExitCode::SUCCESS,
        }
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Failure::Input(error.into())
    }
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::NoSuchAdapter { .. }
            | RenderError::LimitExceeded { .. }
            | RenderError::Panorama(_)
            | RenderError::Scene(_) => Failure::Input(error.into()),
            _ => Failure::Machine(error.into()),
        }
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn input(error: RenderError) -> bool {
        matches!(Failure::from(error), Failure::Input(_))
    }

    #[test]
    fn asking_differently_helps_only_where_the_request_was_wrong() {
        let asked_too_much = RenderError::LimitExceeded {
            what: "picture width".into(),
            asked: 70_000,
            accepted: "1 to 16384 pixels".into(),
        };
        assert!(input(asked_too_much));
        assert!(input(RenderError::NoSuchAdapter { wanted: "x".into(), available: "y".into() }));
        assert!(!input(RenderError::NoAdapter { looked_for: "Vulkan".into() }));
        assert!(!input(RenderError::OutOfMemory { what: "the picture".into() }));
        assert!(!input(RenderError::DeviceLost { reason: "gone".into() }));
    }

    #[test]
    fn a_sentence_is_one_line_and_carries_the_cause() {
        let cause = std::io::Error::other("no\nspace");
        let failure = Failure::Machine(anyhow::Error::new(cause).context("cannot write sea.png"));
        assert_eq!(failure.sentence().as_deref(), Some("cannot write sea.png: no space"));
    }
}

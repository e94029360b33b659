//! What the viewer's window stands in: a desktop with files, or a page of a browser. Both have the same methods.

#[cfg(not(target_arch = "wasm32"))]
mod desktop;
#[cfg(target_arch = "wasm32")]
mod page;

#[cfg(not(target_arch = "wasm32"))]
pub(crate) use desktop::Host;
#[cfg(not(target_arch = "wasm32"))]
pub use desktop::{ViewOptions, view};
#[cfg(target_arch = "wasm32")]
pub(crate) use page::Host;
#[cfg(target_arch = "wasm32")]
pub use page::{Page, Remote, view_on};

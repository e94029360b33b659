//! Quiet on machines without a screen.

/// What says that there is a screen, or that the user chooses among graphics cards by Mesa's own means.
const SAYS_OTHERWISE: [&str; 5] =
    ["XDG_RUNTIME_DIR", "DISPLAY", "DRI_PRIME", "MESA_VK_DEVICE_SELECT", "NODEVICE_SELECT"];

/// Turns off Mesa's device-select layer where there is no screen.
///
/// The layer asks the compositor which graphics card it uses, and without one libwayland writes `error:
/// XDG_RUNTIME_DIR is invalid or not set in the environment.`, twice, to the standard error of a program that
/// needs no compositor.
///
/// Must be called before the process has a second thread.
#[allow(unsafe_code)] // the layer listens to nothing but this variable
pub(crate) fn hush_device_selection() {
    let headless =
        cfg!(target_os = "linux") && SAYS_OTHERWISE.iter().all(|name| std::env::var_os(name).is_none());
    if headless {
        // SAFETY: the process has one thread, so nobody reads the environment meanwhile.
        unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
    }
}

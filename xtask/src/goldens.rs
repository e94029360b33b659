//! The golden pictures, made anew on purpose.

use crate::{process, product, setup};
use anyhow::Result;

pub(crate) fn run() -> Result<()> {
    setup::ensure_adapter(&product::build_tests()?)?;
    process::heading("golden pictures");
    let mut test = process::cargo();
    // The whole workspace, for the reason that `build_tests` gives; only one crate has a test of this name.
    test.args(["test", "--workspace", "--test", "goldens"]);
    process::run(test.env("WHITECAP_UPDATE_GOLDENS", "1").env("WHITECAP_REQUIRE_ADAPTER", "1"))?;
    process::say(
        "\nThe pictures in crates/whitecap-tests/goldens/ are new. They are now what every change is measured\n\
         against, so somebody must look at each of them before they are committed.",
    );
    Ok(())
}

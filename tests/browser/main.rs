//! The HTML page as people use it: opened in Chromium without a window, and driven by mouse and keyboard.
//!
//! Without Chromium the tests say so and pass, except when `CI=true`. `OBJDICT_CHROMIUM` names another executable.
#![cfg(all(unix, feature = "cli"))]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod chromium;
mod driving;
mod tab;

//! The HTML page as people use it: opened in Chromium without a window, and driven by mouse and keyboard.
//!
//! Without Chromium the tests say so and pass, except when `CI=true`. `OBJDICT_CHROMIUM` names another executable.
#![cfg(all(unix, feature = "cli"))]
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may fail by panicking, and says how long a large page takes"
)]

mod anchors;
mod bus_page;
mod changes;
mod chromium;
mod copying;
mod driving;
mod filter;
mod hostile;
mod large;
mod layout;
mod page;
mod paper;
mod pictures;
mod probe;
mod reading;
#[path = "../support/mod.rs"]
mod support;
mod tab;

//! Checks files according to their configuration and reports the findings. Part of `objdict`, which is the
//! crate to depend on.

#![cfg_attr(not(feature = "full"), allow(unreachable_pub, reason = "what is used depends on the features"))]

#[cfg(feature = "full")]
pub mod baseline;
pub mod check;
pub mod compat;
#[cfg(feature = "lint")]
pub mod config;
#[cfg(feature = "lint")]
mod fix;
#[cfg(feature = "network")]
pub mod line_diff;
pub mod registry;
pub mod report;
#[cfg(feature = "lint")]
pub mod workspace;

pub use check::{check, check_unordered, check_with};
#[cfg(feature = "lint")]
pub use fix::{AppliedFix, Fixed, fix, fix_for_readers, with_sound_fixes};

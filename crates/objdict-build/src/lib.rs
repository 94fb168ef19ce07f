//! Generated files and build scripts. Part of `objdict`, which is the crate to depend on.

#![cfg_attr(
    not(feature = "command"),
    allow(unreachable_pub, reason = "what is used depends on the features")
)]

pub mod build_script;
mod output;
pub mod pipeline;

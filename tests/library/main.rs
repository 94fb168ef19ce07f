//! What the library makes of descriptions: reading, checking, fixing, writing. A module an area; `cargo test --test library
//! rules` runs one.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod agree;
mod boot;
mod boots;
#[cfg(feature = "full")]
mod canopeneditor;
mod changes;
mod circles;
mod compat;
mod concise;
mod config;
mod configure;
mod configure_node;
mod conformance;
#[cfg(feature = "full")]
mod conversions;
mod dbc;
mod device_profile;
mod device_toml;
mod device_variants;
#[cfg(feature = "cli")]
mod disabled;
mod document;
mod doors;
mod download_plan;
mod equal;
mod errata;
#[cfg(feature = "cli")]
mod esi;
mod fix;
mod fmt;
#[cfg(feature = "cli")]
mod grammar;
mod graph;
mod helps;
mod identify;
mod ini_oracle;
mod interop;
mod json;
mod links;
mod lint;
mod lock;
mod lossless;
#[cfg(feature = "full")]
mod lsp;
mod namesakes;
mod network;
mod new;
mod numbers;
mod objdictgen;
#[cfg(feature = "full")]
mod object_table;
#[cfg(feature = "cli")]
mod pages;
mod patch;
mod places;
mod planted;
#[cfg(feature = "full")]
mod probe;
mod profiles;
#[cfg(feature = "cli")]
mod published;
mod related;
mod rules;
mod skipping;
mod structure;
#[path = "../support/mod.rs"]
mod support;
mod texts;
mod timing;
mod torture;
#[cfg(feature = "full")]
mod traffic;
mod verify;
mod write;
mod xdd;
mod xdd_of_tools;
mod xml_oracle;

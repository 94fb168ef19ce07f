//! Tables that derive the traits of defmt: that they compile is all that is tried, for a program needs a logger. Everything else
//! is in `tests`.
#![allow(unsafe_code, reason = "the macros of defmt write it")]

include!(concat!(env!("OUT_DIR"), "/defmt.rs"));

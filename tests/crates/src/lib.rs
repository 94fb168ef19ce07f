//! Tables that derive the traits of defmt. They are only compiled, because a program needs a logger. All
//! other tests are in `tests`.
#![allow(unsafe_code, reason = "the macros of defmt write it")]

include!(concat!(env!("OUT_DIR"), "/defmt.rs"));

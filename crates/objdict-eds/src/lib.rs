//! EDS and DCF (CiA 306-1): lines with positions, and conversion to and from the model. Part of
//! `objdict`, which is the crate to depend on.

pub mod eds;
pub mod ini;

use objdict_model::{diagnostic, literal, model, source};

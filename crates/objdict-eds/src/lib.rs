//! EDS and DCF (CiA 306-1): lines with positions, the model read from them and written to them. Part of
//! `objdict`, which is the crate to depend on.

pub mod eds;
pub mod ini;

use objdict_model::{diagnostic, literal, model, source};

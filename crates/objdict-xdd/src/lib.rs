//! XDD and XDC (CiA 311): elements with positions, the model read from them and written to them. Part of
//! `objdict`, which is the crate to depend on.

pub mod xdd;
pub mod xml;

use objdict_model::{diagnostic, literal, model, source};

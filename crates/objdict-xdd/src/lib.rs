//! XDD and XDC (CiA 311): elements with positions, and conversion to and from the model. Part of
//! `objdict`, which is the crate to depend on.

pub mod xdd;
pub mod xml;

use objdict_model::{diagnostic, literal, model, source};

//! Configuration of nodes: settings checked against a dictionary, couplers with their modules, and concise
//! DCF (CiA 302-3). Part of `objdict`; depend on that crate instead.

pub mod concise;
pub mod configure;
pub mod coupler;
pub mod download;
pub mod parameter;
mod resolve;

pub use resolve::{ObjectName, candidates, meant, resolve};

use objdict_model::{diagnostic, literal, model};
use objdict_profile as profile;

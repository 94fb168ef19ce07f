//! The language server: an editor in this process opens files, changes them and asks.

mod again;
mod allowed;
pub(crate) mod client;
mod findings;
mod folder;
mod keyed;
mod offered;
mod places;
mod random;
mod typing;
mod writing;

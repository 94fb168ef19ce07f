//! The built-in documents, generated from `data` by `cargo xtask profiles`. If the table format changes, xtask
//! does not build with the old tables: remove them from this list for that run.

#[rustfmt::skip]
mod cia301;
#[cfg(feature = "catalogue")]
#[rustfmt::skip]
mod cia302;
#[cfg(feature = "catalogue")]
#[rustfmt::skip]
mod cia401;
#[cfg(feature = "catalogue")]
#[rustfmt::skip]
mod cia402;
#[cfg(feature = "catalogue")]
#[rustfmt::skip]
mod cia404;
#[cfg(feature = "catalogue")]
#[rustfmt::skip]
mod cia406;

use super::Profile;

/// The documents in ascending order of their numbers.
pub(super) static DOCUMENTS: &[(u16, &Profile)] = &[
    (301, &cia301::PROFILE),
    #[cfg(feature = "catalogue")]
    (302, &cia302::PROFILE),
    #[cfg(feature = "catalogue")]
    (401, &cia401::PROFILE),
    #[cfg(feature = "catalogue")]
    (402, &cia402::PROFILE),
    #[cfg(feature = "catalogue")]
    (404, &cia404::PROFILE),
    #[cfg(feature = "catalogue")]
    (406, &cia406::PROFILE),
];

//! The documents that come with the program: generated from `data` by `cargo xtask profiles`. When the form of
//! the tables changes, xtask does not build with the old ones: take them out of this list for that run.

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

/// The documents, with their numbers, in the order of these.
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

//! The documents that come with the program: generated from `data` by `cargo xtask profiles`. When the form of
//! the tables changes, xtask does not build with the old ones: take them out of this list for that run.

#[rustfmt::skip]
mod cia301;
#[rustfmt::skip]
mod cia302;
#[rustfmt::skip]
mod cia401;
#[rustfmt::skip]
mod cia402;
#[rustfmt::skip]
mod cia404;
#[rustfmt::skip]
mod cia406;

use super::Profile;

/// The documents, with their numbers, in the order of these.
pub(super) static DOCUMENTS: &[(u16, &Profile)] = &[
    (301, &cia301::PROFILE),
    (302, &cia302::PROFILE),
    (401, &cia401::PROFILE),
    (402, &cia402::PROFILE),
    (404, &cia404::PROFILE),
    (406, &cia406::PROFILE),
];

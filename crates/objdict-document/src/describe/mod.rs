//! Meanings of values as text: communication objects (CiA 301 §7.5.2, CiA 304) and objects of device
//! profiles.

mod decoder;
mod device;
mod error;
pub mod frames;
mod pdo;
pub(crate) mod time;
mod value;

pub use self::decoder::Decoder;
pub(crate) use self::device::is_of_cia;
pub(crate) use self::error::{error_codes, single_codes};
pub(crate) use self::pdo::{can_id, spelled};
pub(crate) use self::time::{decimal, of_microseconds, of_milliseconds};
pub use self::value::ValueReader;

#[cfg(test)]
mod tests;

//! XDD and XDC: device descriptions and configurations in XML (CiA 311).

#![allow(dead_code, unused_imports, unreachable_pub, reason = "the reader and the writer come next")]

mod leftovers;
mod markup;
#[macro_use]
mod shape;
mod version;

pub use self::version::XddVersion;

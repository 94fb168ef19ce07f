//! How fast the library is; `cargo bench xml` runs one module.

mod concise;
#[cfg(feature = "full")]
mod docs;
mod large;
mod lookup;
#[cfg(feature = "full")]
mod network;
mod read;
mod xml;

fn main() {
    divan::main();
}

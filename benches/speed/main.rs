//! How fast the library is; `cargo bench xml` runs one module.

mod concise;
#[cfg(feature = "document")]
mod docs;
mod large;
mod lookup;
#[cfg(feature = "network")]
mod network;
mod read;
mod xml;

fn main() {
    divan::main();
}

//! How fast the library is; `cargo bench xml` runs one module.

mod concise;
#[cfg(feature = "document")]
mod docs;
mod large;
mod lookup;
mod read;
mod xml;

fn main() {
    divan::main();
}

//! Makes `od.rs` of the EDS that the variable `NODE_EDS` names.

use objdict::build_script::{Builder, Error};

fn main() -> Result<(), Error> {
    println!("cargo:rerun-if-env-changed=NODE_EDS");
    let eds = std::env::var("NODE_EDS").unwrap_or_else(|_| "../../fixtures/eds/all-types.eds".to_owned());
    Builder::new(eds).node_id(5).domain_capacity(1000).runtime(true).generate()?;
    let bootloader = Builder::new("../../fixtures/eds/bootloader.eds").node_id(5).module("bootloader");
    bootloader.group(0x1017..=0x1017, "PERSISTENT").runtime(true).generate()?;
    let stored = Builder::new("../../fixtures/eds/io-401.eds").node_id(5).module("stored");
    stored.group(0x1005..=0x1FFF, "COMM").group(0x2000..=0x9FFF, "APPLICATION").runtime(true).generate()?;
    Ok(())
}

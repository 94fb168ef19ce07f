//! Makes `od.rs` of an EDS.

use objdict::build_script::{Builder, Error};

fn main() -> Result<(), Error> {
    Builder::new("../../fixtures/eds/io-401.eds").node_id(5).runtime(true).generate()?;
    Ok(())
}

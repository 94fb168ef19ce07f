//! Makes `od.rs` of the description whenever it changes, and fails where the description has an error.

use objdict::build_script::{Builder, Error};

fn main() -> Result<(), Error> {
    Builder::new("../climate-sensor.eds").node_id(5).generate()?;
    Ok(())
}

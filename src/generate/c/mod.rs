//! The target `c`: `od.h` and `od.c` in C99.

mod view;

use super::table::Table;
use super::{Backend, Choice, GenerateError, Generated, Options, render};
use crate::model::Device;

/// Tables for C.
pub(super) struct C;

impl Backend for C {
    fn name(&self) -> &'static str {
        "c"
    }

    fn summary(&self) -> &'static str {
        "`od.h` and `od.c` in C99 (no malloc): dictionary, values, SDO access by index and sub-index"
    }

    fn uses(&self) -> &'static [Choice] {
        &[Choice::Names, Choice::Renamed, Choice::Prefix, Choice::StringCapacity, Choice::DomainCapacity]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let table = Table::new(device, options)?;
        let prefix = options.prefix_or("od")?;
        let header = render(format!("{prefix}.h"), &view::Header::new(&table, &prefix))?;
        let source = render(format!("{prefix}.c"), &view::Source::new(&table, &prefix))?;
        Ok(Generated { files: vec![header, source], notes: table.notes })
    }
}

//! The target `c`: `od.h` and `od.c` in C99.

mod view;

use super::table::Table;
use super::{Backend, GenerateError, Generated, Options, render};
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

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let table = Table::new(device, options)?;
        let header = render("od.h", &view::Header::new(&table))?;
        let source = render("od.c", &view::Source::new(&table))?;
        Ok(Generated { files: vec![header, source], notes: table.notes })
    }
}

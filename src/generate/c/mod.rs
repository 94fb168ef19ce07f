//! The target `c`: `od.h` and `od.c` in C99.

mod pdo;
mod view;

use super::frames::frames;
use super::notes::in_order;
use super::size::Layout;
use super::table::Table;
use super::{Backend, Choice, GenerateError, Generated, Options, SizeReport, render};
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
        let prefix = options.prefix_or("od")?;
        let mut table = Table::new(device, options)?;
        let mut notes = std::mem::take(&mut table.notes);
        let frames = frames(device, &table, &mut notes);
        let mut files = vec![
            render(format!("{prefix}.h"), &view::Header::new(&table, &prefix))?,
            render(format!("{prefix}.c"), &view::Source::new(&table, &prefix))?,
        ];
        if !frames.is_empty() {
            files.push(render(format!("{prefix}_pdo.h"), &pdo::PdoHeader::new(&table, &prefix, &frames))?);
            files.push(render(format!("{prefix}_pdo.c"), &pdo::PdoSource::new(&table, &prefix, &frames))?);
        }
        Ok(Generated { files, notes: in_order(notes) })
    }

    fn size(&self, device: &Device, options: &Options) -> Result<Option<SizeReport>, GenerateError> {
        let table = Table::new(device, options)?;
        let row = if table.is_wide() { 16 } else { 10 };
        Ok(Some(SizeReport::of_table(&table, Layout { row, is_ascending: true })))
    }
}

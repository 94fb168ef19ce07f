//! The target `lely`: the static device (`struct co_sdev`) of Lely core 2.4.
//!
//! The table matches that of the generator dcf2c of Lely core, with one row per sub-index, and corrects its errors:
//! OCTET_STRING and DOMAIN defaults, REAL defaults, TIME_DIFFERENCE, quotes in strings. For a library without
//! `malloc()`, a function of the source builds the device in static memory from the same table.

mod value;
mod view;

use super::c_code::file_name;
use super::dictionary::TableDictionary;
use super::notes::{in_order, once_per_device};
use super::{GenerateError, Generated, Options, render, startup};
use crate::model::{Device, DeviceKind};

pub(super) fn make(device: &Device, options: &Options) -> Result<Generated, GenerateError> {
    let prefix = options.prefix_or("od")?;
    let stem = file_name(options, "sdev");
    // the library allocates the memory of texts and DOMAINs, so their capacity has no limit
    let unlimited = Options { domain_capacity: u16::MAX, ..options.clone() };
    let mut dictionary = TableDictionary::new(device, &unlimited)?;
    // an EDS may have configured values as well
    let configured = Device { kind: DeviceKind::Node, ..device.clone() };
    let defaults = configured.unconfigured();
    let defaults = TableDictionary::new(&defaults, &unlimited)?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let tables = view::LelyView::new(&dictionary, &defaults, options, (&prefix, &stem), &mut notes);
    let files =
        vec![render(format!("{stem}.c"), tables.source()), render(format!("{stem}.h"), tables.header())];
    let mut notes = once_per_device(in_order(notes));
    notes.append(&mut startup::notes(&startup::LELY, &dictionary));
    Ok(Generated { files, notes: in_order(notes) })
}

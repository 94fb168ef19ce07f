//! The target `canopen-rs`: a function of the node-ID that creates the object dictionary for the crate
//! canopen-rs 0.6.

mod losses;
mod view;

use super::dictionary::TableDictionary;
use super::head::Head;
use super::names::NameScope;
use super::notes::{in_order, once_per_device};
use super::{GenerateError, Generated, Options, render};
use crate::model::Device;

/// Capacity of a string, octet string or DOMAIN in the crate, in bytes (`MAX_STRING_LEN`).
const ROOM: u16 = 32;

pub(super) fn make(device: &Device, options: &Options) -> Result<Generated, GenerateError> {
    let module = options.module_or("od")?;
    let function = NameScope::of_lower_case("address octets put").claim(&module, format_args!("od"));
    let room = Options { string_capacity: ROOM, domain_capacity: ROOM, ..options.clone() };
    let mut dictionary = TableDictionary::new(device, &room)?;
    let losses = losses::of(&mut dictionary);
    dictionary.notes.extend(losses);
    let notes = once_per_device(in_order(std::mem::take(&mut dictionary.notes)));
    if dictionary.objects.is_empty() {
        return Err(GenerateError::NoEntries { notes });
    }
    let head = Head::new(device, options, &function, &module);
    let file = render(format!("{module}.rs"), view::CanOpenRsView::new(&dictionary, head).text());
    Ok(Generated { files: vec![file], notes })
}

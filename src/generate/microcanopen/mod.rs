//! The target `microcanopen`: the tables of MicroCANopen, as chapter 6 of "Embedded Networking with CAN and CANopen" has
//! them.
//!
//! What never changes is a ready SDO reply; what can change lies in the process image, where the PDOs take it from. So
//! the order in the image follows the PDO mapping, and everything else comes behind.

mod image;
mod pdos;
mod replies;
mod view;

use super::c_code::file_stem;
use super::dictionary::Dictionary;
use super::notes::{in_order, once_per_device};
use super::{Backend, Choice, GenerateError, Generated, Note, Options, render};
use crate::model::{Device, Part};

/// Tables for MicroCANopen.
pub(super) struct MicroCanopen;

/// The most rows that the stack searches.
const MOST_ROWS: usize = 255;

impl Backend for MicroCanopen {
    fn name(&self) -> &'static str {
        "microcanopen"
    }

    fn summary(&self) -> &'static str {
        "the tables of MicroCANopen: SDO replies, process image, calls that initialise PDOs"
    }

    fn uses(&self) -> &'static [Choice] {
        &[Choice::Names, Choice::Renamed, Choice::Prefix, Choice::StringCapacity]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let mut dictionary = Dictionary::new(device, options)?;
        let prefix = options.prefix_or("od")?;
        let mut notes = std::mem::take(&mut dictionary.notes);
        let mut image = image::Image::new(&dictionary, &prefix, &mut notes);
        let calls = pdos::calls(&dictionary, &mut image, &mut notes);
        image.place_the_rest();
        let replies = replies::replies(&dictionary, &prefix, &mut notes);
        for (rows, what) in [(replies.len(), "SDO replies"), (image.entries.len(), "process data entries")] {
            if rows > MOST_ROWS {
                let text = format!("{rows} {what}; the stack searches {MOST_ROWS} rows at most");
                notes.push(Note::new(Part::Device, text));
            }
        }
        image.check(&mut notes);
        let stem = file_stem(options);
        let head = view::Head::new(&dictionary, &image, options, (&prefix, &stem));
        let files = vec![
            render(format!("{stem}_mco.c"), &view::Source::new(&head, &image, &replies, &calls))?,
            render(format!("{stem}_pimg.h"), &view::Header::new(&head, &image))?,
        ];
        Ok(Generated { files, notes: once_per_device(in_order(notes)) })
    }
}

//! The target `microcanopen`: tables for MicroCANopen as described in chapter 6 of "Embedded Networking with
//! CAN and CANopen".
//!
//! This target and `objdict-macros` are code, not templates of the target `template`: a template sees one device
//! and writes one file, so notes, the process image and `--report size` would be lost.
//!
//! Constant values become prepared SDO replies. Variable values are in the process image, from which the
//! stack reads PDO data. So the image starts with the mapped objects in PDO mapping order; all others
//! follow.

mod image;
mod pdos;
mod view;

use super::c_code::file_stem;
use super::dictionary::TableDictionary;
use super::head::Head;
use super::memory::{Memory, SizeTally};
use super::notes::{in_order, once_per_device};
use super::{BackendOutput, GenerateError, Note, Options, Sizes, render};
use crate::model::{Device, Part};
use view::MicroCanOpenView;

/// Maximum number of rows in the stack.
const MOST_ROWS: usize = 255;

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let mut dictionary = TableDictionary::new(device, options)?;
    let prefix = options.prefix_or("od")?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let mut image = image::Image::new(&dictionary, &prefix, &mut notes);
    let calls = pdos::calls(&dictionary, &mut image, &mut notes);
    image.place_the_rest();
    let replies = view::replies(&dictionary, &prefix, &mut notes);
    for (rows, what) in [(replies.len(), "SDO replies"), (image.entries.len(), "process data entries")] {
        if rows > MOST_ROWS {
            let text = format!("{rows} {what}, but the stack searches at most {MOST_ROWS} rows");
            notes.push(Note::new(Part::Device, text));
        }
    }
    image.check(&mut notes);
    let stem = file_stem(options);
    let head = Head::new(device, options, &prefix, &stem);
    let tables = MicroCanOpenView { head, dictionary: &dictionary, image, calls, replies };
    let files = vec![
        render(format!("{stem}_mco.c"), tables.source()),
        render(format!("{stem}_pimg.h"), tables.header()),
    ];
    Ok(BackendOutput { files, notes: once_per_device(in_order(notes)), size: size(&tables) })
}

/// The content that the sizes include.
const COUNTED: &str =
    "the tables with offsets of 16 bits, and the process image; without code and stack internals";

/// Size of an SDO reply in bytes.
const REPLY: usize = 8;

/// Size of a process image row with 16-bit offsets, in bytes.
const ROW: usize = 6;

fn size(MicroCanOpenView { dictionary, image, replies, .. }: &MicroCanOpenView<'_>) -> Sizes {
    let mut tally = SizeTally::of_dictionary(dictionary);
    for reply in replies {
        tally.of(reply.index, Memory::Flash, REPLY);
    }
    for entry in &image.entries {
        tally.of(entry.index, Memory::Flash, ROW);
        tally.of(entry.index, Memory::Zeroed, entry.size);
    }
    tally.rest(Memory::Flash, REPLY + ROW); // end marks
    let entries: usize = image.entries.iter().map(|entry| entry.size).sum();
    tally.rest(Memory::Zeroed, image.size.max(1).saturating_sub(entries)); // dummy entries of the mapping; C has no empty arrays
    tally.report(COUNTED)
}

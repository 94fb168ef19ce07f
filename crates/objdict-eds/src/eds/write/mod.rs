//! The canonical EDS and DCF of a device without source text: in the order and spelling that most readers
//! accept (CiA 306-1).

mod info;
mod modules;
mod objects;
mod section_writer;

use self::section_writer::SectionWriter;
use crate::eds::Style;
use crate::model::{Device, LANGUAGE, Meanings};

/// The canonical text of a device in the encoding of the options. Content that the format or the
/// encoding cannot represent is approximated; reading the text back shows the loss.
pub fn write(device: &Device, options: &Style) -> Vec<u8> {
    let mut sections = SectionWriter::new(options, &device.extra);
    let meanings = options.meanings.then(|| device.meanings_in(LANGUAGE));
    let writer = EdsWriter { device, meanings };
    writer.general(&mut sections);
    writer.modules(&mut sections);
    writer.objects(&mut sections);
    sections.rest(&device.extra);
    let text = sections.finish();
    let bytes = options.encoding.and_then(|encoding| encoding.encode(&text).ok());
    bytes.unwrap_or(text.into_bytes())
}

/// A device during writing.
struct EdsWriter<'a> {
    device: &'a Device,
    /// The meanings of values, for a reader that supports keys for them.
    meanings: Option<Meanings<'a>>,
}

//! Frames as lines: of text, or of JSON.

use std::io::{self, Write};

use super::super::stdout::Output;
use super::{FramePrinter, ShownFrame, digits, id_of, write_raw};

/// A line for each frame: time, channel, CAN-ID, data, words.
pub(super) struct TextLines;

impl FramePrinter for TextLines {
    fn frame(&mut self, shown: &ShownFrame<'_, '_>, out: &mut Output) -> io::Result<()> {
        let ShownFrame { frame, decoded, bus, .. } = shown;
        let data = if frame.is_remote { "remote".to_owned() } else { digits(frame.data(), " ") };
        let channel = if bus.channel.is_empty() { String::new() } else { format!("{}  ", bus.channel) };
        let words = bus.words(decoded, frame);
        let line = format!("{}  {channel}{:>3}  {data:<23}  {words}", frame.time, id_of(frame));
        writeln!(out, "{}", line.trim_end())
    }
}

/// A line of JSON for each frame.
pub(super) struct JsonLines;

impl FramePrinter for JsonLines {
    fn frame(&mut self, shown: &ShownFrame<'_, '_>, out: &mut Output) -> io::Result<()> {
        write_raw(out, &(shown.bus.json(&shown.decoded, shown.frame) + "\n"))
    }
}

//! Frames as CSV.

use std::collections::BTreeMap;
use std::io;

use super::super::stdout::Output;
use super::{FramePrinter, ShownFrame, digits, id_of, write_raw};
use objdict_document::csv_field;
use objdict_document::describe::frames::{FrameKind, PdoSignal};
use objdict_traffic::log::LogTime;
use objdict_traffic::raw;

const COLUMNS: &str = "time,channel,can_id,kind,node,index,sub,name,value,scaled,unit,text\n";

/// A row for each signal of a PDO, and for each other frame.
#[derive(Default)]
pub(super) struct LongCsv {
    has_heading: bool,
}

impl LongCsv {
    fn row(cells: &[&str], out: &mut Output) -> io::Result<()> {
        let cells: Vec<_> = cells.iter().map(|cell| csv_field(cell)).collect();
        write_raw(out, &(cells.join(",") + "\n"))
    }

    fn heading(&mut self, out: &mut Output) -> io::Result<()> {
        let is_first = !std::mem::replace(&mut self.has_heading, true);
        if is_first { write_raw(out, COLUMNS) } else { Ok(()) }
    }
}

/// The number of a signal, or its text.
fn plain(signal: &PdoSignal<'_>) -> String {
    match (&signal.value, signal.raw) {
        (Some(value), _) => value.to_string(),
        (None, Some(raw)) => raw.to_string(),
        (None, None) => String::new(),
    }
}

impl FramePrinter for LongCsv {
    fn frame(&mut self, shown: &ShownFrame<'_, '_>, out: &mut Output) -> io::Result<()> {
        self.heading(out)?;
        let ShownFrame { frame, decoded, bus, .. } = shown;
        let (time, id) = (frame.time.to_string(), id_of(frame));
        let node = decoded.node_id.map_or_else(String::new, |node_id| node_id.to_string());
        let start = [&*time, &*bus.channel, &*id, decoded.kind.name(), &*node];
        let address = |(index, sub): (u16, u8)| (format!("0x{index:04X}"), format!("0x{sub:02X}"));
        let frame_of_bus = raw(frame);
        let signals = match decoded.kind {
            FrameKind::Pdo => bus.reader.signals(decoded, &frame_of_bus),
            _ => Vec::new(),
        };
        for signal in &signals {
            let (index, sub) = address((signal.index, signal.sub));
            let (value, scaled) = (plain(signal), signal.scaled.as_deref().unwrap_or_default());
            let end = [&*index, &*sub, &*signal.name, &*value, scaled, &*signal.unit, &*signal.text];
            Self::row(&[&start[..], &end].concat(), out)?;
        }
        if !signals.is_empty() {
            return Ok(());
        }
        let entry = decoded.sdo.and_then(|sdo| sdo.entry);
        let (index, sub) = entry.map_or_else(Default::default, address);
        let is_complete = decoded.sdo.is_some_and(|sdo| sdo.step.has_value());
        let value =
            bus.reader.transferred(decoded).filter(|_| is_complete).map(|(bytes, value)| match value {
                Some(value) => value.to_string(),
                None => digits(bytes, " "),
            });
        let (value, words) = (value.unwrap_or_default(), bus.words(decoded, frame));
        let end = [&*index, &*sub, "", &*value, "", "", &*words];
        Self::row(&[&start[..], &end].concat(), out)
    }

    fn end(&mut self, out: &mut Output) -> io::Result<()> {
        self.heading(out)
    }
}

/// A column for each signal and a row for each PDO, which are written at the end, when all signals are known.
pub(super) struct WideCsv {
    max_rows: usize,
    columns: Vec<String>,
    /// Positions of columns by bus, node, index and sub-index.
    positions: BTreeMap<(usize, u8, u16, u8), usize>,
    rows: Vec<(LogTime, Vec<(usize, String)>)>,
    left_out: u64,
}

impl WideCsv {
    pub(super) fn new(max_rows: usize) -> Self {
        Self { max_rows, columns: Vec::new(), positions: BTreeMap::new(), rows: Vec::new(), left_out: 0 }
    }

    fn column(&mut self, shown: &ShownFrame<'_, '_>, signal: &PdoSignal<'_>) -> usize {
        let key = (shown.at, signal.node_id, signal.index, signal.sub);
        let columns = &mut self.columns;
        *self.positions.entry(key).or_insert_with(|| {
            let node = shown.bus.reader.name(signal.node_id);
            let name = match &*signal.name {
                "" => format!("{:04X}:{:02X}", signal.index, signal.sub),
                name => name.to_owned(),
            };
            let unit = if signal.unit.is_empty() { String::new() } else { format!(" [{}]", signal.unit) };
            columns.push(format!("{node} {name}{unit}"));
            columns.len() - 1
        })
    }
}

impl FramePrinter for WideCsv {
    fn frame(&mut self, shown: &ShownFrame<'_, '_>, _out: &mut Output) -> io::Result<()> {
        let ShownFrame { frame, decoded, bus, .. } = shown;
        let frame_of_bus = raw(frame);
        let signals = bus.reader.signals(decoded, &frame_of_bus);
        if signals.is_empty() {
            return Ok(());
        }
        if self.rows.len() >= self.max_rows {
            self.left_out += 1;
            return Ok(());
        }
        let cells = signals.iter().map(|signal| {
            let value = signal.scaled.clone().unwrap_or_else(|| plain(signal));
            (self.column(shown, signal), value)
        });
        let cells = cells.collect();
        self.rows.push((frame.time, cells));
        Ok(())
    }

    fn end(&mut self, out: &mut Output) -> io::Result<()> {
        let names = self.columns.iter().map(|name| csv_field(name));
        let heading: Vec<_> = std::iter::once("time".into()).chain(names).collect();
        write_raw(out, &(heading.join(",") + "\n"))?;
        for (time, cells) in &self.rows {
            let mut row = vec![String::new(); self.columns.len()];
            for (at, value) in cells {
                row[*at] = csv_field(value).into_owned();
            }
            write_raw(out, &format!("{time},{}\n", row.join(",")))?;
        }
        if self.left_out > 0 {
            let text =
                format!("warning: {} PDOs are left out (--max-rows {})\n", self.left_out, self.max_rows);
            super::tell(&text);
        }
        Ok(())
    }
}

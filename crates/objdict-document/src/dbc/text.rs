//! The text of a DBC.

use std::fmt::Write;

use super::Database;
use super::identifier::DbcName;
use super::signal::{DbcMessage, DbcSignal, NumberFormat};
use crate::source::transliterate;

/// The node of frames that no known node sends or receives.
const NO_NODE: &str = "Vector__XXX";

/// Writes a database.
pub(super) fn write(database: &Database<'_>) -> Vec<u8> {
    let mut text = DbcWriter { database, lines: String::new() };
    text.nodes_and_messages();
    text.comments();
    text.attributes();
    text.values();
    text.lines.chars().map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')).collect()
}

struct DbcWriter<'a> {
    database: &'a Database<'a>,
    lines: String,
}

/// Adds a line; writing to a string cannot fail.
macro_rules! line {
    ($text:expr, $($arguments:tt)*) => {
        let _ = write!($text.lines, $($arguments)*);
        $text.lines.push_str("\r\n");
    };
}

impl DbcWriter<'_> {
    fn signals(&self) -> impl Iterator<Item = (&DbcMessage, &DbcName, &DbcSignal)> {
        let messages = self.database.messages.iter();
        messages.flat_map(|message| message.signals.iter().map(move |(name, signal)| (message, name, signal)))
    }

    /// The names of nodes, or the name for no node.
    fn nodes<'n>(&self, nodes: impl IntoIterator<Item = &'n usize>) -> String {
        let names = nodes.into_iter().map(|&node| self.database.stations[node].name.short.as_str());
        let names = names.collect::<Vec<_>>().join(",");
        if names.is_empty() { NO_NODE.to_owned() } else { names }
    }

    fn nodes_and_messages(&mut self) {
        line!(self, "VERSION \"\"\r\n\r\nNS_ :\r\n\r\nBS_:\r\n");
        let names: Vec<&str> =
            self.database.stations.iter().map(|station| station.name.short.as_str()).collect();
        line!(self, "BU_: {}\r\n", names.join(" "));
        for message in &self.database.messages {
            let DbcMessage { id, name, length, senders, signals, .. } = message;
            let sender = self.nodes(senders.first());
            line!(self, "BO_ {} {}: {length} {sender}", id.in_file(), name.short);
            for (name, signal) in signals {
                let line = self.signal(name, signal);
                line!(self, "{line}");
            }
            line!(self, "");
        }
        for message in self.database.messages.iter().filter(|message| message.senders.len() > 1) {
            line!(self, "BO_TX_BU_ {} : {};", message.id.in_file(), self.nodes(&message.senders));
        }
    }

    fn signal(&self, name: &DbcName, signal: &DbcSignal) -> String {
        let first = signal.mux.within.as_ref().and_then(|(_, ranges)| ranges.first());
        let mux = match (first, signal.mux.selects) {
            (None, false) => String::new(),
            (None, true) => " M".to_owned(),
            (Some([value, _]), false) => format!(" m{value}"),
            (Some([value, _]), true) => format!(" m{value}M"),
        };
        let sign = if signal.number == NumberFormat::Unsigned { '+' } else { '-' };
        let limits = signal.limits.map_or_else(|| "0|0".to_owned(), |[low, high]| format!("{low}|{high}"));
        format!(
            " SG_ {}{mux} : {}|{}@1{sign} ({},{}) [{limits}] {} {}",
            name.short,
            signal.first,
            signal.bits,
            signal.scale.factor,
            signal.scale.offset,
            quoted(&signal.unit),
            self.nodes(&signal.receivers)
        )
    }

    fn comments(&mut self) {
        for station in &self.database.stations {
            let comment = quoted(&format!("node-ID {}: {}", station.node_id, station.title));
            line!(self, "CM_ BU_ {} {comment};", station.name.short);
        }
        for message in &self.database.messages {
            line!(self, "CM_ BO_ {} {};", message.id.in_file(), quoted(&message.comment));
            for (name, signal) in message.signals.iter().filter(|(_, signal)| !signal.comment.is_empty()) {
                line!(self, "CM_ SG_ {} {} {};", message.id.in_file(), name.short, quoted(&signal.comment));
            }
        }
    }

    fn attributes(&mut self) {
        line!(self, "BA_DEF_ \"BusType\" STRING ;");
        line!(self, "BA_DEF_ \"Baudrate\" INT 0 1000000;");
        line!(self, "BA_DEF_ BU_ \"SystemNodeLongSymbol\" STRING ;");
        line!(self, "BA_DEF_ BO_ \"SystemMessageLongSymbol\" STRING ;");
        line!(self, "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 4294967;");
        line!(self, "BA_DEF_ SG_ \"SystemSignalLongSymbol\" STRING ;");
        line!(self, "BA_DEF_DEF_ \"BusType\" \"CAN\";");
        line!(self, "BA_DEF_DEF_ \"Baudrate\" 0;");
        line!(self, "BA_DEF_DEF_ \"SystemNodeLongSymbol\" \"\";");
        line!(self, "BA_DEF_DEF_ \"SystemMessageLongSymbol\" \"\";");
        line!(self, "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;");
        line!(self, "BA_DEF_DEF_ \"SystemSignalLongSymbol\" \"\";");
        if let Some(rate) = self.bit_rate() {
            line!(self, "BA_ \"Baudrate\" {};", u32::from(rate) * 1000);
        }
        for station in &self.database.stations {
            if let Some(full) = &station.name.full {
                line!(self, "BA_ \"SystemNodeLongSymbol\" BU_ {} \"{full}\";", station.name.short);
            }
        }
        for message in &self.database.messages {
            let id = message.id.in_file();
            if let Some(full) = &message.name.full {
                line!(self, "BA_ \"SystemMessageLongSymbol\" BO_ {id} \"{full}\";");
            }
            if let Some(cycle) = message.cycle {
                line!(self, "BA_ \"GenMsgCycleTime\" BO_ {id} {cycle};");
            }
            for (name, full) in
                message.signals.iter().filter_map(|(name, _)| Some((name, name.full.as_ref()?)))
            {
                line!(self, "BA_ \"SystemSignalLongSymbol\" SG_ {id} {} \"{full}\";", name.short);
            }
        }
    }

    /// The bit rate in kbit/s that all nodes state that state one.
    fn bit_rate(&self) -> Option<u16> {
        // a manager without a description uses the network's bit rate, if any
        let stations = self.database.stations.iter().filter(|station| !station.is_counterpart);
        let mut rates = stations.filter_map(|station| station.device.commissioning.as_ref()?.baud_rate);
        let first = rates.next()?;
        rates.all(|rate| rate == first).then_some(first)
    }

    fn values(&mut self) {
        let mut lines = String::new();
        for (message, name, signal) in self.signals().filter(|(.., signal)| !signal.values.is_empty()) {
            let _ = write!(lines, "VAL_ {} {}", message.id.in_file(), name.short);
            for (number, value) in &signal.values {
                let _ = write!(lines, " {number} {}", quoted(value));
            }
            lines.push_str(" ;\r\n");
        }
        for (message, name, signal) in self.signals() {
            let kind = match signal.number {
                NumberFormat::Unsigned | NumberFormat::Signed => continue,
                NumberFormat::Real32 => 1,
                NumberFormat::Real64 => 2,
            };
            let _ = write!(lines, "SIG_VALTYPE_ {} {} : {kind};\r\n", message.id.in_file(), name.short);
        }
        for (message, name, signal) in self.signals() {
            let Some((selector, ranges)) = &signal.mux.within else { continue };
            let Some((selector, _)) = message.signals.get(*selector) else { continue };
            let ranges = ranges.iter().map(|[first, last]| format!("{first}-{last}")).collect::<Vec<_>>();
            let (id, ranges) = (message.id.in_file(), ranges.join(", "));
            let _ = write!(lines, "SG_MUL_VAL_ {id} {} {} {ranges};\r\n", name.short, selector.short);
        }
        self.lines.push_str(&lines);
    }
}

/// A quoted string. For some readers, a quote or a backslash inside ends it.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.trim().chars() {
        match c {
            '"' => quoted.push('\''),
            '\\' => quoted.push('/'),
            'μ' => quoted.push('µ'),
            c if c.is_control() => quoted.push(' '),
            c if u32::from(c) <= 0xFF => quoted.push(c),
            c => quoted.push_str(&transliterate(c).unwrap_or("?").replace('"', "'")),
        }
    }
    quoted.push('"');
    quoted
}

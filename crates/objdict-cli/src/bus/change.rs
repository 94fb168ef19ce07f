//! A change of a node: checked, shown, asked for, made and reported.

use std::collections::BTreeMap;
use std::io::{self, Write};

use objdict_can::{ApplyOptions, ClientError, Danger, WriteResult};
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_model::model::Device;
use objdict_node::download::Download;
use objdict_node::parameter::no_parameter;
use serde::Serialize;

use super::session::BusSession;
use super::values::ValueWords;
use crate::args::{BusChangeArgs, ShowFormat};
use crate::ending::{Failure, Outcome, note};
use crate::stdout::Output;
use crate::table::TextTable;

/// The most characters of a cell.
const CELL: usize = 60;

/// A change of a node.
pub(super) struct Change<'a> {
    pub(super) node_id: u8,
    pub(super) device: &'a Device,
    pub(super) downloads: &'a [Download],
    /// The values before; absent for entries that cannot be read.
    pub(super) present: &'a BTreeMap<(u16, u8), Vec<u8>>,
}

/// What became of a change.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct WritesJson {
    /// The version of the document.
    version: Version<1>,
    /// The node-ID.
    node_id: u8,
    /// Whether nothing was sent but reads.
    is_dry_run: bool,
    /// Why the command ended early.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
    /// The downloads in their order.
    writes: Vec<WriteRow>,
}

/// A download.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Write"))]
struct WriteRow {
    /// The index in hex.
    index: String,
    /// The sub-index in hex.
    sub: String,
    /// The names of the object and the entry.
    name: String,
    /// The value before; absent if it cannot be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    before: Option<String>,
    /// The new value.
    value: String,
    /// What became of it.
    result: WriteWord,
    /// The description of the abort code, or the value that was read back.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

/// What became of a download.
#[derive(Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "WriteResult"))]
enum WriteWord {
    /// Accepted.
    Written,
    /// Accepted, and another value is read back.
    Differs,
    /// Refused by the node.
    Refused,
    /// Not sent.
    Unsent,
}

impl BusSession {
    /// Refuses a node that is another device than the description, or must not be changed.
    pub(super) fn require_safe(
        &mut self,
        node_id: u8,
        device: &Device,
        is_configured: bool,
        args: &BusChangeArgs,
    ) -> Result<(), Failure> {
        if self.client.has_master() && !self.client.states().is_empty() && is_configured && !args.force {
            let failure = Failure::new("a different NMT or LSS master is active on this bus");
            return Err(failure.help("stop it, or pass `--force`"));
        }
        let other = self.client.other_identity(node_id, device)?;
        if let Some(other) = other.filter(|_| !args.force) {
            let failure = Failure::new(format_args!("node {node_id} is not the described device: {other}"));
            return Err(failure.help("name the right description with `--with`; `--force` uses this one"));
        }
        let dangers = self.client.dangers(node_id, device)?;
        let is_refused = |danger: &&Danger| !danger.can_be_forced() || is_configured && !args.force;
        match dangers.iter().find(is_refused) {
            Some(danger @ Danger::Safety) => {
                let failure = Failure::new(format_args!("node {node_id} is not written: {danger}"));
                Err(failure.help("use the tool of its vendor"))
            }
            Some(danger) => {
                let failure = Failure::new(format_args!("node {node_id} is not configured: {danger}"));
                Err(failure.help(format!("stop the machine, then `objdict bus nmt pre-operational {node_id}`; `--force` does it anyway")))
            }
            None => Ok(()),
        }
    }

    /// Lets a node store its parameters.
    pub(super) fn store(&mut self, node_id: u8) -> Result<(), Failure> {
        self.client.download(node_id, 0x1010, 1, b"save")?;
        note(&format!("note: node {node_id} has stored its parameters\n"));
        Ok(())
    }
}

/// Entries as `1017:00, 2003:01`.
pub(super) fn entries(entries: &[(u16, u8)]) -> String {
    let names: Vec<String> = entries.iter().map(|(index, sub)| format!("{index:04X}:{sub:02X}")).collect();
    names.join(", ")
}

/// Reports the entries that an undo omits.
pub(super) fn tell_lost(lost: &[(u16, u8)]) {
    if !lost.is_empty() {
        let lost = entries(lost);
        note(&format!("note: cannot be undone, because their values before are not known: {lost}\n"));
    }
}

/// Refuses downloads to entries that are no parameters.
pub(super) fn require_parameters(
    device: &Device,
    downloads: &[Download],
    args: &BusChangeArgs,
) -> Result<(), Failure> {
    let other = downloads.iter().find_map(|download| {
        no_parameter(device, download.index, download.sub).map(|reason| (download, reason))
    });
    match other.filter(|_| !args.force) {
        Some((Download { index, sub, .. }, reason)) => {
            let failure = Failure::new(format_args!("{index:04X}h sub-index {sub} is not written: {reason}"));
            Err(failure.help("`--force` writes process data and commands; make sure that nothing can move"))
        }
        None => Ok(()),
    }
}

impl Change<'_> {
    /// Shows what is to be written: present and new values.
    pub(super) fn show(&self, format: ShowFormat, out: &mut Output) -> io::Result<()> {
        if format == ShowFormat::Json {
            return Ok(());
        }
        let words = ValueWords::new(self.device, self.node_id);
        let mut table = TextTable::new(["", "Entry", "Name", "Present", "New"], CELL);
        for (at, download) in self.downloads.iter().enumerate() {
            let entry = download.entry();
            let present =
                self.present.get(&entry).map_or_else(|| "?".to_owned(), |bytes| words.text(entry, bytes));
            table.row([
                (at + 1).to_string(),
                format!("{:04X}:{:02X}", entry.0, entry.1),
                words.name(entry),
                present,
                words.text(entry, &download.data),
            ]);
        }
        table.write(out)?;
        // a question follows on another stream
        out.flush()
    }

    /// Makes the downloads.
    pub(super) fn make(
        &self,
        session: &mut BusSession,
        options: ApplyOptions,
    ) -> (Vec<WriteResult>, Option<ClientError>) {
        session.client.apply(self.node_id, self.downloads, options)
    }

    /// Reports what became of the downloads from `first` on, counted from 0.
    pub(super) fn report(
        &self,
        (results, error): (&[WriteResult], Option<&ClientError>),
        first: usize,
        format: ShowFormat,
        out: &mut Output,
    ) -> io::Result<Outcome> {
        match format {
            ShowFormat::Json => out.json(&self.json(results, error, false))?,
            ShowFormat::Table => self.write_results(results, out)?,
        }
        let is_clean = results.iter().skip(first).all(|result| *result == WriteResult::Written);
        Ok(if is_clean { Outcome::Clean } else { Outcome::Findings })
    }

    fn write_results(&self, results: &[WriteResult], out: &mut Output) -> io::Result<()> {
        let words = ValueWords::new(self.device, self.node_id);
        for (download, result) in self.downloads.iter().zip(results) {
            let entry = download.entry();
            let name = words.name(entry);
            let place = format!("{:04X}:{:02X} {name}", entry.0, entry.1);
            match result {
                WriteResult::Refused(abort) => writeln!(out, "{place}: refused: {abort}")?,
                WriteResult::Differs(bytes) => {
                    let (new, read) = (words.text(entry, &download.data), words.text(entry, bytes));
                    writeln!(out, "{place}: wrote {new}, read back {read}")?;
                }
                _ => {}
            }
        }
        let count =
            |is_meant: fn(&WriteResult) -> bool| results.iter().filter(|result| is_meant(result)).count();
        let written = count(|result| matches!(result, WriteResult::Written | WriteResult::Differs(_)));
        let refused = count(|result| matches!(result, WriteResult::Refused(_)));
        let unsent = count(|result| *result == WriteResult::Unsent);
        let mut line =
            format!("node {}: {} of {} written", self.node_id, written, plural(results.len(), "value"));
        for (count, what) in [(refused, "refused"), (unsent, "not sent")] {
            if count > 0 {
                line += &format!(", {count} {what}");
            }
        }
        out.summary(line)
    }

    /// Reports that nothing was sent.
    pub(super) fn leave(&self, format: ShowFormat, out: &mut Output) -> io::Result<Outcome> {
        if format == ShowFormat::Json {
            out.json(&self.json(&vec![WriteResult::Unsent; self.downloads.len()], None, true))?;
        }
        Ok(Outcome::Clean)
    }

    fn json(&self, results: &[WriteResult], error: Option<&ClientError>, is_dry_run: bool) -> WritesJson {
        let words = ValueWords::new(self.device, self.node_id);
        let row = |(download, result): (&Download, &WriteResult)| {
            let entry = download.entry();
            let (result, reason) = match result {
                WriteResult::Refused(abort) => (WriteWord::Refused, Some(abort.to_string())),
                WriteResult::Differs(bytes) => (WriteWord::Differs, Some(words.text(entry, bytes))),
                WriteResult::Written => (WriteWord::Written, None),
                _ => (WriteWord::Unsent, None),
            };
            WriteRow {
                index: format!("{:04X}", entry.0),
                sub: format!("{:02X}", entry.1),
                name: words.name(entry),
                before: self.present.get(&entry).map(|bytes| words.text(entry, bytes)),
                value: words.text(entry, &download.data),
                result,
                reason,
            }
        };
        let writes = self.downloads.iter().zip(results).map(row).collect();
        let error = error.map(ToString::to_string);
        WritesJson { version: Version, node_id: self.node_id, is_dry_run, error, writes }
    }
}

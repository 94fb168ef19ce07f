//! A node during the generation of its downloads.

use std::collections::BTreeMap;

use super::{INVALID_VALUE, MISSING_ENTRY, missing};
use crate::compiled::DcfgenMode;
use crate::compiled::Origins;
use crate::configure::{Setting, configure};
use crate::diagnostic::{At, Diagnostic, Findings, Severity, say};
use crate::download::{Beyond, Download, beyond, bytes_of, transferred_type};
use crate::effective::before;
use crate::literal::{self, NoValue};
use crate::model::{Access, Address, Assignment, DataType, Device, Field, Object, Place, Value, hex};
use crate::network::{Node, Said};
use crate::origin::because;
use crate::rules::{CONTRADICTION, INVALID_SETTING, READ_ONLY_ENTRY};
use crate::source::Span;

/// The part of a network file that sets the value of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum FilePart {
    /// An implied setting, from a key such as `watches`.
    Implied,
    /// A key, or a link.
    Key,
    /// `set`.
    Setting,
    /// The list of downloads at the end.
    Download,
}

/// The last value that each part assigns to an entry, and its position.
type WrittenValues = BTreeMap<FilePart, (Span, Vec<u8>)>;

/// A node, its downloads so far, and their problems.
pub(super) struct Compiler<'n, 'f> {
    pub(super) node: &'n Node,
    /// The node after the downloads so far.
    pub(super) device: Device,
    /// The part that is currently written.
    pub(super) part: FilePart,
    /// The values written to each entry.
    written: BTreeMap<(u16, u8), WrittenValues>,
    pub(super) origins: Origins,
    /// The positions of overridden values in the network file, by index.
    pub(super) former: Vec<(u16, Span)>,
    /// The position of the node in the network.
    pub(super) position: usize,
    pub(super) node_id: u8,
    pub(super) mode: DcfgenMode,
    pub(super) downloads: Vec<Download>,
    pub(super) findings: &'f mut Findings,
}

impl<'n, 'f> Compiler<'n, 'f> {
    pub(super) fn new(
        (position, node): (usize, &'n Node),
        node_id: u8,
        mode: DcfgenMode,
        findings: &'f mut Findings,
    ) -> Self {
        Self {
            node,
            device: before(node, node_id),
            part: FilePart::Key,
            written: BTreeMap::new(),
            origins: Origins::new(),
            former: Vec::new(),
            position,
            node_id,
            mode,
            downloads: Vec::new(),
            findings,
        }
    }

    /// A place in the description of the node.
    pub(super) fn place(&self, place: Place) -> At {
        At::Node(self.position, place)
    }

    /// Reports a problem caused by a field of an entry in the description.
    pub(super) fn report(&mut self, finding: Diagnostic, at: Address, field: Field) {
        let place = self.node.device.entry_place(at.index, at.sub.unwrap_or(0)).field(field);
        self.findings.push(because(finding, self.position, place));
    }

    /// The place of an entry's value in the description; `None` if a download so far replaces it.
    pub(super) fn origin(&self, index: u16, sub: u8) -> Option<At> {
        self.node.origin(self.position, &self.origins, (index, sub))
    }

    /// Whether the node has the entry.
    pub(super) fn has(&self, at: Address) -> bool {
        self.node.device.entry(at.index, at.sub.unwrap_or(0)).is_some()
    }

    /// The number in an entry after the downloads so far (for dcfgen, before all of them); 0 if it is not
    /// stated.
    pub(super) fn present(&self, index: u16, sub: u8) -> i128 {
        self.number(self.object(index), sub)
    }

    /// The object after the downloads so far (for dcfgen, before all of them).
    pub(super) fn object(&self, index: u16) -> Option<&Object> {
        if self.mode == DcfgenMode::Exact { &self.node.device } else { &self.device }.object(index)
    }

    /// The number in an entry of an object; 0 if it is not stated.
    pub(super) fn number(&self, object: Option<&Object>, sub: u8) -> i128 {
        let value = object.and_then(|object| object.value(sub));
        value.and_then(|value| value.integer_for(self.node_id)).unwrap_or(0)
    }

    /// The position of an object's current value in the network file.
    pub(super) fn said(&self, index: u16) -> Option<Span> {
        self.origins.get(&(index, 0)).copied()
    }

    /// The final producer heartbeat time in milliseconds; 0: none.
    pub(super) fn heartbeat(&self) -> u16 {
        // dcfgen has the manager wait for the heartbeat of a node that cannot send one
        let request = self.node.heartbeat.producer.filter(|_| self.mode == DcfgenMode::Exact);
        request.map_or_else(|| u16::try_from(self.present(0x1017, 0)).unwrap_or(0), |request| request.value)
    }

    /// COB-ID of EMCY (1014h), unless it is not valid.
    pub(super) fn emcy(&self) -> Option<u32> {
        let is_strict = self.mode == DcfgenMode::Exact;
        let stated = self.object(0x1014)?.value(0).and_then(|value| value.integer_for(self.node_id));
        let number = match stated {
            Some(number) => u32::try_from(number).ok()?,
            None if is_strict => 0,
            None => return None,
        };
        (number >> 31 == 0).then_some(number)
    }

    /// Writes an entry unless it already has the value; a missing service remains disabled.
    pub(super) fn change(&mut self, at: Address, number: i128, said: Span) {
        if self.has(at) && self.present(at.index, at.sub.unwrap_or(0)) == number {
            return;
        }
        self.write(at, number, said, Severity::Warning);
    }

    /// Writes a number to an entry. A node without it is a finding of this severity.
    pub(super) fn write(&mut self, at: Address, number: i128, said: Span, if_missing: Severity) {
        if !self.exists(at, said, if_missing) {
            return;
        }
        let sub = at.sub.unwrap_or(0);
        let data_type = transferred_type(&self.node.device, at.index, sub);
        let value = match data_type {
            // a whole number is exact up to 2^53
            Some(data_type) => {
                real(number as f64, data_type).or_else(|| Value::from_integer(number, data_type))
            }
            None => None,
        };
        match value {
            Some(value) => self.write_value(at, &value, said),
            None => self.invalid(at, &number.to_string(), said),
        }
    }

    /// Writes a number with a fraction, which dcfgen truncates.
    pub(super) fn write_real(&mut self, at: Address, number: f64, said: Span) {
        let data_type = transferred_type(&self.node.device, at.index, at.sub.unwrap_or(0));
        let value = data_type.and_then(|data_type| real(number, data_type));
        if let (Some(value), DcfgenMode::Corrected) = (&value, self.mode) {
            return self.write_value(at, value, said);
        }
        let whole = number.trunc() as i128;
        if value.is_none() && self.has(at) {
            let message = say!(
                "{:04X}h:{:02X} accepts only whole numbers, so `{}` becomes {}",
                at.index,
                at.sub.unwrap_or(0),
                number,
                whole
            );
            let finding = Diagnostic::new(&INVALID_VALUE, said, message).understood();
            let finding = finding.help("write a whole number in the unit of the entry");
            self.report(finding, at, Field::DataType);
        }
        self.write(at, whole, said, Severity::Error);
    }

    /// Writes a string, spelled as in a DCF.
    pub(super) fn write_text(&mut self, at: Address, text: &str, said: Span) {
        if !self.exists(at, said, Severity::Error) {
            return;
        }
        let data_type = transferred_type(&self.node.device, at.index, at.sub.unwrap_or(0));
        match data_type.map(|data_type| literal::written(text, data_type)) {
            Some(Ok(value)) => self.write_value(at, &value, said),
            Some(Err(NoValue { message, help: Some(help) })) => {
                let message = format!("{:04X}h:{:02X}: {message}", at.index, at.sub.unwrap_or(0));
                let finding = Diagnostic::new(&INVALID_VALUE, said, message).help(help);
                self.report(finding, at, Field::DataType);
            }
            _ => self.invalid(at, text, said),
        }
    }

    /// Writes a value to an entry.
    fn write_value(&mut self, at: Address, value: &Value, said: Span) {
        if !self.exists(at, said, Severity::Error) {
            return;
        }
        let sub = at.sub.unwrap_or(0);
        let Ok(data) = bytes_of(&self.node.device, at.index, sub, value, Some(self.node_id)) else {
            return self.invalid(at, &value.to_string(), said);
        };
        self.check(at, value, said);
        let parts = self.written.entry((at.index, sub)).or_default();
        parts.insert(self.part, (said, data.clone()));
        let former = self.origins.insert((at.index, sub), said).filter(|former| *former != said);
        self.former.extend(former.map(|former| (at.index, former)));
        let download = Download::new(at.index, sub, data);
        self.device.assign(download.assignment(&self.device).as_slice());
        self.downloads.push(download);
    }

    /// Reports entries that a key and a setting or download set to different values.
    pub(super) fn contradictions(&mut self) {
        for ((index, sub), parts) in std::mem::take(&mut self.written) {
            let mut parts = parts.into_iter();
            let Some((_, (first, wanted))) = parts.next() else { continue };
            // the SYNC period implies that the node sends SYNC, but no CAN-ID
            let is_sender = |data: &[u8]| data.last().is_some_and(|byte| byte & 0x40 != 0);
            let are_same =
                |data: &[u8]| *data == *wanted || index == 0x1005 && is_sender(data) && is_sender(&wanted);
            for (part, (said, data)) in parts.filter(|(_, (_, data))| !are_same(data)) {
                let shown = |data: &[u8]| match Download::new(index, sub, data).value(&self.device) {
                    // COB-IDs and mapped entries
                    Some(Value::Unsigned(number)) if data.len() == 4 => format!("{number:X}h"),
                    Some(value) => value.to_string(),
                    None => hex::print(data).to_string(),
                };
                let (is, wanted) = (shown(&data), shown(&wanted));
                let name = &self.node.name.value;
                let message =
                    say!("{:04X}h:{:02X} of `{}` is set to {}, but also to {}", index, sub, name, is, wanted);
                let finding = Diagnostic::new(&CONTRADICTION, said, message)
                    .label(first, "the other value")
                    .help("remove one of the two");
                // a download at the end intentionally overrides all others
                let severity = if part == FilePart::Download { Severity::Warning } else { Severity::Error };
                self.findings.push(finding.severity(severity).understood());
            }
        }
    }

    /// Applies the downloads in the manager's description, which the network file need not repeat.
    pub(super) fn take_stored(&mut self) {
        for download in self.node.stored.iter().flat_map(|stored| &stored.downloads.0) {
            let Some(assignment) = download.assignment(&self.device) else { continue };
            let present = bytes_of_present(&self.device, download, self.node_id);
            if present.as_ref() != Some(&download.data) {
                self.origins.insert(download.entry(), self.node.name.at);
            }
            self.device.assign(&[assignment]);
        }
    }

    /// Applies a setting like `objdict configure`.
    pub(super) fn set(&mut self, setting: &Said<Setting>) {
        match configure(&self.device, self.node_id, std::slice::from_ref(&setting.value)) {
            Ok(values) => {
                for Assignment { index, sub, value } in values {
                    self.write_value(Address { index, sub: Some(sub) }, &value, setting.at);
                }
            }
            Err(problems) => {
                for problem in problems {
                    let message = format!("`{}`: {}", self.node.name.value, problem.message);
                    let help = problem.help.unwrap_or_else(|| "correct the setting".to_owned());
                    let finding = Diagnostic::new(&INVALID_SETTING, setting.at, message).help(help);
                    self.findings.push(because(finding, self.position, problem.place));
                }
            }
        }
    }

    /// Whether the node has the entry; if not, that is reported.
    fn exists(&mut self, at: Address, said: Span, severity: Severity) -> bool {
        let exists = self.has(at);
        if !exists {
            let finding = Diagnostic::new(&MISSING_ENTRY, said, missing(self.node, at)).severity(severity);
            let finding = finding.help("remove the setting, or correct index and sub-index");
            self.findings.push(because(finding, self.position, Place::object(at.index)));
        }
        exists
    }

    /// Whether the node has the entry and rejects writing it.
    pub(super) fn is_constant(&self, at: Address) -> bool {
        let entry = self.node.device.entry(at.index, at.sub.unwrap_or(0));
        entry.and_then(|entry| entry.implied_access()).is_some_and(|access| !access.is_writable())
    }

    /// Reports values that can be sent but that the node rejects.
    fn check(&mut self, at: Address, value: &Value, said: Span) {
        let sub = at.sub.unwrap_or(0);
        let Some(entry) = self.node.device.entry(at.index, sub) else { return };
        let access = entry.implied_access().filter(|access: &Access| !access.is_writable());
        // PDOs write some entries twice
        if let Some(access) =
            access.filter(|_| self.downloads.iter().all(|other| other.entry() != (at.index, sub)))
        {
            let message = say!("{:04X}h:{:02X} of `{}` is `{}`", at.index, sub, self.node.name.value, access);
            let finding = Diagnostic::new(&READ_ONLY_ENTRY, said, message).understood();
            let finding = finding.help("remove the setting, or set a different entry");
            self.report(finding, at, Field::AccessType);
        }
        let Some(limit) = beyond(&entry, value, Some(self.node_id)) else { return };
        let (side, limit, field) = match limit {
            Beyond::Low(limit) => ("below the low", limit, Field::LowLimit),
            Beyond::High(limit) => ("above the high", limit, Field::HighLimit),
        };
        let message = say!("{} is {} limit {} of {:04X}h:{:02X}", value, side, limit, at.index, sub);
        let finding = Diagnostic::new(&INVALID_VALUE, said, message).understood();
        self.report(finding.help("write a value inside the limits of the entry"), at, field);
    }

    fn invalid(&mut self, at: Address, value: &str, said: Span) {
        let sub = at.sub.unwrap_or(0);
        let data_type = transferred_type(&self.node.device, at.index, sub);
        let finding = match data_type {
            Some(data_type) => {
                let message =
                    say!("`{}` is not a valid {} for {:04X}h:{:02X}", value, data_type, at.index, sub);
                Diagnostic::new(&INVALID_VALUE, said, message)
                    .help("write a value of the data type of the entry")
            }
            None => {
                let message = say!("the data type of {:04X}h:{:02X} is unknown", at.index, sub);
                Diagnostic::new(&INVALID_VALUE, said, message)
                    .help("correct the description; `objdict check` shows where")
            }
        };
        self.report(finding, at, Field::DataType);
    }
}

/// The bytes of a download's entry before the download.
fn bytes_of_present(device: &Device, download: &Download, node_id: u8) -> Option<Vec<u8>> {
    let value = device.object(download.index)?.value(download.sub)?.into_owned();
    bytes_of(device, download.index, download.sub, &value, Some(node_id)).ok()
}

/// A number as a value of REAL32 or REAL64; `None` for other data types.
fn real(number: f64, data_type: DataType) -> Option<Value> {
    match data_type {
        DataType::REAL32 => Some(Value::Real32(number as f32)),
        DataType::REAL64 => Some(Value::Real64(number)),
        _ => None,
    }
}

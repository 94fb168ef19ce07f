//! INI files: EDS, DCF and node lists of CANopen, and the EDS of CIP.

use std::borrow::Cow;

use super::{ContentKind, ExaminedContent, Identification, list, quoted};
use crate::Format;
use objdict_eds::eds::SectionName;
use objdict_eds::ini::{LineKind, Lines};
use objdict_model::literal::{self, Quirks};
use objdict_model::model::Part;

/// Sections that a reason names.
const NAMED: usize = 3;

/// The number of bytes after the start of a section that are searched for its keys.
const SECTION: usize = 1 << 12;

/// The evidence in the sections of a file.
#[derive(Default)]
struct IniSigns<'a> {
    /// Section names that are specific to an EDS or DCF.
    canopen: Vec<&'a str>,
    /// The section of the node, as spelled in the file.
    commissioning: Option<&'a str>,
    version: Option<&'a str>,
    node_id: Option<&'a str>,
    topology: Option<&'a str>,
    /// The first CIP key in each of its sections.
    cip: Vec<(&'static str, &'static str)>,
    /// `Class1` of a CIP device.
    class: Option<&'a str>,
    /// `[IO_Info]`, which only the EDS of DeviceNet contains.
    io_info: bool,
    /// Whether the current section has keys that are evidence.
    is_telling: bool,
}

/// Sections with keys that are evidence, apart from the section of the node.
const TELLING: [&str; 4] = ["FileInfo", "File", "Device", "Device Classification"];

pub(super) fn identify(content: &ExaminedContent<'_>) -> Option<Identification> {
    let mut signs = IniSigns::of(&content.head);
    let node = if signs.commissioning.is_none() { commissioning_behind(content) } else { None };
    if let Some(node) = &node {
        let late = IniSigns::of(node);
        signs.commissioning = late.commissioning;
        signs.node_id = late.node_id;
    }
    if !signs.canopen.is_empty() {
        return Some(if is_powerlink(content) { powerlink() } else { signs.description(content) });
    }
    if let Some(topology) = signs.topology {
        let reason = format!("it has a section `[{}]`", quoted(topology));
        return Some(Identification::new(ContentKind::NodeList, reason));
    }
    if signs.cip.len() < 2 {
        return None;
    }
    let technology = Some(signs.cip_technology().to_owned());
    let keys: Vec<String> =
        signs.cip.iter().map(|(section, key)| format!("`{key}` in `[{section}]`")).collect();
    let reason = format!("it has {}", list(&keys));
    Some(Identification { technology, ..Identification::new(ContentKind::CipEds, reason) })
}

/// Objects that each node of Ethernet POWERLINK has: its node-ID and its timing. CiA 302 ends at 1F91h.
const POWERLINK: [&str; 2] = ["[1F93]", "[1F98]"];

fn is_powerlink(content: &ExaminedContent<'_>) -> bool {
    POWERLINK.iter().all(|section| line_starts(content.bytes, section).next().is_some())
}

fn powerlink() -> Identification {
    let [node_id, timing] = POWERLINK;
    let reason = format!("only Ethernet POWERLINK has objects in `{node_id}` and `{timing}`");
    let technology = Some("Ethernet POWERLINK".to_owned());
    Identification { technology, ..Identification::new(ContentKind::PowerlinkEds, reason) }
}

/// The positions at which lines start with a string.
fn line_starts<'a>(bytes: &'a [u8], text: &'a str) -> impl Iterator<Item = usize> + 'a {
    memchr::memmem::find_iter(bytes, text)
        .filter(|&at| matches!(bytes[..at].last(), None | Some(b'\n' | b'\r')))
}

/// The node section after the first objects: it may be the last in the file.
fn commissioning_behind<'a>(content: &'a ExaminedContent<'_>) -> Option<Cow<'a, str>> {
    // both spellings start with this, so searching a large file once is enough
    let start = line_starts(content.bytes, "[DeviceCom").find(|&at| {
        let rest = &content.bytes[at..];
        rest.starts_with(b"[DeviceComissioning]") || rest.starts_with(b"[DeviceCommissioning]")
    })?;
    let rest = &content.bytes[start..];
    Some(String::from_utf8_lossy(&rest[..rest.len().min(SECTION)]))
}

impl<'a> IniSigns<'a> {
    /// Reads only the text before the first object.
    fn of(text: &'a str) -> Self {
        let mut signs = Self::default();
        let mut section = "";
        for line in Lines::new(text) {
            match line.kind {
                // `[[link]]` of TOML is no section
                LineKind::Section { name } if name.of(text).starts_with('[') => signs.is_telling = false,
                LineKind::Section { name } => {
                    section = name.of(text);
                    if signs.section(section) {
                        break;
                    }
                }
                LineKind::Entry { key, value } => signs.entry(section, key.of(text), value.of(text)),
                _ => {}
            }
        }
        signs
    }

    /// Records a section, and returns whether it belongs to an object.
    fn section(&mut self, name: &'a str) -> bool {
        self.is_telling = TELLING.iter().any(|telling| telling.eq_ignore_ascii_case(name));
        match SectionName::parse(name).part {
            Part::Commissioning => {
                self.is_telling = true;
                self.commissioning.get_or_insert(name);
                self.canopen.push(name);
            }
            Part::FileInfo | Part::DeviceInfo | Part::DummyUsage | Part::List(_) => self.canopen.push(name),
            // any file may have `[A0]`
            Part::Object(_) | Part::Entry(..) if name.len() >= 4 => {
                self.canopen.push(name);
                return true;
            }
            _ if is_topology(name) => {
                self.topology.get_or_insert(name);
            }
            _ => self.io_info |= name.eq_ignore_ascii_case("IO_Info"),
        }
        false
    }

    fn entry(&mut self, section: &str, key: &'a str, value: &'a str) {
        if !self.is_telling {
            return;
        }
        let is = |(a, b): (&str, &str)| section.eq_ignore_ascii_case(a) && key.eq_ignore_ascii_case(b);
        if is(("FileInfo", "EDSVersion")) {
            self.version.get_or_insert(value);
        } else if self.commissioning.is_some_and(|name| is((name, "NodeID"))) {
            self.node_id.get_or_insert(value);
        } else if is(("Device Classification", "Class1")) {
            self.class.get_or_insert(value);
        }
        let cip = [
            ("File", "DescText"),
            ("File", "HomeURL"),
            ("File", "CreateDate"),
            ("Device", "VendCode"),
            ("Device", "VendName"),
            ("Device", "ProdType"),
            ("Device", "ProdCode"),
            ("Device", "ProdName"),
            ("Device Classification", "Class1"),
        ];
        let found = cip.into_iter().find(|&pair| is(pair));
        self.cip.extend(found.filter(|(section, _)| self.cip.iter().all(|(known, _)| known != section)));
    }

    /// An EDS or a DCF. They have the same sections, so the file extension decides if it is one of the two.
    fn description(&self, content: &ExaminedContent<'_>) -> Identification {
        let commissioning = self.commissioning;
        let mut sections: Vec<String> = Vec::new();
        let others = self.canopen.iter().filter(|name| SectionName::parse(name).part != Part::Commissioning);
        let rooms = NAMED - usize::from(commissioning.is_some());
        for section in others.copied().take(rooms).chain(commissioning) {
            sections.push(format!("`[{}]`", quoted(section)));
        }
        let (kind, but) = match (Format::from_name(content.name), commissioning) {
            (Some(Format::Dcf), Some(_)) => (ContentKind::Dcf, ""),
            (Some(Format::Dcf), None) => {
                (ContentKind::Dcf, "; no `[DeviceComissioning]`, but the name suggests DCF")
            }
            (Some(Format::Eds), Some(_)) => (ContentKind::Eds, ", as in a DCF, but the name suggests EDS"),
            (_, Some(_)) => (ContentKind::Dcf, ""),
            (_, None) => (ContentKind::Eds, ""),
        };
        let noun = if sections.len() == 1 { "section" } else { "sections" };
        let reason = format!("it has the {noun} {}{but}", list(&sections));
        let number = |text: &str| literal::integer_in_line(text, 1, 127, &mut Quirks::default()).ok();
        Identification {
            version: self.version.map(quoted).filter(|version| !version.is_empty()),
            node_id: self.node_id.and_then(number).and_then(|id| u8::try_from(id).ok()),
            ..Identification::new(kind, reason)
        }
    }

    /// The network of the CIP family, if stated in the file.
    fn cip_technology(&self) -> &'static str {
        let class = self.class.unwrap_or_default().to_ascii_lowercase();
        let networks = [
            ("ethernet", "EtherNet/IP"),
            ("devicenet", "DeviceNet"),
            ("controlnet", "ControlNet"),
            ("componet", "CompoNet"),
        ];
        match networks.into_iter().find(|(word, _)| class.contains(word)) {
            Some((_, name)) => name,
            None if self.io_info => "DeviceNet",
            None => "CIP (DeviceNet, EtherNet/IP, ControlNet)",
        }
    }
}

/// Whether a text may be a node list: the name of a section begins like that of the nodes.
pub(super) fn has_topology(text: &str) -> bool {
    let is_blank = |c: char| c.is_whitespace() || matches!(c, '\0' | '\u{1A}');
    let is_meant = |section: &str| section.trim_start_matches(is_blank).get(..8).is_some_and(is_topology);
    memchr::memchr_iter(b'[', text.as_bytes()).any(|at| is_meant(&text[at + 1..]))
}

/// `Topology`, `Topology2` …
pub(crate) fn is_topology(name: &str) -> bool {
    let number = name.get(.."Topology".len()).filter(|word| word.eq_ignore_ascii_case("Topology"));
    number.is_some_and(|word| name[word.len()..].bytes().all(|byte| byte.is_ascii_digit()))
}

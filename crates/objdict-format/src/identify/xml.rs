//! XML: the root element, its namespace, and the technology in a profile.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::{ContentKind, ExaminedContent, Identification, quoted};

/// The element that contains the profiles of an XDD.
const CONTAINER: &str = "ISO15745ProfileContainer";

impl ExaminedContent<'_> {
    /// Whether the content contains a word.
    fn contains(&self, word: &str) -> bool {
        self.find(word).is_some()
    }

    fn find(&self, word: &str) -> Option<usize> {
        memchr::memmem::find(self.bytes, word.as_bytes())
    }
}

/// The evidence in an XML file.
#[derive(Default)]
struct XmlSigns {
    root: Option<Root>,
    /// The first text of an element `ProfileTechnology`.
    technology: Option<String>,
    /// The type of the first profile body, without its prefix.
    body: Option<String>,
    /// The name that the file had when it was written.
    file_name: Option<String>,
    /// The first namespace of a container in a network.
    inner_namespace: Option<String>,
}

struct Root {
    name: String,
    namespace: Option<String>,
    version: Option<String>,
    location: Option<String>,
}

/// Identifies a text that starts like XML.
pub(super) fn identify(content: &ExaminedContent<'_>, text: &str) -> Option<Identification> {
    let is_start = |c: char| c.is_alphabetic() || matches!(c, '_' | '?' | '!');
    if !text.strip_prefix('<')?.starts_with(is_start) {
        return None;
    }
    let signs = XmlSigns::of(text);
    let Some(root) = &signs.root else {
        // a malformed XDD must be checked, not rejected
        let is_named = known_ending(content.name).is_some();
        let kind = if is_named { ContentKind::Unknown } else { ContentKind::OtherXml };
        return Some(Identification::new(kind, "it starts like XML and has no root element"));
    };
    let found = signs.identified(content, root);
    let namespace = root.namespace.clone().or(signs.inner_namespace);
    Some(Identification { namespace, ..found })
}

/// XML that does not start at the beginning of the text, for example after the messages of a tool.
pub(super) fn behind_junk(content: &ExaminedContent<'_>) -> Option<Identification> {
    let declaration = content.head.find("<?xml");
    let start = declaration.or_else(|| content.head.find(&format!("<{CONTAINER}")))?;
    identify(content, &content.head[start..]).filter(|found| found.kind != ContentKind::OtherXml)
}

impl XmlSigns {
    /// Reads until all is known, the text ends, or it is too malformed to continue.
    fn of(text: &str) -> Self {
        let mut signs = Self::default();
        let mut reader = Reader::from_str(text);
        let config = reader.config_mut();
        config.check_end_names = false;
        config.allow_unmatched_ends = true;
        config.allow_dangling_amp = true;
        let mut in_technology = false;
        while let Ok(event) = reader.read_event() {
            match event {
                Event::Eof => break,
                Event::Start(element) => {
                    in_technology = element.local_name().as_ref() == "ProfileTechnology";
                    signs.element(&element);
                }
                Event::Empty(element) => signs.element(&element),
                Event::Text(text) if in_technology && signs.technology.is_none() => {
                    signs.technology = Some(quoted(&text.into_inner())).filter(|text| !text.is_empty());
                }
                Event::End(_) => in_technology = false,
                _ => {}
            }
            if signs.technology.is_some() && signs.body.is_some() {
                break;
            }
        }
        signs
    }

    fn element(&mut self, element: &BytesStart<'_>) {
        let name = element.local_name();
        let name = name.as_ref();
        if self.root.is_none() {
            self.root = Some(Root::of(element));
        }
        if name == CONTAINER && self.inner_namespace.is_none() {
            self.inner_namespace = namespace(element);
        }
        if name == "ProfileBody" {
            let kind =
                attribute(element, "type").map(|text| text.rsplit(':').next().unwrap_or(&text).to_owned());
            self.body = self.body.take().or(kind);
            self.file_name = self.file_name.take().or_else(|| attribute(element, "fileName"));
        }
    }

    fn identified(&self, content: &ExaminedContent<'_>, root: &Root) -> Identification {
        let reason = root.reason();
        match root.name.as_str() {
            CONTAINER | "ISO15745Profile" => self.profile(content, root),
            "EtherCATInfo" => foreign(ContentKind::EthercatEsi, "EtherCAT", reason),
            "IODevice" => foreign(ContentKind::Iodd, "IO-Link", reason),
            name if is_network(name) => network(content, root, reason),
            "device" if content.contains("<CANopenObjectList") => Identification::new(
                ContentKind::CanopenNodeProject,
                format!("{reason} and has `CANopenObjectList`"),
            ),
            "PyObject" if content.contains("\"Dictionary\"") => Identification::new(
                ContentKind::ObjdictgenProject,
                format!("{reason} and has a `Dictionary`"),
            ),
            _ => Identification::new(ContentKind::OtherXml, reason),
        }
    }

    /// A profile by ISO 15745: its technology decides.
    fn profile(&self, content: &ExaminedContent<'_>, root: &Root) -> Identification {
        let namespace = letters(root.namespace.as_deref().unwrap_or_default());
        let technology = self.technology.as_deref().unwrap_or_default();
        let body = self.body.as_deref().unwrap_or_default();
        let says = |word: &str| {
            [&namespace, &letters(technology), &letters(body)].iter().any(|text| text.contains(word))
        };
        let mut reason = root.reason();
        let word =
            ["powerlink", "canopenfd", "gsdml", "profinet", "canopen"].into_iter().find(|word| says(word));
        if !word.is_some_and(|word| namespace.contains(word)) {
            match (technology, body) {
                ("", "") => {}
                ("", body) => reason.push_str(&format!(", with a profile body of the type `{body}`")),
                (technology, _) => reason.push_str(&format!(", and `ProfileTechnology` is `{technology}`")),
            }
        }
        match word {
            Some("powerlink") => {
                let is_xdc = self.configured(content).is_some();
                let kind = if is_xdc { ContentKind::PowerlinkXdc } else { ContentKind::PowerlinkXdd };
                foreign(kind, "Ethernet POWERLINK", reason)
            }
            Some("canopenfd") => foreign(ContentKind::CanopenFdXdd, "CANopen FD", reason),
            Some("gsdml" | "profinet") => foreign(ContentKind::Gsdml, "PROFINET", reason),
            Some(_) => self.canopen(content, root, reason),
            None if !technology.is_empty() => foreign(ContentKind::OtherProfile, technology, reason),
            None if content.contains("CANopenObject") => {
                self.canopen(content, root, format!("{reason}, with `CANopenObject`"))
            }
            None if known_ending(content.name).is_some() => {
                self.canopen(content, root, format!("{reason}, and the name is one of CANopen"))
            }
            None => {
                Identification::new(ContentKind::OtherXml, format!("{reason}, which specifies no technology"))
            }
        }
    }

    fn canopen(&self, content: &ExaminedContent<'_>, root: &Root, mut reason: String) -> Identification {
        let version = root
            .namespace
            .as_deref()
            .and_then(|uri| uri.rsplit_once("/xml/"))
            .map(|(_, version)| quoted(version));
        let is_profile = match known_ending(content.name) {
            Some(ending) => ending == "xpd",
            None => self.file_name.as_deref().and_then(known_ending) == Some("xpd"),
        };
        let kind = if is_profile {
            reason.push_str("; the name suggests a profile database");
            ContentKind::Xpd
        } else if let Some(sign) = self.configured(content) {
            reason.push_str(sign);
            ContentKind::Xdc
        } else {
            ContentKind::Xdd
        };
        let node_id = (kind == ContentKind::Xdc).then(|| node_id(content)).flatten();
        Identification { version, node_id, ..Identification::new(kind, reason) }
    }

    /// The evidence for the configuration of a node. An XDD and an XDC have the same elements, so the file extension
    /// decides if it is one of the two.
    fn configured(&self, content: &ExaminedContent<'_>) -> Option<&'static str> {
        match known_ending(content.name) {
            Some("xdc") if commissioning(content).is_some() => Some(", with `deviceCommissioning`"),
            Some("xdc") => Some("; no `deviceCommissioning`, but the name suggests XDC"),
            Some(_) => None,
            None if commissioning(content).is_some() => Some(", with `deviceCommissioning`"),
            None if content.contains("actualValue=") => Some(", with `actualValue`"),
            None => None,
        }
    }
}

impl Root {
    fn of(element: &BytesStart<'_>) -> Self {
        Self {
            name: quoted(element.local_name().as_ref()),
            namespace: namespace(element),
            version: attribute(element, "version"),
            location: attribute(element, "schemaLocation"),
        }
    }

    fn reason(&self) -> String {
        let name = &self.name;
        match (&self.namespace, &self.location) {
            (Some(namespace), _) => format!("the root element is `{name}` in the namespace `{namespace}`"),
            (None, Some(location)) => format!("the root element is `{name}` with the schema `{location}`"),
            (None, None) => format!("the root element is `{name}` without a namespace"),
        }
    }
}

/// The namespace that an element binds for itself.
fn namespace(element: &BytesStart<'_>) -> Option<String> {
    let name = element.name();
    let prefix = name.prefix();
    let binding = prefix.map_or("xmlns".to_owned(), |prefix| format!("xmlns:{}", prefix.as_ref()));
    let mut attributes = element.attributes();
    let found = attributes.with_checks(false).flatten().find(|attribute| attribute.key.0 == binding)?;
    Some(quoted(&found.value)).filter(|uri| !uri.is_empty())
}

/// The value of an attribute with any prefix.
fn attribute(element: &BytesStart<'_>, name: &str) -> Option<String> {
    let mut attributes = element.attributes();
    let mut known = attributes.with_checks(false).flatten();
    let found = known.find(|attribute| attribute.key.local_name().as_ref() == name)?;
    Some(quoted(&found.value)).filter(|text| !text.is_empty())
}

/// The endings of CANopen's XML files.
fn known_ending(name: &str) -> Option<&'static str> {
    name.rsplit('.').find_map(|part| {
        let known = ["xdd", "xdc", "xpd", "nxdd", "nxdc"];
        known.into_iter().find(|ending| ending.eq_ignore_ascii_case(part))
    })
}

/// `CanOpenProject_1_1` of CANopenEditor, `OpenEDSProject` of the editor before.
fn is_network(root: &str) -> bool {
    root.starts_with("CanOpenProject") || root == "OpenEDSProject"
}

/// Several devices in one file.
fn network(content: &ExaminedContent<'_>, root: &Root, reason: String) -> Identification {
    let is_configured = match known_ending(content.name) {
        Some(ending) => ending == "nxdc",
        None => commissioning(content).is_some(),
    };
    let kind = if is_configured { ContentKind::NetworkXdc } else { ContentKind::NetworkXdd };
    let devices = Some(starts(content, CONTAINER).count());
    Identification { version: root.version.clone(), devices, ..Identification::new(kind, reason) }
}

/// The positions at which an element with this local name starts.
fn starts<'a>(content: &'a ExaminedContent<'_>, name: &'a str) -> impl Iterator<Item = usize> + 'a {
    let bytes = content.bytes;
    memchr::memmem::find_iter(bytes, name).filter(move |&at| {
        let is_name =
            |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-' | b'.') || byte >= 0x80;
        if bytes.get(at + name.len()).is_some_and(|&next| is_name(next)) {
            return false;
        }
        let before = &bytes[..at];
        let before = match before.strip_suffix(b":") {
            // prefixes are short
            Some(before) => {
                let prefix = before.iter().rev().take(64).take_while(|&&byte| is_name(byte)).count();
                &before[..before.len() - prefix]
            }
            None => before,
        };
        before.ends_with(b"<")
    })
}

/// The position of the element with the node of a description.
fn commissioning(content: &ExaminedContent<'_>) -> Option<usize> {
    starts(content, "deviceCommissioning").next()
}

/// The node-ID in `deviceCommissioning`.
fn node_id(content: &ExaminedContent<'_>) -> Option<u8> {
    let rest = &content.bytes[commissioning(content)?..];
    let tag = &rest[..memchr::memchr(b'>', &rest[..rest.len().min(1 << 12)])?];
    let at = memchr::memmem::find(tag, b"nodeID").or_else(|| memchr::memmem::find(tag, b"NodeID"))?;
    let value = std::str::from_utf8(&tag[at + "nodeID".len()..]).ok()?;
    let value = value.trim_start().strip_prefix('=')?.trim_start();
    let quote = value.chars().next().filter(|&c| c == '"' || c == '\'')?;
    let id: u8 = value[1..].split(quote).next()?.trim().parse().ok()?;
    (1..=127).contains(&id).then_some(id)
}

/// Letters and digits in lower case, so that `CANopen FD` and `CANopen_FD` are one word.
fn letters(text: &str) -> String {
    text.chars().filter(char::is_ascii_alphanumeric).map(|c| c.to_ascii_lowercase()).collect()
}

fn foreign(kind: ContentKind, technology: &str, reason: String) -> Identification {
    Identification { technology: Some(technology.to_owned()), ..Identification::new(kind, reason) }
}

//! Links: the entries of a node that are sent to entries of others.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use objdict_node::ObjectName;

use crate::Said;
use crate::model::{Address, NoAddress};
use crate::source::Span;

/// Entries of a node whose values other nodes receive. [`resolve`](crate::resolve()) creates PDOs from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The position of the link in the network file.
    pub at: Span,
    /// The entries of the producer.
    pub from: LinkEnd,
    /// The entries of each consumer, the same number as of the producer and in the same order.
    pub to: Vec<LinkEnd>,
    /// How the PDO is sent; `None` keeps the setting of the producer's description.
    pub parameters: LinkParameters,
    /// The timeout of a consumer in milliseconds; `None` or 0: never.
    pub deadline: Option<Said<u16>>,
}

/// How the values of a link are sent. Values with the same parameters share PDOs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LinkParameters {
    /// Transmission type (CiA 301 §7.5.2.37).
    pub transmission: Option<u8>,
    /// Inhibit time in multiples of 100 µs.
    pub inhibit_time: Option<u16>,
    /// Event timer in milliseconds.
    pub event_timer: Option<u16>,
    /// The CAN-ID, above 7FFh with 29 bits; `None` selects a free one.
    pub can_id: Option<u32>,
}

impl LinkParameters {
    /// Whether a PDO with these parameters meets those in `wanted`.
    pub(crate) fn satisfy(&self, wanted: &Self) -> bool {
        fn is_met<T: PartialEq + Copy>(wanted: Option<T>, present: Option<T>) -> bool {
            wanted.is_none() || wanted == present
        }
        is_met(wanted.transmission, self.transmission)
            && is_met(wanted.inhibit_time, self.inhibit_time)
            && is_met(wanted.event_timer, self.event_timer)
            && is_met(wanted.can_id, self.can_id)
    }
}

/// One end of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkEnd {
    /// The position of the link end in the network file.
    pub at: Span,
    /// The name of the node.
    pub node: String,
    /// Its entries; `None` for a manager without a description, which is the counterpart of each PDO.
    pub entries: Option<LinkedEntries>,
}

impl LinkEnd {
    /// Parses an end of a link, such as `left.6000:1-5`, or `plc` for a manager without a description.
    ///
    /// # Errors
    /// If the node is missing, or the entries are neither an address nor a name.
    pub fn parse(text: &str, at: Span) -> Result<Self, NoLinkEnd> {
        let (node, entries) =
            text.split_once('.').map_or((text, None), |(node, entries)| (node, Some(entries)));
        let node = node.trim().to_owned();
        let entries = entries.map(str::parse).transpose().map_err(|NoAddress| NoLinkEnd)?;
        if node.is_empty() { Err(NoLinkEnd) } else { Ok(Self { at, node, entries }) }
    }
}

/// A text that is not a link end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoLinkEnd;

objdict_model::error_messages! { NoLinkEnd: {
    Self => "write the node and its entries: `left.6000:1-5`, `left.6041`, `left.Statusword`";
} }

/// The entries at an end of a link: `6000:1-5`, `6000:1`, `6041`, `Statusword`, `Read input:1-5`.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkedEntries {
    /// The object or entry.
    pub object: ObjectName,
    /// A range of its sub-indexes; `None` selects the entry itself, or each entry of the object that a PDO
    /// can carry.
    pub subs: Option<RangeInclusive<u8>>,
}

impl LinkedEntries {
    /// The addresses of the entries; `None` for a name.
    pub fn addresses(&self) -> Option<impl Iterator<Item = Address> + use<>> {
        let ObjectName::Address(Address { index, sub }) = self.object else { return None };
        let subs = self.subs.clone().or(sub.map(|sub| sub..=sub)).unwrap_or(0..=0);
        Some(subs.map(move |sub| Address { index, sub: Some(sub) }))
    }
}

/// Numbers are hexadecimal, as in addresses.
impl FromStr for LinkedEntries {
    type Err = NoAddress;

    fn from_str(text: &str) -> Result<Self, NoAddress> {
        let range = text.rsplit_once(':').and_then(|(object, subs)| {
            let (first, last) = subs.split_once('-').unwrap_or((subs, subs));
            Some((object, sub(first)?..=sub(last)?))
        });
        match range {
            Some((_, subs)) if subs.is_empty() => Err(NoAddress),
            Some((object, subs)) => Ok(Self { object: object.parse()?, subs: Some(subs) }),
            None => Ok(Self { object: text.parse()?, subs: None }),
        }
    }
}

fn sub(text: &str) -> Option<u8> {
    let digits = text.trim();
    let digits = digits.strip_prefix("0x").unwrap_or(digits);
    let is_hex = (1..=2).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    u8::from_str_radix(digits, 16).ok().filter(|_| is_hex)
}

impl fmt::Display for LinkedEntries {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.object.fmt(f)?;
        match &self.subs {
            Some(subs) if subs.start() == subs.end() => write!(f, ":{:X}", subs.start()),
            Some(subs) => write!(f, ":{:X}-{:X}", subs.start(), subs.end()),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_of_an_end() {
        for (text, node, entries) in [
            ("left.6000:1-5", "left", "6000:1-5"),
            ("left. 0x6000 : 0x01-0A", "left", "6000:1-A"),
            ("left.6000:3", "left", "6000:3"),
            ("left.6000.3", "left", "6000:3"),
            ("left.6041", "left", "6041"),
            ("left.Statusword", "left", "Statusword"),
            ("left.Read input 8 bit:1-5", "left", "Read input 8 bit:1-5"),
        ] {
            let end = LinkEnd::parse(text, Span::default()).unwrap();
            assert_eq!((&*end.node, &*end.entries.unwrap().to_string()), (node, entries), "{text}");
        }
        let end = LinkEnd::parse(" plc ", Span::default()).unwrap();
        assert_eq!((&*end.node, end.entries), ("plc", None));
        for text in ["", ".6000", "left.", "left.6000:5-1", "left.60000:1", "left.6000:100"] {
            assert_eq!(LinkEnd::parse(text, Span::default()), Err(NoLinkEnd), "{text}");
        }
    }
}

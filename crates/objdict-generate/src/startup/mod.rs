//! The behaviour of a stack with a dictionary at start-up: PDOs that it does not serve, heartbeat consumers that it
//! rejects, SDO servers that it lacks. One table for each stack (`stacks`), applied to the resolved entries of a table,
//! with one warning for each cause.

mod pdos;
mod stacks;
mod words;

use std::collections::HashMap;

use crate::Note;
use crate::dictionary::{ResolvedObject, TableDictionary};
use crate::model::Place;
use crate::resolve::{Encoded, ValueShape};
pub(crate) use stacks::CANOPENNODE;
#[cfg(feature = "stacks")]
pub(crate) use stacks::{CANFESTIVAL, CANOPEN_STACK, CANOPENNODE_V1, LELY};

/// A stack, as far as a dictionary can be served less than described.
pub(crate) struct Stack {
    /// How it reads the mapping of a PDO.
    mapping: pdos::StackMapping,
    /// The reasons for not serving PDOs, in the order of the stack's checks, and the effects.
    pdos: &'static [pdos::CauseRow],
    /// The heartbeat consumers that it accepts; `None` for all.
    consumers: Option<Consumers>,
    /// Its requirements for the parameters of SDO channels.
    sdo: &'static [DemandRow],
}

/// Reports everything that the stack will not serve.
pub(crate) fn notes(stack: &Stack, dictionary: &TableDictionary<'_>) -> Vec<Note> {
    let mut notes = pdos::notes(stack, dictionary);
    notes.extend(stack.consumers.iter().flat_map(|rules| consumer_notes(rules, dictionary)));
    notes.extend(stack.sdo.iter().flat_map(|row| server_notes(row, dictionary)));
    notes
}

/// The initial number of an entry, without the node-ID; `None` if the entry is missing or not a number of
/// this many bytes.
fn number(object: Option<&ResolvedObject<'_>>, sub: u8, bytes: usize) -> Option<u64> {
    datum(object, sub, bytes).map(Encoded::word)
}

fn datum<'a>(object: Option<&'a ResolvedObject<'_>>, sub: u8, bytes: usize) -> Option<&'a Encoded> {
    let resolved = &object?.entry(sub)?.resolved;
    let is_number = matches!(resolved.shape, ValueShape::Word(_)) && resolved.shape.size() == bytes;
    is_number.then_some(&resolved.default)
}

/// The reason why a PDO is not served.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum PdoCause {
    /// Above 255, the maximum of a byte counter, which includes PDOs that are not valid.
    Number,
    NoTransmissionType,
    NoCobId,
    RtrAllowed,
    Extended,
    NoCanId,
    /// The CAN-ID is 0, and the PDO has data to send.
    OnNmt,
    /// Outside the CAN-IDs that the stack uses for PDOs.
    NotDispatched,
    /// An RPDO before it has the CAN-ID, valid or not.
    Taken,
    NoMapping,
    TooMany,
    /// So many short entries that the stack does not detect the overrun.
    Overrun,
    NoSlot,
    TooLong,
    Dummy,
    Missing,
    Bits,
    Direction,
    NotMappable,
    Short,
    /// Numbers of a different length.
    Size,
    /// A length that the functions of the dictionary reject: any different one for writing, a longer one for
    /// reading.
    Length,
    /// In flash, and the stack does not check the access type when it writes.
    Constant,
    Empty,
    Reserved,
    /// Neither events nor SYNCs nor RTRs transmit it.
    NoTrigger,
    SyncStart,
}

/// The entries of 1016h that a stack accepts.
struct Consumers {
    /// Whether it processes the entries from the last to the first, and stops there.
    from_last: bool,
    /// Whether sub-index 0 determines how many entries it processes.
    is_counted: bool,
    /// The effect on a second entry that monitors the same node, if it is not served.
    repeated: Option<&'static str>,
}

fn consumer_notes(rules: &Consumers, dictionary: &TableDictionary<'_>) -> Vec<Note> {
    let Some(object) = dictionary.object(0x1016) else { return Vec::new() };
    let mut subs: Vec<u8> = object.entries.iter().map(|entry| entry.sub).filter(|&sub| sub > 0).collect();
    if rules.from_last {
        subs.reverse();
    }
    let count = number(Some(object), 0, 1).filter(|_| rules.is_counted);
    let is_used = |sub: &u8| number(Some(object), *sub, 4).is_some_and(|value| consumer(value).is_some());
    let (counted, others): (Vec<u8>, Vec<u8>) =
        subs.into_iter().partition(|&sub| count.is_none_or(|count| u64::from(sub) <= count));
    let mut consumer_notes = Vec::new();
    if let (Some(count), true) = (count, others.iter().any(is_used)) {
        let text =
            format!("the stack does not monitor the nodes of the entries above {count}, the value here");
        let note = Note::new(Place::entry(0x1016, 0), text).warning();
        consumer_notes.push(note.help("write the number of entries"));
    }
    let mut taken: HashMap<u64, u8> = HashMap::new();
    for sub in counted {
        let Some(node_id) = number(Some(object), sub, 4).and_then(consumer) else { continue };
        if let (Some(other), Some(effect)) = (taken.get(&node_id), rules.repeated) {
            let text = format!("{effect}: sub-index {other:02X}h also monitors node {node_id}");
            let note = Note::new(Place::entry(0x1016, sub), text).warning();
            consumer_notes.push(note.help("monitor each node in one entry"));
            if rules.from_last {
                break; // the entries before are not looked at
            }
        } else {
            taken.insert(node_id, sub);
        }
    }
    consumer_notes
}

/// The node of an entry that is in use.
fn consumer(value: u64) -> Option<u64> {
    let (time, node_id) = (value & 0xFFFF, value >> 16 & 0xFF);
    (time != 0 && node_id != 0).then_some(node_id)
}

/// The bit of a COB-ID that marks it as not valid.
const NOT_VALID: u64 = 1 << 31;

/// A requirement, and the effect if it is not met.
enum DemandRow {
    /// The highest sub-index of the objects in a range must be one of these, or the stack does not start; without
    /// `stops`, only if it is compiled with the service.
    Highest { first: u16, last: u16, allowed: &'static [u64], stops: bool },
    /// The default server (1200h) uses the COB-IDs of its entries: these must be valid, and equal to those of
    /// CiA 301.
    DefaultServer,
}

fn server_notes(row: &DemandRow, dictionary: &TableDictionary<'_>) -> Vec<Note> {
    match row {
        DemandRow::Highest { first, last, allowed, stops } => {
            let notes = highest(dictionary, (*first, *last), allowed).into_iter();
            notes.map(|note| if *stops { note.error() } else { note }).collect()
        }
        DemandRow::DefaultServer => default_server(dictionary),
    }
}

fn highest(dictionary: &TableDictionary<'_>, (first, last): (u16, u16), allowed: &[u64]) -> Vec<Note> {
    let objects = dictionary.objects.iter().filter(|object| (first..=last).contains(&object.index));
    let wrong = objects.filter_map(|object| {
        let highest = number(Some(object), 0, 1).filter(|highest| !allowed.contains(highest))?;
        let words: Vec<String> = allowed.iter().map(u64::to_string).collect();
        let text = format!("the stack does not start with {highest} here, but with {}", words.join(" or "));
        Some(Note::new(Place::entry(object.index, 0), text).warning().help("correct the number of entries"))
    });
    wrong.collect()
}

fn default_server(dictionary: &TableDictionary<'_>) -> Vec<Note> {
    let object = dictionary.object(0x1200);
    let wrong = [(1, 0x600_u64), (2, 0x580)].into_iter().filter_map(|(sub, base)| {
        let value = datum(object, sub, 4)?;
        let of_node = |node_id: u8| value.on_node(Some(node_id)) == base + u64::from(node_id);
        let fits = match dictionary.node_id {
            Some(node_id) => of_node(node_id),
            None => (1..=127).any(of_node),
        };
        let text = match value.word() {
            _ if fits => return None,
            word if word & NOT_VALID != 0 => {
                "the COB-ID is not valid (bit 31), so the stack has no SDO server".to_owned()
            }
            word => format!("with COB-ID {word:X}h the stack does not respond to SDOs for its node-ID"),
        };
        let note = Note::new(Place::entry(0x1200, sub), text).warning();
        Some(note.help("write `$NODEID+0x600` in sub-index 1 and `$NODEID+0x580` in sub-index 2"))
    });
    wrong.collect()
}

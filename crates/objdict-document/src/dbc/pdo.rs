//! Messages of PDOs: one for a CAN-ID, with the signals of the node that sends it.

use std::collections::BTreeMap;

use super::identifier::words;
use super::signal::{DbcCanId, DbcMessage, DbcSignal, NumberFormat};
use super::value::DbcEntry;
use super::{Database, Omission, services};
use crate::describe::spelled;
use crate::layout::{FieldKind, FrameContent, FrameLayout, LayoutField};
use crate::model::{CobId, DataType, Pdo, PdoKind, Place, TypeKind, predefined, restricted};

/// A PDO of a node.
struct Port<'a> {
    node: usize,
    pdo: Pdo<'a>,
    layout: FrameLayout,
}

/// The reason why a PDO has no message: the place, and whether the bus carries it.
struct PdoRefusal {
    place: Place,
    is_lost: bool,
    reason: String,
}

impl Port<'_> {
    /// The place of a mapped object.
    fn slot(&self, field: &LayoutField) -> Place {
        Place::entry(self.pdo.mapping_index(), field.slot)
    }
}

impl<'a> Database<'a> {
    /// The valid PDOs of all nodes.
    pub(super) fn add_pdos(&mut self) {
        let mut frames: BTreeMap<DbcCanId, Vec<Port<'a>>> = BTreeMap::new();
        for node in 0..self.stations.len() {
            let device = self.stations[node].device;
            for pdo in device.pdos() {
                let layout = FrameLayout::new(device, &pdo, &|_| String::new());
                match can_id(&pdo, &layout, self.stations[node].node_id) {
                    Ok(id) => frames.entry(id).or_default().push(Port { node, pdo, layout }),
                    Err(_) if self.stations[node].is_counterpart => {}
                    Err(PdoRefusal { place, is_lost, reason }) => self.omit(node, place, is_lost, reason),
                }
            }
        }
        for (id, ports) in frames {
            self.add_frame(id, ports);
        }
    }

    fn add_frame(&mut self, id: DbcCanId, mut ports: Vec<Port<'a>>) {
        let is_counterpart = |port: &Port<'_>| self.stations[port.node].is_counterpart;
        if ports.iter().all(is_counterpart) {
            return; // already reported for the node's PDO
        }
        // the node that sends the frame describes it, otherwise the first receiver
        ports.sort_by_key(|port| (is_counterpart(port), port.pdo.kind == PdoKind::Rpdo));
        if let Some(other) = self.messages.iter().find(|message| message.id == id) {
            let other = other.comment.split(':').next().unwrap_or_default();
            let reason = format!("CAN-ID {} is used by {other}", spelled(id.number, id.is_extended));
            for port in ports.iter().filter(|port| !self.stations[port.node].is_counterpart) {
                let place = Place::entry(port.pdo.communication_index(), 1);
                self.omissions.push(Omission {
                    node: port.node,
                    place,
                    is_lost: true,
                    reason: reason.clone(),
                });
            }
            return;
        }
        let Some((main, others)) = ports.split_first() else { return };
        // it is called as its sender calls it, though a counterpart does not describe it
        let sender = ports.iter().find(|port| port.pdo.kind == PdoKind::Tpdo).unwrap_or(main);
        let mut message = self.message(id, main, sender);
        for other in others {
            self.join(&mut message, main, other);
        }
        self.messages.push(message);
    }

    /// The message of a PDO.
    fn message(&mut self, id: DbcCanId, port: &Port<'a>, sender: &Port<'a>) -> DbcMessage {
        let of = &self.stations[sender.node];
        let name = words(&format!("{} {}{}", of.title, sender.pdo.kind, sender.pdo.number));
        let name = self.names.claim(&name, &of.node_id.to_string());
        let station = &self.stations[port.node];
        let mut message = DbcMessage::new(id, name, port.layout.bytes(), self.title(port));
        if let Some(number) = port.pdo.transmission_type {
            let transmission = station.decoder.transmission_type(port.pdo.kind, number.into());
            message.comment.push_str(&format!(": {transmission}"));
        }
        match port.layout.content {
            FrameContent::SourceMultiplexed | FrameContent::DestinationMultiplexed => {
                message.length = 8;
                multiplexed().into_iter().for_each(|signal| message.push(signal));
            }
            _ => self.put_fields(&mut message, port),
        }
        match port.pdo.kind {
            PdoKind::Tpdo => self.sent_by(&mut message, port),
            PdoKind::Rpdo => message.received_by(port.node),
        }
        message
    }

    /// Adds the sender of a message, with the time between two frames: the SYNC period, or the event timer.
    fn sent_by(&mut self, message: &mut DbcMessage, port: &Port<'a>) {
        message.senders.push(port.node);
        let Port { node, pdo, .. } = port;
        message.cycle = match pdo.transmission_type {
            Some(cycles @ 1..=240) => {
                let station = &self.stations[*node];
                let stated = station.device.services().sync.unwrap_or(CobId::new(predefined::SYNC.into()));
                let period = self.cycles.get(&services::can_id(stated, station.node_id)).copied();
                let place = Place::entry(pdo.communication_index(), 2);
                period
                    .and_then(|period| self.milliseconds(*node, u64::from(period) * u64::from(cycles), place))
            }
            Some(0 | 241..=253) => None,
            _ => pdo.event_timer.filter(|&time| time > 0).map(u32::from),
        };
    }

    /// `TPDO 1 of Drive (1800h, 1A00h)`.
    fn title(&self, port: &Port<'_>) -> String {
        let Port { pdo, node, .. } = port;
        let (communication, mapping) = (pdo.communication_index(), pdo.mapping_index());
        format!("{pdo} of {} ({communication:04X}h, {mapping:04X}h)", self.stations[*node].title)
    }

    fn put_fields(&mut self, message: &mut DbcMessage, port: &Port<'_>) {
        for field in &port.layout.fields {
            match self.signals(port, field) {
                Ok(signals) => {
                    if let Some(object) = field.object.filter(|_| field.kind == FieldKind::Object) {
                        self.carried.insert((port.node, object.index, object.sub));
                    }
                    signals.into_iter().for_each(|signal| message.push(signal));
                }
                Err(reason) => {
                    let object = field.object.map(|object| format!("{object}: ")).unwrap_or_default();
                    self.omit(port.node, port.slot(field), true, format!("{object}{reason}"));
                }
            }
        }
    }

    /// The signals of a mapped object; none for a dummy.
    fn signals(&self, port: &Port<'_>, field: &LayoutField) -> Result<Vec<DbcSignal>, &'static str> {
        let Some(object) = field.object else {
            return Err("it has no value, so the positions of the following objects are unknown");
        };
        let is_carried = matches!(field.kind, FieldKind::Object | FieldKind::Missing);
        let Some(start) = field.first.filter(|_| is_carried) else {
            return if is_carried { Err("its place is not known") } else { Ok(Vec::new()) };
        };
        if field.is_cut() {
            return Err("it ends beyond the 64 bits of a frame");
        }
        let station = &self.stations[port.node];
        let entry = station.device.entry(object.index, object.sub);
        let carried = DbcEntry { station, index: object.index, sub: object.sub, entry: entry.as_deref() };
        let mut signals = carried.signals(field.bits, self.options.bits)?;
        for signal in &mut signals {
            signal.first += start;
        }
        Ok(signals)
    }

    /// Adds a second PDO with the CAN-ID of a message.
    fn join(&mut self, message: &mut DbcMessage, main: &Port<'a>, other: &Port<'a>) {
        if self.stations[other.node].is_counterpart {
            match other.pdo.kind {
                PdoKind::Tpdo if message.senders.is_empty() => self.sent_by(message, other),
                PdoKind::Tpdo => {}
                PdoKind::Rpdo => message.received_by(other.node),
            }
            return;
        }
        let title = self.title(main);
        if other.pdo.kind == PdoKind::Tpdo {
            let place = Place::entry(other.pdo.communication_index(), 1);
            let id = spelled(message.id.number, message.id.is_extended);
            self.omit(other.node, place, true, format!("CAN-ID {id} is used by {title}"));
            return;
        }
        message.comment.push_str(&format!("; {}", self.title(other)));
        let fields = other.layout.fields.iter();
        for field in fields.filter(|field| matches!(field.kind, FieldKind::Object | FieldKind::Missing)) {
            let Some(object) = field.object else { continue };
            let key = |of: &LayoutField| (of.first, of.bits, number_of(of));
            let is_same = |of: &LayoutField| of.first.is_some() && key(of) == key(field);
            if main.layout.fields.iter().any(is_same) {
                self.carried.insert((other.node, object.index, object.sub));
            } else {
                let reason = format!("{object}: the frame has the signals of {title}");
                self.omit(other.node, other.slot(field), true, reason);
            }
            let Some(span) = field.span() else { continue };
            let signals = message.signals.iter_mut().map(|(_, signal)| signal);
            for signal in signals.filter(|signal| signal.first < span.end && span.start < signal.end()) {
                signal.receivers.insert(other.node);
            }
        }
    }
}

/// How the bits of a mapped object are a number.
fn number_of(field: &LayoutField) -> NumberFormat {
    match field.data_type.map(DataType::kind) {
        Some(TypeKind::Signed(_)) => NumberFormat::Signed,
        Some(TypeKind::Real32) => NumberFormat::Real32,
        Some(TypeKind::Real64) => NumberFormat::Real64,
        _ => NumberFormat::Unsigned,
    }
}

/// The CAN-ID of a PDO with a message.
fn can_id(pdo: &Pdo<'_>, layout: &FrameLayout, node_id: u8) -> Result<DbcCanId, PdoRefusal> {
    let communication = Place::entry(pdo.communication_index(), 1);
    let refuse = |place, is_lost, reason: String| Err(PdoRefusal { place, is_lost, reason });
    let Some(cob_id) = pdo.cob_id else {
        return refuse(communication, true, "the COB-ID of the PDO is not stated".to_owned());
    };
    if !cob_id.is_valid() {
        return refuse(communication, false, "the PDO is not valid (bit 31 of its COB-ID)".to_owned());
    }
    let id = DbcCanId { is_extended: cob_id.is_extended(), number: cob_id.can_id(node_id) };
    let owner = restricted(id.number).filter(|owner| !id.is_extended && *owner != "reserved");
    if let Some(owner) = owner {
        return refuse(
            communication,
            true,
            format!("CAN-ID {} is used by {owner}", spelled(id.number, false)),
        );
    }
    let mapping = Place::entry(pdo.mapping_index(), 0);
    match layout.content {
        FrameContent::Nothing => refuse(mapping, false, "nothing is mapped".to_owned()),
        FrameContent::Unstated if layout.fields.is_empty() => {
            refuse(mapping, true, "the mapped objects are not specified".to_owned())
        }
        FrameContent::Reserved(count) => {
            refuse(mapping, true, format!("`{count}` is not a number of mapped objects"))
        }
        _ => Ok(id),
    }
}

/// The frame of a multiplexed PDO (CiA 301 §7.2.2.6).
fn multiplexed() -> [DbcSignal; 5] {
    [
        DbcSignal::new("Node", 0, 7).with_values([(0, "all nodes")]),
        DbcSignal::new("Destination", 7, 1)
            .with_values([(0, "source addressing"), (1, "destination addressing")]),
        DbcSignal::new("Index", 8, 16),
        DbcSignal::new("Sub_index", 24, 8),
        DbcSignal::new("Data", 32, 32),
    ]
}

//! PDOs as a whole: the mapping as the content of a frame, the CAN-ID, and the transmission.

use std::collections::BTreeSet;

use super::audience::Affected;
use super::{DeviceComparison, Side, Spot, rules};
use crate::diagnostic::{counted, say};
use crate::model::{CobId, DataType, MappedObject, Pdo, PdoKind, Place};

impl DeviceComparison<'_> {
    pub(super) fn pdos(&mut self) {
        let numbers = |side: &Side<'_>| -> BTreeSet<(PdoKind, u16)> {
            side.device.pdos().map(|pdo| (pdo.kind, pdo.number)).collect()
        };
        let all: Vec<_> = numbers(&self.old).union(&numbers(&self.new)).copied().collect();
        for (kind, number) in all {
            let (old, new) = (self.old.device, self.new.device);
            match (old.pdo(kind, number), new.pdo(kind, number)) {
                (Some(old), Some(new)) => self.pdo(&old, &new),
                (Some(old), None) => {
                    let shown = self.old.content(&old);
                    let message = format!("{old} is removed: {shown}");
                    let spot = Spot { new: None, ..spot(&old) };
                    self.report(&rules::PDO_REMOVED, &spot, [Some(shown), None], message);
                }
                (None, Some(new)) => {
                    let shown = self.new.content(&new);
                    let message = format!("{new} is added: {shown}");
                    let spot = Spot { old: None, ..spot(&new) };
                    self.report(&rules::PDO_ADDED, &spot, [None, Some(shown)], message);
                }
                (None, None) => {}
            }
        }
    }

    fn pdo(&mut self, old: &Pdo<'_>, new: &Pdo<'_>) {
        let spot = spot(old);
        if self.is_remapped(old, new) {
            let values = [self.old.content(old), self.new.content(new)];
            let message = format!("{old}: {} → {}", values[0], values[1]);
            let mapping = Some(Place::object(old.mapping_index()));
            let spot = Spot { old: mapping.clone(), new: mapping, ..spot.clone() };
            self.report(&rules::PDO_MAPPING_CHANGED, &spot, values.map(Some), message);
        }
        self.can_id(&spot, old, new);
        self.transmission(&spot, old, new);
    }

    /// Whether a frame has other data.
    fn is_remapped(&self, old: &Pdo<'_>, new: &Pdo<'_>) -> bool {
        let here = |object: MappedObject| match self.moved.get(&object.entry()) {
            Some(&(index, sub)) => MappedObject { index, sub, ..object },
            None => object,
        };
        old.is_multiplexed() != new.is_multiplexed() || !old.mapped().map(here).eq(new.mapped())
    }

    /// The sub-indexes of a mapping parameter that belong to a changed mapping.
    pub(super) fn slots_of_changed_mapping(&self, index: u16) -> BTreeSet<u8> {
        let changed = PdoKind::of_mapping(index).and_then(|(kind, number)| {
            let (old, new) = (self.old.device.pdo(kind, number)?, self.new.device.pdo(kind, number)?);
            self.is_remapped(&old, &new).then_some([old, new])
        });
        changed.iter().flatten().flat_map(Pdo::used_slots).map(|slot| slot.sub).collect()
    }

    fn can_id(&mut self, spot: &Spot, old: &Pdo<'_>, new: &Pdo<'_>) {
        if old.cob_id == new.cob_id {
            return;
        }
        let node_id = self.node_id();
        let number = |cob_id: CobId| match node_id {
            Some(node_id) => (cob_id.on_node(node_id), false),
            None => (cob_id.number(), cob_id.depends_on_node_id()),
        };
        let is_valid = |pdo: &Pdo<'_>| pdo.cob_id.is_some_and(CobId::is_valid);
        // the CAN-ID and whether it is extended, without the RTR permission
        let frame =
            |pdo: &Pdo<'_>| pdo.cob_id.map(number).map(|(number, depends)| (number & 0x3FFF_FFFF, depends));
        let shown = |pdo: &Pdo<'_>| pdo.cob_id.map(shown);
        let values = [shown(old), shown(new)];
        let [before, after] = values.clone().map(|text| text.unwrap_or_else(|| "none".to_owned()));
        let field =
            |pdo: &Pdo<'_>, side: &Side<'_>| Some(side.device.value_place(pdo.communication_index(), 1));
        let spot =
            Spot { sub: Some(1), old: field(old, &self.old), new: field(new, &self.new), ..spot.clone() };
        let is_other = frame(old) != frame(new);
        // a COB-ID that one description does not state may be any
        let is_known = old.cob_id.is_some() && new.cob_id.is_some();
        let mut report = |rule, message| self.report(rule, &spot, values.clone(), message);
        match (is_valid(old), is_valid(new)) {
            (true, true) if is_other => {
                report(
                    &rules::PDO_COB_ID_CHANGED,
                    say!("{}: the COB-ID changes from {} to {}", old, before, after),
                );
            }
            _ if !is_known => {
                report(
                    &rules::DEFAULT_CHANGED,
                    say!("{}: the COB-ID changes from {} to {}", old, before, after),
                );
            }
            (true, false) => {
                report(&rules::PDO_DISABLED, say!("{} is no longer valid: {}, then {}", old, before, after));
            }
            (false, true) => {
                report(&rules::PDO_ENABLED, say!("{} becomes valid: {}, then {}", old, before, after));
            }
            (false, false) if is_other => {
                report(
                    &rules::DEFAULT_CHANGED,
                    say!("{}: the COB-ID changes from {} to {}", old, before, after),
                );
            }
            _ => {}
        }
    }

    fn transmission(&mut self, spot: &Spot, old: &Pdo<'_>, new: &Pdo<'_>) {
        let (before, mut after) = (timing(old), timing(new));
        if old.cob_id.is_none() || new.cob_id.is_none() {
            after[4].clone_from(&before[4]);
        }
        let changed: Vec<_> = before.iter().zip(&after).filter(|(old, new)| old != new).collect();
        let Some(first) = before.iter().zip(&after).position(|(old, new)| old != new) else { return };
        let values = [0, 1].map(|side| {
            let texts = changed.iter().map(|(old, new)| if side == 0 { old.as_str() } else { new.as_str() });
            texts.collect::<Vec<_>>().join(", ")
        });
        let message = say!("{}: {}, then {}", old, &values[0], &values[1]);
        let sub = [2, 3, 5, 6, 1][first];
        let place =
            |pdo: &Pdo<'_>, side: &Side<'_>| Some(side.device.value_place(pdo.communication_index(), sub));
        let spot =
            Spot { sub: Some(sub), old: place(old, &self.old), new: place(new, &self.new), ..spot.clone() };
        self.report(&rules::PDO_TRANSMISSION_CHANGED, &spot, values.map(Some), message);
    }
}

/// A PDO as a whole: the place of its communication parameter.
fn spot(pdo: &Pdo<'_>) -> Spot {
    let index = match pdo.communication {
        Some(_) => pdo.communication_index(),
        None => pdo.mapping_index(),
    };
    let place = Some(Place::object(index));
    let affected = Affected::ALL;
    Spot { index: Some(pdo.communication_index()), sub: None, old: place.clone(), new: place, affected }
}

/// A COB-ID of a PDO, with the meaning of its bits.
fn shown(cob_id: CobId) -> String {
    let number = cob_id.number() & 0x1FFF_FFFF;
    let id =
        if cob_id.depends_on_node_id() { format!("$NODEID+{number:X}h") } else { format!("{number:X}h") };
    if cob_id.is_valid() { id } else { format!("{id} (not valid)") }
}

/// The transmission of a PDO, part by part. A missing time equals 0.
fn timing(pdo: &Pdo<'_>) -> [String; 5] {
    let number = |value: Option<u16>| value.unwrap_or(0).to_string();
    let transmission_type =
        pdo.transmission_type.map_or_else(|| "none".to_owned(), |value| value.to_string());
    let allows_rtr = match pdo.cob_id.filter(|_| pdo.kind == PdoKind::Tpdo) {
        Some(cob_id) if cob_id.bit_30() => "not allowed",
        Some(_) => "allowed",
        None => "not stated",
    };
    [
        format!("transmission type {transmission_type}"),
        format!("inhibit time {}", number(pdo.inhibit_time)),
        format!("event timer {}", number(pdo.event_timer)),
        format!("SYNC start value {}", number(pdo.sync_start_value.map(u16::from))),
        format!("RTR {allows_rtr}"),
    ]
}

impl Side<'_> {
    /// The content of a PDO: "Statusword, Position actual value (48 bits)".
    fn content(&self, pdo: &Pdo<'_>) -> String {
        if pdo.is_multiplexed() {
            return "multiplexed".to_owned();
        }
        let names: Vec<String> = pdo.mapped().map(|object| self.name_of(object)).collect();
        let bits = usize::try_from(pdo.bit_length()).unwrap_or_default();
        let length = counted(bits, "bit", "bits");
        if names.is_empty() { "nothing".to_owned() } else { format!("{} ({length})", names.join(", ")) }
    }

    fn name_of(&self, mapped: MappedObject) -> String {
        if mapped.is_dummy() {
            return format!("dummy {}", DataType(mapped.index));
        }
        let address = || format!("{:04X}h:{:02X}", mapped.index, mapped.sub);
        let Some(object) = self.device.object(mapped.index) else { return address() };
        let name = match object.entry(mapped.sub).filter(|_| object.object_type().has_subs()) {
            Some(entry) => format!("{} / {}", object.name(), entry.name),
            None => object.name().to_owned(),
        };
        if name.trim().is_empty() { address() } else { name }
    }
}

//! Mappings and CAN-IDs of PDOs.

use super::{CanId, Desk, PdoName, Wrong};
use crate::diagnostic::listing;
use crate::download::transferred_type;
use crate::model::{Address, CobId, DataType, MappedObject, PdoKind, Value, restricted};
use crate::resolve::ObjectName;

/// Bits of a CAN data field.
const FRAME: u32 = 64;

impl Desk<'_> {
    /// Maps entries into a PDO. Mapping entries after the last mapped object keep their values, because the
    /// number of mapped objects excludes them.
    pub(super) fn map(&mut self, pdo: PdoName, objects: &[ObjectName]) -> Result<(), Wrong> {
        let index = self.mapping_of(pdo)?;
        let mut bits = 0;
        let mut mapped = Vec::with_capacity(objects.len());
        for name in objects {
            let object = self.mappable(pdo.kind, self.address(name)?)?;
            bits += u32::from(object.bits);
            mapped.push(object);
        }
        if bits > FRAME {
            return Err(Wrong::new(format!("{bits} bits are mapped, but a PDO has at most {FRAME}")));
        }
        for (sub, object) in (1..=u8::MAX).zip(&mapped) {
            self.assign(pdo, index, sub, object.to_number().into())?;
        }
        self.assign(pdo, index, 0, mapped.len() as u64)
    }

    /// Sets a mapping entry unless it already has the value.
    fn assign(&mut self, pdo: PdoName, index: u16, sub: u8, number: u64) -> Result<(), Wrong> {
        if self.number(index, sub) == Some(number) {
            return Ok(());
        }
        let at = Address { index, sub: Some(sub) };
        if self.device.entry(index, sub).is_none() {
            let slots = self
                .device
                .object(index)
                .map_or(0, |object| object.entries().filter(|(sub, _)| *sub > 0).count());
            return Err(Wrong::new(format!("{pdo} maps at most {slots} objects")));
        }
        let (sub, entry) = self.writable(at).map_err(|wrong| {
            Wrong::new(format!(
                "the mapping of {pdo} cannot be changed: `{}`: {}",
                ObjectName::Address(at),
                wrong.message
            ))
        })?;
        self.put(index, sub, &entry, Value::Unsigned(number))
    }

    fn mapping_of(&self, pdo: PdoName) -> Result<u16, Wrong> {
        let index = pdo.kind.mapping_index(pdo.number).filter(|index| self.device.object(*index).is_some());
        index.ok_or_else(|| self.no_pdo(pdo))
    }

    fn no_pdo(&self, pdo: PdoName) -> Wrong {
        let names = self.device.pdos().filter(|other| other.kind == pdo.kind);
        let names: Vec<String> =
            names.map(|other| PdoName { kind: other.kind, number: other.number }.to_string()).collect();
        let wrong = Wrong::new(format!("the device has no {pdo}"));
        if names.is_empty() { wrong } else { wrong.help(format!("it has {}", listing(names))) }
    }

    /// The mapping value for an entry.
    fn mappable(&self, kind: PdoKind, at: Address) -> Result<MappedObject, Wrong> {
        let name = ObjectName::Address(at);
        let data_type = DataType(at.index);
        if at.index < 0x20 {
            let bits = data_type.bit_length().filter(|_| kind == PdoKind::Rpdo && data_type.is_dummy());
            let Some(bits) = bits else {
                return Err(Wrong::new(format!(
                    "`{name}` is a data type, which only an RPDO can map, as a dummy entry"
                )));
            };
            let usage = self.device.dummy_usage.as_ref().and_then(|usage| usage.types.get(&data_type));
            if usage == Some(&false) {
                return Err(Wrong::new(format!(
                    "the device does not support {data_type} as a dummy entry (`DummyUsage`)"
                )));
            }
            return Ok(MappedObject { index: at.index, sub: 0, bits });
        }
        let (_, sub, entry) = self
            .entry(at)
            .map_err(|wrong| Wrong { message: format!("`{name}`: {}", wrong.message), ..wrong })?;
        if !entry.is_mappable() {
            return Err(Wrong::new(format!("`{name}` cannot be mapped")));
        }
        if !entry.fits_pdo(kind) {
            let access = entry.access.map_or(String::new(), |access| format!(": it is `{access}`"));
            return Err(Wrong::new(format!("no {kind} can carry `{name}`{access}")));
        }
        match transferred_type(self.device, at.index, sub).and_then(DataType::bit_length) {
            Some(bits) => Ok(MappedObject { index: at.index, sub, bits }),
            None => Err(Wrong::new(format!("`{name}` has no fixed length"))),
        }
    }

    /// Sets the CAN-ID of a PDO. Bit 30 of a TPDO (no RTR) is preserved.
    pub(super) fn cob_id(&mut self, pdo: PdoName, id: CanId) -> Result<(), Wrong> {
        let index = pdo.kind.communication_index(pdo.number);
        let Some(index) = index.filter(|index| self.device.object(*index).is_some()) else {
            return Err(self.no_pdo(pdo));
        };
        let at = Address { index, sub: Some(1) };
        let (sub, entry) = self.writable(at)?;
        let present = self.value(index, sub).as_ref().and_then(CobId::from_value);
        let kept = present.map_or(0, CobId::number) & CobId::BIT_30;
        let cob_id = match id {
            CanId::Off => present.unwrap_or(CobId::new(0)).disabled(),
            CanId::Number(number) => CobId::new(kept | framed(number)),
            CanId::PerNode(number) => CobId::per_node(kept | framed(number))
                .ok_or_else(|| Wrong::new(format!("`{id}` is too large for a CAN-ID")))?,
        };
        if id != CanId::Off {
            self.free(pdo, cob_id)?;
        }
        self.put(index, sub, &entry, cob_id.to_value())
    }

    /// Rejects a CAN-ID that another service of the node uses or that is not allowed for PDOs.
    fn free(&self, pdo: PdoName, cob_id: CobId) -> Result<(), Wrong> {
        let can_id = cob_id.can_id(self.node_id);
        if !cob_id.is_extended() && cob_id.stray_bits() != 0 {
            return Err(Wrong::new(format!("`{cob_id}` is above 7FFh, the highest 11-bit CAN-ID")));
        }
        if let Some(owner) = restricted(can_id).filter(|_| !cob_id.is_extended()) {
            return Err(Wrong::new(format!("the CAN-ID `0x{can_id:X}` is reserved: {owner}")));
        }
        for other in self.device.pdos().filter(|other| (other.kind, other.number) != (pdo.kind, pdo.number)) {
            let present = self.value(other.communication_index(), 1).as_ref().and_then(CobId::from_value);
            let is_same = |other: CobId| {
                other.can_id(self.node_id) == can_id && other.is_extended() == cob_id.is_extended()
            };
            if present.is_some_and(|other| other.is_valid() && is_same(other)) {
                let other = PdoName { kind: other.kind, number: other.number };
                let wrong = Wrong::new(format!("{other} already has the CAN-ID `0x{can_id:X}`"));
                return Err(
                    wrong.help(format!("disable it first with `--cob-id {other}=off`, or change its CAN-ID"))
                );
            }
        }
        Ok(())
    }
}

/// Sets bit 29 if the CAN-ID needs 29 bits.
fn framed(can_id: u32) -> u32 {
    if can_id > 0x7FF { can_id | CobId::FRAME } else { can_id }
}

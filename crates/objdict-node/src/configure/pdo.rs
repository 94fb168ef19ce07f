//! Mappings and parameters of PDOs.

use super::{Configurator, PdoName, PdoParameter, Wrong};
use crate::diagnostic::listing;
use crate::download::transferred_type;
use crate::model::{Address, DataType, MappedObject, Pdo, PdoKind, Value};
use crate::resolve::ObjectName;

impl Configurator<'_> {
    /// Maps entries into a PDO. Mapping entries after the last mapped object keep their values, because the
    /// number of mapped objects excludes them.
    pub(super) fn map(&mut self, pdo: PdoName, objects: &[ObjectName]) -> Result<(), Wrong> {
        let index = self.mapping_of(pdo)?;
        let mapped = objects.iter().map(|name| self.mappable(pdo.kind, self.address(name)?));
        let mapped = mapped.collect::<Result<Vec<_>, _>>()?;
        let (bits, most) = (mapped.iter().map(|object| u32::from(object.bits)).sum::<u32>(), Pdo::FRAME_BITS);
        if bits > most {
            return Err(Wrong::new(format!("{bits} bits are mapped, but a PDO has at most {most}")));
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

    /// Sets a parameter of a PDO.
    pub(super) fn pdo_parameter(
        &mut self,
        pdo: PdoName,
        parameter: PdoParameter,
        text: &str,
    ) -> Result<(), Wrong> {
        let index = self.communication_of(pdo)?;
        self.set_implied(Address { index, sub: Some(parameter.sub()) }, text)
    }

    /// The index of the communication parameter.
    pub(super) fn communication_of(&self, pdo: PdoName) -> Result<u16, Wrong> {
        let index = pdo.kind.communication_index(pdo.number);
        index.filter(|index| self.device.object(*index).is_some()).ok_or_else(|| self.no_pdo(pdo))
    }

    pub(super) fn no_pdo(&self, pdo: PdoName) -> Wrong {
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
}

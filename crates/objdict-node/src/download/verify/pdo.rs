//! Rules for writes to PDO parameters (CiA 301 §7.5.2.35 to §7.5.2.38).

use super::super::transfer::EntryType;
use super::ObjectionKind;
use super::node::{Judgement, Node};
use super::services::{CobIdChange, is_invalid};
use crate::model::{DataType, MappedObject, PdoKind};

/// Bits of a CAN data field.
const FRAME: u32 = 64;

impl Node<'_> {
    /// Checks a write to the communication parameter.
    pub(super) fn judge_communication(&mut self, kind: PdoKind, pdo: u16, sub: u8, new: u64) -> Judgement {
        match sub {
            1 => {
                let present = kind.communication_index(pdo).and_then(|index| self.word((index, 1)));
                let new = u32::try_from(new).unwrap_or(u32::MAX);
                CobIdChange { present, new }.judge(is_invalid, "set bit 31 of the COB-ID")
            }
            2 if is_reserved(kind, new) => Err(ObjectionKind::Undefined("the transmission type is reserved")),
            // inhibit time and SYNC start value; the others may change at any time
            3 | 6 if self.pdo_is_valid(kind, pdo) => Err(ObjectionKind::PdoIsValid(kind, pdo)),
            _ => Ok(None),
        }
    }

    /// Checks a write to the mapping.
    pub(super) fn judge_mapping(
        &mut self,
        kind: PdoKind,
        pdo: u16,
        sub: u8,
        new: u64,
    ) -> Result<(), ObjectionKind> {
        let Some(mapping) = kind.mapping_index(pdo) else { return Ok(()) };
        if self.pdo_is_valid(kind, pdo) {
            return Err(ObjectionKind::PdoIsValid(kind, pdo));
        }
        if sub == 0 {
            return self.judge_count(kind, mapping, new);
        }
        if self.number((mapping, 0)).is_some_and(|count| count != 0) {
            return Err(ObjectionKind::MappingInUse);
        }
        match u32::try_from(new).map(MappedObject::from_number) {
            Ok(mapped) if mapped.is_unused() => Ok(()),
            Ok(mapped) => self.judge_mapped(kind, mapped),
            Err(_) => Ok(()), // longer than a mapping entry: already rejected by its data type
        }
    }

    /// Checks the number of mapped objects, which makes the mapping valid.
    fn judge_count(&mut self, kind: PdoKind, mapping: u16, count: u64) -> Result<(), ObjectionKind> {
        if matches!(count, 0xFE | 0xFF) {
            return Ok(()); // multiplexed: each frame names its object
        }
        let mut bits = 0;
        for sub in 1..=u8::try_from(count).unwrap_or(u8::MAX).min(65) {
            if sub > 64 {
                return Err(ObjectionKind::PdoTooLong { bits });
            }
            let Some(mapped) = self.word((mapping, sub)).map(MappedObject::from_number) else {
                match self.device.entry(mapping, sub) {
                    Some(_) => continue, // value unknown
                    None => return Err(ObjectionKind::NothingMapped { sub }),
                }
            };
            if mapped.is_unused() {
                return Err(ObjectionKind::NothingMapped { sub });
            }
            self.judge_mapped(kind, mapped)?;
            bits += u32::from(mapped.bits);
            if bits > FRAME {
                return Err(ObjectionKind::PdoTooLong { bits });
            }
        }
        Ok(())
    }

    /// Checks existence, access and length of the mapped object.
    fn judge_mapped(&self, kind: PdoKind, mapped: MappedObject) -> Result<(), ObjectionKind> {
        let length = |bits: Option<u8>| match bits.filter(|&bits| bits != mapped.bits) {
            Some(bits) => Err(ObjectionKind::MappedLength { mapped, bits }),
            None => Ok(()),
        };
        let refused = ObjectionKind::NotMappable(mapped, kind);
        let data_type = DataType(mapped.index);
        if mapped.is_dummy() {
            let is_filler = kind == PdoKind::Rpdo && data_type.is_dummy() && mapped.sub == 0;
            return if is_filler { length(data_type.bit_length()) } else { Err(refused) };
        }
        let Some(object) = self.device.object(mapped.index) else { return Err(refused) };
        let Some(entry) = object.entry(mapped.sub) else { return Err(refused) };
        if !entry.is_mappable() || !entry.fits_pdo(kind) {
            return Err(refused);
        }
        length(
            EntryType::of(self.device, object, (mapped.index, mapped.sub), &entry)
                .transferred
                .and_then(DataType::bit_length),
        )
    }

    /// Whether bit 31 of the COB-ID is known to be clear.
    fn pdo_is_valid(&mut self, kind: PdoKind, pdo: u16) -> bool {
        let cob_id = kind.communication_index(pdo).and_then(|index| self.word((index, 1)));
        cob_id.is_some_and(|cob_id| !is_invalid(cob_id))
    }
}

/// Transmission types that CiA 301 reserves.
fn is_reserved(kind: PdoKind, number: u64) -> bool {
    match kind {
        PdoKind::Rpdo => matches!(number, 0xF1..=0xFD),
        PdoKind::Tpdo => matches!(number, 0xF1..=0xFB),
    }
}

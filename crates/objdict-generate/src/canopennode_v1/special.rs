//! Objects that the stack refers to by name, and those for which it has structures.

use crate::dictionary::{ResolvedEntry, ResolvedObject};
use crate::model::DataType;
use crate::resolve::ValueShape;

const U8: DataType = DataType::UNSIGNED8;
const U16: DataType = DataType::UNSIGNED16;
const U32: DataType = DataType::UNSIGNED32;

/// The structure that the stack expects of an object.
#[derive(Clone, Copy)]
pub(super) enum StackForm {
    /// A number of this type, with its value where the description lacks the object.
    Value(DataType, u32),
    /// At least this many elements of this type.
    List(DataType, usize),
    /// An octet string of at least this many bytes.
    Octets(usize),
}

/// An object with the name that the stack uses.
pub(super) struct NamedObject {
    pub(super) index: u16,
    pub(super) name: &'static str,
    pub(super) form: StackForm,
}

const fn value(index: u16, name: &'static str, data_type: DataType, missing: u32) -> NamedObject {
    NamedObject { index, name, form: StackForm::Value(data_type, missing) }
}

pub(super) const NAMED: [NamedObject; 15] = [
    value(0x1001, "errorRegister", U8, 0),
    NamedObject { index: 0x1003, name: "preDefinedErrorField", form: StackForm::List(U32, 1) },
    value(0x1005, "COB_ID_SYNCMessage", U32, 0x80),
    value(0x1006, "communicationCyclePeriod", U32, 0),
    value(0x1007, "synchronousWindowLength", U32, 0),
    value(0x100C, "guardTime", U16, 0),
    value(0x100D, "lifeTimeFactor", U8, 0),
    value(0x1012, "COB_ID_TIME", U32, 0x100),
    value(0x1015, "inhibitTimeEMCY", U16, 0),
    NamedObject { index: 0x1016, name: "consumerHeartbeatTime", form: StackForm::List(U32, 1) },
    value(0x1017, "producerHeartbeatTime", U16, 0),
    value(0x1019, "synchronousCounterOverflowValue", U8, 0),
    NamedObject { index: 0x1029, name: "errorBehavior", form: StackForm::List(U8, 6) },
    value(0x1F80, "NMTStartup", U32, 0),
    NamedObject { index: 0x2100, name: "errorStatusBits", form: StackForm::Octets(10) },
];

/// The members of the identity, which LSS reads.
pub(super) const IDENTITY: [&str; 4] = ["vendorID", "productCode", "revisionNumber", "serialNumber"];

/// A member of a stack structure.
pub(super) struct StructureField {
    pub(super) name: &'static str,
    pub(super) data_type: DataType,
}

/// Objects for which the stack has an array of structures.
pub(super) struct StructureFamily {
    pub(super) first: u16,
    pub(super) last: u16,
    pub(super) name: &'static str,
    /// By sub-index: names, each after the bits of its number.
    members: &'static str,
    /// Whether the stack needs at least one.
    pub(super) needed: bool,
}

/// The stack compiles without SDO clients, but not without one of each other family.
const fn family(first: u16, last: u16, name: &'static str, members: &'static str) -> StructureFamily {
    StructureFamily { first, last, name, members, needed: first != 0x1280 }
}

const MAPPING: &str =
    "8 numberOfMappedObjects 32 mappedObject1 32 mappedObject2 32 mappedObject3 32 mappedObject4
    32 mappedObject5 32 mappedObject6 32 mappedObject7 32 mappedObject8";

const SDO: &str = "8 maxSubIndex 32 COB_IDClientToServer 32 COB_IDServerToClient";
const SDO_CLIENT: &str =
    "8 maxSubIndex 32 COB_IDClientToServer 32 COB_IDServerToClient 8 nodeIDOfTheSDOServer";
const RPDO: &str = "8 maxSubIndex 32 COB_IDUsedByRPDO 8 transmissionType";
const TPDO: &str = "8 maxSubIndex 32 COB_IDUsedByTPDO 8 transmissionType 16 inhibitTime 8 compatibilityEntry
    16 eventTimer 8 SYNCStartValue";

pub(super) const FAMILIES: [StructureFamily; 6] = [
    family(0x1200, 0x127F, "SDOServerParameter", SDO),
    family(0x1280, 0x12FF, "SDOClientParameter", SDO_CLIENT),
    family(0x1400, 0x15FF, "RPDOCommunicationParameter", RPDO),
    family(0x1600, 0x17FF, "RPDOMappingParameter", MAPPING),
    family(0x1800, 0x19FF, "TPDOCommunicationParameter", TPDO),
    family(0x1A00, 0x1BFF, "TPDOMappingParameter", MAPPING),
];

impl StructureFamily {
    /// The family of an index.
    pub(super) fn of(index: u16) -> Option<&'static Self> {
        FAMILIES.iter().find(|family| (family.first..=family.last).contains(&index))
    }

    /// The members by sub-index.
    pub(super) fn fields(&self) -> impl Iterator<Item = StructureField> {
        let mut words = self.members.split_ascii_whitespace();
        std::iter::from_fn(move || {
            let data_type = match words.next()? {
                "8" => U8,
                "16" => U16,
                _ => U32,
            };
            Some(StructureField { data_type, name: words.next()? })
        })
    }

    /// The member for an entry; `None` if there is none of this type.
    pub(super) fn field(&self, entry: &ResolvedEntry<'_>) -> Option<StructureField> {
        let field = self.fields().nth(entry.sub.into())?;
        (entry.resolved.shape == ValueShape::Word(field.data_type)).then_some(field)
    }

    /// The initial value of a member without an entry: a PDO or SDO without COB-ID is not valid, and the stack
    /// checks the number of members.
    pub(super) fn missing(&self, field: &StructureField) -> u32 {
        match field.name {
            "maxSubIndex" => u32::try_from(self.fields().count() - 1).unwrap_or(0),
            name if name.starts_with("COB_ID") => 0x8000_0000,
            _ => 0,
        }
    }
}

/// The name of an object, if it matches the stack's expectation; `Err` if not.
pub(super) fn named(
    object: &ResolvedObject<'_>,
) -> Result<Option<&'static NamedObject>, &'static NamedObject> {
    let Some(named) = NAMED.iter().find(|named| named.index == object.index) else { return Ok(None) };
    let is = |entry: &ResolvedEntry<'_>, data_type| entry.resolved.shape == ValueShape::Word(data_type);
    let fits = match named.form {
        StackForm::Value(data_type, _) => {
            object.is_single() && object.entries.iter().all(|entry| is(entry, data_type))
        }
        StackForm::List(data_type, least) => {
            let elements = object.entries.iter().filter(|entry| entry.sub > 0);
            elements.clone().count() >= least && elements.clone().all(|entry| is(entry, data_type))
        }
        StackForm::Octets(least) => {
            let has_room = |entry: &ResolvedEntry<'_>| match entry.resolved.shape {
                ValueShape::Bytes(DataType::OCTET_STRING, room) => usize::from(room) >= least,
                _ => false,
            };
            object.is_single() && object.entries.iter().all(has_room)
        }
    };
    if fits { Ok(Some(named)) } else { Err(named) }
}

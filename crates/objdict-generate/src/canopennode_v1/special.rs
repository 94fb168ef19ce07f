//! Objects that the stack refers to by name, and those of which it has structures.

use crate::dictionary::{ResolvedEntry, ResolvedObject};
use crate::model::DataType;
use crate::resolve::Shape;

const U8: DataType = DataType::UNSIGNED8;
const U16: DataType = DataType::UNSIGNED16;
const U32: DataType = DataType::UNSIGNED32;

/// What the stack takes an object for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// A number of this type, with its value where the description lacks the object.
    Value(DataType, u32),
    /// At least this many elements of this type.
    List(DataType, usize),
    /// An octet string of at least this many bytes.
    Octets(usize),
}

/// An object with the name that the stack uses.
pub(super) struct Named {
    pub(super) index: u16,
    pub(super) name: &'static str,
    pub(super) form: Form,
}

const fn value(index: u16, name: &'static str, data_type: DataType, missing: u32) -> Named {
    Named { index, name, form: Form::Value(data_type, missing) }
}

pub(super) const NAMED: [Named; 15] = [
    value(0x1001, "errorRegister", U8, 0),
    Named { index: 0x1003, name: "preDefinedErrorField", form: Form::List(U32, 1) },
    value(0x1005, "COB_ID_SYNCMessage", U32, 0x80),
    value(0x1006, "communicationCyclePeriod", U32, 0),
    value(0x1007, "synchronousWindowLength", U32, 0),
    value(0x100C, "guardTime", U16, 0),
    value(0x100D, "lifeTimeFactor", U8, 0),
    value(0x1012, "COB_ID_TIME", U32, 0x100),
    value(0x1015, "inhibitTimeEMCY", U16, 0),
    Named { index: 0x1016, name: "consumerHeartbeatTime", form: Form::List(U32, 1) },
    value(0x1017, "producerHeartbeatTime", U16, 0),
    value(0x1019, "synchronousCounterOverflowValue", U8, 0),
    Named { index: 0x1029, name: "errorBehavior", form: Form::List(U8, 6) },
    value(0x1F80, "NMTStartup", U32, 0),
    Named { index: 0x2100, name: "errorStatusBits", form: Form::Octets(10) },
];

/// The members of the identity, which LSS reads.
pub(super) const IDENTITY: [&str; 4] = ["vendorID", "productCode", "revisionNumber", "serialNumber"];

/// A member of a structure of the stack.
pub(super) struct Field {
    pub(super) name: &'static str,
    pub(super) data_type: DataType,
}

/// Objects of which the stack has an array of structures.
pub(super) struct Family {
    pub(super) first: u16,
    pub(super) last: u16,
    pub(super) name: &'static str,
    /// By sub-index.
    pub(super) fields: &'static [Field],
    /// Whether the stack needs at least one.
    pub(super) needed: bool,
}

const fn field(name: &'static str, data_type: DataType) -> Field {
    Field { name, data_type }
}

const MAPPING: &[Field] = &[
    field("numberOfMappedObjects", U8),
    field("mappedObject1", U32),
    field("mappedObject2", U32),
    field("mappedObject3", U32),
    field("mappedObject4", U32),
    field("mappedObject5", U32),
    field("mappedObject6", U32),
    field("mappedObject7", U32),
    field("mappedObject8", U32),
];

pub(super) const FAMILIES: [Family; 6] = [
    Family {
        first: 0x1200,
        last: 0x127F,
        name: "SDOServerParameter",
        fields: &[
            field("maxSubIndex", U8),
            field("COB_IDClientToServer", U32),
            field("COB_IDServerToClient", U32),
        ],
        needed: true,
    },
    Family {
        first: 0x1280,
        last: 0x12FF,
        name: "SDOClientParameter",
        fields: &[
            field("maxSubIndex", U8),
            field("COB_IDClientToServer", U32),
            field("COB_IDServerToClient", U32),
            field("nodeIDOfTheSDOServer", U8),
        ],
        needed: false,
    },
    Family {
        first: 0x1400,
        last: 0x15FF,
        name: "RPDOCommunicationParameter",
        fields: &[field("maxSubIndex", U8), field("COB_IDUsedByRPDO", U32), field("transmissionType", U8)],
        needed: true,
    },
    Family { first: 0x1600, last: 0x17FF, name: "RPDOMappingParameter", fields: MAPPING, needed: true },
    Family {
        first: 0x1800,
        last: 0x19FF,
        name: "TPDOCommunicationParameter",
        fields: &[
            field("maxSubIndex", U8),
            field("COB_IDUsedByTPDO", U32),
            field("transmissionType", U8),
            field("inhibitTime", U16),
            field("compatibilityEntry", U8),
            field("eventTimer", U16),
            field("SYNCStartValue", U8),
        ],
        needed: true,
    },
    Family { first: 0x1A00, last: 0x1BFF, name: "TPDOMappingParameter", fields: MAPPING, needed: true },
];

impl Family {
    /// The family of an index.
    pub(super) fn of(index: u16) -> Option<&'static Self> {
        FAMILIES.iter().find(|family| (family.first..=family.last).contains(&index))
    }

    /// The member for an entry; `None` if it has none of this type.
    pub(super) fn field(&self, entry: &ResolvedEntry<'_>) -> Option<&Field> {
        let field = self.fields.get(usize::from(entry.sub))?;
        (entry.resolved.shape == Shape::Word(field.data_type)).then_some(field)
    }

    /// The initial value of a member without an entry: a PDO or SDO without COB-ID is not valid, and the stack
    /// checks the number of members.
    pub(super) fn missing(&self, field: &Field) -> u32 {
        match field.name {
            "maxSubIndex" => u32::try_from(self.fields.len() - 1).unwrap_or(0),
            name if name.starts_with("COB_ID") => 0x8000_0000,
            _ => 0,
        }
    }
}

/// The name of an object, if the stack can use it in its form; `Err` if it cannot.
pub(super) fn named(object: &ResolvedObject<'_>) -> Result<Option<&'static Named>, &'static Named> {
    let Some(named) = NAMED.iter().find(|named| named.index == object.index) else { return Ok(None) };
    let is = |entry: &ResolvedEntry<'_>, data_type| entry.resolved.shape == Shape::Word(data_type);
    let fits = match named.form {
        Form::Value(data_type, _) => {
            object.is_single() && object.entries.iter().all(|entry| is(entry, data_type))
        }
        Form::List(data_type, least) => {
            let elements = object.entries.iter().filter(|entry| entry.sub > 0);
            elements.clone().count() >= least && elements.clone().all(|entry| is(entry, data_type))
        }
        Form::Octets(least) => {
            let has_room = |entry: &ResolvedEntry<'_>| match entry.resolved.shape {
                Shape::Bytes(DataType::OCTET_STRING, room) => usize::from(room) >= least,
                _ => false,
            };
            object.is_single() && object.entries.iter().all(has_room)
        }
    };
    if fits { Ok(Some(named)) } else { Err(named) }
}

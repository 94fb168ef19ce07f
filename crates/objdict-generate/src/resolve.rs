//! A resolved entry: the data that tables need, as numbers and bytes.

use super::{LONGEST_VALUE, Note, Options};
use crate::literal::{self, Intended, Quirks};
use crate::model::{
    Access, DataType, Device, Entry, Field, InvalidValue, Object, ObjectType, PdoMapping, Place, TypeKind,
    Value,
};

/// The representation of an entry's values.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum ValueShape {
    /// BOOLEAN, INTEGERn, UNSIGNEDn, REALn or TIME_x: at most eight bytes, as a number.
    Word(DataType),
    /// VISIBLE_STRING, OCTET_STRING, UNICODE_STRING or DOMAIN: at most this many bytes.
    Bytes(DataType, u16),
    /// A device-specific type: exactly this many bytes.
    Block(u16),
}

impl ValueShape {
    /// Maximum size of a value in an SDO transfer, in bytes.
    pub(crate) fn size(self) -> usize {
        match self {
            Self::Word(data_type) => data_type.byte_length().map_or(0, usize::from),
            Self::Bytes(_, size) | Self::Block(size) => usize::from(size),
        }
    }

    /// The data type; `None` for a device-specific one.
    pub(crate) fn data_type(self) -> Option<DataType> {
        match self {
            Self::Word(data_type) | Self::Bytes(data_type, _) => Some(data_type),
            Self::Block(_) => None,
        }
    }
}

/// A value.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum Encoded {
    /// The number of a [`ValueShape::Word`]: two's complement, sign-extended; the bits of a REAL; the 48 bits of a TIME.
    Word(u64),
    /// The node-ID plus this number.
    Formula(u64),
    /// The bytes of any other shape.
    Bytes(Vec<u8>),
}

impl Encoded {
    /// The number; of a formula the offset to the node-ID, of bytes 0.
    pub(crate) fn word(&self) -> u64 {
        match self {
            Self::Word(word) | Self::Formula(word) => *word,
            Self::Bytes(_) => 0,
        }
    }

    /// The number on a node; without a node-ID nothing is added.
    pub(crate) fn on_node(&self, node_id: Option<u8>) -> u64 {
        self.word().wrapping_add(if self.is_formula() { node_id.unwrap_or(0).into() } else { 0 })
    }

    /// Whether the node-ID is added.
    pub(crate) fn is_formula(&self) -> bool {
        matches!(self, Self::Formula(_))
    }

    /// Whether all bytes are zero, without the node-ID.
    pub(crate) fn is_zero(&self) -> bool {
        self.word() == 0 && self.bytes().iter().all(|&byte| byte == 0)
    }

    /// The bytes of a non-numeric value; empty for a number.
    pub(crate) fn bytes(&self) -> &[u8] {
        match self {
            Self::Bytes(bytes) => bytes,
            Self::Word(_) | Self::Formula(_) => &[],
        }
    }

    /// The bytes of a value on a node; a number has this size.
    pub(crate) fn bytes_on(&self, node_id: Option<u8>, size: usize) -> Vec<u8> {
        match self {
            Self::Bytes(bytes) => bytes.clone(),
            number => number.on_node(node_id).to_le_bytes().into_iter().take(size).collect(),
        }
    }
}

/// An entry, resolved.
#[derive(Clone)]
pub(crate) struct EntryPlan {
    pub(crate) shape: ValueShape,
    pub(crate) access: Access,
    /// Whether a TPDO may map it.
    pub(crate) tpdo: bool,
    /// Whether an RPDO may map it.
    pub(crate) rpdo: bool,
    /// Whether the value never changes and remains in flash.
    pub(crate) constant: bool,
    pub(crate) default: Encoded,
    /// Only for a numeric [`ValueShape::Word`].
    pub(crate) low: Option<Encoded>,
    pub(crate) high: Option<Encoded>,
}

impl EntryPlan {
    /// Whether SDOs read the entry, and whether they write it.
    pub(crate) fn sdo(&self) -> (bool, bool) {
        (self.access.is_readable(), self.access.is_writable())
    }

    /// The word for the SDO access: none, read, write, or both.
    pub(crate) fn sdo_word(&self, words: [&'static str; 4]) -> &'static str {
        let (read, write) = self.sdo();
        words[usize::from(read) + 2 * usize::from(write)]
    }

    /// The word for the PDOs that may map the entry: none, TPDOs, RPDOs, or both.
    pub(crate) fn pdo_word(&self, words: [&'static str; 4]) -> &'static str {
        words[usize::from(self.tpdo) + 2 * usize::from(self.rpdo)]
    }

    /// The access type without information about the PDOs that may map the entry.
    pub(crate) fn plain_access(&self) -> &'static str {
        match self.access {
            Access::Rwr | Access::Rww => Access::Rw.name(),
            access => access.name(),
        }
    }

    /// The field of a limit, the low one of two.
    pub(crate) fn limit(&self) -> Option<Field> {
        let high = self.high.as_ref().map(|_| Field::HighLimit);
        self.low.as_ref().map(|_| Field::LowLimit).or(high)
    }

    /// The deviation in a table with values of fixed length.
    pub(crate) fn padding(&self) -> Option<String> {
        let ValueShape::Bytes(_, room) = self.shape else { return None };
        (self.default.bytes().len() < usize::from(room))
            .then(|| format!("a row has a fixed length; the value always has {room} bytes, padded with 0"))
    }
}

/// Resolves the entries of a device and collects inexpressible ones.
pub(crate) struct Resolver<'a> {
    device: &'a Device,
    options: &'a Options,
    /// Omissions and assumptions.
    pub(crate) notes: Vec<Note>,
    /// Values that cannot be represented.
    pub(crate) errors: Vec<Note>,
}

impl<'a> Resolver<'a> {
    pub(crate) fn new(device: &'a Device, options: &'a Options) -> Self {
        Self { device, options, notes: Vec::new(), errors: Vec::new() }
    }

    /// Resolves an entry of `object`; `None`, with a note, if a table cannot contain it.
    pub(crate) fn entry(&mut self, object: &Object, index: u16, sub: u8, entry: &Entry) -> Option<EntryPlan> {
        let place = Place::entry(index, sub);
        let object_type = entry.object_type.unwrap_or(ObjectType::Var);
        if object_type == ObjectType::Null {
            self.notes.push(Note::new(place, "an object of type NULL has no data and is omitted"));
            return None;
        }
        let data_type = self.data_type(object, (index, sub), entry)?;
        self.invalid_values(&place, entry, data_type);
        let access = self.access(object, &place, entry);
        let kind = data_type.kind();
        let (shape, default) = match kind {
            TypeKind::VisibleString | TypeKind::OctetString | TypeKind::UnicodeString | TypeKind::Domain => {
                let bytes = self.string(&place, entry, data_type);
                let capacity = self.capacity(data_type, access, bytes.len(), entry);
                if capacity == 0 && kind == TypeKind::Domain {
                    self.notes.push(
                        Note::new(place.clone(), "a DOMAIN without a default has no memory in the table")
                            .help("transfer the data in the application, or set a capacity for DOMAINs"),
                    );
                }
                (ValueShape::Bytes(data_type, capacity), Encoded::Bytes(bytes))
            }
            TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved => {
                let length = self.defined_length(&place, data_type)?;
                (ValueShape::Block(length), Encoded::Bytes(self.block(&place, entry, usize::from(length))))
            }
            _ => {
                let intended = intended(entry, &Field::DefaultValue, data_type);
                let value = entry.value().or(intended.as_ref());
                let default = self.word(place.clone().field(value_field(entry)), value, data_type);
                (ValueShape::Word(data_type), default.unwrap_or(Encoded::Word(0)))
            }
        };
        let (low, high) = self.limits(&place, entry, data_type);
        let (tpdo, rpdo) = directions(access, entry.pdo_mapping.unwrap_or_default());
        let constant = access == Access::Const || is_fixed(object, sub, access);
        let resolved = EntryPlan { shape, access, tpdo, rpdo, constant, default, low, high };
        Some(self.with_count(object, (index, sub), resolved))
    }

    /// Treats sub-index 0 of 1003h and 1016h as in an ARRAY that is stored in full, although compact storage only has a
    /// fixed count: an application changes both, and an SDO clears the error history.
    fn with_count(&mut self, object: &Object, (index, sub): (u16, u8), resolved: EntryPlan) -> EntryPlan {
        let is_implied = sub == 0 && object.compact.is_some() && object.subs.get(0).is_none();
        match index {
            0x1003 if is_implied => {
                let text = "the number of errors, which compact storage cannot describe, is `rw` and 0, as in CiA 301";
                self.notes.push(Note::new(Place::entry(index, sub), text));
                EntryPlan { access: Access::Rw, constant: false, default: Encoded::Word(0), ..resolved }
            }
            0x1016 if is_implied => EntryPlan { constant: false, ..resolved },
            _ => resolved,
        }
    }

    /// The data type of an entry, stated or implied by its object.
    fn data_type(&mut self, object: &Object, (index, sub): (u16, u8), entry: &Entry) -> Option<DataType> {
        let implied = || match (object.object_type(), sub) {
            (ObjectType::DefType, 0) => Some(DataType::UNSIGNED32), // its length in bits
            (ObjectType::DefStruct, 1..) => Some(DataType::UNSIGNED16), // the type of a member
            (object_type, 0) if object_type.has_subs() => DataType::of_sub_0(index),
            _ => None,
        };
        let data_type = entry.implied_type().or_else(implied);
        if data_type.is_none() {
            let place = Place::entry(index, sub).field(Field::DataType);
            self.notes.push(match entry.invalid_values.get(&Field::DataType) {
                Some(invalid) => {
                    Note::new(place, format!("`{}` is not a data type; the entry is omitted", invalid.text))
                }
                None => Note::new(place, "an entry without a data type is omitted"),
            });
        }
        data_type
    }

    fn access(&mut self, object: &Object, place: &Place, entry: &Entry) -> Access {
        if let Some(access) = entry.implied_access() {
            return access;
        }
        if matches!(object.object_type(), ObjectType::DefType | ObjectType::DefStruct) {
            return Access::Const;
        }
        let place = place.clone().field(Field::AccessType);
        let invalid = entry.invalid_values.get(&Field::AccessType);
        let intended = invalid.and_then(InvalidValue::intended_access);
        let access = intended.unwrap_or(Access::Ro);
        let instead = if intended.is_some() { "it is read as" } else { "it is assumed to be" };
        self.notes.push(match invalid {
            Some(InvalidValue { text, .. }) => {
                Note::new(place, format!("`{text}` is not an access type; {instead} `{access}`"))
            }
            None => Note::new(place, format!("an entry without an access type is assumed to be `{access}`")),
        });
        access
    }

    /// Notes invalid values.
    pub(crate) fn invalid_values(&mut self, place: &Place, entry: &Entry, data_type: DataType) {
        for (field, instead) in [
            (Field::ParameterValue, "the default is used, or zero or empty without one"),
            (Field::DefaultValue, "zero or empty is used"),
            (Field::LowLimit, "the limit is not enforced"),
            (Field::HighLimit, "the limit is not enforced"),
        ] {
            let ignored = field == Field::DefaultValue && entry.configured_value().is_some();
            let Some(invalid) = entry.invalid_values.get(&field).filter(|_| !ignored) else { continue };
            let instead = match invalid.intended(data_type).filter(|_| field != Field::ParameterValue) {
                Some(Intended::Value(value)) => format!("it is read as {value}"),
                Some(Intended::Nothing) => "it is read as missing".to_owned(),
                None => instead.to_owned(),
            };
            let text = format!("`{}` is not a valid {data_type}; {instead}", invalid.text);
            self.notes.push(Note::new(place.clone().field(field), text));
        }
    }

    /// The number of a value; `None` without a value.
    fn word(&mut self, place: Place, value: Option<&Value>, data_type: DataType) -> Option<Encoded> {
        let value = value?;
        if let Value::NodeId(offset) = *value {
            if data_type.is_integer() && value.resolve(data_type, 127).is_some() {
                return Some(Encoded::Formula(offset));
            }
            let text = format!("`{value}` does not fit {data_type} for every node-ID up to 127");
            self.errors.push(Note::new(place, text));
            return None;
        }
        // the type is not stated, but known
        let typed = match value {
            Value::Raw(text) => literal::value_in_line(text, Some(data_type), &mut Quirks::default()).ok(),
            _ => None,
        };
        let word = word(typed.as_ref().unwrap_or(value), data_type);
        if word.is_none() {
            self.errors.push(Note::new(place, format!("`{value}` is not a valid {data_type}")));
        }
        word.map(Encoded::Word)
    }

    /// The bytes of a string or DOMAIN value; empty without a value.
    fn string(&mut self, place: &Place, entry: &Entry, data_type: DataType) -> Vec<u8> {
        let place = place.clone().field(value_field(entry));
        let intended = intended(entry, &Field::DefaultValue, data_type);
        let Some(value) = entry.value().or(intended.as_ref()) else {
            return Vec::new();
        };
        match value.to_bytes(data_type) {
            Some(bytes) if bytes.len() <= LONGEST_VALUE => return bytes,
            Some(bytes) => {
                let text = format!(
                    "the value has {} bytes, but a table supports at most {LONGEST_VALUE}",
                    bytes.len()
                );
                self.errors.push(Note::new(place, text));
            }
            None => self.errors.push(Note::new(place, format!("`{value}` is not a valid {data_type}"))),
        }
        Vec::new()
    }

    /// Capacity of a string or DOMAIN with a default of `length` bytes: from the description, otherwise
    /// from the options.
    fn capacity(&self, data_type: DataType, access: Access, length: usize, entry: &Entry) -> u16 {
        let length = u16::try_from(length).unwrap_or(u16::MAX); // longer ones are already errors
        let (stated, room) = match data_type.kind() {
            TypeKind::Domain => (None, self.options.domain_capacity),
            TypeKind::UnicodeString => (characters(entry, 2), self.options.string_capacity.max(2) & !1),
            _ => (characters(entry, 1), self.options.string_capacity.max(1)),
        };
        match (access, stated) {
            (_, Some(stated)) => length.max(stated),
            (Access::Const, None) => length,
            (_, None) if access.is_writable() || length == 0 => length.max(room),
            (_, None) => length,
        }
    }

    /// Size of a type defined by a DEFTYPE object, whose value is the length in bits (CiA 301 §7.4.7.3).
    fn defined_length(&mut self, place: &Place, data_type: DataType) -> Option<u16> {
        let definition = self.device.object(data_type.0);
        let definition = definition.filter(|object| object.object_type() == ObjectType::DefType);
        let bits = definition.and_then(|object| object.entry(0)?.value()?.as_integer());
        let length = bits.and_then(|bits| u16::try_from((bits + 7) / 8).ok()).filter(|&length| length > 0);
        if length.is_none() {
            let text = format!("the length of the data type `{data_type}` is unknown; the entry is omitted");
            let note = Note::new(place.clone().field(Field::DataType), text);
            self.notes.push(note.help("describe the type as a DEFTYPE whose value is its length in bits"));
        }
        length
    }

    /// The value of a device-specific type: a little-endian number.
    fn block(&mut self, place: &Place, entry: &Entry, length: usize) -> Vec<u8> {
        let number = match entry.value() {
            None => Some(0),
            Some(Value::Raw(text)) => plain_number(text),
            Some(value) => value.as_integer().and_then(|number| u128::try_from(number).ok()),
        };
        let bytes =
            number.map(u128::to_le_bytes).filter(|bytes| bytes.iter().skip(length).all(|&byte| byte == 0));
        if let (None, Some(value)) = (bytes, entry.value()) {
            let text = format!("`{value}` cannot be converted to {length} bytes; zeros are used");
            self.notes.push(Note::new(place.clone().field(value_field(entry)), text));
        }
        let mut block: Vec<u8> = bytes.into_iter().flatten().take(length).collect();
        block.resize(length, 0);
        block
    }

    /// Both limits; `None` if the type has no order.
    fn limits(
        &mut self,
        place: &Place,
        entry: &Entry,
        data_type: DataType,
    ) -> (Option<Encoded>, Option<Encoded>) {
        let mut limit = |field: Field, value: Option<&Value>| {
            let value = value?;
            let place = place.clone().field(field);
            if !data_type.is_numeric() {
                let text = format!("values of {data_type} are not ordered; the limit is not enforced");
                self.notes.push(Note::new(place, text));
                return None;
            }
            if value.as_real().is_some_and(f64::is_nan) {
                self.notes.push(Note::new(place, "a limit that is not a number is not enforced"));
                return None;
            }
            self.word(place, Some(value), data_type)
        };
        let [low, high] = [(Field::LowLimit, &entry.low_limit), (Field::HighLimit, &entry.high_limit)].map(
            |(field, stated)| {
                let intended = intended(entry, &field, data_type);
                limit(field, stated.as_ref().or(intended.as_ref()))
            },
        );
        if let (Some(Encoded::Word(lowest)), Some(Encoded::Word(highest))) = (&low, &high)
            && is_above(*lowest, *highest, data_type)
        {
            let text = "the low limit is above the high one, so neither is enforced";
            self.notes.push(Note::new(place.clone().field(Field::LowLimit), text).warning());
            return (None, None);
        }
        (low, high)
    }
}

/// The shortest digits of a REAL in C and Rust; `None` if it is not finite.
pub(crate) fn digits(word: u64, data_type: DataType) -> Option<String> {
    if data_type.kind() == TypeKind::Real32 {
        let real = f32::from_bits(word as u32); // a REAL32 has 32 bits
        return real.is_finite().then(|| format!("{real:?}"));
    }
    let real = f64::from_bits(word);
    real.is_finite().then(|| format!("{real:?}"))
}

/// Whether values are a TIME_OF_DAY or a TIME_DIFFERENCE.
pub(crate) fn is_time(data_type: DataType) -> bool {
    matches!(data_type.kind(), TypeKind::TimeOfDay | TypeKind::TimeDifference)
}

/// Whether a number exceeds another one of its type.
fn is_above(left: u64, right: u64, data_type: DataType) -> bool {
    match data_type.kind() {
        TypeKind::Signed(_) => left.cast_signed() > right.cast_signed(),
        TypeKind::Real32 => f32::from_bits(left as u32) > f32::from_bits(right as u32), // their bits
        TypeKind::Real64 => f64::from_bits(left) > f64::from_bits(right),
        _ => left > right,
    }
}

/// The unambiguous value that an invalid string in a field means.
fn intended(entry: &Entry, field: &Field, data_type: DataType) -> Option<Value> {
    match entry.invalid_values.get(field)?.intended(data_type)? {
        Intended::Value(value) => Some(value),
        Intended::Nothing => None,
    }
}

/// The field with the value of an entry.
fn value_field(entry: &Entry) -> Field {
    if entry.configured_value().is_some() { Field::ParameterValue } else { Field::DefaultValue }
}

/// The number of a value of at most eight bytes; `None` if it is not valid for `data_type`.
fn word(value: &Value, data_type: DataType) -> Option<u64> {
    if data_type.integer_range().is_some() {
        let typed = Value::from_integer(value.as_integer()?, data_type)?;
        return match typed {
            Value::Boolean(value) => Some(u64::from(value)),
            Value::Unsigned(value) => Some(value),
            Value::Signed(value) => Some(value as u64), // same bits
            _ => None,
        };
    }
    let bytes = value.to_bytes(data_type).filter(|bytes| bytes.len() <= 8)?;
    Some(bytes.iter().rev().fold(0, |word, &byte| word << 8 | u64::from(byte)))
}

/// Parses a number: decimal or `0x…`.
fn plain_number(text: &str) -> Option<u128> {
    let text = text.trim();
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(hex) if !hex.starts_with('+') => u128::from_str_radix(hex, 16).ok(),
        Some(_) => None,
        None if text.starts_with('+') => None,
        None => text.parse().ok(),
    }
}

/// Whether a TPDO and whether an RPDO may map the entry.
fn directions(access: Access, mapping: PdoMapping) -> (bool, bool) {
    match mapping {
        PdoMapping::No => (false, false),
        PdoMapping::Optional | PdoMapping::Default => (access.fits_tpdo(), access.fits_rpdo()),
        PdoMapping::Tpdo => (access.fits_tpdo(), false),
        PdoMapping::Rpdo => (false, access.fits_rpdo()),
    }
}

/// Whether an entry is constant regardless of its access type: a type definition, and sub-index 0 of a RECORD
/// or of a compactly stored object.
fn is_fixed(object: &Object, sub: u8, access: Access) -> bool {
    let count = sub == 0 && (object.object_type() == ObjectType::Record || object.compact.is_some());
    let definition = matches!(object.object_type(), ObjectType::DefType | ObjectType::DefStruct);
    access == Access::Ro && (count || definition)
}

/// Minimum size of a string in bytes (`CO_stringLengthMin`), for characters of this size.
fn characters(entry: &Entry, bytes: u32) -> Option<u16> {
    let length = entry.stack.as_ref()?.min_string_length.filter(|&length| length > 0)?;
    u16::try_from(length.saturating_mul(bytes)).ok()
}

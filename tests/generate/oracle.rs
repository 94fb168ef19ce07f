//! The expected answers of a dictionary, derived from the model alone in the simplest way: limits are
//! compared as 128-bit integers and floating-point numbers, lengths are looked up, nothing is packed.

use std::collections::BTreeMap;

use objdict::model::{
    Access, DataType, Device, Entry, Field, Object, ObjectType, PdoMapping, TypeKind, Value,
};
use objdict::profile;
use objdict_model::literal::{self, Intended, Quirks};

/// Capacity of strings with a shorter default, see docs/reference/generate.md.
pub(crate) const STRING_ROOM: usize = 32;

/// The dictionary of a node.
pub(crate) struct Dictionary {
    node_id: u8,
    facts: BTreeMap<(u16, u8), Facts>,
    values: BTreeMap<(u16, u8), Vec<u8>>,
}

/// Bytes, or the abort code.
pub(crate) type Answer = Result<Vec<u8>, u32>;

impl Dictionary {
    pub(crate) fn new(device: &Device, node_id: u8) -> Self {
        let facts: BTreeMap<(u16, u8), Facts> = facts_of(device).collect();
        let values = facts.iter().map(|(&address, facts)| (address, facts.default_on(node_id)));
        Self { node_id, values: values.collect(), facts }
    }

    /// SDOs cannot write PDO mappings, as without hooks and `--runtime`.
    pub(crate) fn freeze_mappings(&mut self) {
        let is_mapping = |index| matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF);
        let facts = self
            .facts
            .iter_mut()
            .filter(|((index, _), facts)| is_mapping(*index) && facts.access.is_writable());
        facts.for_each(|(_, facts)| facts.access = Access::Ro);
    }

    fn facts(&self, index: u16, sub: u8) -> Result<&Facts, u32> {
        let exists = self.facts.range((index, 0)..=(index, 0xFF)).next().is_some();
        let missing = if exists { 0x0609_0011 } else { 0x0602_0000 };
        self.facts.get(&(index, sub)).ok_or(missing)
    }

    pub(crate) fn read(&self, index: u16, sub: u8, size: usize) -> Answer {
        let facts = self.facts(index, sub)?;
        if !facts.access.is_readable() {
            return Err(0x0601_0001);
        }
        if facts.has_no_data() {
            return Err(0x0800_0024);
        }
        let value = &self.values[&(index, sub)];
        if value.len() > size { Err(0x0504_0005) } else { Ok(value.clone()) }
    }

    pub(crate) fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Answer {
        let facts = self.facts(index, sub)?;
        if !facts.access.is_writable() {
            return Err(0x0601_0002);
        }
        if facts.has_no_data() {
            return Err(0x0800_0020);
        }
        let exact = facts.kind.is_none() || facts.data_type.byte_length().is_some();
        if bytes.len() > facts.size {
            return Err(0x0607_0012);
        }
        if exact && bytes.len() < facts.size {
            return Err(0x0607_0013);
        }
        if facts.kind == Some(TypeKind::UnicodeString) && bytes.len() % 2 == 1 {
            return Err(0x0607_0010);
        }
        facts.check(bytes, self.node_id)?;
        let mut value = bytes.to_vec();
        if matches!(facts.kind, Some(TypeKind::TimeOfDay | TypeKind::TimeDifference)) {
            value[3] &= 0x0F; // unused bits
        }
        self.values.insert((index, sub), value);
        Ok(Vec::new())
    }

    /// The bytes of a value, regardless of its access type.
    pub(crate) fn value(&self, index: u16, sub: u8) -> &[u8] {
        &self.values[&(index, sub)]
    }

    /// The table as the drivers print it.
    pub(crate) fn table(&self) -> Vec<String> {
        self.facts.iter().map(|(&(index, sub), facts)| facts.row(index, sub, self.node_id)).collect()
    }
}

/// All entries of a device in a table.
pub(crate) fn facts_of(device: &Device) -> impl Iterator<Item = ((u16, u8), Facts)> + '_ {
    let is_disabled =
        |object: &Object| object.main.stack.as_ref().is_some_and(|stack| stack.disabled == Some(true));
    let objects = device.objects.iter().filter(move |(_, object)| !is_disabled(object));
    objects.flat_map(move |(&index, object)| {
        object
            .entries()
            .filter_map(move |(sub, entry)| {
                Some(((index, sub), Facts::new(device, object, (index, sub), &entry)?))
            })
            .collect::<Vec<_>>()
    })
}

/// The relevant data of an entry.
pub(crate) struct Facts {
    pub(crate) data_type: DataType,
    /// `None` for a device-specific type.
    pub(crate) kind: Option<TypeKind>,
    pub(crate) access: Access,
    pub(crate) mapping: PdoMapping,
    /// Maximum size in bytes.
    pub(crate) size: usize,
    value: Option<Value>,
    pub(crate) low: Option<Value>,
    pub(crate) high: Option<Value>,
}

impl Facts {
    /// `None` if a table does not contain it.
    fn new(device: &Device, object: &Object, (index, sub): (u16, u8), entry: &Entry) -> Option<Self> {
        if entry.object_type == Some(ObjectType::Null) {
            return None;
        }
        let definition = matches!(object.object_type(), ObjectType::DefType | ObjectType::DefStruct);
        let domain = entry.object_type == Some(ObjectType::Domain);
        // the section that describes it: of compact sub-objects that of the object
        let is_compact = sub > 0 && object.compact.is_some() && object.subs.get(sub).is_none();
        let described = (!is_compact && object.object_type().has_subs()).then_some(sub);
        let data_type = match entry.data_type {
            Some(data_type) => data_type,
            None if domain => DataType::DOMAIN,
            None if object.object_type() == ObjectType::DefType && sub == 0 => DataType::UNSIGNED32,
            None if object.object_type() == ObjectType::DefStruct && sub == 0 => DataType::UNSIGNED8,
            None if object.object_type() == ObjectType::DefStruct => DataType::UNSIGNED16,
            None if definition => return None,
            None if object.object_type().has_subs() && sub == 0 => DataType::UNSIGNED8,
            None if entry.invalid_values.get(&Field::DataType).is_some() => return None,
            None => profile::data_type(device, index, described)?,
        };
        let invalid = entry.invalid_values.get(&Field::AccessType);
        let access = match invalid {
            Some(invalid) => invalid.intended_access(),
            None if domain || definition => None,
            None => profile::access(device, index, described),
        };
        let access = entry.access.or(access);
        let access = access.unwrap_or(match (domain, definition) {
            (true, _) => Access::Rw,
            (_, true) => Access::Const,
            _ => Access::Ro,
        });
        let own = matches!(data_type.kind(), TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved);
        let is_crossed = match (&entry.low_limit, &entry.high_limit) {
            (Some(low), Some(high)) => match (low.as_integer(), high.as_integer()) {
                (Some(low), Some(high)) => low > high,
                _ => low.as_real() > high.as_real(),
            },
            _ => false,
        };
        let limit = |limit: &Option<Value>| limit.clone().filter(|_| data_type.is_numeric() && !is_crossed);
        let mut facts = Self {
            data_type,
            kind: (!own).then_some(data_type.kind()),
            access,
            mapping: entry.pdo_mapping.unwrap_or_default(),
            size: 0,
            value: match entry.value() {
                Some(Value::Raw(text)) if entry.data_type.is_none() => {
                    literal::value(text, Some(data_type), &mut Quirks::default()).ok()
                }
                Some(value) => Some(value.clone()),
                None => {
                    match entry.invalid_values.get(&Field::DefaultValue).map(|text| text.intended(data_type))
                    {
                        Some(Some(Intended::Value(value))) => Some(value),
                        _ => None,
                    }
                }
            },
            low: limit(&entry.low_limit),
            high: limit(&entry.high_limit),
        };
        if (index, sub) == (0x1003, 0) && object.compact.is_some() && object.subs.get(0).is_none() {
            (facts.access, facts.value) = (Access::Rw, Some(Value::Unsigned(0))); // the number of errors
        }
        facts.size = match data_type.byte_length() {
            Some(length) => usize::from(length),
            None if own => defined_length(device, data_type)?,
            None => facts.room(entry),
        };
        Some(facts)
    }

    /// Whether another entry accepts the same values.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        let facts =
            |facts: &Self| (facts.data_type, facts.access, facts.size, facts.low.clone(), facts.high.clone());
        facts(self) == facts(other)
    }

    fn room(&self, entry: &Entry) -> usize {
        let length = self.default_on(1).len();
        let stated = entry.stack.as_ref().and_then(|stack| stack.min_string_length).unwrap_or(0);
        let bytes = if self.kind == Some(TypeKind::UnicodeString) { 2 } else { 1 };
        if self.kind == Some(TypeKind::Domain) {
            return length;
        }
        let grows = self.access != Access::Const && (length == 0 || self.access.is_writable());
        length.max(match stated {
            0 if grows => STRING_ROOM,
            stated => stated as usize * bytes,
        })
    }

    pub(crate) fn has_no_data(&self) -> bool {
        self.kind == Some(TypeKind::Domain) && self.size == 0
    }

    /// The bytes of the default for a node.
    pub(crate) fn default_on(&self, node_id: u8) -> Vec<u8> {
        let zeros = vec![
            0;
            usize::from(self.data_type.byte_length().unwrap_or(0)).max(if self.kind.is_none() {
                self.size
            } else {
                0
            })
        ];
        match &self.value {
            None => zeros,
            Some(Value::Raw(text)) => raw_bytes(text, self.size),
            Some(value) => {
                let value = value.resolve(self.data_type, node_id).expect("a formula fits");
                value.to_bytes(self.data_type).expect("a value of its type")
            }
        }
    }

    /// Checks a value given as bytes of the right length.
    fn check(&self, bytes: &[u8], node_id: u8) -> Result<(), u32> {
        if !self.data_type.is_numeric() {
            return Ok(());
        }
        let Some(value) = Value::from_bytes(bytes, self.data_type) else {
            return Err(0x0609_0030); // BOOLEAN
        };
        let limit =
            |limit: &Option<Value>| limit.as_ref().and_then(|limit| limit.resolve(self.data_type, node_id));
        let (low, high) = (limit(&self.low), limit(&self.high));
        let order = |limit: Option<Value>| {
            limit.map(|limit| match (value.as_integer(), limit.as_integer()) {
                (Some(value), Some(limit)) => Some(value.cmp(&limit)),
                _ => value.as_real()?.partial_cmp(&limit.as_real()?),
            })
        };
        match (order(low), order(high)) {
            (Some(None), _) | (_, Some(None)) => Err(0x0609_0030), // NaN
            (Some(Some(std::cmp::Ordering::Less)), _) => Err(0x0609_0032),
            (_, Some(Some(std::cmp::Ordering::Greater))) => Err(0x0609_0031),
            _ => Ok(()),
        }
    }

    fn row(&self, index: u16, sub: u8, node_id: u8) -> String {
        let code = if self.kind.is_some() { self.data_type.0 } else { 0 };
        let (access, mapping) = (self.access, self.mapping);
        let tpdo = matches!(mapping, PdoMapping::Optional | PdoMapping::Default | PdoMapping::Tpdo);
        let rpdo = matches!(mapping, PdoMapping::Optional | PdoMapping::Default | PdoMapping::Rpdo);
        let formula = matches!(self.value, Some(Value::NodeId(_)));
        let flags = [
            access.is_readable(),
            access.is_writable(),
            tpdo && access.fits_tpdo(),
            rpdo && access.fits_rpdo(),
            formula,
        ];
        let flags: String = flags.map(|flag| if flag { '1' } else { '0' }).iter().collect();
        let default = self.default_on(0); // a formula without the node-ID
        let limit = |limit: &Option<Value>| {
            let Some(limit) = limit else { return "-".to_owned() };
            match limit.resolve(self.data_type, node_id).unwrap() {
                Value::Real32(number) => format!("{:X}", number.to_bits()),
                Value::Real64(number) => format!("{:X}", number.to_bits()),
                number => format!("{:X}", number.as_integer().unwrap() as u64),
            }
        };
        let (low, high) = (limit(&self.low), limit(&self.high));
        format!("{index:04X} {sub:02X} {code:02X} {flags} {} {} {low} {high}", self.size, hex(&default))
    }
}

/// Size of a type defined by the device.
fn defined_length(device: &Device, data_type: DataType) -> Option<usize> {
    let definition = device.object(data_type.0)?;
    let bits = definition.entry(0)?.value()?.as_integer()?;
    (definition.object_type() == ObjectType::DefType).then_some(usize::try_from(bits).ok()?.div_ceil(8))
}

/// The bytes of a decimal or hexadecimal number; zeros if it is not valid.
fn raw_bytes(text: &str, size: usize) -> Vec<u8> {
    let number = match text.strip_prefix("0x") {
        Some(hex) => u64::from_str_radix(hex, 16),
        None => text.parse(),
    };
    let mut bytes = number.unwrap_or(0).to_le_bytes().to_vec();
    bytes.resize(size.max(8), 0);
    if bytes[size..].iter().any(|&byte| byte != 0) {
        return vec![0; size];
    }
    bytes.truncate(size);
    bytes
}

/// Bytes as the drivers print them.
pub(crate) fn hex(bytes: &[u8]) -> String {
    if bytes.is_empty() {
        return "-".to_owned();
    }
    bytes.iter().map(|byte| format!("{byte:02X}")).collect()
}

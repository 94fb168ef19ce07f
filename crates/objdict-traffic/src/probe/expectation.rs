//! What a description says of an entry, for a node-ID.

use std::cmp::Ordering;

use objdict_model::model::{Access, DataType, Device, Entry, Object, TypeKind, Value};

/// An entry as it is described.
#[derive(Clone, Debug)]
pub(super) struct Expectation {
    pub(super) index: u16,
    pub(super) sub: u8,
    pub(super) name: String,
    pub(super) data_type: Option<DataType>,
    pub(super) access: Option<Access>,
    /// As an SDO transfers it: the configured value of a DCF, else the default.
    pub(super) default: Option<Vec<u8>>,
    pub(super) low: Option<Value>,
    pub(super) high: Option<Value>,
    pub(super) is_mappable: bool,
    /// Whether it is sub-index 0 of an array or a record.
    pub(super) is_highest_sub: bool,
}

impl Expectation {
    pub(super) fn of(device: &Device, index: u16, sub: u8, node_id: u8) -> Option<Self> {
        let object = device.object(index)?;
        let entry = object.entry(sub)?;
        Some(Self::new(object, index, sub, &entry, node_id))
    }

    pub(super) fn new(object: &Object, index: u16, sub: u8, entry: &Entry, node_id: u8) -> Self {
        let data_type = entry.implied_type();
        let resolved = |value: &Value| value.resolve(data_type?, node_id);
        let value = entry.value().and_then(resolved);
        let has_subs = object.object_type().has_subs();
        let name = match (sub, has_subs) {
            (_, false) => entry.name.to_string(),
            _ => format!("{}: {}", object.name(), entry.name),
        };
        Self {
            index,
            sub,
            name,
            data_type,
            access: entry.implied_access(),
            default: value.and_then(|value| value.to_bytes(data_type?)),
            low: entry.low_limit.as_ref().and_then(resolved),
            high: entry.high_limit.as_ref().and_then(resolved),
            is_mappable: entry.is_mappable(),
            is_highest_sub: sub == 0 && has_subs,
        }
    }

    /// How messages call it.
    pub(super) fn place(&self) -> String {
        if self.sub == 0 && !self.is_highest_sub {
            format!("{:04X}h", self.index)
        } else {
            place(self.index, self.sub)
        }
    }

    pub(super) fn is_readable(&self) -> bool {
        self.access.is_none_or(Access::is_readable)
    }

    pub(super) fn is_writable(&self) -> bool {
        self.access.is_none_or(Access::is_writable)
    }

    /// The bytes of each value; `None` for a type whose values have lengths of their own.
    pub(super) fn length(&self) -> Option<usize> {
        self.data_type.and_then(DataType::byte_length).map(usize::from)
    }

    /// Whether each value has the same number of bytes as this one.
    pub(super) fn fits(&self, bytes: &[u8]) -> bool {
        self.length().is_none_or(|length| length == bytes.len())
    }

    pub(super) fn value(&self, bytes: &[u8]) -> Option<Value> {
        Value::from_bytes(bytes, self.data_type?)
    }

    /// The limit that a value exceeds, and where the value is.
    pub(super) fn exceeded(&self, bytes: &[u8]) -> Option<(&Value, Ordering)> {
        let value = self.value(bytes)?;
        let beyond =
            |limit: Option<&'_ Value>, side| limit.is_some_and(|limit| order(&value, limit) == Some(side));
        if beyond(self.low.as_ref(), Ordering::Less) {
            return self.low.as_ref().map(|low| (low, Ordering::Less));
        }
        let is_above = beyond(self.high.as_ref(), Ordering::Greater);
        self.high.as_ref().filter(|_| is_above).map(|high| (high, Ordering::Greater))
    }

    /// Values that are not allowed, such as one below the low limit.
    pub(super) fn beyond_limits(&self) -> impl Iterator<Item = Vec<u8>> {
        let limits = [(self.low.as_ref(), -1), (self.high.as_ref(), 1)];
        let numbers = limits.into_iter().filter_map(|(limit, step)| Some(limit?.as_integer()? + step));
        numbers.filter_map(|number| self.bytes_of(number)).filter(|bytes| self.exceeded(bytes).is_some())
    }

    /// Two allowed values, so that one is not the present one.
    pub(super) fn allowed_values(&self) -> Vec<Vec<u8>> {
        let present =
            self.default.as_ref().and_then(|bytes| self.value(bytes)).and_then(|value| value.as_integer());
        let present = present.filter(|_| self.data_type.is_some_and(DataType::is_integer)).unwrap_or(0);
        let limits = [&self.low, &self.high].into_iter().flatten().filter_map(Value::as_integer);
        let numbers = [present + 1, present - 1, present, present + 2].into_iter().chain(limits);
        let mut values: Vec<Vec<u8>> = Vec::new();
        for bytes in numbers.filter_map(|number| self.bytes_of(number)) {
            if values.len() < 2 && self.exceeded(&bytes).is_none() && !values.contains(&bytes) {
                values.push(bytes);
            }
        }
        values
    }

    fn bytes_of(&self, number: i128) -> Option<Vec<u8>> {
        let data_type = self.data_type.filter(|data_type| data_type.is_integer())?;
        Value::from_integer(number, data_type)?.to_bytes(data_type)
    }

    /// Why bytes of the right number are not a value of the type.
    pub(super) fn defect(&self, bytes: &[u8]) -> Option<&'static str> {
        match self.data_type?.kind() {
            TypeKind::Boolean if bytes != [0] && bytes != [1] => Some("neither 0 nor 1"),
            TypeKind::VisibleString if !is_visible(bytes) => Some("characters that are not ASCII"),
            TypeKind::UnicodeString if bytes.len() % 2 == 1 => Some("half a character"),
            TypeKind::Real32 | TypeKind::Real64 => {
                let number = self.value(bytes).and_then(|value| value.as_real());
                number.is_some_and(f64::is_nan).then_some("no number (NaN)")
            }
            _ => None,
        }
    }

    /// A value in words.
    pub(super) fn shown(&self, bytes: &[u8]) -> String {
        match self.value(bytes) {
            Some(value @ (Value::Signed(_) | Value::Unsigned(_))) => match value.as_integer() {
                Some(number) if number > 9 => format!("{number} ({number:#X})"),
                number => number.map(|number| number.to_string()).unwrap_or_default(),
            },
            Some(value @ (Value::Real32(_) | Value::Real64(_))) => value.to_string(),
            Some(Value::Text(text)) => format!("\"{text}\""),
            _ => hex(bytes),
        }
    }
}

/// Printable ASCII; many devices end a string with a zero.
fn is_visible(bytes: &[u8]) -> bool {
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    bytes[..end].iter().all(|byte| matches!(byte, 0x20..=0x7E | b'\t' | b'\r' | b'\n'))
        && bytes[end..].iter().all(|&byte| byte == 0)
}

/// The order of a value and a limit of the same type.
fn order(value: &Value, limit: &Value) -> Option<Ordering> {
    match value.as_integer().zip(limit.as_integer()) {
        Some((value, limit)) => Some(value.cmp(&limit)),
        None => value.as_real()?.partial_cmp(&limit.as_real()?),
    }
}

/// Bytes as two digits each, with blanks between them.
pub(super) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ")
}

/// How messages call an entry.
pub(super) fn place(index: u16, sub: u8) -> String {
    format!("{index:04X}h sub-index {sub}")
}

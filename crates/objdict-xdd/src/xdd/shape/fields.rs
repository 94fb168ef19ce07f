//! The fields of parts: for strings, and for other parts; the values of an entry, `DeviceIdentity` or `identity`, and
//! the settings for CANopenNode generators in the spelling of CANopenEditor.

use std::borrow::Cow;

use super::TextForm;
use crate::model::{
    DataTypeRef, DeviceIdentity, Entry, Field, Property, SimpleType, StackOptions, Value, VariableRef,
};

/// A field for an attribute or the text of an element.
pub(crate) trait TextField {
    /// Stores a value; `false` if the field already has one or the string is not valid.
    fn accept(&mut self, text: &str) -> bool;

    /// Whether it has a value.
    fn is_set(&self) -> bool;

    /// The value; `None` if there is nothing to write.
    fn text(&self) -> Option<Cow<'_, str>>;
}

/// A field for elements with one value each.
pub(crate) trait ValueFields {
    /// Adds a value; `None` if the field is full.
    fn add(&mut self) -> Option<&mut dyn TextField>;

    /// Calls `put` for each value.
    fn each(&self, put: &mut dyn FnMut(&str));
}

/// A string that always exists; a missing one is empty.
impl TextField for Box<str> {
    fn accept(&mut self, text: &str) -> bool {
        let is_first = !self.is_set();
        if is_first {
            *self = text.into();
        }
        is_first
    }

    fn is_set(&self) -> bool {
        !self.is_empty()
    }

    fn text(&self) -> Option<Cow<'_, str>> {
        Some(Cow::Borrowed(self))
    }
}

impl<T: TextForm> TextField for Option<T> {
    fn accept(&mut self, text: &str) -> bool {
        if self.is_some() {
            return false;
        }
        *self = T::parse(text);
        self.is_some()
    }

    fn is_set(&self) -> bool {
        self.is_some()
    }

    fn text(&self) -> Option<Cow<'_, str>> {
        self.as_ref().map(T::print)
    }
}

impl<F: TextField> ValueFields for F {
    fn add(&mut self) -> Option<&mut dyn TextField> {
        if self.is_set() { None } else { Some(self) }
    }

    fn each(&self, put: &mut dyn FnMut(&str)) {
        if let Some(text) = self.text() {
            put(&text);
        }
    }
}

impl ValueFields for Vec<Box<str>> {
    fn add(&mut self) -> Option<&mut dyn TextField> {
        self.push(Box::default());
        self.last_mut().map(|last| last as &mut dyn TextField)
    }

    fn each(&self, put: &mut dyn FnMut(&str)) {
        self.iter().for_each(|text| put(text));
    }
}

/// A field for parts `C`, each in its own element.
pub(crate) trait Holds<C> {
    /// Adds a part; `None` if the field is full.
    fn add(&mut self, new: fn() -> C) -> Option<&mut C>;

    /// Calls `put` for each part.
    fn each(&self, put: &mut dyn FnMut(&C));
}

/// A part that always exists; an empty one is not written.
impl<C: Default + PartialEq> Holds<C> for C {
    fn add(&mut self, _: fn() -> C) -> Option<&mut C> {
        if *self == C::default() { Some(self) } else { None }
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        if *self != C::default() {
            put(self);
        }
    }
}

impl<C> Holds<C> for Option<C> {
    fn add(&mut self, new: fn() -> C) -> Option<&mut C> {
        if self.is_some() { None } else { Some(self.insert(new())) }
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        self.iter().for_each(put);
    }
}

impl<C> Holds<C> for Option<Box<C>> {
    fn add(&mut self, new: fn() -> C) -> Option<&mut C> {
        if self.is_some() { None } else { Some(self.insert(Box::new(new()))) }
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        self.iter().for_each(|part| put(part));
    }
}

impl<C> Holds<C> for Vec<C> {
    fn add(&mut self, new: fn() -> C) -> Option<&mut C> {
        self.push(new());
        self.last_mut()
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        self.iter().for_each(put);
    }
}

/// Several `variableRef`.
impl Holds<VariableRef> for Option<DataTypeRef> {
    fn add(&mut self, new: fn() -> VariableRef) -> Option<&mut VariableRef> {
        match self.get_or_insert_with(|| DataTypeRef::Variables(Vec::new())) {
            DataTypeRef::Variables(variables) => variables.add(new),
            _ => None,
        }
    }

    fn each(&self, put: &mut dyn FnMut(&VariableRef)) {
        if let Some(DataTypeRef::Variables(variables)) = self {
            variables.iter().for_each(put);
        }
    }
}

/// An element such as `UDINT`, or a `dataTypeIDRef`.
macro_rules! data_types {
    ($($Part:ty: $Variant:ident;)+) => {$(
        impl Holds<$Part> for Option<DataTypeRef> {
            fn add(&mut self, new: fn() -> $Part) -> Option<&mut $Part> {
                match self {
                    Some(_) => None,
                    None => match self.insert(DataTypeRef::$Variant(new())) {
                        DataTypeRef::$Variant(part) => Some(part),
                        _ => None,
                    },
                }
            }

            fn each(&self, put: &mut dyn FnMut(&$Part)) {
                if let Some(DataTypeRef::$Variant(part)) = self {
                    put(part);
                }
            }
        }
    )+};
}

data_types! { SimpleType: Simple; Box<str>: Defined; }

/// One of the values of an entry.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slots {
    Default,
    Actual,
    Low,
    High,
}

impl Slots {
    pub(crate) const fn field(self) -> Field {
        match self {
            Self::Default => Field::DefaultValue,
            Self::Actual => Field::ParameterValue,
            Self::Low => Field::LowLimit,
            Self::High => Field::HighLimit,
        }
    }

    pub(crate) fn get(self, entry: &Entry) -> Option<&Value> {
        match self {
            Self::Default => entry.default.as_ref(),
            Self::Actual => entry.configured_value(),
            Self::Low => entry.low_limit.as_ref(),
            Self::High => entry.high_limit.as_ref(),
        }
    }

    pub(crate) fn set(self, entry: &mut Entry, value: Value) {
        match self {
            Self::Default => entry.default = Some(value),
            Self::Actual => entry.configured_mut().value = Some(value),
            Self::Low => entry.low_limit = Some(value),
            Self::High => entry.high_limit = Some(value),
        }
    }
}

/// The complete content of the element.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct IdentityContent {
    pub(crate) vendor_name: Option<Box<str>>,
    /// As written.
    pub(crate) vendor_id: Option<Box<str>>,
    pub(crate) product_name: Option<Box<str>>,
    /// As written.
    pub(crate) product_id: Option<Box<str>>,
    pub(crate) order_numbers: Vec<Box<str>>,
    /// Fields that an EDS lacks, without further order numbers.
    pub(crate) rest: DeviceIdentity,
}

/// Moves the properties that CANopenEditor defines out of a list. Invalid values and repeated properties
/// remain in the list.
pub(crate) fn take_stack_options(options: &mut Option<Box<StackOptions>>, properties: &mut Vec<Property>) {
    let mut taken = options.take().unwrap_or_default();
    properties.retain(|property| !take(&mut taken, &property.name, &property.value));
    *options = Some(taken).filter(|taken| **taken != StackOptions::default());
}

/// Stores a setting if its value is spelled as the writer spells it.
fn take(options: &mut StackOptions, name: &str, value: &str) -> bool {
    let mut alone = StackOptions::default();
    let is_whole = alone.set(name, value) && alone.settings().all(|(_, written)| written == value);
    is_whole && options.set(name, value)
}

/// The properties that [`take_stack_options`] took, in the order of CANopenEditor. They precede other
/// properties.
pub(crate) fn stack_properties(options: &StackOptions) -> Vec<Property> {
    let property = |(name, value): (&str, String)| Property { name: name.into(), value: value.into() };
    options.settings().map(property).collect()
}

/// Stores an attribute of a `CANopenObject` or `CANopenSubObject` that older versions of CANopenEditor and
/// earlier projects used instead; `false` for any other attribute or an invalid value.
pub(crate) fn stack_attribute(options: &mut StackOptions, name: &str, value: &str) -> bool {
    let property = match name {
        // the first spelling is a typo in CANopenEditor
        "edseditor_extenstion_storagelocation" | "edseditor_extension_storagelocation" | "memoryType" => {
            "CO_storageGroup"
        }
        "edseditor_extension_notifyonchange" | "edseditor_extenstion_notifyonchange" | "TPDOdetectCOS" => {
            "CO_flagsPDO"
        }
        "disabled" => "CO_disabled",
        _ => return false,
    };
    take(options, property, value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::SrdoAccess;

    fn property((name, value): (&str, &str)) -> Property {
        Property { name: name.into(), value: value.into() }
    }

    fn taken(properties: &mut Vec<Property>) -> Option<Box<StackOptions>> {
        let mut options = None;
        take_stack_options(&mut options, properties);
        options
    }

    #[test]
    fn known_properties_move_and_come_back() {
        let known = [
            ("CO_disabled", "true"),
            ("CO_countLabel", "TPDO"),
            ("CO_storageGroup", "PERSIST_COMM"),
            ("CO_extensionIO", "false"),
            ("CO_flagsPDO", "true"),
            ("CO_accessSRDO", "trx"),
            ("CO_stringLengthMin", "10"),
        ];
        let mut properties: Vec<_> = known.map(property).to_vec();
        properties.insert(3, property(("scale", "log")));
        let options = taken(&mut properties).unwrap_or_default();
        assert_eq!(properties, [property(("scale", "log"))]);
        assert_eq!(options.srdo_access, Some(SrdoAccess::Trx));
        assert_eq!(options.min_string_length, Some(10));
        assert_eq!(stack_properties(&options), known.map(property));
    }

    #[test]
    fn what_is_no_value_stays() {
        let odd = [
            ("CO_disabled", "yes"),
            ("CO_flagsPDO", "1"),
            ("CO_accessSRDO", "both"),
            ("CO_stringLengthMin", "0x10"),
            ("CO_stringLengthMin", "-1"),
            ("co_countlabel", "TPDO"),
        ];
        let mut properties: Vec<_> = odd.map(property).to_vec();
        assert_eq!(taken(&mut properties), None);
        assert_eq!(properties, odd.map(property));
        let mut twice = [("CO_countLabel", "SYNC"), ("CO_countLabel", "TIME")].map(property).to_vec();
        let options = taken(&mut twice).unwrap_or_default();
        assert_eq!(options.count_label.as_deref(), Some("SYNC"));
        assert_eq!(twice, [property(("CO_countLabel", "TIME"))]);
    }

    #[test]
    fn older_files_have_attributes() {
        let mut options = StackOptions::default();
        assert!(stack_attribute(&mut options, "edseditor_extenstion_storagelocation", "ROM"));
        assert!(stack_attribute(&mut options, "edseditor_extension_notifyonchange", "false"));
        assert!(!stack_attribute(&mut options, "edseditor_extension_notifyonchange", "true"));
        assert!(!stack_attribute(&mut options, "edseditor_extension_colour", "red"));
        assert_eq!((options.storage_group.as_deref(), options.detects_change), (Some("ROM"), Some(false)));
    }
}

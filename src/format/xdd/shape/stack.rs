//! What description files say to the generators of CANopenNode: properties of parameters, as CANopenEditor spells them.

use super::Text;
use crate::model::{Property, SrdoAccess, StackOptions};

/// Takes the properties that CANopenEditor gives a meaning out of a list. What is no value of its property, and what
/// stands again, stays in the list.
pub(crate) fn take_stack_options(options: &mut Option<Box<StackOptions>>, properties: &mut Vec<Property>) {
    let mut taken = options.take().unwrap_or_default();
    properties.retain(|property| !take(&mut taken, &property.name, &property.value));
    *options = Some(taken).filter(|taken| **taken != StackOptions::default());
}

fn take(options: &mut StackOptions, name: &str, value: &str) -> bool {
    match name {
        "CO_disabled" => set(&mut options.disabled, value),
        "CO_countLabel" => set(&mut options.count_label, value),
        "CO_storageGroup" => set(&mut options.storage_group, value),
        "CO_extensionIO" => set(&mut options.io_extension, value),
        "CO_flagsPDO" => set(&mut options.detects_change, value),
        "CO_accessSRDO" => set(&mut options.srdo_access, value),
        "CO_stringLengthMin" => set(&mut options.min_string_length, value),
        _ => false,
    }
}

/// Takes a value that is spelled as it would be written again.
fn set<T: Text>(field: &mut Option<T>, value: &str) -> bool {
    if field.is_some() {
        return false;
    }
    *field = T::parse(value).filter(|parsed| parsed.print() == value);
    field.is_some()
}

/// The properties that [`take_stack_options`] took, in the order of CANopenEditor. They stand before others.
pub(crate) fn stack_properties(options: &StackOptions) -> Vec<Property> {
    let StackOptions {
        storage_group,
        count_label,
        disabled,
        srdo_access,
        min_string_length,
        detects_change,
        io_extension,
    } = options;
    let mut properties = Vec::new();
    add(&mut properties, "CO_disabled", disabled);
    add(&mut properties, "CO_countLabel", count_label);
    add(&mut properties, "CO_storageGroup", storage_group);
    add(&mut properties, "CO_extensionIO", io_extension);
    add(&mut properties, "CO_flagsPDO", detects_change);
    add(&mut properties, "CO_accessSRDO", srdo_access);
    add(&mut properties, "CO_stringLengthMin", min_string_length);
    properties
}

fn add<T: Text>(properties: &mut Vec<Property>, name: &str, field: &Option<T>) {
    properties
        .extend(field.as_ref().map(|value| Property { name: name.into(), value: value.print().into() }));
}

/// Takes an attribute of a `CANopenObject` or `CANopenSubObject` by which older versions of CANopenEditor said the same;
/// `false` when it is none of those, or no value of it.
pub(crate) fn stack_attribute(options: &mut StackOptions, name: &str, value: &str) -> bool {
    match name {
        // the one name is misspelled in the files
        "edseditor_extenstion_storagelocation" | "edseditor_extension_storagelocation" => {
            set(&mut options.storage_group, value)
        }
        "edseditor_extension_notifyonchange" | "edseditor_extenstion_notifyonchange" => {
            set(&mut options.detects_change, value)
        }
        _ => false,
    }
}

impl Text for SrdoAccess {
    fn parse(text: &str) -> Option<Self> {
        Self::from_name(text)
    }

    fn print(&self) -> std::borrow::Cow<'_, str> {
        self.name().into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

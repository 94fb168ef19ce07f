//! Settings for the generators of CANopenNode: properties of parameters, as CANopenEditor spells them.

use crate::model::{Property, StackOptions};

/// Takes the properties that CANopenEditor defines out of a list. Invalid values and repeated properties
/// stay in the list.
pub(crate) fn take_stack_options(options: &mut Option<Box<StackOptions>>, properties: &mut Vec<Property>) {
    let mut taken = options.take().unwrap_or_default();
    properties.retain(|property| !take(&mut taken, &property.name, &property.value));
    *options = Some(taken).filter(|taken| **taken != StackOptions::default());
}

/// Takes a setting if its value is spelled as the writer spells it.
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

/// Takes an attribute of a `CANopenObject` or `CANopenSubObject` that older versions of CANopenEditor, and the
/// projects before, used instead; `false` for any other attribute or an invalid value.
pub(crate) fn stack_attribute(options: &mut StackOptions, name: &str, value: &str) -> bool {
    let property = match name {
        // the first spelling is an error of CANopenEditor
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

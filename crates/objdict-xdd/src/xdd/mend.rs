//! Changes of a description to edits of its elements and attributes. Only what has one counterpart in CiA 311 is changed.

use super::locate::{Locator, attribute_name};
use crate::diagnostic::Change;
use crate::model::{Field, Part, Place};
use crate::source::Span;
use crate::xml::{Editor, Element, Tree};

/// The edits that make the changes, in the order of the text; `None` where it has no place for one of them.
pub fn edits(tree: &Tree, locator: &Locator, changes: &[Change]) -> Option<Vec<(Span, String)>> {
    let mut rewriter = Rewriter { tree, locator, editor: Editor::new(tree) };
    changes.iter().try_for_each(|change| rewriter.change(change))?;
    rewriter.editor.into_list().ok()
}

/// A text in the making.
struct Rewriter<'a> {
    tree: &'a Tree,
    locator: &'a Locator,
    editor: Editor<'a>,
}

impl<'a> Rewriter<'a> {
    fn change(&mut self, change: &Change) -> Option<()> {
        match change {
            Change::Replace(span, text) => {
                self.editor.replace(*span, text.as_str());
                Some(())
            }
            Change::Set(Place { part, field: Some(field) }, value) => self.set(part, field, value),
            Change::Remove(Place { part, field: Some(field) }) => self.remove_field(part, field),
            Change::Remove(Place { part, field: None }) => {
                let element = self.entry(part)?;
                self.editor.remove_element(element);
                Some(())
            }
            // there are no lists of objects to change, and no sections to add
            _ => None,
        }
    }

    fn set(&mut self, part: &Part, field: &Field, value: &str) -> Option<()> {
        if let Some(element) = self.entry(part) {
            let name = attribute_name(field);
            let value = attribute_text(field, value)?;
            if element.attribute(&name).is_none()
                && self.locator.in_parameter(self.tree, element, field).is_some()
            {
                return None;
            }
            self.editor.set_attribute(element, &name, &value);
            return Some(());
        }
        match part {
            Part::FileInfo => self.set_fact(field, value),
            Part::DeviceInfo => self.set_identity(field, value).or_else(|| self.set_feature(field, value)),
            _ => None,
        }
    }

    /// A fact about the file, which both profiles state.
    fn set_fact(&mut self, field: &Field, value: &str) -> Option<()> {
        let name = match field {
            Field::FileName => "fileName",
            Field::CreatedBy => "fileCreator",
            Field::ModifiedBy => "fileModifiedBy",
            _ => return None,
        };
        let layout = self.locator.layout(self.tree)?;
        let mut is_set = None;
        for profile in [layout.device, layout.network].into_iter().flatten() {
            self.editor.set_attribute(profile.body, name, value);
            is_set = Some(());
        }
        is_set
    }

    fn set_identity(&mut self, field: &Field, value: &str) -> Option<()> {
        let name = match field {
            Field::VendorName => "vendorName",
            Field::VendorNumber => "vendorID",
            Field::ProductName => "productName",
            Field::ProductNumber => "productID",
            _ => return None,
        };
        let element = self.locator.layout(self.tree)?.in_device(&["DeviceIdentity", name])?;
        self.editor.set_text(element, value);
        Some(())
    }

    /// An attribute of the general features, which are there.
    fn set_feature(&mut self, field: &Field, value: &str) -> Option<()> {
        let name = match field {
            Field::NrOfRxPdo => "nrOfRxPDO",
            Field::NrOfTxPdo => "nrOfTxPDO",
            Field::Granularity => "granularity",
            Field::DynamicChannelsSupported => "dynamicChannels",
            Field::GroupMessaging => "groupMessaging",
            Field::LssSupported => "layerSettingServiceSlave",
            Field::SimpleBootUpSlave => "bootUpSlave",
            _ => return None,
        };
        let path = ["NetworkManagement", "CANopenGeneralFeatures"];
        let element = self.locator.layout(self.tree)?.in_network(&path)?;
        let is_number = matches!(
            field,
            Field::NrOfRxPdo | Field::NrOfTxPdo | Field::Granularity | Field::DynamicChannelsSupported
        );
        let text = match value {
            "0" if !is_number => "false",
            "1" if !is_number => "true",
            number if is_number && number.bytes().all(|byte| byte.is_ascii_digit()) => number,
            _ => return None,
        };
        self.editor.set_attribute(element, name, text);
        Some(())
    }

    fn remove_field(&mut self, part: &Part, field: &Field) -> Option<()> {
        let element = self.entry(part)?;
        let name = attribute_name(field);
        // what CiA 311 demands stays
        let is_demanded = matches!(field, Field::ParameterName | Field::ObjectType);
        element.attribute(&name).filter(|_| !is_demanded)?;
        self.editor.remove_attribute(element, &name);
        Some(())
    }

    /// The element of an object or sub-object.
    fn entry(&self, part: &Part) -> Option<Element<'a>> {
        match *part {
            Part::Object(index) => self.locator.element(self.tree, index, None),
            Part::Entry(index, sub) => self.locator.element(self.tree, index, Some(sub)),
            _ => None,
        }
    }
}

/// The text of an attribute for a value as an EDS has it; `None` for what CiA 311 says elsewhere or not at all.
fn attribute_text(field: &Field, value: &str) -> Option<String> {
    let number = || match value.strip_prefix("0x") {
        Some(digits) => u32::from_str_radix(digits, 16).ok(),
        None => value.parse().ok(),
    };
    Some(match (field, value) {
        (Field::ObjectType | Field::SubNumber, _) => number()?.to_string(),
        (Field::DataType, _) => format!("{:04X}", number()?),
        (Field::ObjFlags, _) => match number()? {
            flags @ 0..=0xFFFF => format!("{flags:04X}"),
            flags => format!("{flags:08X}"),
        },
        // the parameter says what is input and what is output
        (Field::AccessType, "rwr" | "rww") => return None,
        (Field::PdoMapping, "0") => "no".to_owned(),
        (Field::PdoMapping, "1") => "optional".to_owned(),
        (Field::PdoMapping, _) => return None,
        (
            Field::ParameterName
            | Field::AccessType
            | Field::LowLimit
            | Field::HighLimit
            | Field::DefaultValue
            | Field::ParameterValue
            | Field::Denotation,
            _,
        ) => value.to_owned(),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_spelled_as_attributes() {
        for (field, eds, xdd) in [
            (Field::DataType, "0x7", Some("0007")),
            (Field::ObjectType, "0x9", Some("9")),
            (Field::ObjFlags, "0x1", Some("0001")),
            (Field::PdoMapping, "1", Some("optional")),
            (Field::AccessType, "ro", Some("ro")),
            (Field::AccessType, "rww", None),
            (Field::DefaultValue, "$NODEID+0x180", Some("$NODEID+0x180")),
            (Field::CompactSubObj, "3", None),
        ] {
            assert_eq!(attribute_text(&field, eds).as_deref(), xdd, "{field}");
        }
    }
}

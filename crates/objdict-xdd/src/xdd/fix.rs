//! Applies changes of a description as edits of its elements and attributes. Changes without a unique
//! counterpart in CiA 311 are not applied.

use super::locate::{ElementLocator, attribute_of};
use super::schema::{self, DEVICE_BODY, GENERAL_FEATURES, OBJECT};
use crate::diagnostic::Change;
use crate::model::{Field, Part, Place};
use crate::source::Span;
use crate::xml::{Element, Tree, XmlEditor, n};

/// The edits for the changes, in text order; `None` if a change cannot be expressed as an edit.
pub fn edits(tree: &Tree, locator: &ElementLocator, changes: &[Change]) -> Option<Vec<(Span, String)>> {
    let mut rewriter = XddRewriter { tree, locator, editor: XmlEditor::new(tree) };
    changes.iter().try_for_each(|change| rewriter.change(change))?;
    rewriter.editor.into_list().ok()
}

/// A text during rewriting.
struct XddRewriter<'a> {
    tree: &'a Tree,
    locator: &'a ElementLocator,
    editor: XmlEditor<'a>,
}

impl<'a> XddRewriter<'a> {
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
            // CiA 311 has no lists of objects to change and no sections to add
            _ => None,
        }
    }

    fn set(&mut self, part: &Part, field: &Field, value: &str) -> Option<()> {
        if let Some(element) = self.entry(part) {
            let known = OBJECT.attribute_of(field)?;
            let value = known.spelled(value)?;
            if element.attribute(known.name).is_none()
                && let Some(span) = self.locator.in_parameter(self.tree, element, field)
            {
                return self.set_parameter(element, span, field, &value);
            }
            self.editor.set_attribute(element, known.name.text(), &value);
            return Some(());
        }
        match part {
            Part::FileInfo => self.set_fact(field, value),
            Part::DeviceInfo => self.set_identity(field, value).or_else(|| self.set_feature(field, value)),
            _ => None,
        }
    }

    /// A number in the parameter of an element, if that is of no other.
    fn set_parameter(&mut self, element: Element<'_>, span: Span, field: &Field, value: &str) -> Option<()> {
        let is_number =
            *field == Field::DefaultValue && value.bytes().all(|byte| byte.is_ascii_alphanumeric());
        if !is_number || !self.locator.has_own_parameter(self.tree, element) {
            return None;
        }
        self.editor.replace(span, value);
        Some(())
    }

    /// Sets a value about the file, which both profiles contain.
    fn set_fact(&mut self, field: &Field, value: &str) -> Option<()> {
        let known = match field {
            // after the version, in the same attribute
            Field::FileRevision => DEVICE_BODY.attribute_of(&Field::FileVersion)?,
            Field::FileVersion => return None,
            field => DEVICE_BODY.attribute_of(field).filter(|_| !matches!(field, Field::Named(_)))?,
        };
        let layout = self.locator.layout(self.tree)?;
        let mut is_set = None;
        for profile in [layout.device, layout.network].into_iter().flatten() {
            let value = match field {
                Field::FileRevision => {
                    let stated = profile.body.attribute(known.name)?.value();
                    let version = stated.split_once('.').map_or(&*stated, |(version, _)| version);
                    format!("{version}.{value}")
                }
                _ => known.spelled(value)?,
            };
            self.editor.set_attribute(profile.body, known.name.text(), &value);
            is_set = Some(());
        }
        is_set
    }

    fn set_identity(&mut self, field: &Field, value: &str) -> Option<()> {
        let known = schema::identity_element(field).filter(|_| *field != Field::OrderCode)?;
        let element = self.locator.layout(self.tree)?.in_device(&[n::DeviceIdentity, known.name])?;
        self.editor.set_text(element, value);
        Some(())
    }

    /// An attribute of the general features, if that element exists.
    fn set_feature(&mut self, field: &Field, value: &str) -> Option<()> {
        let known = GENERAL_FEATURES.attribute_of(field).filter(|_| !matches!(field, Field::Named(_)))?;
        let path = [n::NetworkManagement, n::CANopenGeneralFeatures];
        let element = self.locator.layout(self.tree)?.in_network(&path)?;
        let is_decimal = value.bytes().all(|byte| byte.is_ascii_digit());
        let text = known.spelled(value).filter(|_| is_decimal)?;
        self.editor.set_attribute(element, known.name.text(), &text);
        Some(())
    }

    fn remove_field(&mut self, part: &Part, field: &Field) -> Option<()> {
        let element = self.entry(part)?;
        let attribute = attribute_of(element, OBJECT, field)?;
        // CiA 311 requires these
        if matches!(field, Field::ParameterName | Field::ObjectType) {
            return None;
        }
        self.editor.remove_attribute(element, attribute.name());
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
            let spelled = OBJECT.attribute_of(&field).and_then(|known| known.spelled(eds));
            assert_eq!(spelled.as_deref(), xdd, "{field}");
        }
    }
}

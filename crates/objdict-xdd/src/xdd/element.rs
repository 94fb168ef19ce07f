//! Elements and attributes as CiA 311 declares them.

use super::schema::TextKind;
use crate::literal;
use crate::model::Field;
use crate::xml::{Name, n};

/// An element in a certain context: `range` of `allowedValues` differs from `range` of `rangeList`.
#[derive(Debug)]
pub(crate) struct SchemaElement {
    pub name: Name,
    /// Whether version 1.1 declares the element globally, so that it is in the namespace there.
    pub is_global: bool,
    pub attributes: &'static [SchemaAttribute],
    /// The kind of the text; `None` if only elements are allowed.
    pub text: Option<SchemaAttribute>,
    /// The child elements, in order.
    pub content: &'static [Child],
    /// The attributes and children that version 1.0 does not define.
    pub newer: &'static [Name],
}

/// An attribute, or the text of an element.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SchemaAttribute {
    pub name: Name,
    pub kind: TextKind,
    pub need: Occurrence,
    /// The field of the model, if it is not a plain string.
    pub field: Option<fn() -> Field>,
    /// The maximum, if it is lower than the type's.
    pub most: Option<u64>,
    /// The placeholder for a missing value. The reader drops it.
    pub unstated: Option<&'static str>,
}

/// Whether an attribute or element is required.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Occurrence {
    Optional,
    /// Required by the standard, optional for readers.
    Required,
    /// The element is meaningless without it.
    Key,
    /// Not allowed here by the standard but part of the model: reported, and still read and written.
    Stray,
}

/// Names of elements with their Boolean marks.
pub(crate) type Marks = Vec<(Box<str>, bool)>;

/// A position in the order of the children: one element, or a choice of several.
#[derive(Debug)]
pub(crate) struct Child {
    pub of: &'static [&'static SchemaElement],
    pub least: u32,
    pub most: u32,
    pub need: Occurrence,
}

/// The maximum number of slots of an element.
pub(crate) const MAX_SLOTS: usize = 16;

/// No maximum.
pub(crate) const MANY: u32 = u32::MAX;

impl Child {
    /// The element with this name, if it is allowed here.
    pub(crate) fn element(&self, name: Name) -> Option<&'static SchemaElement> {
        self.of.iter().copied().find(|element| element.name == name)
    }

    /// The maximum number of elements with the name of this one. Only `variableRef` may occur more often
    /// than its alternatives.
    pub(crate) fn most_of(&self, element: &SchemaElement) -> u32 {
        if element.name == n::variableRef { MANY } else { self.most }
    }
}

impl SchemaElement {
    /// Whether the standard leaves the content open, as for the simple types.
    pub(crate) fn is_opaque(&self) -> bool {
        self.attributes.is_empty() && self.content.is_empty() && self.text.is_none()
    }

    /// Whether the element can contain names and descriptions.
    pub(crate) fn has_labels(&self) -> bool {
        self.content.iter().any(|slot| slot.need != Occurrence::Stray && slot.element(n::label).is_some())
    }

    /// The attribute with this name.
    pub(crate) fn attribute(&self, name: Name) -> Option<(usize, &'static SchemaAttribute)> {
        self.attributes.iter().enumerate().find(|(_, attribute)| attribute.name == name)
    }

    /// The attribute of a field that an EDS has too.
    pub(crate) fn attribute_of(&self, field: &Field) -> Option<&'static SchemaAttribute> {
        self.attributes.iter().find(|attribute| attribute.field().as_ref() == Some(field))
    }

    /// The slot of a child. The search begins at `from`, because children are usually in order.
    pub(crate) fn slot(&self, name: Name, from: usize) -> Option<(usize, &'static SchemaElement)> {
        let slots = || self.content.iter().enumerate();
        let find = |(number, slot): (usize, &Child)| Some((number, slot.element(name)?));
        slots().skip(from).find_map(find).or_else(|| slots().take(from).find_map(find))
    }

    /// The location of the value of an element with one value: its first attribute, otherwise its text.
    pub(crate) fn holder(&self) -> Name {
        self.attributes.first().filter(|_| self.text.is_none()).map_or(n::text, |attribute| attribute.name)
    }
}

impl SchemaAttribute {
    /// The field of the model, if it is not a plain string.
    pub(crate) fn field(&self) -> Option<Field> {
        self.field.map(|field| field())
    }

    /// The placeholder for a required attribute without a value; `None` if the element is meaningless without
    /// it.
    pub(crate) fn placeholder(&self) -> Option<&'static str> {
        self.unstated.or(match self.kind {
            TextKind::Language => Some(super::defaults::LANGUAGE),
            TextKind::Text if self.need == Occurrence::Required => Some(""),
            _ => None,
        })
    }

    /// An EDS value in the spelling of this attribute; `None` if the attribute cannot express it.
    pub(crate) fn spelled(&self, text: &str) -> Option<String> {
        let number = || match text.strip_prefix("0x") {
            Some(digits) => u32::from_str_radix(digits, 16).ok(),
            None => text.parse().ok(),
        };
        Some(match (self.kind, text) {
            (TextKind::Number(..), _) => number()?.to_string(),
            (TextKind::Hex(..), _) => match number()? {
                number @ 0..=0xFFFF => format!("{number:04X}"),
                number => format!("{number:08X}"),
            },
            (TextKind::Boolean, "0") => "false".to_owned(),
            (TextKind::Boolean, "1") => "true".to_owned(),
            (TextKind::Word(_), _) if self.name == n::PDOmapping => match text {
                "0" => "no".to_owned(),
                "1" => "optional".to_owned(),
                _ => return None,
            },
            (TextKind::Date, _) => literal::date(text)?.0.to_iso(),
            (TextKind::Time, _) => literal::clock_time(text)?.to_iso(true),
            // the parameter specifies inputs and outputs
            (TextKind::Word(_), "rwr" | "rww") | (TextKind::Boolean, _) => return None,
            _ => text.to_owned(),
        })
    }
}

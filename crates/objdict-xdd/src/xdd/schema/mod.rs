//! CiA 311 (versions 1.0 and 1.1) in one table: the elements, their content and its order, the values of
//! their attributes, and their fields in the model. Reading, writing, checking, locating and the wording of
//! findings use this table.

mod application;
mod container;
mod device;
mod lexical;
mod network;
mod values;
mod xsd;

use std::any::Any;

pub(crate) use self::application::{APPLICATION_PROCESS, PARAMETER};
pub(crate) use self::container::{
    CONTAINER, DEVICE_BODY, DEVICE_HEADER, EXTERNAL_NETWORK_BODY, NETWORK_BODY, NETWORK_HEADER, PROFILE,
};
pub(crate) use self::device::{
    DEVICE_FUNCTION, DEVICE_IDENTITY, DEVICE_MANAGER, ORDER_NUMBER, PRODUCT_ID, PRODUCT_NAME, VENDOR_ID,
    VENDOR_NAME,
};
pub(crate) use self::lexical::{decimal, is_language, is_name, is_name_character, whole_number};
pub(crate) use self::network::*;
pub(crate) use self::values::{BAUD_RATES, Kind, Target};
pub use self::xsd::xsd;
use super::fact::Fact;
use super::shape::{Parts, TextField, Values};
use crate::model::{Entry, Field, Value};
use crate::xml::{Name, n};

/// An element in a certain context: `range` of `allowedValues` differs from `range` of `rangeList`.
#[derive(Debug)]
pub(crate) struct Element {
    pub name: Name,
    /// Whether version 1.1 declares the element globally, so that it is in the namespace there.
    pub is_global: bool,
    pub attributes: &'static [Attribute],
    /// The kind of the text; `None` if only elements are allowed.
    pub text: Option<Attribute>,
    /// The child elements, in order.
    pub content: &'static [Slot],
    /// The attributes and children that version 1.0 does not define.
    pub newer: &'static [Name],
}

/// An attribute, or the text of an element.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attribute {
    pub name: Name,
    pub kind: Kind,
    pub need: Need,
    pub at: At,
}

/// Whether an attribute or element is required.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Need {
    Optional,
    /// Required by the standard, optional for readers.
    Required,
    /// Without it the element has no meaning.
    Key,
    /// Not defined by the standard at this place but part of the model: reported, and still read and
    /// written.
    Stray,
}

/// The field of a part of the model: for writing, and for reading.
pub(crate) struct Lens<T: ?Sized> {
    pub get: for<'a> fn(&'a dyn Any) -> Option<&'a T>,
    pub get_mut: for<'a> fn(&'a mut dyn Any) -> Option<&'a mut T>,
}

/// Where the part stores the value of an attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum At {
    /// Not stored, or stored by the code that reads the element.
    Nowhere,
    /// In a field for texts; a text it does not accept becomes a leftover.
    Text(Lens<dyn TextField>),
    /// In a field that an EDS has too; a text it does not accept becomes an invalid value.
    Fact(FactAt),
    /// Among the values of an entry, which are read once the data type is known.
    Value(Slots),
}

/// Where the part stores a value that an EDS has too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FactAt {
    /// `None` for a field that only CiA 311 has: it is named like the attribute.
    pub field: Option<&'static Field>,
    /// The maximum, if it is lower than that of the type.
    pub most: Option<u64>,
    /// The placeholder for a missing value. The reader drops it.
    pub unstated: Option<&'static str>,
    pub lens: Lens<dyn Fact>,
}

/// One of the values of an entry.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slots {
    Default,
    Actual,
    Low,
    High,
}

/// Where the part stores elements.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Child {
    /// Not stored, or stored by the code that reads the element.
    Nowhere,
    /// The element groups others of the same part.
    Same,
    /// The element has this constant content.
    Fixed(&'static str),
    /// As parts.
    Parts(Lens<dyn Parts>),
    /// As values: the first attribute of the element, or its text.
    Values(Lens<dyn Values>),
    /// One for the first element of the choice, and one for the others.
    Either(&'static Child, &'static Child),
}

/// A place in the order of the children: one element, or a choice of several.
#[derive(Debug)]
pub(crate) struct Slot {
    pub of: &'static [&'static Element],
    pub least: u32,
    pub most: u32,
    pub need: Need,
    pub at: Child,
}

/// The maximum number of slots of an element.
pub(crate) const MAX_SLOTS: usize = 16;

/// No maximum.
const MANY: u32 = u32::MAX;

impl<T: ?Sized> Clone for Lens<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: ?Sized> Copy for Lens<T> {}

impl<T: ?Sized> std::fmt::Debug for Lens<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Lens")
    }
}

impl Slot {
    /// The element with this name, if it is allowed here.
    pub(crate) fn element(&self, name: Name) -> Option<&'static Element> {
        self.of.iter().copied().find(|element| element.name == name)
    }

    /// The maximum number of elements with the name of this one. Only `variableRef` may occur more often
    /// than its alternatives.
    pub(crate) fn most_of(&self, element: &Element) -> u32 {
        if element.name == n::variableRef { MANY } else { self.most }
    }

    /// Its elements and where the part stores them: one place for all, or one for each.
    pub(crate) fn kept(&self) -> impl Iterator<Item = (&'static Element, Child)> {
        let at = move |number: usize| match self.at {
            Child::Either(first, others) => Some(if number == 0 { *first } else { *others }),
            one => Some(one).filter(|_| number == 0),
        };
        self.of.iter().enumerate().filter_map(move |(number, element)| Some((*element, at(number)?)))
    }
}

impl Element {
    /// Whether the standard leaves the content open, as for the simple types.
    pub(crate) fn is_opaque(&self) -> bool {
        self.attributes.is_empty() && self.content.is_empty() && self.text.is_none()
    }

    /// Whether the element can contain names and descriptions.
    pub(crate) fn has_labels(&self) -> bool {
        self.content.iter().any(|slot| slot.need != Need::Stray && slot.element(n::label).is_some())
    }

    /// The attribute with this name.
    pub(crate) fn attribute(&self, name: Name) -> Option<(usize, &'static Attribute)> {
        self.attributes.iter().enumerate().find(|(_, attribute)| attribute.name == name)
    }

    /// The attribute of a field that an EDS has too.
    pub(crate) fn attribute_of(&self, field: &Field) -> Option<&'static Attribute> {
        self.attributes.iter().find(|attribute| attribute.field().as_ref() == Some(field))
    }

    /// The slot of a child. The search begins at `from`, because children are usually in order.
    pub(crate) fn slot(&self, name: Name, from: usize) -> Option<(usize, &'static Element)> {
        let slots = || self.content.iter().enumerate();
        let find = |(number, slot): (usize, &Slot)| Some((number, slot.element(name)?));
        slots().skip(from).find_map(find).or_else(|| slots().take(from).find_map(find))
    }

    /// What holds the value of an element with one value: its first attribute, else its text.
    pub(crate) fn holder(&self) -> Name {
        self.attributes.first().filter(|_| self.text.is_none()).map_or(n::text, |attribute| attribute.name)
    }
}

impl Attribute {
    /// The field of the model, if it is not a plain text.
    pub(crate) fn field(&self) -> Option<Field> {
        match self.at {
            At::Fact(FactAt { field: Some(field), .. }) => Some(field.clone()),
            At::Fact(_) => Some(Field::Named(self.name.text().into())),
            At::Value(value) => Some(value.field()),
            At::Nowhere | At::Text(_) => match self.name {
                n::name => Some(Field::ParameterName),
                n::denotation => Some(Field::Denotation),
                n::subNumber => Some(Field::SubNumber),
                _ => None,
            },
        }
    }

    /// The text for a required attribute without a value; `None` if the element has no meaning without it.
    pub(crate) fn placeholder(&self) -> Option<&'static str> {
        match (self.at, self.kind) {
            (At::Fact(FactAt { unstated: Some(text), .. }), _) => Some(text),
            (_, Kind::Language) => Some(super::defaults::LANGUAGE),
            (_, Kind::Text) if self.need == Need::Required => Some(""),
            _ => None,
        }
    }

    /// An EDS value in the spelling of this attribute; `None` if the attribute cannot express it.
    pub(crate) fn spelled(&self, text: &str) -> Option<String> {
        let number = || match text.strip_prefix("0x") {
            Some(digits) => u32::from_str_radix(digits, 16).ok(),
            None => text.parse().ok(),
        };
        Some(match (self.kind, text) {
            (Kind::Number(..), _) => number()?.to_string(),
            (Kind::Hex(..), _) => match number()? {
                number @ 0..=0xFFFF => format!("{number:04X}"),
                number => format!("{number:08X}"),
            },
            (Kind::Boolean, "0") => "false".to_owned(),
            (Kind::Boolean, "1") => "true".to_owned(),
            (Kind::Word(_), _) if self.name == n::PDOmapping => match text {
                "0" => "no".to_owned(),
                "1" => "optional".to_owned(),
                _ => return None,
            },
            // the parameter specifies inputs and outputs
            (Kind::Word(_), "rwr" | "rww") | (Kind::Boolean, _) => return None,
            _ => text.to_owned(),
        })
    }
}

impl Slots {
    pub(crate) fn field(self) -> Field {
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

/// The element of the identity whose text is a field of an EDS.
pub(crate) fn identity_element(field: &Field) -> Option<&'static Element> {
    Some(match field {
        Field::VendorName => &VENDOR_NAME,
        Field::VendorNumber => &VENDOR_ID,
        Field::ProductName => &PRODUCT_NAME,
        Field::ProductNumber => &PRODUCT_ID,
        Field::OrderCode => &ORDER_NUMBER,
        _ => return None,
    })
}

/// A field of a part, or a function that returns it.
macro_rules! lens {
    ($Part:ident self) => {
        $crate::xdd::schema::Lens {
            get: |part| Some(part.downcast_ref::<$Part>()?),
            get_mut: |part| Some(part.downcast_mut::<$Part>()?),
        }
    };
    ($Part:ident $($path:tt)+) => {
        $crate::xdd::schema::Lens {
            get: |part| Some(&part.downcast_ref::<$Part>()?.$($path)+),
            get_mut: |part| Some(&mut part.downcast_mut::<$Part>()?.$($path)+),
        }
    };
}
use lens;

/// Where the value of an attribute is stored: `[field]` takes texts, `{Field field}` has that name in an
/// EDS, `<Value>` is a value of an entry, and `(CONSTANT)` is defined separately.
macro_rules! at {
    ($Part:ident) => { At::Nowhere };
    ($Part:ident [$($path:tt)+]) => { At::Text(lens!($Part $($path)+)) };
    ($Part:ident ($lens:ident)) => { At::Text($lens) };
    ($Part:ident (value $value:ident)) => { At::Value(Slots::$value) };
    ($Part:ident {$field:ident $path:ident $(most $most:literal)? $(unstated $text:expr)?}) => {
        At::Fact(FactAt {
            field: at!(@field $field),
            most: at!(@option $($most)?),
            unstated: at!(@option $($text)?),
            lens: lens!($Part $path),
        })
    };
    (@field Named) => { None };
    (@field $field:ident) => { Some(&Field::$field) };
    (@option) => { None };
    (@option $value:expr) => { Some($value) };
}
use at;

/// Where elements are stored: `[field]` as parts, `{field}` as values, `same` in the same part, and
/// `(CONSTANT)` is defined separately.
macro_rules! child {
    ($Part:ident) => { Child::Nowhere };
    ($Part:ident same) => { Child::Same };
    ($Part:ident [$($path:tt)+]) => { Child::Parts(lens!($Part $($path)+)) };
    ($Part:ident {$($path:tt)+}) => { Child::Values(lens!($Part $($path)+)) };
    ($Part:ident ($lens:ident)) => { Child::Parts($lens) };
    ($Part:ident (same $other:tt)) => { Child::Either(&Child::Same, &child!($Part $other)) };
    ($Part:ident $text:literal) => { Child::Fixed($text) };
}
use child;

/// The minimum and maximum of a [`Slot`].
macro_rules! slot {
    (one $of:tt $at:expr) => { slot!(@ $of, 1, 1, Required, $at) };
    (key $of:tt $at:expr) => { slot!(@ $of, 1, 1, Key, $at) };
    (maybe $of:tt $at:expr) => { slot!(@ $of, 0, 1, Optional, $at) };
    (some $of:tt $at:expr) => { slot!(@ $of, 1, super::MANY, Required, $at) };
    (two $of:tt $at:expr) => { slot!(@ $of, 2, super::MANY, Required, $at) };
    (any $of:tt $at:expr) => { slot!(@ $of, 0, super::MANY, Optional, $at) };
    (stray $of:tt $at:expr) => { slot!(@ $of, 0, super::MANY, Stray, $at) };
    (@ [$($of:ident)|+], $($rest:tt)+) => { slot!(@@ &[$(&$of),+], $($rest)+) };
    (@ ($of:ident), $($rest:tt)+) => { slot!(@@ $of, $($rest)+) };
    (@ $of:ident, $($rest:tt)+) => { slot!(@@ &[&$of], $($rest)+) };
    (@@ $of:expr, $least:expr, $most:expr, $need:ident, $at:expr) => {
        Slot { of: $of, least: $least, most: $most, need: Need::$need, at: $at }
    };
}
use slot;

/// Declares elements: `NAME global|local name of Part (attributes) = text, [children], newer [names];`
///
/// The mark after the name of an attribute is `?` (optional), `!` (required), `*` (without it the element
/// has no meaning) or `+` (stray).
///
/// A child is `count WHAT`, where the count is `one`, `key` (one; the element has no meaning without it),
/// `maybe`, `some`, `two` (at least), `any` or `stray`, and WHAT is an element, a choice `[A | B]` or a list
/// `(LIST)` of elements. `=>` is followed by where the part stores it; an element of `Nothing` is not
/// stored, or by the code that reads it.
macro_rules! elements {
    ($($NAME:ident $form:ident $name:ident of $Part:ident
        $(($($attribute:ident $need:tt: $kind:expr $(=> $at:tt)?),+ $(,)?))?
        $(= $text:expr $(=> $text_at:tt)?)?
        $(, [$($count:ident $of:tt $(=> $child:tt)?),+ $(,)?])?
        $(, newer [$($newer:ident),+ $(,)?])?
    ;)+) => {
        $(pub(crate) static $NAME: Element = Element {
            name: n::$name,
            is_global: elements!(@ $form),
            attributes: &[$($(Attribute {
                name: n::$attribute,
                kind: $kind,
                need: elements!(@ $need),
                at: at!($Part $($at)?),
            }),+)?],
            text: elements!(@text $Part $($text, $($text_at)?)?),
            content: &[$($(slot!($count $of child!($Part $($child)?))),+)?],
            newer: &[$($(n::$newer),+)?],
        };)+
    };
    (@ global) => { true };
    (@ local) => { false };
    (@ ?) => { Need::Optional };
    (@ !) => { Need::Required };
    (@ *) => { Need::Key };
    (@ +) => { Need::Stray };
    (@text $Part:ident) => { None };
    (@text $Part:ident $text:expr, $($at:tt)?) => {
        Some(Attribute { name: n::text, kind: $text, need: Need::Optional, at: at!($Part $($at)?) })
    };
}
use elements;

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    /// Every element below `root`, each once.
    pub(in crate::xdd) fn all(root: &'static Element) -> Vec<&'static Element> {
        let mut all = vec![root];
        let mut seen: HashSet<*const Element> = HashSet::new();
        let mut next = 0;
        while let Some(element) = all.get(next) {
            let children = element.content.iter().flat_map(|slot| slot.of).copied();
            let new: Vec<_> = children.filter(|child| seen.insert(std::ptr::from_ref(*child))).collect();
            all.extend(new);
            next += 1;
        }
        all
    }

    #[test]
    fn the_table_is_sound() {
        for element in [&CONTAINER, &DEVICE_BODY, &NETWORK_BODY, &EXTERNAL_NETWORK_BODY]
            .into_iter()
            .flat_map(|root| all(root))
        {
            let name = element.name.text();
            let children: Vec<Name> = element
                .content
                .iter()
                .filter(|slot| slot.need != Need::Stray)
                .flat_map(|slot| slot.of.iter().map(|child| child.name))
                .collect();
            assert!(element.attributes.len() <= 32 && element.content.len() <= MAX_SLOTS, "{name}");
            assert_eq!(
                children.iter().collect::<HashSet<_>>().len(),
                children.len(),
                "{name}: a child is there twice"
            );
            for newer in element.newer {
                let is_known = element.attribute(*newer).is_some() || children.contains(newer);
                assert!(is_known, "{name} has no `{}`", newer.text());
            }
        }
    }
}

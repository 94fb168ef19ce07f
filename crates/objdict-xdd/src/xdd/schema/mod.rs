//! CiA 311 (versions 1.0 and 1.1) in one table: which elements there are, what stands in them in which order, what their
//! attributes take, and where the model keeps it. Reading, writing, checking, locating and the words of findings go by it.

mod application;
mod container;
mod device;
mod network;
mod values;

use std::any::Any;

pub(crate) use self::application::{APPLICATION_PROCESS, PARAMETER};
pub(crate) use self::container::{
    CONTAINER, DEVICE_BODY, DEVICE_HEADER, EXTERNAL_NETWORK_BODY, NETWORK_BODY, NETWORK_HEADER, PROFILE,
};
pub(crate) use self::device::{
    DEVICE_FUNCTION, DEVICE_IDENTITY, DEVICE_MANAGER, ORDER_NUMBER, PRODUCT_ID, PRODUCT_NAME, VENDOR_ID,
    VENDOR_NAME,
};
pub(crate) use self::network::*;
pub(crate) use self::values::{BAUD_RATES, Kind, Target};
use super::fact::Fact;
use super::shape::{Parts, TextField, Values};
use crate::model::{Entry, Field, Value};
use crate::xml::{Name, n};

/// An element in a certain place: `range` of `allowedValues` is another one than `range` of `rangeList`.
#[derive(Debug)]
pub(crate) struct Element {
    pub name: Name,
    /// Whether version 1.1 declares it globally, so that it is in the namespace there.
    pub is_global: bool,
    pub attributes: &'static [Attribute],
    /// What the text is; `None` where only elements may stand.
    pub text: Option<Attribute>,
    /// The elements in it, in their order.
    pub content: &'static [Slot],
    /// The attributes and children that version 1.0 does not have.
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

/// Whether an attribute or element must be there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Need {
    Optional,
    /// The standard wants it, and readers do without.
    Required,
    /// Without it the rest means nothing.
    Key,
    /// The standard does not have it there, and the model does: it is a finding, and is read and written.
    Stray,
}

/// Where a part of the model keeps something: for writing, and for reading.
pub(crate) struct Lens<T: ?Sized> {
    pub get: for<'a> fn(&'a dyn Any) -> Option<&'a T>,
    pub get_mut: for<'a> fn(&'a mut dyn Any) -> Option<&'a mut T>,
}

/// Where the part keeps the value of an attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum At {
    /// Nowhere, or whoever reads the element knows.
    Nowhere,
    /// In a field that takes texts; what it does not take is left over.
    Text(Lens<dyn TextField>),
    /// In a field that an EDS has too; what it does not take is an invalid value.
    Fact(FactAt),
    /// Among the values of an entry, which are read when the data type is known.
    Value(Slots),
}

/// Where the part keeps what an EDS has too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FactAt {
    /// `None` for what only CiA 311 has: the field is called like the attribute.
    pub field: Option<&'static Field>,
    /// The greatest number, where that of the type is too much.
    pub most: Option<u64>,
    /// What is written where nobody stated anything. It is read as nothing.
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

/// Where the part keeps elements.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Child {
    /// Nowhere, or whoever reads the element knows.
    Nowhere,
    /// The element stands around others of the same part.
    Same,
    /// It always says this.
    Fixed(&'static str),
    /// In parts.
    Parts(Lens<dyn Parts>),
    /// In values: the first attribute of the element, or its text.
    Values(Lens<dyn Values>),
    /// One for the first element of the choice, and one for the others.
    Either(&'static Child, &'static Child),
}

/// A place in the order of an element's children: one element, or a choice of several.
#[derive(Debug)]
pub(crate) struct Slot {
    pub of: &'static [&'static Element],
    pub least: u32,
    pub most: u32,
    pub need: Need,
    pub at: Child,
}

/// At least as many places as the content of any element has.
pub(crate) const MAX_SLOTS: usize = 16;

/// No upper bound.
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
    /// The element of a name, if it may stand here.
    pub(crate) fn element(&self, name: Name) -> Option<&'static Element> {
        self.of.iter().copied().find(|element| element.name == name)
    }

    /// How often elements of this one's name may stand here. Only `variableRef` may stand more often than what else
    /// stands in its place.
    pub(crate) fn most_of(&self, element: &Element) -> u32 {
        if element.name == n::variableRef { MANY } else { self.most }
    }

    /// Its elements with where the part keeps them: one for all, or one for each.
    pub(crate) fn kept(&self) -> impl Iterator<Item = (&'static Element, Child)> {
        let at = move |number: usize| match self.at {
            Child::Either(first, others) => Some(if number == 0 { *first } else { *others }),
            one => Some(one).filter(|_| number == 0),
        };
        self.of.iter().enumerate().filter_map(move |(number, element)| Some((*element, at(number)?)))
    }
}

impl Element {
    /// Whether the standard does not say what is in it, as with the simple types.
    pub(crate) fn is_opaque(&self) -> bool {
        self.attributes.is_empty() && self.content.is_empty() && self.text.is_none()
    }

    /// Whether names and descriptions stand in it.
    pub(crate) fn has_labels(&self) -> bool {
        self.content.iter().any(|slot| slot.need != Need::Stray && slot.element(n::label).is_some())
    }

    /// The attribute of a name.
    pub(crate) fn attribute(&self, name: Name) -> Option<(usize, &'static Attribute)> {
        self.attributes.iter().enumerate().find(|(_, attribute)| attribute.name == name)
    }

    /// The attribute of a field that an EDS has too.
    pub(crate) fn attribute_of(&self, field: &Field) -> Option<&'static Attribute> {
        self.attributes.iter().find(|attribute| attribute.field().as_ref() == Some(field))
    }

    /// The place of a child in the order, looked for from `from` on first: children mostly stand in their order.
    pub(crate) fn slot(&self, name: Name, from: usize) -> Option<(usize, &'static Element)> {
        let slots = || self.content.iter().enumerate();
        let find = |(number, slot): (usize, &Slot)| Some((number, slot.element(name)?));
        slots().skip(from).find_map(find).or_else(|| slots().take(from).find_map(find))
    }

    /// What its values stand in where it has one value: its first attribute, else its text.
    pub(crate) fn holder(&self) -> Name {
        self.attributes.first().filter(|_| self.text.is_none()).map_or(n::text, |attribute| attribute.name)
    }
}

impl Attribute {
    /// The field that it is in the model, where it is no mere text.
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

    /// A value as this attribute has it, which an EDS spells as `text`; `None` where the attribute cannot say it.
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
            // the parameter says what is input and what is output
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

/// The element of the identity whose text an EDS has in a field.
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

/// A field of a part, or a function that finds it.
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

/// Where the value of an attribute is kept: `[field]` takes texts, `{Field field}` is called so in an EDS, `<Value>` is one
/// of an entry, and `(CONSTANT)` a place of its own.
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

/// Where elements are kept: `[field]` in parts, `{field}` in values, `same` in the same part, and `(CONSTANT)` in a place
/// of its own.
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

/// The counts of a [`Slot`].
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
/// The mark behind the name of an attribute is `?` (optional), `!` (required), `*` (without it the element means nothing) or
/// `+` (a stray one).
///
/// A child is `count WHAT`, where the count is `one`, `key` (one, and nothing works without it), `maybe`, `some`, `two` (at
/// least), `any` or `stray`, and WHAT is an element, a choice `[A | B]` or a list `(LIST)` of elements. Behind `=>` stands
/// where the part keeps it; an element of `Nothing` keeps nothing, or whoever reads it knows.
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

    /// Everything in an element, each once.
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

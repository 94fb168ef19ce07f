//! CiA 311 (versions 1.0 and 1.1) in one table: the elements, their content and its order, the values of
//! their attributes, and their fields in the model. Reading, writing, checking, locating and the wording of
//! findings use this table.
//!
//! *Stray* elements and attributes are those that the model has and the standard does not allow in this place.
//! The table spans several modules that import each other (`fact`, `shape`, this folder), one per body of CiA
//! 311.

pub(crate) mod application;
pub(crate) mod container;
pub(crate) mod device;
mod lexical;
pub(crate) mod network;
mod values;
mod xsd;

use std::ops::Deref;

pub(crate) use self::application::{APPLICATION_PROCESS, PARAMETER};
pub(crate) use self::container::{
    CONTAINER, DEVICE_HEADER, EXTERNAL_NETWORK_BODY, NETWORK_BODY, NETWORK_HEADER, PROFILE,
};
pub(crate) use self::device::{DEVICE_FUNCTION, DEVICE_IDENTITY, DEVICE_MANAGER};
pub(crate) use self::lexical::{decimal, is_language, is_name, is_name_character, whole_number};
pub(crate) use self::network::{APPLICATION_LAYERS, IDENTITY, MODULE_MANAGEMENT};
pub(crate) use self::values::{BAUD_RATES, ReferenceTarget, TextKind};
pub use self::xsd::xsd;

/// The words that an attribute of an object or sub-object may be; none where it is no word.
pub fn words_of(element: crate::xml::Element<'_>, name: &str) -> &'static [&'static str] {
    let schema = match element.tag() {
        crate::xml::n::CANopenObject => Some(OBJECT),
        tag => OBJECT.slot(tag, 0).map(|(_, element)| element),
    };
    let known = schema.and_then(|schema| schema.attribute(crate::xml::Name::of(name)));
    match known.map(|(_, attribute)| &attribute.kind) {
        Some(TextKind::Word(words) | TextKind::Words(words)) => words,
        Some(TextKind::Boolean) => &["true", "false"],
        _ => &[],
    }
}
use super::fact::Fact;
use super::shape::{Keep, TextField};
use crate::literal;
use crate::model::{Entry, Field, Value};
use crate::xml::{Name, n};

/// The structure of elements with fields of an EDS.
pub(crate) static OBJECT: &SchemaElement = &network::OBJECT.element;
pub(crate) static DEVICE_BODY: &SchemaElement = &container::DEVICE_BODY.element;
pub(crate) static GENERAL_FEATURES: &SchemaElement = &network::GENERAL_FEATURES.element;
pub(crate) static MASTER_FEATURES: &SchemaElement = &network::MASTER_FEATURES.element;
pub(crate) static DEVICE_COMMISSIONING: &SchemaElement = &network::DEVICE_COMMISSIONING.element;

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
    /// The field of the model, if it is not a plain text.
    pub field: Option<fn() -> Field>,
    /// The maximum, if it is lower than that of the type.
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
    /// Without it the element has no meaning.
    Key,
    /// Not defined by the standard at this place but part of the model: reported, and still read and
    /// written.
    Stray,
}

/// An element, and where a part `P` of the model keeps what is in it.
pub(crate) struct Shape<P: 'static> {
    pub element: SchemaElement,
    /// An empty part.
    pub new: fn() -> P,
    /// Whether a part is this element and not another one of the same choice.
    pub is: fn(&P) -> bool,
    /// Where the part keeps each attribute, and behind them the text.
    pub values: &'static [AttributePlace<P>],
    /// How the part keeps the children of each slot.
    pub children: &'static [&'static [&'static (dyn Keep<P> + Sync)]],
    /// Where the part keeps the marks of its children.
    pub marks: Option<Lens<P, Marks>>,
}

impl<P> Deref for Shape<P> {
    type Target = SchemaElement;

    fn deref(&self) -> &SchemaElement {
        &self.element
    }
}

/// Names of elements with the values of their marks.
pub(crate) type Marks = Vec<(Box<str>, bool)>;

/// A field of a part: for writing, and for reading. `None` for a part without it.
pub(crate) struct Lens<P, T: ?Sized + 'static> {
    pub get: fn(&P) -> Option<&T>,
    pub get_mut: fn(&mut P) -> Option<&mut T>,
}

/// Where a part keeps the value of an attribute.
pub(crate) enum AttributePlace<P> {
    /// Not stored, or stored by the code that reads the element.
    Nowhere,
    /// In a field for texts; a text it does not accept becomes a leftover.
    Text(Lens<P, dyn TextField>),
    /// In a field that an EDS has too; a text it does not accept becomes an invalid value.
    Fact(Lens<P, dyn Fact>),
    /// Among the values of an entry, which are read once the data type is known.
    Value(Slots),
    /// Among the marks that the part of the element around it keeps, under the name of the element; the second element of a
    /// name is `orderNumber[2]`.
    Mark,
}

/// One of the values of an entry.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slots {
    Default,
    Actual,
    Low,
    High,
}

/// The alternatives of a choice that a part of one type is.
pub(crate) struct ElementChoice<C: 'static> {
    pub elements: &'static [&'static SchemaElement],
    pub shapes: &'static [&'static Shape<C>],
}

/// A place in the order of the children: one element, or a choice of several.
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
const MANY: u32 = u32::MAX;

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

    /// What holds the value of an element with one value: its first attribute, else its text.
    pub(crate) fn holder(&self) -> Name {
        self.attributes.first().filter(|_| self.text.is_none()).map_or(n::text, |attribute| attribute.name)
    }
}

impl SchemaAttribute {
    /// The field of the model, if it is not a plain text.
    pub(crate) fn field(&self) -> Option<Field> {
        self.field.map(|field| field())
    }

    /// The text for a required attribute without a value; `None` if the element has no meaning without it.
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

/// The element of the identity whose text is a field of an EDS.
pub(crate) fn identity_element(field: &Field) -> Option<&'static SchemaElement> {
    Some(match field {
        Field::VendorName => &device::VENDOR_NAME,
        Field::VendorNumber => &device::VENDOR_ID,
        Field::ProductName => &device::PRODUCT_NAME,
        Field::ProductNumber => &device::PRODUCT_ID,
        Field::OrderCode => &device::ORDER_NUMBER,
        _ => return None,
    })
}

/// A field of a part: the part itself, a path of fields, or a variable of a pattern that the part or a field has.
macro_rules! lens {
    (self) => { $crate::xdd::schema::Lens { get: |part| Some(part), get_mut: |part| Some(part) } };
    (in self $pattern:pat => $field:ident) => {
        $crate::xdd::schema::Lens {
            get: |part| if let $pattern = part { Some($field) } else { None },
            get_mut: |part| if let $pattern = part { Some($field) } else { None },
        }
    };
    (in $path:ident $pattern:pat => $field:ident) => {
        $crate::xdd::schema::Lens {
            get: |part| if let $pattern = &part.$path { Some($field) } else { None },
            get_mut: |part| if let $pattern = &mut part.$path { Some($field) } else { None },
        }
    };
    ($($path:tt)+) => {
        $crate::xdd::schema::Lens {
            get: |part| Some(&part.$($path)+),
            get_mut: |part| Some(&mut part.$($path)+),
        }
    };
}
use lens;

/// Where the value of an attribute is kept: `[field]` takes texts, `{Field field}` has that name in an EDS (`Named`: that of the
/// attribute), `(value Which)` is a value of an entry, `mark` is kept by the element around it, and `(field Field)` is kept by the code that reads the element.
macro_rules! at {
    () => { AttributePlace::Nowhere };
    (mark) => { AttributePlace::Mark };
    ((value $value:ident)) => { AttributePlace::Value(Slots::$value) };
    ((field $field:ident)) => { AttributePlace::Nowhere };
    ([$($path:tt)+]) => { AttributePlace::Text(lens!($($path)+)) };
    ({$field:ident $path:ident $($rest:tt)*}) => { AttributePlace::Fact(lens!($path)) };
}
use at;

/// The attribute beside its [`at!`].
macro_rules! attribute {
    ($name:ident $kind:expr, $need:expr) => { attribute!(@ $name $kind, $need, None, , ) };
    ($name:ident $kind:expr, $need:expr, mark) => { attribute!(@ $name $kind, $need, None, , ) };
    ($name:ident $kind:expr, $need:expr, [$($path:tt)+]) => { attribute!(@ $name $kind, $need, None, , ) };
    ($name:ident $kind:expr, $need:expr, (value $value:ident)) => {
        attribute!(@ $name $kind, $need, Some(|| Slots::$value.field()), , )
    };
    ($name:ident $kind:expr, $need:expr, (field $field:ident)) => {
        attribute!(@ $name $kind, $need, Some(|| Field::$field), , )
    };
    ($name:ident $kind:expr, $need:expr, {Named $path:ident}) => {
        attribute!(@ $name $kind, $need, Some(|| Field::Named(n::$name.text().into())), , )
    };
    ($name:ident $kind:expr, $need:expr, {$field:ident $path:ident $(most $most:literal)? $(unstated $text:expr)?}) => {
        attribute!(@ $name $kind, $need, Some(|| Field::$field), $($most)?, $($text)?)
    };
    (@ $name:ident $kind:expr, $need:expr, $field:expr, $($most:literal)?, $($text:expr)?) => {
        SchemaAttribute {
            name: n::$name,
            kind: $kind,
            need: $need,
            field: $field,
            most: attribute!(@option $($most)?),
            unstated: attribute!(@option $($text)?),
        }
    };
    (@option) => { None };
    (@option $value:expr) => { Some($value) };
}
use attribute;

/// The elements of a [`Child`]: `A`, `[A | B]`, `(CHOICE)`, or `(ELEMENTS: CHOICE CHOICE)` for parts of several types.
macro_rules! of {
    ([$($of:ident)|+]) => { &[$(&$of.element),+] };
    (($elements:ident: $($choice:ident)+)) => { $elements };
    (($of:ident)) => { $of.elements };
    ($of:ident) => { &[&$of.element] };
}
use of;

/// How elements are kept: `[field]` as parts, `{field}` as values, `same` in the same part.
macro_rules! kept {
    ($Part:ident $of:tt) => { &[] };
    ($Part:ident $of:ident same) => { &[&Same(&$of)] };
    ($Part:ident [$same:ident | $of:ident] (same $other:tt)) => { &[&Same(&$same), &kept!(@ $Part &[&$of], $other)] };
    ($Part:ident $of:ident $text:literal) => { &[&FixedContent(&$of.element, $text)] };
    ($Part:ident $of:ident {$($path:tt)+}) => {
        &[&ValuesIn::<$Part> { element: &$of.element, field: lens!($($path)+) }]
    };
    ($Part:ident [$($of:ident)|+] $kept:tt) => { &[&kept!(@ $Part &[$(&$of),+], $kept)] };
    ($Part:ident ($elements:ident: $($choice:ident)+) $kept:tt) => { &[$(&kept!(@ $Part $choice.shapes, $kept)),+] };
    ($Part:ident ($of:ident) $kept:tt) => { &[&kept!(@ $Part $of.shapes, $kept)] };
    ($Part:ident $of:ident $kept:tt) => { &[&kept!(@ $Part &[&$of], $kept)] };
    (@ $Part:ident $shapes:expr, [$($path:tt)+]) => { PartsIn::<$Part, _> { shapes: $shapes, field: lens!($($path)+) } };
}
use kept;

/// The minimum and maximum of a [`Child`].
macro_rules! slot {
    (one $of:tt) => { slot!(@ $of, 1, 1, Required) };
    (key $of:tt) => { slot!(@ $of, 1, 1, Key) };
    (maybe $of:tt) => { slot!(@ $of, 0, 1, Optional) };
    (some $of:tt) => { slot!(@ $of, 1, super::MANY, Required) };
    (two $of:tt) => { slot!(@ $of, 2, super::MANY, Required) };
    (any $of:tt) => { slot!(@ $of, 0, super::MANY, Optional) };
    (stray $of:tt) => { slot!(@ $of, 0, super::MANY, Stray) };
    (@ $of:tt, $least:expr, $most:expr, $need:ident) => {
        Child { of: of!($of), least: $least, most: $most, need: Occurrence::$need }
    };
}
use slot;

/// Declares elements: `NAME global|local name of Part (attributes) = text, [children], newer [names], marks [field];`
///
/// The part of an element of a [`ElementChoice`] is `Part as (new part, pattern of the part)`, and that of an element that is not kept, or
/// by the code that reads it, is `Nothing`. The mark after the name of an attribute is `?` (optional), `!` (required), `*` (without it
/// the element has no meaning) or `+` (stray).
///
/// A child is `count WHAT`, where the count is `one`, `key` (one; the element has no meaning without it), `maybe`, `some`, `two` (at
/// least), `any` or `stray`. `=>` is followed by where the part keeps it.
macro_rules! elements {
    ($($NAME:ident $form:ident $name:ident of $Part:ident $(as ($new:expr, $is:pat))?
        $(($($attribute:ident $need:tt: $kind:expr $(=> $at:tt)?),+ $(,)?))?
        $(= $text:expr $(=> $text_at:tt)?)?
        $(, [$($count:ident $of:tt $(=> $child:tt)?),+ $(,)?])?
        $(, newer [$($newer:ident),+ $(,)?])?
        $(, marks [$($marks:tt)+])?
    ;)+) => {
        $(pub(crate) static $NAME: Shape<$Part> = Shape {
            element: SchemaElement {
                name: n::$name,
                is_global: elements!(@ $form),
                attributes: &[$($(attribute!($attribute $kind, elements!(@ $need) $(, $at)?)),+)?],
                text: elements!(@text $($text)?),
                content: &[$($(slot!($count $of)),+)?],
                newer: &[$($(n::$newer),+)?],
            },
            new: elements!(@new $Part $($new)?),
            is: elements!(@is $($is)?),
            values: &[$($(at!($($at)?),)+)? $(elements!(@at $text $(=> $text_at)?))?],
            children: &[$($(kept!($Part $of $($child)?)),+)?],
            marks: attribute!(@option $(lens!($($marks)+))?),
        };)+
    };
    (@ global) => { true };
    (@ local) => { false };
    (@ ?) => { Occurrence::Optional };
    (@ !) => { Occurrence::Required };
    (@ *) => { Occurrence::Key };
    (@ +) => { Occurrence::Stray };
    (@text) => { None };
    (@text $text:expr) => { Some(attribute!(text $text, Occurrence::Optional)) };
    (@at $text:expr) => { AttributePlace::Nowhere };
    (@at $text:expr => $at:tt) => { at!($at) };
    (@new $Part:ident) => { <$Part>::default };
    (@new $Part:ident $new:expr) => { || $new };
    (@is) => { |_| true };
    (@is $is:pat) => { |part| matches!(part, $is) };
}
use elements;

/// Declares a [`ElementChoice`].
macro_rules! choice {
    ($NAME:ident of $Part:ident: $($of:ident)+) => {
        pub(crate) static $NAME: ElementChoice<$Part> =
            ElementChoice { elements: &[$(&$of.element),+], shapes: &[$(&$of),+] };
    };
}
use choice;

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    /// Every element below `root`, each once.
    pub(in crate::xdd) fn all(root: &'static SchemaElement) -> Vec<&'static SchemaElement> {
        let mut all = vec![root];
        let mut seen: HashSet<*const SchemaElement> = HashSet::new();
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
        for element in
            [&CONTAINER.element, DEVICE_BODY, &NETWORK_BODY, &EXTERNAL_NETWORK_BODY].into_iter().flat_map(all)
        {
            let name = element.name.text();
            let children: Vec<Name> = element
                .content
                .iter()
                .filter(|slot| slot.need != Occurrence::Stray)
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

//! CiA 311 (versions 1.0 and 1.1) in one table: the elements, their content and its order, the values of
//! their attributes, and their fields in the model. Reading, writing, checking, locating and the wording of
//! findings use this table.
//!
//! *Stray* elements and attributes belong to the model, but the standard does not allow them at their position. The
//! table is here, with a module for each body of CiA 311; `element` contains its types, and `shape` maps elements to
//! parts of the model.

pub(crate) mod application;
pub(crate) mod container;
pub(crate) mod device;
mod lexical;
pub(crate) mod network;
mod xsd;

pub(crate) use self::application::{APPLICATION_PROCESS, PARAMETER};
pub(crate) use self::container::{
    CONTAINER, DEVICE_HEADER, EXTERNAL_NETWORK_BODY, NETWORK_BODY, NETWORK_HEADER, PROFILE,
};
pub(crate) use self::device::{DEVICE_FUNCTION, DEVICE_IDENTITY, DEVICE_MANAGER};
pub(crate) use self::lexical::{
    BAUD_RATES, ReferenceTarget, TextKind, decimal, is_language, is_name, is_name_character, whole_number,
};
pub(crate) use self::network::{APPLICATION_LAYERS, IDENTITY, MODULE_MANAGEMENT};
pub use self::xsd::xsd;
pub(crate) use super::element::{Child, MANY, MAX_SLOTS, Occurrence, SchemaAttribute, SchemaElement};
pub(crate) use super::shape::{AttributePlace, ElementChoice, Lens, Shape, Slots};

/// The keywords that an attribute of an object or sub-object may contain; empty if it is not a keyword.
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
use crate::model::Field;

/// The structure of elements with fields of an EDS.
pub(crate) static OBJECT: &SchemaElement = &network::OBJECT.element;
pub(crate) static DEVICE_BODY: &SchemaElement = &container::DEVICE_BODY.element;
pub(crate) static GENERAL_FEATURES: &SchemaElement = &network::GENERAL_FEATURES.element;
pub(crate) static MASTER_FEATURES: &SchemaElement = &network::MASTER_FEATURES.element;
pub(crate) static DEVICE_COMMISSIONING: &SchemaElement = &network::DEVICE_COMMISSIONING.element;

/// The element of the identity whose text is an EDS field.
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

/// A field of a part: the part itself, a path of fields, or a variable of a pattern that matches the part or
/// a field.
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

/// The storage of an attribute value: `[field]` stores strings, `{Field field}` has this name in an EDS (`Named`: the
/// attribute's name), `(value Which)` is a value of an entry, `mark` is stored in the parent element, and
/// `(field Field)` is stored by the code that reads the element.
macro_rules! at {
    () => { AttributePlace::Nowhere };
    (mark) => { AttributePlace::Mark };
    ((value $value:ident)) => { AttributePlace::Value(Slots::$value) };
    ((field $field:ident)) => { AttributePlace::Nowhere };
    ([$($path:tt)+]) => { AttributePlace::Text(lens!($($path)+)) };
    ({$field:ident $path:ident $($rest:tt)*}) => { AttributePlace::Fact(lens!($path)) };
}
use at;

/// The attribute that belongs to an [`at!`].
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

/// The storage of elements: `[field]` as parts, `{field}` as values, `same` in the same part.
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
/// The part of an element of a [`ElementChoice`] is `Part as (new part, pattern of the part)`; it is `Nothing` for an
/// element that is not stored, or stored by the code that reads it. The mark after the name of an attribute is `?`
/// (optional), `!` (required), `*` (the element is meaningless without it) or `+` (stray).
///
/// A child is `count WHAT`, where the count is `one`, `key` (one; the element is meaningless without it), `maybe`,
/// `some`, `two` (at least), `any` or `stray`. `=>` precedes its storage in the part.
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
    use crate::xml::Name;

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

//! The structure of CiA 311 (versions 1.0 and 1.1) as data: which elements there are, what stands in them in which order,
//! and what their attributes take. The reader does not need it, for it takes what it finds; the rules of the group
//! `cia311` and the writer do.

mod application;
mod container;
mod device;
mod network;
mod values;

pub(crate) use container::{CONTAINER, DEVICE_BODY, EXTERNAL_NETWORK_BODY, NETWORK_BODY};
pub(crate) use values::{BAUD_RATES, Kind, Target};

/// An element in a certain place: `range` of `allowedValues` is another one than `range` of `rangeList`.
#[derive(Debug)]
pub(crate) struct Element {
    /// The local name.
    pub name: &'static str,
    /// Whether version 1.1 declares it globally, so that it is in the namespace there.
    pub is_global: bool,
    pub attributes: &'static [Attribute],
    /// What the text is; `None` where only elements may stand.
    pub text: Option<Kind>,
    /// The elements in it, in their order.
    pub content: &'static [Slot],
    /// The attributes and children that version 1.0 does not have.
    pub newer: &'static [&'static str],
}

/// An attribute.
#[derive(Debug)]
pub(crate) struct Attribute {
    pub name: &'static str,
    pub kind: Kind,
    pub need: Need,
}

/// Whether an attribute or element must be there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Need {
    Optional,
    /// The standard wants it, and readers do without.
    Required,
    /// Without it the rest means nothing.
    Key,
}

/// A place in the order of an element's children: one element, or a choice of several.
#[derive(Debug)]
pub(crate) struct Slot {
    pub of: &'static [&'static Element],
    pub least: u32,
    pub most: u32,
    pub need: Need,
}

/// At least as many places as the content of any element has.
pub(crate) const MAX_SLOTS: usize = 16;

/// No upper bound.
const MANY: u32 = u32::MAX;

impl Slot {
    /// The element of a name, if it may stand here.
    pub(crate) fn element(&self, name: &str) -> Option<&'static Element> {
        self.of.iter().copied().find(|element| element.name == name)
    }

    /// How often elements of this one's name may stand here. Only `variableRef` may stand more often than what else
    /// stands in its place.
    pub(crate) fn most_of(&self, element: &Element) -> u32 {
        if element.name == "variableRef" { MANY } else { self.most }
    }
}

impl Element {
    /// Whether the standard does not say what is in it, as with the simple types.
    pub(crate) fn is_opaque(&self) -> bool {
        self.attributes.is_empty() && self.content.is_empty() && self.text.is_none()
    }

    /// Whether names and descriptions stand in it.
    pub(crate) fn has_labels(&self) -> bool {
        self.content.iter().any(|slot| slot.element("label").is_some())
    }

    /// The attribute of a name.
    pub(crate) fn attribute(&self, name: &str) -> Option<(usize, &'static Attribute)> {
        self.attributes.iter().enumerate().find(|(_, attribute)| attribute.name == name)
    }

    /// The place of a child in the order, looked for from `from` on first: children mostly stand in their order.
    pub(crate) fn slot(&self, name: &str, from: usize) -> Option<(usize, &'static Element)> {
        let slots = || self.content.iter().enumerate();
        let find = |(number, slot): (usize, &Slot)| Some((number, slot.element(name)?));
        slots().skip(from).find_map(find).or_else(|| slots().take(from).find_map(find))
    }
}

/// The counts of a [`Slot`].
macro_rules! slot {
    (one $of:tt) => {
        slot!(@ $of, 1, 1, Required)
    };
    (key $of:tt) => {
        slot!(@ $of, 1, 1, Key)
    };
    (maybe $of:tt) => {
        slot!(@ $of, 0, 1, Optional)
    };
    (some $of:tt) => {
        slot!(@ $of, 1, $crate::xdd::schema::MANY, Required)
    };
    (two $of:tt) => {
        slot!(@ $of, 2, $crate::xdd::schema::MANY, Required)
    };
    (any $of:tt) => {
        slot!(@ $of, 0, $crate::xdd::schema::MANY, Optional)
    };
    (@ [$($of:ident)|+], $least:expr, $most:expr, $need:ident) => {
        slot!(@@ &[$(&$of),+], $least, $most, $need)
    };
    (@ ($of:ident), $least:expr, $most:expr, $need:ident) => {
        slot!(@@ $of, $least, $most, $need)
    };
    (@ $of:ident, $least:expr, $most:expr, $need:ident) => {
        slot!(@@ &[&$of], $least, $most, $need)
    };
    (@@ $of:expr, $least:expr, $most:expr, $need:ident) => {
        $crate::xdd::schema::Slot {
            of: $of,
            least: $least,
            most: $most,
            need: $crate::xdd::schema::Need::$need,
        }
    };
}
use slot;

/// The mark behind the name of an attribute: `?` optional, `!` required, `*` without it the element means nothing.
macro_rules! need {
    (?) => {
        $crate::xdd::schema::Need::Optional
    };
    (!) => {
        $crate::xdd::schema::Need::Required
    };
    (*) => {
        $crate::xdd::schema::Need::Key
    };
}
use need;

/// Declares elements: `NAME global|local "name" (attributes) = text, [children], newer ["names"];`
///
/// A child is `count WHAT`, where the count is `one`, `key` (one, and nothing works without it), `maybe`, `some`, `two` (at
/// least) or `any`, and WHAT is an element, a choice `[A | B]` or a list `(LIST)` of elements.
macro_rules! elements {
    ($($NAME:ident $form:ident $name:literal
        $(($($attribute:ident $need:tt: $kind:expr),+ $(,)?))?
        $(= $text:expr)?
        $(, [$($count:ident $of:tt),+ $(,)?])?
        $(, newer [$($newer:literal),+ $(,)?])?
    ;)+) => {
        $(pub(super) static $NAME: $crate::xdd::schema::Element = $crate::xdd::schema::Element {
            name: $name,
            is_global: elements!(@ $form),
            attributes: &[$($($crate::xdd::schema::Attribute {
                name: stringify!($attribute),
                kind: $kind,
                need: need!($need),
            }),+)?],
            text: elements!(@text $($text)?),
            content: &[$($(slot!($count $of)),+)?],
            newer: &[$($($newer),+)?],
        };)+
    };
    (@ global) => { true };
    (@ local) => { false };
    (@text) => { None };
    (@text $text:expr) => { Some($text) };
}
use elements;

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use crate::xdd::markup::Body;

    /// Everything in an element, each once.
    fn elements(
        element: &'static Element,
        all: &mut Vec<&'static Element>,
        seen: &mut HashSet<*const Element>,
    ) {
        for child in element.content.iter().flat_map(|slot| slot.of) {
            if seen.insert(std::ptr::from_ref(*child)) {
                all.push(child);
                elements(child, all, seen);
            }
        }
    }

    fn all(root: &'static Element) -> Vec<&'static Element> {
        let mut all = vec![root];
        elements(root, &mut all, &mut HashSet::new());
        all
    }

    #[test]
    fn the_writer_knows_the_same_elements_as_global() {
        for (body, root) in [(Body::Device, DEVICE_BODY), (Body::Network, NETWORK_BODY)] {
            let elements = all(root);
            assert!(elements.len() > 30);
            for element in elements.iter().skip(1) {
                // labels stand in the network body too, in `deviceFamily`
                assert_eq!(body.declares_globally(element.name), element.is_global, "{}", element.name);
            }
        }
    }

    #[test]
    fn the_tables_are_sound() {
        for root in [CONTAINER, DEVICE_BODY, NETWORK_BODY, EXTERNAL_NETWORK_BODY] {
            for element in all(root) {
                let children = element.content.iter().flat_map(|slot| slot.of).map(|child| child.name);
                let names: Vec<&str> = element
                    .attributes
                    .iter()
                    .map(|attribute| attribute.name)
                    .chain(children.clone())
                    .collect();
                assert!(
                    element.attributes.len() <= 32 && element.content.len() <= MAX_SLOTS,
                    "{}",
                    element.name
                );
                let unique: HashSet<&str> = children.clone().collect();
                assert_eq!(unique.len(), children.count(), "{}: a child is there twice", element.name);
                for newer in element.newer {
                    assert!(names.contains(newer), "{} has no `{newer}`", element.name);
                }
            }
        }
    }
}

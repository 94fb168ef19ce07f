//! The fields of parts: for texts, and for other parts.

use std::borrow::Cow;

use super::TextForm;
use crate::model::{DataTypeRef, SimpleType, VariableRef};

/// A field for an attribute or the text of an element.
pub(crate) trait TextField {
    /// Takes a value; `false` if the field already has one or the text is not valid.
    fn accept(&mut self, text: &str) -> bool;

    /// Whether it has a value.
    fn is_set(&self) -> bool;

    /// The value; `None` if there is nothing to write.
    fn text(&self) -> Option<Cow<'_, str>>;
}

/// A field for elements with one value each.
pub(crate) trait ValueFields {
    /// Adds a value; `None` if the field is full.
    fn add(&mut self) -> Option<&mut dyn TextField>;

    /// Calls `put` for each value.
    fn each(&self, put: &mut dyn FnMut(&str));
}

/// A text that always exists; a missing one is empty.
impl TextField for Box<str> {
    fn accept(&mut self, text: &str) -> bool {
        let is_first = !self.is_set();
        if is_first {
            *self = text.into();
        }
        is_first
    }

    fn is_set(&self) -> bool {
        !self.is_empty()
    }

    fn text(&self) -> Option<Cow<'_, str>> {
        Some(Cow::Borrowed(self))
    }
}

impl<T: TextForm> TextField for Option<T> {
    fn accept(&mut self, text: &str) -> bool {
        if self.is_some() {
            return false;
        }
        *self = T::parse(text);
        self.is_some()
    }

    fn is_set(&self) -> bool {
        self.is_some()
    }

    fn text(&self) -> Option<Cow<'_, str>> {
        self.as_ref().map(T::print)
    }
}

impl<F: TextField> ValueFields for F {
    fn add(&mut self) -> Option<&mut dyn TextField> {
        if self.is_set() { None } else { Some(self) }
    }

    fn each(&self, put: &mut dyn FnMut(&str)) {
        if let Some(text) = self.text() {
            put(&text);
        }
    }
}

impl ValueFields for Vec<Box<str>> {
    fn add(&mut self) -> Option<&mut dyn TextField> {
        self.push(Box::default());
        self.last_mut().map(|last| last as &mut dyn TextField)
    }

    fn each(&self, put: &mut dyn FnMut(&str)) {
        self.iter().for_each(|text| put(text));
    }
}

/// A field for parts `C`, each in its own element.
pub(crate) trait Holds<C> {
    /// Adds a part; `None` if the field is full.
    fn add(&mut self, new: fn() -> C) -> Option<&mut C>;

    /// Calls `put` for each part.
    fn each(&self, put: &mut dyn FnMut(&C));
}

/// A part that always exists; an empty one is not written.
impl<C: Default + PartialEq> Holds<C> for C {
    fn add(&mut self, _: fn() -> C) -> Option<&mut C> {
        if *self == C::default() { Some(self) } else { None }
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        if *self != C::default() {
            put(self);
        }
    }
}

impl<C> Holds<C> for Option<C> {
    fn add(&mut self, new: fn() -> C) -> Option<&mut C> {
        if self.is_some() { None } else { Some(self.insert(new())) }
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        self.iter().for_each(put);
    }
}

impl<C> Holds<C> for Option<Box<C>> {
    fn add(&mut self, new: fn() -> C) -> Option<&mut C> {
        if self.is_some() { None } else { Some(self.insert(Box::new(new()))) }
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        self.iter().for_each(|part| put(part));
    }
}

impl<C> Holds<C> for Vec<C> {
    fn add(&mut self, new: fn() -> C) -> Option<&mut C> {
        self.push(new());
        self.last_mut()
    }

    fn each(&self, put: &mut dyn FnMut(&C)) {
        self.iter().for_each(put);
    }
}

/// Several `variableRef`.
impl Holds<VariableRef> for Option<DataTypeRef> {
    fn add(&mut self, new: fn() -> VariableRef) -> Option<&mut VariableRef> {
        match self.get_or_insert_with(|| DataTypeRef::Variables(Vec::new())) {
            DataTypeRef::Variables(variables) => variables.add(new),
            _ => None,
        }
    }

    fn each(&self, put: &mut dyn FnMut(&VariableRef)) {
        if let Some(DataTypeRef::Variables(variables)) = self {
            variables.iter().for_each(put);
        }
    }
}

/// An element such as `UDINT`, or a `dataTypeIDRef`.
macro_rules! data_types {
    ($($Part:ty: $Variant:ident;)+) => {$(
        impl Holds<$Part> for Option<DataTypeRef> {
            fn add(&mut self, new: fn() -> $Part) -> Option<&mut $Part> {
                match self {
                    Some(_) => None,
                    None => match self.insert(DataTypeRef::$Variant(new())) {
                        DataTypeRef::$Variant(part) => Some(part),
                        _ => None,
                    },
                }
            }

            fn each(&self, put: &mut dyn FnMut(&$Part)) {
                if let Some(DataTypeRef::$Variant(part)) = self {
                    put(part);
                }
            }
        }
    )+};
}

data_types! { SimpleType: Simple; Box<str>: Defined; }

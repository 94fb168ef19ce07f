//! Fields of enums, which the table cannot name by a path.

use super::{Parts, TextField};
use crate::model::{Label, TextRef, TypeDefinition, TypeShape};
use crate::xdd::schema::Lens;

/// A field of some variants of a part.
macro_rules! lenses {
    ($($NAME:ident: $Part:ident $(. $field:ident)? => $kind:ident $($variant:pat => $at:expr),+;)+) => {$(
        pub(crate) const $NAME: Lens<dyn $kind> = Lens {
            get: |part| match &(*part.downcast_ref::<$Part>()?)$(.$field)? {
                $($variant => Some($at),)+
                _ => None,
            },
            get_mut: |part| match &mut (*part.downcast_mut::<$Part>()?)$(.$field)? {
                $($variant => Some($at),)+
                _ => None,
            },
        };
    )+};
}

lenses! {
    LABEL_LANG: Label => TextField Label::Name { lang, .. } | Label::Description { lang, .. } => lang;
    LABEL_TEXT: Label => TextField Label::Name { text, .. } | Label::Description { text, .. } => text;
    LABEL_URI: Label => TextField
        Label::Description { uri, .. } => uri,
        Label::NameRef(TextRef { uri, .. }) | Label::DescriptionRef(TextRef { uri, .. }) => uri;
    LABEL_DICTIONARY: Label => TextField
        Label::NameRef(TextRef { dictionary, .. }) | Label::DescriptionRef(TextRef { dictionary, .. }) => dictionary;
    LABEL_TEXT_ID: Label => TextField
        Label::NameRef(TextRef { text_id, .. }) | Label::DescriptionRef(TextRef { text_id, .. }) => text_id;
    ARRAY_RANGES: TypeDefinition.shape => Parts TypeShape::Array { ranges, .. } => ranges;
    ARRAY_TYPE: TypeDefinition.shape => Parts TypeShape::Array { element, .. } => element;
    STRUCT_MEMBERS: TypeDefinition.shape => Parts TypeShape::Struct { members } => members;
    ENUM_SIZE: TypeDefinition.shape => TextField TypeShape::Enum { size, .. } => size;
    ENUM_VALUES: TypeDefinition.shape => Parts TypeShape::Enum { values, .. } => values;
    ENUM_TYPE: TypeDefinition.shape => Parts TypeShape::Enum { base, .. } => base;
    DERIVED_COUNT: TypeDefinition.shape => Parts TypeShape::Derived { count, .. } => count;
    DERIVED_TYPE: TypeDefinition.shape => Parts TypeShape::Derived { base, .. } => base;
}

//! Elements and attributes as stored: their positions in the text.

use super::expand::Entities;
use super::names::Name;
use crate::source::Span;

/// The result of the builder.
#[derive(Debug, Default)]
pub(super) struct Parts {
    /// The elements in the order of their start tags; the root is first.
    pub(super) elements: Vec<Record>,
    /// The attributes of all elements in order, including namespace declarations.
    pub(super) attributes: Vec<AttributeRecord>,
    /// The URIs of the namespaces that elements are in.
    pub(super) namespaces: Vec<Box<str>>,
    /// Skipped text that is neither markup nor character data, in order.
    pub(super) damage: Vec<Span>,
    pub(super) entities: Entities,
    pub(super) is_complete: bool,
}

/// No element, or no namespace.
pub(super) const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// The `<` of the start tag; the name follows immediately.
    pub(super) start: u32,
    pub(super) tag_end: u32,
    /// The `<` of the end tag.
    pub(super) inner_end: u32,
    pub(super) end: u32,
    pub(super) parent: u32,
    pub(super) next: u32,
    /// The first attribute; the next element's attributes follow the last one.
    pub(super) attributes: u32,
    pub(super) namespace: u32,
    pub(super) name_length: u16,
    /// Length of the prefix with its colon.
    pub(super) prefix_length: u16,
    pub(super) tag: Name,
    /// Whether the element may contain more than whitespace, elements, comments and processing instructions.
    pub(super) has_text: bool,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct AttributeRecord {
    pub(super) name: u32,
    pub(super) value: u32,
    pub(super) value_end: u32,
    pub(super) name_length: u16,
    /// Length of the prefix with its colon, and [`DECLARES`].
    pub(super) prefix_length: u16,
    pub(super) tag: Name,
    /// Whether the value is used unchanged: it has no reference, line end or tab.
    pub(super) is_plain: bool,
}

/// Marks an attribute that declares a namespace.
pub(super) const DECLARES: u16 = 1 << 15;

impl AttributeRecord {
    pub(super) fn declares(self) -> bool {
        self.prefix_length & DECLARES != 0
    }
}

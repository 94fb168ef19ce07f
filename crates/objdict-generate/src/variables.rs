//! C variables for the values of a dictionary: one per entry, or an array if the elements of an ARRAY are alike.

use std::ops::Range;

use super::dictionary::ResolvedObject;
use super::memory::{Memory, SizeTally, TypeExtent};
use super::names::{LONGEST, NameScope, clip, words};
use crate::model::{Object, ObjectType};

/// The type of a variable; variables of equal types can be elements of one array.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CType {
    /// The part before the name: begins with `const ` for a variable in flash.
    pub(crate) base: String,
    /// The part after the name and the number of elements.
    pub(crate) suffix: String,
    /// The size of one value.
    pub(crate) extent: TypeExtent,
}

impl CType {
    /// A number.
    pub(crate) fn number(base: impl Into<String>) -> Self {
        let base = base.into();
        Self { suffix: String::new(), extent: TypeExtent::of_c(&base), base }
    }

    /// An array of this many bytes, each of the type `base`.
    pub(crate) fn bytes(base: impl Into<String>, room: usize) -> Self {
        Self { base: base.into(), suffix: format!("[{room}]"), extent: TypeExtent::BYTE.times(room) }
    }
}

/// The entries of one object that are in one variable.
#[derive(Debug)]
pub(crate) struct ObjectVariable {
    /// Unique; not a keyword; short enough for the prefix.
    pub(crate) name: String,
    /// Object number in the dictionary.
    pub(crate) object: usize,
    /// Entry numbers in the object: one, or the elements of an array.
    pub(crate) entries: Range<usize>,
    /// Whether it is an array.
    pub(crate) array: bool,
    pub(crate) type_: CType,
}

impl ObjectVariable {
    /// The entries by number, each with its expression based on the name of the variable.
    pub(crate) fn places<'a>(&'a self, name: &'a str) -> impl Iterator<Item = (usize, String)> + 'a {
        self.entries.clone().enumerate().map(move |(element, at)| {
            (at, if self.array { format!("{name}[{element}]") } else { name.to_owned() })
        })
    }

    /// Its definition; `initial` returns an entry's initializer and whether that is zero.
    pub(crate) fn define(
        self,
        object: &ResolvedObject<'_>,
        name: String,
        initial: impl Fn(usize) -> (String, bool),
    ) -> Definition {
        let (values, zeros): (Vec<String>, Vec<bool>) = self.entries.clone().map(initial).unzip();
        let (first, last) = (&object.entries[self.entries.start], &object.entries[self.entries.end - 1]);
        Definition {
            elements: self.array.then_some(values.len()),
            initializer: if self.array { format!("{{{}}}", values.join(", ")) } else { values.concat() },
            is_zero: zeros.into_iter().all(|is_zero| is_zero),
            index: object.index,
            subs: (first.sub, last.sub),
            described: if self.array { object.object.name() } else { &first.entry.name }.to_owned(),
            type_: self.type_,
            name,
        }
    }
}

/// A variable as C defines it.
pub(crate) struct Definition {
    pub(crate) type_: CType,
    pub(crate) name: String,
    /// The number of elements of an array.
    pub(crate) elements: Option<usize>,
    pub(crate) initializer: String,
    /// Whether the initial value is all zeros.
    pub(crate) is_zero: bool,
    /// The index of its object.
    pub(crate) index: u16,
    /// The first and the last sub-index.
    pub(crate) subs: (u8, u8),
    /// The name in the description.
    pub(crate) described: String,
}

impl Definition {
    /// A variable with a non-zero value.
    pub(crate) fn new(index: u16, type_: CType, name: String, initializer: String) -> Self {
        let (subs, described) = ((0, 0), String::new());
        Self { type_, name, elements: None, initializer, is_zero: false, index, subs, described }
    }

    pub(crate) fn declaration(&self) -> String {
        format!("{} {}{}", self.type_.base, self.name, self.suffix())
    }

    /// The part after the name.
    pub(crate) fn suffix(&self) -> String {
        let elements = self.elements.map(|elements| format!("[{elements}]")).unwrap_or_default();
        elements + &self.type_.suffix
    }

    pub(crate) fn is_constant(&self) -> bool {
        self.type_.base.starts_with("const ")
    }

    pub(crate) fn extent(&self) -> TypeExtent {
        self.type_.extent.times(self.elements.unwrap_or(1))
    }

    pub(crate) fn memory(&self) -> Memory {
        if self.is_constant() { Memory::Flash } else { Memory::of_values(self.is_zero) }
    }

    /// Adds its bytes to those of its object.
    pub(crate) fn count(&self, tally: &mut SizeTally) {
        tally.of(self.index, self.memory(), self.extent().size);
    }
}

/// The variables of a dictionary in order. Entries without a type have no variable; entries of equal types
/// can form an array. `names` returns the names of all of them: of entries, or of arrays (`None`).
pub(crate) fn variables(
    objects: &[ResolvedObject<'_>],
    names: impl FnOnce(&[WantedName<'_>]) -> Vec<String>,
    type_of: impl Fn(usize, usize) -> Option<CType>,
) -> Vec<ObjectVariable> {
    let (mut variables, mut wanted) = (Vec::new(), Vec::new());
    for (number, object) in objects.iter().enumerate() {
        let types: Vec<Option<CType>> =
            (0..object.entries.len()).map(|entry| type_of(number, entry)).collect();
        let subs: Vec<u8> = object.entries.iter().map(|entry| entry.sub).collect();
        let elements = elements(object.object, &subs, |at| types[at].clone());
        for (entry, type_) in types.into_iter().enumerate() {
            let (Some(type_), true) = (type_, entry <= elements.start || !elements.contains(&entry)) else {
                continue;
            };
            let array = elements.contains(&entry);
            wanted.push((object, (!array).then_some(entry)));
            let entries = if array { elements.clone() } else { entry..entry + 1 };
            variables.push(ObjectVariable { name: String::new(), object: number, entries, array, type_ });
        }
    }
    for (variable, name) in variables.iter_mut().zip(names(&wanted)) {
        variable.name = name;
    }
    variables
}

/// The entries that form an array: sub-index 1 and up without gaps, all of the same kind.
pub(crate) fn elements<K: PartialEq>(
    object: &Object,
    subs: &[u8],
    kind: impl Fn(usize) -> Option<K>,
) -> Range<usize> {
    let none = subs.len()..subs.len();
    if object.object_type() != ObjectType::Array && object.compact.is_none() {
        return none;
    }
    let Some(start) = subs.iter().position(|&sub| sub > 0).filter(|&start| subs[start] == 1) else {
        return none;
    };
    let end = subs.len() - usize::from(subs.last() == Some(&0xFF)); // FFh: the structure of the object
    let numbered = (start..end).zip(1_u16..).all(|(at, sub)| u16::from(subs[at]) == sub);
    let first = kind(start);
    if numbered && first.is_some() && (start..end).all(|at| kind(at) == first) { start..end } else { none }
}

/// An entry of an object by its number, or the whole object, that needs a name.
pub(crate) type WantedName<'a> = (&'a ResolvedObject<'a>, Option<usize>);

/// Claims a name for each of them, independent of their order.
pub(crate) fn claim(scope: &mut NameScope, prefix: &str, wanted: &[WantedName<'_>]) -> Vec<String> {
    let wanted: Vec<(String, String)> = wanted.iter().map(|wanted| described(prefix, wanted)).collect();
    scope.foresee(wanted.iter().map(|(name, _)| name.as_str()));
    wanted.iter().map(|(name, suffix)| scope.claim(name, format_args!("{suffix}"))).collect()
}

/// The words of a name, and the suffix that makes it unique.
fn described(prefix: &str, &(object, entry): &WantedName<'_>) -> (String, String) {
    let index = object.index;
    let object_name = words(&object.name);
    let object_name = if object_name.is_empty() { format!("x{index:04x}") } else { object_name };
    let entry = entry.filter(|_| !object.is_single()).and_then(|entry| object.entries.get(entry));
    let (name, suffix) = match entry {
        None => (object_name, format!("{index:04x}")),
        Some(entry) => {
            let sub = entry.sub;
            let entry_name = words(&entry.name);
            let entry_name = if entry_name.is_empty() { format!("{sub:02x}") } else { entry_name };
            (format!("{object_name}_{entry_name}"), format!("{index:04x}_{sub:02x}"))
        }
    };
    let room = LONGEST - prefix.len() - 4 - suffix.len(); // for the prefix, the suffix and a number
    (clip(&name, room).to_owned(), suffix)
}

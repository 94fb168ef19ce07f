//! Names of C variables for the values of a dictionary: one per entry, or an array if the elements of an
//! ARRAY are alike.

use std::ops::Range;

use super::dictionary::ResolvedObject;
use super::names::{LONGEST, Scope, clip, words};
use crate::model::ObjectType;

/// A variable with the entries of one object in it.
#[derive(Debug)]
pub(crate) struct Variable<S> {
    /// Unique; not a keyword; short enough for the prefix.
    pub(crate) name: String,
    /// Object number in the dictionary.
    pub(crate) object: usize,
    /// Entry numbers in the object: one, or the elements of an array.
    pub(crate) entries: Range<usize>,
    /// Whether it is an array.
    pub(crate) array: bool,
    /// Its kind.
    pub(crate) kind: S,
}

/// The variables of a dictionary in order. Entries without `kind` have no variable; entries of equal kinds
/// can form an array. `names` gives the names of all of them: of entries, or of arrays (`None`).
pub(crate) fn variables<S: PartialEq>(
    objects: &[ResolvedObject<'_>],
    names: impl FnOnce(&[Wanted<'_>]) -> Vec<String>,
    kind: impl Fn(usize, usize) -> Option<S>,
) -> Vec<Variable<S>> {
    let (mut variables, mut wanted) = (Vec::new(), Vec::new());
    for (number, object) in objects.iter().enumerate() {
        let kinds: Vec<Option<S>> = (0..object.entries.len()).map(|entry| kind(number, entry)).collect();
        let elements = elements(object, &kinds);
        for (entry, kind) in kinds.into_iter().enumerate() {
            let (Some(kind), true) = (kind, entry <= elements.start || !elements.contains(&entry)) else {
                continue;
            };
            let array = elements.contains(&entry);
            wanted.push((object, (!array).then_some(entry)));
            let entries = if array { elements.clone() } else { entry..entry + 1 };
            variables.push(Variable { name: String::new(), object: number, entries, array, kind });
        }
    }
    for (variable, name) in variables.iter_mut().zip(names(&wanted)) {
        variable.name = name;
    }
    variables
}

/// The entries that form an array: sub-index 1 and up without gaps, all alike.
fn elements<S: PartialEq>(object: &ResolvedObject<'_>, kinds: &[Option<S>]) -> Range<usize> {
    let entries = &object.entries;
    let none = entries.len()..entries.len();
    if object.object.object_type() != ObjectType::Array && object.object.compact.is_none() {
        return none;
    }
    let Some(start) = entries.iter().position(|entry| entry.sub == 1) else { return none };
    let end = entries.len() - usize::from(entries.last().is_some_and(|entry| entry.sub == 0xFF)); // FFh: the structure
    let numbered = |(at, sub): (usize, u16)| u16::from(entries[at].sub) == sub;
    let alike = (start..end).all(|at| kinds[at].is_some() && kinds[at] == kinds[start]);
    if alike && (start..end).zip(1..).all(numbered) { start..end } else { none }
}

/// An entry of an object by its number, or the whole object, that needs a name.
pub(crate) type Wanted<'a> = (&'a ResolvedObject<'a>, Option<usize>);

/// Claims a name for each of them, which does not depend on their order.
pub(crate) fn claim(scope: &mut Scope, prefix: &str, wanted: &[Wanted<'_>]) -> Vec<String> {
    let wanted: Vec<(String, String)> = wanted.iter().map(|wanted| described(prefix, wanted)).collect();
    scope.foresee(wanted.iter().map(|(name, _)| name.as_str()));
    wanted.iter().map(|(name, suffix)| scope.claim(name, format_args!("{suffix}"))).collect()
}

/// The words of a name, and what makes it unique.
fn described(prefix: &str, &(object, entry): &Wanted<'_>) -> (String, String) {
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

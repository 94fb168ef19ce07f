//! The ids of a document while it is written: each is an XML name, and is there once; a reference leads to one.

use std::borrow::Cow;
use std::collections::HashSet;
use std::rc::Rc;

use super::schema::{is_name, is_name_character};

/// The ids and the references written so far.
#[derive(Debug, Default)]
pub(crate) struct WrittenIds {
    /// In the order of the document.
    defined: Vec<Rc<str>>,
    set: HashSet<Rc<str>>,
    references: Vec<Rc<str>>,
    /// What may be referred to; `None` for anything.
    known: Option<HashSet<Rc<str>>>,
}

impl WrittenIds {
    /// Without ids. With `known`, other references are not written.
    pub(crate) fn new(known: Option<HashSet<Rc<str>>>) -> Self {
        Self { known, ..Self::default() }
    }

    /// The id for an element: the text as a name that no other element has.
    pub(crate) fn define<'t>(&mut self, text: &'t str) -> Cow<'t, str> {
        let name = name_of(text);
        let mut free = name.clone();
        let mut number = 1;
        while self.set.contains(&*free) {
            number += 1;
            free = Cow::Owned(format!("{name}_{number}"));
        }
        let id: Rc<str> = (*free).into();
        self.defined.push(Rc::clone(&id));
        self.set.insert(id);
        free
    }

    /// The id for a reference; `None` if nothing has it.
    pub(crate) fn refer<'t>(&mut self, text: &'t str) -> Option<Cow<'t, str>> {
        let name = name_of(text);
        let leads = self.known.as_ref().is_none_or(|known| known.contains(&*name));
        if text.trim_ascii().is_empty() || !leads {
            return None;
        }
        self.references.push(self.set.get(&*name).map_or_else(|| (*name).into(), Rc::clone));
        Some(name)
    }

    /// A mark for [`reset`](Self::reset).
    pub(crate) fn mark(&self) -> (usize, usize) {
        (self.defined.len(), self.references.len())
    }

    /// Forgets what came after a mark.
    pub(crate) fn reset(&mut self, (defined, references): (usize, usize)) {
        for id in self.defined.drain(defined..) {
            self.set.remove(&id);
        }
        self.references.truncate(references);
    }

    /// The ids that there are, if a reference leads to another one.
    pub(crate) fn into_known(self) -> Option<HashSet<Rc<str>>> {
        let Self { set, references, known, .. } = self;
        if references.iter().all(|reference| set.contains(reference)) {
            return None;
        }
        // fewer each time, so that writing again comes to an end
        Some(match known {
            Some(known) => set.into_iter().filter(|id| known.contains(id)).collect(),
            None => set,
        })
    }
}

/// A text as a name: the same text if it is one, and always the same name for it.
fn name_of(text: &str) -> Cow<'_, str> {
    let text = text.trim_ascii();
    if is_name(text) {
        return Cow::Borrowed(text);
    }
    let mut name = "ID_".to_owned();
    for character in text.chars() {
        match is_name_character(character) {
            true => name.push(character),
            false => name.push_str(&format!("_{:X}", u32::from(character))),
        }
    }
    Cow::Owned(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_names_and_unique() {
        let mut ids = WrittenIds::default();
        for (text, expected) in [
            ("a", "a"),
            ("a", "a_2"),
            ("1000-1", "ID_1000-1"),
            ("a b", "ID_a_20b"),
            ("", "ID_"),
            ("", "ID__2"),
        ] {
            assert_eq!(ids.define(text), expected);
        }
        assert_eq!(ids.refer("1000-1").as_deref(), Some("ID_1000-1"));
        assert_eq!(ids.refer(" "), None);
        let mark = ids.mark();
        ids.define("b");
        ids.refer("b");
        ids.reset(mark);
        assert_eq!(ids.define("b"), "b");
        ids.refer("c");
        let known = ids.into_known().unwrap();
        assert!(known.contains("b") && !known.contains("c"));
        assert_eq!(WrittenIds::new(Some(known)).refer("c"), None);
    }
}

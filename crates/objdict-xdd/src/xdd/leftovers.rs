//! Content of an XDD that the reader does not use, which is kept.

use std::collections::{HashMap, HashSet};

use crate::model::{Extra, ExtraSection};
use crate::xml::{Attribute, Element, ElementId, n};

/// The key of an element's text.
const TEXT: &str = n::text.text();

/// Attributes, elements and texts without a place in the model, and strings that are not valid in
/// their fields.
///
/// Memory use is proportional to the text: overlong paths are shortened.
#[derive(Debug, Default)]
pub struct Leftovers<'a> {
    found: Vec<(Element<'a>, Extra)>,
}

impl<'a> Leftovers<'a> {
    /// Keeps an attribute.
    pub fn attribute(&mut self, element: Element<'a>, attribute: Attribute<'a>) {
        push_lines(self.extra(element), &full_name(attribute), &attribute.value());
    }

    /// Keeps the text of an element, if it has one.
    pub(crate) fn text(&mut self, element: Element<'a>) {
        if !element.has_text() {
            return;
        }
        let text = element.text();
        let text = text.trim_matches([' ', '\t', '\n', '\r']);
        if !text.is_empty() {
            push_lines(self.extra(element), TEXT, text);
        }
    }

    /// Keeps an element with its content.
    pub fn element(&mut self, element: Element<'a>) {
        for part in std::iter::once(element).chain(element.descendants()) {
            self.found.push((part, Extra::default()));
            for attribute in part.attributes() {
                self.attribute(part, attribute);
            }
            self.text(part);
        }
    }

    /// One section for each element with leftovers, in the order of the file.
    ///
    /// The name is `xml:` and the path of the element relative to its `ProfileBody` or EtherCAT `Device` (otherwise the
    /// root), such as `xml:DeviceFunction/foo[2]`; the keys are names of attributes and `TEXT`. A value of several
    /// lines becomes several entries with the same key.
    pub fn into_sections(mut self) -> Vec<ExtraSection> {
        self.found.sort_by_key(|(element, _)| element.id());
        let length = self.found.first().map_or(0, |(element, _)| element.tree().text().len());
        let room = length.saturating_mul(2).saturating_add(4096);
        let mut paths = Paths { room, ..Paths::default() };
        self.found.dedup_by(|(element, extra), (last, entries)| {
            let is_same = element.id() == last.id();
            if is_same {
                extra.iter().for_each(|(key, value)| entries.push(key, value));
            }
            is_same
        });
        let sections = self.found.iter();
        sections.map(|(element, extra)| ExtraSection::new(&paths.name(*element), extra)).collect()
    }

    fn extra(&mut self, element: Element<'a>) -> &mut Extra {
        if self.found.last().is_none_or(|(last, _)| last.id() != element.id()) {
            self.found.push((element, Extra::default()));
        }
        let last = self.found.len() - 1;
        &mut self.found[last].1
    }
}

/// The name with its prefix.
fn full_name(attribute: Attribute<'_>) -> String {
    match attribute.prefix() {
        "" => attribute.name().to_owned(),
        prefix => format!("{prefix}:{}", attribute.name()),
    }
}

/// Splits a value of several lines into entries, because an entry cannot contain a line feed.
fn push_lines(extra: &mut Extra, key: &str, value: &str) {
    value.split('\n').for_each(|line| extra.push(key, line));
}

/// The paths of elements.
#[derive(Default)]
struct Paths {
    /// The number of an element among siblings with the same name, if there are several.
    numbers: HashMap<ElementId, u32>,
    numbered: HashSet<ElementId>,
    /// The maximum total length of all further paths.
    room: usize,
}

impl Paths {
    /// The name of an element's section.
    fn name(&mut self, element: Element<'_>) -> String {
        let mut steps: Vec<_> = std::iter::successors(Some(element), |element| element.parent()).collect();
        // below the `ProfileBody` or `Device`, otherwise below the root
        let is_body = |step: &Element<'_>| step.tag() == n::ProfileBody || step.name() == "Device";
        let body = steps.iter().rposition(is_body).filter(|&above| above > 0);
        steps.truncate(body.unwrap_or((steps.len() - 1).max(1)));
        let least: usize = steps.iter().map(|step| step.name().len()).sum();
        let path = if least > self.room { None } else { Some(self.path(&steps)) };
        let is_short = path.as_ref().is_some_and(|path| path.len() <= self.room);
        self.room = path.as_ref().map_or(0, |path| self.room.saturating_sub(path.len()));
        match path {
            Some(path) if is_short => format!("xml:{path}"),
            _ if steps.len() == 1 => format!("xml:{}", self.path(&steps)),
            _ => format!("xml:.../{}", self.path(&steps[..1])),
        }
    }

    /// The names and numbers of elements, from the outermost to the innermost.
    fn path(&mut self, steps: &[Element<'_>]) -> String {
        let step = |step: &Element<'_>| match self.number(*step) {
            Some(number) => format!("{}[{number}]", step.name()),
            None => step.name().to_owned(),
        };
        steps.iter().rev().map(step).collect::<Vec<_>>().join("/")
    }

    fn number(&mut self, element: Element<'_>) -> Option<u32> {
        let parent = element.parent()?;
        if self.numbered.insert(parent.id()) {
            let mut so_far: HashMap<&str, Vec<ElementId>> = HashMap::new();
            parent.children().for_each(|child| so_far.entry(child.name()).or_default().push(child.id()));
            let several = so_far.into_values().filter(|same| same.len() > 1);
            self.numbers.extend(several.flat_map(|same| same.into_iter().zip(1..)));
        }
        self.numbers.get(&element.id()).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Findings;
    use crate::source::SourceFile;
    use crate::xml::Tree;

    fn tree(text: &str) -> Tree {
        Tree::new(SourceFile::from_text("test.xdd", text), &mut Findings::new())
    }

    /// The sections of all elements with one of the names.
    fn sections(text: &str, names: &[&str]) -> Vec<(String, Vec<(String, String)>)> {
        let tree = tree(text);
        let mut leftovers = Leftovers::default();
        let elements =
            tree.root().into_iter().flat_map(|root| std::iter::once(root).chain(root.descendants()));
        // reversed: the result must not depend on the order of reading
        let mut elements: Vec<_> = elements.filter(|element| names.contains(&element.name())).collect();
        elements.reverse();
        elements.into_iter().for_each(|element| leftovers.element(element));
        let sections = leftovers.into_sections().into_iter();
        let owned = |(key, value): (&str, &str)| (key.to_owned(), value.to_owned());
        sections.map(|section| (section.name().into(), section.entries().map(owned).collect())).collect()
    }

    fn names_of(sections: &[(String, Vec<(String, String)>)]) -> Vec<&str> {
        sections.iter().map(|(name, _)| name.as_str()).collect()
    }

    #[test]
    fn paths_begin_below_the_body() {
        let text = "<C><Profile><ProfileHeader><x/></ProfileHeader><ProfileBody><x/><F><x/><y/><x/></F><F/></ProfileBody>\
            <x/></Profile><Profile><ProfileBody><D><x/></D></ProfileBody></Profile></C>";
        let expected = [
            "xml:Profile[1]/ProfileHeader/x",
            "xml:x",
            "xml:F[1]/x[1]",
            "xml:F[1]/x[2]",
            "xml:Profile[1]/x",
            "xml:D/x",
        ];
        assert_eq!(names_of(&sections(text, &["x"])), expected);
        let around = ["xml:C", "xml:Profile[1]", "xml:Profile[1]/ProfileBody", "xml:Profile[2]"];
        let whole = sections(text, &["C"]);
        assert!(around.iter().all(|name| names_of(&whole).contains(name)), "{whole:?}");
    }

    #[test]
    fn an_element_is_kept_with_all_in_it() {
        let text =
            "<R><ProfileBody><a k='1' l='&#10;2'> first <b>in\n side</b> second\n<c/></a></ProfileBody></R>";
        let entry = |key: &str, value: &str| (key.to_owned(), value.to_owned());
        let expected = [
            (
                "xml:a".to_owned(),
                vec![entry("k", "1"), entry("l", ""), entry("l", "2"), entry(TEXT, "first  second")],
            ),
            ("xml:a/b".to_owned(), vec![entry(TEXT, "in"), entry(TEXT, " side")]),
            ("xml:a/c".to_owned(), vec![]),
        ];
        assert_eq!(sections(text, &["a"]), expected);
    }

    #[test]
    fn attributes_of_one_element_are_one_section() {
        let tree = tree("<R><ProfileBody a='1' b='2'><c d='3'/></ProfileBody></R>");
        let mut leftovers = Leftovers::default();
        let elements: Vec<_> = tree.root().into_iter().flat_map(Element::descendants).collect();
        for (element, name) in [(elements[0], "b"), (elements[1], "d"), (elements[0], "a")] {
            if let Some(attribute) = element.attribute(name) {
                leftovers.attribute(element, attribute);
            }
        }
        let sections = leftovers.into_sections();
        let entries: Vec<_> = sections.iter().map(|section| section.entries().collect::<Vec<_>>()).collect();
        assert_eq!(entries, [vec![("b", "2"), ("a", "1")], vec![("d", "3")]]);
    }

    /// Many elements at the end of a long path, or siblings, need memory proportional to their text.
    #[test]
    fn hostile_files_take_about_their_text() {
        let name = "n".repeat(1000);
        let depth = 200;
        let deep = format!(
            "<R>{}{}{}</R>",
            format!("<{name}>").repeat(depth),
            "<a/>".repeat(50_000),
            format!("</{name}>").repeat(depth)
        );
        let wide = format!("<R>{}</R>", "<a/><b/>".repeat(50_000));
        for text in [deep, wide] {
            let found = sections(&text, &["R"]);
            assert!(found.len() > 50_000);
            let length: usize = found.iter().map(|(name, _)| name.len()).sum();
            assert!(length < 16 * text.len(), "{length} of {}", text.len());
        }
    }
}

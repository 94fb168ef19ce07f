//! The sections that the model does not know as one text: a line with the name of each, and a line with a blank in front
//! for each key.

use std::borrow::Cow;

use crate::model::{Extra, ExtraSection};

/// The text of sections.
pub(super) fn print(sections: &[&ExtraSection]) -> String {
    let mut text = String::new();
    for section in sections {
        text.push_str(&escaped(section.name()));
        text.push('\n');
        for (key, value) in section.entries() {
            [" ", key, "=", value, "\n"].into_iter().for_each(|part| text.push_str(part));
        }
    }
    text
}

/// The sections of a text; `None` when [`print`] does not make it.
pub(super) fn parse(text: &str) -> Option<Vec<ExtraSection>> {
    let mut sections: Vec<ExtraSection> = Vec::new();
    let mut lines = text.strip_suffix('\n')?.split('\n').peekable();
    while let Some(line) = lines.next() {
        let name = unescaped(line).filter(|_| !line.starts_with(' '))?;
        let mut entries = Extra::default();
        while let Some(entry) = lines.next_if(|line| line.starts_with(' ')) {
            let (key, value) = entry.get(1..)?.split_once('=')?;
            entries.push(key, value);
        }
        sections.push(ExtraSection::new(&name, &entries));
    }
    Some(sections)
}

/// A name on one line that does not start with a blank.
fn escaped(name: &str) -> Cow<'_, str> {
    if !name.starts_with(' ') && !name.contains(['\\', '\n']) {
        return name.into();
    }
    let name = name.replace('\\', "\\\\").replace('\n', "\\n");
    let blanks = name.len() - name.trim_start_matches(' ').len();
    ["\\s".repeat(blanks).as_str(), &name[blanks..]].concat().into()
}

fn unescaped(line: &str) -> Option<Cow<'_, str>> {
    if !line.contains('\\') {
        return Some(line.into());
    }
    let mut name = String::with_capacity(line.len());
    let mut chars = line.chars();
    while let Some(c) = chars.next() {
        name.push(match c {
            '\\' => match chars.next()? {
                'n' => '\n',
                's' => ' ',
                '\\' => '\\',
                _ => return None,
            },
            c => c,
        });
    }
    Some(name.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_gives_the_sections_back() {
        let section = |name: &str, entries: &[(&str, &str)]| {
            let mut extra = Extra::default();
            entries.iter().for_each(|(key, value)| extra.push(key, value));
            ExtraSection::new(name, &extra)
        };
        let sections = [
            section("", &[]),
            section("", &[("", ""), (" a", " b=c ")]),
            section("  two\nlines\\n", &[("\\", "x")]),
            section("Vendor", &[("Key", "value"), ("Key", "")]),
        ];
        let text = print(&sections.iter().collect::<Vec<_>>());
        assert_eq!(parse(&text).unwrap(), sections, "{text}");
        assert!([" a=b\n", "a", "\\x\n", "a\n b\n"].iter().all(|text| parse(text).is_none()));
    }
}

//! The code that serves the table as a part of the generated file: the text of `objdict_device::table`.

use objdict_device::source;

use crate::{Derive, OptionValue};

/// The parts of the code that a table needs.
#[derive(Clone, Copy)]
pub(super) struct PastedParts<'a> {
    pub(super) stored: bool,
    pub(super) hooks: bool,
    pub(super) pdo: bool,
    pub(super) derives: &'a [Derive],
}

impl PastedParts<'_> {
    /// The text of the parts.
    pub(super) fn text(self) -> String {
        let has = |derive| self.derives.contains(&derive);
        let optional = [
            (self.stored, source::STORED),
            (self.hooks, source::HOOKS),
            (self.pdo, source::PDO),
            (has(Derive::Defmt), source::DEFMT),
            (has(Derive::Serde), source::SERDE),
        ];
        let optional = optional.into_iter().filter_map(|(is_needed, text)| is_needed.then_some(text));
        let texts = source::TABLE.iter().copied().chain(optional).map(|text| self.joined(text));
        texts.collect::<Vec<_>>().join("\n")
    }

    /// A file without its imports from the others, and with the derives that are asked for.
    fn joined(self, text: &str) -> String {
        let mut joined = String::with_capacity(text.len());
        let mut is_import = false;
        for line in text.lines() {
            is_import |= line.starts_with("use super::");
            if is_import {
                is_import = !line.ends_with(';');
                continue;
            }
            let Some(condition) = line.trim_start().strip_prefix("#[cfg_attr(feature = \"") else {
                joined.push_str(line);
                joined.push('\n');
                continue;
            };
            let names = Derive::ALL.iter().filter(|(derive, ..)| self.derives.contains(derive));
            let derive = names
                .map(|(_, name, _)| condition.strip_prefix(name))
                .find_map(|rest| rest?.strip_prefix("\", ")?.strip_suffix(")]"));
            if let Some(derive) = derive {
                let indent = &line[..line.len() - line.trim_start().len()];
                joined.push_str(&format!("{indent}#[{derive}]\n"));
            }
        }
        joined.trim().to_owned() + "\n"
    }
}

//! Content between tags: text, references, comments and instructions, and everything before the root.

use super::build::TreeBuilder;
use super::chars::{is_blank, is_blank_text, is_name};
use super::expand::{Entity, EntityReference, MAX_EXPANSION, reference};
use super::findings::{self as rules, shown};
use super::prolog;
use crate::diagnostic::{Diagnostic, Severity};

impl TreeBuilder<'_, '_> {
    /// Reads the text from `start` up to the next tag; returns where to continue.
    pub(super) fn run(&mut self, start: usize) -> usize {
        let rest = &self.text.as_bytes()[start..];
        let blanks = rest.iter().take_while(|&&byte| is_blank(byte)).count();
        if rest.get(blanks).is_none_or(|&byte| byte == b'<') {
            return start + blanks;
        }
        let length = memchr::memchr(b'<', rest).unwrap_or(rest.len());
        if self.is_skipping() {
            return start + length;
        }
        if self.open.is_empty() {
            return self.run_outside(start, start + length);
        }
        self.mark_text();
        self.check_text(start, start + length);
        if self.has_references {
            for at in memchr::memchr_iter(b'&', &rest[..length]) {
                self.check_reference(start + at);
            }
        }
        start + length
    }

    /// Reports the next reference, or the text before it, in a text outside the root; returns where to
    /// continue.
    fn run_outside(&mut self, start: usize, end: usize) -> usize {
        let rest = &self.text[start..end];
        let until =
            |from: usize, stop: &[char]| rest[from..].find(stop).map_or(rest.len(), |length| from + length);
        let length = match rest.chars().next() {
            Some('\u{FEFF}') => 3,
            Some('&') => until(1, &[';', '&']),
            _ => until(0, &['&']),
        };
        if rest.starts_with('&') && rest[length..].starts_with(';') {
            self.outside_root(start, start + 1);
            return start + length + 1;
        }
        self.outside_root(start, start + length);
        start + length
    }

    pub(super) fn outside_root(&mut self, start: usize, end: usize) {
        if !self.open.is_empty() || self.is_skipping() || is_blank_text(&self.text[start..end]) {
            return;
        }
        let first = self.find(start, |byte| !is_blank(byte));
        let span = Self::span(first, start + self.text[start..end].trim_ascii_end().len());
        let side = if self.parts.elements.is_empty() { "before" } else { "after" };
        self.defect(&rules::TEXT_OUTSIDE_ROOT, span, |text| format!("the text `{text}` is {side} the root"));
    }

    fn check_text(&mut self, start: usize, end: usize) {
        if !self.has_section_ends {
            return;
        }
        for at in memchr::memmem::find_iter(&self.text.as_bytes()[start..end], b"]]>") {
            let span = Self::span(start + at, start + at + 3);
            self.report(&rules::CDATA_END_IN_TEXT, || {
                Diagnostic::new(&rules::CDATA_END_IN_TEXT, span, "the text contains `]]>`")
                    .help("write `]]&gt;`")
            });
        }
    }

    /// Checks the reference that starts with the `&` at `start`.
    pub(super) fn check_reference(&mut self, start: usize) {
        let text = self.text;
        let (reference, length) = reference(&text[start..]);
        let span = Self::span(start, start + length);
        let name = match reference {
            EntityReference::Character(_) => return,
            EntityReference::BadNumber => {
                return self.defect(&rules::BAD_REFERENCE, span, |reference| {
                    format!("`{reference}` is not a character that XML allows")
                });
            }
            EntityReference::Lone => {
                return self.report(&rules::BAD_REFERENCE, || {
                    Diagnostic::new(&rules::BAD_REFERENCE, span, "the `&` does not start a reference")
                        .help("write `&amp;`")
                });
            }
            EntityReference::Entity(name) => name,
        };
        let reason = match self.parts.entities.declared.get(name) {
            Some(Entity::Text(entity)) => {
                self.expanded += entity.len();
                if self.expanded > MAX_EXPANSION {
                    self.parts.entities.declared.clear();
                    self.limit(
                        start,
                        "the entities of the file expand to more than 1 MiB of text".to_owned(),
                    );
                }
                return;
            }
            Some(Entity::Unread(reason)) => *reason,
            None => "it is not declared",
        };
        self.defect(&rules::UNKNOWN_ENTITY, span, |_| format!("unknown entity `{}`: {reason}", shown(name)));
    }

    pub(super) fn comment(&mut self, start: usize, end: usize) {
        let Some(content) = self.text.get(start + 4..end - 3) else { return };
        let found = memchr::memmem::find(content.as_bytes(), b"--");
        let found = found.or_else(|| content.ends_with('-').then_some(content.len().saturating_sub(1)));
        if let (Some(length), false) = (found, self.is_skipping()) {
            let span = Self::span(start + 4 + length, start + 6 + length);
            self.defect(&rules::DOUBLE_HYPHEN, span, |_| "the comment contains `--`".to_owned());
        }
    }

    pub(super) fn instruction(&mut self, start: usize, end: usize) {
        let behind = start + 2;
        let target_end = self.find(behind, |byte| is_blank(byte) || byte == b'?');
        let target = &self.text[behind..target_end];
        let is_whole = target_end == end - 2 || self.text.as_bytes()[target_end] != b'?';
        if target == "xml" && is_whole {
            return self.declaration(start, end);
        }
        let is_reserved = target.eq_ignore_ascii_case("xml");
        if (!is_reserved && is_name(target)) || self.is_skipping() {
            return;
        }
        self.defect(&rules::BAD_TARGET, Self::span(behind, target_end), |target| match is_reserved {
            true => format!("the target `{target}` is reserved"),
            false => format!("`{target}` is not a valid target of a processing instruction"),
        });
    }

    fn declaration(&mut self, start: usize, end: usize) {
        if start > 0 && !(start == 3 && self.text.starts_with('\u{FEFF}')) {
            return self.defect(&rules::MISPLACED_DECLARATION, Self::span(start, end), |_| {
                "the XML declaration is not at the start of the file".to_owned()
            });
        }
        let declaration = prolog::declaration(self.text, Self::span(start, end));
        self.encoding = declaration.encoding;
        if let Some((span, message)) = declaration.defect {
            self.defect(&rules::BAD_DECLARATION, span, |_| message);
        }
    }

    pub(super) fn document_type(&mut self, start: usize, end: usize) {
        let span = Self::span(start, end);
        let rule = &rules::DOCUMENT_TYPE;
        let misplaced = |what: &'static str| Diagnostic::new(rule, span, what).severity(Severity::Error);
        if self.is_skipping() {
            return;
        }
        if !self.parts.elements.is_empty() {
            return self.report(rule, || misplaced("the document type is not before the root"));
        }
        if std::mem::replace(&mut self.has_document_type, true) {
            return self.report(rule, || misplaced("the file has a second document type"));
        }
        let read = prolog::document_type(span.of(self.text));
        self.parts.entities = read.entities;
        self.report(rule, || match read.defect {
            Some(defect) => Diagnostic::new(rule, span, defect).severity(Severity::Error),
            None => Diagnostic::new(rule, span, "the file has a document type"),
        });
    }
}

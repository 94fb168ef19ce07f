//! The lines of an EDS or DCF.

use std::sync::OnceLock;

use crate::text::{DescriptionText, LinesBefore, NodeOfType, ReadText, TextEdits, restored};
use objdict_eds::eds::{self, SectionLocator, SectionStarts};
use objdict_eds::ini::{self, Document, EditedSpan};
use objdict_model::diagnostic::{Change, Findings};
use objdict_model::model::{Device, DeviceKind, Objects, Place};
use objdict_model::source::{EditError, SourceFile, Span};

/// A text of lines with its locator, which is created on demand.
#[derive(Debug)]
struct IniText {
    document: Document,
    locator: OnceLock<SectionLocator>,
    /// The findings about the lines.
    findings: OnceLock<Findings>,
    /// The objects that need not be read again while their sections are unchanged.
    plain: Objects,
    /// The starts of its sections, for the next edit.
    starts: OnceLock<SectionStarts>,
}

/// Reads lines, reusing the result from before an edit.
pub(super) fn read(source: SourceFile, kind: DeviceKind, before: Option<LinesBefore<'_>>) -> ReadText {
    let document = Document::new(source);
    let (findings, starts) = (OnceLock::new(), OnceLock::new());
    let read = match before {
        None => eds::read_first(&document, kind),
        Some(LinesBefore { document: old, plain, sections, is_clean }) => {
            let edited = EditedSpan::of(old.text(), document.text());
            if is_clean && ini::findings::lines::stays_clean(&document, old, edited) {
                findings.get_or_init(Findings::new);
            }
            let (read, sections) =
                eds::read_after(&document, kind, &eds::BeforeEdit { plain, sections, edited });
            starts.get_or_init(|| sections);
            read
        }
    };
    let text = IniText { document, locator: OnceLock::new(), findings, plain: read.plain, starts };
    let (device, findings) = restored((read.device, read.findings));
    (Box::new(text), device, findings)
}

impl IniText {
    fn locator(&self) -> &SectionLocator {
        self.locator.get_or_init(|| SectionLocator::new(&self.document))
    }
}

impl DescriptionText for IniText {
    fn source(&self) -> &SourceFile {
        self.document.source()
    }

    fn lines(&self) -> Option<&Document> {
        Some(&self.document)
    }

    fn locate(&self, place: &Place) -> Option<Span> {
        self.locator().locate(&self.document, place)
    }

    fn place_at(&self, at: u32) -> Option<Place> {
        self.locator().place_at(&self.document, at)
    }

    fn objects(&self) -> Vec<(u16, Span)> {
        eds::objects(&self.document)
    }

    fn findings(&self) -> Findings {
        let found = self.findings.get_or_init(|| {
            let mut findings = Findings::new();
            ini::findings::lines::check(&self.document, &mut findings);
            findings
        });
        found.clone()
    }

    fn read_lines(&self) -> Option<LinesBefore<'_>> {
        let is_clean = self.findings.get().is_some_and(Findings::is_empty);
        let sections = self.starts.get_or_init(|| SectionStarts::of(&self.document));
        Some(LinesBefore { document: &self.document, plain: &self.plain, sections, is_clean })
    }

    fn edits(&self, device: &Device, changes: &[Change]) -> Option<TextEdits> {
        eds::edits(&self.document, self.locator(), device, changes)
    }

    fn of_node(&self, file_name: &str, node: Option<NodeOfType<'_>>) -> Option<Result<Vec<u8>, EditError>> {
        Some(match node {
            Some((node, last_eds)) => eds::to_dcf(&self.document, file_name, last_eds, node),
            None => eds::to_eds(&self.document, file_name),
        })
    }

    #[cfg(feature = "full")]
    fn arranged<'a>(&'a self, device: &'a Device) -> Option<Box<dyn Iterator<Item = String> + 'a>> {
        let extents = eds::fmt::Extent::ALL.into_iter();
        Some(Box::new(extents.map(|extent| eds::fmt::arrange(&self.document, device, extent))))
    }
}

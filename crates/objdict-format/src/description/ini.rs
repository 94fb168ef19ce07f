//! The lines of an EDS or DCF.

use std::sync::OnceLock;

use crate::text::{DescriptionText, NodeOfType, ReadText, TextEdits, restored};
use objdict_eds::eds::{self, SectionLocator};
use objdict_eds::ini::{self, Document};
use objdict_model::diagnostic::{Change, Findings};
use objdict_model::model::{Device, DeviceKind, Place};
use objdict_model::source::{EditError, SourceFile, Span};

/// Lines with what finds places in them, which is made when it is asked for.
#[derive(Debug)]
struct IniText {
    document: Document,
    locator: OnceLock<SectionLocator>,
}

/// Reads lines.
pub(super) fn read(source: SourceFile, kind: DeviceKind) -> ReadText {
    let document = Document::new(source);
    let (device, findings) = restored(eds::read(&document, kind));
    (Box::new(IniText { document, locator: OnceLock::new() }), device, findings)
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
        let mut findings = Findings::new();
        ini::findings::lines::check(&self.document, &mut findings);
        findings
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

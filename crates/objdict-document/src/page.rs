//! The content of a page in reading order.
//!
//! A new part is a field of `Page` with its data in a file of its own, partials in `templates/html` and
//! `templates/markdown`, and words in `texts` in both languages.

use super::card::Card;
use super::communication::Communication;
use super::context::Context;
use super::downloads::{self, DownloadView};
use super::finding::RuleFindings;
use super::groups::{self, ShownGroup};
use super::object::{self, Area};
use super::options::Options;
use super::states::{self, ErrorCode, StatesView};
use super::subject::Subject;
use super::texts::LanguageTexts;
use crate::Language;

/// The documentation of a device in words.
pub(crate) struct Page<'a> {
    pub(crate) language: Language,
    pub(crate) texts: &'static LanguageTexts,
    pub(crate) title: String,
    /// The node-ID for formulas.
    pub(crate) node_id: Option<u8>,
    pub(crate) card: Card,
    /// The findings of `check` by rule; `None` if it did not run.
    pub(crate) findings: Option<Vec<RuleFindings<'a>>>,
    pub(crate) communication: Communication,
    /// What configures the node, in order; empty for a device type.
    pub(crate) downloads: Vec<DownloadView>,
    /// The state machine of the device profile.
    pub(crate) states: Option<StatesView>,
    /// The error codes that EMCY may have; empty if the device profile has none.
    pub(crate) error_codes: Vec<ErrorCode>,
    pub(crate) areas: Vec<Area<'a>>,
    pub(crate) groups: Vec<ShownGroup<'a>>,
    /// Whether any entry has a configured value.
    pub(crate) is_configured: bool,
    /// The URL of the index of the site; `None` for a page alone.
    pub(crate) site: Option<String>,
    /// The address of a workbench, and the file to open there.
    pub(crate) workbench: Option<(&'a str, &'a str)>,
}

impl<'a> Page<'a> {
    pub(crate) fn new(subject: &Subject<'a>, options: &'a Options, context: &Context<'a>) -> Self {
        let areas = object::areas(context);
        let card = Card::new(subject, context);
        let is_configured = areas
            .iter()
            .flat_map(|area| &area.objects)
            .flat_map(|object| &object.entries)
            .any(|entry| entry.value.is_some());
        Self {
            language: context.language,
            texts: context.texts,
            title: options.title.clone().unwrap_or_else(|| card.title.clone()),
            node_id: context.node_id,
            card,
            findings: subject.findings.map(RuleFindings::by_rule),
            communication: Communication::new(&context.decoder, &|entry| context.name(entry).to_owned()),
            downloads: downloads::downloads(context),
            states: states::states(context),
            error_codes: states::error_codes(context),
            groups: groups::groups(context),
            areas,
            is_configured,
            site: None,
            workbench: options.workbench.as_deref().map(|address| (address, subject.file)),
        }
    }

    /// The CAN-ID of the default SDO request in hex; `6xx` if the node-ID is unknown (CiA 301 §7.3.5).
    pub(crate) fn sdo_can_id(&self) -> String {
        self.node_id.map_or_else(|| "6xx".to_owned(), |node| format!("{:X}", 0x600 + u16::from(node)))
    }

    /// The number of findings.
    pub(crate) fn finding_count(&self) -> usize {
        self.findings.iter().flatten().map(|found| found.findings.len()).sum()
    }

    /// The number of objects.
    pub(crate) fn object_count(&self) -> usize {
        self.areas.iter().map(|area| area.objects.len()).sum()
    }

    /// Whether browsers need long to lay out parts outside the viewport.
    pub(crate) fn is_large(&self) -> bool {
        self.entry_count() > 1500
    }

    /// The number of entries.
    pub(crate) fn entry_count(&self) -> usize {
        self.areas.iter().flat_map(|area| &area.objects).map(|object| object.entries.len()).sum()
    }
}

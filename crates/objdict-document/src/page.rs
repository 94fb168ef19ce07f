//! The content of a page in reading order: communication (services and PDOs as text, CAN-IDs), and the configuration of
//! a node in the order of transmission.
//!
//! A new part is a field of `Page` with its data in a separate file, partials in `templates/html` and
//! `templates/markdown`, and text in `texts` in both languages.

use super::anchor::Anchor;
use super::card::Card;
use super::connections::{self, ConnectionRow};
use super::context::{Context, Options, Subject};
use super::details::{self, ErrorCode, StatesView};
use super::diagram::Grid;
use super::finding::RuleFindings;
use super::groups::{self, ShownGroup};
use super::object::{self, Area};
use super::pdos::{self, PdoView};
use super::sentence::anchor;
use super::services::{self, ServiceView};
use super::texts::LanguageTexts;
use crate::Language;
use crate::describe::{Decoder, ValueReader};
use crate::model::{Entry, Value};
use objdict_node::download::{ConciseDcf, Download, PlanOptions, Step, transferred_type};

/// The documentation of a device as text.
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
    /// The configuration of the node, in order; empty for a device type.
    pub(crate) downloads: Vec<DownloadView>,
    /// The state machine of the device profile.
    pub(crate) states: Option<StatesView>,
    /// The possible error codes of EMCY; empty if the device profile has none.
    pub(crate) error_codes: Vec<ErrorCode>,
    pub(crate) areas: Vec<Area<'a>>,
    pub(crate) groups: Vec<ShownGroup<'a>>,
    /// Whether any entry has a configured value.
    pub(crate) is_configured: bool,
    /// The URL of the index of the site; `None` for a single page.
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
            downloads: downloads(context),
            states: details::states(context),
            error_codes: details::error_codes(context),
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

/// The communication section of a page.
pub(crate) struct Communication {
    pub(crate) services: Vec<ServiceView>,
    pub(crate) pdos: Vec<PdoView>,
    pub(crate) connections: Vec<ConnectionRow>,
}

impl Communication {
    /// Describes a device. If the device stores PDOs as objects, those implied by `CompactPDO` are included
    /// ([`Device::with_implicit_pdos`](crate::model::Device::with_implicit_pdos)). `name` supplies the names
    /// of entries.
    pub(crate) fn new(decoder: &Decoder<'_>, name: &dyn Fn(&Entry) -> String) -> Self {
        Self {
            services: services::services(decoder, name),
            pdos: pdos::pdos(decoder, name),
            connections: connections::connections(decoder),
        }
    }

    /// The grid shared by all PDO diagrams.
    pub(crate) fn grid(&self) -> Grid {
        Grid::new()
    }
}

/// A download to the device.
pub(crate) struct DownloadView {
    pub(crate) entry: Anchor,
    /// The position of the entry on the page.
    pub(crate) anchor: Option<Anchor>,
    /// The names of object and entry: `Identity object / Vendor-ID`.
    pub(crate) name: String,
    /// The value; `None` for data in a file.
    pub(crate) value: Option<Value>,
    /// The value as text, or the name of the file.
    pub(crate) shown: String,
    /// The meaning of the value as text.
    pub(crate) meaning: Option<String>,
}

/// The downloads of a configured node; empty if its values cannot be sent, which `check` reports.
pub(super) fn downloads(context: &Context<'_>) -> Vec<DownloadView> {
    let options = PlanOptions { node_id: context.node_id, ..PlanOptions::default() };
    let plan = ConciseDcf::plan(context.device, &options).unwrap_or_default();
    let view = |step| match step {
        Step::Write(download) => written(context, &download),
        Step::File(file) => DownloadView { shown: file.name.into(), ..view(context, file.index, file.sub) },
    };
    plan.steps.into_iter().map(view).collect()
}

fn written(context: &Context<'_>, download: &Download) -> DownloadView {
    let (index, sub) = download.entry();
    let value = download.value(context.device).unwrap_or_else(|| Value::Bytes(download.data.clone().into()));
    let reader = ValueReader { index, node_id: context.node_id };
    DownloadView {
        shown: reader.short(Some(&value), transferred_type(context.device, index, sub)),
        meaning: context.decoder.of(index, sub, &value),
        value: Some(value),
        ..view(context, index, sub)
    }
}

fn view(context: &Context<'_>, index: u16, sub: u8) -> DownloadView {
    let object = context.device.object(index);
    let names = object.map(|object| {
        let of_object = context.name(&object.main);
        match object.entry(sub).filter(|_| object.object_type().has_subs()) {
            Some(entry) => format!("{of_object} / {}", context.name(&entry)),
            None => of_object.to_owned(),
        }
    });
    DownloadView {
        entry: Anchor::entry(index, sub),
        anchor: anchor(context.device, index, sub),
        name: names.unwrap_or_default(),
        value: None,
        shown: String::new(),
        meaning: None,
    }
}

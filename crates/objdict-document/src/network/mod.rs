//! Networks on the index page of a site: who is in them, what goes from which node to which, and how they boot.

mod link;
mod site_network;
mod stated;
mod tables;

use std::borrow::Cow;

use askama::Template;
use objdict_network::{End, MappedEntry, MessageRow, NodeRow, Overview, Timing, graph, timeline};

use self::link::{PdoLink, can_id, spoken};
pub use self::site_network::SiteNetwork;
pub(crate) use self::stated::{StatedNode, stated};
pub(crate) use self::tables::tables;
use super::anchor::Anchor;
use super::escape::{address, filters};
use super::finding::RuleFindings;
use super::form::Form;
use super::texts::LanguageTexts;
use crate::Language;
use crate::describe::{decimal, of_microseconds, of_milliseconds};
use crate::model::Address;

/// A network in words.
pub(crate) struct NetworkView<'a> {
    language: Language,
    texts: &'static LanguageTexts,
    network: &'a SiteNetwork,
    overview: &'a Overview,
    /// What addresses on the page begin with.
    prefix: String,
    /// The name of the picture beside the page; empty if there is none.
    picture: String,
    /// The URLs of the pages of nodes.
    pages: Vec<Option<String>>,
    findings: Option<Vec<RuleFindings<'a>>>,
    links: Vec<PdoLink<'a>>,
}

/// A number of 32 bits.
fn hex(number: u32) -> String {
    format!("0x{number:08X}")
}

impl<'a> NetworkView<'a> {
    /// The view of the network with this number on the page, counted from 1.
    pub(crate) fn new(network: &'a SiteNetwork, number: usize, form: Form) -> Self {
        let overview = &network.overview;
        let has_pages = network.pages.iter().any(Option::is_some);
        Self {
            language: overview.language,
            texts: LanguageTexts::of(overview.language),
            network,
            overview,
            prefix: format!("network-{number}"),
            // a page without others beside it has no picture there either
            picture: match form {
                Form::Markdown if has_pages => format!("network-{number}.svg"),
                _ => String::new(),
            },
            pages: network.pages.iter().map(|page| page.as_deref().map(address)).collect(),
            findings: network.findings.as_deref().map(RuleFindings::by_rule),
            links: overview.links.iter().map(PdoLink::new).collect(),
        }
    }

    /// The pictures and their file names, if they are files of their own.
    pub(crate) fn pictures(&self) -> Vec<(String, String)> {
        if self.picture.is_empty() {
            return Vec::new();
        }
        let timeline =
            self.network.timing.is_some().then(|| (self.timeline_picture(), self.timeline() + "\n"));
        [(self.picture.clone(), self.drawn() + "\n")].into_iter().chain(timeline).collect()
    }

    /// The file of the picture of messages in time.
    fn timeline_picture(&self) -> String {
        format!("{}-timeline.svg", self.prefix)
    }

    /// The picture of messages in time (SVG).
    fn timeline(&self) -> String {
        self.network.timing.as_ref().map_or_else(String::new, |timing| timeline::svg(timing, can_id))
    }

    /// Load, and the bit rate from which the network fits.
    fn timed(&self) -> Option<String> {
        let Timing { load, bit_rate, .. } = self.network.timing.as_ref()?;
        let percent =
            |percent: u64| decimal(u32::try_from(percent / 100).unwrap_or(u32::MAX), 1, self.language);
        let LanguageTexts { load_average, load_worst, fits_from, .. } = self.texts;
        let (average, worst) =
            (percent(load.average_percent(*bit_rate)), percent(load.worst_percent(*bit_rate)));
        let loads = format!("{load_average} {average} %, {load_worst} {worst} %");
        let rate = self.network.timing.as_ref().and_then(Timing::fits_from);
        let fits = rate.map_or_else(String::new, |rate| format!("; {fits_from} {rate} kbit/s"));
        Some(loads + &fits)
    }

    /// How long a message may take until it is received, and its deadline; empty where nothing is known.
    fn response(&self, message: &MessageRow) -> [String; 2] {
        let timed = self.network.timing.iter().flat_map(|timing| &timing.messages);
        let Some(timed) = timed.into_iter().find(|timed| timed.can_id == message.can_id) else {
            return Default::default();
        };
        let time = |time: u64| {
            of_microseconds(u32::try_from(time.div_ceil(1000)).unwrap_or(u32::MAX), self.language)
        };
        let response = timed.response.map_or_else(|| self.texts.unbounded.to_owned(), time);
        let late = if timed.is_missed() { format!("; {}", self.texts.may_be_late) } else { String::new() };
        [response + &late, timed.deadline.map(|(deadline, _)| time(deadline)).unwrap_or_default()]
    }

    /// The picture of nodes and messages (SVG).
    fn drawn(&self) -> String {
        graph::svg(self.overview, can_id)
    }

    /// `chapter 4`; empty for a network without a name.
    pub(crate) fn name(&self) -> &'a str {
        self.overview.name.as_deref().unwrap_or_default()
    }

    /// File, bit rate and load.
    fn summary(&self) -> String {
        let mut words: Vec<String> = self.network.file.iter().cloned().collect();
        words.extend(self.overview.bit_rate.map(|rate| format!("{rate} kbit/s")));
        let load = |load| {
            let load = decimal(u32::try_from(load).unwrap_or(u32::MAX), 1, self.language);
            format!("{} {load} %", self.texts.bus_load)
        };
        words.extend(self.overview.load.map(load));
        words.join(", ")
    }

    /// What the load does not count; empty without a load.
    fn uncounted(&self) -> String {
        let words = self.overview.uncounted.words(self.language, can_id);
        if self.overview.load.is_none() || words.is_empty() {
            return String::new();
        }
        format!("{}: {words}", self.texts.not_counted)
    }

    /// The number of findings.
    fn finding_count(&self) -> usize {
        self.findings.iter().flatten().map(|found| found.findings.len()).sum()
    }

    /// Node-IDs of several nodes, which CANopen does not allow.
    fn doubled(&self) -> Vec<u8> {
        let mut ids: Vec<u8> = self.overview.nodes.iter().filter_map(|node| node.node_id).collect();
        let mut doubled: Vec<u8> = Vec::new();
        ids.sort_unstable();
        doubled.extend(ids.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]));
        doubled.dedup();
        doubled
    }

    /// The URL of the page of a node; `None` without one.
    fn page(&self, position: usize) -> Option<&str> {
        self.pages.get(position)?.as_deref()
    }

    /// `5 pump`.
    fn label(&self, position: usize) -> String {
        let node = self.overview.nodes.iter().find(|node| node.position == position);
        node.map_or_else(String::new, called)
    }

    /// The URL of an entry of a node; `None` without a page or for a dummy.
    fn entry_page(&self, position: Option<usize>, entry: &MappedEntry) -> Option<String> {
        let Address { index, sub } = entry.address?;
        Some(format!("{}#{}", self.page(position?)?, Anchor { index, sub }))
    }

    /// The nodes that downloads configure, with their numbers in the table of nodes, and their positions in the network.
    fn configured(&self) -> Vec<(usize, Option<usize>, &NodeRow)> {
        let nodes = self.overview.nodes.iter().enumerate();
        let configured = nodes.filter(|(_, node)| !node.configuration.is_empty());
        configured.map(|(number, node)| (number, Some(node.position), node)).collect()
    }

    /// What goes from one node to another, with the numbers of the links.
    fn between(&self, from: &NodeRow, to: &NodeRow) -> Vec<(usize, &PdoLink<'a>)> {
        let is =
            |end: &Option<End>, node: &NodeRow| end.as_ref().is_some_and(|end| end.position == node.position);
        let links = self.links.iter().enumerate();
        links.filter(|(_, link)| is(&link.row.sender, from) && is(&link.row.receiver, to)).collect()
    }

    /// What a service is called.
    fn service(&self, end: &End) -> Cow<'static, str> {
        end.service.name(self.language)
    }

    /// A period in microseconds; empty without one.
    fn period(&self, period: Option<u64>) -> String {
        let shown = |time| of_microseconds(u32::try_from(time).unwrap_or(u32::MAX), self.language);
        period.map(shown).unwrap_or_default()
    }

    /// A time in milliseconds; empty for 0.
    fn time(&self, time: u16) -> String {
        if time == 0 { String::new() } else { of_milliseconds(time.into(), self.language) }
    }
}

/// `5 pump`.
fn called(node: &NodeRow) -> String {
    let id = node.node_id.map_or_else(|| "?".to_owned(), |id| id.to_string());
    format!("{id} {}", node.name)
}

#[derive(Template)]
#[template(path = "html/_network.html")]
struct HtmlNetwork<'a> {
    network: &'a NetworkView<'a>,
}

#[derive(Template)]
#[template(path = "markdown/_network.md")]
struct MarkdownNetwork<'a> {
    network: &'a NetworkView<'a>,
}

impl NetworkView<'_> {
    /// The network as a part of an HTML page.
    pub(crate) fn html(&self) -> String {
        // writing to a text cannot fail, nor do the filters
        HtmlNetwork { network: self }.render().unwrap_or_default()
    }

    /// The network as a part of a Markdown page.
    pub(crate) fn markdown(&self) -> String {
        MarkdownNetwork { network: self }.render().unwrap_or_default()
    }
}

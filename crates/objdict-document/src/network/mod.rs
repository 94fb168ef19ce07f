//! Networks on the index page of a site: their nodes, the data between nodes, and the boot procedure.

mod tables;

use std::borrow::Cow;
use std::collections::BTreeMap;

pub(crate) use self::tables::tables;
use super::anchor::Anchor;
use super::context::{Context, Form};
use super::escape::{address, filters};
use super::finding::{Finding, RuleFindings};
use super::texts::LanguageTexts;
use crate::Language;
use crate::describe::{decimal, of_microseconds, of_milliseconds, spelled};
use crate::model::Address;
use crate::source::Span;
use askama::Template;
use objdict_network::{
    CarriedEntry, DcfgenMode, End, LinkRow, MappedEntry, MessageId, MessageRow, Network, Node, NodeRow,
    Overview, Said, Timing, TimingOptions, compile, graph, timeline,
};

/// A network as text.
pub(crate) struct NetworkView<'a> {
    language: Language,
    texts: &'static LanguageTexts,
    network: &'a SiteNetwork,
    overview: &'a Overview,
    /// The prefix of addresses on the page.
    prefix: String,
    /// The file name of the diagram next to the page; empty if there is none.
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
            // a single page has no diagram next to it either
            picture: match form {
                Form::Markdown if has_pages => format!("network-{number}.svg"),
                _ => String::new(),
            },
            pages: network.pages.iter().map(|page| page.as_deref().map(address)).collect(),
            findings: network.findings.as_deref().map(RuleFindings::by_rule),
            links: overview.links.iter().map(PdoLink::new).collect(),
        }
    }

    /// The diagrams and their file names, if they are separate files.
    pub(crate) fn pictures(&self) -> Vec<(String, String)> {
        if self.picture.is_empty() {
            return Vec::new();
        }
        let timeline =
            self.network.timing.is_some().then(|| (self.timeline_picture(), self.timeline() + "\n"));
        [(self.picture.clone(), self.drawn() + "\n")].into_iter().chain(timeline).collect()
    }

    /// The file of the timing diagram.
    fn timeline_picture(&self) -> String {
        format!("{}-timeline.svg", self.prefix)
    }

    /// The timing diagram (SVG).
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

    /// The maximum time until a message is received, and its deadline; empty if unknown.
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

    /// The diagram of nodes and messages (SVG).
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

    /// Messages that the load does not include; empty without a load.
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

    /// Node-IDs that several nodes have, which CANopen does not allow.
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

    /// The data sent from one node to another, with the numbers of the links.
    fn between(&self, from: &NodeRow, to: &NodeRow) -> Vec<(usize, &PdoLink<'a>)> {
        let is =
            |end: &Option<End>, node: &NodeRow| end.as_ref().is_some_and(|end| end.position == node.position);
        let links = self.links.iter().enumerate();
        links.filter(|(_, link)| is(&link.row.sender, from) && is(&link.row.receiver, to)).collect()
    }

    /// The name of a service.
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
        // writing to a string cannot fail, nor can the filters
        HtmlNetwork { network: self }.render().unwrap_or_default()
    }

    /// The network as a part of a Markdown page.
    pub(crate) fn markdown(&self) -> String {
        MarkdownNetwork { network: self }.render().unwrap_or_default()
    }
}

/// A network for the index of a site.
#[derive(Clone, Debug)]
pub struct SiteNetwork {
    /// The network and its behaviour, in the language of the site.
    pub overview: Overview,
    /// Load and response times; `None` for a network without a bit rate.
    pub timing: Option<Timing>,
    /// The file of the network, as known to readers; `None` if only its nodes are described.
    pub file: Option<String>,
    /// The names of the nodes' pages by the position of the node in the network; `None` for a node without a page.
    pub pages: Vec<Option<String>>,
    /// The findings of `network check`; `None` if it did not run.
    pub findings: Option<Vec<Finding>>,
}

/// A PDO from its sender to one receiver.
struct PdoLink<'a> {
    row: &'a LinkRow,
    can_id: String,
    /// Whether the receiver expects more bits than are sent, and therefore ignores the PDO.
    is_too_short: bool,
}

impl<'a> PdoLink<'a> {
    fn new(row: &'a LinkRow) -> Self {
        let end = |of: fn(&CarriedEntry) -> &Option<MappedEntry>| {
            let mapped = row.entries.iter().filter(|entry| of(entry).is_some());
            mapped.map(|entry| entry.bit + entry.bits).max().unwrap_or(0)
        };
        let (sent, received) = (end(|entry| &entry.from), end(|entry| &entry.to));
        Self { row, can_id: can_id(row.can_id), is_too_short: sent != 0 && sent < received }
    }

    /// The node that sends it.
    fn sender(&self) -> Option<usize> {
        self.row.sender.as_ref().map(|end| end.position)
    }

    /// The node that receives it.
    fn receiver(&self) -> Option<usize> {
        self.row.receiver.as_ref().map(|end| end.position)
    }

    /// The lines of the link in a table.
    fn rows(&self) -> usize {
        self.row.entries.len().max(1)
    }

    /// The entries in short notation: `0x6000:01–05, 0x6401:01`; those of the sender, if known.
    fn span(&self) -> String {
        let entries = self.row.entries.iter().filter_map(|entry| entry.from.as_ref().or(entry.to.as_ref()));
        let mut spans: Vec<(Address, u8)> = Vec::new();
        for Address { index, sub } in entries.filter_map(|entry| entry.address) {
            let number = sub.unwrap_or(0);
            match spans.last_mut() {
                Some((first, last)) if first.index == index && last.checked_add(1) == Some(number) => {
                    *last = number;
                }
                _ => spans.push((Address { index, sub }, number)),
            }
        }
        let shown = |(first, last): (Address, u8)| {
            let anchor = Anchor { index: first.index, sub: first.sub };
            let is_one = first.sub.unwrap_or(0) == last;
            if is_one { anchor.spoken() } else { format!("{}–{last:02X}", anchor.spoken()) }
        };
        spans.into_iter().map(shown).collect::<Vec<_>>().join(", ")
    }
}

/// `0x185`; eight digits for an extended frame.
fn can_id(id: MessageId) -> String {
    spelled(id.number, id.is_extended)
}

/// `0x6000:01`; empty for a dummy.
fn spoken(entry: &MappedEntry) -> String {
    entry.address.map_or_else(String::new, |Address { index, sub }| Anchor { index, sub }.spoken())
}

/// A configured node of a site.
#[derive(Debug)]
pub(crate) struct StatedNode {
    /// Number and name of its network.
    network: (Option<u32>, String),
    /// The name of its page.
    pub(crate) page: String,
    node: Node,
}

impl StatedNode {
    /// The node of a configured device; `None` for a device type.
    pub(crate) fn new(context: &Context<'_>, title: &str, page: &str) -> Option<Self> {
        let commissioning = context.device.commissioning.as_ref()?;
        let text = |text: &Option<String>| text.as_deref().unwrap_or_default().trim().to_owned();
        let name = Some(text(&commissioning.node_name)).filter(|name| !name.is_empty());
        let node = Node {
            name: said(name.unwrap_or_else(|| title.to_owned())),
            file: said(page.to_owned()),
            device: context.device.clone(),
            node_id: Some(said(context.node_id?)),
            ..Node::default()
        };
        let network = (commissioning.net_number, text(&commissioning.network_name));
        Some(Self { network, page: page.to_owned(), node })
    }
}

/// A value without a position in a text.
fn said<T>(value: T) -> Said<T> {
    Said::new(value, Span::empty(0))
}

/// The networks with several of the nodes. Each node is as described; the manager is irrelevant.
pub(crate) fn stated(nodes: Vec<StatedNode>, tag: &str) -> Vec<SiteNetwork> {
    let mut networks: BTreeMap<(Option<u32>, String), Vec<StatedNode>> = BTreeMap::new();
    for node in nodes {
        networks.entry(node.network.clone()).or_default().push(node);
    }
    let several = networks.into_iter().filter(|(_, nodes)| nodes.len() > 1);
    several.map(|((number, name), nodes)| network(number, &name, nodes, tag)).collect()
}

fn network(number: Option<u32>, name: &str, nodes: Vec<StatedNode>, tag: &str) -> SiteNetwork {
    let bit_rate = |node: &StatedNode| node.node.device.commissioning.as_ref()?.baud_rate;
    let mut bit_rates = nodes.iter().map(bit_rate);
    let bit_rate = bit_rates.next().flatten().filter(|rate| bit_rates.all(|other| other == Some(*rate)));
    // `2 line`
    let words = number.map(|number| number.to_string()).into_iter().chain([name.to_owned()]);
    let words: Vec<String> = words.filter(|word| !word.is_empty()).collect();
    let (pages, nodes) = nodes.into_iter().map(|node| (Some(node.page), node.node)).unzip();
    let network = Network {
        name: Some(words.join(" ")).filter(|name| !name.is_empty()),
        bit_rate: bit_rate.map(said),
        nodes,
        ..Network::default()
    };
    let compiled = compile(&network, DcfgenMode::Corrected);
    let overview = Overview::in_language(&network, &compiled, tag);
    let timing = Timing::in_language(&network, &compiled, &TimingOptions::default(), overview.language);
    SiteNetwork { overview, timing, file: None, pages, findings: None }
}

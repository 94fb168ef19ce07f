//! The networks that configured nodes say they are in.

use std::collections::BTreeMap;

use objdict_network::{DcfgenMode, Network, Node, Overview, Said, Timing, TimingOptions, compile};

use super::site_network::SiteNetwork;
use crate::context::Context;
use crate::source::Span;

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

/// What no text says at a place.
fn said<T>(value: T) -> Said<T> {
    Said::new(value, Span::empty(0))
}

/// The networks with several of the nodes. Each node is as its description says; who the manager is does not matter.
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

//! What a site is given of a network.

use objdict_network::{Overview, Timing};

use crate::finding::Finding;

/// A network for the index of a site.
#[derive(Clone, Debug)]
pub struct SiteNetwork {
    /// What the network is and does, in the language of the site.
    pub overview: Overview,
    /// Load and response times; `None` for a network without a bit rate.
    pub timing: Option<Timing>,
    /// The file of the network, as readers know it; `None` if only its nodes are described.
    pub file: Option<String>,
    /// The names of the nodes' pages by the position of the node in the network; `None` for a node without a page.
    pub pages: Vec<Option<String>>,
    /// The findings of `network check`; `None` if it did not run.
    pub findings: Option<Vec<Finding>>,
}

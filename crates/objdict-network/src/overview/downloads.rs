//! The downloads that configure a node, in order.

use super::{ConfiguredNetwork, MappedEntry};
use crate::diagnostic::one_line;
use crate::download::{ConciseDcf, transferred_type};
use crate::model::Device;
use objdict_node::concise;

/// A download to a node.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DownloadRow {
    /// The written entry.
    pub entry: MappedEntry,
    /// The value, spelled as in the text of a concise DCF.
    pub value: String,
}

impl ConfiguredNetwork<'_> {
    pub(super) fn downloads(self, device: &Device, downloads: &ConciseDcf) -> Vec<DownloadRow> {
        let row = |download: &crate::download::Download| {
            let (index, sub) = download.entry();
            let (_, value) = concise::spelled(download, transferred_type(device, index, sub));
            // many bytes are in several lines there
            let value = value.lines().map(|line| one_line(line.trim())).collect::<Vec<_>>().join(" ");
            DownloadRow { entry: self.entry(device, index, sub), value }
        };
        downloads.0.iter().map(row).collect()
    }
}

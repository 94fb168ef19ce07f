//! A node of the bus with what describes its values.

use super::BusNode;
use super::identifier::{DbcName, DbcNames, words};
use crate::describe::Decoder;
use crate::model::{Device, Entry, Meanings};

/// A node.
pub(super) struct Station<'a> {
    pub(super) device: &'a Device,
    pub(super) node_id: u8,
    pub(super) decoder: Decoder<'a>,
    pub(super) meanings: Meanings<'a>,
    /// The name on the bus.
    pub(super) name: DbcName,
    /// The name that the device states, or the node-ID.
    pub(super) title: String,
    /// Whether its PDOs are the other sides of those of the other nodes.
    pub(super) is_counterpart: bool,
}

/// The language of names.
pub(super) const LANGUAGE: &str = "en";

impl<'a> Station<'a> {
    pub(super) fn new(node: &BusNode<'a>, names: &mut DbcNames) -> Self {
        let BusNode { device, node_id, name, is_counterpart } = *node;
        let stated = device.commissioning.as_ref().and_then(|of| of.node_name.as_deref());
        let product = device.device_info.as_ref().and_then(|info| info.product_name.as_deref());
        let mut titles = [name, stated, product].into_iter().flatten().map(str::trim);
        let title = titles.find(|title| !words(title).is_empty());
        let mut title = title.map_or_else(|| format!("Node {node_id}"), str::to_owned);
        let name = names.claim(&words(&title), &node_id.to_string());
        if *name.full.as_ref().unwrap_or(&name.short) != words(&title) {
            title.push_str(&format!(" {node_id}")); // another node has the same
        }
        Self {
            device,
            node_id,
            decoder: Decoder::english(device, Some(node_id)),
            meanings: device.meanings_in(LANGUAGE),
            name,
            title,
            is_counterpart,
        }
    }

    /// The name of an entry in English, else the name in the file.
    pub(super) fn name_of<'e>(&self, entry: &'e Entry) -> &'e str {
        let label = entry.parameter.as_ref().and_then(|parameter| parameter.labels.name_in(LANGUAGE));
        label.map(str::trim).filter(|label| !label.is_empty()).unwrap_or(&entry.name)
    }

    /// The words of a signal: the name in the application, else that of the entry. The name of an entry such as `Sub 1` says
    /// nothing without that of its object.
    pub(super) fn signal_words(&self, index: u16, sub: u8, entry: &Entry) -> String {
        let configured = entry.configured.as_ref().and_then(|configured| configured.denotation.as_deref());
        let parameter = entry.parameter.as_ref().and_then(|of| of.denotation.name_in(LANGUAGE));
        let denotation = configured.or(parameter).map(words).filter(|words| !words.is_empty());
        if let Some(denotation) = denotation {
            return denotation;
        }
        let own = words(self.name_of(entry));
        let object = self.device.object(index).filter(|object| object.object_type().has_subs() || sub > 0);
        let object = object.map(|object| words(self.name_of(&object.main))).unwrap_or_default();
        let is_in = |word: &str| word.len() > 2 && own.split('_').any(|own| own.eq_ignore_ascii_case(word));
        match (object.is_empty(), own.is_empty()) {
            (false, true) => format!("{object}_{sub:02X}"),
            (false, false) if !object.split('_').any(is_in) => format!("{object}_{own}"),
            _ => own,
        }
    }
}

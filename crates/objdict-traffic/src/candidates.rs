//! Which node a description without a node-ID is for: by the answers to 1000h and 1018h, or the only one there is.

use std::collections::BTreeMap;

use super::{DescribedNode, Descriptions};
use objdict_document::describe::frames::{DecodedFrame, FrameKind, FrameReader, TransferStep};
use objdict_model::model::Device;

/// The entries that say what a node is.
const IDENTITY: [(u16, u8); 4] = [(0x1000, 0), (0x1018, 1), (0x1018, 2), (0x1018, 3)];

/// Descriptions without a node-ID, and what is known of the nodes of the bus.
#[derive(Debug)]
pub(super) struct Candidates<'d> {
    waiting: Vec<&'d DescribedNode>,
    answers: BTreeMap<u8, [Option<i128>; IDENTITY.len()]>,
    /// Node-IDs of those who answered SDOs, who sent heartbeats or the like, and who sent PDOs.
    seen: [u128; 3],
    found: u128,
    is_news: bool,
}

/// What was found: the node, its description, and what to say of it.
type FoundNode<'d> = (u8, Option<&'d DescribedNode>, Option<String>);

impl<'d> Candidates<'d> {
    pub(super) fn new(descriptions: &'d Descriptions) -> Self {
        let waiting = descriptions.nodes.iter().filter(|node| node.node_id.is_none()).collect();
        Self { waiting, answers: BTreeMap::new(), seen: [0; 3], found: 0, is_news: false }
    }

    /// Whether a description waits for its node.
    pub(super) fn is_open(&self) -> bool {
        !self.waiting.is_empty()
    }

    /// Forgets the descriptions whose nodes were not found.
    pub(super) fn close(&mut self) {
        self.waiting.clear();
    }

    /// What a frame says of its node.
    pub(super) fn take(&mut self, decoded: &DecodedFrame, reader: &FrameReader<'_>) {
        let Some(node_id) = decoded.node_id else { return };
        let is_answer = decoded.sdo.is_some_and(|sdo| !sdo.is_request);
        let place = match decoded.kind {
            FrameKind::Sdo if is_answer => 0,
            FrameKind::Heartbeat | FrameKind::BootUp | FrameKind::Emcy => 1,
            FrameKind::Pdo => 2,
            _ => return,
        };
        let bit = 1 << node_id;
        self.is_news |= self.seen[place] & bit == 0;
        self.seen[place] |= bit;
        let asked = decoded.sdo.filter(|sdo| is_answer && sdo.step == TransferStep::Value);
        let at = asked.and_then(|sdo| IDENTITY.iter().position(|entry| Some(*entry) == sdo.entry));
        if let (Some(at), Some(bytes)) = (at, reader.transferred_bytes(decoded)) {
            let number = bytes.iter().rev().fold(0, |number, byte| number << 8 | i128::from(*byte));
            self.answers.entry(node_id).or_default()[at] = Some(number);
            self.is_news = true;
        }
    }

    /// The nodes that were found since the last time. A node that is the only one is assumed.
    pub(super) fn found(&mut self, is_all: bool, reader: &FrameReader<'_>) -> Vec<FoundNode<'d>> {
        let mut found = Vec::new();
        if !self.is_open() || !std::mem::take(&mut self.is_news) && !is_all {
            return found;
        }
        for (&node_id, answers) in &self.answers {
            let is_free = self.found >> node_id & 1 == 0 && !reader.is_described(node_id);
            let mut matching = self.waiting.iter().filter(|node| is_it(&node.device, answers));
            if let (true, Some(node), None) = (is_free, matching.next(), matching.next()) {
                self.found |= 1 << node_id;
                let note =
                    format!("`{}` describes node {node_id}, by its responses to 1000h and 1018h", node.file);
                found.push((node_id, Some(*node), Some(note)));
            }
        }
        if let [node] = self.waiting.as_slice()
            && self.found == 0
        {
            let assumed = self.assumed(node, is_all, reader);
            if let Some((node_id, Some(_), _)) = &assumed {
                self.found |= 1 << node_id;
            }
            found.extend(assumed);
        }
        found
    }

    /// The only node of the bus that has no description, if there is one.
    fn assumed(
        &self,
        node: &'d DescribedNode,
        is_all: bool,
        reader: &FrameReader<'_>,
    ) -> Option<FoundNode<'d>> {
        let is_unknown = |node_id: &u8| !reader.is_described(*node_id);
        let nodes = |seen: u128| (1..=127).filter(move |node_id| seen >> node_id & 1 == 1).filter(is_unknown);
        // PDOs may have any CAN-ID, so those of a log that goes on are not enough
        let levels = if is_all { &self.seen[..] } else { &self.seen[..2] };
        let seen = *levels.iter().find(|seen| nodes(**seen).next().is_some())?;
        let file = &node.file;
        let mut nodes = nodes(seen);
        let first = nodes.next()?;
        if let Some(second) = nodes.next() {
            let note = format!(
                "`{file}` does not say which node it describes: the log has {first}, {second} and others; write `--with {first}={file}`"
            );
            let note = note.replace(" and others", if nodes.next().is_some() { ", and others" } else { "" });
            return is_all.then_some((first, None, Some(note)));
        }
        let is_other = self.answers.get(&first).is_some_and(|answers| differs(&node.device, answers));
        if is_other {
            let note =
                format!("`{file}` does not describe node {first}, whose identity (1000h, 1018h) differs");
            return is_all.then_some((first, None, Some(note)));
        }
        let note =
            format!("`{file}` is taken for node {first}, the only one in the log without a description");
        Some((first, Some(node), Some(note)))
    }
}

/// The numbers that a description and the answers both have.
fn pairs<'a>(
    device: &'a Device,
    answers: &'a [Option<i128>; IDENTITY.len()],
) -> impl Iterator<Item = (usize, i128, i128)> + 'a {
    IDENTITY.iter().enumerate().filter_map(|(at, &(index, sub))| {
        let stated = device.entry(index, sub)?.value()?.as_integer()?;
        Some((at, stated, answers[at]?))
    })
}

/// Whether the answers are of a device of this description: vendor and product at least, or where it has no product the type.
fn is_it(device: &Device, answers: &[Option<i128>; IDENTITY.len()]) -> bool {
    let is_known = |wanted| pairs(device, answers).any(|(at, stated, _)| at == wanted && stated != 0);
    !differs(device, answers) && (is_known(2) || is_known(0) && is_known(1))
}

/// Whether the answers are of another device; a product code or vendor-ID of 0 in a description is not stated, and revisions change.
fn differs(device: &Device, answers: &[Option<i128>; IDENTITY.len()]) -> bool {
    pairs(device, answers).any(|(at, stated, answer)| at != 3 && stated != answer && (stated != 0 || at == 0))
}

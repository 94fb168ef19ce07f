//! Links become PDOs.

mod can_ids;
mod ends;
mod frame;
mod groups;
mod obstacles;
mod pack;
mod pdos;
#[cfg(test)]
mod tests;

pub(crate) use self::pdos::NodePdos;
use crate::Network;
use crate::compile::compile;
use crate::compiled::DcfgenMode;
use crate::diagnostic::Findings;

/// Converts the [links](Network::links) to PDOs: creates a [`PdoRequest`](crate::PdoRequest) for each PDO of
/// a producer and of its consumers.
///
/// Links of a producer with the same consumers and parameters share as few PDOs as possible; an entry is not sent
/// twice. A consumer of parts of a PDO has dummies in the gaps. CAN-IDs are those of the predefined connection set for
/// the PDO of the producer or of the first consumer, then free ones (CiA 301 §7.3.5); additions at the end of the
/// network do not change them. PDOs whose COB-ID or mapping the network file states are not used.
///
/// A link without a PDO is a finding. Nodes with [`unused_pdos`](crate::Node::unused_pdos) get a request to disable
/// each valid PDO that no link and no key uses.
pub(crate) fn connect(network: &mut Network, findings: &mut Findings) {
    if network.links.is_empty() && (0..network.nodes.len()).all(|node| network.switches_off(node).is_none()) {
        return;
    }
    let groups = groups::collect(network, findings);
    let compiled = compile(network, DcfgenMode::Corrected);
    let requests = pack::pack(network, &compiled, groups, findings);
    for (node, request) in requests {
        network.nodes[node].pdos.push(request);
    }
    for node in &mut network.nodes {
        node.pdos.sort_by_key(|request| request.pdo.kind);
    }
}

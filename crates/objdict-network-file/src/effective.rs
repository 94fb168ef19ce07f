//! The rules about devices, for the nodes as configured by the network. Errors in a generated DCF are reported where
//! the network file sets the value.

use objdict_lint as lint;
use objdict_model::diagnostic::{At, Diagnostic, Findings, RuleInfo, Severity, SourceLabel};
use objdict_model::model::{Device, Part, Place};
use objdict_network::{Compiled, Network};

/// Warnings about ineffective values that no network rule reports.
const IDLE: [&str; 2] = ["cia301/invalid-sync-start-value", "cia301/rtr-pdo-without-rtr"];

/// Whether a label is about the parameters of a PDO.
fn is_of_pdo(label: &SourceLabel) -> bool {
    match &label.at {
        At::Place(Place { part: Part::Entry(index, _) | Part::Object(index), .. }) => {
            (0x1400..0x1C00).contains(index)
        }
        _ => false,
    }
}

/// Reports problems in values that the network file sets.
pub(super) fn check(network: &Network, compiled: &Compiled, findings: &mut Findings) {
    let options = lint::Options::default();
    // a rule of a lower severity has errors only about lists and `CompactSubObj`, which do not depend on the network
    let is_wanted = |rule: &RuleInfo| rule.severity == Severity::Error || IDLE.contains(&rule.id);
    let check = |device: &Device, is_asked: &dyn Fn(u16) -> bool| {
        lint::check_some(device, &options, &is_wanted, is_asked)
    };
    let is_reported =
        |finding: &&Diagnostic| finding.severity == Severity::Error || IDLE.contains(&finding.rule.id);
    for slave in compiled.nodes() {
        let node = &network.nodes[slave.node];
        // in a DCF for a different node, values that fit only that node
        let is_of_other = node.device.node_id().is_some_and(|made_for| made_for != slave.node_id);
        let own = is_of_other.then(|| check(&node.device, &|_| true));
        // values that the network file does not write are as in the description, which has its own findings
        let said = slave.said_objects();
        let is_asked = |index| is_of_other || said.contains(&index);
        let found = lint::without_disabled(&slave.device, check(&slave.device, &is_asked));
        // the PDOs of a generated manager mirror PDOs of the nodes, where errors are reported
        let is_made = network.is_made(slave.node);
        let is_own = |finding: &&Diagnostic| !is_made || !finding.labels.iter().any(is_of_pdo);
        for finding in found.iter().filter(is_reported).filter(is_own) {
            let is_new = |own: &Findings| own.iter().all(|known| known.rule.id != finding.rule.id);
            let node_id = node.node_id.filter(|_| own.as_ref().is_some_and(is_new)).map(|node_id| node_id.at);
            if let Some(finding) = slave.found(network, finding, node_id, findings) {
                findings.push(finding);
            }
        }
    }
}

//! From what a network file says to the configuration of its nodes.
//!
//! A format fills `Network` with its statements and their spans (`Said`), and links become requests for PDOs on
//! both sides, so all formats lead to the same findings. A finding that leaves no doubt about the result is
//! `understood`: `--strict-dcfgen` builds in spite of it.

use crate::compile::compile;
use crate::compiled::{Compiled, DcfgenMode};
use crate::configure::Setting;
use crate::connect::connect;
use crate::diagnostic::Findings;
use crate::network::{Manager, Network, Node, Said};
use crate::watch::watch;

/// A network in which all that follows from its file is settled, with the configurations of its nodes. It does not change
/// any more, so both belong together.
#[derive(Clone, Debug, Default)]
pub struct Resolved {
    network: Network,
    compiled: Compiled,
}

impl Resolved {
    /// The network.
    pub const fn network(&self) -> &Network {
        &self.network
    }

    /// The configurations of its nodes, without the errors of dcfgen.
    pub const fn compiled(&self) -> &Compiled {
        &self.compiled
    }
}

/// Settles what follows from a network as its file says it: settings of a described manager, watched nodes, the PDOs of links
/// and the bit rate. What cannot be settled is a finding.
pub fn resolve(mut network: Network, findings: &mut Findings) -> Resolved {
    if let Some(manager) = &network.manager
        && let Some(node) = manager.node
    {
        describe(manager, &mut network.nodes[node]);
    }
    watch(&mut network, findings);
    connect(&mut network, findings);
    network.settle_bit_rate();
    let compiled = compile(&network, DcfgenMode::Corrected);
    Resolved { network, compiled }
}

/// What `bus` and `manager` say, as settings of the described manager.
fn describe(manager: &Manager, node: &mut Node) {
    node.heartbeat.producer = node.heartbeat.producer.or(manager.heartbeat.producer);
    node.time_cob_id = manager.time_cob_id.or(node.time_cob_id);
    let errors = manager.error_behavior.iter();
    node.error_behavior.extend(errors.map(|(sub, value)| (*sub, Said::new(*value, manager.name.at))));
    let Manager { sync_period, sync_window, sync_overflow, .. } = manager;
    let inhibit_time = manager.emcy_inhibit_time;
    let settings = [
        (inhibit_time.into(), manager.name.at, Setting::value(&format!("1015={inhibit_time}"))),
        (
            sync_overflow.value.into(),
            sync_overflow.at,
            Setting::value(&format!("1019={}", sync_overflow.value)),
        ),
        (sync_window.value, sync_window.at, Setting::value(&format!("1007={}", sync_window.value))),
        (sync_period.value, sync_period.at, Setting::sync(&format!("producer,{}us", sync_period.value))),
    ];
    let said = settings.into_iter().filter(|(value, ..)| *value > 0);
    node.implied.extend(said.filter_map(|(_, at, setting)| Some(Said::new(setting.ok()?, at))));
}

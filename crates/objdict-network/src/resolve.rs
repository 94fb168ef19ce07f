//! Resolves a network file to the configuration of its nodes.
//!
//! A format fills `Network` with its statements and their spans (`Said`), and links become requests for PDOs on
//! both sides, so all formats lead to the same findings. A finding with an unambiguous result is `understood`:
//! `--strict-dcfgen` builds despite it.

use crate::compile::{compile, compile_manager};
use crate::compiled::{Compiled, DcfgenMode, Origins, indexes};
use crate::configure::{PdoName, Setting};
use crate::connect::connect;
use crate::diagnostic::Findings;
use crate::lely::{LelyOptions, lely_master, mirrored_numbers};
use crate::manager::with_command;
use crate::model::{Access, Assignment, Device, DeviceKind, PdoKind, Value};
use crate::network::{Manager, Network, Node, Said};
use crate::watch::watch;

/// A network with all values derived from its file, and the configurations of its nodes. Both are consistent because
/// they no longer change.
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

    /// The configurations of its nodes, without the bugs of dcfgen.
    pub const fn compiled(&self) -> &Compiled {
        &self.compiled
    }
}

/// Derives values from the statements of a network: settings of a described manager, watched nodes, the PDOs of links,
/// the bit rate, and the description of a manager that the file does not describe, which `read` reads from the text of
/// its DCF. Unresolvable statements are findings.
pub fn resolve(
    mut network: Network,
    read: impl FnOnce(String) -> Device,
    findings: &mut Findings,
) -> Resolved {
    if let Some(manager) = &network.manager
        && let Some(node) = manager.node
    {
        describe(manager, &mut network.nodes[node]);
    }
    watch(&mut network, findings);
    connect(&mut network, findings);
    network.settle_bit_rate();
    let mut compiled = compile(&network, DcfgenMode::Corrected);
    make_manager(&mut network, &mut compiled, read);
    Resolved { network, compiled }
}

/// Assigns the description of Lely's master to a manager that the file does not describe, with a PDO for each PDO of a
/// node. Findings about its values point to the keys of the manager and to the PDOs of the nodes.
fn make_manager(network: &mut Network, compiled: &mut Compiled, read: impl FnOnce(String) -> Device) {
    if network.manager.as_ref().is_none_or(|manager| manager.node.is_some()) {
        return;
    }
    let Some(master) = lely_master(network, &compiled.slaves, &LelyOptions::default()) else { return };
    let Some(manager) = &mut network.manager else { return };
    manager.node = Some(network.nodes.len());
    manager.is_made = true;
    let mut device = read(master.dcf).expanded().into_owned();
    device.kind = DeviceKind::Node;
    // not expressible in one line for all entries: the history is empty, and like mappings it has a writable
    // number of entries
    for (index, object) in device.objects.iter_mut() {
        match (index, object.subs.get_mut(0)) {
            (0x1003, Some(count)) => {
                (count.access, count.default) = (Some(Access::Rw), Some(Value::Unsigned(0)));
            }
            (0x1600..=0x17FF | 0x1A00..=0x1BFF, Some(count)) => count.access = Some(Access::Rw),
            (0x1F82, _) => *object = with_command(object),
            _ => {}
        }
    }
    // it is as new as the newest description that it depends on
    let dates = network.nodes.iter().filter_map(|node| node.device.file_info.as_ref());
    let newest = dates.filter_map(|info| info.creation_date.zip(info.creation_time)).max();
    let info = device.file_info.get_or_insert_default();
    (info.creation_date, info.creation_time) = newest.unzip();
    info.eds_version = Some("4.0".to_owned());
    // the text states network 1, which contradicts nodes whose DCFs state a different one
    device.commissioning.get_or_insert_default().net_number = None;
    if manager.serial_number != 0 {
        // Lely's master sets it by its own download
        let value = Value::Unsigned(manager.serial_number.into());
        device.assign(&[Assignment { index: 0x1018, sub: 4, value }]);
    }
    let (name, node_id) = (manager.name.clone(), manager.node_id);
    let mut origins = own_origins(manager);
    network.nodes.push(Node { name, node_id, device, ..Node::default() });
    for kind in PdoKind::ALL {
        for (slave, pdo, number) in mirrored_numbers(network, &compiled.slaves, kind) {
            let other = PdoName { kind: kind.other(), number };
            let (communication, mapping) = indexes(other);
            let entries = (1..=6).map(|sub| (communication, sub)).chain([(mapping, 0)]);
            let said = slave.stated(network, pdo).into_iter();
            origins.extend(said.flat_map(|at| entries.clone().map(move |entry| (entry, at))));
        }
    }
    compile_manager(network, compiled);
    if let Some(own) = &mut compiled.manager {
        own.origins.extend(origins);
    }
}

/// The positions of the manager's values in its keys.
fn own_origins(manager: &Manager) -> Origins {
    let sync = Some(manager.sync_period.at);
    let keys = [
        (0x1005, sync),
        (0x1006, sync),
        (0x1007, Some(manager.sync_window.at)),
        (0x1012, manager.time_cob_id.map(|time| time.at)),
        (0x1014, manager.node_id.map(|node_id| node_id.at)),
        (0x1017, manager.heartbeat.producer.map(|time| time.at)),
        (0x1019, Some(manager.sync_overflow.at)),
    ];
    let said = keys.into_iter().filter_map(|(index, at)| Some(((index, 0), at?)));
    let errors = manager.error_behavior.keys().map(|sub| ((0x1029, *sub), manager.name.at));
    said.filter(|(_, at)| !at.is_empty()).chain(errors).collect()
}

/// The content of `bus` and `manager` as settings of the described manager.
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

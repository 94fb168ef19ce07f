//! The manager's expectations while it boots the network.

use super::NetworkCheck;
use crate::compiled::Slave;
use crate::diagnostic::{At, Diagnostic, Severity, say};
use crate::download::Order;
use crate::identity::{self, PLACEHOLDER, answered, number};
use crate::manager::numbers;
use crate::model::Place;
use crate::rules::{
    AMBIGUOUS_IDENTITY, BOOT_TIME, KEPT_ALIVE_WITHOUT_STATE, MISSING_ENTRY, NOTHING_TO_RESTORE,
    WRONG_IDENTITY,
};
use crate::source::Span;
use crate::timing::sdo_bits;

impl NetworkCheck<'_, '_> {
    pub(super) fn identities(&mut self) {
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            let name = &node.name.value;
            let stated = [(3, node.revision_number, "revision"), (4, node.serial_number, "serial")];
            for (sub, request, what) in stated {
                // 0 is not checked (CiA 302-2), and neither is a placeholder
                let is_checked = |request: &crate::Said<u32>| ![0, PLACEHOLDER].contains(&request.value);
                let Some(request) = request.filter(is_checked) else { continue };
                if node.device.entry(0x1018, sub).is_none() {
                    self.unanswered(slave, request.at, sub, what);
                    continue;
                }
                let described = number(&node.device, 0x1018, sub, slave.node_id).unwrap_or(0);
                let described = answered(&node.device, sub, slave.node_id).unwrap_or(described);
                if described != 0 && described != request.value {
                    let message = say!(
                        "the {} number of `{}` is {:X}h, but {:X}h in its description",
                        what,
                        name,
                        request.value,
                        described
                    );
                    let elsewhere =
                        identity::stated(&node.device).into_iter().nth(usize::from(sub) - 1).flatten();
                    let elsewhere = elsewhere.filter(|(number, _)| *number == described);
                    let place = elsewhere.map_or(node.device.value_place(0x1018, sub), |(_, place)| place);
                    let finding = Diagnostic::new(&WRONG_IDENTITY, request.at, message)
                        .label(At::Node(slave.node, place), "the described number");
                    let finding = finding.help("correct the number, or use that device's description");
                    self.findings.push(self.judged(slave, finding, sub, slave.identity[usize::from(sub)]));
                }
            }
            self.ambiguous_identity(slave);
            self.expected_identity(slave);
        }
    }

    /// A finding about an expected number: an error if the manager does not boot the node because its
    /// response differs.
    fn judged(&self, slave: &Slave, finding: Diagnostic, sub: u8, expected: u32) -> Diagnostic {
        let node = &self.network.nodes[slave.node];
        let is_other = match answered(&node.device, sub, slave.node_id) {
            Some(number) => number != expected,
            None => node.device.entry(0x1018, sub).is_none(),
        };
        let is_booted = self.network.manager.is_some() && node.boot.boot;
        if expected != 0 && is_other && is_booted {
            finding.severity(Severity::Error).understood()
        } else {
            finding
        }
    }

    /// Checks 1F55h against 1F56h of the nodes whose software the manager checks (1F81h bit 5).
    pub(super) fn software(&mut self) {
        const CHECKED: u32 = 1 << 5;
        let numbers = numbers(self.compiled);
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            let known = |index| numbers.get(&(index, slave.node_id)).copied().unwrap_or(0);
            if !node.boot.boot || known(0x1F81) & CHECKED == 0 {
                continue;
            }
            let (name, version) = (&node.name.value, node.boot.software_version);
            let at = if version.at.is_empty() { node.name.at } else { version.at };
            let own = number(&node.device, 0x1F56, 1, slave.node_id).filter(|own| *own != 0);
            let place = At::Node(slave.node, node.device.value_place(0x1F56, 1));
            let finding = match (known(0x1F55), own) {
                (0, _) => Diagnostic::new(
                    &WRONG_IDENTITY,
                    at,
                    say!("the manager checks the software of `{}`, but 1F55h has no expected version", name),
                )
                .help("specify the version with `software-version` (1F55h of the manager)"),
                (_, None) if node.device.entry(0x1F56, 1).is_none() => {
                    let message =
                        say!("`{}` has no 1F56h:01, so the manager cannot check its software", name);
                    Diagnostic::new(&MISSING_ENTRY, at, message)
                        .help("remove the key, or complete the description")
                }
                (expected, Some(own)) if own != expected => {
                    let message = say!(
                        "the manager expects the software {:X}h of `{}`, but 1F56h:01 has {:X}h",
                        expected,
                        name,
                        own
                    );
                    let finding =
                        Diagnostic::new(&WRONG_IDENTITY, at, message).label(place, "the described number");
                    finding.help("correct the number, or use that device's description")
                }
                _ => continue,
            };
            self.findings.push(finding.severity(Severity::Error).understood());
        }
    }

    /// A number that the network file states and the node does not have.
    fn unanswered(&mut self, slave: &Slave, at: Span, sub: u8, what: &'static str) {
        let node = &self.network.nodes[slave.node];
        let name = &node.name.value;
        let message =
            say!("`{}` has no 1018h:{:02X}, so the manager does not check its {} number", name, sub, what);
        let finding = Diagnostic::new(&MISSING_ENTRY, at, message).severity(Severity::Warning);
        let place = node.device.object(0x1018).map(|_| At::Node(slave.node, Place::object(0x1018)));
        self.findings.push(finding.label_each(place, "the object").help("remove the key"));
    }

    /// Nodes without 1000h, which the manager reads first (CiA 302-2).
    pub(super) fn without_device_type(&mut self) {
        let manager = self.network.manager.as_ref();
        for slave in self.compiled.slaves.iter().filter(|_| manager.is_some()) {
            let node = &self.network.nodes[slave.node];
            if !node.boot.boot || node.device.entry(0x1000, 0).is_some() {
                continue;
            }
            let message = say!("`{}` has no 1000h, so the manager does not boot it", node.name.value);
            let finding = Diagnostic::new(&MISSING_ENTRY, node.file.at, message).understood();
            self.findings.push(finding.help("complete the description, or write `boot = false`"));
        }
    }

    /// Numbers for which a description has two values, one of which the manager checks.
    fn ambiguous_identity(&mut self, slave: &Slave) {
        let node = &self.network.nodes[slave.node];
        if self.network.manager.is_none() || !node.boot.boot || self.network.is_as_described {
            return;
        }
        let numbers = ["vendor-ID", "product code", "revision number"];
        for ((position, what), stated) in (1..).zip(numbers).zip(identity::stated(&node.device)) {
            let Some((stated, place)) = stated else { continue };
            let Some((present, other)) = identity::present(&node.device, position, slave.node_id) else {
                continue;
            };
            // 0 is not checked, and neither are numbers that the network file excludes
            let expected = slave.identity[usize::from(position)];
            let is_settled = position == 3 && node.revision_number.is_some();
            let is_checked = expected != 0 && [stated, present].contains(&expected) && !is_settled;
            if !is_checked || [0, PLACEHOLDER].contains(&stated) || present == 0 || present == stated {
                continue;
            }
            let name = &node.name.value;
            let message = match expected == stated {
                true => say!(
                    "the manager expects the {} {:X}h of `{}`, but 1018h:{:02X} has {:X}h",
                    what,
                    stated,
                    name,
                    position,
                    present
                ),
                false => say!(
                    "the manager expects the {} {:X}h of `{}` (1018h:{:02X}), but `DeviceInfo` has {:X}h",
                    what,
                    present,
                    name,
                    position,
                    stated
                ),
            };
            let finding = Diagnostic::new(&AMBIGUOUS_IDENTITY, node.file.at, message)
                .label(At::Node(slave.node, place), "the number in `DeviceInfo`")
                .label(At::Node(slave.node, other), "the number in 1018h");
            let finding = self.judged(slave, finding, position, expected);
            self.findings.push(finding.help(match (position, self.network.order) {
                (3, Order::Dcfgen) => "specify the correct number: `revision_number`",
                (_, Order::Dcfgen) => "correct the description",
                (3, Order::Safe) => {
                    "specify the correct number with `revision-number`, or check less with `identity = \"product\"`"
                }
                (_, Order::Safe) => "correct the description, or check less, for example with `identity = \"none\"`",
            }));
        }
    }

    /// The objects of a described manager against the node.
    fn expected_identity(&mut self, slave: &Slave) {
        let Some(manager) = &self.compiled.manager else { return };
        let node = &self.network.nodes[slave.node];
        let described = identity::described(&node.device, slave.node_id, self.network.order)
            .into_iter()
            .zip(slave.identity);
        let identity = (0x1F84..).zip(described).map(|(index, ((number, place), is))| {
            // the network file may state a different one
            (index, is, (number == is).then_some(At::Node(slave.node, place)))
        });
        let emcy = slave.emcy.map(|emcy| (0x1028, emcy, slave.origin(self.network, 0x1014, 0)));
        for (index, is, origin) in identity.chain(emcy) {
            let Some(wanted) = number(&manager.device, index, slave.node_id, slave.node_id) else { continue };
            let is_off = wanted == 0 || index == 0x1028 && wanted >> 31 != 0;
            // a device type of 0 is valid
            let is_stated = match index {
                0x1F84 => node.device.value(0x1000, 0).is_some(),
                // a node does not return missing entries
                0x1F85..=0x1F88 => is != 0 || node.device.entry(0x1018, (index - 0x1F84) as u8).is_none(),
                _ => is != 0,
            };
            let said = manager.said(index, slave.node_id);
            // a setting in addition to a number from the node is a contradiction
            let is_reported = said.is_some() && is != 0;
            if !is_off && !is_reported && is_stated && wanted != is {
                let message = say!(
                    "{:04X}h of the manager expects {:X}h of `{}`, which has {:X}h",
                    index,
                    wanted,
                    node.name.value,
                    is
                );
                let finding = Diagnostic::new(&WRONG_IDENTITY, said.unwrap_or(node.name.at), message)
                    .label_each(manager.origin(self.network, index, slave.node_id), "the expected number")
                    .label_each(origin, "the described number")
                    .help("correct the manager's value, or use that device's description");
                // the revision may differ from the description's
                let is_other_device = (0x1F84..=0x1F86).contains(&index);
                self.findings.push(match (index, is_other_device) {
                    (_, true) => finding.severity(Severity::Error).understood(),
                    (0x1F87 | 0x1F88, _) => self.judged(slave, finding, (index - 0x1F84) as u8, wanted),
                    _ => finding,
                });
            }
        }
    }

    /// Nodes that must not be reset while they are operational, but do not report whether they are.
    pub(super) fn kept_alive(&mut self) {
        let Some(manager) = &self.network.manager else { return };
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            if !node.boot.boot || node.boot.reset_communication {
                continue;
            }
            // before its configuration, the node has the defaults, or the values in its DCF
            let is_stored = self.network.order == Order::Dcfgen || self.network.is_as_described;
            let own = node.device.object(0x1017).and_then(|object| {
                let entry = object.entry(0)?;
                let value = if is_stored { entry.value() } else { entry.default.as_ref() };
                value?.integer_for(slave.node_id)
            });
            // the manager polls a node whose heartbeat it does not expect
            let is_expected = slave.heartbeat != 0 && manager.monitors_nodes();
            let is_asked = !is_expected && node.device.object(0x100C).is_some();
            if own.is_some_and(|time| time != 0) || is_asked {
                continue;
            }
            let name = &node.name.value;
            let message = match is_expected {
                false => say!("`{}` must not be reset, but has neither a heartbeat nor node guarding", name),
                true => say!("`{}` must not be reset, but has no heartbeat before it is configured", name),
            };
            let place = At::Node(slave.node, node.device.value_place(0x1017, 0));
            let place = own.map(|_| place);
            let finding = Diagnostic::new(&KEPT_ALIVE_WITHOUT_STATE, node.name.at, message)
                .label_each(place, "the heartbeat time of the node when it is switched on");
            let help = match is_expected {
                true => "let the manager reset the node, or use a DCF with its stored heartbeat time",
                false => "let the manager reset the node",
            };
            self.findings.push(finding.help(help).understood());
        }
    }

    /// 1F8Ah against 1011h of the nodes.
    pub(super) fn restored(&mut self) {
        if self.network.manager.is_none() {
            return;
        }
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            let restored = node.boot.restore_configuration;
            let is_there = || node.device.entry(0x1011, restored.value).is_some();
            if !node.boot.boot || restored.value == 0 || is_there() {
                continue;
            }
            let (name, sub) = (&node.name.value, restored.value);
            let (message, help) = match node.device.object(0x1011) {
                None => {
                    (say!("`{}` has no 1011h, so it cannot restore its defaults", name), "remove the key")
                }
                Some(_) => {
                    (say!("`{}` has no 1011h:{:02X}", name, sub), "name a sub-index that the node has")
                }
            };
            let place = node.device.object(0x1011).map(|_| At::Node(slave.node, Place::object(0x1011)));
            let at = if restored.at.is_empty() { node.name.at } else { restored.at };
            let finding = Diagnostic::new(&NOTHING_TO_RESTORE, at, message);
            self.findings
                .push(finding.label_each(place, "the sub-indexes of the node").help(help).understood());
        }
    }

    pub(super) fn boot_time(&mut self) {
        let Some(manager) = self.network.manager.as_ref().filter(|manager| manager.boot_time.value != 0)
        else {
            return;
        };
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            if !node.boot.mandatory {
                continue;
            }
            let downloads = slave.arranged_or_stated();
            let bits: u64 = downloads.0.iter().map(|download| sdo_bits(download.data.len())).sum();
            let milliseconds = bits.div_ceil(self.bit_rate().into());
            if milliseconds > manager.boot_time.value.into() {
                let message = say!(
                    "the configuration of `{}` takes at least {} ms, but the boot time is {} ms",
                    node.name.value,
                    milliseconds,
                    manager.boot_time.value
                );
                let finding = Diagnostic::new(&BOOT_TIME, manager.boot_time.at, message)
                    .label(node.name.at, "the node");
                self.findings.push(finding.help("lengthen the boot time"));
            }
        }
    }
}

//! What the manager expects while it boots the network.

use super::Check;
use super::timing::sdo_bits;
use crate::diagnostic::{Diagnostic, say};
use crate::model::Device;
use crate::rules::{BOOT_TIME, WRONG_IDENTITY};
use crate::source::Span;

impl Check<'_, '_> {
    pub(super) fn identities(&mut self) {
        for slave in &self.compiled.slaves {
            let node = &self.network.nodes[slave.node];
            let name = &node.name.value;
            let stated = [(3, node.revision_number, "revision"), (4, node.serial_number, "serial")];
            for (sub, wish, what) in stated {
                let Some(wish) = wish else { continue };
                let described = number(&node.device, 0x1018, sub, slave.node_id).unwrap_or(0);
                if described != 0 && described != wish.value {
                    let message = say!(
                        "the {} number of `{}` is {:X}h, but its description says {:X}h",
                        what,
                        name,
                        wish.value,
                        described
                    );
                    let finding = Diagnostic::new(&WRONG_IDENTITY, wish.at, message);
                    self.findings
                        .push(finding.help("correct the number, or use the description of that device"));
                }
            }
            let Some(manager) = self.compiled.manager.as_ref().map(|manager| &manager.device) else {
                continue;
            };
            let expected = (0x1F84..).zip(slave.identity);
            for (index, is) in expected.chain(slave.emcy.map(|emcy| (0x1028, emcy))) {
                let Some(wanted) = number(manager, index, slave.node_id, slave.node_id) else { continue };
                let is_off = wanted == 0 || index == 0x1028 && wanted >> 31 != 0;
                if !is_off && is != 0 && wanted != is {
                    let message = say!(
                        "{:04X}h of the manager expects {:X}h of `{}`, which has {:X}h",
                        index,
                        wanted,
                        name,
                        is
                    );
                    let at: Span = node.name.at;
                    let finding = Diagnostic::new(&WRONG_IDENTITY, at, message);
                    self.findings.push(finding.help("correct the value in the description of the manager"));
                }
            }
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
            let bits: u64 = slave.downloads.0.iter().map(|download| sdo_bits(download.data.len())).sum();
            let milliseconds = bits.div_ceil(self.bit_rate());
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

/// The number in an entry after the configuration.
fn number(device: &Device, index: u16, sub: u8, node_id: u8) -> Option<u32> {
    let number = device.object(index)?.value(sub)?.integer_for(node_id)?;
    u32::try_from(number).ok()
}

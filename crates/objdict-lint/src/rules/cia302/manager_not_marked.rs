use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::model::{Field, Part, Place};
use crate::{Facts, rule};

rule! {
    "cia302/manager-not-marked", Note, Applied(check), fix Unsafe;
    summary: "the device has objects of a network manager but is not marked as one",
    checks: "Whether a device with lists of nodes (1F20h, 1F22h, 1F23h, 1F25h, 1F81h to 1F88h) has `SimpleBootUpMaster=0`.",
    why: "A tool that searches for the network manager ignores the device.",
    example: "`[1F81]` with `SimpleBootUpMaster=0`",
    remedy: "Write `SimpleBootUpMaster=1` if the device can boot a network.",
    source: "CiA 306-1 §4.4; CiA 302-2",
}

/// Lists that only a device needs that boots or configures other nodes.
const LISTS: [u16; 12] =
    [0x1F20, 0x1F22, 0x1F23, 0x1F25, 0x1F81, 0x1F82, 0x1F83, 0x1F84, 0x1F85, 0x1F86, 0x1F87, 0x1F88];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, _: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let marked = device.device_info.as_ref().and_then(|info| info.simple_boot_up_master);
    let list = LISTS.iter().find(|&&index| device.object(index).is_some_and(|object| !object.orphan));
    if let Some(&index) = list.filter(|_| marked == Some(false)) {
        let message = say!("the device has {:04X}h, a list of nodes, but `{SimpleBootUpMaster=0}`", index);
        let place = Place::of(Part::DeviceInfo).field(Field::SimpleBootUpMaster);
        let finding = Diagnostic::new(rule, place.clone(), message);
        let finding = finding.label(Place::object(index), "a list of nodes");
        let finding = finding.help(say!("write `{SimpleBootUpMaster=1}` if the device can boot a network"));
        findings.push(finding.fix(Fix::risky(say!("write `{SimpleBootUpMaster=1}`")).set(place, "1")));
    }
}

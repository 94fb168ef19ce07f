use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::{rule, stated};

rule! {
    "cia306/manager-without-nmt-master", Warning, Device(check);
    summary: "the network manager is not an NMT master",
    checks: "Whether a DCF with `CANopenManager=1` has `SimpleBootUpMaster=1` or 1F80h, NMT startup.",
    why: "The manager starts and monitors the other nodes. Without an NMT master they stay in the state after power-on.",
    example: "`CANopenManager=1`, `SimpleBootUpMaster=0`, and no `[1F80]`",
    remedy: "Write `CANopenManager=0`, or correct `SimpleBootUpMaster`.",
    source: "CiA 306-1 §5.4, CiA 302-2",
}

fn check(device: &Device, findings: &mut Findings) {
    let is_manager = device.commissioning.as_ref().is_some_and(|node| node.manager == Some(true));
    let refuses = device.device_info.as_ref().is_some_and(|info| info.simple_boot_up_master == Some(false));
    if !is_manager || !refuses || stated::is_there(device, 0x1F80) {
        return;
    }
    let place = Place::of(Part::Commissioning).field(Field::CanOpenManager);
    let finding =
        Diagnostic::new(&RULE.info, place, "the node is the network manager, but not an NMT master").label(
            Place::of(Part::DeviceInfo).field(Field::SimpleBootUpMaster),
            "not an NMT master, and 1F80h is missing",
        );
    findings.push(finding.help(say!("write `{CANopenManager=0}`, or correct `{SimpleBootUpMaster}`")));
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::{rule, stated};

rule! {
    "cia306/manager-that-is-no-master", Warning, Device(check);
    summary: "the manager of the network is no master",
    checks: "Whether a DCF with `CANopenManager=1` is of a device with `SimpleBootUpMaster=1` or with 1F80h, NMT startup.",
    why: "The manager starts and watches the other nodes. A device that cannot be the NMT master leaves them where they are after power-on.",
    example: "`CANopenManager=1`, `SimpleBootUpMaster=0`, and no `[1F80]`",
    remedy: "Write `CANopenManager=0`, or what the device supports.",
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
        Diagnostic::new(&RULE.info, place, "the node manages the network, and cannot be its master").label(
            Place::of(Part::DeviceInfo).field(Field::SimpleBootUpMaster),
            "says so, and there is no 1F80h",
        );
    findings.push(finding.help(say!("write `{CANopenManager=0}`, or what the device supports")));
}

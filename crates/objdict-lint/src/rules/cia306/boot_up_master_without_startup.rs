use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Field, Part, Place};
use crate::{rule, stated};

rule! {
    "cia306/boot-up-master-without-startup", Note, Device(check);
    summary: "a boot-up master lacks 1F80h, NMT startup",
    checks: "Whether a device with `SimpleBootUpMaster=1` has 1F80h, NMT startup.",
    why: "A configuration tool uses 1F80h to make the device the NMT master. Without 1F80h, a tool can neither configure how the device starts the network nor turn the master off.",
    example: "`SimpleBootUpMaster=1` without `[1F80]`",
    remedy: "Add 1F80h, an UNSIGNED32, or write `SimpleBootUpMaster=0`.",
    source: "CiA 306-1 §4.5, CiA 302-2",
}

fn check(device: &Device, findings: &mut Findings) {
    let is_master = device.device_info.as_ref().is_some_and(|info| info.simple_boot_up_master == Some(true));
    if !is_master || stated::is_there(device, 0x1F80) {
        return;
    }
    let place = Place::of(Part::DeviceInfo).field(Field::SimpleBootUpMaster);
    let message = "the device is a boot-up master, but 1F80h (NMT startup) is missing";
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(finding.help("add 1F80h (NMT startup, UNSIGNED32), or write 0"));
}

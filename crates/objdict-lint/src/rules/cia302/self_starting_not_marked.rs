use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::model::{Field, Part, Place};
use crate::rule;

rule! {
    "cia302/self-starting-not-marked", Note, Against(check), fix Unsafe;
    summary: "the device starts by itself but is not marked as a simple boot-up slave",
    checks: "Whether a device that enters operational without a master (bits 0 and 2 of 1F80h are clear) has `SimpleBootUpSlave=0`.",
    why: "A master that relies on the description configures the node while it already transmits. Some drives have 0 in 1F80h and still wait for their master, so it is a note.",
    example: "`[1F80]` with `DefaultValue=0x00000000`, and `SimpleBootUpSlave=0`",
    remedy: "Write `SimpleBootUpSlave=1`, or set bit 2 of 1F80h if the device waits for its master.",
    source: "CiA 302-2 (1F80h); CiA 306-1 §4.4",
}

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let value = at.object.value(0).filter(|_| at.index == 0x1F80 && at.has_its_shape());
    let starts = value.and_then(|value| value.as_integer()).is_some_and(|value| value & 0b101 == 0);
    let marked = at.device.device_info.as_ref().and_then(|info| info.simple_boot_up_slave);
    if starts && marked == Some(false) {
        let message = say!("1F80h makes the device enter operational by itself, but `{SimpleBootUpSlave=0}`");
        let place = Place::of(Part::DeviceInfo).field(Field::SimpleBootUpSlave);
        let finding = Diagnostic::new(rule, place.clone(), message);
        let finding = finding.label(at.device.value_place(at.index, 0), "bit 2 is clear");
        let fix = Fix::risky(say!("write `{SimpleBootUpSlave=1}`")).set(place, "1");
        findings.push(finding.help(say!("write `{SimpleBootUpSlave=1}`")).fix(fix));
    }
}

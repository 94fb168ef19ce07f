use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Object, Part, Place};
use crate::{Facts, rule};

rule! {
    "cia306/group-messaging-flag", Warning, Facts(check);
    summary: "`GroupMessaging` and the PDOs disagree",
    checks: "Whether a device with multiplexed PDOs, whose mapping counts 254 or 255, or with the lists that belong to them (1FA0h to 1FFFh), says `GroupMessaging=1`, and whether one that says it has such a list, such a PDO, or a mapping that can be made one.",
    why: "Tools offer multiplexed PDOs for devices with the flag only, and configure them where nothing is there to configure.",
    example: "`[1A00sub0]` with `DefaultValue=255` and `GroupMessaging=0`",
    remedy: "Write what the device supports.",
    source: "CiA 306-1 §4.5, CiA 301 §7.5.2.36",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let Some(flag) = device.device_info.as_ref().and_then(|info| info.group_messaging) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::GroupMessaging);
    let multiplexed = facts.pdos.iter().map(|facts| &facts.pdo).find(|pdo| pdo.is_multiplexed());
    let list = device.objects.range(0x1FA0..=0x1FFF).next();
    let finding = match (flag, multiplexed, list) {
        (false, Some(pdo), _) => {
            let finding = Diagnostic::new(
                &RULE.info,
                place,
                say!("{} is a multiplexed PDO, and the flag denies them", pdo),
            );
            finding.label(device.value_place(pdo.mapping_index(), 0), "makes it one")
        }
        (false, None, Some((&index, _))) => {
            let message = say!("{:04X}h is for multiplexed PDOs, and the flag denies them", index);
            Diagnostic::new(&RULE.info, place, message).label(Place::object(index), "the list")
        }
        (true, None, None) if !can_be_made(facts) => Diagnostic::new(
            &RULE.info,
            place,
            "no PDO of the device is a multiplexed one, or can be made one",
        ),
        _ => return,
    };
    findings.push(finding.help("write what the device supports"));
}

/// Whether a PDO is there, or implied, whose number of mapped objects can be written.
fn can_be_made(facts: &Facts<'_>) -> bool {
    let writable = |object: &Object| {
        object.subs.get(0).is_some_and(|entry| entry.access.is_none_or(Access::is_writable))
    };
    let is_implied =
        facts.device.device_info.as_ref().is_some_and(|info| info.compact_pdo.is_some_and(|mask| mask != 0));
    is_implied || facts.pdos.iter().filter_map(|facts| facts.pdo.mapping).any(writable)
}

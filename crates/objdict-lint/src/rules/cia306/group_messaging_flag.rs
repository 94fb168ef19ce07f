use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::model::{Access, Field, Object, Part, Place};
use crate::{Facts, rule};

rule! {
    "cia306/group-messaging-flag", Warning, Facts(check);
    summary: "`GroupMessaging` and the PDOs disagree",
    checks: "Whether a device with multiplexed PDOs (mapping count 254 or 255) or with their lists (1FA0h to 1FFFh) has `GroupMessaging=1`, and whether a device with `GroupMessaging=1` has such a list or such a PDO. A device with a writable mapping, which can make a PDO multiplexed, is a note.",
    why: "Tools offer multiplexed PDOs only for devices with the flag. With a wrong flag they configure PDOs that the device does not support.",
    example: "`[1A00sub0]` with `DefaultValue=255` and `GroupMessaging=0`",
    remedy: "Correct the flag.",
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
                say!("{} is a multiplexed PDO, but `{GroupMessaging}` is {GroupMessaging:0}", pdo),
            );
            finding.label(device.value_place(pdo.mapping_index(), 0), "multiplexed by this value")
        }
        (false, None, Some((&index, _))) => {
            let message =
                say!("{:04X}h is for multiplexed PDOs, but `{GroupMessaging}` is {GroupMessaging:0}", index);
            Diagnostic::new(&RULE.info, place, message).label(Place::object(index), "the list")
        }
        (true, None, None) if can_be_made(facts) => {
            let message =
                say!("`{GroupMessaging}` is {GroupMessaging:1}, but no PDO is multiplexed by default");
            Diagnostic::new(&RULE.info, place, message).severity(Severity::Note)
        }
        (true, None, None) => Diagnostic::new(
            &RULE.info,
            place,
            "the device has no multiplexed PDO and no PDO that can become one",
        ),
        _ => return,
    };
    findings.push(finding.help("correct the flag"));
}

/// Whether the device has or implies a PDO with a writable number of mapped objects.
fn can_be_made(facts: &Facts<'_>) -> bool {
    let writable = |object: &Object| {
        object.subs.get(0).is_some_and(|entry| entry.access.is_none_or(Access::is_writable))
    };
    let is_implied =
        facts.device.device_info.as_ref().is_some_and(|info| info.compact_pdo.is_some_and(|mask| mask != 0));
    is_implied || facts.pdos.iter().filter_map(|facts| facts.pdo.mapping).any(writable)
}

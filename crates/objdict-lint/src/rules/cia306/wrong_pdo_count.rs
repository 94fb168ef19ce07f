use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, say};
use crate::model::{Device, DeviceInfo, Field, Part, Place};
use crate::{canopennode, rule};

rule! {
    "cia306/wrong-pdo-count", Error, Device(check), fix Mixed;
    summary: "`NrOfRXPDO` or `NrOfTXPDO` does not match the described PDOs",
    checks: "Whether `NrOfRXPDO` is the number of objects 1400h to 15FFh and `NrOfTXPDO` the number of objects 1800h to 19FFh. With `CompactPDO` the number may be higher: the other PDOs are implied. Objects that are marked as disabled (`CO_disabled`) do not count.",
    why: "Configuration tools offer the given number of PDOs. PDOs above it are never configured, and writing missing ones fails.",
    example: "`NrOfRXPDO=2` where only 1400h is described",
    remedy: "Write the number of communication parameter objects, or describe the missing ones.",
    source: "CiA 306-1 §4.5, §4.6.3.4.1",
}

/// The PDOs of one direction: their name, the field of their number, and the range of their communication
/// records.
struct Pdos {
    name: &'static str,
    field: Field,
    low: u16,
    high: u16,
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    if let Some(stated) = info.rpdo_count {
        let rpdos = Pdos { name: "RPDO", field: Field::NrOfRxPdo, low: 0x1400, high: 0x15FF };
        check_count(device, info, &rpdos, usize::from(stated), findings);
    }
    if let Some(stated) = info.tpdo_count {
        let tpdos = Pdos { name: "TPDO", field: Field::NrOfTxPdo, low: 0x1800, high: 0x19FF };
        check_count(device, info, &tpdos, usize::from(stated), findings);
    }
}

fn check_count(device: &Device, info: &DeviceInfo, pdos: &Pdos, stated: usize, findings: &mut Findings) {
    let Pdos { name, field, low, high } = pdos;
    let described = device.objects.range(low..=high);
    let described =
        described.filter(|(_, object)| !object.orphan && !canopennode::is_disabled(object)).count();
    let compact = info.compact_pdo.is_some_and(|mask| mask != 0)
        || info.invalid_values.get(&Field::CompactPdo).is_some();
    if stated == described || compact && stated > described {
        return;
    }
    let count = match described {
        0 => say!("no {} is", name),
        1 => say!("1 {} is", name),
        _ => say!("{} {}s are", described, name),
    };
    let message = say!("`{}` is {}, but {} described ({:04X}h to {:04X}h)", field, stated, count, low, high);
    let place = Place::of(Part::DeviceInfo).field(field.clone());
    let title = say!("write `{}`", Argument::setting(field, described));
    // a number above it is what is left of PDOs that are missing
    let fix = if stated > described { Fix::risky(title.clone()) } else { Fix::safe(title.clone()) };
    let fix = fix.set(place.clone(), described.to_string());
    let finding = Diagnostic::new(&RULE.info, place, message).fix(fix);
    findings.push(if stated > described {
        finding.help(say!("{}, or describe the missing {}s", title, name))
    } else {
        finding.help(title)
    });
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Device, Field, PdoKind, Place};
use crate::rule;

rule! {
    "cia301/mappable-without-pdo", Warning, Device(check);
    summary: "entries are mappable, but the device has no PDO in their direction",
    checks: "Whether a device with PDOs has a TPDO for its entries with `PDOMapping=1` and access `ro` or `rwr`, and an RPDO for those with `wo` or `rww`, described or implied by `CompactPDO`. Modular devices and objects below 2000h are not checked.",
    why: "Tools offer the entries for mapping, but there is no PDO for them. Often PDOs are missing in the description.",
    example: "`AccessType=rww` and `PDOMapping=1` in `[2000]` of a device with only TPDOs",
    remedy: "Describe the PDOs, or write `PDOMapping=0`.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",
}

fn check(device: &Device, findings: &mut Findings) {
    let [rpdo, tpdo] = PdoKind::ALL.map(|kind| has_pdo(device, kind));
    let (missing, fits): (PdoKind, fn(Access) -> bool) = match (rpdo, tpdo) {
        (true, false) => (PdoKind::Tpdo, |access| access.fits_tpdo() && !access.fits_rpdo()),
        (false, true) => (PdoKind::Rpdo, |access| access.fits_rpdo() && !access.fits_tpdo()),
        _ => return,
    };
    if device.is_modular() || device.dynamic_channels.is_some() {
        return;
    }
    let mut entries = device.objects.range(0x2000..).flat_map(|(&index, object)| {
        let place = move |sub: Option<u8>| sub.map_or(Place::object(index), |sub| Place::entry(index, sub));
        object.described().map(move |(sub, entry)| (place(sub), entry))
    });
    let found = entries.find(|(_, entry)| {
        let has_length = entry.data_type.is_some_and(|data_type| data_type.bit_length().is_some());
        entry.is_mappable() && has_length && entry.access.is_some_and(fits)
    });
    let Some((place, _)) = found else { return };
    let message = say!("the entry is mappable to {}s, but the device has none", missing);
    let finding = Diagnostic::new(&RULE.info, place.field(Field::PdoMapping), message);
    findings.push(finding.help(say!("describe the PDOs, or write `{PDOMapping=0}`")));
}

fn has_pdo(device: &Device, kind: PdoKind) -> bool {
    let info = device.device_info.as_ref();
    let declared = info.and_then(|info| match kind {
        PdoKind::Rpdo => info.rpdo_count,
        PdoKind::Tpdo => info.tpdo_count,
    });
    // another rule reports a count without objects
    declared.is_some_and(|count| count > 0) || device.pdos().any(|pdo| pdo.kind == kind)
}

use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{MappedObject, PdoKind};
use crate::{Facts, channels, rule};

rule! {
    "cia401/channels-without-pdo", Warning, Applied(check);
    summary: "channels of an I/O module have no PDO",
    checks: "Whether a module with more than 8 bytes of digital inputs or outputs, or more than 12 words of analogue ones, maps the last of them or has a PDO above PDO 4. Channels of modules of a modular device are not counted.",
    why: "The default PDOs are full, so the remaining channels are accessible by SDO only, which is too slow for process data.",
    example: "`[6000sub0]` with `DefaultValue=12`, and no TPDO above TPDO 4",
    remedy: "Add PDOs from PDO 5 on for the remaining channels, not valid by default.",
    source: "CiA 401, default PDOs; CiA 301 §7.5.2.35 (PDO 5 and above)",
}

/// The number of elements that the default PDOs carry: PDO 1, and PDOs 2 to 4.
const BYTES: u8 = 8;
const WORDS: u8 = 12;
/// The last PDO with a default mapping.
const LAST: u16 = 4;

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let channels = channels::of_device(facts.device).filter(|_| applied.block == 0);
    let Some(channels) = channels else { return };
    let arrays = [
        (PdoKind::Tpdo, 0x6000, channels.digital_inputs, BYTES),
        (PdoKind::Rpdo, 0x6200, channels.digital_outputs, BYTES),
        (PdoKind::Tpdo, 0x6401, channels.analog_inputs, WORDS),
        (PdoKind::Rpdo, 0x6411, channels.analog_outputs, WORDS),
    ];
    for (kind, index, number, room) in arrays.into_iter().filter(|(_, _, number, room)| number > room) {
        let mut pdos = facts.pdos.iter().filter(|pdo| pdo.pdo.kind == kind);
        let carries = |object: MappedObject| (object.index, object.sub) == (index, number);
        if pdos.any(|pdo| pdo.pdo.number > LAST || pdo.mapped.iter().any(|mapped| carries(mapped.object))) {
            continue;
        }
        let kind = kind.name();
        let message = say!(
            "{:04X}h has {} elements, but {}s 1 to 4 have room for only {} of them",
            index,
            number,
            kind,
            room
        );
        let finding = Diagnostic::new(rule, facts.device.value_place(index, 0), message);
        findings.push(finding.help(say!("add {}s from {} 5 on for the remaining elements", kind, kind)));
    }
}

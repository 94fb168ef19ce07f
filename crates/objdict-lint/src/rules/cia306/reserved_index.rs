use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Object, Place};
use crate::rule;

rule! {
    "cia306/reserved-index", Warning, Object(check);
    summary: "an object has a reserved index",
    checks: "Whether an object has index 0000h or is in 0260h to 0FFFh, 101Ah to 101Fh, 102Bh to 11FFh, 1C00h to 1EFFh or C000h to FFFFh.",
    why: "A later version of the standard may define the index, and tools will then misinterpret the device. A conformance test fails.",
    example: "`[C000]`",
    remedy: "Move vendor-specific objects to 2000h to 5FFFh.",
    source: "CiA 301 §7.4.1, tables 41 and 44; CiA 302-2 for 102Ah",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let area = match index {
        0x0260..=0x0FFF => "0260h to 0FFFh",
        0x101A..=0x101F => "101Ah to 101Fh",
        // CiA 302-2 defines 102Ah, the NMT inhibit time
        0x102B..=0x11FF => "102Bh to 11FFh",
        0x1C00..=0x1EFF => "1C00h to 1EFFh",
        0xC000.. => "C000h to FFFFh",
        0 => "0000h",
        _ => return,
    };
    if !object.orphan {
        let message = say!("{:04X}h is in a reserved area ({})", index, area);
        let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
        findings.push(finding.help(match index {
            0x0260..=0x0FFF => "move data types to 0040h to 025Fh",
            _ => "move vendor-specific objects to 2000h to 5FFFh",
        }));
    }
}

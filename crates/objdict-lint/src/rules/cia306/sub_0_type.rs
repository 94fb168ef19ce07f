use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{DataType, Field, ObjectType};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/sub-0-type", Error, Entry(check), fix Unsafe;
    summary: "sub-index 0 is not an UNSIGNED8",
    checks: "Whether sub-index 0 of an ARRAY, RECORD or DEFSTRUCT has the data type UNSIGNED8, except in the obsolete 1004h, where it is a number of PDOs.",
    why: "Sub-index 0 is the highest sub-index, and managers read one byte.",
    example: "`[1A00sub0]` with `DataType=0x0007`",
    remedy: "Write `DataType=0x0005`.",
    source: "CiA 301 §7.4.7.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let (Some(0), Some(expected), Some(data_type)) =
        (at.sub, DataType::of_sub_0(at.index), at.entry.data_type)
    else {
        return;
    };
    if data_type != expected && stated::object_type(at.object).is_some_and(ObjectType::has_subs) {
        let message = say!("sub-index 0 of {:04X}h is {}, not UNSIGNED8", at.index, data_type);
        let finding = Diagnostic::new(&RULE.info, at.field(Field::DataType), message);
        let fix = Fix::risky(say!("write `{DataType=0x0005}`")).set(at.field(Field::DataType), "0x0005");
        findings.push(finding.help(say!("write `{DataType=0x0005}`")).fix(fix));
    }
}

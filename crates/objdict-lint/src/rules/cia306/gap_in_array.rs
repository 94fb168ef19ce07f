use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Device, Object, ObjectType, Place};
use crate::rule;

rule! {
    "cia306/gap-in-array", Note, Object(check);
    summary: "the sub-indexes of an ARRAY have a gap",
    checks: "Whether the described sub-indexes of each ARRAY from 2000h to 5FFFh are consecutive, except FFh. Other ranges are not checked: the standards define objects with gaps.",
    why: "A gap is allowed, but programs iterate over an ARRAY from 1 to sub-index 0 and get an abort at the gap, and generated code has unused elements. Sometimes sub-indexes were written in decimal: `[2000sub10]` is the sixteenth.",
    example: "`[2000sub1]` and `[2000sub3]`, and no `[2000sub2]`",
    remedy: "Describe the missing elements, or change the object to a RECORD.",
    source: "CiA 306-1 §4.6.3.2, CiA 301 §7.4.3",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let is_array = object.main.object_type == Some(ObjectType::Array) && object.compact.is_none();
    if !(0x2000..0x6000).contains(&index) || !is_array || object.orphan {
        return;
    }
    let mut subs = object.subs.iter().map(|(sub, _)| sub).filter(|&sub| sub != 0xFF);
    let Some(mut last) = subs.next() else { return };
    for sub in subs {
        if sub != last + 1 {
            let message =
                say!("{:04X}h has sub-index {} directly after {}", index, sub_index(sub), sub_index(last));
            let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub), message);
            findings.push(finding.help("describe the missing elements, or change the object to a RECORD"));
            return;
        }
        last = sub;
    }
}

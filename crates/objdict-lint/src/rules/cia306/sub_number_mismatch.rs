use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, counted, say};
use crate::model::{Device, Field, Object, ObjectType, Place};
use crate::{rule, stated};

rule! {
    "cia306/sub-number-mismatch", Error, Object(check), fix Mixed,
        explains Object [
            "wrong-highest-sub-index", "gap-in-mapping", "gap-in-array", "missing-sub-index", "wrong-mapping-count",
            "incomplete-pdo-parameter", "incomplete-sdo-parameter"
        ];
    summary: "`SubNumber` does not match the described sub-indexes",
    checks: "Whether `SubNumber` of an ARRAY, RECORD or DEFSTRUCT equals the number of its sections, including sub-index 0, excluding sub-index FFh. Gaps are legal: `SubNumber` is not the highest sub-index plus one.",
    why: "Readers that count do not see the last sub-indexes, or look for missing ones.",
    example: "`SubNumber=3` where sub-indexes 0 to 3 are described",
    remedy: "Write the number of sections.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(stated) = object.sub_number.map(usize::from) else { return };
    let described = stated::described_subs(object);
    if stated == described || object.compact.is_some() {
        return;
    }
    // another rule reports a sub-index 0 that is counted but missing
    let only_sub_0_missing = described > 0 && stated == described + 1 && object.subs.get(0).is_none();
    if only_sub_0_missing || !stated::object_type(object).is_some_and(ObjectType::has_subs) {
        return;
    }
    let described_text = match described {
        0 => "no sub-index is".to_owned(),
        _ => counted(described, "sub-index is", "sub-indexes are"),
    };
    let message = say!("`{SubNumber}` is {}, but {} described", stated, described_text);
    let finding = Diagnostic::new(&RULE.info, Place::object(index).field(Field::SubNumber), message);
    findings.push(if described == 0 {
        finding.help(say!("describe the sub-indexes, or correct `{ObjectType}`"))
    } else {
        let title = say!("write `{}`", Argument::setting(Field::SubNumber, described));
        let place = Place::object(index).field(Field::SubNumber);
        // if sub-index 0 agrees with `SubNumber`, a section is missing
        let value = object.value(0).and_then(|value| value.as_integer());
        let is_lost = stated > described && value == i128::try_from(stated).ok().map(|stated| stated - 1);
        let fix = if is_lost { Fix::risky(title.clone()) } else { Fix::safe(title.clone()) };
        finding.fix(fix.set(place, described.to_string())).help(if stated > described {
            say!("describe the others, or {}", title)
        } else {
            title
        })
    });
}

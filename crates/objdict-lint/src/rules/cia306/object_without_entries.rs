use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{ObjectType, Place};
use crate::{Facts, demands, rule, stated};

rule! {
    "cia306/object-without-entries", Warning, Facts(check);
    summary: "an ARRAY or RECORD has no entry besides sub-index 0",
    checks: "Whether each ARRAY and RECORD without `CompactSubObj` describes a further sub-index. PDO mappings, objects of modular devices, and objects whose sub-index 0 counts more entries are not checked; missing sub-indexes that a document requires have their own rules.",
    why: "The object holds no data. The descriptions of its entries were probably lost.",
    example: "`[2000]` with `ObjectType=0x8` and `SubNumber=1`, and only `[2000sub0]`",
    remedy: "Describe the entries, or remove the object.",
    source: "CiA 301 §7.4.3; CiA 306-1 §4.6.3.2",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    if device.is_modular() {
        return;
    }
    for (&index, object) in &device.objects {
        let is_list = matches!(stated::object_type(object), Some(ObjectType::Array | ObjectType::Record));
        let has_only_sub_0 = object.subs.len() == 1 && object.subs.get(0).is_some();
        let counts_none = object.value(0).is_none_or(|count| count.as_integer() == Some(0));
        let is_checked = is_list && has_only_sub_0 && counts_none && object.compact.is_none();
        if !is_checked || stated::counts_otherwise(index) || demands_entries(facts, index) {
            continue;
        }
        let message = say!("{:04X}h has no entry besides sub-index 0", index);
        let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
        findings.push(finding.help("describe the entries, or remove the object"));
    }
}

/// Whether a document requires an entry, which another rule reports.
fn demands_entries(facts: &Facts<'_>, index: u16) -> bool {
    demands::applied(facts.device, facts.options).iter().any(|applied| {
        let object = applied.profile.object_in(applied.block, index);
        object.is_some_and(|object| object.entries().any(|entry| entry.first > 0 && entry.is_mandatory()))
    })
}

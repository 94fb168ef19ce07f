use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, rule};

rule! {
    "portability/unused-mapping-slot", Warning, Pdo(check);
    summary: "a fixed PDO mapping has entries that it does not use",
    checks: "Whether the default of sub-index 0 of each mapping is its highest sub-index, if `Granularity=0` says that the mapping cannot be changed.",
    why: "CANchkEDS warns because the entries can never be used.",
    example: "`Granularity=0`, `[1A00sub0]` with `DefaultValue=1`, and `[1A00sub2]`",
    remedy: "Remove the unused entries, or write the granularity of a mapping that can be changed.",
    source: "CANchkEDS 4.0",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity);
    let index = pdo.pdo.mapping_index();
    let highest = facts.device.object(index).and_then(crate::model::Object::highest_sub);
    let (Some(0), Some(count), Some(highest)) = (granularity, pdo.pdo.mapped_count, highest) else { return };
    if count < highest {
        let message = say!("{:04X}h has {} entries, but {} maps only `{}`", index, highest, pdo.pdo, count);
        let finding = Diagnostic::new(&RULE.info, facts.device.value_place(index, 0), message);
        findings.push(finding.help("remove the unused entries, or write another `Granularity`"));
    }
}

use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{has_shape_of, rule};
use crate::model::{Device, Object};
use crate::profile::{ObjectFacts, cia301};

rule! {
    /// sub-index 0 of a communication object states an impossible highest sub-index
    ///
    /// ## What it checks
    /// Whether the value of sub-index 0 lies in the range that CiA 301 gives it: 1 to 4 for 1018h, 1 to 127 for 1010h, 1011h, 1016h and 1028h, 2 to 6 for PDO communication parameters, 3 for SDO clients. It is silent where another rule has it: sub-indexes that are missing or too many, or a highest one that is not described. What a PDO mapping states is the matter of another rule.
    ///
    /// ## Why it matters
    /// Managers read sub-index 0 before the others and stop at what it says.
    ///
    /// ## Example
    /// `[1016]` with `[1016sub0]` only, and `DefaultValue=0` there
    ///
    /// ## How to mend
    /// Describe the entries, or leave out an object that has none.
    ///
    /// ## Source
    /// CiA 301 §7.4.7.2, §7.5.2
    "cia301/sub-0-out-of-range", Warning, Object(check)
}

fn check(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(facts) = cia301::object(index).filter(|facts| has_shape_of(object, facts)) else { return };
    let Some((low, high)) = facts.entry(0).and_then(|facts| facts.range) else { return };
    let Some(value) = object.value(0).and_then(|value| value.as_integer()) else { return };
    if (i128::from(low)..=i128::from(high)).contains(&value) || is_reported_elsewhere(object, facts, value) {
        return;
    }
    let message = if low == high {
        format!("`{value}` as highest sub-index of {index:04X}h ({}), which has always {low}", facts.name)
    } else {
        format!(
            "`{value}` as highest sub-index of {index:04X}h ({}), which takes {low} to {high}",
            facts.name
        )
    };
    let finding = Diagnostic::new(&RULE.info, device.value_place(index, 0), message);
    findings.push(finding.help("describe the entries of the object, or leave the object out"));
}

/// Whether another rule has it: the sub-indexes are too many or too few, or others than sub-index 0 says.
fn is_reported_elsewhere(object: &Object, facts: &ObjectFacts, value: i128) -> bool {
    let highest = object.highest_sub().unwrap_or(0);
    let differs = value != i128::from(highest)
        && object.subs.get(0).and_then(|entry| entry.access).is_some_and(|access| !access.is_writable());
    let has_rule = matches!(facts.first, 0x1018 | 0x1200..=0x12FF | 0x1400..=0x19FF);
    let missing = facts.entries.iter().any(|entry| entry.mandatory && !object.has(entry.first));
    differs || highest > facts.highest_sub() || (has_rule && missing) || object.compact.is_some()
}

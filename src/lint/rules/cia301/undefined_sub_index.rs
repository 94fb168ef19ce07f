use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{has_shape_of, rule};
use crate::model::{Device, Field, Object, Place};
use crate::profile::cia301;

rule! {
    /// a communication object has a sub-index that CiA 301 does not define
    ///
    /// ## What it checks
    /// Whether each sub-index of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists is one that the standard defines. FFh, which describes the object itself, may always be there.
    ///
    /// ## Why it matters
    /// The meaning of these objects belongs to CiA; a later edition may give the sub-index another one. Tools that know the object do not show it.
    ///
    /// ## Example
    /// `[1018sub5]`
    ///
    /// ## How to mend
    /// Put what is your own into 2000h to 5FFFh.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/undefined-sub-index", Error, Object(check)
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(facts) = cia301::object(index) else { return };
    // a VAR with sub-indexes is the matter of another rule
    if !has_shape_of(object, facts) || !object.object_type().has_subs() {
        return;
    }
    let highest = facts.highest_sub();
    for (sub, _) in object.subs.iter().filter(|&(sub, _)| sub != 0xFF && facts.entry(sub).is_none()) {
        let message = format!("{index:04X}h ({}) has no sub-index {sub}, only up to {highest}", facts.name);
        let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub), message);
        findings.push(finding.help("describe what is your own from 2000h on"));
    }
    if let Some(compact) = object.compact.as_ref().filter(|compact| compact.count > highest) {
        let message = format!(
            "`CompactSubObj` gives {index:04X}h ({}) {} sub-indexes, CiA 301 {highest}",
            facts.name, compact.count
        );
        let finding = Diagnostic::new(&RULE.info, Place::object(index).field(Field::CompactSubObj), message);
        findings.push(finding.help(format!("write at most {highest}")));
    }
}

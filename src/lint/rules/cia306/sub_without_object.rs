use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::rule;
use crate::model::{Device, Object, Place};

rule! {
    /// a sub-index belongs to no object
    ///
    /// ## What it checks
    /// Whether each sub-index has the section of its object.
    ///
    /// ## Why it matters
    /// Object type and name are missing; many tools refuse the file.
    ///
    /// ## Example
    /// `[2001sub1]` without `[2001]`
    ///
    /// ## How to mend
    /// Describe the object, or remove its sub-indexes.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.2
    "cia306/sub-without-object", Error, Object(check)
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if !object.orphan {
        return;
    }
    let Some((sub, _)) = object.subs.iter().next() else { return };
    let message = format!("sub-indexes of {index:04X}h are described, the object is not");
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub), message);
    findings
        .push(finding.help(format!("add a section `[{index:X}]` with name, object type and `SubNumber`")));
}

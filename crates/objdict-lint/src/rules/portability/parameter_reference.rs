use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field};
use crate::{rule, stated, with_others};

rule! {
    /// a reference designator is lost to a tool
    ///
    /// ## What it checks
    /// Whether an entry of a DCF has a `ParamRefd`. The first one is shown, others are named.
    ///
    /// ## Why it matters
    /// python-canopen and CANopenEditor write files without it.
    ///
    /// ## Example
    /// `ParamRefd=-A1.X3`
    ///
    /// ## How to mend
    /// Keep the original, and do not edit it with the tool.
    ///
    /// ## Source
    /// python-canopen 2.4.1, CANopenEditor of 2026
    "portability/parameter-reference", Note, Device(check)
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device)
        .filter(|(_, entry)| {
            entry.configured.as_ref().is_some_and(|configured| configured.reference_designator.is_some())
        })
        .map(|(place, _)| place.field(Field::ParamRefd));
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, say!("`{ParamRefd}` is not known to all tools"))
        .help("keep the original file");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

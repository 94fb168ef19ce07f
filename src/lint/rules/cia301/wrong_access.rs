use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{Expected, expected, rule};
use crate::model::{Access, Device, Field, Object};
use crate::profile::cia301;

rule! {
    /// a communication object has an access type that CiA 301 does not allow
    ///
    /// ## What it checks
    /// The access types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists, entry by entry. `ro` and `const` stand for each other, for the editions of CiA 301 exchanged them; `rwr` and `rww` count as `rw`; parameters that a profile may fix can be `const`.
    ///
    /// ## Why it matters
    /// A tool offers to write what the device refuses, or does not write what it must: a heartbeat time that is read-only cannot be set, a device type that can be written means nothing.
    ///
    /// ## Example
    /// `[1000]` with `AccessType=rw`
    ///
    /// ## How to mend
    /// Use an access type of the standard, in the description and in the device.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/wrong-access", Error, Object(check)
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    for at in expected(index, object) {
        let wrong_access = at.entry.access.filter(|&access| !at.facts.accepts_access(access));
        // what a compactly stored object says of all its sub-indexes may be meant for sub-index 0
        let for_sub_0 = |access: &Access| {
            let facts = cia301::object(index).and_then(|facts| facts.entry(0));
            at.sub.is_none()
                && object.compact.is_some()
                && facts.is_some_and(|facts| facts.accepts_access(*access))
        };
        if let Some(access) = wrong_access.filter(|access| !for_sub_0(access)) {
            findings.push(wrong(&at, access));
        }
    }
}

fn wrong(at: &Expected<'_>, access: Access) -> Diagnostic {
    let allowed: Vec<String> = at.facts.access.iter().map(|access| format!("`{access}`")).collect();
    let message = format!("`{access}` as access type of {at}, CiA 301 makes it {}", allowed.join(" or "));
    let finding = Diagnostic::new(&RULE.info, at.place().field(Field::AccessType), message);
    let first = at.facts.access.first().map_or("ro", |access| access.name());
    finding.help(format!("write `AccessType={first}`"))
}

use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::rule;
use crate::model::{Device, Object, Place};
use crate::profile::cia301;

rule! {
    /// an SDO parameter lacks a sub-index
    ///
    /// ## What it checks
    /// Whether each SDO server (1200h to 127Fh) has the COB-IDs of both directions, sub-indexes 1 and 2, and each SDO client (1280h to 12FFh) the node-ID of its server, sub-index 3, too.
    ///
    /// ## Why it matters
    /// An SDO channel needs both identifiers; a client does not know whom it talks to without the node-ID.
    ///
    /// ## Example
    /// `[1280]` with sub-indexes 0 to 2 only
    ///
    /// ## How to mend
    /// Describe the missing sub-index.
    ///
    /// ## Source
    /// CiA 301 §7.5.2.33, §7.5.2.34
    "cia301/incomplete-sdo-parameter", Error, Object(check)
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if !(0x1200..=0x12FF).contains(&index) || object.orphan || !object.object_type().has_subs() {
        return;
    }
    let Some(facts) = cia301::object(index) else { return };
    let needed = facts.entries.iter().filter(|entry| entry.mandatory && entry.first > 0);
    for entry in needed.filter(|entry| !object.has(entry.first)) {
        let (sub, name) = (entry.first, entry.name);
        let message = format!("{index:04X}h ({}) has no sub-index {sub} ({name})", facts.name);
        let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
        findings.push(finding.help(format!("add `[{index:X}sub{sub:X}]`")));
    }
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Object, Place};
use crate::profile;
use crate::rule;

rule! {
    "cia301/obsolete-object", Note, Object(check);
    summary: "an object of an old edition of CiA 301",
    checks: "Whether the description has 1004h, 100Bh, 100Eh or 100Fh, which version 4 of CiA 301 gave up and keeps reserved.",
    why: "It does no harm, but nobody reads these objects any more: 1018h, 1200h and the PDO records tell what they told.",
    example: "`[100B]`, the node-ID",
    remedy: "Leave the object out of new devices.",
    source: "CiA 301 annex A, list of objects",
}

fn check(_: &Device, index: u16, _: &Object, findings: &mut Findings) {
    if let Some(purpose) = profile::obsolete(index) {
        let message = say!("{:04X}h ({}) is obsolete since version 4 of CiA 301", index, purpose);
        let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
        findings.push(finding.help("leave it out where no old tool needs it"));
    }
}

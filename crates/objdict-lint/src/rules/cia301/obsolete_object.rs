use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Object, Place};
use crate::profile;
use crate::rule;

rule! {
    "cia301/obsolete-object", Note, Object(check);
    summary: "an object of an old edition of CiA 301",
    checks: "Whether the description has 1004h, 100Bh, 100Eh or 100Fh, which are reserved since version 4 of CiA 301.",
    why: "The objects are harmless but unused: 1018h, 1200h and the PDO parameters provide the same information.",
    example: "`[100B]`, the node-ID",
    remedy: "Omit the object in new devices.",
    source: "CiA 301 annex A, list of objects",
}

fn check(_: &Device, index: u16, _: &Object, findings: &mut Findings) {
    if let Some(purpose) = profile::obsolete(index) {
        let message = say!("{:04X}h ({}) is obsolete since version 4 of CiA 301", index, purpose);
        let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
        findings.push(finding.help("remove the object unless an old tool needs it"));
    }
}

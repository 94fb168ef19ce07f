use crate::configured::Configured;
use crate::diagnostic::{Findings, say};
use crate::model::{Access, Field};
use crate::rule;

rule! {
    "configuration/different-access", Warning, Configured(check);
    summary: "an entry of a configuration has another access type than in its EDS",
    checks: "Whether each entry of a DCF has the `AccessType` of its EDS, where both state one. `ro` and `const` are the same here: neither is downloaded.",
    why: "A tool downloads what the device does not let it write, or leaves out what it must write.",
    example: "`AccessType=rw` in the DCF, and `AccessType=ro` in the EDS",
    remedy: "Write the access type of the EDS, or check with the EDS of the device.",
    source: "CiA 306-1 §4.6.3.2, §5.3",
}

fn check(configured: &Configured<'_>, findings: &mut Findings) {
    for pair in configured.pairs() {
        let Some((is, original)) = pair.entry.access.zip(pair.original.access) else { continue };
        let is_written = |access| !matches!(access, Access::Ro | Access::Const);
        if is != original && (is_written(is) || is_written(original)) {
            let message = say!(
                "{} has access type `{}`, but `{}` in the {EDS}",
                pair.name(),
                is.name(),
                original.name()
            );
            let finding = configured.finding(&RULE.info, &pair, Field::AccessType, message);
            findings.push(finding.help(say!("write the access type of the {EDS}")));
        }
    }
}

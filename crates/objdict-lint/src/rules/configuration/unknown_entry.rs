use crate::configured::Configured;
use crate::diagnostic::{At, Diagnostic, Findings, Severity, say, series, sub_index};
use crate::model::{Entry, Place};
use crate::rule;

rule! {
    "configuration/unknown-entry", Warning, Configured(check);
    summary: "a configuration has an object or a sub-index that its EDS does not have",
    checks: "Whether each object and sub-index of a DCF is in its EDS, also as one that `CompactPDO` or `CompactSubObj` implies. With a configured value it is an error. A DCF of a coupler is not checked, because its modules bring objects.",
    why: "The device rejects the download with abort code 06020000h or 06090011h, and the configuration stops there.",
    example: "`[2001]` with `ParameterValue=5`, and an EDS without `[2001]`",
    remedy: "Remove the entry, or check with the EDS of the device.",
    source: "CiA 306-1 §5.3; CiA 301 §7.2.4.3.17",
}

fn check(configured: &Configured<'_>, findings: &mut Findings) {
    if configured.origin.is_modular() {
        return;
    }
    for (&index, object) in &configured.device.objects {
        let Some(origin) = configured.origin.object(index) else {
            if !object.orphan {
                let is_configured = object.entries().any(|(_, entry)| entry.configured_value().is_some());
                let message = say!("the {EDS} has no object {:04X}h", index);
                push(Diagnostic::new(&RULE.info, Place::object(index), message), is_configured, findings);
            }
            continue;
        };
        let subs = object.described().filter_map(|(sub, entry)| Some((sub?, entry)));
        let missing: Vec<(u8, &Entry)> = subs.filter(|(sub, _)| !origin.has(*sub)).collect();
        let Some((first, _)) = missing.first() else { continue };
        let is_configured = missing.iter().any(|(_, entry)| entry.configured_value().is_some());
        let list = series(missing.iter().map(|(sub, _)| sub_index(*sub)));
        let message = say!("the {EDS} has no {} {} in {:04X}h", count_noun(missing.len()), list, index);
        let finding = Diagnostic::new(&RULE.info, Place::entry(index, *first), message);
        let finding = finding.label(At::Node(0, Place::object(index)), say!("in the {EDS}"));
        push(finding, is_configured, findings);
    }
}

fn count_noun(count: usize) -> &'static str {
    if count == 1 { "sub-index" } else { "sub-indexes" }
}

fn push(finding: Diagnostic, is_configured: bool, findings: &mut Findings) {
    let finding = finding.help(say!("remove it, or check with the {EDS} of the device"));
    findings.push(if is_configured { finding.severity(Severity::Error) } else { finding });
}

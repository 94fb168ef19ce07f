use crate::demands::Applied;
use crate::diagnostic::{Argument, Diagnostic, Findings, RuleInfo, say};
use crate::model::{ObjectList, Part, Place};
use crate::profile::Need;
use crate::{Facts, rule, stated};

rule! {
    "cia301/missing-mandatory-object", Error, Applied(check);
    summary: "a mandatory object is missing",
    checks: "Whether 1000h (device type), 1001h (error register) and 1018h (identity) are described. Objects that are listed but not described, or are in the wrong list, have their own rules.",
    why: "A manager reads 1000h and 1018h when a node boots and rejects a node that answers with an abort. Tools identify devices by 1018h.",
    example: "no section `[1018]`",
    remedy: "Describe the object, and add it to `MandatoryObjects`.",
    source: "CiA 301 §7.5.2.1, §7.5.2.2, §7.5.2.21; CiA 306-1 §4.6.3.1",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    // a file without any part of a device has no missing objects
    if device.objects.is_empty() && device.device_info.is_none() && device.file_info.is_none() {
        return;
    }
    for facts in applied.profile.objects().filter(|facts| facts.need == Need::Mandatory) {
        let (index, name) = (facts.first, facts.name);
        // another rule reports objects that are listed but not described
        if stated::is_there(device, index) {
            continue;
        }
        let place = match device.lists.mandatory {
            Some(_) => Place::of(Part::List(ObjectList::Mandatory)),
            None => Place::device(),
        };
        let message = say!("the mandatory object {:04X}h ({}) is missing", index, name);
        let help = say!(
            "add `{}`{}",
            Part::Object(index),
            Argument::OfLists(say!(" and list `0x{:04X}` in `MandatoryObjects`", index))
        );
        findings.push(Diagnostic::new(rule, place, message).help(help));
    }
}

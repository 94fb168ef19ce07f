//! The linter: rules about the model. A rule knows no files and no formats; it looks at a [`Device`] and speaks of
//! [`Place`](crate::model::Place)s.

mod rule;
mod rules;

use crate::diagnostic::Findings;
use crate::model::Device;

pub(crate) use rule::{Check, EntryAt, Rule, rule};
pub(crate) use rules::RULES;

/// All rules on one device.
pub fn check(device: &Device) -> Findings {
    let mut findings = Findings::new();
    for rule in RULES {
        if let Check::Device(check) = rule.check {
            check(device, &mut findings);
        }
    }
    check_objects(device, &mut findings);
    findings
}

/// One walk over the objects for all rules that look at one object or one entry at a time.
fn check_objects(device: &Device, findings: &mut Findings) {
    for (&index, object) in &device.objects {
        for rule in RULES {
            if let Check::Object(check) = rule.check {
                check(device, index, object, findings);
            }
        }
        for (sub, entry) in object.described() {
            let at = EntryAt { device, index, object, sub, entry };
            for rule in RULES {
                if let Check::Entry(check) = rule.check {
                    check(&at, findings);
                }
            }
        }
    }
}

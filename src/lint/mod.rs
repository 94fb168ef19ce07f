//! The linter: rules about the model. A rule knows no files and no formats; it looks at a [`Device`] and speaks of
//! [`Place`](crate::model::Place)s.

mod expected;
mod facts;
mod index_set;
mod rule;
mod rules;
mod stated;

use crate::diagnostic::Findings;
use crate::model::Device;

pub(crate) use expected::{Expected, expected, has_shape_of};
pub(crate) use facts::{CobIdUse, Facts, PdoFacts, Service, Target, is_unstated};
pub(crate) use index_set::IndexSet;
pub(crate) use rule::{Check, EntryAt, Rule, rule, with_others};
pub(crate) use rules::RULES;

/// All rules on one device.
pub fn check(device: &Device) -> Findings {
    let mut findings = Findings::new();
    let facts = Facts::new(device);
    for rule in RULES {
        match rule.check {
            Check::Device(check) => check(device, &mut findings),
            Check::Facts(check) => check(&facts, &mut findings),
            Check::Pdo(check) => facts.pdos.iter().for_each(|pdo| check(&facts, pdo, &mut findings)),
            Check::Object(_) | Check::Entry(_) => {}
        }
    }
    check_objects(device, &mut findings);
    findings
}

/// One walk over the objects for all rules that look at one object or one entry at a time.
fn check_objects(device: &Device, findings: &mut Findings) {
    let mut object_checks = Vec::new();
    let mut entry_checks = Vec::new();
    for rule in RULES {
        match rule.check {
            Check::Object(check) => object_checks.push(check),
            Check::Entry(check) => entry_checks.push(check),
            _ => {}
        }
    }
    for (&index, object) in &device.objects {
        for check in &object_checks {
            check(device, index, object, findings);
        }
        for (sub, entry) in object.described() {
            let at = EntryAt { device, index, object, sub, entry };
            for check in &entry_checks {
                check(&at, findings);
            }
        }
    }
}

use crate::diagnostic::{Diagnostic, Findings, Severity};
use crate::lint::rule;
use crate::model::{DataType, Device, Field, Object, ObjectType, Place};
use crate::profile::cia301;

rule! {
    /// a communication object has another object type than CiA 301 gives it
    ///
    /// ## What it checks
    /// The object types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists. An ARRAY where CiA 301 has a RECORD of alike members, or the reverse, is a warning: the sub-indexes are the same, and devices of well-known makers have an identity object of object type ARRAY.
    ///
    /// ## Why it matters
    /// A tool that knows the object takes the sub-indexes of the standard for granted and does not find them.
    ///
    /// ## Example
    /// `[1017]` with `ObjectType=0x9`
    ///
    /// ## How to mend
    /// Use the object type of the standard.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/wrong-object-type", Error, Object(check)
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(facts) = cia301::object(index) else { return };
    let (expected, found) = (facts.object_type(), object.object_type());
    if object.orphan || found == expected || found == ObjectType::Null || is_reported_elsewhere(object) {
        return;
    }
    let message =
        format!("{index:04X}h ({}) is of object type {found}, CiA 301 makes it {expected}", facts.name);
    let finding = Diagnostic::new(&RULE.info, Place::object(index).field(Field::ObjectType), message);
    let finding = finding.help(format!("write `ObjectType=0x{:X}`", expected.code()));
    let harmless = facts.object_types.contains(&found);
    findings.push(if harmless { finding.severity(Severity::Warning) } else { finding });
}

/// Whether other rules have it: no object type at all, sub-indexes of a VAR, a VAR of type DOMAIN.
fn is_reported_elsewhere(object: &Object) -> bool {
    let is_var = object.object_type() == ObjectType::Var;
    let is_domain = object.main.data_type == Some(DataType::DOMAIN);
    object.main.misfits.get(&Field::ObjectType).is_some()
        || (is_var && (!object.subs.is_empty() || is_domain))
}

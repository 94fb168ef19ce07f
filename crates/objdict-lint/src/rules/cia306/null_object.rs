use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Object, ObjectType, Place};
use crate::rule;

rule! {
    "cia306/null-object", Warning, Object(check);
    summary: "an object of type NULL is described",
    checks: "Whether an object has object type 0, NULL.",
    why: "A NULL object has no data to read or write. Tools show an object that does not respond, or refuse the file.",
    example: "`ObjectType=0x0`",
    remedy: "Write the actual object type, or remove the object and its list entry.",
    source: "CiA 301 §7.4.3, table 42",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if object.main.object_type != Some(ObjectType::Null) {
        return;
    }
    let message = say!("{:04X}h is a NULL object, which has no data", index);
    let finding = Diagnostic::new(&RULE.info, Place::object(index).field(Field::ObjectType), message);
    findings.push(finding.help("write the actual object type, or remove the object"));
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{DataType, Device, Entry, Field, Object, ObjectType, Place, Value};
use crate::{rule, stated};

rule! {
    "cia306/wrong-structure-entry", Error, Object(check);
    summary: "sub-index FFh does not match the object",
    checks: "Whether each sub-index FFh, which describes the structure of its object, is an UNSIGNED32 with the object code in the lowest byte and the data type above. A missing value is accepted, and DEFSTRUCTs are not checked.",
    why: "A master that reads FFh gets a wrong object type or data type.",
    example: "`[2000subFF]` with `DefaultValue=0x00000509` in an ARRAY",
    remedy: "Write `0x00`, four digits of the data type and two digits of the object code: `0x00000508` is an ARRAY of UNSIGNED8.",
    source: "CiA 301 §7.4.7.2",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(entry) = object.subs.get(0xFF) else { return };
    let object_type =
        stated::object_type(object).filter(|kind| matches!(kind, ObjectType::Array | ObjectType::Record));
    let Some(object_type) =
        object_type.filter(|_| entry.object_type.is_none_or(|kind| kind == ObjectType::Var))
    else {
        return;
    };
    // if sub-index 0 is 255, FFh is an ordinary element
    let is_element = object.value(0).is_some_and(|count| count.as_integer() == Some(0xFF));
    if is_element {
        return;
    }
    let place = |field| Place::entry(index, 0xFF).field(field);
    let finding = if let Some(other) = entry.data_type.filter(|&data_type| data_type != DataType::UNSIGNED32)
    {
        let message = say!("sub-index FFh of {:04X}h is {}, but must be UNSIGNED32", index, other);
        Diagnostic::new(&RULE.info, place(Field::DataType), message)
    } else if let Some(code) = stated_code(entry).filter(|&code| code != i128::from(object_type.code())) {
        let message = say!(
            "sub-index FFh of {:04X}h has object code {}, but the object is {}",
            index,
            code,
            object_type
        );
        let finding = Diagnostic::new(&RULE.info, place(Field::DefaultValue), message);
        finding.label(Place::object(index).field(Field::ObjectType), "the object type")
    } else {
        return;
    };
    let code = object_type.code();
    findings.push(finding.help(say!(
        "write an UNSIGNED32 such as `{}{:02X}`, with four digits of the data type",
        "0x0000{data type}",
        code
    )));
}

/// The object code: the lowest byte of the value.
fn stated_code(entry: &Entry) -> Option<i128> {
    Some(entry.default.as_ref().and_then(Value::as_integer)? & 0xFF)
}

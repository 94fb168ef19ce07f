use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{DataType, Device, Entry, Field, Object, ObjectType, Place, Value};
use crate::{rule, stated};

rule! {
    "cia306/wrong-structure-entry", Error, Object(check);
    summary: "sub-index FFh does not say what the object is",
    checks: "Whether each sub-index FFh, which describes the structure of its object, is an UNSIGNED32 whose value, where there is one, has the object code in its lowest byte and a data type above it. It is not looked at in a DEFSTRUCT.",
    why: "A master reads FFh to learn object type and data type, and takes the object for another one.",
    example: "`[2000subFF]` with `DefaultValue=0x00000509` in an ARRAY",
    remedy: "Write `0x00` for nothing, four digits of the data type and two of the object code: `0x00000508` is an ARRAY of UNSIGNED8.",
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
    // an object may have 255 elements where sub-index 0 says so
    let is_element = object.value(0).is_some_and(|count| count.as_integer() == Some(0xFF));
    if is_element {
        return;
    }
    let place = |field| Place::entry(index, 0xFF).field(field);
    let finding = if let Some(other) = entry.data_type.filter(|&data_type| data_type != DataType::UNSIGNED32)
    {
        let message =
            say!("sub-index FFh of {:04X}h is {}, and the structure is an UNSIGNED32", index, other);
        Diagnostic::new(&RULE.info, place(Field::DataType), message)
    } else if let Some(code) = stated_code(entry).filter(|&code| code != i128::from(object_type.code())) {
        let message = say!(
            "sub-index FFh of {:04X}h gives object code {}, and the object is {}",
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
        "write an UNSIGNED32 such as `{}{:02X}`, the data type in four digits",
        "0x0000{data type}",
        code
    )));
}

/// The object code in the value, the lowest byte.
fn stated_code(entry: &Entry) -> Option<i128> {
    Some(entry.default.as_ref().and_then(Value::as_integer)? & 0xFF)
}

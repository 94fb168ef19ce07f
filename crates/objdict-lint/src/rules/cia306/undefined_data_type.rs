use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{DataType, Device, Field, ObjectType, Part, TypeKind};
use crate::{EntryAt, rule};

rule! {
    "cia306/undefined-data-type", Error, Entry(check), stops "*";
    summary: "a data type is not defined",
    checks: "Whether `DataType` is a type of CiA 301, or, from 0040h to 025Fh, a DEFTYPE or DEFSTRUCT of the file.",
    why: "Length and meaning of the value are unknown; the value can be neither read nor written.",
    example: "`DataType=0x0017`",
    remedy: "Write the intended type, such as `0x0007` for UNSIGNED32, or describe a custom type in a section with its index.",
    source: "CiA 301 §7.4.7, table 44",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(data_type) = at.entry.data_type else { return };
    let why = match data_type.kind() {
        TypeKind::Reserved => "is not the index of a data type",
        TypeKind::Defined if !is_defined(at.device, data_type) => {
            "is a custom data type, but the file does not define it"
        }
        _ => return,
    };
    // the type of sub-index 0 has its own rule
    let is_count = at.sub == Some(0) && at.object.object_type().has_subs();
    if is_count || !at.holds_value() {
        return;
    }
    let message = say!("{:04X}h {}", data_type.0, why);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::DataType), message);
    findings.push(match data_type.kind() {
        TypeKind::Reserved => finding.help(say!("write a type of CiA 301, such as `{DataType:0x0007}` for UNSIGNED32")),
        _ => finding.help(say!(
            "write a type of CiA 301, such as `{DataType:0x0007}`, or describe a DEFTYPE or DEFSTRUCT in `{}`",
            Part::Object(data_type.0)
        )),
    });
}

fn is_defined(device: &Device, data_type: DataType) -> bool {
    let object_type = device.object(data_type.0).map(|object| object.main.object_type);
    matches!(object_type, Some(Some(ObjectType::DefType | ObjectType::DefStruct)))
}

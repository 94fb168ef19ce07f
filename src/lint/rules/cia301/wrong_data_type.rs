use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{Expected, expected, rule};
use crate::model::{DataType, Device, Field, Object, TypeKind};

rule! {
    /// a communication object has another data type than CiA 301 gives it
    ///
    /// ## What it checks
    /// The data types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists, entry by entry. Where editions of CiA 301 differ, both types are accepted: 1022h is UNSIGNED8 or UNSIGNED16. Sub-index 0 is the matter of a rule of its own.
    ///
    /// ## Why it matters
    /// Managers write these objects with the length that CiA 301 gives them. A device with another length answers with an abort, and the boot-up ends there.
    ///
    /// ## Example
    /// `[1017]` with `DataType=0x0007`
    ///
    /// ## How to mend
    /// Use the data type of the standard, in the description and in the device.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/wrong-data-type", Error, Object(check)
}

fn check(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    for at in expected(index, object) {
        let counts = at.sub == Some(0) && object.object_type().has_subs();
        let wrong_type = at.entry.data_type.filter(|&data_type| !counts && !at.facts.accepts_type(data_type));
        // a type that does not exist, or that no entry can have, is reported as that
        let exists = |data_type: &DataType| match data_type.kind() {
            TypeKind::Reserved | TypeKind::Structure => false,
            TypeKind::Defined => device.objects.contains_key(&data_type.0),
            _ => true,
        };
        let wrong_type = wrong_type.filter(exists);
        if let Some(data_type) = wrong_type {
            findings.push(wrong(&at, data_type));
        }
    }
}

fn wrong(at: &Expected<'_>, data_type: DataType) -> Diagnostic {
    let types: Vec<String> = at.facts.data_types.iter().map(ToString::to_string).collect();
    let message = format!("`{data_type}` as data type of {at}, CiA 301 makes it {}", types.join(" or "));
    let finding = Diagnostic::new(&RULE.info, at.place().field(Field::DataType), message);
    let code = at.facts.data_types.first().map_or(0, |data_type| data_type.0);
    finding.help(format!("write `DataType=0x{code:04X}`"))
}

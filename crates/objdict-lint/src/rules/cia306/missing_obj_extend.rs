use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{DataType, Device, Field, ModulePart, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-obj-extend", Warning, Device(check), fix Unsafe;
    summary: "modules add bits to an object that cannot continue in the next one",
    checks: "Whether extensions of the CiA 401 objects with one bit per sub-index (6020h to 603Fh, 6220h to 6267h) have `ObjExtend`.",
    why: "Each of these objects has 128 bits, and the next index has the next 128. Without `ObjExtend` all bits go to the first object, up to sub-index 254.",
    example: "`[M1SubExt6020]` with `Count=8` and without `ObjExtend`",
    remedy: "Write `ObjExtend=128`.",
    source: "CiA 306-1 §6.3, CiA 401-1 §7.3",
}

fn check(device: &Device, findings: &mut Findings) {
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        for (&index, extension) in &module.extensions {
            let is_bit = extension.entry.data_type == Some(DataType::BOOLEAN)
                && matches!(index, 0x6020..=0x603F | 0x6220..=0x6267);
            let is_stated = extension.obj_extend.is_some_and(|limit| limit > 0)
                || extension.entry.invalid_values.get(&Field::ObjExtend).is_some();
            if !is_bit || is_stated {
                continue;
            }
            let place = Place::of(Part::Module(number, ModulePart::SubExt(index))).field(Field::ObjExtend);
            let message = say!("module {} adds bits to {:04X}h without `{ObjExtend}`", number, index);
            let title = say!("write `{ObjExtend=128}`");
            let finding = Diagnostic::new(&RULE.info, place.clone(), message).help(title.clone());
            findings.push(finding.fix(Fix::risky(title).set(place, "128")));
        }
    }
}

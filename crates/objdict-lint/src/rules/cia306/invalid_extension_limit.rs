use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, ExtensionCount, Field, ModulePart, Part, Place};
use crate::rule;

rule! {
    "cia306/invalid-extension-limit", Error, Device(check);
    summary: "a module extends an object beyond what it can hold",
    checks: "Whether `ObjExtend` of each extension is at most 254, the highest sub-index that an element can have, and not below the number of sub-indexes in `Count`.",
    why: "`ObjExtend` says after which sub-index the next object goes on. With one that cannot be reached, the sub-indexes of the modules overlap or have no place.",
    example: "`ObjExtend=4` and `Count=8` in `[M1SubExt6000]`",
    remedy: "Write 254, or 128 for the objects with one bit an entry that CiA 401 has.",
    source: "CiA 306-1 §6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        for (&index, extension) in &module.extensions {
            let Some(limit) = extension.obj_extend.filter(|&limit| limit > 0) else { continue };
            let count = match extension.count {
                Some(ExtensionCount::Subs(count)) => count,
                _ => 0,
            };
            let place = |field| Place::of(Part::Module(number, ModulePart::SubExt(index))).field(field);
            let finding = if limit == 255 {
                let message = "`255` as highest sub-index of an element, which is 254 at most";
                Diagnostic::new(&RULE.info, place(Field::ObjExtend), message)
            } else if count > limit {
                let message = say!(
                    "each module {} adds {} sub-indexes to {:04X}h, which takes {}",
                    number,
                    count,
                    index,
                    limit
                );
                Diagnostic::new(&RULE.info, place(Field::ObjExtend), message)
                    .label(place(Field::Count), "so many are added")
            } else {
                continue;
            };
            findings.push(finding.help("write 254, or 128 for objects with one bit an entry"));
        }
    }
}

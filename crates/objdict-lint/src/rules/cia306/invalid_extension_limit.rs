use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, ExtensionCount, Field, ModulePart, Part, Place};
use crate::rule;

rule! {
    "cia306/invalid-extension-limit", Error, Device(check);
    summary: "a module extends an object beyond its highest sub-index",
    checks: "Whether `ObjExtend` of each extension is at most 254, the highest sub-index of an element, and not below the number of sub-indexes in `Count`.",
    why: "`ObjExtend` is the sub-index after which the next object starts. With an invalid value, sub-indexes of the modules overlap or do not fit.",
    example: "`ObjExtend=4` and `Count=8` in `[M1SubExt6000]`",
    remedy: "Write 254, or 128 for CiA 401 objects with one bit per entry.",
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
                let message = "`255` is above 254, the highest sub-index of an element";
                Diagnostic::new(&RULE.info, place(Field::ObjExtend), message)
            } else if count > limit {
                let message = say!(
                    "module {} adds {} sub-indexes per instance to {:04X}h, but `{ObjExtend}` is {}",
                    number,
                    count,
                    index,
                    limit
                );
                Diagnostic::new(&RULE.info, place(Field::ObjExtend), message)
                    .label(place(Field::Count), "number of added sub-indexes")
            } else {
                continue;
            };
            findings.push(finding.help("write 254, or 128 for objects with one bit per entry"));
        }
    }
}

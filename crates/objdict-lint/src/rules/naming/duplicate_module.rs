use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, ModulePart, Part, Place};
use crate::rule;

rule! {
    "naming/duplicate-module", Note, Device(check);
    summary: "two modules have the same name and order code",
    checks: "Whether two modules have both the same `ProductName` and the same `OrderCode`.",
    why: "Users who assemble a station by names cannot distinguish the two modules.",
    example: "`ProductName=DI8` and `OrderCode=750-430` in `[M1ModuleInfo]` and in `[M2ModuleInfo]`",
    remedy: "Add the version to the name, or remove one of the modules.",
    source: "CiA 306-1 §6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut seen = HashMap::new();
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        let (Some(name), Some(code)) = (&module.product_name, &module.order_code) else { continue };
        // two versions of a module may share a name
        let key = (name, code, module.product_version, module.product_revision);
        let first = *seen.entry(key).or_insert(number);
        if first == number || name.is_empty() {
            continue;
        }
        let place = |number| Place::of(Part::Module(number, ModulePart::Info)).field(Field::ProductName);
        let message = say!("modules {} and {} are both `{}` with order code `{}`", first, number, name, code);
        let finding = Diagnostic::new(&RULE.info, place(number), message).label(place(first), "first here");
        findings.push(finding.help("add the version to the name, or remove one of the modules"));
    }
}

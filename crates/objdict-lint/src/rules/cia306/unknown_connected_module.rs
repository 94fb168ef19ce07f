use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, ModulePart, Part, Place};
use crate::rule;

rule! {
    "cia306/unknown-connected-module", Error, Device(check), fix Unsafe;
    summary: "a connected module is not described",
    checks: "Whether each number in `[ConnectedModules]` is the number of a described module.",
    why: "The objects of such a module are unknown.",
    example: "`2=7` in `[ConnectedModules]` of a coupler with five modules",
    remedy: "Write the number of a described module, or copy the module description from the EDS.",
    source: "CiA 306-1 §6.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    for (item, number) in (1..).zip(modules.connected.iter().flatten()) {
        if !modules.supported.contains_key(number) {
            let place = Place::of(Part::ConnectedModules).field(Field::Item(item));
            let message = say!("module {} is connected, but not described", number);
            let fix = Fix::risky("remove the list entry").remove(place.clone());
            let finding = Diagnostic::new(&RULE.info, place, message).fix(fix);
            findings.push(finding.help(say!(
                "add the {sections} of the module (`{}` and others), or correct the number",
                Part::Module(*number, ModulePart::Info)
            )));
        }
    }
}

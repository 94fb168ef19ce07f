use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, say, sub_index};
use crate::model::{Device, DeviceKind, Field, ModulePart, Part, Place};
use crate::rule;

rule! {
    "cia306/unknown-connected-module", Error, Device(check), fix Unsafe;
    summary: "a connected module is not described, or not the one of the module list",
    checks: "Whether each number in `[ConnectedModules]` is the number of a described module, and in a DCF the value of 1027h (module list) at its position, if that is not 0. The second is a warning.",
    why: "The objects of such a module are unknown.",
    example: "`2=7` in `[ConnectedModules]` of a coupler with five modules",
    remedy: "Write the number of a described module, or copy the module description from the EDS.",
    source: "CiA 306-1 §6.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    let is_node = device.kind == DeviceKind::Node;
    for (item, number) in (1..).zip(modules.connected.iter().flatten()) {
        let sub = u8::try_from(item).ok().filter(|_| is_node);
        let listed = sub.and_then(|sub| Some((sub, device.value(0x1027, sub)?.as_integer()?)));
        if let Some((sub, other)) = listed.filter(|&(_, other)| other != 0 && other != i128::from(*number)) {
            let place = Place::of(Part::ConnectedModules).field(Field::Item(item));
            let message = say!("module {} is connected, but 1027h:{} is {}", number, sub_index(sub), other);
            let finding = Diagnostic::new(&RULE.info, place, message).severity(Severity::Warning);
            let finding = finding.label(device.value_place(0x1027, sub), "the module list");
            findings.push(finding.help("write the module that is connected in both places"));
        }
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

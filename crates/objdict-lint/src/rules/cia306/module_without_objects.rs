use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Module, ModulePart, Part, Place};
use crate::rule;

rule! {
    "cia306/module-without-objects", Warning, Device(check);
    summary: "a module adds no objects",
    checks: "Whether each supported module has objects of its own (`[MxFixedObjects]`) or extends those of the device (`[MxSubExtends]`).",
    why: "A configuration tool offers the module, but nothing changes when it is plugged in. Most likely its sections were forgotten or are misspelt.",
    example: "`[M2ModuleInfo]` without `[M2FixedObjects]` and `[M2SubExtends]`",
    remedy: "Describe the objects of the module, or remove the module if it has none, such as a power supply.",
    source: "CiA 306-1 §6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        if adds_something(module) {
            continue;
        }
        let part = |part| Part::Module(number, part);
        let message = say!(
            "module {} has neither `{}` nor `{}`",
            number,
            part(ModulePart::FixedObjects),
            part(ModulePart::SubExtends)
        );
        let finding = Diagnostic::new(&RULE.info, Place::of(part(ModulePart::Info)), message);
        findings.push(finding.help("describe the objects of the module"));
    }
}

fn adds_something(module: &Module) -> bool {
    !(module.fixed_list.is_empty()
        && module.fixed.is_empty()
        && module.extension_list.is_empty()
        && module.extensions.is_empty())
}

use crate::diagnostic::{Diagnostic, Findings, listing, listing_or, say};
use crate::model::{Device, Field, Module, ModulePart, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-module-info", Error, Device(check);
    summary: "a module lacks its product information",
    checks: "Whether each module has `[MxModuleInfo]` with `ProductName`, `ProductVersion`, `ProductRevision` and `OrderCode`.",
    why: "Configuration tools show these values to users who assemble modules.",
    example: "`[M1FixedObjects]` without `[M1ModuleInfo]`",
    remedy: "Add the section or the missing keys.",
    source: "CiA 306-1 §6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    for (&number, module) in &modules.supported {
        let missing = missing(module);
        let Some(first) = missing.first() else { continue };
        let message = if missing.len() == 4 {
            say!(
                "module {} has no `{}`, or the {section} is empty",
                number,
                Part::Module(number, ModulePart::Info)
            )
        } else {
            say!("`{}` has no {}", Part::Module(number, ModulePart::Info), listing_or(&missing))
        };
        let info = Place::of(Part::Module(number, ModulePart::Info)).field(first.clone());
        let place = if missing.len() == 4 { some_part(number, module) } else { info };
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help(say!("add {}", listing(&missing))));
    }
}

fn missing(module: &Module) -> Vec<Field> {
    let stated = [
        (Field::ProductName, module.product_name.is_some()),
        (Field::ProductVersion, module.product_version.is_some()),
        (Field::ProductRevision, module.product_revision.is_some()),
        (Field::OrderCode, module.order_code.is_some()),
    ];
    let is_missing = |(field, stated): &(Field, bool)| !stated && module.invalid_values.get(field).is_none();
    stated.into_iter().filter(is_missing).map(|(field, _)| field).collect()
}

/// Any section of a module without information.
fn some_part(number: u16, module: &Module) -> Place {
    let part = if let Some(&index) = module.fixed.keys().next() {
        ModulePart::Fixed(index)
    } else if let Some(&index) = module.extensions.keys().next() {
        ModulePart::SubExt(index)
    } else if !module.fixed_list.is_empty() {
        ModulePart::FixedObjects
    } else if !module.extension_list.is_empty() {
        ModulePart::SubExtends
    } else if !module.comments.is_empty() {
        ModulePart::Comments
    } else {
        ModulePart::Info
    };
    Place::of(Part::Module(number, part))
}

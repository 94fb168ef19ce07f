use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Module, ModulePart, Part, Place};
use crate::{IndexSet, rule};

rule! {
    "cia306/module-list-mismatch", Error, Device(check), fix Mixed;
    summary: "the lists of a module do not match its objects",
    checks: "Whether each index of `[MxFixedObjects]` and `[MxSubExtends]` is described in `[MxFixedxxxx]` or `[MxSubExtxxxx]`, each described index is listed, and each sub-index of a fixed object has its object.",
    why: "Tools that assemble modules use the lists and ignore objects that are not listed.",
    example: "`1=0x6423` in `[M1FixedObjects]`, and no `[M1Fixed6423]`",
    remedy: "Describe the object, or correct the list and its `NrOfEntries`.",
    source: "CiA 306-1 §6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    for (&number, module) in &modules.supported {
        check_fixed(number, module, findings);
        check_extensions(number, module, findings);
    }
}

fn check_fixed(number: u16, module: &Module, findings: &mut Findings) {
    let list = Part::Module(number, ModulePart::FixedObjects);
    let listed: IndexSet = module.fixed_list.iter().copied().collect();
    for (item, index) in (1..).zip(&module.fixed_list) {
        if !module.fixed.contains_key(index) {
            listed_only(&list, (item, *index), &Part::Module(number, ModulePart::Fixed(*index)), findings);
        }
    }
    for (&index, object) in &module.fixed {
        let section = Part::Module(number, ModulePart::Fixed(index));
        if let Some((sub, _)) = object.subs.iter().next().filter(|_| object.orphan) {
            let place = Place::of(Part::Module(number, ModulePart::FixedEntry(index, sub)));
            let message = say!(
                "sub-indexes of the fixed object {:04X}h are described, but the object is missing",
                index
            );
            let finding = Diagnostic::new(&RULE.info, place, message);
            findings.push(
                finding.help(say!("add {a section} `{}`", Part::Module(number, ModulePart::Fixed(index)))),
            );
        } else if !listed.contains(index) {
            described_only(section, index, (&list, module.fixed_list.len()), findings);
        }
    }
}

fn check_extensions(number: u16, module: &Module, findings: &mut Findings) {
    let list = Part::Module(number, ModulePart::SubExtends);
    let listed: IndexSet = module.extension_list.iter().copied().collect();
    for (item, index) in (1..).zip(&module.extension_list) {
        if !module.extensions.contains_key(index) {
            listed_only(&list, (item, *index), &Part::Module(number, ModulePart::SubExt(*index)), findings);
        }
    }
    for &index in module.extensions.keys().filter(|&&index| !listed.contains(index)) {
        let section = Part::Module(number, ModulePart::SubExt(index));
        described_only(section, index, (&list, module.extension_list.len()), findings);
    }
}

fn listed_only(list: &Part, (item, index): (u32, u16), section: &Part, findings: &mut Findings) {
    let place = Place::of(list.clone()).field(Field::Item(item));
    let fix = Fix::risky("remove the list entry").remove(place.clone());
    let message = say!("{:04X}h is listed, but {section} `{}` is missing", index, section);
    let finding = Diagnostic::new(&RULE.info, place, message).fix(fix);
    findings.push(finding.help("describe the object, or remove its list entry"));
}

fn described_only(section: Part, index: u16, (list, length): (&Part, usize), findings: &mut Findings) {
    let next = u32::try_from(length + 1).unwrap_or(u32::MAX);
    let place = Place::of(list.clone()).field(Field::Item(next));
    let title = say!("add `0x{:04X}` to `{}`", index, list);
    let fix = Fix::safe(title.clone()).set(place, format!("0x{index:04X}"));
    let message = say!("{:04X}h is described, but not listed in `{}`", index, list);
    let finding = Diagnostic::new(&RULE.info, Place::of(section), message);
    findings.push(finding.help(title).fix(fix));
}

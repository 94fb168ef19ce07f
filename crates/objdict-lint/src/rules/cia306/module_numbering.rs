use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, Text, say, series};
use crate::model::{Device, Field, ModulePart, Modules, Part, Place};
use crate::rule;

rule! {
    "cia306/module-numbering", Error, Device(check), fix Safe;
    summary: "the modules are not numbered consecutively from 1",
    checks: "Whether the sections of the modules (`[MxModuleInfo]` and others) have the numbers 1 to `NrOfEntries` of `[SupportedModules]`.",
    why: "Tools count from 1. They ignore modules above the count and stop at a gap.",
    example: "`NrOfEntries=2`, `[M1ModuleInfo]` and `[M3ModuleInfo]`",
    remedy: "Renumber the modules in all their sections and in `[ConnectedModules]`.",
    source: "CiA 306-1 §6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    if modules.invalid_values.get(&Field::NrOfEntries).is_some() {
        return;
    }
    let described = modules.supported.len();
    let numbered = modules.supported.keys().zip(1..).all(|(&number, expected)| number == expected);
    let count = Place::of(Part::SupportedModules).field(Field::NrOfEntries);
    match modules.declared {
        None if described == 0 => {}
        None => {
            let message =
                say!("{} modules are described, but `{[SupportedModules]}` has no count", described);
            let fix = Fix::safe(say!("write `{}`", Argument::setting(Field::NrOfEntries, described)))
                .set(count, described.to_string());
            let finding = Diagnostic::new(&RULE.info, first_module(modules), message).fix(fix);
            findings.push(finding.help(say!(
                "write `{}` in `{[SupportedModules]}`",
                Argument::setting(Field::NrOfEntries, described)
            )));
        }
        Some(declared) if usize::from(declared) != described => {
            let message = say!("`{NrOfEntries}` is {}, but {} described", declared, modules_are(described));
            let fix = Fix::safe(say!("write `{}`", Argument::setting(Field::NrOfEntries, described)));
            let fix = fix.set(count.clone(), described.to_string());
            let finding = Diagnostic::new(&RULE.info, count, message).fix(fix);
            findings.push(finding.help(say!(
                "write `{}`, or describe the others",
                Argument::setting(Field::NrOfEntries, described)
            )));
        }
        Some(_) if numbered => {}
        Some(declared) => {
            let numbers = series(modules.supported.keys());
            let message = say!("{} modules have the numbers {}, not 1 to {}", declared, numbers, declared);
            findings.push(Diagnostic::new(&RULE.info, count, message).help("renumber the modules"));
        }
    }
}

fn modules_are(number: usize) -> Text {
    match number {
        0 => "no module is".into(),
        1 => "1 module is".into(),
        _ => say!("{} modules are", number),
    }
}

fn first_module(modules: &Modules) -> Place {
    let first = modules.supported.keys().next();
    first.map_or(Place::of(Part::SupportedModules), |&number| {
        Place::of(Part::Module(number, ModulePart::Info))
    })
}

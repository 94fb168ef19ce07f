use crate::diagnostic::{Diagnostic, Findings, Fix, series};
use crate::model::{Device, Field, ModulePart, Modules, Part, Place};
use crate::rule;

rule! {
    /// the modules are not numbered from 1 to their number
    ///
    /// ## What it checks
    /// Whether the sections `[MxModuleInfo]` and the like have the numbers 1 to `NrOfEntries` of `[SupportedModules]`.
    ///
    /// ## Why it matters
    /// Tools count from 1. They do not see modules beyond the number, and stop at a gap.
    ///
    /// ## Example
    /// `NrOfEntries=2`, `[M1ModuleInfo]` and `[M3ModuleInfo]`
    ///
    /// ## How to mend
    /// Number the modules again, in all of their sections and in `[ConnectedModules]`.
    ///
    /// ## Source
    /// CiA 306-1 §6.3
    "cia306/module-numbering", Error, Device(check), fix Safe
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    if modules.misfits.get(&Field::NrOfEntries).is_some() {
        return;
    }
    let described = modules.supported.len();
    let numbered = modules.supported.keys().zip(1..).all(|(&number, expected)| number == expected);
    let count = Place::of(Part::SupportedModules).field(Field::NrOfEntries);
    match modules.declared {
        None if described == 0 => {}
        None => {
            let message = format!("`[SupportedModules]` does not say that there are {described} modules");
            let fix = Fix::safe(format!("write `NrOfEntries={described}`")).set(count, described.to_string());
            let finding = Diagnostic::new(&RULE.info, first_module(modules), message).fix(fix);
            findings.push(finding.help(format!("write `NrOfEntries={described}` into `[SupportedModules]`")));
        }
        Some(declared) if usize::from(declared) != described => {
            let message = format!("`NrOfEntries` is {declared}, but {} described", modules_are(described));
            let fix = Fix::safe(format!("write `NrOfEntries={described}`"));
            let fix = fix.set(count.clone(), described.to_string());
            let finding = Diagnostic::new(&RULE.info, count, message).fix(fix);
            findings.push(finding.help(format!("write `NrOfEntries={described}`, or describe the others")));
        }
        Some(_) if numbered => {}
        Some(declared) => {
            let numbers = series(modules.supported.keys());
            let message = format!("{declared} modules have the numbers {numbers}, not 1 to {declared}");
            findings.push(Diagnostic::new(&RULE.info, count, message).help("number the modules again"));
        }
    }
}

fn modules_are(number: usize) -> String {
    match number {
        0 => "no module is".to_owned(),
        1 => "1 module is".to_owned(),
        _ => format!("{number} modules are"),
    }
}

fn first_module(modules: &Modules) -> Place {
    let first = modules.supported.keys().next();
    first.map_or(Place::of(Part::SupportedModules), |&number| {
        Place::of(Part::Module(number, ModulePart::Info))
    })
}

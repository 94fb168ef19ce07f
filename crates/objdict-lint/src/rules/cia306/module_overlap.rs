use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, DeviceKind, ModulePart, Part, Place};
use crate::{IndexSet, rule};

rule! {
    "cia306/module-overlap", Error, Device(check);
    summary: "an object is defined by a module and elsewhere",
    checks: "Whether a fixed object of a module is not also a device object of an EDS, and whether no index is both a fixed object and an extension. A DCF contains the objects of the connected modules in addition to the modules.",
    why: "The object of the coupler and the object of the module share an index.",
    example: "`[6423]` and `[M1Fixed6423]`",
    remedy: "Keep only one definition.",
    source: "CiA 306-1 §6.3",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    let mut extended: BTreeMap<u16, u16> = BTreeMap::new();
    for (&number, module) in &modules.supported {
        for &index in module.extensions.keys() {
            extended.entry(index).or_insert(number);
        }
    }
    let mut seen = IndexSet::new();
    for (&number, module) in &modules.supported {
        // objects of several modules are reported at the first one
        for &index in module.fixed.keys().filter(|&&index| seen.insert(index)) {
            let place = Place::of(Part::Module(number, ModulePart::Fixed(index)));
            let fixed = say!("{:04X}h is a fixed object of module {}", index, number);
            if device.kind == DeviceKind::Type && device.objects.contains_key(&index) {
                let finding =
                    Diagnostic::new(&RULE.info, place, say!("{} and also an object of the device", fixed))
                        .label(Place::object(index), "the device's");
                findings.push(finding.help("keep only one definition"));
            } else if let Some(&other) = extended.get(&index) {
                let extension = Place::of(Part::Module(other, ModulePart::SubExt(index)));
                let finding =
                    Diagnostic::new(&RULE.info, place, say!("{} and is extended by module {}", fixed, other))
                        .label(extension, "the extension");
                findings.push(finding.help("describe the object either as fixed or as extension"));
            }
        }
    }
}

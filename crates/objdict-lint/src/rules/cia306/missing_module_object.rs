use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::model::{Device, DeviceKind, Field, Part, Place};
use crate::{rule, stated};

rule! {
    "cia306/missing-module-object", Warning, Device(check);
    summary: "the DCF does not describe the objects of a connected module",
    checks: "Whether a DCF describes the fixed and extended objects of the modules in `[ConnectedModules]`.",
    why: "The DCF describes the complete station including its modules. Objects of modules that are not described are not configured.",
    example: "`1=2` in `[ConnectedModules]` and `1=0x6423` in `[M2FixedObjects]` without `[6423]`",
    remedy: "Describe the objects as defined by the modules.",
    source: "CiA 306-1 §6.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = device.modules.as_ref().filter(|_| device.kind == DeviceKind::Node) else { return };
    let mut seen = BTreeSet::new();
    for (at, &number) in modules.connected.iter().flatten().enumerate() {
        let Some(module) = modules.supported.get(&number).filter(|_| seen.insert(number)) else { continue };
        let brings = module.fixed.keys().chain(module.extensions.keys());
        let mut missing = brings.filter(|&&index| !stated::is_there(device, index));
        let Some(first) = missing.next() else { continue };
        let more = match missing.count() {
            0 => Text::default(),
            others => say!(" and {} more", others),
        };
        let item = u32::try_from(at + 1).unwrap_or(u32::MAX);
        let message = say!("module {} defines {:04X}h{}, missing in the {DCF}", number, first, more);
        let place = Place::of(Part::ConnectedModules).field(Field::Item(item));
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("describe the objects as defined by the modules"));
    }
}

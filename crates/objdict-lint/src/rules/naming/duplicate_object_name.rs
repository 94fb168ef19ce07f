use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Place};
use crate::{rule, with_others};

rule! {
    "naming/duplicate-object-name", Note, Device(check);
    summary: "two objects have the same name",
    checks: "Whether the names of objects from 2000h on differ. Not checked: objects at a distance of 800h, which are the same object of several axes or channels, and 5800h to 5FFFh, where masters store the PDOs of other nodes. The first repetition is shown with the others.",
    why: "Users cannot distinguish the objects, libraries that look up objects by name return the first one, and code generators have to add numbers.",
    example: "`ParameterName=Setpoint` in `[2000]` and in `[2001]`",
    remedy: "Add a number or a word to the names.",
    source: "Not in a standard; python-canopen, for example, looks up objects by name",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut seen: HashMap<&str, u16> = HashMap::with_capacity(device.objects.len());
    let mut repeated = device.objects.range(0x2000..).filter_map(|(&index, object)| {
        let name = object.name();
        if name.is_empty() || object.orphan || (0x5800..0x6000).contains(&index) {
            return None;
        }
        let first = *seen.entry(name).or_insert(index);
        // the same object of another axis is 800h higher
        let is_copy = index >= 0x6000 && (index - first).is_multiple_of(0x800);
        (first != index && !is_copy).then_some((first, index, name))
    });
    let Some((first, second, name)) = repeated.next() else { return };
    let place = |index| Place::object(index).field(Field::ParameterName);
    let message = say!("{:04X}h and {:04X}h are both called `{}`", first, second, name);
    let finding = Diagnostic::new(&RULE.info, place(second), message).label(place(first), "first here");
    let others = repeated
        .map(|(first, index, _)| (place(index), say!("and {:04X}h the same as {:04X}h", index, first)));
    findings.push(with_others(finding, others).help("add a number or a word to the names"));
}

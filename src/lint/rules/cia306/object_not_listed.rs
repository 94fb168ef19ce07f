use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{IndexSet, rule};
use crate::model::{Device, ObjectList, Place};

rule! {
    /// an object is described, but in no list
    ///
    /// ## What it checks
    /// Whether each object from 1000h on is in one of the lists. Definitions of data types below need not be. Where a list is missing as a whole, that is the finding.
    ///
    /// ## Why it matters
    /// Readers that go by the lists, as Lely and most C tools do, do not see the object.
    ///
    /// ## Example
    /// `[2000]`, and `SupportedObjects=0` in `[ManufacturerObjects]`
    ///
    /// ## How to mend
    /// Add the index to the list of its range and write the new count, or remove the section.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.1
    "cia306/object-not-listed", Error, Device(check)
}

fn check(device: &Device, findings: &mut Findings) {
    let lists = &device.lists;
    let [mandatory, optional, manufacturer] =
        [&lists.mandatory, &lists.optional, &lists.manufacturer].map(Option::is_some);
    let listed: IndexSet = lists.iter().map(|(_, index)| index).collect();
    for (&index, object) in device.objects.range(0x1000..) {
        if object.orphan || listed.contains(index) {
            continue;
        }
        let (list, exists) = match index {
            0x1000 | 0x1001 | 0x1018 => (ObjectList::Mandatory, mandatory),
            0x2000..=0x5FFF => (ObjectList::Manufacturer, manufacturer),
            _ => (ObjectList::Optional, optional),
        };
        if exists {
            let message = format!("{index:04X}h is described, but in no list of objects");
            let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
            findings.push(finding.help(format!("add `0x{index:04X}` to `[{list}]`")));
        }
    }
}

use crate::diagnostic::{Diagnostic, Findings, Severity, counted};
use crate::lint::rule;
use crate::model::{Device, DeviceKind, ObjectList, Place};

rule! {
    /// a section that every description has is missing
    ///
    /// ## What it checks
    /// Whether `[FileInfo]`, `[DeviceInfo]`, `[DummyUsage]`, `[Comments]` and the three object lists are there. An error are `[FileInfo]` and `[DeviceInfo]` of an EDS, and each list that described objects belong to. What a DCF is made of is looked at with more patience: the tools that write it need not say who made it. An empty file has its own finding.
    ///
    /// ## Why it matters
    /// Objects of a missing list are in no list at all, so most tools do not see them. Without `[DeviceInfo]` nobody knows whose device it is. The other sections may be empty, but some readers refuse a file without them.
    ///
    /// ## Example
    /// A file that starts with `[1000]`
    ///
    /// ## How to mend
    /// Add the section; an empty list is `SupportedObjects=0`, empty comments are `Lines=0`.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    "cia306/missing-section", Error, Device(check)
}

fn check(device: &Device, findings: &mut Findings) {
    if is_blank(device) {
        return;
    }
    let is_node = device.kind == DeviceKind::Node;
    let grave = if is_node { Severity::Note } else { Severity::Error };
    let light = if is_node { Severity::Note } else { Severity::Warning };
    // keys above all sections most likely belong to it, and that is reported
    let headless = device.extra.iter().any(|section| section.name.is_empty());
    if device.file_info.is_none() && !headless {
        report("FileInfo", grave, "say who made the file and when", findings);
    }
    if device.device_info.is_none() {
        let severity = if is_node { Severity::Warning } else { Severity::Error };
        report("DeviceInfo", severity, "say whose device it is and what it can do", findings);
    }
    if device.dummy_usage.is_none() {
        report(
            "DummyUsage",
            light,
            "write `Dummy0005=1` for a type that can fill a gap in an RPDO",
            findings,
        );
    }
    if device.comments.is_none() {
        report("Comments", Severity::Note, "write `Lines=0` into it", findings);
    }
    check_lists(device, light, findings);
}

fn check_lists(device: &Device, light: Severity, findings: &mut Findings) {
    let lists = &device.lists;
    let present = [&lists.mandatory, &lists.optional, &lists.manufacturer];
    for (list, indexes) in ObjectList::ALL.into_iter().zip(present) {
        if indexes.is_some() {
            continue;
        }
        let objects = device.objects.keys().filter(|&&index| list_of(index) == Some(list)).count();
        if objects == 0 {
            // where the mandatory objects are missing too, that is the finding
            if list != ObjectList::Mandatory {
                report(list.name(), light, "write `SupportedObjects=0` into it", findings);
            }
            continue;
        }
        let objects_belong = counted(objects, "object belongs", "objects belong");
        let message = format!("section `[{list}]` is missing, to which {objects_belong}");
        let finding = Diagnostic::new(&RULE.info, Place::device(), message);
        findings.push(finding.help("list the objects in it: `SupportedObjects=1`, `1=0x1000`"));
    }
}

/// The list that an object belongs to; none for the definition of a data type.
fn list_of(index: u16) -> Option<ObjectList> {
    match index {
        0x1000 | 0x1001 | 0x1018 => Some(ObjectList::Mandatory),
        0x2000..=0x5FFF => Some(ObjectList::Manufacturer),
        0x1000.. => Some(ObjectList::Optional),
        _ => None,
    }
}

/// Whether the file says nothing at all, which another rule reports.
fn is_blank(device: &Device) -> bool {
    let lists = &device.lists;
    device.file_info.is_none()
        && device.device_info.is_none()
        && device.dummy_usage.is_none()
        && device.comments.is_none()
        && device.commissioning.is_none()
        && lists.mandatory.is_none()
        && lists.optional.is_none()
        && lists.manufacturer.is_none()
        && device.objects.is_empty()
        && device.extra.is_empty()
}

fn missing(section: &str) -> String {
    format!("section `[{section}]` is missing")
}

fn report(section: &str, severity: Severity, help: &'static str, findings: &mut Findings) {
    let finding = Diagnostic::new(&RULE.info, Place::device(), missing(section)).severity(severity);
    findings.push(finding.help(help));
}

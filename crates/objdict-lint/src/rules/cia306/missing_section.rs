use crate::diagnostic::{Change, Diagnostic, Findings, Fix, Severity, Text, counted, say};
use crate::model::{Device, DeviceKind, Field, ObjectList, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-section", Error, Device(check), fix Safe, explains Keys ["unknown-key"];
    summary: "a standard section is missing",
    checks: "Whether `[FileInfo]`, `[DeviceInfo]`, `[DummyUsage]`, `[Comments]` and the three object lists are in the file. A missing `[FileInfo]` or `[DeviceInfo]` of an EDS is an error, and so is a missing list of described objects. DCFs get lower severities: tools that write them need not record the author. In real files, mostly DCFs without `[Comments]` or `[FileInfo]` are reported, as a harmless note; the errors are fragments and lists whose absence hides whole ranges of objects. An empty file has its own finding.",
    why: "Objects of a missing list are not listed at all, so most tools do not see them. Without `[DeviceInfo]` the device is unknown. The other sections may be empty, but some readers refuse a file without them.",
    example: "A file that starts with `[1000]`",
    remedy: "Add the section. Write `SupportedObjects=0` for an empty list, `Lines=0` for empty comments.",
    source: "CiA 306-1 §4.2",
}

fn check(device: &Device, findings: &mut Findings) {
    if is_blank(device) {
        return;
    }
    let is_node = device.kind == DeviceKind::Node;
    let severe = if is_node { Severity::Note } else { Severity::Error };
    let light = if is_node { Severity::Note } else { Severity::Warning };
    // keys before the first section, which another rule reports, probably belong to `FileInfo`
    let headless = device.extra.iter().any(|section| section.name().is_empty());
    if device.file_info.is_none() && !headless {
        findings.push(report(&Part::FileInfo, severe, "add it with the author and the date of the file"));
    }
    if device.device_info.is_none() {
        let severity = if is_node { Severity::Warning } else { Severity::Error };
        findings.push(report(
            &Part::DeviceInfo,
            severity,
            "add it with the vendor, the product and the features of the device",
        ));
    }
    if device.dummy_usage.is_none() {
        let help = "add it with `Dummy0005=1` for each type that may fill a gap in an RPDO";
        let key = |number| Field::Named(format!("Dummy{number:04X}").into());
        let none = (1..=7).map(|number| (key(number), "0".to_owned())).collect();
        let fix =
            Fix::safe(say!("add the {section} without dummies")).with(Change::Add(Part::DummyUsage, none));
        findings.push(report(&Part::DummyUsage, light, help).fix(fix));
    }
    if device.comments.is_none() {
        let none = vec![(Field::Lines, "0".to_owned())];
        let fix =
            Fix::safe(say!("add the {section} without comments")).with(Change::Add(Part::Comments, none));
        findings.push(report(&Part::Comments, Severity::Note, say!("add it with `{Lines=0}`")).fix(fix));
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
        let members = device.objects.keys().copied().filter(|&index| ObjectList::of(index) == Some(list));
        let fix = Fix::safe("add the list").with(Change::List(list, members.clone().collect()));
        let objects = members.count();
        if objects == 0 {
            // another rule reports missing mandatory objects
            if list != ObjectList::Mandatory {
                let finding = report(&Part::List(list), light, say!("add it with `{SupportedObjects=0}`"));
                findings.push(finding.fix(fix));
            }
            continue;
        }
        let objects_belong = counted(objects, "object belongs", "objects belong");
        let message = say!("{section} `{}` is missing, but {} in it", list, objects_belong);
        let finding = Diagnostic::new(&RULE.info, Place::device(), message);
        findings.push(
            finding.help(say!("add the list of these objects: `{SupportedObjects=1}`, `1=0x1000`")).fix(fix),
        );
    }
}

/// Whether the file is empty, which another rule reports.
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

fn missing(section: &Part) -> Text {
    say!("{section} `{}` is missing", section)
}

fn report(section: &Part, severity: Severity, help: impl Into<Text>) -> Diagnostic {
    Diagnostic::new(&RULE.info, Place::device(), missing(section)).severity(severity).help(help)
}

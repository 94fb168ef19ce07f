//! The object lists, object links and the other standard sections.

use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};

use crate::diagnostic::{At, Change, Diagnostic, Findings, Fix, Severity, Text, counted, say};
use crate::model::{Device, DeviceKind, Field, Object, ObjectList, Part, Place};
use crate::rule::rules;
use crate::{IndexSet, ListFixes, with_members};

rules! {
    source: "CiA 306-1 §4.6.3.1";

    "cia306/disabled-object" = DISABLED_OBJECT, Note, Described(disabled_object);
    summary: "objects are marked as disabled and are not checked",
    checks: "Reports objects that are marked as disabled by the property `CO_disabled` of an XDD or the comment `;CO_disabled=true` of an EDS. CANopenEditor writes these marks.",
    why: "The generators of CANopenNode omit these objects, so the device does not have them. Other tools read them as objects of the device.",
    example: "`;CO_disabled=true` in `[1F80]`",
    remedy: "Remove objects that the device does not have before you publish the description, or remove the mark.",
    source: "CANopenEditor",

    "cia306/link-to-missing-object" = LINK_TO_MISSING_OBJECT, Warning,
        ObjectOf(link_to_missing_object), fix Unsafe;
    summary: "a link refers to a missing object",
    checks: "Each index in `[xxxxObjectLinks]` must be described, and so must object xxxx.",
    why: "Tools show linked objects as a group, which is then incomplete.",
    example: "`1=0x6999` in `[2000ObjectLinks]`, and no `[6999]`",
    remedy: "Correct the index, or remove the link and update the count.",
    source: "CiA 306-1 §4.6.4",

    "cia306/listed-object-missing" = LISTED_OBJECT_MISSING, Error,
        Device(listed_object_missing), fix Mixed, explains Section ["unknown-key"];
    summary: "a list contains an object that is not described",
    checks: "Each index of the three lists must have its section. `CompactPDO` makes no exception: implied PDOs are not listed.",
    why: "Most readers stop at such a list entry or show an object without name and type.",
    example: "`4=0x2000` in a list, and no `[2000]`",
    remedy: "Describe the object, or remove its list entry and update the count.",

    "cia306/missing-section" = MISSING_SECTION, Error,
        Device(missing_section), fix Safe, explains Keys ["unknown-key"];
    summary: "a standard section is missing",
    checks: "The file must contain `[FileInfo]`, `[DeviceInfo]`, `[DummyUsage]`, `[Comments]` and the three object lists. In an EDS, a missing `[FileInfo]` or `[DeviceInfo]` is an error, and so is a missing list of described objects. DCFs get lower severities: tools that write them need not record the author. In real files, mostly DCFs without `[Comments]` or `[FileInfo]` are reported, as a harmless note. The errors are fragments and missing lists, which hide whole ranges of objects. An empty file has its own finding.",
    why: "Objects of a missing list are not listed at all, so most tools do not see them. Without `[DeviceInfo]` the device is unknown. The other sections may be empty, but some readers reject a file without them.",
    example: "A file that starts with `[1000]`",
    remedy: "Add the section. Write `SupportedObjects=0` for an empty list, `Lines=0` for empty comments.",
    source: "CiA 306-1 §4.2",

    "cia306/object-listed-twice" = OBJECT_LISTED_TWICE, Error, Device(object_listed_twice), fix Mixed;
    summary: "an object is listed twice",
    checks: "Each index must be in one list only, and only once.",
    why: "Some tools create two objects, others reject the file.",
    example: "`0x1018` in `[MandatoryObjects]` and in `[OptionalObjects]`",
    remedy: "Remove it from the list that it does not belong to, renumber the following entries and update the count.",

    "cia306/object-not-listed" = OBJECT_NOT_LISTED, Error, Device(object_not_listed), fix Safe;
    summary: "an object is described but not listed",
    checks: "Each object from 1000h on must be in one of the lists, except data type definitions. A missing list has its own finding.",
    why: "Readers that rely on the lists, such as Lely and most C tools, do not see the object.",
    example: "`[2000]`, and `SupportedObjects=0` in `[ManufacturerObjects]`",
    remedy: "Add the index to the list of its range and update the count, or remove the section.",

    "cia306/repeated-link" = REPEATED_LINK, Warning, Object(repeated_link);
    summary: "an object is linked twice",
    checks: "Each object must be linked only once.",
    why: "Tools that show linked objects as a group show the object twice.",
    example: "`1=0x6005` and `2=0x6005` in `[6000ObjectLinks]`",
    remedy: "Remove the link and decrease the count by one.",
    source: "CiA 306-1 §4.6.4",

    "cia306/unsorted-list" = UNSORTED_LIST, Note, Device(unsorted_list), fix Safe;
    summary: "an object list is not in ascending order",
    checks: "The indexes of `[MandatoryObjects]`, `[OptionalObjects]` and `[ManufacturerObjects]` must be in ascending order. An index that is listed twice has its own finding.",
    why: "Readers look up objects in the list, and line-by-line comparisons show moved objects as changes.",
    example: "`1=0x1017` and `2=0x1005` in `[OptionalObjects]`",
    remedy: "Sort the list, for example with `objdict fmt`.",
    source: "Not in a standard",

    "cia306/wrong-object-list" = WRONG_OBJECT_LIST, Warning, Device(wrong_object_list), fix Safe;
    summary: "an object is in the wrong list",
    checks: "1000h, 1001h and 1018h must be in `[MandatoryObjects]`, 2000h to 5FFFh in `[ManufacturerObjects]`, and all other objects in neither. Objects from 6000h on may be mandatory, depending on the device profile. A mandatory object in a different list is an error.",
    why: "Tools derive the category of an object from its list. They reject a device whose mandatory objects are optional and require optional objects that are listed as mandatory.",
    example: "`0x2001` in `[OptionalObjects]`",
    remedy: "Move the entry and update the count of both lists.",
}

fn disabled_object(described: &Device, findings: &mut Findings) {
    let mut disabled = described.objects.iter().filter(|(_, object)| object.is_disabled());
    let Some((&first, _)) = disabled.next() else { return };
    let number = 1 + disabled.count();
    let objects =
        counted(number, "object is marked as disabled and is", "objects are marked as disabled and are");
    let finding = DISABLED_OBJECT.at(Place::object(first), say!("{} not checked", objects));
    findings.push(finding.help("remove the objects before you publish the description"));
}

/// A reader's findings without findings about disabled objects, which the device does not have.
pub fn without_disabled(described: &Device, findings: Findings) -> Findings {
    findings.filter_map(|finding| {
        let index = match finding.labels.first().map(|label| &label.at) {
            Some(At::Place(place)) => place.part.object(),
            _ => None,
        };
        let is_disabled = index.and_then(|index| described.object(index)).is_some_and(Object::is_disabled);
        (!is_disabled).then_some(finding)
    })
}

/// Findings about a device without its disabled objects, with the item numbers of lists as in its description. A list
/// written by a fix would lack the disabled objects, so these findings have no fix.
pub(crate) fn renumbered(described: &Device, findings: Findings) -> Findings {
    let number_of = |list: ObjectList, number: u32| {
        let enabled = (1..)
            .zip(described.lists.get(list))
            .filter(|(_, index)| !described.object(**index).is_some_and(Object::is_disabled));
        let item = usize::try_from(number).ok()?.checked_sub(1)?;
        enabled.map(|(number, _)| number).nth(item)
    };
    findings.filter_map(|mut finding| {
        for label in &mut finding.labels {
            let At::Place(place) = &mut label.at else { continue };
            let Part::List(list) = place.part else { continue };
            finding.fix = None;
            if let Some(Field::Item(number)) = &mut place.field {
                *number = number_of(list, *number).unwrap_or(*number);
            }
        }
        Some(finding)
    })
}

fn listed_object_missing(device: &Device, findings: &mut Findings) {
    if device.objects.is_empty() {
        return nothing_described(device, findings);
    }
    let mut fixes = ListFixes::new();
    for list in ObjectList::ALL {
        let is_described = |index: &u16| device.objects.contains_key(index);
        let described = OnceCell::new();
        for (number, index) in (1..).zip(device.lists.get(list)) {
            if !is_described(index) {
                let place = Place::of(Part::List(list)).field(Field::Item(number));
                let message =
                    say!("{:04X}h is listed, but {section} `{}` is missing", index, Part::Object(*index));
                let finding = LISTED_OBJECT_MISSING.at(place, message);
                let mut finding = finding.help(listed_object_help(device, *index));
                let listed = device.lists.get(list);
                finding.fix = fixes.next(listed, || {
                    let described: &Vec<u16> =
                        described.get_or_init(|| listed.iter().copied().filter(is_described).collect());
                    let fix = Fix::risky("remove all list entries without a description");
                    fix.with(Change::List(list, described.clone()))
                });
                findings.push(finding);
            }
        }
    }
}

/// A hex index without `0x` is read as decimal: `1017` is 03F9h.
fn listed_object_help(device: &Device, index: u16) -> Text {
    match u16::from_str_radix(&index.to_string(), 16) {
        Ok(meant) if meant >= 0x1000 && index < 0x1000 || device.objects.contains_key(&meant) => {
            say!("did you mean `0x{:04X}`? otherwise describe the object, or remove its list entry", meant)
        }
        _ => "describe the object, or remove its list entry".into(),
    }
}

/// One finding for a file that consists of lists only.
fn nothing_described(device: &Device, findings: &mut Findings) {
    let mut listed = device.lists.iter();
    let Some((list, _)) = listed.next() else { return };
    let objects = counted(1 + listed.count(), "object is", "objects are");
    let message = say!("{} listed, but none is described", objects);
    let finding = LISTED_OBJECT_MISSING.at(Place::of(Part::List(list)), message);
    findings.push(finding.help(say!("add {a section} such as `{[1000]}` for each object")));
}

fn missing_section(device: &Device, findings: &mut Findings) {
    if is_empty_file(device) {
        return;
    }
    let is_node = device.kind == DeviceKind::Node;
    let severe = if is_node { Severity::Note } else { Severity::Error };
    let light = if is_node { Severity::Note } else { Severity::Warning };
    // keys before the first section, which another rule reports, probably belong to `FileInfo`
    let headless = device.extra.iter().any(|section| section.name().is_empty());
    if device.file_info.is_none() && !headless {
        findings.push(report_section(&Part::FileInfo, severe, "with the author and the date of the file"));
    }
    if device.device_info.is_none() {
        let severity = if is_node { Severity::Warning } else { Severity::Error };
        findings.push(report_section(
            &Part::DeviceInfo,
            severity,
            "with the vendor, the product and the features of the device",
        ));
    }
    if device.dummy_usage.is_none() {
        let help = "with `Dummy0005=1` for each type that may fill a gap in an RPDO";
        let key = |number| Field::Named(format!("Dummy{number:04X}").into());
        let none = (1..=7).map(|number| (key(number), "0".to_owned())).collect();
        let fix =
            Fix::safe(say!("add the {section} without dummies")).with(Change::Add(Part::DummyUsage, none));
        findings.push(report_section(&Part::DummyUsage, light, help).fix(fix));
    }
    if device.comments.is_none() {
        let none = vec![(Field::Lines, "0".to_owned())];
        let fix =
            Fix::safe(say!("add the {section} without comments")).with(Change::Add(Part::Comments, none));
        findings.push(report_section(&Part::Comments, Severity::Note, say!("with `{Lines=0}`")).fix(fix));
    }
    check_list_sections(device, light, findings);
}

fn check_list_sections(device: &Device, light: Severity, findings: &mut Findings) {
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
                let finding = report_section(&Part::List(list), light, say!("with `{SupportedObjects=0}`"));
                findings.push(finding.fix(fix));
            }
            continue;
        }
        let objects_belong = counted(objects, "object belongs", "objects belong");
        let message = say!("{section} `{}` is missing, but {} in it", list, objects_belong);
        let finding = MISSING_SECTION.at(Place::device(), message);
        findings.push(
            finding.help(say!("add the list of these objects: `{SupportedObjects=1}`, `1=0x1000`")).fix(fix),
        );
    }
}

/// Whether the file is empty, which another rule reports.
fn is_empty_file(device: &Device) -> bool {
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

fn section_is_missing(section: &Part) -> Text {
    say!("{section} `{}` is missing", section)
}

fn report_section(section: &Part, severity: Severity, help: impl Into<Text>) -> Diagnostic {
    let help = say!("add `{}` {}", section.clone(), help.into());
    MISSING_SECTION.at(Place::device(), section_is_missing(section)).severity(severity).help(help)
}

fn object_listed_twice(device: &Device, findings: &mut Findings) {
    let mut seen = IndexSet::new();
    let mut listed = ObjectList::ALL.into_iter().flat_map(|list| device.lists.get(list));
    if listed.all(|&index| seen.insert(index)) {
        return;
    }
    let mut fixes = ListFixes::new();
    let mut first: HashMap<u16, (ObjectList, u32)> = HashMap::new();
    for list in ObjectList::ALL {
        for (number, &index) in (1..).zip(device.lists.get(list)) {
            let (other, at) = *first.entry(index).or_insert((list, number));
            if (other, at) == (list, number) {
                continue;
            }
            let place = |list, number| Place::of(Part::List(list)).field(Field::Item(number));
            let message = if other == list {
                say!("{:04X}h is listed twice in `{}`", index, list)
            } else {
                say!("{:04X}h is listed in `{}` and in `{}`", index, other, list)
            };
            // the position of the edit
            let is_first_wrong = other != list && ObjectList::of(index) == Some(list);
            let (wrong, edited, kept) = match is_first_wrong {
                true => (other, place(other, at), place(list, number)),
                false => (list, place(list, number), place(other, at)),
            };
            let finding = OBJECT_LISTED_TWICE.at(edited, message).label(kept, "also here");
            let mut finding = match other == list {
                true => finding.help("remove the second entry"),
                false => finding.help(say!("remove it from `{}`", wrong)),
            };
            finding.fix = fixes.next(device.lists.get(list), || match other == list {
                true => keep_once(device, list),
                false => remove_from_list(device, wrong, index),
            });
            findings.push(finding);
        }
    }
}

/// Keeps each member of the list once.
fn keep_once(device: &Device, list: ObjectList) -> Fix {
    let mut seen = HashSet::new();
    let members = device.lists.get(list).iter().copied().filter(|&index| seen.insert(index)).collect();
    Fix::safe("remove the repeated entries").with(Change::List(list, members))
}

/// Removes the object from the list that it does not belong to.
fn remove_from_list(device: &Device, wrong: ObjectList, index: u16) -> Fix {
    let members = device.lists.get(wrong).iter().copied().filter(|&member| member != index).collect();
    Fix::risky(say!("remove it from `{}`", wrong)).with(Change::List(wrong, members))
}

fn object_not_listed(device: &Device, findings: &mut Findings) {
    let lists = &device.lists;
    let listed: IndexSet = lists.iter().map(|(_, index)| index).collect();
    let objects = device.objects.range(0x1000..).filter(|(_, object)| !object.orphan);
    let unlisted: Vec<u16> =
        objects.map(|(&index, _)| index).filter(|&index| !listed.contains(index)).collect();
    let mut fixes = ListFixes::new();
    // another rule reports a missing list
    for list in ObjectList::ALL.into_iter().filter(|&list| lists.has(list)) {
        let others = unlisted.iter().copied().filter(|&index| ObjectList::of(index) == Some(list));
        let all = with_members(lists.get(list), others.clone());
        // an unreadable entry may be the missing one
        let has_unread = device.extra.iter().any(|section| {
            section.name() == list.name() && section.entries().any(|(key, _)| Field::item(key).is_some())
        });
        for index in others {
            let message = say!("{:04X}h is described, but not in any object list", index);
            let finding = OBJECT_NOT_LISTED.at(Place::object(index), message);
            let mut finding = finding.help(say!("add `0x{:04X}` to `{}`", index, list));
            finding.fix = fixes.next(&all, || {
                let title = say!("add all described objects to `{}`", list);
                let fix = if has_unread { Fix::risky(title) } else { Fix::safe(title) };
                fix.with(Change::List(list, all.clone()))
            });
            findings.push(finding);
        }
    }
}

fn unsorted_list(device: &Device, findings: &mut Findings) {
    for list in ObjectList::ALL {
        let indexes = device.lists.get(list);
        let Some(at) = indexes.windows(2).position(|pair| pair[0] > pair[1]) else { continue };
        let mut sorted = indexes.to_vec();
        sorted.sort_unstable();
        if sorted.windows(2).any(|pair| pair[0] == pair[1]) {
            continue;
        }
        let (Some(first), Some(second)) = (indexes.get(at), indexes.get(at + 1)) else { continue };
        let message = say!("`{}` lists {:04X}h after {:04X}h", list, second, first);
        let item = u32::try_from(at + 2).unwrap_or(u32::MAX);
        let place = Place::of(Part::List(list)).field(Field::Item(item));
        let fix = Fix::safe("sort the list").with(Change::List(list, sorted));
        findings.push(UNSORTED_LIST.at(place, message).help("sort the list").fix(fix));
    }
}

fn wrong_object_list(device: &Device, findings: &mut Findings) {
    let [mandatory, optional, manufacturer] =
        ObjectList::ALL.map(|list| device.lists.get(list).iter().copied().collect::<IndexSet>());
    let is_in = |index, list| match list {
        ObjectList::Mandatory => mandatory.contains(index),
        ObjectList::Optional => optional.contains(index),
        ObjectList::Manufacturer => manufacturer.contains(index),
    };
    let mut fixes = ListFixes::new();
    for list in ObjectList::ALL {
        for (number, &index) in (1..).zip(device.lists.get(list)) {
            let right = right_list(index, list);
            // another rule reports an object that is also in the right list
            if right != list && !is_in(index, right) {
                let place = Place::of(Part::List(list)).field(Field::Item(number));
                let message = say!("{:04X}h is in `{}`, but belongs in `{!}`", index, list, right);
                let mut finding = WRONG_OBJECT_LIST.at(place, message).help(say!("move it to `{}`", right));
                let members = device.lists.get(list);
                finding.fix = fixes.next(members, || move_to_list(device, list, right, &is_in));
                let missed = right == ObjectList::Mandatory;
                findings.push(if missed { finding.severity(Severity::Error) } else { finding });
            }
        }
    }
}

/// Moves all misplaced objects from one list to the other.
fn move_to_list(
    device: &Device,
    from: ObjectList,
    to: ObjectList,
    is_in: &impl Fn(u16, ObjectList) -> bool,
) -> Fix {
    let belongs = |index: &u16| right_list(*index, from) == to && !is_in(*index, to);
    let (wrong, right): (Vec<u16>, Vec<u16>) =
        device.lists.get(from).iter().partition(|index| belongs(index));
    let members = with_members(device.lists.get(to), wrong);
    let fix = Fix::safe(say!("move all misplaced objects to `{}`", to));
    fix.with(Change::List(from, right)).with(Change::List(to, members))
}

/// The list that an index belongs to; the current list if it is also correct.
fn right_list(index: u16, is: ObjectList) -> ObjectList {
    match index {
        0x1000 | 0x1001 | 0x1018 => ObjectList::Mandatory,
        0x2000..=0x5FFF => ObjectList::Manufacturer,
        0x6000.. if is == ObjectList::Mandatory => is,
        0..=0xFFF => is,
        _ => ObjectList::Optional,
    }
}

fn link_to_missing_object(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if object.links.is_empty() {
        return;
    }
    let section = Place::of(Part::Links(index));
    if object.orphan && object.subs.is_empty() {
        let message = say!("links of {:04X}h are described, but the object is missing", index);
        let fix = Fix::risky(say!("remove the {section}")).remove(section.clone());
        let finding = LINK_TO_MISSING_OBJECT.at(section, message).fix(fix);
        findings.push(
            finding.help(say!("describe the object in `{}`, or remove the {section}", Part::Object(index))),
        );
        return;
    }
    let described = |index: &u16| device.object(*index).is_some_and(|object| !object.orphan);
    for (number, link) in (1..).zip(&object.links).filter(|(_, link)| !described(link)) {
        let message = say!("{:04X}h links to {:04X}h, which is not described", index, link);
        let place = section.clone().field(Field::Item(number));
        let fix = Fix::risky("remove the link").remove(place.clone());
        let finding = LINK_TO_MISSING_OBJECT.at(place, message).fix(fix);
        findings.push(finding.help("correct the index, or remove the link"));
    }
}

fn repeated_link(index: u16, object: &Object, findings: &mut Findings) {
    if object.links.is_empty() {
        return;
    }
    let mut seen = std::collections::HashSet::new();
    for (at, &link) in object.links.iter().enumerate() {
        if seen.insert(link) {
            continue;
        }
        let message = say!("{:04X}h has two links to {:04X}h", index, link);
        let item = u32::try_from(at + 1).unwrap_or(u32::MAX);
        let place = Place::of(Part::Links(index)).field(Field::Item(item));
        findings.push(REPEATED_LINK.at(place, message).help("remove the link and decrease the count by one"));
        return;
    }
}

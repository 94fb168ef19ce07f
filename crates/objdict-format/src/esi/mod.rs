//! EtherCAT slave information (ESI): the CoE dictionaries of devices in `EtherCATInfo` (ETG.2000). Read-only.

mod dictionary;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use self::dictionary::EsiDictionary;
use crate::text::{DescriptionText, ReadText};
use objdict_model::diagnostic::{Diagnostic, Findings, Severity, Text, say, text_rules};
use objdict_model::model::{
    Access, DataType, Device, DeviceInfo, DeviceKind, ETHERCAT_SECTION, Entry, Extra, ExtraSection,
    MappedObject, Object, ObjectLists, ObjectType, Part, PdoMapping, Place, Value,
};
use objdict_model::source::{Folder, SourceFile, SourceOptions, Span};
use objdict_xdd::xdd::Leftovers;
use objdict_xdd::xml::{Element, ElementId, Tree};

/// The elements and attributes that are parsed; the rest is kept.
const KNOWN: &str = " Access AddInfo ArrayInfo Backup BaseType BitLen BitOffs BitSize Category DataType DataTypes DefaultData DefaultString DefaultValue \
    Dictionary DictionaryFile Elements Entry Enum EnumInfo Flags Index Info LBound LcId MaxData MaxValue MinData MinValue Name Object Objects PdoMapping \
    ProductCode Profile ProfileNo RevisionNo RxPdo SubIdx SubIndex SubItem Symbol Text TxPdo Type Unit UnitType UnitTypes ";

/// A file as one of its devices.
#[derive(Debug)]
struct EsiText {
    tree: Arc<Tree>,
    places: BTreeMap<Part, ElementId>,
}

/// A device during reading, and the locations of its objects and entries.
#[derive(Default)]
struct EsiDevice {
    device: Device,
    findings: Findings,
    places: BTreeMap<Part, ElementId>,
}

/// Reads one of the devices of a file, by number from 0.
pub(super) fn read(tree: Arc<Tree>, number: usize, kind: DeviceKind) -> ReadText {
    let mut read = EsiDevice::default();
    if let Some(element) = devices(&tree).nth(number) {
        read.read(&tree, element);
    }
    let modules = tree.root().and_then(|root| root.child("Descriptions")?.child("Modules"));
    if let Some(modules) = modules.filter(|_| number == 0) {
        read.not_read(modules, say!("the objects of modules are not read"));
    }
    (Box::new(EsiText { tree, places: read.places }), Device { kind, ..read.device }, read.findings)
}

/// The devices of a file.
fn devices(tree: &Tree) -> impl Iterator<Item = Element<'_>> {
    let list = tree.root().and_then(|root| root.child("Descriptions")?.child("Devices"));
    list.into_iter().flat_map(|list| list.children_named("Device"))
}

/// The text of an element on one line.
fn line(element: Element<'_>) -> String {
    element.text().split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The text of a child on one line; the English one if there are several; empty if there is none.
fn text(of: Element<'_>, name: &str) -> String {
    let found = of.children_named(name).find(|text| !is_foreign(*text)).or_else(|| of.child(name));
    found.map(line).unwrap_or_default()
}

/// Whether a text is in a language other than English.
fn is_foreign(text: Element<'_>) -> bool {
    text.attribute("LcId").is_some_and(|language| language.value() != "1033")
}

/// A number in ETG.2000 notation: decimal, or hexadecimal after `#x`.
fn number<T: TryFrom<u64>>(text: &str) -> Option<T> {
    let hex = text.strip_prefix("#x").map(|digits| u64::from_str_radix(digits, 16));
    hex.unwrap_or_else(|| text.parse()).ok()?.try_into().ok()
}

/// The content of an element that the model does not support.
fn leftovers(of: Element<'_>) -> Vec<ExtraSection> {
    let (mut leftovers, mut end) = (Leftovers::default(), 0);
    let is_known = |name: &str| KNOWN.contains(&format!(" {name} "));
    // the most common case
    let is_usual = |of: Element<'_>| of.name() == "Setting" && line(of) == "0";
    for part in of.descendants().filter(|part| !is_usual(*part)) {
        if part.span().start >= end && (!is_known(part.name()) || is_foreign(part)) {
            end = part.span().end;
            leftovers.element(part);
        } else if part.span().start >= end {
            let attributes = part.attributes().filter(|attribute| !is_known(attribute.name()));
            attributes.for_each(|attribute| leftovers.attribute(part, attribute));
        }
    }
    leftovers.into_sections()
}

impl EsiDevice {
    fn read(&mut self, tree: &Tree, element: Element<'_>) {
        let mut extra = Extra::default();
        element.attributes().for_each(|of| extra.push(of.name(), &of.value().replace('\n', " ")));
        let vendor = tree.root().and_then(|root| root.child("Vendor"));
        let of_type = |name: &str| number(element.child("Type")?.attribute(name)?.value().trim());
        self.device.device_info = Some(DeviceInfo {
            vendor_name: vendor.map(|vendor| text(vendor, "Name")),
            vendor_number: vendor.and_then(|vendor| number(&text(vendor, "Id"))),
            product_name: Some(text(element, "Name")),
            product_number: of_type("ProductCode"),
            revision_number: of_type("RevisionNo"),
            order_code: Some(text(element, "Type")),
            ..DeviceInfo::default()
        });
        for profile in element.children_named("Profile") {
            ["ProfileNo", "AddInfo"].iter().for_each(|name| extra.push(name, &text(profile, name)));
            profile.children_named("Dictionary").for_each(|of| EsiDictionary::read(of, None, self));
            for named in profile.children_named("DictionaryFile") {
                if self.follow(tree, named).is_none() {
                    let message =
                        say!("the objects of the device are in `{}`, which cannot be read", line(named));
                    let finding =
                        Diagnostic::new(&NOT_READ, named.tag_span(), message).severity(Severity::Error);
                    self.findings.push(finding.help("copy the vendor's file into this file's folder"));
                }
            }
        }
        let pdos = element.children().filter(|child| matches!(child.name(), "RxPdo" | "TxPdo"));
        pdos.for_each(|pdo| self.pdo(pdo));
        self.device.lists = ObjectLists::naming(self.device.objects.keys().copied());
        self.device.extra.push(ExtraSection::new(ETHERCAT_SECTION, &extra));
        self.device.extra.extend(leftovers(element));
    }

    /// Reads the dictionary in another file; `None` if it cannot be read.
    fn follow(&mut self, tree: &Tree, named: Element<'_>) -> Option<()> {
        let path = Folder::of(Path::new(tree.source().name())).resolve(&line(named)).ok()?;
        // the dictionaries of vendors have some hundred kilobytes
        let source = SourceFile::open(&path, &SourceOptions { encoding: None, max_size: 8 << 20 }).ok()?;
        let other = Tree::new(source, &mut Findings::new());
        let mut elements = other.root().into_iter().flat_map(Element::descendants).chain(other.root());
        let dictionary = elements.find(|of| of.child("Objects").is_some())?;
        EsiDictionary::read(dictionary, Some(named), self);
        self.device.extra.extend(leftovers(dictionary));
        Some(())
    }

    /// A PDO: the object with its mapping, or the values that the dictionary does not contain.
    fn pdo(&mut self, pdo: Element<'_>) {
        let index = number::<u16>(&text(pdo, "Index")).unwrap_or(0);
        if !matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) {
            return self
                .not_read(pdo, say!("a PDO has no index from 1600h to 17FFh, or from 1A00h to 1BFFh"));
        }
        let (access, pdo_mapping) = (Some(Access::Ro), Some(PdoMapping::No));
        let entry = |name: String, data_type, value: u32| {
            let (name, default) = (name.into(), Some(Value::Unsigned(value.into())));
            Entry { name, data_type: Some(data_type), access, pdo_mapping, default, ..Entry::default() }
        };
        let mut mapping = Object::default();
        mapping.main.name = text(pdo, "Name").into();
        mapping.main.object_type = Some(ObjectType::Record);
        for (element, count) in pdo.children_named("Entry").zip(1..255) {
            let of: Option<u16> = number(&text(element, "Index"));
            let sub = number(&text(element, "SubIndex")).unwrap_or(0);
            let Some((index, bits)) = of.zip(number(&text(element, "BitLen"))) else {
                return self.not_read(element, say!("an entry of a PDO has no index, or more than 255 bits"));
            };
            let mapped = MappedObject { index, sub, bits }.to_number();
            mapping.subs.insert(count, entry(text(element, "Name"), DataType::UNSIGNED32, mapped));
        }
        let count = mapping.subs.iter().count() as u32;
        mapping.sub_number = Some(count as u8 + 1);
        mapping.subs.insert(0, entry("SubIndex 000".to_owned(), DataType::UNSIGNED8, count));
        self.places.entry(Part::Object(index)).or_insert(pdo.id());
        let object = self.device.objects.get_or_insert_with(index, || mapping.clone());
        let is_it = |(sub, wanted): (u8, &Entry)| {
            let Some(entry) = object.subs.get_mut(sub) else { return false };
            entry.default = entry.default.take().or_else(|| wanted.default.clone());
            entry.default == wanted.default
        };
        if !mapping.subs.iter().all(is_it) {
            self.not_read(pdo, say!("the dictionary's mapping at {:04X}h differs from the PDO", index));
        }
    }

    fn not_read(&mut self, element: Element<'_>, message: Text) {
        let help = "correct the file, or ask the vendor for one that has this part";
        self.findings.push(Diagnostic::new(&NOT_READ, element.tag_span(), message).help(help));
    }
}

impl DescriptionText for EsiText {
    fn source(&self) -> &SourceFile {
        self.tree.source()
    }

    /// The element of an object or of an entry.
    fn locate(&self, place: &Place) -> Option<Span> {
        Some(self.tree.element(*self.places.get(&place.part)?).tag_span())
    }

    fn device_count(&self) -> usize {
        devices(&self.tree).count().max(1)
    }

    fn sibling(&self, number: usize) -> Option<ReadText> {
        devices(&self.tree).nth(number)?;
        Some(read(Arc::clone(&self.tree), number, DeviceKind::Type))
    }

    fn is_project(&self) -> bool {
        true
    }
}

text_rules! {
    "esi/not-read" = NOT_READ, Warning;
    summary: "a part of the file cannot be read",
    checks: "Each object needs an index of its own and types that the file defines. An object's entries and a PDO's mapped entries must match the types. The file that `DictionaryFile` names must exist. Modules are reported because their objects are not read.",
    why: "The part is omitted from all output generated from the device.",
    example: "`<Type>DT2000</Type>` without a `DataType` of this name",
    remedy: "Correct the file, or ask the vendor for one that has the part.",
    source: "ETG.2000",
}

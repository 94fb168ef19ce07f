//! EtherCAT slave information (ESI).

use std::fmt::Write as _;
use std::process::Command;

use objdict::diagnostic::{Findings, Severity};
use objdict::format::input::{FileKind, Input, Reading};
use objdict::format::{Description, Format, WriteOptions, json};
use objdict::model::{
    Access, AllowedValues, DataType, Device, ExtraSection, ObjectType, PdoMapping, Support, Value,
};
use proptest::prelude::*;

use crate::support::{fixtures, skips};

fn read(name: &str, bytes: Vec<u8>) -> Description {
    let (kind, input) = Reading::default().read(name, bytes.clone()).unwrap();
    let Input::Description(description) = input else { panic!("no description") };
    assert_eq!((kind, description.is_project(), description.print()), (FileKind::Esi, true, bytes));
    *description
}

/// The file of the fixtures, with some of its text replaced.
fn press(replaced: &[(&str, &str)]) -> Description {
    let path = fixtures().join("esi/press.xml");
    let mut text = std::fs::read_to_string(&path).unwrap();
    for (old, new) in replaced {
        assert!(text.contains(old), "{old}");
        text = text.replacen(old, new, 1);
    }
    read(path.to_str().unwrap(), text.into_bytes())
}

fn default(device: &Device, index: u16, sub: u8) -> Option<Value> {
    device.entry(index, sub).unwrap().default.clone()
}

fn lines(findings: &Findings) -> Vec<String> {
    findings.iter().map(|found| format!("{} {}", found.rule.id, found.message)).collect()
}

#[test]
fn a_file_is_read() {
    let description = press(&[]);
    assert_eq!((description.device_count(), description.findings().len()), (2, 0));
    let device = description.device();
    let info = device.device_info.as_ref().unwrap();
    assert_eq!(
        (info.vendor_name.as_deref(), info.product_name.as_deref(), info.order_code.as_deref()),
        (Some("Nobody"), Some("Press"), Some("PRESS-2"))
    );
    assert_eq!(
        (info.vendor_number, info.product_number, info.revision_number),
        (Some(0x3F9), Some(0x451), Some(0x1_0002))
    );
    // values of each kind, by the object, its name or the type
    assert_eq!(default(device, 0x1000, 0), Some(Value::Unsigned(0x2_0192)));
    assert_eq!(
        [default(device, 0x1008, 0), default(device, 0x1009, 0)],
        ["Press", "1.0 a"].map(|text| Some(Value::Text(text.into())))
    );
    assert_eq!(
        [default(device, 0x1018, 0), default(device, 0x1018, 2)],
        [4, 1105].map(|number| Some(Value::Unsigned(number)))
    );
    assert_eq!(default(device, 0x2001, 0), Some(Value::Bytes([0, 1, 0xA0, 0xFF].into())));
    let stroke = device.entry(0x2000, 1).unwrap();
    assert_eq!((stroke.access, stroke.pdo_mapping), (Some(Access::Rwr), Some(PdoMapping::Tpdo)));
    assert_eq!(
        (&stroke.default, &stroke.low_limit, &stroke.high_limit),
        (&Some(Value::Signed(-10)), &Some(Value::Signed(-100)), &Some(Value::Signed(100)))
    );
    let unit = |sub| device.entry(0x2000, sub).unwrap().parameter.clone().unwrap().unit.unwrap().labels;
    assert_eq!([unit(1).name_in("en"), unit(3).name_in("en")], [Some("mm"), Some("kN")]);
    // types
    let types = [(0x2000, 3), (0x2000, 4), (0x6060, 0), (0x1C12, 1)];
    let types = types.map(|(index, sub)| device.entry(index, sub).unwrap().data_type.unwrap());
    assert_eq!(types, [DataType::REAL32, DataType::UNSIGNED8, DataType::INTEGER8, DataType::UNSIGNED16]);
    let parameter = |index, sub| device.entry(index, sub).unwrap().parameter.clone().unwrap_or_default();
    let modes = [("0", "none"), ("1", "profile position")];
    assert_eq!(parameter(0x6060, 0).allowed_values, Some(AllowedValues::named(modes)));
    assert_eq!(
        [parameter(0x2000, 1), parameter(0x2000, 3)]
            .map(|parameter| (parameter.support, parameter.persistent)),
        [(Some(Support::Mandatory), Some(true)), (None, None)]
    );
    assert_eq!(device.entry(0x2000, 4).unwrap().extra.get("EtherCATType"), Some("BIT3"));
    let object = |index: u16| (device.objects[&index].name(), device.objects[&index].object_type());
    assert_eq!(
        [object(0x2000), object(0x1C12)],
        [("Axis", ObjectType::Record), ("RxPDO assign", ObjectType::Array)]
    );
    assert_eq!(&*device.entry(0x1C12, 2).unwrap().name, "Second");
    // PDOs: one that the dictionary has without values, and one that it has not
    let mapped = |index, sub| default(device, index, sub).and_then(|value| value.as_integer());
    assert_eq!(
        [mapped(0x1600, 0), mapped(0x1600, 2), mapped(0x1600, 3)],
        [Some(4), Some(0x2000_0320), Some(8)]
    );
    assert_eq!([mapped(0x1A00, 0), mapped(0x1A00, 2)], [Some(2), Some(0x2000_0110)]);
    // what the model has no place for is kept
    let kept: Vec<&str> = device.extra.iter().map(ExtraSection::name).collect();
    for name in ["xml:Mailbox/CoE", "xml:Sm", "xml:Profile/Dictionary/Objects/Object[7]/Comment", "xml:RxPdo"]
    {
        assert!(kept.contains(&name), "{name}: {kept:#?}");
    }
}

#[test]
fn a_dictionary_in_another_file_is_followed() {
    let device = press(&[]).select(1).unwrap();
    assert_eq!(device.findings().len(), 0);
    assert_eq!(default(device.device(), 0x1000, 0), Some(Value::Unsigned(0x1389)));
    assert_eq!(device.device().entry(0x8000, 0).unwrap().access, Some(Access::Rw));
    for name in ["no-such.xml", "/etc/passwd"] {
        let device = press(&[("press-dictionary.xml", name)]).select(1).unwrap();
        let found = device.findings().iter().next().unwrap();
        assert_eq!((found.rule.id, found.severity), ("esi/not-read", Severity::Error), "{name}");
        let span = device.span_of(&found.labels[0].at);
        assert_eq!(span.of(device.source().text()), "<DictionaryFile>", "{name}");
    }
}

/// Python's reading of the same elements.
#[test]
fn python_reads_the_same_entries() {
    if !skips::has("python3", "python3") {
        return;
    }
    let esi = fixtures().join("esi/press.xml");
    let folder = tempfile::tempdir().unwrap();
    for (number, entries) in [("1", 33), ("2", 2)] {
        let written = folder.path().join("device.json");
        let device = press(&[]).select(number.parse::<usize>().unwrap() - 1).unwrap();
        std::fs::write(&written, json::write_device(device.device())).unwrap();
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/library/esi.py");
        let output = Command::new("python3").arg(script).args([&esi, &written]).arg(number).output().unwrap();
        let printed = String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap();
        assert_eq!(printed, format!("{entries} entries, 0 differences\n"));
    }
}

#[test]
fn it_stays_a_device_of_ethercat() {
    let device = press(&[]).into_device();
    for format in [Format::Eds, Format::Xdd] {
        let mut options = WriteOptions::default();
        options.embed = true;
        let written = objdict::format::write(&device, format, &options).unwrap();
        let name = format!("press.{}", format.name().to_lowercase());
        let (_, input) = Reading::default().read(&name, written.bytes.clone()).unwrap();
        let Input::Description(again) = input else { panic!("no description") };
        assert_eq!(again.device().objects, device.objects, "{format:?}");
        // no rule of the communication of CANopen applies, those of the profile do
        let found = lines(&objdict::check(&again));
        assert!(found.iter().all(|line| !line.starts_with("cia301/")), "{found:#?}");
        let mut node = Reading::default();
        node.is_node = true;
        let error = node.read(&name, written.bytes).unwrap_err().to_string();
        assert!(error.contains("it describes an EtherCAT device"), "{error}");
    }
    assert_eq!(lines(&objdict::check(&press(&[]))), [] as [&str; 0]);
    let without = press(&[("<Index>#x6064</Index>", "<Index>#x2064</Index>")]);
    let found = lines(&objdict::check(&without));
    assert!(found.iter().any(|line| line.contains("6064h (Position actual value) is missing")), "{found:#?}");
}

/// What is malformed is a finding with a place.
#[test]
fn what_cannot_be_read_is_found() {
    let wrong = [
        ("<DefaultData>F6FF</DefaultData>", "<DefaultData>F6F</DefaultData>", "invalid-value"),
        ("<DefaultData>F6FF</DefaultData>", "<DefaultData>F6</DefaultData>", "invalid-value"),
        ("<DefaultValue>1105</DefaultValue>", "<DefaultValue>many</DefaultValue>", "invalid-value"),
        ("<MinValue>-100</MinValue>", "<MinValue>-40000</MinValue>", "invalid-value"),
        ("<Access>ro</Access><PdoMapping>T<", "<Access>x</Access><PdoMapping>T<", "invalid-value"),
        ("<Access>rw</Access><PdoMapping>R<", "<Access>rw</Access><PdoMapping>S<", "invalid-value"),
        ("<Type>DT2000</Type>", "<Type>DT2001</Type>", "not-read"),
        ("<Index>#x6041</Index>\n", "<Index>#x6040</Index>\n", "not-read"),
        ("<Index>#x6041</Index>\n", "<Index>#x16041</Index>\n", "not-read"),
        ("<SubIdx>3</SubIdx><Name>Force", "<SubIdx>1</SubIdx><Name>Force", "not-read"),
        ("<Elements>2</Elements>", "<Elements>9999999999</Elements>", "not-read"),
        ("<BaseType>SINT</BaseType>", "<BaseType>DT_MODE</BaseType>", "not-read"),
        ("<SubItem><Name>Product code</Name><Info>", "<SubItem><Name>Product</Name><Info>", "not-read"),
        ("<BitLen>32</BitLen>", "<BitLen>320</BitLen>", "not-read"),
        ("<Index>#x1A00</Index>", "<Index>#x1C00</Index>", "not-read"),
    ];
    for (old, new, rule) in wrong {
        let description = press(&[(old, new)]);
        let findings = objdict::check(&description);
        let found = findings.iter().find(|found| found.rule.id.ends_with(rule));
        let found = found.unwrap_or_else(|| panic!("{new}: {:#?}", lines(&findings)));
        assert!(description.span_of(&found.labels[0].at).start > 100, "{new}");
    }
}

/// Few objects whose type has many entries, and types in a circle.
#[test]
fn hostile_files_take_little() {
    let mut objects = String::new();
    for index in 1..3000 {
        let _ = write!(objects, "<Object><Index>{index}</Index><Type>A</Type></Object>");
    }
    let circle = "<DataType><Name>B</Name><BaseType>C</BaseType></DataType><DataType><Name>C</Name><BaseType>B</BaseType></DataType>";
    let text = format!(
        "<EtherCATInfo><Descriptions><Devices><Device><Profile><Dictionary><DataTypes>{circle}<DataType><Name>A</Name><BaseType>BYTE\
         </BaseType><ArrayInfo><LBound>1</LBound><Elements>254</Elements></ArrayInfo></DataType></DataTypes><Objects><Object><Index>\
         9999</Index><Type>B</Type></Object>{objects}</Objects></Dictionary></Profile></Device></Devices></Descriptions></EtherCATInfo>"
    );
    let description = read("x.xml", text.into_bytes());
    let entries: usize = description.device().objects.values().map(|object| object.subs.iter().count()).sum();
    assert!((20_000..250_000).contains(&entries), "{entries}");
    let found = lines(description.findings());
    assert!(found.iter().any(|line| line.contains("too many entries")), "{found:?}");
    assert!(found.iter().any(|line| line.contains("unknown data type `B`")), "{found:?}");
    // few types whose values have many names
    let names = "<EnumInfo><Text>on</Text><Enum>1</Enum></EnumInfo>".repeat(3000);
    let text = format!(
        "<EtherCATInfo><Descriptions><Devices><Device><Profile><Dictionary><DataTypes><DataType><Name>A</Name><BaseType>BYTE</BaseType>\
         {names}</DataType></DataTypes><Objects>{objects}</Objects></Dictionary></Profile></Device></Devices></Descriptions></EtherCATInfo>"
    );
    let found = lines(read("x.xml", text.into_bytes()).findings());
    assert!(found.iter().any(|line| line.contains("too many entries")), "{found:?}");
}

proptest! {
    /// Parts that are cut out, doubled or overwritten.
    #[test]
    fn broken_files_are_read_as_far_as_possible(
        start in 0usize..14_000, length in 0usize..400, repeat in 0usize..3, byte in any::<u8>(), is_written in any::<bool>(),
    ) {
        let mut bytes = std::fs::read(fixtures().join("esi/press.xml")).unwrap();
        let (start, end) = (start.min(bytes.len()), (start + length).min(bytes.len()));
        let part = if is_written { vec![byte] } else { bytes[start..end].repeat(repeat) };
        bytes.splice(start..end, part);
        let mut options = Reading::default();
        options.from = Some(FileKind::Esi);
        if let Ok((_, Input::Description(description))) = options.read("x.xml", bytes) {
            for device in description.map_devices(|device| device.device().clone()) {
                let written = objdict::format::write(&device, Format::Eds, &WriteOptions::default()).unwrap();
                let mut eds = Reading::default();
                eds.from = Some(FileKind::Eds);
                prop_assert!(eds.read("x.eds", written.bytes).is_ok());
            }
            objdict::check(&description);
        }
    }
}

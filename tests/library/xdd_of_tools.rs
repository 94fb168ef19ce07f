//! What CANopenEditor and CANopenNode write into an XDD, which CiA 311 leaves open, and the projects of CANopenNode.

use objdict::format::input::{FileKind, Input, Reading};
use objdict::format::{Format, XddVersion};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Part, Value};

use crate::support;
use crate::xdd::{at, only_entry, read, with_objects, write};

/// The XDD of a device with these objects and parameters, from lamp.xdd.
fn lamp(objects: &str, parameters: &str) -> Device {
    let base = std::fs::read_to_string(support::fixtures().join("bases/lamp.xdd")).unwrap();
    let text = base.replace("</CANopenObjectList>", &format!("{objects}</CANopenObjectList>"));
    let process = format!(
        "<ApplicationProcess><parameterList>{parameters}</parameterList></ApplicationProcess></ProfileBody>"
    );
    read(&text.replacen("</ProfileBody>", &process, 1), Format::Xdd).into_device()
}

#[test]
fn elements_without_a_type_inherit_that_of_their_array() {
    let device = lamp(
        r#"<CANopenObject index="1016" name="Times" objectType="8" dataType="0007" accessType="rw">
            <CANopenSubObject subIndex="00" name="Count" objectType="7" dataType="0000" accessType="ro" defaultValue="1"/>
            <CANopenSubObject subIndex="01" name="First" objectType="7" dataType="0000" accessType="rw" defaultValue="0x10"/>
            <CANopenSubObject subIndex="02" name="Other" objectType="7" accessType="rw" defaultValue="1"/>
        </CANopenObject><CANopenObject index="2001" name="None" objectType="7" dataType="0000" accessType="rw"/>"#,
        "",
    );
    let entry = |sub| device.entry(0x1016, sub).unwrap();
    assert_eq!(entry(0).data_type, Some(DataType::UNSIGNED8));
    assert_eq!(
        (entry(1).data_type, &entry(1).default),
        (Some(DataType::UNSIGNED32), &Some(Value::Unsigned(16)))
    );
    assert_eq!(entry(2).data_type, None);
    assert_eq!(only_entry(&device, 0x2001).data_type, None);
}

#[test]
fn the_mapping_decides_between_input_and_output() {
    let device = lamp(
        r#"<CANopenObject index="2001" name="Out" objectType="7" PDOmapping="RPDO" uniqueIDRef="A"/>
           <CANopenObject index="2002" name="In" objectType="7" accessType="rw" PDOmapping="TPDO" uniqueIDRef="B"/>
           <CANopenObject index="2003" name="Both" objectType="7" PDOmapping="optional" uniqueIDRef="C"/>"#,
        r#"<parameter uniqueID="A" access="readWriteInput"><label lang="en">Out</label><UINT/></parameter>
           <parameter uniqueID="B" access="readWriteOutput"><label lang="en">In</label><UINT/></parameter>
           <parameter uniqueID="C" access="readWriteInput"><label lang="en">Both</label><UINT/></parameter>"#,
    );
    let access = |index| only_entry(&device, index).access;
    assert_eq!(
        [access(0x2001), access(0x2002), access(0x2003)],
        [Some(Access::Rww), Some(Access::Rwr), Some(Access::Rwr)]
    );
    let text = write(&device, XddVersion::V1_1);
    assert_eq!(text.matches("readWriteOutput").count(), 1, "{text}");
}

#[test]
fn ranges_with_steps_and_several_ranges_give_limits() {
    let device = lamp(
        r#"<CANopenObject index="2001" name="Step" objectType="7" uniqueIDRef="A"/>
           <CANopenObject index="2002" name="Two" objectType="7" uniqueIDRef="B"/>"#,
        r#"<parameter uniqueID="A" access="readWrite"><label lang="en">Step</label><INT/><allowedValues>
             <range><minValue value="-10"/><maxValue value="10"/><step value="5"/></range></allowedValues></parameter>
           <parameter uniqueID="B" access="readWrite"><label lang="en">Two</label><INT/><allowedValues>
             <range><minValue value="20"/><maxValue value="30"/></range>
             <range><minValue value="-9"/><maxValue value="0x0A"/></range></allowedValues></parameter>"#,
    );
    for (index, low, high) in [(0x2001, -10, 10), (0x2002, -9, 30)] {
        let entry = only_entry(&device, index);
        let limits = (&entry.low_limit, &entry.high_limit);
        assert_eq!(limits, (&Some(Value::Signed(low)), &Some(Value::Signed(high))));
        // the steps and the gap have no other place
        assert!(entry.parameter.as_ref().unwrap().allowed_values.is_some());
    }
    let again = read(&write(&device, XddVersion::V1_1), Format::Xdd).into_device();
    assert_eq!(again.objects, device.objects);
}

#[test]
fn bytes_are_written_with_blanks_and_read_in_every_spelling() {
    let entry = |text: &str| {
        let object = format!(
            r#"<CANopenObject index="2001" name="Key" objectType="7" dataType="000A" accessType="rw" defaultValue="{text}"/>"#
        );
        lamp(&object, "")
    };
    let bytes = Some(Value::Bytes([1, 0xA1, 0].into()));
    for text in ["01 A1 00", "01A100", "0x01A100", " 01 a1 00 "] {
        assert_eq!(only_entry(&entry(text), 0x2001).default, bytes, "{text}");
    }
    assert!(write(&entry("01A100"), XddVersion::V1_1).contains(r#"defaultValue="01 A1 00""#));
}

#[test]
fn a_domain_says_what_it_is() {
    let domain = r#"<CANopenObject index="2001" name="Program" objectType="2" uniqueIDRef="A"/>"#;
    let device = lamp(domain, r#"<parameter uniqueID="A"><label lang="en">Program</label></parameter>"#);
    assert_eq!(only_entry(&device, 0x2001).access, Some(Access::Rw));
    let main = Entry { object_type: Some(ObjectType::Domain), ..Entry::default() };
    let device = with_objects(vec![(0x2001, Object { main, ..Object::default() })]);
    let text = write(&device, XddVersion::V1_0);
    assert!(text.contains(r#"objectType="2" dataType="000F" accessType="rw""#), "{text}");
}

#[test]
fn projects_of_canopennode_are_read() {
    let bytes = std::fs::read(support::fixtures().join("cnxml/lamp.xml")).unwrap();
    let (kind, input) = Reading::default().read("lamp.xml", bytes.clone()).unwrap();
    let Input::Description(description) = input else { panic!("no description") };
    assert_eq!((kind, description.is_project(), description.print()), (FileKind::CanopenNode, true, bytes));
    let device = description.described();
    let heartbeat = device.entry(0x1016, 1).unwrap();
    assert_eq!(
        (heartbeat.data_type, &heartbeat.default),
        (Some(DataType::UNSIGNED32), &Some(Value::Unsigned(0x50064)))
    );
    let second = device.entry(0x1016, 2).unwrap();
    assert_eq!((second.data_type, second.access), (Some(DataType::UNSIGNED32), Some(Access::Rw)));
    assert_eq!(device.objects[&0x1018].main.object_type, Some(ObjectType::Record));
    assert_eq!(
        (only_entry(device, 0x1008).access, device.objects[&0x1008].sub_number),
        (Some(Access::Const), None)
    );
    let level = only_entry(device, 0x2110);
    assert_eq!(
        (&level.low_limit, &level.high_limit),
        (&Some(Value::Signed(-100)), &Some(Value::Signed(100)))
    );
    assert_eq!(only_entry(device, 0x2111).default, Some(Value::Bytes([0, 1, 0xA0].into())));
    let register = only_entry(device, 0x1001).stack.as_deref().unwrap();
    assert_eq!((register.storage_group.as_deref(), register.detects_change), (Some("RAM"), Some(true)));
    assert_eq!(only_entry(device, 0x1005).stack.as_ref().unwrap().disabled, Some(true));
    let labels = &only_entry(device, 0x1000).parameter.as_ref().unwrap().labels;
    assert!(labels.description_in("en").unwrap().starts_with("Bits 0 to 15: device profile"));
    let (file, info) = (device.file_info.as_ref().unwrap(), device.device_info.as_ref().unwrap());
    assert_eq!(file.creation_date.unwrap().to_iso(), "2017-01-31");
    assert_eq!(file.creation_time.unwrap().to_iso(false), "17:13");
    assert_eq!((file.file_revision, file.modified_by.as_deref()), (Some(4), Some("Bob")));
    assert_eq!(info.baud_rates.supported().collect::<Vec<_>>(), [125, 1000]);
    assert_eq!(
        (info.vendor_number, info.simple_boot_up_slave, info.granularity),
        (Some(0x3F9), Some(true), Some(8))
    );
    let dummies = device.dummy_usage.as_ref().unwrap();
    assert_eq!(dummies.types.values().collect::<Vec<_>>(), [&false, &true]);
    assert_eq!(at(&description, Part::Object(0x2110), "LowLimit"), "-100");
}

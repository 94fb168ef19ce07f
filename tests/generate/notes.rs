//! Whatever a table cannot express is named in a note with its place, or generation fails.

use objdict::generate::{GenerateError, Generated, Options, Target, generate};
use objdict::model::{
    Access, DataType, Device, Entry, Field, Object, ObjectType, Reason, StackOptions, Value,
};

use crate::odd;

fn with(main: Entry) -> Device {
    let mut device = Device::default();
    device.objects.insert(0x2000, Object { main, ..Object::default() });
    // ensures that there is something to generate
    let main = Entry { data_type: Some(DataType::UNSIGNED8), access: Some(Access::Ro), ..Entry::default() };
    device.objects.insert(0x2001, Object { main, ..Object::default() });
    device
}

fn byte() -> Entry {
    Entry {
        name: "Byte".into(),
        data_type: Some(DataType::UNSIGNED8),
        access: Some(Access::Rw),
        ..Entry::default()
    }
}

fn run(device: &Device) -> Result<Generated, GenerateError> {
    let [rust, c] =
        ["rust", "c"].map(|name| generate(device, Target::named(name).unwrap(), &Options::default()));
    match (&rust, &c) {
        (Ok(rust), Ok(c)) => assert_eq!(rust.notes, c.notes),
        (Err(rust), Err(c)) => assert_eq!(rust.to_string(), c.to_string()),
        _ => panic!("{rust:?}, {c:?}"),
    }
    rust
}

fn notes(device: &Device) -> Vec<String> {
    run(device).unwrap().notes.iter().map(ToString::to_string).collect()
}

fn error(device: &Device) -> String {
    run(device).unwrap_err().to_string()
}

#[test]
fn a_plain_entry_needs_no_note() {
    assert!(notes(&with(byte())).is_empty());
}

#[test]
fn what_the_description_says_to_a_stack_holds_here_too() {
    let stack =
        |options: StackOptions| Entry { name: "Zyklop".into(), stack: Some(Box::new(options)), ..byte() };
    let disabled = with(stack(StackOptions { disabled: Some(true), ..StackOptions::default() }));
    assert_eq!(notes(&disabled), [""; 0], "a disabled object does not exist");
    let code = |device: &Device| {
        run(device).unwrap().files.into_iter().map(|file| file.contents).collect::<Vec<_>>()
    };
    assert!(!code(&disabled).iter().any(|code| String::from_utf8_lossy(code).contains("Zyklop")));
    let enabled = with(stack(StackOptions { disabled: Some(false), ..StackOptions::default() }));
    assert_eq!(notes(&enabled), [""; 0]);
    assert!(code(&enabled).iter().any(|code| String::from_utf8_lossy(code).contains("Zyklop")));
    let room = stack(StackOptions { min_string_length: Some(77), ..StackOptions::default() });
    let room = with(Entry { data_type: Some(DataType::VISIBLE_STRING), ..room });
    assert!(code(&room).iter().any(|code| String::from_utf8_lossy(code).contains("MAX_SIZE: usize = 77;")));
}

#[test]
fn what_is_left_out_is_named() {
    for (entry, expected) in [
        (
            Entry { data_type: None, ..byte() },
            "0x2000sub0 / DataType: an entry without a data type is omitted",
        ),
        (
            Entry { data_type: Some(DataType(0x300)), ..byte() },
            "0x2000sub0 / DataType: the length of the data type `0300h` is unknown; the entry is omitted",
        ),
        (
            Entry { object_type: Some(ObjectType::Null), ..byte() },
            "0x2000sub0: an object of type NULL has no data and is omitted",
        ),
        (
            Entry { object_type: Some(ObjectType::Record), ..byte() },
            "0x2000: an object without entries is omitted",
        ),
        (
            Entry { data_type: Some(DataType::DOMAIN), ..byte() },
            "0x2000sub0: a DOMAIN without a default has no memory in the table",
        ),
    ] {
        assert_eq!(notes(&with(entry)), [expected]);
    }
}

/// An OCTET_STRING that is plainly a text has its characters.
#[test]
fn octets_in_letters_are_characters() {
    let mut entry = Entry { data_type: Some(DataType::OCTET_STRING), ..byte() };
    entry.invalid_values.push(Field::DefaultValue, "Motor", Reason::NotHexBytes);
    let device = with(entry);
    let note = "0x2000sub0 / DefaultValue: `Motor` is not a valid OCTET_STRING; it is read as 4D6F746F72";
    assert_eq!(notes(&device), [note]);
    let generated = generate(&device, Target::named("canopennode").unwrap(), &Options::default()).unwrap();
    let tables = String::from_utf8(generated.files[1].contents.clone()).unwrap();
    assert!(tables.contains("{0x4D, 0x6F, 0x74, 0x6F, 0x72}"), "{tables}");
}

/// The type and the access that the standard has for an entry.
#[test]
fn the_standard_fills_gaps() {
    let gap = Entry { data_type: None, access: None, default: Some(Value::Raw("0x12345".into())), ..byte() };
    let mut device = Device::default();
    device.objects.insert(0x1006, Object { main: gap, ..Object::default() });
    assert_eq!(
        notes(&device),
        [
            "0x1006 / DataType: an entry without a data type; the standard has UNSIGNED32",
            "0x1006 / AccessType: an entry without an access type; the standard has `rw`",
        ]
    );
    let code = run(&device).unwrap().files.remove(0).contents;
    let code = String::from_utf8_lossy(&code);
    assert!(code.contains("Handle<u32, Rw>") && code.contains("0x45, 0x23, 0x01"), "{code}");
}

/// The COB-IDs that the standard has for the default SDO server: with 0, stacks answer no SDO.
#[test]
fn the_default_sdo_server_has_cob_ids() {
    let cob_id = || Entry { data_type: Some(DataType::UNSIGNED32), access: Some(Access::Ro), ..byte() };
    let mut device = Device::default();
    let main = Entry { object_type: Some(ObjectType::Record), ..byte() };
    let subs = [(1, cob_id()), (2, cob_id())].into_iter().collect();
    device.objects.insert(0x1200, Object { main, subs, ..Object::default() });
    assert_eq!(
        notes(&device),
        [
            "0x1200sub1 / DefaultValue: an entry without a default; the standard has `$NODEID+0x600`",
            "0x1200sub2 / DefaultValue: an entry without a default; the standard has `$NODEID+0x580`",
        ]
    );
}

#[test]
fn what_is_assumed_is_named() {
    let invalid = |field: Field, text: &str| {
        let mut entry = byte();
        entry.invalid_values.push(field, text, Reason::Malformed);
        entry
    };
    for (entry, expected) in [
        (
            Entry { access: None, ..byte() },
            "0x2000sub0 / AccessType: an entry without an access type is assumed to be `ro`",
        ),
        (
            Entry { access: None, ..invalid(Field::AccessType, "rx") },
            "0x2000sub0 / AccessType: `rx` is not an access type; it is assumed to be `ro`",
        ),
        (
            invalid(Field::DefaultValue, "256"),
            "0x2000sub0 / DefaultValue: `256` is not a valid UNSIGNED8; zero or empty is used",
        ),
        (
            Entry { default: Some(Value::Unsigned(1)), ..invalid(Field::ParameterValue, "x") },
            "0x2000sub0 / ParameterValue: `x` is not a valid UNSIGNED8; the default is used, or zero or empty without one",
        ),
        (
            invalid(Field::HighLimit, "high"),
            "0x2000sub0 / HighLimit: `high` is not a valid UNSIGNED8; the limit is not enforced",
        ),
        (
            Entry {
                data_type: Some(DataType::VISIBLE_STRING),
                low_limit: Some(Value::Text("a".into())),
                ..byte()
            },
            "0x2000sub0 / LowLimit: values of VISIBLE_STRING are not ordered; the limit is not enforced",
        ),
        (
            Entry { data_type: Some(DataType::REAL32), high_limit: Some(Value::Real32(f32::NAN)), ..byte() },
            "0x2000sub0 / HighLimit: a limit that is not a number is not enforced",
        ),
    ] {
        assert_eq!(notes(&with(entry)), [expected]);
    }
}

#[test]
fn a_configured_value_makes_a_bad_default_harmless() {
    let mut entry = byte();
    entry.invalid_values.push(Field::DefaultValue, "256", Reason::Malformed);
    entry.configured_mut().value = Some(Value::Unsigned(7));
    assert!(notes(&with(entry)).is_empty());
}

#[test]
fn what_would_come_out_wrong_is_refused() {
    let formula = Value::NodeId(129);
    for (entry, expected) in [
        (
            Entry { default: Some(formula.clone()), ..byte() },
            "0x2000sub0 / DefaultValue: `$NODEID+0x81` does not fit UNSIGNED8 for every node-ID up to 127",
        ),
        (
            Entry { low_limit: Some(formula.clone()), ..byte() },
            "0x2000sub0 / LowLimit: `$NODEID+0x81` does not fit UNSIGNED8 for every node-ID up to 127",
        ),
        (
            Entry { default: Some(formula), data_type: Some(DataType::REAL32), ..byte() },
            "0x2000sub0 / DefaultValue: `$NODEID+0x81` does not fit REAL32 for every node-ID up to 127",
        ),
        (
            Entry { default: Some(Value::Unsigned(256)), ..byte() },
            "0x2000sub0 / DefaultValue: `256` is not a valid UNSIGNED8",
        ),
        (
            Entry {
                default: Some(Value::Bytes(vec![0; 65_536].into())),
                data_type: Some(DataType::DOMAIN),
                ..byte()
            },
            "0x2000sub0 / DefaultValue: the value has 65536 bytes, but a table supports at most 65535",
        ),
    ] {
        assert_eq!(error(&with(entry)), expected);
    }
}

#[test]
fn a_device_without_entries_is_refused() {
    assert_eq!(error(&Device::default()), "the device has no entries");
}

#[test]
fn notes_about_entries_of_one_object_are_one() {
    let mut device = odd::device();
    let domain = Entry { data_type: Some(DataType::DOMAIN), ..byte() };
    let subs = (1..=9).map(|sub| (sub, domain.clone())).collect();
    let main = Entry { object_type: Some(ObjectType::Array), ..byte() };
    device.objects.insert(0x4000, Object { main, subs, ..Object::default() });
    insta::assert_snapshot!("odd_notes", notes(&device).join("\n"));
}

#[test]
fn implied_pdos_are_one_note_on_every_target() {
    let device = crate::device(&crate::support::fixtures().join("eds/compact.eds"));
    let expected = format!(
        "`CompactPDO` implies {} PDOs without objects, so no table has them; `--implicit-pdos` adds the objects",
        device.implicit_pdos().len()
    );
    let mut options = Options::default();
    options.node_id = Some(5);
    for target in Target::all().filter(|target| target.name() != "template") {
        let of = |device: &Device| {
            let notes = generate(device, target, &options).unwrap().notes;
            notes
                .into_iter()
                .filter(|note| note.message.contains("CompactPDO"))
                .map(|note| note.message)
                .collect::<Vec<_>>()
        };
        assert_eq!(of(&device), std::slice::from_ref(&expected), "{}", target.name());
        assert_eq!(of(&device.with_implicit_pdos()), [""; 0], "{}", target.name());
    }
}

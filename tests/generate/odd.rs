//! A device with everything that no fixture has.

use objdict::model::{
    Access, Compact, DataType, Device, DeviceInfo, Entry, Object, ObjectType, PdoMapping, Time, Value,
};

pub(crate) fn entry(name: &str, data_type: DataType, access: Access, default: Option<Value>) -> Entry {
    Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(access),
        default,
        ..Entry::default()
    }
}

pub(crate) fn var(main: Entry) -> Object {
    Object { main, ..Object::default() }
}

pub(crate) fn of_type(
    object_type: ObjectType,
    name: &str,
    subs: impl IntoIterator<Item = (u8, Entry)>,
) -> Object {
    let main = Entry { name: name.into(), object_type: Some(object_type), ..Entry::default() };
    Object { main, subs: subs.into_iter().collect(), ..Object::default() }
}

fn limited(entry: Entry, low: Option<Value>, high: Option<Value>) -> Entry {
    Entry { low_limit: low, high_limit: high, ..entry }
}

/// A device with constant values only.
pub(crate) fn constant() -> Device {
    let mut device = Device::default();
    let byte = entry("Byte", DataType::UNSIGNED8, Access::Const, Some(Value::NodeId(3)));
    device.objects.insert(0x2000, var(byte));
    device
}

/// The device.
pub(crate) fn device() -> Device {
    let mut device = Device {
        device_info: Some(DeviceInfo {
            vendor_name: Some("*/ #error \u{202E}\n#error ??/\n".to_owned()),
            product_name: Some("`\n}\" \\".to_owned()),
            ..DeviceInfo::default()
        }),
        ..Device::default()
    };
    let mut put = |index: u16, object: Object| assert!(device.objects.insert(index, object).is_none());
    definitions(&mut put);
    formulas(&mut put);
    limits(&mut put);
    arrays(&mut put);
    mappings(&mut put);
    names(&mut put);
    device
}

/// Device-specific types and entries that use them.
fn definitions(put: &mut impl FnMut(u16, Object)) {
    let length = |bits| entry("Length", DataType::UNSIGNED32, Access::Ro, Some(Value::Unsigned(bits)));
    let definition = |bits| Entry { object_type: Some(ObjectType::DefType), ..length(bits) };
    put(0x60, var(definition(8)));
    put(0x61, var(Entry { data_type: None, access: None, ..definition(20) }));
    let member = |data_type: DataType| Entry {
        default: Some(Value::Unsigned(u64::from(data_type.0))),
        ..Entry::default()
    };
    put(
        0x40,
        of_type(
            ObjectType::DefStruct,
            "Structure",
            [
                (0, Entry { default: Some(Value::Unsigned(1)), ..Entry::default() }),
                (1, member(DataType::UNSIGNED16)),
            ],
        ),
    );
    let own = |data_type, access, text: &str| {
        entry("Own type", DataType(data_type), access, Some(Value::Raw(text.into())))
    };
    put(0x3000, var(own(0x60, Access::Rw, "50")));
    put(0x3001, var(own(0x61, Access::Rw, "0x012345")));
    put(0x3002, var(own(0x61, Access::Const, "7")));
    put(0x3003, var(own(0x61, Access::Rw, "0x12345678"))); // does not fit
    put(0x3004, var(entry("No default", DataType(0x61), Access::Wo, None)));
    put(0x3005, var(own(0x62, Access::Rw, "1"))); // not defined: not in the table
    put(0x3006, of_type(ObjectType::Array, "Array", (1..=3).map(|sub| (sub, own(0x61, Access::Rw, "9")))));
    put(0x3007, var(Entry { object_type: Some(ObjectType::Null), ..own(0x60, Access::Rw, "1") }));
    put(0x3008, of_type(ObjectType::Record, "Nothing in it", []));
}

/// Formulas as defaults and limits, for entries in RAM and in flash.
fn formulas(put: &mut impl FnMut(u16, Object)) {
    let formula = |offset| Some(Value::NodeId(offset));
    put(0x3100, var(entry("In flash", DataType::UNSIGNED32, Access::Const, formula(0x180))));
    put(0x3101, var(entry("Short in flash", DataType::UNSIGNED8, Access::Const, formula(0x80))));
    put(0x3102, var(entry("Signed", DataType::INTEGER24, Access::Rw, formula(0x7F_FF00))));
    put(0x3103, var(entry("Long", DataType::UNSIGNED64, Access::Ro, formula(u64::MAX - 127))));
    let word = |default| entry("Limited", DataType::UNSIGNED16, Access::Rw, default);
    put(0x3104, var(limited(word(formula(0x180)), formula(0x180), formula(0x190))));
    put(0x3105, var(limited(word(None), None, formula(0))));
    put(0x3106, var(limited(word(formula(1)), formula(0), Some(Value::Unsigned(200)))));
    let sub = |offset| entry("Element", DataType::UNSIGNED32, Access::Rw, formula(offset));
    put(0x3107, of_type(ObjectType::Array, "Elements", [(1, sub(0)), (2, sub(0x8000_0000)), (3, sub(7))]));
}

/// One or both limits for every kind of number; contradictory limits.
fn limits(put: &mut impl FnMut(u16, Object)) {
    let mut index = 0x3200;
    let mut next = |entry: Entry| {
        put(index, var(entry));
        index += 1;
    };
    let signed = |number| Some(Value::Signed(number));
    for data_type in [DataType::INTEGER8, DataType::INTEGER24, DataType::INTEGER40, DataType::INTEGER64] {
        let plain = entry("Signed", data_type, Access::Rw, signed(-3));
        next(limited(plain.clone(), signed(-5), None));
        next(limited(plain.clone(), None, signed(-1)));
        next(limited(plain.clone(), signed(3), signed(-3)));
        next(limited(plain, signed(-100), signed(100)));
    }
    let real = |number: f32| Some(Value::Real32(number));
    let plain = entry("Short real", DataType::REAL32, Access::Rw, real(0.0));
    next(limited(plain.clone(), real(0.0), None));
    next(limited(plain.clone(), None, real(-0.0)));
    next(limited(plain.clone(), real(-1.5), real(1.5)));
    next(limited(plain.clone(), real(f32::NEG_INFINITY), real(f32::MAX)));
    next(limited(plain, real(1.0), real(2.0)));
    let real = |number: f64| Some(Value::Real64(number));
    let plain = entry("Long real", DataType::REAL64, Access::Rww, real(std::f64::consts::PI));
    next(limited(plain.clone(), real(-1e300), real(1e-300)));
    next(limited(plain, None, real(f64::INFINITY)));
    for number in [f64::NAN, f64::NEG_INFINITY, std::f64::consts::E, 1e21, 123_456.789_012] {
        next(entry("Real", DataType::REAL64, Access::Rw, real(number)));
    }
    let truth = |truth| Some(Value::Boolean(truth));
    next(limited(entry("Always true", DataType::BOOLEAN, Access::Rw, truth(true)), truth(true), None));
    next(limited(entry("Always false", DataType::BOOLEAN, Access::Rw, None), None, truth(false)));
}

/// Arrays with gaps, of mixed shapes, with sub-index FFh, of strings and times; compact storage.
fn arrays(put: &mut impl FnMut(u16, Object)) {
    let text =
        |text: &str| entry("Text", DataType::VISIBLE_STRING, Access::Rw, Some(Value::Text(text.into())));
    put(
        0x3300,
        of_type(ObjectType::Array, "Texts", [(1, text("a")), (2, text("")), (3, text("c\"\\\n\u{e9}"))]),
    );
    put(0x3301, of_type(ObjectType::Array, "Rooms", [(1, text(&"x".repeat(40))), (2, text("short"))]));
    let byte = |access| entry("Byte", DataType::UNSIGNED8, access, Some(Value::Unsigned(7)));
    put(0x3302, of_type(ObjectType::Array, "Gap", [(1, byte(Access::Rw)), (3, byte(Access::Rw))]));
    put(0x3303, of_type(ObjectType::Array, "Constant", [(1, byte(Access::Rw)), (2, byte(Access::Const))]));
    put(0x3304, of_type(ObjectType::Array, "All", (0..=0xFF).map(|sub| (sub, byte(Access::Rw)))));
    put(0x3305, of_type(ObjectType::Record, "Ends", [(0, byte(Access::Ro)), (0xFF, byte(Access::Rw))]));
    let time = Value::Time(Time { days: 0xFFFF, milliseconds: 86_399_999 });
    let time = entry("Time", DataType::TIME_OF_DAY, Access::Rw, Some(time));
    put(
        0x3306,
        of_type(ObjectType::Array, "Times", [(1, time.clone()), (2, Entry { default: None, ..time })]),
    );
    let wide = Some(Value::Text("\u{1F600}\u{0}é".into()));
    put(0x3307, var(entry("Wide", DataType::UNICODE_STRING, Access::Rww, wide.clone())));
    put(0x3308, var(entry("Wide constant", DataType::UNICODE_STRING, Access::Const, wide)));
    let bytes = Some(Value::Bytes((0..=255).collect::<Vec<u8>>().into()));
    put(0x3309, var(entry("Bytes", DataType::OCTET_STRING, Access::Ro, bytes.clone())));
    put(0x330A, var(entry("Block", DataType::DOMAIN, Access::Const, bytes)));
    put(0x330B, var(entry("No text", DataType::VISIBLE_STRING, Access::Const, None)));
    put(
        0x330C,
        var(Entry {
            access: None,
            object_type: Some(ObjectType::Domain),
            ..entry("Data", DataType::DOMAIN, Access::Rw, None)
        }),
    );
    let main = entry("Compact", DataType::INTEGER48, Access::Rwr, Some(Value::Signed(-1)));
    let main = Entry { object_type: Some(ObjectType::Array), ..main };
    let compact = Compact { count: 254, values: vec![(7, Value::Signed(-(1 << 47)))], ..Compact::default() };
    put(0x330D, Object { main, compact: Some(Box::new(compact)), ..Object::default() });
}

/// Every access type with every mapping.
fn mappings(put: &mut impl FnMut(u16, Object)) {
    let mappings =
        [PdoMapping::No, PdoMapping::Optional, PdoMapping::Default, PdoMapping::Tpdo, PdoMapping::Rpdo];
    for (access, index) in Access::ALL.into_iter().zip(0x3400..) {
        let subs = mappings.into_iter().zip(1_u8..).map(|(mapping, sub)| {
            let byte = entry("Mapped", DataType::UNSIGNED8, access, Some(Value::Unsigned(1)));
            (sub, Entry { pdo_mapping: Some(mapping), ..byte })
        });
        put(index, of_type(ObjectType::Record, "Mappings", subs));
    }
}

/// Names that collide with each other and with names in the templates.
fn names(put: &mut impl FnMut(u16, Object)) {
    let byte = |name: &str| entry(name, DataType::UNSIGNED8, Access::Rw, None);
    let words = [
        "node_id",
        "Node ID",
        "data",
        "self",
        "Self",
        "crate",
        "u8",
        "uint8_t",
        "od",
        "od data t",
        "find",
        "ENTRIES",
        "ROM",
        "Octets",
        "offsetof",
        "bool",
        "int",
        "class",
        "index",
        "read",
        "H",
        "READ",
        "Unsigned32",
        "abort no data",
        "Entry count",
        "",
        "  ",
        "\u{202E}\u{2066}",
        "速度",
        "1",
        "x1",
        "a b",
        "A",
        "a",
        "a_b",
        "union",
        "type",
        "r#type",
        "*/",
        "//",
        "/*",
        "??/",
        "\\",
        "\"",
        "'",
        "`",
        "{{ 7 * 7 }}",
        "{% raw %}",
        "${HOME}",
        "$(id)",
        "]]>",
        "\0",
        "\r\n",
    ];
    for (word, index) in words.into_iter().zip(0x3500..) {
        put(index, var(byte(word)));
        put(index + 0x100, of_type(ObjectType::Record, word, [(1, byte(word))]));
    }
    let subs = words.into_iter().zip(1_u8..).map(|(word, sub)| (sub, byte(word)));
    put(0x36FF, of_type(ObjectType::Record, "od", subs));
    put(0x3700, var(byte(&"very long ".repeat(1000))));
    put(0x3701, var(byte(&"very long ".repeat(1000))));
    put(
        0x3702,
        of_type(ObjectType::Record, &"L".repeat(10_000), (1..4).map(|sub| (sub, byte(&"m".repeat(10_000))))),
    );
}

//! Tables that a project has already, beside those that are generated.

use objdict::generate::{Generated, Options, StackLayout, TableAspect, Target, compare_tables, generate};

use crate::devices::{device, devices};
use crate::support::fixtures;

fn texts(generated: &Generated) -> [String; 2] {
    [".h", ".c"].map(|ending| {
        let file = generated.files.iter().find(|file| file.path.ends_with(ending)).unwrap();
        String::from_utf8(file.contents.clone()).unwrap()
    })
}

#[test]
fn tables_are_the_same_as_themselves() {
    let compared: Vec<Target> = Target::all().filter(|target| target.is_compared()).collect();
    let names: Vec<&str> = compared.iter().map(|target| target.name()).collect();
    assert_eq!(names, ["canopen-stack", "canopennode", "canfestival", "canopennode-v1"]);
    for target in compared {
        for (name, device) in devices() {
            let Ok(generated) = generate(&device, target, &Options::default()) else { continue };
            let [header, source] = texts(&generated);
            let found = compare_tables(target, &header, &source, &generated);
            assert_eq!(found.as_deref(), Some(&[][..]), "{name}: {target:?}");
        }
        assert_eq!(compare_tables(target, "int x;", "", &Generated::default()), None);
        let minimal = device(&fixtures().join("eds/minimal.eds"));
        let generated = generate(&minimal, target, &Options::default()).unwrap();
        assert_eq!(compare_tables(target, "int x;", "int y = 5;", &generated), None, "{target:?}");
    }
}

/// What is different in the header or the source, and the only difference that follows.
const PLANTED: &[(&str, &str, TableAspect, &str)] = &[
    ("vendor_ID", "vendorId", TableAspect::Names, "x1018_identityObject.vendorId -> "),
    ("#define OD_CNT_TPDO 2", "#define OD_CNT_TPDO 3", TableAspect::Names, "OD_CNT_TPDO: 3 -> 2"),
    (
        ".attribute = ODA_SDO_R | ODA_TPDO,\n        .dataElementLength = 1,",
        ".attribute = ODA_SDO_RW | ODA_TRPDO,\n        .dataElementLength = 1,",
        TableAspect::Objects,
        "6000h:01: ODA_RPDO | ODA_SDO_R | ODA_SDO_W | ODA_TPDO -> ODA_SDO_R | ODA_TPDO",
    ),
    ("{0x1000, 0x01, ODT_VAR", "{0x1000, 0x02, ODT_VAR", TableAspect::Objects, "1000h: ODT_VAR with 2"),
    (".x1000_deviceType = 0x000F0191", ".x1000_deviceType = 401UL", TableAspect::Values, "401 -> 983441"),
    ("'1', '.', '2'", "'1', '.', '3', 0", TableAspect::Values, "\"1.3\" -> \"1.2\""),
];

#[test]
fn each_planted_difference_is_found_and_no_other() {
    let module = device(&fixtures().join("eds/io-401.eds"));
    let generated = generate(&module, Target::CANOPENNODE, &Options::default()).unwrap();
    let [header, source] = texts(&generated);
    for (made, existing, aspect, expected) in PLANTED {
        assert!(header.contains(made) || source.contains(made), "{made}");
        let [header, source] = [&header, &source].map(|text| text.replacen(made, existing, 1));
        let found = compare_tables(Target::CANOPENNODE, &header, &source, &generated).unwrap();
        let shown = |text: &Option<String>| text.clone().unwrap_or_default();
        let lines: Vec<String> = found
            .iter()
            .map(|found| format!("{}: {} -> {}", found.place, shown(&found.old), shown(&found.new)))
            .collect();
        assert_eq!(lines.len(), 1, "{made}: {lines:#?}");
        assert!(lines[0].contains(expected) && found[0].aspect == *aspect, "{made}: {lines:?}");
    }
}

/// Tables of other stacks: the target, what is in the header or the source, as an older table has it, and all that differs.
const PLANTED_ROWS: &[(&str, &str, &str, &[&str])] = &[
    (
        "canopennode-v1",
        "{0x1001, 0, 0x0006, 1, (void *)&CO_OD_RAM",
        "{0x1001, 0, 0x36, 1, (void*)&CO_OD_RAM",
        &[
            "1001h: attribute 0x36, 1 bytes, highest sub-index 0 -> attribute 0x06, 1 bytes, highest sub-index 0",
        ],
    ),
    (
        "canopennode-v1",
        "{(void *)&CO_OD_ROM.identity.vendorID, 0x0085, 4}",
        "{(void*)&CO_OD_ROM.identity.vendor, 0x85, 0x4 }",
        &["1018h:01: CO_OD_ROM.identity.vendor -> CO_OD_ROM.identity.vendorID"],
    ),
    ("canopennode-v1", "#define CO_NO_TPDO 2", "#define CO_NO_TPDO 4", &["CO_NO_TPDO: 4 -> 2"]),
    ("canopennode-v1", "0x000F0191u, /* 1000h */", "401L,", &["CO_OD_ROM.deviceType: 401 -> 983441"]),
    (
        "canopennode-v1",
        "UNSIGNED32 deviceType;",
        "UNSIGNED16 deviceType;",
        &["CO_OD_ROM.deviceType: UNSIGNED16, member 1 -> UNSIGNED32, member 1"],
    ),
    (
        "canopen-stack",
        "{CO_KEY(0x1017, 0x00, CO_OBJ_____RW), CO_THB_PROD, (CO_DATA)&od_producer_heartbeat_time}",
        "{CO_KEY(0x1017, 0, CO_OBJ_D___RW), CO_HEARTBEAT_PROD, (CO_DATA)(1000)}",
        &[
            "1017h:00:  -> od_producer_heartbeat_time",
            "1017h:00: HEARTBEAT_PROD RW -> HB_PROD RW",
            "1017h:00: 1000 -> 0",
        ],
    ),
    (
        "canopen-stack",
        "CO_OBJ____PR_), CO_TUNSIGNED8, (CO_DATA)&od_read_digital_input_8_bit[0]",
        "CO_OBJ____PRW), CO_TUNSIGNED8, (CO_DATA)&od_read_digital_input_8_bit[0]",
        &["6000h:01: UNSIGNED8 PRW -> UNSIGNED8 PR"],
    ),
    (
        "canfestival",
        "OD_ROW(RW, uint16, 2u, &od_obj1015)",
        "{ RO, uint16, sizeof (UNS16), (void*)&TestSlave_obj1015, NULL }",
        &[
            "1015h:00: TestSlave_obj1015 -> od_obj1015",
            "1015h:00: RO uint16, 2 bytes -> RW uint16, 2 bytes",
            "1015h:00:  -> 0",
        ],
    ),
    (
        "canfestival",
        "UNS32 od_obj1000 = 0x000F0191u;",
        "UNS32 od_obj1000 = 0x191;",
        &["1000h:00: 401 -> 983441"],
    ),
];

#[test]
fn differences_of_rows_are_found() {
    let module = device(&fixtures().join("eds/io-401.eds"));
    for (target, made, existing, expected) in PLANTED_ROWS {
        let target = Target::named(target).unwrap();
        let generated = generate(&module, target, &Options::default()).unwrap();
        let [header, source] = texts(&generated);
        assert!(header.contains(made) || source.contains(made), "{made}");
        let [header, source] = [&header, &source].map(|text| text.replacen(made, existing, 1));
        let found = compare_tables(target, &header, &source, &generated).unwrap();
        let shown = |text: &Option<String>| text.clone().unwrap_or_default();
        let lines: Vec<String> = found
            .iter()
            .map(|found| format!("{}: {} -> {}", found.place, shown(&found.old), shown(&found.new)))
            .collect();
        assert_eq!(lines, *expected, "{made}");
    }
}

/// A type that grows moves what follows it in memory, so that stored values no longer fit.
#[test]
fn moved_values_of_a_stored_group_are_found() {
    let module = device(&fixtures().join("eds/io-401.eds"));
    let generated = generate(&module, Target::CANOPENNODE, &Options::default()).unwrap();
    let [header, source] = texts(&generated);
    let header =
        header.replace("uint16_t x1015_", "uint8_t x1015_").replace("uint16_t x1017_", "uint64_t x1017_");
    let found = compare_tables(Target::CANOPENNODE, &header, &source, &generated).unwrap();
    let layout: Vec<_> = found.iter().filter(|found| found.aspect == TableAspect::Layout).collect();
    assert_eq!(layout.len(), 1, "{found:#?}");
    assert_eq!(layout[0].place, "OD_PERSIST_COMM");
    assert!(
        layout[0].old.as_deref().unwrap().starts_with("uint8_t x1015_inhibitTimeEMCY at byte "),
        "{layout:?}"
    );
    let types = found.iter().filter(|found| found.aspect == TableAspect::Names).count();
    assert_eq!(types, 2);
}

/// Whatever is in the files, there is an answer.
#[test]
fn hostile_tables_are_read() {
    let deep = format!("OD_RAM_t OD_RAM = {}", "{".repeat(100_000));
    let nested = format!("typedef struct {{ {} }} OD_RAM_t;", "struct {".repeat(100_000));
    for text in ["'", "/*", "#define", "\"\\", "typedef struct {", "x = {", "= {{,}", &deep, &nested] {
        for (header, source) in [(text, ""), ("typedef struct { uint8_t a; } OD_RAM_t;", text)] {
            let generated = generate(
                &device(&fixtures().join("eds/minimal.eds")),
                Target::CANOPENNODE,
                &Options { layout: StackLayout::Complete, ..Options::default() },
            );
            let generated = generated.unwrap();
            for target in Target::all().filter(|target| target.is_compared()) {
                compare_tables(target, header, source, &generated);
            }
        }
    }
}

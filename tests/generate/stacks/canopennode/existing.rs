//! Tables that a project has already, beside those that are generated.

use objdict::generate::{Generated, Options, StackLayout, TableAspect, Target, compare_tables, generate};

use crate::devices::{device, devices};
use crate::support::fixtures;

fn texts(generated: &Generated) -> [String; 2] {
    let mut texts = generated.files.iter().map(|file| String::from_utf8(file.contents.clone()).unwrap());
    [texts.next().unwrap(), texts.next().unwrap()]
}

#[test]
fn tables_are_the_same_as_themselves() {
    for (name, device) in devices() {
        let Ok(generated) = generate(&device, Target::CANOPENNODE, &Options::default()) else { continue };
        let [header, source] = texts(&generated);
        let found = compare_tables(Target::CANOPENNODE, &header, &source, &generated);
        assert_eq!(found.as_deref(), Some(&[][..]), "{name}");
    }
    assert_eq!(compare_tables(Target::CANOPENNODE, "int x;", "", &Generated::default()), None);
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
            compare_tables(Target::CANOPENNODE, header, source, &generated.unwrap());
        }
    }
}

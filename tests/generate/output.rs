//! The text of the output: its form, reproducibility, acceptance by Rust tools, and that no text of a
//! description changes its meaning.

use std::process::Command;

use objdict::generate::{CTable, Options, OutputFile, Sizes, Target, generate, size};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, PdoMapping, Value};

use crate::batch::Batch;
use crate::compile::{c_compiler, cc, generate_into, generate_with, rustc};
use crate::processors::{build, host};
use crate::support::skips::{has, skip_unless_ci};
use crate::verdicts::{Key, accepts};
use crate::{device, devices, odd, support};

/// All files of the table targets.
fn files(device: &Device, options: &Options) -> Vec<OutputFile> {
    let targets = ["rust", "c"].map(|name| Target::named(name).unwrap());
    targets.into_iter().flat_map(|target| generate(device, target, options).unwrap().files).collect()
}

fn text(file: &OutputFile) -> &str {
    std::str::from_utf8(&file.contents).unwrap()
}

#[test]
fn snapshots() {
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    let version = concat!("objdict ", env!("CARGO_PKG_VERSION"));
    for file in files(&minimal, &Options::default()) {
        insta::assert_snapshot!(file.path.as_str(), text(&file).replace(version, "objdict [version]"));
    }
}

#[test]
fn output_is_always_the_same_and_well_formed() {
    for (name, device) in devices() {
        let (first, second) = (files(&device, &Options::default()), files(&device, &Options::default()));
        assert!(first == second, "{name}");
        for file in &first {
            let text = text(file);
            assert!(text.ends_with('\n') && !text.ends_with("\n\n"), "{name}: {}", file.path);
            for (number, line) in text.lines().enumerate() {
                let place = format!("{name}: {}:{}: {line}", file.path, number + 1);
                assert!(line.trim_end() == line && !line.ends_with('\\'), "{place}");
                assert!(
                    line.chars().all(|c| c == ' ' || c.is_ascii_graphic() || c.is_alphanumeric()),
                    "{place}"
                );
            }
        }
    }
}

/// The history of errors and heartbeat consumers, compact or written out: one table.
#[test]
fn compact_storage_gives_the_table_of_what_is_written_out() {
    let object = |index: u16, access: &str| {
        format!("[{index:04X}]\nParameterName=List\nObjectType=8\nDataType=7\nAccessType={access}\n")
    };
    let entry = |at: &str, name: &str, rest: &str| {
        format!("[{at}]\nParameterName={name}\nObjectType=7\nPDOMapping=0\n{rest}\n")
    };
    let list = "[OptionalObjects]\nSupportedObjects=2\n1=0x1003\n2=0x1016\n";
    let compact = [(0x1003, "ro"), (0x1016, "rw")]
        .map(|(index, access)| object(index, access) + "DefaultValue=0\nPDOMapping=0\nCompactSubObj=2\n");
    let written =
        [(0x1003, "ro", "rw", 0), (0x1016, "rw", "ro", 2)].map(|(index, access, of_count, count)| {
            let of_count = format!("DataType=5\nAccessType={of_count}\nDefaultValue={count}");
            let subs = [1, 2].map(|sub| {
                let element = format!("DataType=7\nAccessType={access}\nDefaultValue=0");
                entry(&format!("{index:04X}sub{sub}"), &format!("List{sub}"), &element)
            });
            let count = entry(&format!("{index:04X}sub0"), "NrOfObjects", &of_count);
            format!("{}SubNumber=3\n{count}{}", object(index, access), subs.concat())
        });
    let folder = tempfile::tempdir().unwrap();
    let device_of = |objects: [String; 2]| {
        let path = folder.path().join("lists.eds");
        std::fs::write(&path, format!("{list}{}", objects.concat())).unwrap();
        device(&path)
    };
    let [compact, written] = [compact, written].map(device_of);
    for name in ["c", "rust", "canopennode", "canopennode-v1", "canopen-stack", "canfestival", "lely"] {
        let target = Target::named(name).unwrap();
        let [compact, written] =
            [&compact, &written].map(|device| generate(device, target, &Options::default()).unwrap().files);
        for (compact, written) in compact.iter().zip(&written) {
            assert_eq!(text(compact), text(written), "{name}");
        }
    }
}

/// The same device with other names gives the same code: names only affect comments and identifiers.
#[test]
fn no_name_changes_the_code() {
    let plain = device(&support::fixtures().join("eds/io-401.eds"));
    let mut hostile = plain.clone();
    for object in hostile.objects.values_mut() {
        let attack = "x */ } \"); system(\"id\"); // \u{202E} ??/ \\\n#error `";
        object.main.name = attack.into();
        object.subs.iter_mut().for_each(|(_, entry)| entry.name = attack.into());
    }
    // which are strings in the program, see `gates`
    let mut options = Options::default();
    options.entry_names = false;
    for (plain, hostile) in files(&plain, &options).iter().zip(files(&hostile, &options)) {
        let (plain, hostile) = (bare(text(plain)), bare(text(&hostile)));
        assert_eq!(plain.len(), hostile.len());
        for (plain, hostile) in plain.iter().zip(&hostile) {
            assert_eq!(plain, hostile);
        }
    }
}

/// Lines without comments, identifiers and the order of C fields.
pub(crate) fn bare(text: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let without_comment = lines
        .map(|line| line.split("/*").next().unwrap_or_default().split(" // ").next().unwrap_or_default());
    let masked = without_comment.map(|line| {
        let mut masked = String::new();
        for c in line.trim_end().chars() {
            let identifier =
                c.is_ascii_alphabetic() || c == '_' || (c.is_ascii_digit() && masked.ends_with('i'));
            match (identifier, masked.ends_with('i')) {
                (true, true) => {}
                (true, false) => masked.push('i'),
                (false, _) => masked.push(c),
            }
        }
        masked
    });
    masked.collect()
}

#[test]
fn a_node_id_is_named_as_the_default() {
    let mut device = device(&support::fixtures().join("eds/minimal.eds"));
    let lines = |device: &Device, options: &Options| {
        let files = files(device, options);
        (
            text(&files[0]).contains("pub const NODE_ID: u8 = 9;"),
            text(&files[1]).contains("#define OD_NODE_ID 9u\n"),
        )
    };
    assert_eq!(lines(&device, &Options::default()), (false, false));
    let mut options = Options::default();
    options.node_id = Some(9);
    assert_eq!(lines(&device, &options), (true, true));
    device.commissioning.get_or_insert_default().node_id = Some(9);
    assert_eq!(lines(&device, &Options::default()), (true, true));
}

/// Offsets where 16 bits are too few.
#[test]
fn large_dictionaries_get_longer_places() {
    let mut device = device(&support::fixtures().join("eds/minimal.eds"));
    let text = Value::Text("0123456789".repeat(6000).into());
    for (number, index) in [0x2000, 0x2001].into_iter().enumerate() {
        let mut object = device.objects[&0x1008].clone();
        object.main.default = Some(text.clone());
        object.main.access = Some(Access::Rw);
        object.main.name = format!("Text {number}").into();
        device.objects.insert(index, object);
    }
    let small = files(&crate::device(&support::fixtures().join("eds/minimal.eds")), &Options::default());
    let large = files(&device, &Options::default());
    assert!(self::text(&small[1]).contains("typedef uint16_t od_offset_t;"));
    assert!(self::text(&large[1]).contains("typedef uint32_t od_offset_t;"), "two fields of 60,000 bytes");
    let mut batch = Batch::new(&["-Adead-code"]);
    let program = r#"
        mod od { include!("od.rs"); }
        fn main() {
            let mut data = od::Data::new(5);
            let mut buffer = vec![0; od::MAX_SIZE];
            assert_eq!(data.read(0x2001, 0, &mut buffer), Ok(60_000));
            assert_eq!(data.get(od::TEXT_1), buffer);
            data.set(od::TEXT_1, b"short").unwrap();
            assert_eq!((data.get(od::TEXT_0), data.get(od::TEXT_1)), (&buffer[..], &b"short"[..]));
        }
    "#;
    batch.add("large", &generate(&device, Target::RUST, &Options::default()).unwrap(), program, &());
    batch.build();
    batch.check("large", "", |_| Ok(())).unwrap();
}

/// A device whose numbers need wider rows in C: long texts, pairs of data type and flags, entries.
fn wide([texts, kinds, entries]: [bool; 3]) -> Device {
    let mut device = device(&support::fixtures().join("eds/minimal.eds"));
    let var = device.objects[&0x1001].clone();
    for number in 0..if texts { 2 } else { 0 } {
        let mut object = device.objects[&0x1008].clone();
        object.main.default = Some(Value::Text("0123456789".repeat(6000).into()));
        object.main.access = Some(Access::Rw);
        device.objects.insert(0x2000 + number, object);
    }
    let accesses = [Access::Ro, Access::Rw, Access::Rwr, Access::Rww, Access::Wo];
    let types = [1, 2, 3, 4, 5, 6, 7, 0x10, 0x12, 0x13, 0x18, 0x19, 0x14, 0x15, 0x1B, 0x16];
    for number in 0..if kinds { 16 * 5 * 4 } else { 0 } {
        let mut object = var.clone();
        object.main.data_type = Some(DataType(types[number % 16]));
        object.main.access = Some(accesses[number / 16 % 5]);
        object.main.pdo_mapping = Some(PdoMapping::Optional);
        object.main.low_limit = (number / 80 % 2 == 1).then_some(Value::Unsigned(0));
        object.main.high_limit = (number / 160 == 1).then_some(Value::Unsigned(1));
        device.objects.insert(0x3000 + number as u16, object);
    }
    for number in 0..if entries { 260 } else { 0 } {
        let entry = Entry { access: Some(Access::Const), ..var.main.clone() };
        let main = Entry { object_type: Some(ObjectType::Record), ..var.main.clone() };
        let subs = (0..=255).map(|sub| (sub, entry.clone())).collect();
        device.objects.insert(0x4000 + number, Object { main, subs, ..Object::default() });
    }
    device
}

const WIDE: &str = r#"
#include <stdio.h>
#include <string.h>
#include "od.c"
static od_data_t data;
static char text[60000];

int main(void)
{
    size_t at;
    size_t length;
    od_init(&data, 5);
    for (at = 0u; at < OD_ENTRY_COUNT; at++) {
        const od_entry_t *entry = &od_entries[at];
        if (od_find(od_index(entry), entry->sub) != entry) {
            printf("%04X %02X is lost; ", (unsigned)od_index(entry), (unsigned)entry->sub);
        }
    }
    if (od_find(0x2001, 0) != NULL && (od_read(&data, 0x2001, 0, text, sizeof text, &length) != OD_OK || memcmp(&text[59990], "0123456789", 10) != 0)) {
        printf("the text is wrong; ");
    }
    if (od_find(0x313F, 0) != NULL && (od_data_type(od_find(0x313F, 0)) != OD_UNSIGNED24 || od_flags(od_find(0x313F, 0)) != (OD_WRITE | OD_RPDO | OD_LOW | OD_HIGH))) {
        printf("the last kind is wrong; ");
    }
    printf("%lu %lu %lu", (unsigned long)sizeof(od_entry_t), (unsigned long)sizeof(od_object_t),
           (unsigned long)(sizeof od_entries + sizeof od_kinds + sizeof od_objects + sizeof od_rom));
    return 0;
}
"#;

#[test]
fn rows_in_c_are_as_wide_as_the_device_needs() {
    let Some(compiler) = c_compiler() else { return };
    let cases = [
        ([false; 3], "6 4"),
        ([true, false, false], "12 4"),
        ([false, true, false], "8 4"),
        ([false, false, true], "6 8"),
        ([true; 3], "12 8"),
    ];
    for (case, rows) in cases {
        let device = wide(case);
        let folder = tempfile::tempdir().unwrap();
        generate_into(folder.path(), &device, "c");
        std::fs::write(folder.path().join("wide.c"), WIDE).unwrap();
        let programs = build(cc(&compiler, folder.path()).args(["-I.", "-o", "wide", "wide.c"]));
        let Sizes::Known(report) = size(&device, Target::C, &Options::default()).unwrap() else { panic!() };
        programs
            .expect(&[], &format!("{rows} {}", report.total.flash))
            .unwrap_or_else(|error| panic!("{case:?}: {error}"));
    }
}

#[test]
fn rustfmt_changes_nothing() {
    let program = std::env::var("RUSTFMT").unwrap_or_else(|_| "rustfmt".to_owned());
    if !has(&program, "rustfmt") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (number, (name, device)) in devices().into_iter().enumerate() {
        let folder = folder.path().join(number.to_string());
        std::fs::create_dir(&folder).unwrap();
        generate_into(&folder, &device, "rust");
        let mut rustfmt = Command::new(&program);
        let rustfmt = rustfmt.args(["--edition=2021", "--check", "--config-path", "/dev/null", "od.rs"]);
        accepts(rustfmt.current_dir(folder)).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    generate_with(folder.path(), &crate::odd::device(), "rust", &crate::stored::options());
    let mut rustfmt = Command::new(&program);
    let rustfmt = rustfmt.args(["--edition=2021", "--check", "--config-path", "/dev/null", "od.rs"]);
    accepts(rustfmt.current_dir(folder.path())).unwrap();
}

/// Names that Doxygen would take for commands, tags, entities, links and fences.
const MARKUP: &str = r#"@brief torque|a\param b|<b>bold & co|#hash ::global|`tick|``` fence|~~~|%percent $dollar
    |x[0](y)|* star _u_|"quoted|&amp; &nbsp|@code|\endcode|@{|@}|--dash|1. list|foo() bar::baz|:::|<!-- c|</b>
    |<a href=x>|@|\|C:\temp\new|@@ \\|@"#;

#[test]
fn doxygen_warns_of_nothing() {
    if !has("doxygen", "doxygen") {
        return;
    }
    let mut hostile = device(&support::fixtures().join("eds/dspic-sensors.eds"));
    for (name, index) in MARKUP.split('|').zip(0x2800..) {
        let mut object = device(&support::fixtures().join("eds/minimal.eds")).objects[&0x1001].clone();
        object.main.name = name.trim().into();
        object.main.access = Some(Access::Rw);
        hostile.objects.insert(index, object);
    }
    let info = hostile.device_info.get_or_insert_default();
    (info.vendor_name, info.product_name) = (Some("<x>@y".into()), Some("\\a".into()));
    let valve = device(&support::fixtures().join("xdd/valve.xdd"));
    for device in [hostile, valve, odd::device()] {
        for table in [CTable::Compact, CTable::Structs] {
            let mut options = Options::default();
            options.table = table;
            options.groups = vec!["2800-280F=APP".parse().unwrap()];
            options.hooks = ["2000".parse().unwrap()].into();
            let folder = tempfile::tempdir().unwrap();
            generate_with(folder.path(), &device, "c", &options);
            let settings =
                "QUIET=YES\nEXTRACT_ALL=YES\nGENERATE_HTML=NO\nGENERATE_LATEX=NO\nGENERATE_XML=YES\n";
            std::fs::write(folder.path().join("Doxyfile"), settings).unwrap();
            let mut doxygen = Command::new("doxygen");
            doxygen.current_dir(folder.path());
            let mut key = Key::new();
            key.command(&doxygen);
            key.or_try(|| match &*doxygen.output().unwrap().stderr {
                [] => Ok(()),
                warnings => Err(String::from_utf8_lossy(warnings).into_owned()),
            })
            .unwrap_or_else(|warnings| panic!("{table:?}: {warnings}"));
        }
    }
}

#[test]
fn clippy_finds_nothing() {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let version = Command::new(&cargo).args(["clippy", "--version"]).output();
    if !version.is_ok_and(|output| output.status.success()) {
        skip_unless_ci("no clippy: `rustup component add clippy`");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::create_dir(folder.join("src")).unwrap();
    let manifest = "[package]\nname = \"tables\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n";
    std::fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    let mut modules = String::from(
        "#![no_std]\n#![deny(warnings, clippy::all, clippy::pedantic, clippy::nursery)]\n\
         #![deny(clippy::indexing_slicing, clippy::arithmetic_side_effects)]\n//! Tables.\n",
    );
    let chosen = [
        "odd",
        "constant",
        "hostile.eds",
        "hostile-unicode.eds",
        "all-types.eds",
        "io-401-node5.dcf",
        "valve.xdd",
    ];
    let devices: Vec<_> = devices().into_iter().filter(|(name, _)| chosen.contains(&name.as_str())).collect();
    assert_eq!(devices.len(), chosen.len());
    for (number, (_, device)) in devices.iter().enumerate() {
        let source = format!("src/od{number}");
        std::fs::create_dir(folder.join(&source)).unwrap();
        generate_into(&folder.join(&source), device, "rust");
        modules
            .push_str(&format!("/// A table.\npub mod od{number} {{ include!(\"od{number}/od.rs\"); }}\n"));
    }
    std::fs::create_dir(folder.join("src/grouped")).unwrap();
    generate_with(&folder.join("src/grouped"), &crate::odd::device(), "rust", &crate::stored::options());
    modules.push_str("/// A table.\npub mod grouped { include!(\"grouped/od.rs\"); }\n");
    std::fs::write(folder.join("src/lib.rs"), modules).unwrap();
    let mut clippy = Command::new(cargo);
    let clippy = clippy.args(["clippy", "--offline", "--quiet"]).current_dir(folder);
    let clippy = clippy.env("CARGO_TARGET_DIR", folder.join("target")).env_remove("RUSTFLAGS");
    accepts(clippy).unwrap_or_else(|error| panic!("{error}"));
}

/// The examples of the documentation with their tables.
#[test]
fn the_examples_of_the_documentation_run() {
    let example = |language: &str| {
        let page = format!("{}/docs/guides/{language}-table.md", env!("CARGO_MANIFEST_DIR"));
        let page = std::fs::read_to_string(page).unwrap();
        let (_, rest) = page.split_once(&format!("```{language}\n")).unwrap();
        rest.split_once("```\n").unwrap().0.to_owned()
    };
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    for target in ["rust", "c"] {
        generate_into(folder, &minimal, target);
    }
    std::fs::write(folder.join("example.rs"), example("rust")).unwrap();
    host(rustc(folder).args(["-o", "in-rust", "example.rs"])).succeed().unwrap();
    std::fs::write(folder.join("example.c"), example("c")).unwrap();
    if let Some(compiler) = c_compiler() {
        build(cc(&compiler, folder).args(["-o", "in-c", "od.c", "example.c"])).succeed().unwrap();
    }
}

/// Names of files have the prefix as it is spelt; identifiers have the case of their target.
#[test]
fn files_keep_the_case_of_the_prefix() {
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    let options = Options { prefix: Some("TestSlave".to_owned()), ..Options::default() };
    for target in ["c", "canopen-stack", "canopennode", "microcanopen", "lely", "canfestival"] {
        let generated = generate(&minimal, Target::named(target).unwrap(), &options).unwrap();
        let paths: Vec<&str> = generated.files.iter().map(|file| file.path.as_str()).collect();
        assert!(paths.iter().all(|path| path.starts_with("TestSlave")), "{target}: {paths:?}");
        for file in &generated.files {
            let text = std::str::from_utf8(&file.contents).unwrap();
            let own = text
                .lines()
                .filter_map(|line| line.strip_prefix("#include \""))
                .map(|name| name.trim_end_matches('"'));
            let missing: Vec<&str> = own
                .filter(|name| name.to_ascii_lowercase().starts_with("test") && !paths.contains(name))
                .collect();
            assert!(missing.is_empty(), "{target}: {missing:?}");
        }
    }
}

/// CANopenEditor describes all PDOs of a profile, most of them not in use.
#[test]
fn pdos_that_are_not_in_use_are_reported_once() {
    use std::fmt::Write;
    let mut text = String::new();
    for number in 0..49 {
        for (index, entries) in [
            (0x1400 + number, &[(0, 5, "5"), (1, 7, "$NODEID+0x80000200"), (2, 5, "254"), (5, 6, "0")][..]),
            (0x1600 + number, &[(0, 5, "0"), (1, 7, "0")]),
        ] {
            writeln!(text, "[{index:X}]\nParameterName=PDO\nObjectType=9\nSubNumber={}", entries.len())
                .unwrap();
            for (sub, data_type, default) in entries {
                writeln!(text, "[{index:X}sub{sub}]\nParameterName=Value {sub}\nObjectType=7\nDataType={data_type}\nAccessType=rw\nDefaultValue={default}\nParameterValue=").unwrap();
            }
        }
    }
    let dcf = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap() + &text;
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pdos.dcf");
    std::fs::write(&file, dcf).unwrap();
    let pdos = device(&file);
    for target in Target::all().filter(|target| target.name() != "template") {
        let notes = generate(&pdos, target, &Options::default()).unwrap().notes;
        let of_pdos = notes
            .iter()
            .filter(|note| note.places().count() < 40 && note.to_string().contains("0x14"))
            .count();
        assert!(of_pdos <= 4, "{target:?}: {of_pdos}");
        assert!(notes.len() < 16, "{target:?}: {notes:#?}");
    }
}

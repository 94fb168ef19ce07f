//! Images of storage groups: byte by byte as described in docs/reference/generate.md, equal in Rust and C, and rejected
//! if any part is invalid.

use std::fmt::Write;

use objdict::generate::{CTable, Options, SizeReport, Sizes, Target, generate, size};
use objdict::model::{Access, Device, ObjectType, StackOptions, TypeKind};

use crate::batch::Batch;
use crate::compile::{c_compiler, cc, generate_with, rustc};
use crate::devices::{device, devices, for_all};
use crate::oracle::{Dictionary, Facts, facts_of, hex};
use crate::processors::host;
use crate::script::edges;
use crate::{odd, support};

/// A group in generated code.
#[derive(Clone, Copy)]
struct Group {
    /// The member of the struct of values.
    field: &'static str,
    first: u16,
    last: u16,
}

const fn group(field: &'static str, first: u16, last: u16) -> Group {
    Group { field, first, last }
}

const GROUPS: [Group; 3] =
    [group("comm", 0x0001, 0x2FFF), group("values", 0x3000, 0x34FF), group("a_1", 0x6000, 0x9FFF)];

/// Options with groups and hooks.
pub(crate) fn options() -> Options {
    let mut options = Options::default();
    options.hooks = ["3000", "3300:1"].map(|hook| hook.parse().unwrap()).into();
    let groups = ["1-2FFF=COMM", "3000-34FF=values", "6000-9FFF=a_1"];
    options.groups = groups.map(|group| group.parse().unwrap()).to_vec();
    options
}

/// The entries of a group with values that can change.
fn members(device: &Device, group: Group) -> Vec<(u16, u8, Facts)> {
    let entries = facts_of(device).filter(|((index, _), _)| (group.first..=group.last).contains(index));
    let entries = entries.filter(|((index, sub), facts)| {
        let object = &device.objects[index];
        let is_compact = object.compact.is_some() && !matches!(index, 0x1003 | 0x1016);
        let count = *sub == 0 && (object.object_type() == ObjectType::Record || is_compact);
        let definition = matches!(object.object_type(), ObjectType::DefType | ObjectType::DefStruct);
        let fixed = facts.access == Access::Const || facts.access == Access::Ro && (count || definition);
        !fixed && facts.size > 0
    });
    entries.map(|((index, sub), facts)| (index, sub, facts)).collect()
}

/// The remainder of a polynomial division, bit by bit.
fn crc(bytes: &[u8]) -> [u8; 2] {
    let mut register = 0_u32;
    let bits = bytes.iter().chain(&[0, 0]).flat_map(|byte| (0..8).rev().map(move |bit| byte >> bit & 1));
    for bit in bits {
        register = register << 1 | u32::from(bit);
        if register >> 16 == 1 {
            register ^= 0x1_1021;
        }
    }
    u16::try_from(register).unwrap().to_le_bytes()
}

#[test]
fn the_crc_is_that_of_block_transfers() {
    assert_eq!(crc(b"123456789"), [0xC3, 0x31]);
}

/// The expected image of a group, computed from the description.
fn image(members: &[(u16, u8, Facts)], values: &Dictionary) -> Vec<u8> {
    let mut hash = 0x811C_9DC5_u32;
    let mut bytes = Vec::new();
    for (index, sub, facts) in members {
        let data_type = if facts.kind.is_some() { facts.data_type.0 } else { 0 };
        let [index_low, index_high] = index.to_le_bytes();
        let [low, high] = u16::try_from(facts.size).unwrap().to_le_bytes();
        for byte in [index_low, index_high, *sub, data_type.to_le_bytes()[0], low, high] {
            hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
        let value = values.value(*index, *sub);
        if has_length(facts) {
            bytes.extend(u16::try_from(value.len()).unwrap().to_le_bytes());
        }
        bytes.extend(value);
        bytes.resize(bytes.len() + facts.size - value.len(), 0);
    }
    sealed([hash.to_le_bytes().to_vec(), bytes].concat())
}

/// Appends the CRC.
fn sealed(mut image: Vec<u8>) -> Vec<u8> {
    image.extend(crc(&image));
    image
}

fn has_length(facts: &Facts) -> bool {
    facts.kind.is_some() && facts.data_type.byte_length().is_none()
}

/// Operations and the expected answers.
#[derive(Default)]
struct Session {
    input: String,
    expected: Vec<String>,
}

impl Session {
    fn line(&mut self, line: std::fmt::Arguments<'_>, answer: impl Into<String>) {
        writeln!(self.input, "{line}").unwrap();
        self.expected.push(answer.into());
    }

    fn save(&mut self, group: Group, image: &[u8]) {
        self.line(format_args!("s {}", group.field), hex(image));
    }

    fn load(&mut self, group: Group, image: &[u8], answer: u8) {
        self.line(format_args!("l {} {}", group.field, hex(image)), answer.to_string());
    }

    /// Images of defaults and of other values from one node, loaded by another; then corrupted ones.
    fn of(device: &Device, groups: &[Group], writes: bool) -> Self {
        let mut session = Self::default();
        let all: Vec<(Group, Vec<_>)> = groups.iter().map(|&group| (group, members(device, group))).collect();
        let (mut values, others) = (Dictionary::new(device, 5), Dictionary::new(device, 127));
        // the same answers in Rust, where SDOs cannot write mappings, and in C
        let is_mapping = |index: u16| matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF);
        session.line(format_args!("i 05"), "0");
        for (group, members) in &all {
            session.save(*group, &image(members, &values));
        }
        let written = all.iter().flat_map(|(_, members)| members).filter(|(index, ..)| !is_mapping(*index));
        for (index, sub, facts) in written {
            let longer = if has_length(facts) { vec![0x41; facts.size & !1] } else { Vec::new() };
            for value in edges(facts).into_iter().chain([longer]).filter(|_| writes) {
                let answer = values.write(*index, *sub, &value).err().unwrap_or(0);
                let line = format!("w {index:04X} {sub:02X} {}", hex(&value));
                session.line(format_args!("{line}"), format!("{answer:X}"));
            }
        }
        let images: Vec<Vec<u8>> = all.iter().map(|(_, members)| image(members, &values)).collect();
        for ((group, _), image) in all.iter().zip(&images) {
            session.save(*group, image);
        }
        session.line(format_args!("i 7F"), "0");
        for ((group, members), kept) in all.iter().zip(&images) {
            let before = image(members, &others);
            session.save(*group, &before);
            for (damaged, answer) in damaged(kept, members) {
                session.load(*group, &damaged, answer);
                session.save(*group, &before);
            }
            session.load(*group, &with_void_bits(kept, members), 0);
            session.save(*group, kept);
            session.line(format_args!("i 7F"), "0");
            session.load(*group, kept, 0);
            session.save(*group, kept);
        }
        session
    }

    fn compare(&self, name: &str, language: &str, output: &str) -> Result<(), String> {
        let lines: Vec<&str> = output.lines().collect();
        let wrong = lines.iter().zip(&self.expected).position(|(line, expected)| line != expected);
        match wrong {
            Some(at) => Err(format!(
                "{name}, {language}: `{}` gives `{}`, not `{}`",
                self.input.lines().nth(at).unwrap_or_default(),
                lines[at],
                self.expected[at]
            )),
            None if lines.len() != self.expected.len() => Err(format!("{name}, {language}: {}", lines.len())),
            None => Ok(()),
        }
    }
}

/// The same values with unused bits of times set.
fn with_void_bits(image: &[u8], members: &[(u16, u8, Facts)]) -> Vec<u8> {
    let mut body = image[..image.len() - 2].to_vec();
    let mut at = 4;
    for (.., facts) in members {
        if matches!(facts.kind, Some(TypeKind::TimeOfDay | TypeKind::TimeDifference)) {
            body[at + 3] |= 0xF0;
        }
        at += facts.size + if has_length(facts) { 2 } else { 0 };
    }
    sealed(body)
}

/// Corrupted images and the expected errors.
fn damaged(image: &[u8], members: &[(u16, u8, Facts)]) -> Vec<(Vec<u8>, u8)> {
    let flipped = |at: usize| {
        let mut image = image.to_vec();
        image[at] ^= 0x10;
        image
    };
    let end = image.len();
    let mut images = vec![
        (Vec::new(), 1),
        (image[..end - 1].to_vec(), 1),
        ([image, &[0]].concat(), 1),
        (flipped(0), 2),
        (flipped(3), 2),
        (vec![0; end], 2),
        (vec![0xFF; end], 2),
        (flipped(4), 3),
        (flipped(end - 3), 3),
        (flipped(end - 2), 3),
        (flipped(end - 1), 3),
    ];
    let mut at = 4;
    for (.., facts) in members {
        let mut body = image[..end - 2].to_vec();
        if facts.kind == Some(TypeKind::Boolean) {
            body[at] = 2;
            images.push((sealed(body), 4));
        } else if has_length(facts) {
            let longer = u16::try_from(facts.size + 1).unwrap().to_le_bytes();
            body[at..at + 2].copy_from_slice(&longer);
            images.push((sealed(body), 4));
            at += 2;
        }
        at += facts.size;
    }
    assert_eq!(at, end - 2);
    images
}

const RUST: &str = r#"
mod od {
    include!("od.rs");
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect()
}

fn bytes(text: &str) -> Vec<u8> {
    let text = text.trim_matches('-');
    (0..text.len() / 2).map(|at| u8::from_str_radix(&text[2 * at..2 * at + 2], 16).unwrap()).collect()
}

fn number(text: &str) -> u16 {
    u16::from_str_radix(text, 16).unwrap()
}

fn answer(answer: Result<(), od::ImageError>) -> String {
    String::from(match answer {
        Ok(()) => "0",
        Err(od::ImageError::Length) => "1",
        Err(od::ImageError::Layout) => "2",
        Err(od::ImageError::Checksum) => "3",
        Err(od::ImageError::Value) => "4",
    })
}

fn main() {
    let mut data = od::Data::new(1);
    for line in std::io::stdin().lines() {
        let line = line.unwrap();
        let words: Vec<&str> = line.split(' ').collect();
        let shown = match words[..] {
            ["i", node_id] => {
                data = od::Data::new(number(node_id) as u8);
                String::from("0")
            }
            ["w", index, sub, value] => {
                let answer = data.write(number(index), number(sub) as u8, &bytes(value));
                answer.map_or_else(|abort| format!("{:X}", abort.code()), |()| String::from("0"))
            }
"#;

const C: &str = r#"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "od.h"

static char line[400000];
static uint8_t bytes[200000];
static uint8_t image[200000];

static size_t parse(const char *text)
{
    size_t length = 0;
    while (text[0] != '-' && text[0] != '\n') {
        char pair[3] = {text[0], text[1], '\0'};
        bytes[length++] = (uint8_t)strtoul(pair, NULL, 16);
        text += 2;
    }
    return length;
}

static void show(size_t length)
{
    size_t at;
    for (at = 0; at < length; at++) {
        printf("%02X", (unsigned)image[at]);
    }
    printf("\n");
}

int main(void)
{
    while (fgets(line, sizeof line, stdin) != NULL) {
        memset(image, 0xEE, sizeof image);
"#;

/// Programs that execute the lines of a session.
fn programs(groups: &[Group], has_write: bool) -> (String, String) {
    let (mut rust, mut c) = (RUST.to_owned(), C.to_owned());
    if has_write {
        c = c.replace("int main", "static od_data_t data;\n\nint main");
    }
    let (data, init) = if has_write {
        ("data", "od_init(&data, (uint8_t)strtoul(line + 2, NULL, 16))")
    } else {
        ("od_data", "od_init((uint8_t)strtoul(line + 2, NULL, 16))")
    };
    writeln!(c, "        if (line[0] == 'i') {{ {init}; printf(\"0\\n\"); continue; }}").unwrap();
    if has_write {
        c.push_str(
            "        if (line[0] == 'w') {
            const uint16_t index = (uint16_t)strtoul(line + 2, NULL, 16);
            const uint8_t sub = (uint8_t)strtoul(line + 7, NULL, 16);
            const size_t length = parse(line + 10);
            printf(\"%lX\\n\", (unsigned long)od_write(&data, index, sub, bytes, length));
            continue;
        }
",
        );
    }
    for Group { field, .. } in groups {
        let upper = field.to_uppercase();
        writeln!(
            rust,
            "[\"s\", \"{field}\"] => {{ let mut image = [0xEE; od::groups::{upper}.image_size()]; \
             data.save(od::groups::{upper}, &mut image); hex(&image) }}
             [\"l\", \"{field}\", image] => answer(data.load(od::groups::{upper}, &bytes(image))),"
        )
        .unwrap();
        let skip = 3 + field.len();
        writeln!(
            c,
            "if (strncmp(line, \"s {field}\\n\", {skip}) == 0) {{ od_{field}_save(&{data}.{field}, image); \
             show(OD_{upper}_IMAGE_SIZE); continue; }}
             if (strncmp(line, \"l {field} \", {skip}) == 0) {{ const size_t length = parse(line + {skip}); \
             printf(\"%d\\n\", (int)od_{field}_load(&{data}.{field}, bytes, length)); continue; }}"
        )
        .unwrap();
    }
    rust.push_str("_ => panic!(\"{line}\"),\n};\nprintln!(\"{shown}\");\n}\n}\n");
    c.push_str("        printf(\"? %s\", line);\n    }\n    return 0;\n}\n");
    (rust, c)
}

/// A device with its groups.
struct Case {
    name: String,
    device: Device,
    options: Options,
    groups: Vec<Group>,
}

impl Case {
    fn in_c(&self, compiler: &str, table: CTable) -> Result<(), String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let writes = table == CTable::Compact;
        let session = Session::of(&self.device, &self.groups, writes);
        let mut options = self.options.clone();
        options.table = table;
        generate_with(folder, &self.device, "c", &options);
        std::fs::write(folder.join("driver.c"), programs(&self.groups, writes).1)
            .map_err(|error| error.to_string())?;
        let programs = host(cc(compiler, folder).args(["-O1", "-I.", "-o", "in-c", "od.c", "driver.c"]));
        let compare = |output: &str| session.compare(&self.name, &format!("C, {table:?}"), output);
        programs.check(&[], &session.input, &session.expected, compare)
    }
}

fn run(cases: &[Case]) {
    let mut batch = Batch::new(&[]);
    for Case { name, device, options, groups } in cases {
        let generated = generate(device, Target::RUST, options).unwrap();
        let session = Session::of(device, groups, true);
        batch.add(name, &generated, &programs(groups, true).0, &(session.input, session.expected));
    }
    batch.build();
    let compiler = c_compiler();
    for_all(cases, |case| {
        let session = Session::of(&case.device, &case.groups, true);
        batch.check(&case.name, &session.input, |output| session.compare(&case.name, "Rust", output))?;
        let Some(compiler) = &compiler else { return Ok(()) };
        let in_c = |table| case.in_c(compiler, table).map_err(|error| format!("{}: {error}", case.name));
        in_c(CTable::Compact).and_then(|()| in_c(CTable::Structs))
    });
}

/// Each language saves the expected image and loads the image of the other language.
#[test]
fn images_are_the_same_in_both_languages() {
    let chosen = ["odd", "all-types.eds", "io-401.eds"];
    let devices = devices().into_iter().filter(|(name, _)| chosen.contains(&name.as_str()));
    let cases = devices.map(|(name, device)| {
        let groups = GROUPS.into_iter().filter(|&group| !members(&device, group).is_empty()).collect();
        Case { name, device, options: options(), groups }
    });
    let cases: Vec<Case> = cases.collect();
    assert_eq!(cases.len(), chosen.len());
    run(&cases);
}

/// Groups stated in the description with names that are not identifiers, are keywords, or are taken.
#[test]
fn stated_groups_get_names_of_their_own() {
    let mut device = odd::device();
    let stated = [
        ("速度", "group"),
        ("type", "type_"),
        ("*/ } #error", "error"),
        ("self", "self_"),
        ("tpdo1", "tpdo1_group"),
        ("Data", "data_group"),
        ("a 1", "a_1"),
        ("A-1", "a_1_3201"),
        ("a1", "a1"),
        ("node_id", "node_id_3203"),
        ("option", "option"),
        ("\u{202E}", "group_3205"),
        (" RAM ", ""),
        ("rom", ""),
    ];
    let mut groups = Vec::new();
    let indexes: Vec<u16> = device.objects.range(0x3100..).map(|(&index, _)| index).collect();
    let mut free = indexes.into_iter().filter(|index| !matches!(index, 0x3100 | 0x3101));
    for (name, field) in stated {
        let index = free.next().unwrap();
        let stack = StackOptions { storage_group: Some(name.into()), ..StackOptions::default() };
        device.objects.get_mut(&index).unwrap().main.stack = Some(Box::new(stack));
        if !field.is_empty() {
            groups.push(group(field, index, index));
        }
    }
    run(&[Case { name: "stated".to_owned(), device, options: Options::default(), groups }]);
}

#[test]
fn what_belongs_to_no_struct_or_should_not_is_reported() {
    let mut device = device(&support::fixtures().join("eds/io-401.eds"));
    let store = device.objects.get_mut(&0x1010).unwrap();
    let command = store.subs.get(1).unwrap().clone();
    assert!([2, 3].map(|sub| store.subs.insert(sub, command.clone())).iter().all(Option::is_none));
    let told = |groups: &[&str]| {
        let mut options = Options::default();
        options.groups = groups.iter().map(|group| group.parse().unwrap()).collect();
        let generated = generate(&device, Target::named("c").unwrap(), &options).unwrap();
        let header = String::from_utf8(generated.files[0].contents.clone()).unwrap();
        let notes: Vec<String> = generated.notes.iter().map(ToString::to_string).collect();
        (header, notes)
    };
    let (plain, _) = told(&[]);
    assert_eq!(told(&["1000-FFFF=ram"]).0, plain);
    let (header, notes) = told(&["1000-1FFF=COMM", "6000-9FFF=APP", "B000-BFFF=NONE"]);
    for line in ["#define OD_COMM_STORE_SUB_INDEX 2u\n", "#define OD_APP_STORE_SUB_INDEX 3u\n"] {
        assert!(header.contains(line), "{header}");
    }
    assert!(!told(&["1000-9FFF=BOTH"]).0.contains("STORE_SUB_INDEX 2u"));
    insta::assert_snapshot!("group_notes", notes.join("\n"));
}

/// The size report includes the structs of groups.
#[test]
fn sizes_are_those_of_the_compilers() {
    let press = device(&support::fixtures().join("xdd/press-402.xdd"));
    let all = device(&support::fixtures().join("eds/all-types.eds"));
    let cases = [
        ("odd", odd::device(), options()),
        ("all types", all, options()),
        ("press", press, Options::default()),
    ];
    let report = |device: &Device, target, options: &Options| {
        let sizes = size(device, Target::named(target).unwrap(), options).unwrap();
        let Sizes::Known(SizeReport { total: report, .. }) = sizes else { panic!("no sizes of `{target}`") };
        (report.flash, report.ram)
    };
    let mut batch = Batch::new(&["-Adead-code"]);
    for (name, device, options) in &cases {
        let generated = generate(device, Target::RUST, options).unwrap();
        batch.add(name, &generated, crate::size::RUST, &report(device, "rust", options));
    }
    batch.build();
    for (name, device, options) in cases {
        let (flash, ram) = report(&device, "rust", &options);
        let compare = |output: &str| {
            let (rows, measured) = output.trim().split_once(' ').unwrap();
            let is_so = measured == ram.to_string() && rows.parse::<usize>().unwrap() < flash;
            if is_so { Ok(()) } else { Err(format!("{name}: {output}, but {flash} {ram} reported")) }
        };
        batch.check(name, "", compare).unwrap();
        let Some(compiler) = c_compiler() else { continue };
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        generate_with(folder, &device, "c", &options);
        std::fs::write(folder.join("size.c"), crate::size::C).unwrap();
        let (flash, ram) = report(&device, "c", &options);
        let programs = host(cc(&compiler, folder).args(["-I.", "-o", "in-c", "size.c"]));
        programs.expect(&[], &format!("{flash} {ram}\n")).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// The examples of the documentation with their tables.
#[test]
fn the_examples_of_the_documentation_run() {
    let page =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/guides/storage.md")).unwrap();
    let example = |language: &str| {
        let (_, rest) = page.split_once(&format!("```{language}\n")).unwrap();
        rest.split_once("```\n").unwrap().0
    };
    let mut options = Options::default();
    options.groups = vec!["1014-1017=PERSIST_COMM".parse().unwrap()];
    options.hooks = ["1010:1".parse().unwrap()].into();
    let device = device(&support::fixtures().join("eds/io-401.eds"));
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for target in ["rust", "c"] {
        let notes = generate_with(folder, &device, target, &options).notes;
        assert!(
            notes.iter().all(|note| note.message.starts_with("SDOs cannot write PDO mappings")),
            "{notes:?}"
        );
    }
    std::fs::write(folder.join("example.rs"), example("rust")).unwrap();
    host(rustc(folder).args(["-o", "in-rust", "example.rs"])).succeed().unwrap();
    std::fs::write(folder.join("example.c"), example("c")).unwrap();
    if let Some(compiler) = c_compiler() {
        host(cc(&compiler, folder).args(["-o", "in-c", "od.c", "example.c"])).succeed().unwrap();
    }
}

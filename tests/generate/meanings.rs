//! Enumerations and bit fields: the compiled code agrees with the model, bit by bit.

use std::fmt::Write;
use std::path::Path;

use objdict::generate::{Options, Target, generate};
use objdict::model::{
    Access, AllowedValues, ApplicationProcess, BitStruct, DataType, DataTypeRef, Device, Entry, EnumValue,
    Enumeration, Labels, Meaning, Object, ObjectType, Parameter, ScaledValue, SimpleType, TypeDefinition,
    TypeShape, Value, VarDeclaration,
};

use crate::batch::Batch;
use crate::compile::{c_compiler, cc, generate_into};
use crate::odd::{entry, of_type};
use crate::processors::{build, host};
use crate::{device, for_all, support};

/// Test words.
const WORDS: [u64; 6] =
    [0, u64::MAX, 0x5555_5555_5555_5555, 0x1234_5678_9ABC_DEF0, 0x8000_8000_8080_8080, 0xD05];

fn devices() -> Vec<(String, Device)> {
    let fixture = |name: &str| (name.to_owned(), device(&support::fixtures().join("xdd").join(name)));
    let mut devices: Vec<_> =
        ["valve.xdd", "press-402.xdd", "drive-402.xdd", "io-401.xdd"].map(fixture).into();
    devices.push(("odd".to_owned(), odd()));
    devices
}

/// A device with named values that no fixture has.
fn odd() -> Device {
    let mut device = Device::default();
    let mut process = ApplicationProcess::default();
    let mut put = |index: u16, data_type: DataType, shape: TypeShape| {
        let id = format!("T{index:X}");
        let name = if index.is_multiple_of(2) { "Mode" } else { "*/ \u{202E}`" };
        process.data_types.push(TypeDefinition {
            name: name.into(),
            unique_id: id.as_str().into(),
            labels: Labels::default(),
            shape,
        });
        let parameter =
            Parameter { data_type: Some(DataTypeRef::Defined(id.into())), ..Parameter::default() };
        device.objects.insert(index, var(data_type, parameter));
    };
    let values = |values: &[(&str, &str)]| TypeShape::Enum {
        size: None,
        values: values
            .iter()
            .map(|(name, value)| EnumValue { labels: label(name), value: Some((*value).into()) })
            .collect(),
        base: None,
    };
    put(
        0x2000,
        DataType::INTEGER64,
        values(&[("least", "-9223372036854775808"), ("-", "-1"), ("most", "0x7FFFFFFFFFFFFFFF")]),
    );
    put(0x2001, DataType::UNSIGNED64, values(&[("most", "0xFFFFFFFFFFFFFFFF"), ("least", "0")]));
    put(0x2002, DataType::BOOLEAN, values(&[("off", "0"), ("on", "1"), ("maybe", "2")]));
    put(0x2003, DataType::BOOLEAN, values(&[("true", "1")]));
    put(
        0x2004,
        DataType::INTEGER24,
        values(&[("least", "-8388608"), ("hex", "0xFFFFFF"), ("too much", "0x1000000")]),
    );
    put(0x2005, DataType::INTEGER32, values(&[("least", "-2147483648"), ("Self", "1"), ("self", "2")]));
    let names = [
        ("None", "0"),
        ("Some", "1"),
        ("continue", "2"),
        ("", "3"),
        ("速度", "4"),
        ("a b", "5"),
        ("A-B", "6"),
        ("a b", "5"),
        ("b", "5"),
        ("x1", "7"),
        ("X 1", "8"),
        ("X_1_8", "9"),
        ("*/ \"", "10"),
        ("A", "11"),
        ("a", "11"),
        ("shift", "12"),
        ("MASK", "13"),
        ("int", "14"),
        ("too much", "256"),
        ("below", "-1"),
        ("no number", "one"),
    ];
    put(0x2006, DataType::UNSIGNED8, values(&names));
    put(
        0x2007,
        DataType::UNSIGNED8,
        values(
            &(0..256)
                .map(|number: i32| number.to_string())
                .collect::<Vec<_>>()
                .iter()
                .map(|number| ("n", number.as_str()))
                .collect::<Vec<_>>(),
        ),
    );
    put(0x2008, DataType::REAL32, values(&[("one", "1")]));
    let member = |name: &str, start: Option<&str>, size: &str, signed: bool| VarDeclaration {
        name: name.into(),
        start: start.map(Into::into),
        size: Some(size.into()),
        signed: Some(signed),
        data_type: Some(DataTypeRef::Simple(SimpleType::Bitstring)),
        ..VarDeclaration::default()
    };
    let parts = |members: Vec<VarDeclaration>| TypeShape::Struct { members };
    put(
        0x2100,
        DataType::INTEGER24,
        parts(vec![
            member("bit", None, "1", true),
            member("top", Some("19"), "5", true),
            member("too long", Some("22"), "5", false),
        ]),
    );
    put(
        0x2101,
        DataType::UNSIGNED64,
        parts(vec![
            member("all", None, "64", false),
            member("signed", Some("0"), "64", true),
            member("last", Some("63"), "1", false),
        ]),
    );
    put(
        0x2102,
        DataType::INTEGER8,
        parts(vec![
            member("get", None, "4", false),
            member("get", None, "4", true),
            member("", Some("0"), "8", false),
        ]),
    );
    put(
        0x2103,
        DataType::UNSIGNED40,
        parts(vec![member("match", Some("30"), "10", true), member("get shift", Some("0"), "30", false)]),
    );
    put(0x2104, DataType::INTEGER64, parts(vec![member("high", Some("32"), "32", true)]));
    put(0x2105, DataType::INTEGER16, parts(vec![member("no bits", None, "0", false)]));
    let named = |name: &str, value: &str| ScaledValue {
        value: value.into(),
        labels: label(name),
        ..ScaledValue::default()
    };
    for index in [0x2200, 0x2201] {
        let allowed =
            AllowedValues { values: vec![named("on", "1"), named("", "2")], ..AllowedValues::default() };
        let parameter = Parameter { allowed_values: Some(allowed), ..Parameter::default() };
        device.objects.insert(index, var(DataType::UNSIGNED16, parameter));
    }
    device.application.push(process);
    device
}

fn label(name: &str) -> Labels {
    if name.is_empty() { Labels::default() } else { Labels::name("en", name) }
}

fn var(data_type: DataType, parameter: Parameter) -> Object {
    let main = Entry {
        name: "Mode".into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(Access::Rw),
        default: (data_type != DataType::REAL32 && data_type != DataType::BOOLEAN)
            .then_some(Value::Unsigned(0)),
        parameter: Some(Box::new(parameter)),
        ..Entry::default()
    };
    Object { main, ..Object::default() }
}

/// The addresses at the end of a comment.
fn addresses(comment: &str) -> Vec<(u16, u8)> {
    let list = comment.rsplit(": ").next().unwrap_or_default();
    let hex = |text: &str| {
        let digits: String = text.chars().filter(char::is_ascii_hexdigit).collect();
        u16::from_str_radix(digits.trim_start_matches("00").get(..).unwrap_or_default(), 16).unwrap_or(0)
    };
    let address = |entry: &str| {
        let (index, sub) = entry.split_once(" sub-index ")?;
        let index = index.trim_start_matches("values of ");
        Some((hex(&index.replace("0x", "")), hex(&sub.replace("0x", "")) as u8))
    };
    list.split(", ").filter_map(address).collect()
}

/// Data per entry.
type OfEntries<T> = Vec<((u16, u8), T)>;

/// All enumerations and words of a device, including the enumerations of bit fields.
fn model(device: &Device) -> (OfEntries<Enumeration<'_>>, OfEntries<BitStruct<'_>>) {
    let meanings = device.meanings();
    let (mut enums, mut words) = (Vec::new(), Vec::new());
    let is_disabled = |index: u16| {
        device.objects[&index].main.stack.as_ref().is_some_and(|stack| stack.disabled == Some(true))
    };
    for ((index, sub), _) in crate::oracle::facts_of(device).filter(|((index, _), _)| !is_disabled(*index)) {
        match meanings.of(index, sub) {
            Some(Meaning::Enumeration(enumeration)) if !enumeration.values.is_empty() => {
                enums.push(((index, sub), enumeration));
            }
            Some(Meaning::BitStruct(word)) if !word.fields.is_empty() => {
                let of_fields = word.fields.iter().filter_map(|field| field.values.clone());
                enums.extend(of_fields.map(|values| ((index, sub), values)));
                words.push(((index, sub), word));
            }
            _ => {}
        }
    }
    (enums, words)
}

/// The value of a bit field, and the word with another value, computed bit by bit.
fn part_of(word: u64, first: u8, bits: u8, is_signed: bool) -> i128 {
    let set = |bit: u8| i128::from(word >> (first + bit) & 1);
    let number: i128 = (0..bits).map(|bit| set(bit) << bit).sum();
    if is_signed && set(bits - 1) == 1 { number - (1 << bits) } else { number }
}

fn word_with(word: u64, first: u8, bits: u8, value: u64) -> u64 {
    (0..64).fold(0, |result, bit: u8| {
        let from_value = (first..first + bits).contains(&bit);
        let set = if from_value { value >> (bit - first) & 1 } else { word >> bit & 1 };
        result | set << bit
    })
}

/// A word as a value of the data type.
fn typed(word: u64, data_type: DataType) -> i128 {
    let bits = data_type.bit_length().unwrap_or(64);
    let is_signed = data_type.integer_range().is_some_and(|(low, _)| low < 0);
    part_of(word, 0, bits, is_signed)
}

fn rust_type(data_type: DataType) -> String {
    let bits = data_type.bit_length().unwrap_or(64);
    let letter = if data_type.integer_range().is_some_and(|(low, _)| low < 0) { 'i' } else { 'u' };
    match bits {
        1 => "bool".to_owned(),
        bits => format!("{letter}{}", bits.next_power_of_two().max(8)),
    }
}

/// The names of modules, each with the comment above it.
fn modules(text: &str, mark: &str) -> Vec<(String, String)> {
    let mut comment = "";
    let mut found = Vec::new();
    for line in text.lines() {
        if let Some(rest) = line.trim_start().strip_prefix("/// ") {
            comment = rest.trim_end_matches('.');
        } else if let Some(rest) = line.strip_prefix(mark) {
            found.push((rest.trim_end_matches(" {").to_owned(), comment.to_owned()));
        }
    }
    found
}

fn part_of_text<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    text.split_once(from).and_then(|(_, rest)| rest.split_once(to)).map_or("", |(module, _)| module)
}

/// A program that compares them; fails if they are not the expected ones.
fn in_rust(text: &str, device: &Device) -> Result<String, String> {
    let (enums, words) = model(device);
    let mut program = String::from(
        "mod od { include!(\"od.rs\"); }\n#[allow(unused_imports)]\nuse od::{Abort, Data};\nfn main() {\n",
    );
    let generated = modules(part_of_text(text, "pub mod enums {\n", "\n}\n"), "    pub enum ");
    for (at, of_model) in &enums {
        let type_ = rust_type(of_model.data_type);
        let numbers: Vec<i128> = of_model.values.iter().map(|value| value.number).collect();
        // one of the entry's enumerations has exactly these values
        let mut checks = Vec::new();
        for (name, _) in generated.iter().filter(|(_, comment)| addresses(comment).contains(at)) {
            let (low, high) = of_model.data_type.integer_range().unwrap_or_default();
            let probes =
                numbers.iter().flat_map(|number| [number - 1, *number, number + 1]).chain([0, low, high]);
            let probes = probes.filter(|number| (low..=high).contains(number));
            let check = probes.map(|number| {
                let literal = match type_.as_str() {
                    "bool" => (number == 1).to_string(),
                    type_ => format!("{number}_{type_}"),
                };
                let known = numbers.contains(&number);
                format!("(od::enums::{name}::from_value({literal}).map(|found| found.value()) == {known}.then_some({literal}) && od::enums::{name}::try_from({literal}).is_ok() == {known})")
            });
            checks.push(format!("({})", check.collect::<Vec<_>>().join(" && ")));
        }
        if checks.len() != 1 && !checks.is_empty() {
            return Err(format!("{at:?} has several enumerations"));
        }
        let check = checks.pop().ok_or_else(|| format!("{at:?} has no enumeration"))?;
        let _ = writeln!(program, "assert!({check}, \"{at:?}\");");
    }
    let module = format!("{}\n", part_of_text(text, "pub mod bits {\n", "\n}\n"));
    let generated = modules(&module, "    pub mod ");
    for (at, word) in &words {
        let (name, _) =
            generated.iter().find(|(_, comment)| addresses(comment).contains(at)).ok_or("no word")?;
        let of_word = part_of_text(&module, &format!("    pub mod {name} {{\n"), "\n    }\n");
        let parts = modules(of_word, "        pub mod ");
        if parts.len() != word.fields.len() {
            return Err(format!("{parts:?} where {:?} were expected", word.fields));
        }
        for ((part, _), field) in parts.iter().zip(&word.fields) {
            let (first, bits, signed) = (field.first, field.bits, field.is_signed);
            for bit_word in WORDS {
                let argument = format!("{}_{}", typed(bit_word, word.data_type), rust_type(word.data_type));
                let path = format!("od::bits::{name}::{part}");
                let own_word = typed(bit_word, word.data_type) as u64;
                let expected = part_of(own_word, first, bits, signed);
                let _ = writeln!(program, "assert_eq!({path}::get({argument}) as i128, {expected});");
                let value = part_of(bit_word, 0, bits, signed);
                let literal = match rust_type(field.data_type()).as_str() {
                    "bool" => (value != 0).to_string(),
                    type_ => format!("{value}_{type_}"),
                };
                let expected = typed(word_with(own_word, first, bits, value as u64), word.data_type);
                let _ =
                    writeln!(program, "assert_eq!({path}::with({argument}, {literal}) as i128, {expected});");
            }
            let _ =
                writeln!(program, "assert_eq!(u64::from(od::bits::{name}::{part}::MASK), {});", field.mask());
        }
    }
    program.push_str("}\n");
    Ok(program)
}

/// The macros below each comment of a bit field in the header.
fn macros(text: &str) -> Vec<(String, Vec<String>)> {
    let mut found: Vec<(String, Vec<String>)> = Vec::new();
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("/** ") {
            found.push((rest.trim_end_matches(" */").to_owned(), Vec::new()));
        } else if let (Some(rest), Some((_, names))) = (line.strip_prefix("#define "), found.last_mut()) {
            names.push(rest.split([' ', '(']).next().unwrap_or_default().to_owned());
        }
    }
    found
}

fn in_c(folder: &Path, text: &str, compiler: &str, device: &Device) -> Result<(), String> {
    let (enums, words) = model(device);
    let start = if enums.is_empty() { "/* Bit fields of entries" } else { "/* Named values of entries" };
    let section = part_of_text(text, start, "/** A time of day");
    let (of_enums, of_words) = match section.split_once("/* Bit fields of entries") {
        Some(parts) => parts,
        None => (section, ""),
    };
    let (of_enums, of_words) = (macros(of_enums), macros(of_words));
    let mut program = String::from("#include <stdio.h>\n#include \"od.h\"\nint main(void)\n{\n");
    let mut expected: Vec<String> = Vec::new();
    for (at, enumeration) in &enums {
        let (_, names) =
            of_enums.iter().find(|(comment, _)| addresses(comment).contains(at)).ok_or("no values")?;
        let mut numbers: Vec<i128> = enumeration.values.iter().map(|value| value.number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let is_signed = enumeration.data_type.integer_range().is_some_and(|(low, _)| low < 0);
        for name in names {
            // selects one of them
            let terms = numbers.iter().map(|number| {
                let literal = match *number {
                    number if number == i128::from(i64::MIN) => "INT64_MIN".to_owned(),
                    number if is_signed => format!("INT64_C({number})"),
                    number => format!("UINT64_C({number})"),
                };
                format!("({name} == {literal})")
            });
            let _ = writeln!(program, "printf(\"%d\\n\", {});", terms.collect::<Vec<_>>().join(" + "));
            expected.push("1".to_owned());
        }
        let least: std::collections::BTreeSet<_> = numbers.iter().collect();
        if names.len() < least.len() {
            return Err(format!("{names:?} for {numbers:?}"));
        }
    }
    for (at, word) in &words {
        let (_, names) =
            of_words.iter().find(|(comment, _)| addresses(comment).contains(at)).ok_or("no parts")?;
        let names: Vec<&str> = names.iter().filter_map(|name| name.strip_suffix("_WITH")).collect();
        let is_signed = word.data_type.integer_range().is_some_and(|(low, _)| low < 0);
        for (name, field) in names.iter().zip(&word.fields) {
            let (first, bits, signed) = (field.first, field.bits, field.is_signed);
            for bit_word in WORDS {
                let own_word = typed(bit_word, word.data_type) as u64;
                let cast = rust_type(word.data_type).replace('i', "int").replace('u', "uint");
                let argument = format!("({cast}_t)UINT64_C({own_word})");
                let _ = writeln!(program, "printf(\"%lld\\n\", (long long){name}_GET({argument}));");
                expected.push((part_of(own_word, first, bits, signed) as i64).to_string());
                let value = part_of(bit_word, 0, bits, signed) as u64;
                let _ = writeln!(
                    program,
                    "printf(\"%lld\\n\", (long long){name}_WITH({argument}, (int64_t)UINT64_C({value})));"
                );
                let with = typed(word_with(own_word, first, bits, value), word.data_type);
                expected.push(if is_signed { with.to_string() } else { (with as i64).to_string() });
            }
            let _ = writeln!(program, "printf(\"%llu\\n\", (unsigned long long){name}_MASK);");
            expected.push(field.mask().to_string());
        }
        if names.len() != word.fields.len() {
            return Err(format!("{names:?} for {:?}", word.fields));
        }
    }
    program.push_str("    return 0;\n}\n");
    std::fs::write(folder.join("meanings.c"), &program).map_err(|error| error.to_string())?;
    let programs = host(cc(compiler, folder).args(["-I.", "-Wno-type-limits", "-o", "in-c", "meanings.c"]));
    programs.check(&[], "", &expected, |output| {
        let answers: Vec<&str> = output.lines().collect();
        match expected.iter().zip(&answers).position(|(expected, answer)| expected != answer) {
            None if expected.len() == answers.len() => Ok(()),
            at => {
                let at = at.unwrap_or_default();
                let asked = program.lines().filter(|line| line.starts_with("printf")).nth(at);
                Err(format!("`{}` where `{}` was expected: {asked:?}", answers[at], expected[at]))
            }
        }
    })
}

#[test]
fn enumerations_and_bit_fields_are_those_of_the_model() {
    let compiler = c_compiler();
    let text = |generated: &objdict::generate::Generated| {
        String::from_utf8_lossy(&generated.files[0].contents).into_owned()
    };
    let mut batch = Batch::new(&[]);
    for (name, device) in devices() {
        let generated = generate(&device, Target::RUST, &Options::default()).unwrap();
        let program = in_rust(&text(&generated), &device);
        batch.add(&name, &generated, &program.unwrap_or_else(|error| panic!("{name}: {error}")), &());
    }
    batch.build();
    for_all(&devices(), |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        batch.check(name, "", |_| Ok(())).map_err(fail)?;
        let Some(compiler) = &compiler else { return Ok(()) };
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        in_c(folder, &text(&generate_into(folder, device, "c")), compiler, device).map_err(fail)
    });
}

#[test]
fn what_has_no_meaning_in_code_is_noted() {
    let [in_rust, in_c] =
        [Target::RUST, Target::C].map(|target| generate(&odd(), target, &Options::default()).unwrap());
    assert_eq!(in_rust.notes, in_c.notes);
    let notes: Vec<String> = in_rust.notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        notes,
        [
            "0x2002sub0: `2` of `maybe` is not a valid BOOLEAN",
            "0x2004sub0: `0x1000000` of `too much` is not a valid INTEGER24",
            "0x2006sub0: `256` of `too much` is not a valid UNSIGNED8",
            "0x2006sub0: `-1` of `below` is not a valid UNSIGNED8",
            "0x2006sub0: `one` of `no number` is not a valid UNSIGNED8",
            "0x2008sub0: values of REAL32 are not numbers and cannot have names",
            "0x2100sub0: the member `too long` ends at bit 26, but a value of INTEGER24 at bit 23",
            "0x2105sub0: the member `no bits` is not part of a word: `0` is not a number of bits",
        ]
    );
}

#[test]
fn the_valve_reads_as_people_would_write_it() {
    let valve = device(&support::fixtures().join("xdd/valve.xdd"));
    let program = r#"
        mod od { include!("od.rs"); }
        use od::bits::status_word;
        use od::enums::{ChannelState, ValveMode};
        fn main() {
            let mut data = od::Data::new(5);
            assert_eq!(ValveMode::try_from(data.get(od::MODE)), Ok(ValveMode::Manual));
            assert_eq!(ValveMode::AUTOMATIC, ValveMode::ClosedLoop);
            assert_eq!(ValveMode::from_value(7), None);
            data.set(od::MODE, ValveMode::Service.value()).unwrap();
            assert_eq!(data.get(od::MODE), -1);
            let status = data.get(od::STATUS);
            assert_eq!(ChannelState::from_value(status_word::state::get(status)), Some(ChannelState::Working));
            assert_eq!(status_word::trim::get(status), 13);
            let status = status_word::trim::with(status, -3);
            assert_eq!((status_word::trim::get(status), status_word::ready::get(status)), (-3, true));
            assert_eq!(ChannelState::from_value(data.get(od::CHANNEL_STATES.at(2))), Some(ChannelState::BrokenWire));
        }
    "#;
    let mut batch = Batch::new(&["-Adead-code"]);
    batch.add("valve", &generate(&valve, Target::RUST, &Options::default()).unwrap(), program, &());
    batch.build();
    batch.check("valve", "", |_| Ok(())).unwrap();
}

/// Words that the device profile defines, where the description says nothing of them.
/// Prints which numbers are two states.
const STATES: &str = r#"
#include <stdio.h>
#include "od.h"
#define PRINT(state) \
    for (word = 0u; word < 0x80u; word++) { \
        if ((OD_STATUSWORD_STATE_GET(word | 0x200u) & state##_MASK) == state) { \
            printf("%u ", word); \
        } \
    }

int main(void)
{
    unsigned int word;
    PRINT(OD_STATUSWORD_STATE_OPERATION_ENABLED)
    printf("- ");
    PRINT(OD_STATUSWORD_STATE_NOT_READY_TO_SWITCH_ON)
    printf("-");
    return 0;
}
"#;

#[test]
fn words_of_a_profile_have_the_names_of_its_document() {
    let drive = device(&support::fixtures().join("eds/drive-402.eds"));
    let program = r#"
        mod od { include!("od.rs"); }
        use od::bits::{controlword, statusword};
        use od::enums::{ModesOfOperation, StatuswordState};
        fn main() {
            let mut data = od::Data::new(5);
            assert_eq!(data.set(od::MODES_OF_OPERATION, ModesOfOperation::CyclicSynchronousPosition.value()), Ok(()));
            assert_eq!(data.get(od::MODES_OF_OPERATION), 8);
            assert_eq!((ModesOfOperation::from_value(-1), ModesOfOperation::from_value(5)), (None, None));
            // whether the voltage is enabled is no matter of the state
            for word in [0x0227, 0x0237] {
                let state = StatuswordState::from_value(statusword::state::get(word));
                assert_eq!(state, Some(StatuswordState::OperationEnabled));
                assert_eq!(statusword::voltage_enabled::get(word), word == 0x0237);
            }
            assert_eq!(StatuswordState::from_value(statusword::state::get(0x0008)), Some(StatuswordState::Fault));
            let word = controlword::enable_voltage::with(controlword::quick_stop_off::with(0, true), true);
            assert_eq!((word, controlword::fault_reset::get(0x0080)), (0x0006, true));
        }
    "#;
    let mut batch = Batch::new(&["-Adead-code"]);
    batch.add("drive", &generate(&drive, Target::RUST, &Options::default()).unwrap(), program, &());
    batch.build();
    batch.check("drive", "", |_| Ok(())).unwrap();

    let text = |device: &Device, target: Target, file: usize| {
        let generated = generate(device, target, &Options::default()).unwrap();
        String::from_utf8(generated.files[file].contents.clone()).unwrap()
    };
    let header = text(&drive, Target::C, 0);
    for line in [
        "#define OD_STATUSWORD_STATE_OPERATION_ENABLED 39u ",
        "#define OD_STATUSWORD_STATE_OPERATION_ENABLED_MASK 111u ",
        "#define OD_STATUSWORD_STATE_NOT_READY_TO_SWITCH_ON 0u ",
        "#define OD_STATUSWORD_STATE_NOT_READY_TO_SWITCH_ON_MASK 79u ",
        "#define OD_MODES_OF_OPERATION_HOMING 6 ",
        "#define OD_CONTROLWORD_OF_THE_MODE_4_SHIFT 4u ",
        "#define OD_CONTROLWORD_OF_THE_MODE_9_SHIFT 9u ",
    ] {
        assert!(header.contains(line), "no `{line}`");
    }
    if let Some(compiler) = c_compiler() {
        let folder = tempfile::tempdir().unwrap();
        generate_into(folder.path(), &drive, "c");
        std::fs::write(folder.path().join("states.c"), STATES).unwrap();
        let programs = build(cc(&compiler, folder.path()).args(["-I.", "-o", "states", "states.c"]));
        programs.expect(&[], "39 55 - 0 16 32 48 -").unwrap();
    }
    let encoder = text(&device(&support::fixtures().join("eds/encoder-406.eds")), Target::RUST, 0);
    assert!(encoder.contains("pub mod operating_parameters") && encoder.contains("Clockwise = 0,"));
    // the elements of an array have one word
    let mut io = device(&support::fixtures().join("eds/io-401.eds"));
    let subs =
        (1..=2).map(|sub| (sub, entry(&format!("Input {sub}"), DataType::UNSIGNED8, Access::Rw, None)));
    io.objects.insert(0x6421, of_type(ObjectType::Array, "Trigger", subs));
    let entries =
        "/// `Trigger`: `0x6421` sub-index `0x01`, `0x6421` sub-index `0x02`.\n    pub mod trigger {";
    assert!(text(&io, Target::RUST, 0).contains(entries));
    // the names of the device come first
    let mut own = drive;
    let mode = &mut own.objects.get_mut(&0x6060).unwrap().main;
    let value = ScaledValue { value: "1".into(), labels: label("Press"), ..ScaledValue::default() };
    let allowed = AllowedValues { values: vec![value], ..AllowedValues::default() };
    mode.parameter = Some(Box::new(Parameter { allowed_values: Some(allowed), ..Parameter::default() }));
    let text = text(&own, Target::RUST, 0);
    let modes = part_of_text(&text, "pub enum ModesOfOperation {", "}");
    assert!(modes.contains("Press = 1,") && !modes.contains("ProfilePosition"));
}

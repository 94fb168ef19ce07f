//! A spelling is one number everywhere, or none: a list of spellings is put into each place where a file or an argument has a value.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::PathBuf;

use objdict::configure::{Setting, SettingsFile, configure};
use objdict::diagnostic::{Applicability, Diagnostic};
use objdict::download::ConciseDcf;
use objdict::fix;
use objdict::format::network::NetworkFile;
use objdict::format::patch::{Patch, apply};
use objdict::format::{self, Description, Format, concise};
use objdict::model::{DataType, Device, Entry, Field, Value};
use objdict::source::{SourceFile, SourceOptions};
use objdict_model::literal::Intended;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

use crate::fix::folders;
use crate::support;
use crate::support::skips::sample;

/// The node that formulas are evaluated for.
const NODE: u8 = 2;

/// The types, with their words in `device.toml`.
const TYPES: [(DataType, &str); 5] = [
    (DataType::UNSIGNED32, "u32"),
    (DataType::INTEGER16, "i16"),
    (DataType::UNSIGNED8, "u8"),
    (DataType::BOOLEAN, "bool"),
    (DataType::REAL32, "f32"),
];

/// The bytes of the number that each spelling is.
type Read = Vec<Option<Vec<u8>>>;

/// A place of values, and what it reads.
type Door = (&'static str, fn(&[&str], DataType, &str) -> Read);

/// Lines of CiA 306: `010` is octal, and a comment may follow.
const LINES: [Door; 2] = [("EDS", of_eds), ("DCF", of_dcf)];

/// Attributes of CiA 311, which has the values of CiA 306 and no comments in them.
const ATTRIBUTES: [Door; 2] = [("XDD", of_xdd), ("XDC", of_xdc)];

/// Texts that are written for objdict: nothing is a comment, and `010` is no number.
const WRITTEN: [Door; 7] = [
    ("--set", of_argument),
    ("settings", of_settings),
    ("bus.yml", of_bus),
    ("network.toml", of_network),
    ("device.toml", of_toml),
    ("patch", of_patch),
    ("cdcf.txt", of_concise),
];

fn bytes(value: Option<&Value>, data_type: DataType) -> Option<Vec<u8>> {
    match value? {
        formula @ Value::NodeId(_) => formula.resolve(data_type, NODE)?.to_bytes(data_type),
        value => value.to_bytes(data_type),
    }
}

fn index(position: usize) -> u16 {
    0x2000 + u16::try_from(position).unwrap()
}

/// The numbers of objects from 2000h on.
fn of_objects(
    device: &Device,
    count: usize,
    data_type: DataType,
    value: fn(&Entry) -> Option<&Value>,
) -> Read {
    let number = |position| bytes(value(device.entry(index(position), 0)?.as_ref()), data_type);
    (0..count).map(number).collect()
}

fn read(name: &str, text: &str, format: Format) -> Description {
    format::read(SourceFile::from_text(name, text), format)
}

fn eds(texts: &[&str], data_type: DataType, key: &str) -> String {
    let mut eds = String::new();
    for (position, text) in texts.iter().enumerate() {
        let (index, data_type) = (index(position), data_type.0);
        writeln!(
            eds,
            "[{index:X}]\nParameterName=a\nObjectType=7\nDataType={data_type}\nAccessType=rw\n{key}={text}"
        )
        .unwrap();
    }
    eds
}

fn of_eds(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let description = read("a.eds", &eds(texts, data_type, "DefaultValue"), Format::Eds);
    of_objects(description.device(), texts.len(), data_type, |entry| entry.default.as_ref())
}

fn of_dcf(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let description = read("a.dcf", &eds(texts, data_type, "ParameterValue"), Format::Dcf);
    of_objects(description.device(), texts.len(), data_type, Entry::configured_value)
}

fn xml(texts: &[&str], data_type: DataType, attribute: &str) -> String {
    let xdd = std::fs::read_to_string(support::fixtures().join("xdd/valve.xdd")).unwrap();
    let (start, rest) = xdd.split_once("<q2:CANopenObjectList").unwrap();
    let (_, end) = rest.split_once("</q2:CANopenObjectList>").unwrap();
    let mut xml = format!("{start}<q2:CANopenObjectList>");
    for (position, text) in texts.iter().enumerate() {
        let (index, data_type) = (index(position), data_type.0);
        let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
        write!(xml, "<CANopenObject index=\"{index:X}\" name=\"a\" objectType=\"7\" dataType=\"{data_type:04X}\" accessType=\"rw\" {attribute}=\"{text}\" />").unwrap();
    }
    xml + "</q2:CANopenObjectList>" + end
}

fn of_xdd(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let description = read("a.xdd", &xml(texts, data_type, "defaultValue"), Format::Xdd);
    of_objects(description.device(), texts.len(), data_type, |entry| entry.default.as_ref())
}

fn of_xdc(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let description = read("a.xdc", &xml(texts, data_type, "actualValue"), Format::Xdc);
    of_objects(description.device(), texts.len(), data_type, Entry::configured_value)
}

/// An EDS with an object for each spelling.
fn plain(texts: &[&str], data_type: DataType) -> String {
    eds(&vec!["0"; texts.len()], data_type, "DefaultValue")
}

fn set(texts: &[&str], data_type: DataType, setting: impl Fn(&str) -> Option<Setting>) -> Read {
    let description = read("a.eds", &plain(&texts[..1], data_type), Format::Eds);
    let number = |text: &&str| {
        let assigned = configure(description.device(), NODE, &[setting(text)?]).ok()?;
        bytes(Some(&assigned[0].value), data_type)
    };
    texts.iter().map(number).collect()
}

fn of_argument(texts: &[&str], data_type: DataType, _: &str) -> Read {
    set(texts, data_type, |text| Setting::value(&format!("2000={text}")).ok())
}

fn of_settings(texts: &[&str], data_type: DataType, _: &str) -> Read {
    set(texts, data_type, |text| {
        let file = SettingsFile::parse(&format!("[set]\n2000 = '{text}'\n")).ok()?;
        file.settings.into_iter().next()
    })
}

fn of_downloads(network: &str, texts: &[&str], data_type: DataType) -> Read {
    // the tests of this file use the same doors at once
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("a.eds"), plain(texts, data_type)).unwrap();
    let file = NetworkFile::read(SourceFile::from_text("network", network), folder, &Default::default());
    let node = &file.compiled().unwrap().slaves[0];
    let number = |position| {
        let download = node.downloads.0.iter().find(|download| download.index == index(position))?;
        Some(download.data.to_vec())
    };
    (0..texts.len()).map(number).collect()
}

fn of_bus(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let mut bus = format!("master: {{node_id: 1}}\na:\n  dcf: a.eds\n  node_id: {NODE}\n  sdo:\n");
    for (position, text) in texts.iter().enumerate() {
        writeln!(bus, "    - {{index: {}, value: '{text}'}}", index(position)).unwrap();
    }
    of_downloads(&bus, texts, data_type)
}

fn of_network(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let mut network = format!(
        "[bus]\nmanager = \"m\"\n[manager]\nid = 1\n[node.a]\nfile = \"a.eds\"\nid = {NODE}\n[node.a.set]\n"
    );
    for (position, text) in texts.iter().enumerate() {
        writeln!(network, "{:X} = '{text}'", index(position)).unwrap();
    }
    of_downloads(&network, texts, data_type)
}

fn of_toml(texts: &[&str], data_type: DataType, word: &str) -> Read {
    let mut toml = "format = \"objdict-device/1\"\n".to_owned();
    for (position, text) in texts.iter().enumerate() {
        writeln!(toml, "[object.{:X}]\nname = \"a\"\ntype = \"{word}\"\ndefault = '{text}'", index(position))
            .unwrap();
    }
    let description = read("device.toml", &toml, Format::Toml);
    of_objects(description.device(), texts.len(), data_type, |entry| entry.default.as_ref())
}

fn of_patch(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let mut patch = "format = \"objdict-patch/1\"\n".to_owned();
    for (position, text) in texts.iter().enumerate() {
        writeln!(
            patch,
            "[[change]]
at = \"{:X}\"
set = {{ value = '{text}' }}
reason = \"r\"",
            index(position)
        )
        .unwrap();
    }
    let patch = Patch::read(SourceFile::from_text("a.patch.toml", &*patch));
    let patched = apply(read("a.eds", &plain(texts, data_type), Format::Dcf), &[patch.into()]);
    of_objects(patched.device(), texts.len(), data_type, Entry::configured_value)
}

fn of_concise(texts: &[&str], data_type: DataType, _: &str) -> Read {
    let number = |text: &&str| {
        let ConciseDcf(downloads) =
            concise::parse(&format!("2000:00 {data_type} {text}\n"), Some(NODE)).ok()?;
        Some(downloads[0].data.to_vec())
    };
    texts.iter().map(number).collect()
}

/// Spellings of manuals, of Python, C and IEC 61131, and mistakes.
const SPELLINGS: [&str; 5] = [
    "16#3E8|$NODEID+16#200|10#20|2#0|0x10#A|1;2|0x1234;0x5678|100//2|1#|1;|1 ;2|1 #2|1 //2|1 /2|5 # five|5; five|5 ;",
    "0x10 // ten|$NODEID+1 # x|$NODEID+1#x|1.5 # x|1.5#x|true # x|true#x|0|1|-1|+1|010|07|00|-010|09|0x|0xg|0x1_0|1_000|0b11",
    "0o17|1e3|1.0|1.5|.5|5.|-0.5|inf|nan|0x3F800000|0xFFFF|0xFFFFFFFF|4294967295|4294967296|65535|300|-32768|0x10UL|10u|1.5f",
    "true|False|yes|100h|$64|&H64|H64|0X1F|0x1f|1 2|1,2|1,5|1:30|--1|+-1|0x-1|$NODEID|$NODEID+0x200|$nodeid + 512",
    "0x200+$NODEID|$NODEID+010|$NODEID-1|$NODEID+$NODEID|$NODEID+|NODEID+1|0x100000000|18446744073709551616|1%",
];

fn descriptions() -> Vec<PathBuf> {
    let mut files = support::files("", &["eds", "dcf"]);
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        folders(&PathBuf::from(folder), &mut files);
    }
    files
}

/// The spellings above, those of real files, and generated ones; short ones first, so that the first failure is the smallest.
fn spellings() -> Vec<String> {
    let mut all: BTreeSet<String> =
        SPELLINGS.iter().flat_map(|line| line.split('|')).map(str::to_owned).collect();
    for path in descriptions() {
        let text = String::from_utf8_lossy(&std::fs::read(path).unwrap()).into_owned();
        for line in text.lines().filter_map(|line| line.split_once('=')) {
            if ["DefaultValue", "ParameterValue", "LowLimit", "HighLimit"].contains(&line.0) {
                all.insert(line.1.trim().to_owned());
            }
        }
    }
    let mut runner = TestRunner::deterministic();
    for pattern in [
        "[0-9A-Fx#;/$+ .-]{1,6}",
        "(0x|16#|\\$NODEID ?\\+ ?|-)?[0-9A-F]{1,9}( ?[;#]| ?//|[uUlLhf]|\\+)?[0-9]?",
    ] {
        let texts = proptest::string::string_regex(pattern).unwrap();
        for _ in 0..400 {
            all.insert(texts.new_tree(&mut runner).unwrap().current().trim().to_owned());
        }
    }
    // a quote is that of YAML and TOML, and a setting has words of its own
    all.retain(|text| {
        let is_line = !text.is_empty()
            && text.len() < 40
            && !text.contains(|c: char| c == '\'' || c.is_control() || c == '\u{FFFD}');
        is_line && !text.eq_ignore_ascii_case("default")
    });
    let mut all: Vec<String> = all.into_iter().collect();
    all.sort_by_key(String::len);
    all
}

/// The part before a comment.
fn uncommented(text: &str) -> &str {
    let is_blank = |byte: u8| byte == b' ' || byte == b'\t';
    let bytes = text.as_bytes();
    let begins = |at: usize| match bytes[at] {
        b';' => is_blank(bytes[at - 1]) || bytes.get(at + 1).is_none_or(|next| is_blank(*next)),
        b'#' => is_blank(bytes[at - 1]),
        b'/' => is_blank(bytes[at - 1]) && bytes.get(at + 1) == Some(&b'/'),
        _ => false,
    };
    (1..text.len()).find(|&at| begins(at)).map_or(text, |at| text[..at].trim_ascii_end())
}

/// Whether a text has a number with a leading zero that is another one in decimal.
fn is_octal(text: &str) -> bool {
    text.split('+').map(|term| term.trim().trim_start_matches('-')).any(|term| {
        let digits = term.trim_end_matches(['u', 'U', 'l', 'L']);
        u64::from_str_radix(digits, 8)
            .is_ok_and(|octal| digits.starts_with('0') && digits.parse() != Ok(octal))
    })
}

/// Puts the spellings into doors, and gives the answers with the door of each.
fn answers(doors: &[Door], texts: &[&str], data_type: DataType, word: &str) -> Vec<(&'static str, Read)> {
    doors
        .iter()
        .map(|(name, read)| {
            (*name, texts.chunks(0x80).flat_map(|texts| read(texts, data_type, word)).collect())
        })
        .collect()
}

#[test]
fn a_spelling_is_one_number_everywhere_or_none() {
    let spellings = spellings();
    let whole: Vec<&str> =
        spellings.iter().map(String::as_str).filter(|text| uncommented(text) == *text).collect();
    assert!(whole.len() > 1000);
    for (data_type, word) in TYPES {
        let of_standard = answers(&[LINES, ATTRIBUTES].concat(), &whole, data_type, word);
        let written = answers(&WRITTEN, &whole, data_type, word);
        for (position, text) in whole.iter().enumerate() {
            let expected = &of_standard[0].1[position];
            if text.contains(['#', ';', '/']) {
                assert_eq!(*expected, None, "`{text}` of {data_type} is cut to a shorter number");
            }
            for (door, read) in &of_standard {
                assert_eq!(read[position], *expected, "`{text}` of {data_type} in {door}, beside EDS");
            }
            // a REAL has no octal digits
            let is_octal = data_type != DataType::REAL32 && is_octal(text);
            let expected = if is_octal { &None } else { expected };
            for (door, read) in &written {
                assert_eq!(read[position], *expected, "`{text}` of {data_type} in {door}, beside EDS");
            }
        }
    }
}

/// Files of CiA 306 have comments behind values (2,000 lines of the files that we know), although the standard has none; other texts have
/// none, because `#` and `;` begin one nowhere in a text of XML or TOML.
#[test]
fn only_a_line_has_a_comment_and_it_begins_after_a_blank() {
    let spellings = spellings();
    let commented: Vec<&str> =
        spellings.iter().map(String::as_str).filter(|text| uncommented(text) != *text).collect();
    let cores: Vec<&str> = commented.iter().map(|text| uncommented(text)).collect();
    assert!(commented.len() > 50);
    for (data_type, word) in TYPES {
        for ((door, read), (_, of_cores)) in
            answers(&LINES, &commented, data_type, word).iter().zip(answers(&LINES, &cores, data_type, word))
        {
            for (position, text) in commented.iter().enumerate() {
                assert_eq!(read[position], of_cores[position], "`{text}` of {data_type} in {door}");
            }
        }
        let others = [&ATTRIBUTES[..], &WRITTEN[..6]].concat();
        for (door, read) in answers(&others, &commented, data_type, word) {
            for (position, text) in commented.iter().enumerate() {
                assert_eq!(read[position], None, "`{text}` of {data_type} in {door}");
            }
        }
    }
    // a line of `.cdcf.txt` has comments of its own
    assert_eq!(
        of_concise(&["16 # a", "16#3", "16;3", "16 ;3"], DataType::UNSIGNED8, ""),
        [Some(vec![16]), None, None, None]
    );
}

/// CiA 306 has octal, and so has CiA 311, whose values are those of CiA 306; who writes `010` in TOML or an argument means 10 or 8.
#[test]
fn octal_is_a_number_of_the_standard_alone() {
    for (doors, number) in [(&LINES[..], Some(vec![8])), (&ATTRIBUTES, Some(vec![8])), (&WRITTEN, None)] {
        for (door, read) in answers(doors, &["010"], DataType::UNSIGNED8, "u8") {
            assert_eq!(read[0], number, "{door}");
        }
    }
    for text in ["rpdo1=010", "rpdo1=0x10 # x", "rpdo1=16#200", "rpdo1=0x200;0x300"] {
        assert!(Setting::cob_id(text).is_err(), "{text}");
    }
    // YAML 1.1, which dcfgen reads, has numbers of its own where they are not in quotes
    let bus = "master: {node_id: 1}\na:\n  dcf: a.eds\n  node_id: 2\n  sdo: [{index: 0x2000, value: 010}, {index: 0x2001, value: 0b11}, {index: 0x2002, value: 16#3}]\n";
    let read = of_downloads(bus, &["", "", ""], DataType::UNSIGNED8);
    assert_eq!(read, [Some(vec![8]), Some(vec![3]), None]);
}

/// The numbers of a description: those that it has, and those that an invalid text means beyond doubt.
fn numbers(device: &Device) -> BTreeMap<(u16, u8, String), Value> {
    let mut numbers = BTreeMap::new();
    for (&index, object) in &device.objects {
        for (sub, entry) in object.entries() {
            for (field, value) in [
                (Field::DefaultValue, entry.default.as_ref()),
                (Field::ParameterValue, entry.configured_value()),
                (Field::LowLimit, entry.low_limit.as_ref()),
                (Field::HighLimit, entry.high_limit.as_ref()),
            ] {
                let intended = || match entry.invalid_values.get(&field)?.intended(entry.implied_type()?)? {
                    Intended::Value(value) => Some(value),
                    Intended::Nothing => None,
                };
                let value = value.cloned().or_else(intended);
                let number =
                    value.filter(|value| !matches!(value, Value::Text(_) | Value::Bytes(_) | Value::Raw(_)));
                numbers.extend(number.map(|number| ((index, sub, field.to_string()), number)));
            }
        }
    }
    numbers
}

/// The numbers of real files are in `fix::safe_fixes_leave_the_device_as_it_is`.
#[test]
fn a_safe_fix_never_changes_a_number() {
    let spellings = spellings();
    let texts: Vec<&str> = spellings.iter().map(String::as_str).collect();
    for texts in sample(texts.chunks(256)) {
        for (data_type, _) in TYPES {
            let files = [
                ("a.eds", eds(texts, data_type, "DefaultValue"), Format::Eds),
                ("a.dcf", eds(texts, data_type, "ParameterValue"), Format::Dcf),
                ("a.eds", eds(texts, data_type, "HighLimit"), Format::Eds),
                ("a.xdd", xml(texts, data_type, "defaultValue"), Format::Xdd),
            ];
            for (name, text, format) in files {
                let description = read(name, &text, format);
                let before = numbers(description.device());
                let fixed = fix(description, Applicability::Safe, objdict::check);
                let after = numbers(fixed.description.device());
                for (place, number) in &before {
                    let text = texts[usize::from(place.0 - 0x2000)];
                    assert_eq!(
                        after.get(place),
                        Some(number),
                        "`{text}` of {data_type} in {name}: {place:?}"
                    );
                }
                assert_eq!(after.len(), before.len(), "{name}: a text became a number of {data_type}");
            }
        }
    }
}

/// A section with such a name: an example, and how it is made of index and rest of the standard's name.
type SectionForm = (&'static str, fn(&str, &str) -> String);

/// Index and sub-index of sections as people write them: both with the text that follows them in the standard's name.
const SECTIONS: [SectionForm; 8] = [
    ("1018hsub1", |index, rest| format!("{index}h{rest}")),
    ("1018HSUB1", |index, rest| format!("{index}H{}", rest.to_ascii_uppercase())),
    ("1018hexsub1", |index, rest| format!("{index}hex{rest}")),
    ("$1018sub1", |index, rest| format!("${index}{rest}")),
    ("16#1018sub1", |index, rest| format!("16#{index}{rest}")),
    ("0x1018sub1", |index, rest| format!("0x{index}{rest}")),
    ("1018h.1h", |index, rest| match rest.strip_prefix("sub") {
        Some(sub) => format!("{index}h.{sub}h"),
        None => format!("{index}h{rest}"),
    }),
    ("1018sub1h", |index, rest| match rest.strip_prefix("sub") {
        Some(sub) => format!("{index}sub{sub}h"),
        None => format!("{index}h{rest}"),
    }),
];

/// The text with other names of the sections of objects, and how many they are.
fn respelled(text: &str, spelled: fn(&str, &str) -> String) -> (String, usize) {
    let mut count = 0;
    let lines = text.split_inclusive('\n').map(|line| {
        let Some((name, end)) = line.strip_prefix('[').and_then(|line| line.split_once(']')) else {
            return line.to_owned();
        };
        let index =
            ["Fixed", "SubExt"].iter().find_map(|word| Some(name.find(word)? + word.len())).unwrap_or(0);
        let is_index = |index: &str| {
            index.starts_with(|first: char| ('1'..='9').contains(&first))
                && u16::from_str_radix(index, 16).is_ok()
        };
        match name.get(index..index + 4).filter(|index| is_index(index)) {
            Some(digits) => {
                count += 1;
                format!("[{}{}]{end}", &name[..index], spelled(digits, &name[index + 4..]))
            }
            None => line.to_owned(),
        }
    });
    (lines.collect(), count)
}

/// The findings but those about the names of sections, with their lines.
fn found(description: &Description) -> Vec<(&'static str, String, u32)> {
    let findings = objdict::check(description);
    let others = findings.iter().filter(|finding| finding.rule.id != "cia306/section-spelling");
    let line = |finding: &Diagnostic| {
        let start = finding.labels.first().map_or(0, |label| description.span_of(&label.at).start);
        description.source().line_column(start).line
    };
    others.map(|finding| (finding.rule.id, finding.message.to_string(), line(finding))).collect()
}

#[test]
fn a_section_is_read_as_meant() {
    let mut files = support::good_devices();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "eds" || ending == "dcf"));
    assert!(files.len() > 10);
    for path in sample(files) {
        let original = format::open(&path, &SourceOptions::default()).unwrap();
        let text = original.source().text().to_owned();
        let plain = |description: &Description| {
            format::write(description.device(), description.format(), &Default::default()).unwrap().bytes
        };
        for (example, spelled) in SECTIONS {
            let name = format!("{} as [{example}]", path.display());
            let (text, count) = respelled(&text, spelled);
            let odd = || read(original.source().name(), &text, original.format());
            assert_eq!(odd().print(), text.as_bytes(), "{name}");
            assert!(odd().device() == original.device(), "{name}");
            assert_eq!(found(&odd()), found(&original), "{name}");
            assert!(plain(&odd()) == plain(&original), "{name}");
            let findings = objdict::check(&odd());
            assert_eq!(
                findings.iter().filter(|finding| finding.rule.id == "cia306/section-spelling").count(),
                count,
                "{name}"
            );
            let fixed = |description| fix(description, Applicability::Safe, objdict::check).bytes();
            let expected = fixed(read(original.source().name(), original.source().text(), original.format()));
            assert!(fixed(odd()) == expected, "{name}");
        }
    }
}

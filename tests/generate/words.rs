//! A device with every word of generated code as a name.

use std::collections::BTreeSet;
use std::path::Path;

use objdict::generate::{Options, Target, generate};
use objdict::model::{Access, DataType, Device, ObjectType, Value};

use crate::odd::{entry, of_type, var};
use crate::support;

/// Macros of the headers of C, keywords of C++ and names that files and modules have.
const WORDS: &str = "
    EOF BUFSIZ FILENAME_MAX FOPEN_MAX SEEK_SET RAND_MAX EXIT_FAILURE CLOCKS_PER_SEC NULL TRUE FALSE
    EDOM EILSEQ ERANGE ENOENT EINVAL SIGABRT SIGFPE SIGINT SIGTERM SIG_DFL CHAR_BIT INT_MAX LONG_MIN
    UCHAR_MAX FLT_EPSILON DBL_MAX HUGE_VAL INFINITY NAN FP_NAN M_PI INT8_MAX UINT32_MAX INT64_C PRId32
    LC_ALL I assert errno stdin stdout stderr setjmp isalpha tolower signal time abs div exit main
    alignas and and_eq asm bitand bool catch char16_t class compl concept const_cast constexpr delete
    explicit export false friend mutable namespace new noexcept not nullptr operator private public
    requires static_assert template this throw true try typeid typename using virtual wchar_t xor
    self super crate mod lib main async dyn gen Bytes reset Block_read od OD stdint string stdio
";

/// A device whose objects and entries have every word of the templates as a name, and some more.
pub(crate) fn device() -> Device {
    let mut words: BTreeSet<String> = WORDS.split_ascii_whitespace().map(str::to_owned).collect();
    let folder = |name| Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    let sources = ["templates/code", "crates/objdict-device/src/table"].map(folder);
    for file in sources.iter().flat_map(|folder| support::files_below(folder, &["rs", "c", "h"])) {
        let text = std::fs::read_to_string(file).unwrap();
        let of_text = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        words.extend(of_text.map(|word| word.trim_matches('_').to_owned()));
    }
    let words = words.into_iter().filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()));
    let words: Vec<String> = words.collect();
    let mut device = Device::default();
    let kinds = [
        (DataType::UNSIGNED8, Access::Rw),
        (DataType::VISIBLE_STRING, Access::Rw),
        (DataType::UNSIGNED64, Access::Rw),
        (DataType::UNSIGNED32, Access::Const),
    ];
    for ((word, index), (data_type, access)) in words.iter().zip(0x2000..).zip(kinds.into_iter().cycle()) {
        device.objects.insert(index, var(entry(word, data_type, access, None)));
    }
    for (words, index) in words.chunks(250).zip(0x5000..) {
        let subs = words
            .iter()
            .zip(1..)
            .map(|(word, sub)| (sub, entry(word, DataType::UNSIGNED8, Access::Rw, None)));
        let count =
            entry("Count", DataType::UNSIGNED8, Access::Ro, Some(Value::Unsigned(words.len() as u64)));
        let record = of_type(ObjectType::Record, "Words", std::iter::once((0, count)).chain(subs));
        device.objects.insert(index, record);
    }
    device
}

/// The identifiers in all files of a target.
fn identifiers(device: &Device, target: Target) -> BTreeSet<String> {
    let mut options = Options::default();
    options.node_id = Some(5);
    let files = generate(device, target, &options).unwrap().files;
    let texts = files.iter().map(|file| String::from_utf8_lossy(&file.contents));
    let words = texts.flat_map(|text| {
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        words.map(str::to_owned).collect::<Vec<_>>()
    });
    words.filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')).collect()
}

/// Of several objects, entries, enumerations or words with one name none is plain.
#[test]
fn an_object_in_front_renames_no_other() {
    // these keep to the rules of the programs that they replace, where the first of equal names is plain
    let others = ["canfestival", "canopennode-v1"];
    let mut device = crate::device(&support::fixtures().join("xdd/valve.xdd"));
    let object = |number: u64| {
        let value = |name, access| entry(name, DataType::UNSIGNED16, access, Some(Value::Unsigned(number)));
        let count = entry("Count", DataType::UNSIGNED8, Access::Const, Some(Value::Unsigned(3)));
        let subs = [
            (0, count),
            (1, value("Gain", Access::Rw)),
            (2, value("Gain", Access::Rw)),
            (3, value("Limit", Access::Rw)),
        ];
        of_type(ObjectType::Record, "Axis", subs)
    };
    let single =
        |number| var(entry("Speed", DataType::UNSIGNED16, Access::Rw, Some(Value::Unsigned(number))));
    for number in 0..2 {
        device.objects.insert(0x2F10 + number, single(7));
        device.objects.insert(0x2F20 + number, object(7));
    }
    let mut longer = device.clone();
    longer.objects.insert(0x2E1F, single(7));
    longer.objects.insert(0x2E2F, object(7));
    for target in
        Target::all().filter(|target| !others.contains(&target.name()) && target.name() != "template")
    {
        let (before, after) = (identifiers(&device, target), identifiers(&longer, target));
        let is_of_the_new = |word: &&String| {
            let word = word.to_ascii_lowercase();
            word.contains("2e1f") || word.contains("2e2f")
        };
        let lost: Vec<_> = before.difference(&after).collect();
        let new: Vec<_> = after.difference(&before).filter(|word| !is_of_the_new(word)).collect();
        assert!(lost.is_empty() && new.is_empty(), "{}: without {lost:?}, with {new:?}", target.name());
    }
}

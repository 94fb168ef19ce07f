//! The constants of entries: each reads and sets what an SDO with its index and sub-index does, and what must not
//! compile does not.

use std::collections::HashSet;
use std::fmt::Write;

use objdict::generate::{Generated, Options, Target, generate};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};

use crate::batch::{Batch, Part, TABLES};
use crate::compile::{generate_into, rustc, succeed};
use crate::devices::{devices, for_all};
use crate::odd::{entry, of_type, var};
use crate::oracle::{facts_of, hex};
use crate::verdicts::Key;
use crate::{device, support};

/// A constant of the generated file.
struct Constant {
    path: String,
    /// `Handle<u16, Rw>`, `Array<u32, Ro>`.
    type_: String,
}

/// The constants in the text of the file.
fn constants(generated: &Generated) -> Vec<Constant> {
    let text = std::str::from_utf8(&generated.files[0].contents).unwrap();
    let mut module = String::new();
    let mut found = Vec::new();
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("    pub mod ") {
            module = format!("{}::", name.trim_end_matches(" {"));
        } else if line == "    }" {
            module.clear();
        }
        let Some((name, rest)) =
            line.trim_start().strip_prefix("pub const ").and_then(|rest| rest.split_once(": "))
        else {
            continue;
        };
        let Some((type_, value)) = rest.split_once(" = ") else { continue };
        if value.contains("::of(") {
            found.push(Constant { path: format!("od::{module}{name}"), type_: type_.to_owned() });
        }
    }
    found
}

const HEAD: &str = r#"
mod od { include!("od.rs"); }
use od::table::{Typed, Variable};

fn sdo(data: &od::Data, index: u16, sub: u8) -> Option<Vec<u8>> {
    let mut buffer = vec![0; od::MAX_SIZE];
    let length = data.read_entry(od::find(index, sub).unwrap(), &mut buffer).ok()?;
    buffer.truncate(length);
    Some(buffer)
}

fn bytes<T: Typed + ?Sized, A>(data: &od::Data, handle: od::Handle<T, A>) -> Vec<u8> {
    T::with_bytes(data.get(handle), handle.size(), <[u8]>::to_vec)
}

/// `get` is what an SDO reads.
fn read<T: Typed + ?Sized, A>(data: &od::Data, handle: od::Handle<T, A>) {
    let (index, sub) = (handle.index(), handle.sub());
    assert!(std::ptr::eq(handle.entry(), od::find(index, sub).unwrap()));
    let read = bytes(data, handle);
    assert_eq!(sdo(data, index, sub).unwrap_or_default(), read, "{handle:?}");
    println!("{index:04X} {sub:02X} {}", read.iter().map(|byte| format!("{byte:02X}")).collect::<String>());
}

/// `set` answers as an SDO does, and both have the same effect.
fn change<T: Typed + ?Sized, A: Variable>(data: &od::Data, handle: od::Handle<T, A>) {
    for fill in [0x00, 0x01, 0x3F, 0x7E, 0xFF] {
        let bytes = vec![fill; handle.size() & !1 | handle.size() & usize::from(handle.size() < 8)];
        let (mut ours, mut theirs, mut unchecked) = (data.clone(), data.clone(), data.clone());
        let answer = ours.set(handle, T::load(&bytes));
        // a `bool` has no invalid value, and a `Time` no void bits
        let bytes = T::with_bytes(T::load(&bytes), handle.size(), <[u8]>::to_vec);
        assert_eq!(answer, theirs.write_entry(handle.entry(), &bytes), "{handle:?} {fill:02X}");
        assert_eq!(ours, theirs, "{handle:?} {fill:02X}");
        unchecked.put(handle, T::load(&bytes));
        assert!(answer.is_err() || ours == unchecked, "{handle:?} {fill:02X}");
        assert_eq!(self::bytes(&unchecked, handle), bytes, "{handle:?} {fill:02X}");
    }
}
"#;

fn program(constants: &[Constant]) -> String {
    let mut program = HEAD.to_owned();
    program.push_str("\nfn main() {\n    let data = &od::Data::new(5);\n");
    for Constant { path, type_ } in constants {
        let is_constant = ["Const>", "Elsewhere>"].iter().any(|access| type_.ends_with(access));
        let calls = if is_constant { &["read"][..] } else { &["read", "change"] };
        for call in calls {
            match type_.starts_with("Array") {
                true => writeln!(program, "    {path}.iter().for_each(|handle| {call}(data, handle));"),
                false => writeln!(program, "    {call}(data, {path});"),
            }
            .unwrap();
        }
    }
    program.push_str("}\n");
    program
}

/// What the program prints for each entry, and more.
fn lines(device: &Device) -> Vec<String> {
    let lines = facts_of(device).map(|((index, sub), facts)| {
        format!("{index:04X} {sub:02X} {}", hex(&facts.default_on(5)).trim_matches('-'))
    });
    lines.collect()
}

/// The program of the test below.
pub(crate) fn part(name: &str, device: &Device, generated: &Generated) -> Part {
    let program = program(&constants(generated));
    Part::new(&format!("handles {name}"), &program, &lines(device)).allowing("dead_code, unused_imports")
}

#[test]
fn every_entry_has_a_constant_that_reads_and_sets_it() {
    for_all(&devices(), |(name, device)| {
        let lines = lines(device);
        TABLES.check(&format!("handles {name}"), "", |output| {
            let printed: HashSet<&str> = output.lines().collect();
            let missing = lines.iter().find(|line| !printed.contains(line.as_str()));
            missing.map_or(Ok(()), |line| Err(format!("{name}: no `{line}`")))
        })
    });
}

/// A device with an array and limits of all kinds.
fn small() -> Device {
    let mut device = Device::default();
    let limited = |name: &str, data_type, low: Value, high: Value| Entry {
        low_limit: Some(low),
        high_limit: Some(high),
        ..entry(name, data_type, Access::Rw, None)
    };
    let mut put = |index, object: Object| device.objects.insert(index, object);
    put(0x2000, var(limited("Speed", DataType::INTEGER16, Value::Signed(-100), Value::Signed(2000))));
    put(0x2001, var(limited("Gain", DataType::REAL32, Value::Real32(0.5), Value::Real32(8.0))));
    put(
        0x2002,
        var(entry("Version", DataType::VISIBLE_STRING, Access::Const, Some(Value::Text("1.2".into())))),
    );
    put(0x2003, var(entry("Serial", DataType::UNSIGNED32, Access::Const, Some(Value::Unsigned(77)))));
    put(0x2004, var(entry("Sync", DataType::UNSIGNED32, Access::Const, Some(Value::NodeId(0x80)))));
    put(0x2005, var(entry("Wide", DataType::UNSIGNED24, Access::Rw, None)));
    let subs = (1..=3)
        .map(|sub| (sub, entry("Level", DataType::UNSIGNED8, Access::Rw, Some(Value::Unsigned(sub.into())))));
    put(0x2006, of_type(ObjectType::Array, "Levels", subs));
    device
}

/// The program of what handles say, at run time and in constants.
const FACTS: &str = r#"
    mod od { include!("od.rs"); }
    const SPEED_HIGH: Option<i16> = od::SPEED.high(5);
    const SECOND: od::Handle<u8, od::Rw> = od::LEVELS.at(2);
    const ROW: Result<&od::Entry, od::Abort> = od::find(0x2006, 3);
    static BUFFER: [u8; od::MAX_SIZE] = [0; od::MAX_SIZE];
    static DATA: od::Data = od::Data::new(5);
    fn main() {
        assert_eq!((od::SPEED.low(5), SPEED_HIGH, od::SPEED.default(5)), (Some(-100), Some(2000), 0));
        assert_eq!((od::GAIN.low(5), od::GAIN.high(5)), (Some(0.5), Some(8.0)));
        assert_eq!((od::VERSION.value(), od::SERIAL.value(), od::SYNC.default(5)), (&b"1.2"[..], 77, 0x85));
        assert_eq!((DATA.get(od::VERSION), DATA.get(od::SERIAL), DATA.get(od::SYNC)), (&b"1.2"[..], 77, 0x85));
        assert_eq!((ROW.unwrap().size(), BUFFER.len(), SECOND.sub()), (1, 4, 2));
        assert_eq!((od::LEVELS.len(), od::LEVELS.get(0).is_none(), od::LEVELS.get(4).is_none()), (3, true, true));
        assert_eq!(od::LEVELS.iter().map(|level| DATA.get(level)).collect::<Vec<_>>(), [1, 2, 3]);
        let mut data = DATA.clone();
        assert_eq!(data.set(od::SPEED, 2001), Err(od::Abort::TooHigh));
        assert_eq!(data.set(od::GAIN, f32::NAN), Err(od::Abort::InvalidValue));
        assert_eq!(data.set(od::WIDE, 0x100_0000), Err(od::Abort::InvalidValue));
        assert_eq!(data, DATA);
        data.put(od::SPEED, 2001);
        data.set(od::LEVELS.at(3), 9).unwrap();
        assert_eq!((data.get(od::SPEED), data.get(od::LEVELS.at(3))), (2001, 9));
    }
"#;

#[test]
fn handles_know_their_entries() {
    let mut batch = Batch::new(&["-Adead-code"]);
    batch.add("small", &generate(&small(), Target::RUST, &Options::default()).unwrap(), FACTS, &());
    batch.build();
    batch.check("small", "", |_| Ok(())).unwrap();
}

#[test]
fn what_makes_no_sense_does_not_compile() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    generate_into(folder, &small(), "rust");
    let compile = |statement: &str, error: Option<&str>| {
        let program = format!(
            "mod od {{ include!(\"od.rs\"); }}\nfn main() {{ let mut data = od::Data::new(5); let _ = &mut data; {statement} }}\n"
        );
        std::fs::write(folder.join("main.rs"), program).unwrap();
        let mut rustc = rustc(folder);
        rustc.args(["--emit=metadata", "-Adead-code", "main.rs"]);
        let mut key = Key::new();
        key.command(&rustc);
        key.debug(&error);
        key.or_try(|| match (succeed(&mut rustc, ""), error) {
            (Ok(_), None) => Ok(()),
            (Err(errors), Some(error)) if errors.contains(error) => Ok(()),
            (result, _) => Err(format!("{statement}\n{result:?}")),
        })
        .unwrap();
    };
    compile("data.set(od::SPEED, 1).unwrap();", None);
    for (statement, error) in [
        (
            "data.set(od::SERIAL, 1).unwrap();",
            "the application cannot set an entry whose access is `table::Const`",
        ),
        ("data.put(od::SYNC, 1);", "the application cannot set an entry whose access is `table::NodeConst`"),
        (
            "data.put(od::SERIAL, 1);",
            "read it with `value()` or `get`, or describe the entry with a different access type",
        ),
        ("data.set(od::SPEED, 1_u8).unwrap();", "mismatched types"),
        ("let _ = od::SYNC.value();", "no method named `value` found"),
        ("const NONE: od::Handle<u8, od::Rw> = od::LEVELS.at(4);", "no such sub-index"),
    ] {
        compile(statement, Some(error));
    }
}

/// An object that is inserted changes no name but those that are equal to its own.
#[test]
fn names_do_not_depend_on_the_order_of_objects() {
    let paths = |device: &Device| {
        let constants = constants(&generate(device, Target::RUST, &Options::default()).unwrap());
        constants.into_iter().map(|constant| constant.path).collect::<Vec<_>>()
    };
    let mut io = device(&support::fixtures().join("eds/io-401.eds"));
    let before = paths(&io);
    io.objects.insert(0x2FFF, var(entry("Something new", DataType::UNSIGNED8, Access::Rw, None)));
    let mut after = paths(&io);
    after.retain(|path| path != "od::SOMETHING_NEW");
    assert_eq!(before, after);

    let speed = || var(entry("Speed", DataType::UNSIGNED8, Access::Rw, None));
    let mut twice = Device::default();
    twice.objects.insert(0x2001, speed());
    assert_eq!(paths(&twice), ["od::SPEED"]);
    twice.objects.insert(0x2000, speed());
    assert_eq!(paths(&twice), ["od::SPEED_2000", "od::SPEED_2001"]);
}

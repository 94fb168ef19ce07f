//! The structs of PDOs: packed bit by bit as CiA 301 defines, and unpacking gives the same frame.

use std::fmt::Write;
use std::rc::Rc;

use objdict::generate::{Options, Target, generate};
use objdict::model::{
    Access, DataType, Device, Entry, MappedObject, Object, ObjectType, Pdo, PdoKind, TypeKind, Value,
};

use crate::batch::Batch;
use crate::compile::{c_compiler, cc, generate_with};
use crate::oracle::{Facts, facts_of, hex};
use crate::processors::build;
use crate::{devices, for_all};

/// The node-ID for all frames.
const NODE_ID: u8 = 5;

/// The expected packing of a PDO, computed bit by bit.
struct Expected {
    name: String,
    bytes: usize,
    cob_id: Option<u32>,
    /// Each used bit of the frame: its position and its source.
    bits: Vec<(usize, Source)>,
}

/// The source of a frame bit.
struct Source {
    facts: Rc<Facts>,
    bit: usize,
}

impl Expected {
    /// `None` for a PDO without a struct.
    fn new(device: &Device, pdo: &Pdo<'_>) -> Option<Self> {
        if pdo.is_multiplexed() || pdo.bit_length() > 64 {
            return None;
        }
        let mut bits = Vec::new();
        let mut first = 0;
        let mut fields = 0;
        for object in pdo.mapped() {
            if let Some((count, facts)) = (!object.is_dummy()).then(|| field(device, object)).flatten() {
                fields += 1;
                let is_time = matches!(facts.kind, Some(TypeKind::TimeOfDay | TypeKind::TimeDifference));
                let facts = Rc::new(facts);
                let count = (0..count).filter(|bit| !(is_time && (28..32).contains(bit)));
                bits.extend(count.map(|bit| (first + bit, Source { facts: Rc::clone(&facts), bit })));
            }
            first += usize::from(object.bits);
        }
        let letter = if pdo.kind == PdoKind::Rpdo { 'r' } else { 't' };
        (fields > 0).then(|| Self {
            name: format!("{letter}pdo{}", pdo.number),
            bytes: first.div_ceil(8),
            cob_id: pdo.cob_id.map(|cob_id| cob_id.on_node(NODE_ID)),
            bits,
        })
    }

    /// The frame of the default values.
    fn defaults(&self) -> Vec<u8> {
        self.frame(|_, source| {
            let value = source.facts.default_on(NODE_ID);
            value.get(source.bit / 8).is_some_and(|byte| byte >> (source.bit % 8) & 1 == 1)
        })
    }

    /// The frame after unpacking: only used bits remain.
    fn unpacked(&self, frame: &[u8]) -> Vec<u8> {
        self.frame(|at, _| frame[at / 8] >> (at % 8) & 1 == 1)
    }

    /// The frame after a round trip through the dictionary: constants keep their value.
    fn stored(&self, frame: &[u8]) -> Option<Vec<u8>> {
        let is_kept = self.bits.iter().all(|(_, source)| source.facts.access.is_writable());
        is_kept.then(|| self.unpacked(frame))
    }

    fn frame(&self, is_set: impl Fn(usize, &Source) -> bool) -> Vec<u8> {
        let mut frame = vec![0; self.bytes];
        for (at, source) in &self.bits {
            if is_set(*at, source) {
                frame[at / 8] |= 1 << (at % 8);
            }
        }
        frame
    }
}

/// The bits and the entry of a field; `None` if it is not a field.
fn field(device: &Device, object: MappedObject) -> Option<(usize, Facts)> {
    let (_, facts) = facts_of(device).find(|(address, _)| *address == (object.index, object.sub))?;
    let (mapped, size) = (usize::from(object.bits), facts.size * 8);
    let bits = match facts.kind {
        _ if mapped == 0 => None,
        Some(TypeKind::Boolean) => Some(1),
        Some(TypeKind::Signed(_) | TypeKind::Unsigned(_)) => Some(mapped.min(size)),
        Some(_) if facts.data_type.byte_length().is_some() => (mapped >= size).then_some(size),
        _ => (mapped % 8 == 0 && size > 0).then_some(mapped.min(size)),
    };
    Some((bits?, facts))
}

/// Test frames: all bits, alternating bits, and some irregular ones.
fn frames(bytes: usize) -> Vec<Vec<u8>> {
    let mut state = 0x1234_5678_u32;
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    let mut frames = vec![vec![0xFF; bytes], vec![0x55; bytes], vec![0xAA; bytes]];
    frames.extend((0..5).map(|_| (0..bytes).map(|_| random()).collect()));
    frames
}

/// A device with mappings that no fixture has: single bits, parts of integers, gaps, and values across byte
/// boundaries.
fn odd() -> Device {
    let mut device = Device::default();
    let var = |name: &str, data_type, access, default: Option<Value>| Object {
        main: Entry {
            name: name.into(),
            object_type: Some(ObjectType::Var),
            data_type: Some(data_type),
            access: Some(access),
            default,
            ..Entry::default()
        },
        ..Object::default()
    };
    let unsigned = |number: u64| Some(Value::Unsigned(number));
    device.objects.insert(0x2000, var("int", DataType::BOOLEAN, Access::Rw, Some(Value::Boolean(true))));
    device.objects.insert(0x2001, var("Speed", DataType::INTEGER16, Access::Rw, Some(Value::Signed(-5))));
    device.objects.insert(0x2002, var("Wide", DataType::UNSIGNED24, Access::Rw, unsigned(0xABCDEF)));
    device.objects.insert(0x2003, var("Fine", DataType::INTEGER8, Access::Rw, Some(Value::Signed(-1))));
    device
        .objects
        .insert(0x2004, var("Long", DataType::INTEGER64, Access::Rw, Some(Value::Signed(i64::MIN))));
    device.objects.insert(0x2005, var("Real", DataType::REAL64, Access::Rw, Some(Value::Real64(0.1))));
    device.objects.insert(0x2006, var("Small real", DataType::REAL32, Access::Rw, Some(Value::Real32(-2.5))));
    device
        .objects
        .insert(0x2007, var("Text", DataType::VISIBLE_STRING, Access::Rw, Some(Value::Text("ab".into()))));
    device
        .objects
        .insert(0x2008, var("Fixed", DataType::INTEGER16, Access::Const, Some(Value::Signed(-300))));
    device
        .objects
        .insert(0x2009, var("Fixed real", DataType::REAL32, Access::Const, Some(Value::Real32(1.5))));
    device.objects.insert(
        0x200A,
        var("Fixed text", DataType::VISIBLE_STRING, Access::Const, Some(Value::Text("x\"\\".into()))),
    );
    device.objects.insert(
        0x200B,
        var("Fixed per node", DataType::UNSIGNED16, Access::Const, Some(Value::NodeId(0x180))),
    );
    device.objects.insert(
        0x200C,
        var("Fixed least", DataType::INTEGER64, Access::Const, Some(Value::Signed(i64::MIN))),
    );
    device.objects.insert(0x200D, var("int", DataType::BOOLEAN, Access::Rw, None));
    let pdos: [&[u32]; 8] = [
        &[0x2000_0001, 0x0005_0002, 0x2001_000C, 0x2002_0018, 0x2003_0005, 0x200D_0001],
        &[0x2004_0040],
        &[0x2005_0040],
        &[0x2006_0020, 0x2007_0018],
        &[0x2000_0008, 0x2001_0020, 0x2003_0003],
        &[0x2008_0010, 0x2009_0020, 0x200A_0010],
        &[0x200B_0010, 0x2000_0001],
        &[0x200C_0040],
    ];
    for (number, mapped) in (0..).zip(pdos) {
        let first = if number % 2 == 0 { 0x1A00 } else { 0x1600 };
        device.objects.insert(first + number, record(mapped));
        let cob_id = Value::NodeId(0x180 + u64::from(number));
        let cob_id = Entry {
            data_type: Some(DataType::UNSIGNED32),
            access: Some(Access::Rw),
            default: Some(cob_id),
            ..Entry::default()
        };
        let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
        let subs = std::iter::once((1, cob_id)).collect();
        device.objects.insert(first - 0x200 + number, Object { main, subs, ..Object::default() });
    }
    device
}

fn record(mapped: &[u32]) -> Object {
    let entry = |data_type, number: u32| Entry {
        data_type: Some(data_type),
        access: Some(Access::Rw),
        default: Some(Value::Unsigned(number.into())),
        ..Entry::default()
    };
    let count = entry(DataType::UNSIGNED8, u32::try_from(mapped.len()).unwrap());
    let subs = (1..).zip(mapped).map(|(sub, &object)| (sub, entry(DataType::UNSIGNED32, object)));
    let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
    Object { main, subs: std::iter::once((0, count)).chain(subs).collect(), ..Object::default() }
}

/// A program that prints frames, in Rust and in C, and the expected lines.
struct Session {
    rust: String,
    c: String,
    answers: Vec<String>,
}

impl Session {
    fn new(pdos: &[Expected]) -> Self {
        let mut session = Self { rust: RUST_HEAD.to_owned(), c: C_HEAD.to_owned(), answers: Vec::new() };
        for pdo in pdos {
            session.pdo(pdo);
        }
        session.rust.push_str("}\n");
        session.c.push_str("    return 0;\n}\n");
        session
    }

    /// Prints the defaults, then each frame unpacked, packed, and after a round trip through the dictionary.
    fn pdo(&mut self, pdo: &Expected) {
        let name = &pdo.name;
        let type_ = format!("od::pdo::{}{}", name[..1].to_uppercase(), &name[1..]);
        let Self { rust, c, answers } = self;
        writeln!(rust, "    let mut data = od::Data::new({NODE_ID});").unwrap();
        writeln!(rust, "    show(&{type_}::load(&data).pack());").unwrap();
        writeln!(c, "    {{\n    od_{name}_t pdo;\n    uint8_t frame[8];\n    od_init(&data, {NODE_ID});")
            .unwrap();
        writeln!(c, "    od_{name}_load(&data, &pdo);").unwrap();
        let show =
            format!("    od_{name}_pack(&pdo, frame);\n    show(frame, OD_{}_LENGTH);", name.to_uppercase());
        writeln!(c, "{show}").unwrap();
        answers.push(hex(&pdo.defaults()));
        for frame in frames(pdo.bytes) {
            let bytes = frame.iter().map(|byte| format!("0x{byte:02X}")).collect::<Vec<_>>().join(", ");
            writeln!(rust, "    let pdo = {type_}::unpack([{bytes}]);\n    show(&pdo.pack());").unwrap();
            writeln!(
                c,
                "    {{ static const uint8_t given[] = {{{bytes}}}; od_{name}_unpack(given, &pdo); }}"
            )
            .unwrap();
            writeln!(c, "{show}").unwrap();
            answers.push(hex(&pdo.unpacked(&frame)));
            if let Some(stored) = pdo.stored(&frame) {
                writeln!(rust, "    pdo.store(&mut data);\n    show(&{type_}::load(&data).pack());").unwrap();
                writeln!(c, "    od_{name}_store(&pdo, &data);\n    od_{name}_load(&data, &pdo);\n{show}")
                    .unwrap();
                answers.push(hex(&stored));
            }
        }
        if let Some(cob_id) = pdo.cob_id {
            writeln!(rust, "    println!(\"{{:X}}\", {type_}::cob_id({NODE_ID}));").unwrap();
            writeln!(
                c,
                "    printf(\"%lX\\n\", (unsigned long)OD_{}_COB_ID({NODE_ID}u));",
                name.to_uppercase()
            )
            .unwrap();
            answers.push(format!("{cob_id:X}"));
        }
        writeln!(rust, "    let _ = &mut data;").unwrap();
        writeln!(c, "    }}").unwrap();
    }

    fn compare(&self, name: &str, language: &str, output: &str) -> Result<(), String> {
        let lines: Vec<&str> = output.lines().collect();
        let wrong = lines.iter().zip(&self.answers).position(|(line, answer)| line != answer);
        match wrong {
            Some(at) => {
                Err(format!("{name}, {language}: line {at} is `{}`, not `{}`", lines[at], self.answers[at]))
            }
            None if lines.len() != self.answers.len() => {
                Err(format!("{name}, {language}: {} lines, not {}", lines.len(), self.answers.len()))
            }
            None => Ok(()),
        }
    }
}

const RUST_HEAD: &str = "\
mod od {
    include!(\"od.rs\");
}

fn show(frame: &[u8]) {
    println!(\"{}\", frame.iter().map(|byte| format!(\"{byte:02X}\")).collect::<String>());
}

fn main() {
";

const C_HEAD: &str = "\
#include <stdio.h>
#include \"od_pdo.h\"

static od_data_t data;

static void show(const uint8_t *frame, size_t length)
{
    size_t at;
    for (at = 0u; at < length; at++) {
        printf(\"%02X\", frame[at]);
    }
    printf(\"\\n\");
}

int main(void)
{
";

/// A device, the options, and the session with its frames.
struct Case {
    name: String,
    device: Device,
    options: Options,
    session: Session,
}

impl Case {
    fn in_c(&self, compiler: &str) -> Result<(), String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        generate_with(folder, &self.device, "c", &self.options);
        std::fs::write(folder.join("driver.c"), &self.session.c).map_err(|error| error.to_string())?;
        let mut cc = cc(compiler, folder);
        cc.args(["-I.", "-o", "in-c", "od.c", "od_pdo.c", "driver.c"]);
        let compare = |output: &str| self.session.compare(&self.name, "C", output);
        build(&cc)
            .check(&[], "", &self.session.answers, compare)
            .map_err(|error| format!("{}: {error}", self.name))
    }
}

/// All devices with their frames, and one of them again with mapped entries in structs of storage groups.
#[test]
fn frames_are_packed_as_the_description_says() {
    let mut grouped = Options::default();
    grouped.groups = ["2000-2003=FIRST", "2004-FFFF=SECOND"].map(|group| group.parse().unwrap()).to_vec();
    let plain = devices().into_iter().chain([("odd frames".to_owned(), odd())]);
    let plain = plain.map(|(name, device)| (name, device, Options::default()));
    let all = plain.chain([("odd frames in groups".to_owned(), odd(), grouped)]);
    let cases: Vec<Case> = all
        .filter_map(|(name, device, options)| {
            let pdos: Vec<Expected> = device.pdos().filter_map(|pdo| Expected::new(&device, &pdo)).collect();
            let session = (!pdos.is_empty()).then(|| Session::new(&pdos))?;
            Some(Case { name, device, options, session })
        })
        .collect();
    assert!(cases.len() > 9, "{}", cases.len());
    let mut batch = Batch::new(&[]);
    for Case { name, device, options, session } in &cases {
        let generated = generate(device, Target::RUST, options).unwrap();
        batch.add(name, &generated, &session.rust, &session.answers);
    }
    batch.build();
    let compiler = c_compiler();
    for_all(&cases, |case| {
        batch.check(&case.name, "", |output| case.session.compare(&case.name, "Rust", output))?;
        compiler.as_ref().map_or(Ok(()), |compiler| case.in_c(compiler))
    });
}

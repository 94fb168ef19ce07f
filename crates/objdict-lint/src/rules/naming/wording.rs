//! Names that are placeholders, too long, duplicated, or contradict their entry or the standard.

use std::collections::HashMap;

use crate::demands::{self, Against};
use crate::diagnostic::{Findings, Fix, Text, say, sub_index};
use crate::model::{DataType, Device, DeviceKind, Field, ModulePart, Object, Part, PdoKind, Place, TypeKind};
use crate::profile::index_in;
use crate::rule::rules;
use crate::{EntryAt, Facts, PdoFacts};

rules! {
    source: "Not in a standard";

    "naming/duplicate-denotation" = DUPLICATE_DENOTATION, Note, Device(duplicate_denotation);
    summary: "two entries have the same denotation",
    checks: "The denotations of a DCF (the application's names for entries) must differ. The finding is at the first repetition and lists the others.",
    why: "An application that looks up variables by denotation gets the first of the two.",
    example: "`Denotation=Door open` in `[6000sub1]` and in `[6000sub2]`",
    remedy: "Give each entry a unique denotation.",
    source: "CiA 306-1 §5.3",

    "naming/duplicate-module" = DUPLICATE_MODULE, Note, Device(duplicate_module);
    summary: "two modules have the same name and order code",
    checks: "Two modules must not have both the same `ProductName` and the same `OrderCode`.",
    why: "Users who assemble a station by names cannot distinguish the two modules.",
    example: "`ProductName=DI8` and `OrderCode=750-430` in `[M1ModuleInfo]` and in `[M2ModuleInfo]`",
    remedy: "Add the version to the name, or remove one of the modules.",
    source: "CiA 306-1 §6.3",

    "naming/duplicate-object-name" = DUPLICATE_OBJECT_NAME, Note, Device(duplicate_object_name);
    summary: "two objects have the same name",
    checks: "The names of objects from 2000h on must differ. Objects that are 800h apart are not checked: they are the same object of several axes or channels. Neither are 5800h to 5FFFh, where masters store the PDOs of other nodes. The finding is at the first repetition and lists the others.",
    why: "Users cannot distinguish the objects, libraries that look up objects by name return the first one, and code generators have to add numbers.",
    example: "`ParameterName=Setpoint` in `[2000]` and in `[2001]`",
    remedy: "Add a number or a word to the names.",
    source: "Not in a standard; python-canopen, for example, looks up objects by name",

    "naming/long-name" = LONG_NAME, Note, Entry(long_name);
    summary: "a name is longer than a line of text",
    checks: "Each name must have at most 100 characters. The limit of CiA 306-1, 241, applies to the line and has its own rule.",
    why: "Tools show names in columns and truncate them. Identifiers generated from them lose their end, and often the text is a description.",
    example: "A `ParameterName` of two sentences",
    remedy: "Shorten the name; move explanations to a comment or the manual.",

    "naming/name-of-other-object" = NAME_OF_OTHER_OBJECT, Note,
        Facts(name_of_other_object), explains Around ["duplicate-object-name"];
    summary: "an object has the standard name of a different object",
    checks: "No object may have the name that the CiA document gives to a different index. No entry may have the name of a different sub-index of the same object. Only letters and digits are compared, ignoring case. `Reserved` is not a name, and the beginning of the object's own name is accepted. The rule reports one finding per device.",
    why: "Users and tools that look up names write the deceleration to the acceleration. Either the index or the name is wrong; usually two names were swapped.",
    example: "`[6083]` with `ParameterName=Profile deceleration`, which is 6084h",
    remedy: "Write the name of the document, or move the object.",
    source: "CiA 301 and the device profiles, names of objects",

    "naming/placeholder" = PLACEHOLDER, Note, Entry(placeholder);
    summary: "a name is a placeholder",
    checks: "Reports default names of tools and reminders of the author: `New object`, `Unnamed`, `Untitled`, `No name`, `TODO`, `TBD`, `FIXME`, `xxx`, `asdf`, `foo`, `bar`. A name with a template variable, such as `@NAME@`, `${NAME}` and `{{ name }}`, is reported too.",
    why: "Users of the device cannot know the purpose of the entry.",
    example: "`ParameterName=New object`",
    remedy: "Write a descriptive name.",

    "naming/repeated-blanks" = REPEATED_BLANKS, Note, Entry(repeated_blanks), fix Unsafe;
    summary: "a name has extra spaces",
    checks: "A name must not start or end with a space or have two spaces in a row.",
    why: "Tools that look up an entry by the visible name do not find it. Comparisons show changes that are not visible.",
    example: "`ParameterName=Motor  speed`",
    remedy: "Remove the extra spaces.",

    "naming/same-identifier" = SAME_IDENTIFIER, Note, Object(same_identifier);
    summary: "two names of an object result in the same identifier",
    checks: "The names of an object's sub-indexes from 2000h on must differ in more than case, spaces and punctuation. Equal names have their own finding. Only the first pair in an object is shown.",
    why: "Identifiers in generated code consist of letters, digits and `_`: `Gain +` and `gain -` become the same. The generator has to add numbers, which change when an entry is inserted.",
    example: "`ParameterName=Limit +` in `[2000sub1]` and `ParameterName=Limit -` in `[2000sub2]`",
    remedy: "Express the difference in words: `Limit positive` and `Limit negative`.",

    "naming/template-text" = TEMPLATE_TEXT, Warning, Device(template_text);
    summary: "a field of the header contains template text",
    checks: "The rule checks names, descriptions and order codes of the file, the device, the node and the modules. They must not be one of the words of `naming/placeholder` or begin with `TODO`, `TBD` or `FIXME`. They must not have a template variable, such as `@VENDOR@`, `${VENDOR}`, `{{ vendor }}`, `%VENDOR%` and `<vendor>`.",
    why: "The file was created from a template, and a value was not filled in. Configuration tools show the text to users and file the device under it.",
    example: "`VendorName=@VENDOR@`",
    remedy: "Write the value, or correct the script that fills the template.",

    "naming/type-in-name" = TYPE_IN_NAME, Note, Entry(type_in_name);
    summary: "the type in the name differs from the type of the entry",
    checks: "If a name ends with a type, such as `_U16`, `INT8` or `(REAL32)`, the type must match width and kind of the entry.",
    why: "The type was changed but the name was not, or vice versa. Programs that rely on the name read the wrong number of bytes.",
    example: "`ParameterName=Speed_U16` with `DataType=0x0007`",
    remedy: "Correct the type or the name.",

    "naming/unordered-numbering" = UNORDERED_NUMBERING, Note, Object(unordered_numbering);
    summary: "the numbers in element names are not in the order of the sub-indexes",
    checks: "Numbered element names of an object from 2000h on must ascend with the sub-indexes, from any start. Only objects whose elements share a name followed by consecutive numbers are checked. Numbers with gaps or repetitions have a different purpose and are not checked.",
    why: "Usually lines were swapped: software that sets element 3 by its name sets a different element.",
    example: "`[2000sub1]` to `[2000sub3]` called `Input 1`, `Input 3` and `Input 2`",
    remedy: "Number the names in the order of the sub-indexes.",

    "naming/wrong-pdo-direction" = WRONG_PDO_DIRECTION, Warning, Pdo(wrong_pdo_direction);
    summary: "the name of a PDO contains the wrong direction",
    checks: "Names of RPDO objects (14xxh and 16xxh) and their sub-indexes must not mention only a transmit PDO or TPDO. Names of TPDO objects (18xxh and 1Axxh) must not mention only a receive PDO or RPDO.",
    why: "Users who configure the device by names configure the wrong PDO. Usually the object was copied.",
    example: "`ParameterName=Receive PDO 1 parameter` in `[1800]`",
    remedy: "Correct the name or the index.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "naming/wrong-pdo-number" = WRONG_PDO_NUMBER, Warning, Facts(wrong_pdo_number);
    summary: "the name of a PDO contains a different PDO's number",
    checks: "If the names of PDO objects (14xxh, 16xxh, 18xxh and 1Axxh) contain only one number, it must be the number of the PDO. Numbers that begin at 0 are accepted, and so are numbers that begin again at every 64th PDO, as on a further axis.",
    why: "Users who configure the device by names configure the wrong PDO. Usually the object was copied.",
    example: "`ParameterName=RPDO 1 mapping parameter` in `[1601]`",
    remedy: "Correct the name or the index.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",
}

/// The maximum length of a name that is not reported.
const LONGEST_NAME: usize = 100;

fn long_name(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    // another rule reports a line that is too long
    if name.len() <= LONGEST_NAME || name.len() > 241 {
        return;
    }
    let length = name.chars().count();
    if length > LONGEST_NAME {
        let message = say!("the name has {} characters", length);
        let finding = LONG_NAME.at(at.field(Field::ParameterName), message);
        findings.push(finding.help("shorten the name, and move the description to a comment or the manual"));
    }
}

const PLACEHOLDERS: [&str; 14] = [
    "new object",
    "new entry",
    "new item",
    "unnamed",
    "untitled",
    "no name",
    "noname",
    "todo",
    "tbd",
    "fixme",
    "xxx",
    "asdf",
    "foo",
    "bar",
];

fn placeholder(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    if !is_placeholder_word(name) && !has_variable(name) {
        return;
    }
    let message = say!("`{}` is a placeholder", name);
    findings.push(PLACEHOLDER.at(at.field(Field::ParameterName), message).help("write a descriptive name"));
}

fn is_placeholder_word(text: &str) -> bool {
    // the longest word has ten characters
    text.len() <= 10 && PLACEHOLDERS.iter().any(|placeholder| placeholder.eq_ignore_ascii_case(text))
}

/// Beginning and end of variables in templates.
const VARIABLES: [(&str, &str); 5] = [("@", "@"), ("${", "}"), ("{{", "}}"), ("<%", "%>"), ("%", "%")];

/// Whether a string has a variable that a template engine should have replaced.
fn has_variable(text: &str) -> bool {
    let is_word = |text: &str| {
        let text = text.trim_matches([' ', '=']);
        !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_alphabetic() || byte == b'_')
    };
    let has = |&(start, end): &(&str, &str)| {
        let behind = text.split_once(start).and_then(|(_, behind)| behind.split_once(end));
        behind.is_some_and(|(word, _)| is_word(word) && (start.len() > 1 || !word.contains(' ')))
    };
    text.bytes().any(|byte| matches!(byte, b'@' | b'{' | b'%')) && VARIABLES.iter().any(has)
}

/// Whether a header field still contains template text.
fn is_template(text: &str) -> bool {
    let is_reminder = |word: &&str| text.strip_prefix(*word).is_some_and(|rest| rest.starts_with([':', ' ']));
    let is_row = |digit: u8| text.len() > 2 && text.bytes().all(|byte| byte.eq_ignore_ascii_case(&digit));
    let inside = text.strip_prefix('<').and_then(|text| text.strip_suffix('>'));
    is_placeholder_word(text)
        || has_variable(text)
        || is_row(b'x')
        || ["TODO", "TBD", "FIXME"].iter().any(is_reminder)
        || inside.is_some_and(|text| !text.is_empty() && !text.contains(['@', '.', '<']))
}

fn template_text(device: &Device, findings: &mut Findings) {
    let mut check = |part: Part, fields: &[(Field, &Option<String>)]| {
        for (field, text) in fields {
            let Some(text) = text.as_deref().map(str::trim).filter(|text| is_template(text)) else {
                continue;
            };
            let message = say!("`{}` is `{}`, left over from a template", field, text);
            let finding = TEMPLATE_TEXT.at(Place::of(part.clone()).field(field.clone()), message);
            findings.push(finding.help("write the value"));
        }
    };
    if let Some(info) = &device.file_info {
        let names = [(Field::CreatedBy, &info.created_by), (Field::ModifiedBy, &info.modified_by)];
        check(Part::FileInfo, &names);
        check(Part::FileInfo, &[(Field::Description, &info.description)]);
    }
    if let Some(info) = &device.device_info {
        let names = [(Field::VendorName, &info.vendor_name), (Field::ProductName, &info.product_name)];
        check(Part::DeviceInfo, &names);
        check(Part::DeviceInfo, &[(Field::OrderCode, &info.order_code)]);
    }
    if let Some(node) = &device.commissioning {
        let names = [(Field::NodeName, &node.node_name), (Field::NetworkName, &node.network_name)];
        check(Part::Commissioning, &names);
    }
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        let names = [(Field::ProductName, &module.product_name), (Field::OrderCode, &module.order_code)];
        check(Part::Module(number, ModulePart::Info), &names);
    }
}

fn repeated_blanks(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    let bytes = name.as_bytes();
    let at_end = [bytes.first(), bytes.last()].into_iter().flatten().any(|&byte| byte == b' ');
    let is_repeated = || bytes.windows(2).any(|pair| pair == b"  ");
    if !at_end && !is_repeated() {
        return;
    }
    let clean = name.split(' ').filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
    if clean.is_empty() {
        return;
    }
    let place = at.field(Field::ParameterName);
    let message = say!("`{}` has extra spaces", name);
    let fix = Fix::risky("remove the extra spaces").set(place.clone(), clean.as_str());
    findings.push(REPEATED_BLANKS.at(place, message).help(say!("write `{}`", clean)).fix(fix));
}

fn type_in_name(at: &EntryAt<'_>, findings: &mut Findings) {
    // some editors give sub-index 0 the name of the object, and a mapping contains the names of its objects
    let is_own = at.sub != Some(0) && PdoKind::of_mapping(at.index).is_none();
    let Some(data_type) = at.entry.data_type.filter(|_| is_own) else { return };
    let Some((named, text)) = named_type(&at.entry.name) else { return };
    let is_other = data_type.kind() != named && data_type.bit_length().is_some();
    if !is_other || !at.holds_value() {
        return;
    }
    let message = say!("the name ends with `{}`, but the entry is {}", text, data_type);
    let finding = TYPE_IN_NAME.at(at.field(Field::DataType), message);
    let finding = finding.label(at.field(Field::ParameterName), "the name");
    findings.push(finding.help("correct the type or the name"));
}

/// The type at the end of a name: a known word and a width, after a character that is not a letter or digit.
fn named_type(name: &str) -> Option<(TypeKind, &str)> {
    let inner = name.trim_end_matches([')', ']']);
    let word = inner.rsplit(|c: char| !c.is_ascii_alphanumeric()).next()?;
    let kind = word.trim_end_matches(|c: char| c.is_ascii_digit());
    if word.len() == inner.len() || kind.len() == word.len() {
        return None;
    }
    let bits: u8 = word.get(kind.len()..)?.parse().ok()?;
    let matches = |words: &[&str]| words.iter().any(|known| known.eq_ignore_ascii_case(kind));
    let named = match bits {
        8 | 16 | 24 | 32 | 40 | 48 | 56 | 64 if matches(&["u", "uint", "unsigned"]) => {
            TypeKind::Unsigned(bits)
        }
        8 | 16 | 24 | 32 | 40 | 48 | 56 | 64 if matches(&["int", "integer", "sint"]) => {
            TypeKind::Signed(bits)
        }
        32 if matches(&["real", "float"]) => DataType::REAL32.kind(),
        64 if matches(&["real", "float"]) => DataType::REAL64.kind(),
        _ => return None,
    };
    Some((named, word))
}

fn unordered_numbering(index: u16, object: &Object, findings: &mut Findings) {
    if index < 0x2000 || object.compact.is_some() {
        return;
    }
    let Some((first, second)) = first_disorder(object) else { return };
    let name = |sub| object.subs.get(sub).map_or("", |entry| &entry.name);
    let message = say!(
        "sub-index {} is `{}`, but sub-index {} is `{}`",
        sub_index(first),
        name(first),
        sub_index(second),
        name(second)
    );
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding = UNORDERED_NUMBERING.at(place(second), message).label(place(first), "the previous element");
    findings.push(finding.help("number the names in the order of the sub-indexes"));
}

/// The first two neighbours whose numbers do not ascend, if the numbers of all elements are consecutive.
fn first_disorder(object: &Object) -> Option<(u8, u8)> {
    let mut elements = object.subs.iter().filter(|&(sub, _)| sub > 0 && sub < 0xFF);
    let (sub, entry) = elements.next()?;
    let (stem, start) = numbered(&entry.name)?;
    let (mut last, mut lowest, mut highest, mut sum, mut count) =
        ((sub, start), start, start, u64::from(start), 1u64);
    let mut broken = None;
    for (sub, entry) in elements {
        let (_, number) = numbered(&entry.name).filter(|(other, _)| *other == stem)?;
        if number <= last.1 {
            broken.get_or_insert((last.0, sub));
        }
        (lowest, highest) = (lowest.min(number), highest.max(number));
        (sum, count, last) = (sum + u64::from(number), count + 1, (sub, number));
    }
    let (lowest, highest) = (u64::from(lowest), u64::from(highest));
    let is_row = highest - lowest + 1 == count && (lowest + highest) * count == 2 * sum;
    broken.filter(|_| is_row && is_unique(object, lowest))
}

/// Whether all numbers are different; the caller has checked that they are in a range as long as the number
/// of elements.
fn is_unique(object: &Object, lowest: u64) -> bool {
    let mut seen = [false; 256];
    object.subs.iter().filter(|&(sub, _)| sub > 0 && sub < 0xFF).all(|(_, entry)| {
        let at =
            numbered(&entry.name).and_then(|(_, number)| usize::try_from(u64::from(number) - lowest).ok());
        at.and_then(|at| seen.get_mut(at)).is_some_and(|seen| !std::mem::replace(seen, true))
    })
}

/// A name that ends with a number: its stem and the number.
fn numbered(name: &str) -> Option<(&str, u32)> {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = name.get(stem.len()..)?;
    if stem.is_empty() || number.is_empty() { None } else { Some((stem, number.parse().ok()?)) }
}

/// The name of sub-indexes that must not be there.
const RESERVED_NAME: &str = "Reserved";

fn name_of_other_object(facts: &Facts<'_>, findings: &mut Findings) {
    let mut wrong = Vec::new();
    for one in demands::applied(facts.device, facts.options) {
        let objects = || one.profile.objects().map(|object| (object.name, (object.first, object.last)));
        for against in demands::against(facts.device, &one).filter(|against| !against.object.orphan) {
            if let Some((other, _)) = place_of_other(objects(), against.object.name(), against.facts.name) {
                let place = Place::object(against.index);
                let other = index_in(one.block, other);
                wrong.push((
                    place,
                    say!(
                        "{:04X}h has the name of {:04X}h, `{}`",
                        against.index,
                        other,
                        against.object.name()
                    ),
                ));
            }
            entries_with_other_names(&against, &mut wrong);
        }
    }
    for (place, message) in wrong {
        let finding = NAME_OF_OTHER_OBJECT.at(place.field(Field::ParameterName), message);
        findings.push(finding.help("write the name from the document, or move the object"));
    }
}

/// Adds the entries that have the name of a different entry of the same object.
fn entries_with_other_names(against: &Against<'_>, wrong: &mut Vec<(Place, Text)>) {
    let entries = || against.facts.entries().map(|entry| (entry.name, (entry.first, entry.last)));
    for at in against.entries() {
        // another rule reports reserved sub-indexes
        let Some(sub) = at.sub.filter(|_| at.facts.name != RESERVED_NAME) else { continue };
        if let Some((other, _)) = place_of_other(entries(), &at.entry.name, at.facts.name) {
            let message =
                say!("{} has the name of sub-index {}, `{}`", at, sub_index(other), &*at.entry.name);
            wrong.push((Place::entry(against.index, sub), message));
        }
    }
}

/// The first and last number of the only entry with this name, unless the name is the beginning of `own`.
fn place_of_other<'a, T: PartialEq>(
    named: impl Iterator<Item = (&'a str, (T, T))>,
    name: &str,
    own: &str,
) -> Option<(T, T)> {
    // the beginning of the object's own name is an abbreviation: `Program data` of `Program data of nodes`
    let mut own = plain(own);
    if plain(name).all(|char| own.next() == Some(char)) {
        return None;
    }
    let mut alike = named.filter(|(other, _)| !matches!(*other, "" | RESERVED_NAME) && is_alike(name, other));
    let (_, place) = alike.next()?;
    (alike.next().is_none() && place.0 == place.1).then_some(place)
}

/// Whether names differ only in spaces, case and signs. The asterisk of values in increments is compared (CiA 402).
fn is_alike(name: &str, other: &str) -> bool {
    // most names begin with different letters, so comparing bytes is faster
    let letter = |text: &str| text.bytes().next().filter(u8::is_ascii_alphanumeric);
    let first = letter(name).zip(letter(other));
    name == other
        || first.is_none_or(|(one, other)| one.eq_ignore_ascii_case(&other)) && plain(name).eq(plain(other))
}

fn plain(name: &str) -> impl Iterator<Item = char> {
    let named = name.chars().filter(|&char| char.is_alphanumeric() || char == '*');
    named.flat_map(char::to_lowercase)
}

const RECEIVE_WORDS: [&str; 3] = ["rpdo", "receive", "rxpdo"];
const TRANSMIT_WORDS: [&str; 3] = ["tpdo", "transmit", "txpdo"];

fn wrong_pdo_direction(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let (own, other) = match pdo.kind {
        PdoKind::Rpdo => (RECEIVE_WORDS, TRANSMIT_WORDS),
        PdoKind::Tpdo => (TRANSMIT_WORDS, RECEIVE_WORDS),
    };
    let objects = [(pdo.communication_index(), pdo.communication), (pdo.mapping_index(), pdo.mapping)];
    let says = |name: &str, words: [&str; 3]| words.iter().any(|word| contains_word(name, word));
    for (index, object) in objects.into_iter().filter_map(|(index, object)| Some((index, object?))) {
        let entries = object.described().map(|(sub, entry)| (sub, &*entry.name));
        for (sub, name) in entries.filter(|(_, name)| says(name, other) && !says(name, own)) {
            let which = sub.map_or(Text::default(), |sub| say!(" sub-index {}", sub_index(sub)));
            let message = say!("{:04X}h{} belongs to {}, but is named `{}`", index, which, pdo, name);
            let place = Place::at(index, sub).field(Field::ParameterName);
            findings.push(WRONG_PDO_DIRECTION.at(place, message).help("correct the name or the index"));
        }
    }
}

/// The numbers of PDO names that begin again at a further axis.
const PDOS_OF_AXIS: u16 = 64;

fn wrong_pdo_number(facts: &Facts<'_>, findings: &mut Findings) {
    let highest = facts.pdos.iter().map(|facts| facts.pdo.number).max().unwrap_or(0).max(8);
    let objects = facts.pdos.iter().flat_map(|PdoFacts { pdo, .. }| {
        let objects = [(pdo.communication_index(), pdo.communication), (pdo.mapping_index(), pdo.mapping)];
        objects.into_iter().filter_map(move |(index, object)| {
            let name = object?.name();
            Some((pdo, index, name, number_of_pdo(name).filter(|&number| number <= highest)?))
        })
    });
    let named: Vec<_> = objects.collect();
    let matches = |first| named.iter().filter(|&&(pdo, .., number)| number + 1 == pdo.number + first).count();
    let first = u16::from(matches(1) >= matches(0));
    for (pdo, index, name, number) in named {
        let own = pdo.number - 1;
        if number == own + first || number == own % PDOS_OF_AXIS + first {
            continue;
        }
        let message = say!("{:04X}h belongs to {}, but is named `{}`", index, pdo, name);
        let place = Place::object(index).field(Field::ParameterName);
        findings.push(WRONG_PDO_NUMBER.at(place, message).help("correct the name or the index"));
    }
}

/// The number in a name with the word PDO, if it is the only number and not part of a word.
fn number_of_pdo(name: &str) -> Option<u16> {
    let start = name.find(|c: char| c.is_ascii_digit())?;
    let (before, rest) = name.split_at(start);
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    let (number, after) = rest.split_at(end);
    let is_pdo = before.as_bytes().last_chunk::<3>().is_some_and(|end| end.eq_ignore_ascii_case(b"pdo"));
    let is_of_word = before.ends_with(char::is_alphabetic) && !is_pdo;
    let is_only = !after.contains(|c: char| c.is_ascii_digit());
    if is_of_word || !is_only || !contains_word(name, "pdo") { None } else { number.parse().ok() }
}

/// Whether a name contains a word, ignoring case.
fn contains_word(name: &str, word: &str) -> bool {
    name.as_bytes().windows(word.len()).any(|part| part.eq_ignore_ascii_case(word.as_bytes()))
}

fn duplicate_denotation(device: &Device, findings: &mut Findings) {
    if device.kind != DeviceKind::Node {
        return;
    }
    let mut seen: HashMap<&str, Place> = HashMap::new();
    let mut repeated = Vec::new();
    let mut take = |name, place: Place| match seen.get(name) {
        Some(first) => repeated.push((first.clone(), place, name)),
        None => {
            seen.insert(name, place);
        }
    };
    for (&index, object) in &device.objects {
        for (sub, entry) in object.described() {
            let Some(configured) = &entry.configured else { continue };
            let Some(name) = configured.denotation.as_deref().filter(|name| !name.is_empty()) else {
                continue;
            };
            take(name, Place::at(index, sub).field(Field::Denotation));
        }
        for (sub, name) in object.compact.iter().flat_map(|compact| &compact.denotations) {
            if !name.is_empty() {
                take(name, Place::of(Part::CompactDenotations(index)).field(Field::Item(u32::from(*sub))));
            }
        }
    }
    for (first, second, name) in repeated {
        let message = say!("two entries have the denotation `{}`", name);
        let finding = DUPLICATE_DENOTATION.at(second, message).label(first, "first here");
        findings.push(finding.help("give each entry a unique denotation"));
    }
}

fn duplicate_module(device: &Device, findings: &mut Findings) {
    let mut seen = HashMap::new();
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        let (Some(name), Some(code)) = (&module.product_name, &module.order_code) else { continue };
        // two versions of a module may share a name
        let key = (name, code, module.product_version, module.product_revision);
        let first = *seen.entry(key).or_insert(number);
        if first == number || name.is_empty() {
            continue;
        }
        let place = |number| Place::of(Part::Module(number, ModulePart::Info)).field(Field::ProductName);
        let message = say!("modules {} and {} are both `{}` with order code `{}`", first, number, name, code);
        let finding = DUPLICATE_MODULE.at(place(number), message).label(place(first), "first here");
        findings.push(finding.help("add the version to the name, or remove one of the modules"));
    }
}

fn duplicate_object_name(device: &Device, findings: &mut Findings) {
    let mut seen: HashMap<&str, u16> = HashMap::with_capacity(device.objects.len());
    let repeated = device.objects.range(0x2000..).filter_map(|(&index, object)| {
        let name = object.name();
        if name.is_empty() || object.orphan || (0x5800..0x6000).contains(&index) {
            return None;
        }
        let first = *seen.entry(name).or_insert(index);
        // the same object of a further axis is 800h higher
        let is_copy = index >= 0x6000 && (index - first).is_multiple_of(0x800);
        (first != index && !is_copy).then_some((first, index, name))
    });
    for (first, second, name) in repeated {
        let place = |index| Place::object(index).field(Field::ParameterName);
        let message = say!("{:04X}h and {:04X}h are both called `{}`", first, second, name);
        let finding = DUPLICATE_OBJECT_NAME.at(place(second), message).label(place(first), "first here");
        findings.push(finding.help("add a number or a word to the names"));
    }
}

fn same_identifier(index: u16, object: &Object, findings: &mut Findings) {
    if index < 0x2000 {
        return;
    }
    let Some((first, second)) = similar_names(object) else { return };
    let name = |sub| object.subs.get(sub).map_or("", |entry| &entry.name);
    let message = say!(
        "`{}` and `{}`, sub-indexes {} and {}, result in the same identifier",
        name(first),
        name(second),
        sub_index(first),
        sub_index(second)
    );
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding = SAME_IDENTIFIER.at(place(second), message).label(place(first), "first here");
    findings.push(finding.help("make the names differ in letters or digits"));
}

/// The first two sub-indexes whose names differ only in case, spaces and punctuation.
fn similar_names(object: &Object) -> Option<(u8, u8)> {
    let mut seen: Vec<(u64, u8)> = Vec::with_capacity(object.subs.len());
    for (sub, entry) in object.subs.iter() {
        let Some(hash) = hash_of_letters(&entry.name) else { continue };
        let same = seen.iter().find(|&&(other, first)| {
            let name = object.subs.get(first).map_or("", |entry| &entry.name);
            other == hash && is_similar(name, &entry.name)
        });
        match same {
            // another rule reports equal names
            Some(&(_, first)) if object.subs.get(first).is_some_and(|other| other.name == entry.name) => {}
            Some(&(_, first)) => return Some((first, sub)),
            None => seen.push((hash, sub)),
        }
    }
    None
}

/// The letters and digits of a name in lower case; a name with non-ASCII letters is skipped.
fn letters_of(name: &str) -> impl Iterator<Item = u8> {
    name.bytes().filter(u8::is_ascii_alphanumeric).map(|byte| byte.to_ascii_lowercase())
}

fn is_similar(one: &str, other: &str) -> bool {
    letters_of(one).eq(letters_of(other))
}

/// A hash that is equal for similar names; `None` for a name without letters, or with non-ASCII letters.
fn hash_of_letters(name: &str) -> Option<u64> {
    if !name.is_ascii() {
        return None;
    }
    let fold = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3);
    let mut letters = letters_of(name).peekable();
    letters.peek()?;
    Some(letters.fold(0xCBF2_9CE4_8422_2325, fold))
}

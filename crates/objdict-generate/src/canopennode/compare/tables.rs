//! The definitions in CANopenNode 4 tables of any generator.

use std::collections::BTreeMap;

use super::c_text::{Initialiser, Token, initialiser, scan};

/// Records in each other; the tables of CANopenNode have one.
const DEEPEST: usize = 8;

/// The tables in `OD.h` and `OD.c`.
#[derive(Debug, Default)]
pub(super) struct ComparedTables {
    /// The members of each storage group, in the order of memory.
    pub(super) groups: BTreeMap<String, Vec<ComparedMember>>,
    /// The names of entries (`OD_ENTRY_…`) and numbers of objects (`OD_CNT_…`) with their values.
    pub(super) macros: BTreeMap<String, String>,
    /// The objects that the stack serves.
    pub(super) objects: BTreeMap<u16, ListedObject>,
    /// The values that the stack starts with, by group and member.
    pub(super) values: BTreeMap<String, String>,
}

/// A variable of a storage group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ComparedMember {
    pub(super) name: String,
    pub(super) kind: MemberKind,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum MemberKind {
    /// The type, and the numbers of elements.
    Variable(String, Vec<u64>),
    /// The members of a record.
    Record(Vec<ComparedMember>),
}

/// An object in the list of the stack.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct ListedObject {
    /// `ODT_VAR` and the like.
    pub(super) kind: String,
    /// The number of sub-indexes.
    pub(super) count: String,
    /// Properties of its entries by sub-index; an array has only those of sub-index 0 and, as sub-index 1, of
    /// all others.
    pub(super) entries: BTreeMap<u8, ListedEntry>,
}

/// The properties of an entry in the stack.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct ListedEntry {
    /// The flags, sorted; combined flags are split.
    pub(super) flags: Vec<String>,
    /// The number of bytes, or its expression.
    pub(super) length: String,
    /// Whether the tables have memory for the value.
    pub(super) has_value: bool,
}

impl ComparedTables {
    /// Reads the header and the source. Declarations that tables do not have are passed over.
    pub(super) fn read(header: &str, source: &str) -> Self {
        let mut tables = Self::default();
        let (macros, tokens) = scan(header);
        let of_tables = |name: &str| name.starts_with("OD_ENTRY_") || name.starts_with("OD_CNT_");
        tables.macros = macros
            .iter()
            .filter(|(name, _)| of_tables(name))
            .map(|(name, value)| ((*name).to_owned(), (*value).to_owned()))
            .collect();
        let mut rest = &tokens[..];
        while !rest.is_empty() {
            rest = match rest {
                [Token::Word("typedef"), Token::Word("struct"), Token::Mark('{'), body @ ..] => {
                    tables.group(body, &macros)
                }
                _ => &rest[1..],
            };
        }
        tables.definitions(&scan(source).1);
        tables
    }

    /// Reads a group from its first member on; returns the tokens after it.
    fn group<'a, 't>(&mut self, body: &'a [Token<'t>], macros: &BTreeMap<&str, &str>) -> &'a [Token<'t>] {
        let Some((members, behind)) = members(body, macros, 0) else { return body };
        if let [Token::Word(name), behind @ ..] = behind {
            let name = name.strip_suffix("_t").unwrap_or(name);
            if name != "ODObjs" {
                self.groups.insert(name.to_owned(), members);
            }
            return behind;
        }
        behind
    }

    /// Reads the variables of the source: values of groups, descriptors, and the list.
    fn definitions(&mut self, tokens: &[Token<'_>]) {
        let mut descriptors = None;
        for (name, value) in definitions(tokens) {
            match name {
                "ODObjs" => descriptors = Some(value),
                "ODList" => self.list(&value, descriptors.as_ref()),
                group if self.groups.contains_key(group) => self.start_values(group, &value),
                _ => {}
            }
        }
    }

    fn start_values(&mut self, path: &str, value: &Initialiser<'_>) {
        match value {
            Initialiser::List(items) if items.iter().any(|(field, _)| field.is_some()) => {
                for (field, item) in items {
                    self.start_values(&format!("{path}.{}", field.unwrap_or("?")), item);
                }
            }
            _ => {
                self.values.insert(path.to_owned(), plain(value));
            }
        }
    }

    /// Reads the rows `{index, count, kind, &ODObjs.name, NULL}`.
    fn list(&mut self, rows: &Initialiser<'_>, descriptors: Option<&Initialiser<'_>>) {
        for (_, row) in rows.items() {
            let words: Vec<_> = row.items().iter().map(|(_, value)| value.words()).collect();
            let [index, count, kind, object, ..] = &words[..] else { continue };
            let index =
                index.first().and_then(|text| number(text)).and_then(|index| u16::try_from(index).ok());
            let (Some(index), Some(kind)) = (index.filter(|index| *index != 0), kind.first()) else {
                continue;
            };
            let descriptor = object.last().and_then(|name| descriptors?.field(name));
            let count = count.first().map_or_else(String::new, |count| plain_number(count));
            let entries = descriptor.map(entries).unwrap_or_default();
            self.objects.insert(index, ListedObject { kind: (*kind).to_owned(), count, entries });
        }
    }
}

/// The variables of a source with their initialisers.
pub(super) fn definitions<'t>(tokens: &[Token<'t>]) -> Vec<(&'t str, Initialiser<'t>)> {
    let is_end = |token: &Token<'_>| matches!(token, Token::Mark(';' | '{' | '}'));
    let mut found = Vec::new();
    let mut rest = tokens;
    while let Some(at) = rest.iter().position(|token| *token == Token::Mark('=')) {
        // `name`, or `name[COUNT]`
        let declared = rest[..at].rsplit(is_end).next().unwrap_or_default();
        let declared = declared.split(|token| *token == Token::Mark('[')).next().unwrap_or_default();
        let Some((value, behind)) = initialiser(&rest[at + 1..], 0) else { break };
        if let Some(Token::Word(name)) = declared.last() {
            found.push((*name, value));
        }
        rest = behind;
    }
    found
}

/// The members up to the brace that ends them.
pub(super) fn members<'a, 't>(
    mut rest: &'a [Token<'t>],
    macros: &BTreeMap<&str, &str>,
    depth: usize,
) -> Option<(Vec<ComparedMember>, &'a [Token<'t>])> {
    let mut found = Vec::new();
    loop {
        match rest {
            [Token::Mark('}'), behind @ ..] => return Some((found, behind)),
            [Token::Word("struct"), Token::Mark('{'), body @ ..] if depth < DEEPEST => {
                let (inner, behind) = members(body, macros, depth + 1)?;
                let [Token::Word(name), behind @ ..] = behind else { return None };
                found.push(ComparedMember { name: (*name).to_owned(), kind: MemberKind::Record(inner) });
                rest = behind;
            }
            [Token::Word(of), Token::Word(name), behind @ ..] => {
                let end = behind.iter().position(|token| *token == Token::Mark(';'))?;
                let counts = behind[..end].iter().filter_map(|token| match token {
                    Token::Word(count) => {
                        number(count).or_else(|| number(macros.get(count).copied().unwrap_or_default()))
                    }
                    Token::Quoted(_) | Token::Mark(_) => None,
                });
                let kind = MemberKind::Variable((*of).to_owned(), counts.collect());
                found.push(ComparedMember { name: (*name).to_owned(), kind });
                rest = &behind[end..];
            }
            [Token::Mark(';'), behind @ ..] => rest = behind,
            _ => return None,
        }
    }
}

/// The entries of a descriptor: one, those of an array, or those of a record.
fn entries(descriptor: &Initialiser<'_>) -> BTreeMap<u8, ListedEntry> {
    let mut entries = BTreeMap::new();
    if descriptor.field("attribute0").is_some() {
        entries.insert(0, entry(descriptor, ["attribute0", "dataLength0", "dataOrig0"]));
        entries.insert(1, entry(descriptor, ["attribute", "dataElementLength", "dataOrig"]));
    } else if descriptor.field("attribute").is_some() {
        entries.insert(0, entry(descriptor, ["attribute", "dataLength", "dataOrig"]));
    }
    for (_, item) in descriptor.items() {
        let sub = item.field("subIndex").and_then(|sub| number(sub.words().first()?));
        if let Some(Ok(sub)) = sub.map(u8::try_from) {
            entries.insert(sub, entry(item, ["attribute", "dataLength", "dataOrig"]));
        }
    }
    entries
}

fn entry(descriptor: &Initialiser<'_>, [flags, length, value]: [&str; 3]) -> ListedEntry {
    let flags = descriptor.field(flags).map(Initialiser::words).unwrap_or_default();
    let mut flags: Vec<String> = flags.into_iter().flat_map(single_flags).collect();
    flags.sort_unstable();
    flags.dedup();
    let has_value = descriptor.field(value).is_some_and(|value| !value.words().contains(&"NULL"));
    ListedEntry { flags, length: descriptor.field(length).map(plain).unwrap_or_default(), has_value }
}

/// The flags that a flag name of the stack's header represents.
fn single_flags(word: &str) -> Vec<String> {
    match word {
        "ODA_SDO_RW" => ["ODA_SDO_R", "ODA_SDO_W"].map(str::to_owned).to_vec(),
        "ODA_TRPDO" => ["ODA_TPDO", "ODA_RPDO"].map(str::to_owned).to_vec(),
        "ODA_TRSRDO" => ["ODA_TSRDO", "ODA_RSRDO"].map(str::to_owned).to_vec(),
        word if word.starts_with("ODA_") => vec![word.to_owned()],
        _ => Vec::new(),
    }
}

/// A value in normalised spelling: numbers in decimal, characters as a string, without trailing zeros.
pub(super) fn plain(value: &Initialiser<'_>) -> String {
    let items = match value {
        Initialiser::Value(tokens) => return plain_value(tokens),
        Initialiser::List(items) => items,
    };
    if let Some(text) = characters(items) {
        return text;
    }
    let mut texts: Vec<String> = items.iter().map(|(_, item)| plain(item)).collect();
    while texts.last().is_some_and(|last| last == "0") {
        texts.pop();
    }
    match texts.len() {
        0 => "0".to_owned(),
        _ => texts.join(", "),
    }
}

/// A list that contains a character as a quoted string, without trailing zeros; `None` for any other list.
fn characters(items: &[(Option<&str>, Initialiser<'_>)]) -> Option<String> {
    let is_character = |item: &Initialiser<'_>| matches!(item, Initialiser::Value(tokens) if matches!(tokens[..], [Token::Quoted(_)]));
    if !items.iter().any(|(_, item)| is_character(item)) {
        return None;
    }
    let mut bytes = items.iter().map(|(_, item)| byte(item)).collect::<Option<Vec<u8>>>()?;
    while bytes.last() == Some(&0) {
        bytes.pop();
    }
    Some(format!("{:?}", String::from_utf8_lossy(&bytes)))
}

/// The byte of a character, or of a number with or without a cast.
fn byte(item: &Initialiser<'_>) -> Option<u8> {
    let Initialiser::Value(tokens) = item else { return None };
    let Token::Quoted(text) = tokens.last()? else { return number(item.words().last()?)?.try_into().ok() };
    match text.strip_prefix('\'')?.strip_suffix('\'')?.as_bytes() {
        [byte] => Some(*byte),
        [b'\\', b'n'] => Some(b'\n'),
        [b'\\', b'r'] => Some(b'\r'),
        [b'\\', b't'] => Some(b'\t'),
        [b'\\', b'0'] => Some(0),
        [b'\\', b'x', digits @ ..] => u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok(),
        [b'\\', byte] => Some(*byte),
        _ => None,
    }
}

fn plain_value(tokens: &[Token<'_>]) -> String {
    let texts = tokens.iter().map(|token| match token {
        Token::Word(word) => plain_number(word),
        Token::Quoted(text) => (*text).to_owned(),
        Token::Mark(mark) => mark.to_string(),
    });
    texts.collect()
}

pub(super) fn plain_number(text: &str) -> String {
    let text = if text.contains('.') { text.trim_end_matches(['f', 'F']) } else { text };
    number(text).map_or_else(|| text.to_owned(), |number| number.to_string())
}

/// A number of C, with or without a suffix.
pub(super) fn number(text: &str) -> Option<u64> {
    let digits = text.trim_end_matches(['u', 'U', 'l', 'L']);
    match digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) {
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => digits.parse().ok(),
    }
}

//! Tables whose rows are entries: those of CANopenNode 1.3, canopen-stack and CanFestival, of any generator or written by hand.

use std::collections::BTreeMap;

use super::c_text::{Initialiser, Token, scan};
use super::layout::size_of;
use super::tables::{MemberKind, definitions, members, number, plain, plain_number};
use crate::{OutputFile, TableAspect, TableDifference};

/// What a project can notice, by the aspect and the place: an entry, a macro, or a member of a memory.
#[derive(Default)]
struct RowFacts(BTreeMap<(TableAspect, String), String>);

type RowDifferences = Option<Vec<TableDifference>>;

/// Compares tables of CANopenNode 1.3 with generated files; `None` if they are none.
pub(crate) fn compare_v1(header: &str, source: &str, made: &[OutputFile]) -> RowDifferences {
    compare(v1, header, source, made)
}

/// The same for canopen-stack.
pub(crate) fn compare_keys(header: &str, source: &str, made: &[OutputFile]) -> RowDifferences {
    compare(keys, header, source, made)
}

/// The same for CanFestival.
pub(crate) fn compare_indexes(header: &str, source: &str, made: &[OutputFile]) -> RowDifferences {
    compare(indexes, header, source, made)
}

fn compare(
    read: fn(&str, &str) -> RowFacts,
    header: &str,
    source: &str,
    made: &[OutputFile],
) -> RowDifferences {
    let [new_header, new_source] = super::texts(made)?;
    let (RowFacts(mut old), RowFacts(new)) = (read(header, source), read(new_header, new_source));
    if !old.keys().any(|(aspect, _)| *aspect == TableAspect::Objects) {
        return None;
    }
    let mut found = Vec::new();
    let mut add = |(aspect, place), old: Option<String>, new| {
        if old != new {
            found.push(TableDifference { aspect, place, old, new });
        }
    };
    new.into_iter().for_each(|(key, new)| {
        let old = old.remove(&key);
        add(key, old, Some(new));
    });
    old.into_iter().for_each(|(key, old)| add(key, Some(old), None));
    found.sort_by(|a, b| (a.aspect, &a.place).cmp(&(b.aspect, &b.place)));
    Some(found)
}

impl RowFacts {
    fn add(&mut self, aspect: TableAspect, place: &str, fact: String) {
        self.0.insert((aspect, place.to_owned()), fact);
    }

    /// An entry: what the stack knows of it, its variable without casts, and the value that the variable starts with.
    fn entry(
        &mut self,
        place: &str,
        known: String,
        data: &Initialiser<'_>,
        values: &BTreeMap<&str, Initialiser<'_>>,
    ) {
        self.add(TableAspect::Objects, place, known);
        let data: Vec<Token<'_>> =
            tokens(data).into_iter().filter(|token| !matches!(token, Token::Mark('(' | ')'))).collect();
        // `void *&x`, `CO_DATA &x`, `CO_DATA 5`, `x`
        let start = data.iter().rposition(|token| matches!(token, Token::Mark('&' | '*')));
        let start = start.map_or(usize::from(data.len() == 2), |at| at + 1);
        let data = data.get(start..).unwrap_or_default();
        let text = plain(&Initialiser::Value(data.to_vec()));
        if text.starts_with(|c: char| c.is_ascii_digit()) {
            return self.add(TableAspect::Values, place, text);
        }
        self.add(TableAspect::Names, place, text);
        let Some(value) = data.first().and_then(|token| values.get(token.word()?)) else { return };
        let element = match data {
            [_, Token::Mark('['), Token::Word(at), ..] => number(at).and_then(|at| usize::try_from(at).ok()),
            _ => None,
        };
        let value = element.and_then(|at| value.items().get(at)).map_or(value, |(_, item)| item);
        self.add(TableAspect::Values, place, plain(value));
    }

    /// The members of a memory of CANopenNode 1.3, and their values; those of RAM are lost without power.
    fn memory(
        &mut self,
        name: &str,
        body: &[Token<'_>],
        macros: &BTreeMap<&str, &str>,
        values: &[(Option<&str>, Initialiser<'_>)],
    ) {
        let (members, _) = members(body, macros, 0).unwrap_or_default();
        for (position, member) in members.iter().enumerate() {
            let MemberKind::Variable(of, counts) = &member.kind else { continue };
            let counts: String = counts.iter().map(|count| format!("[{count}]")).collect();
            let place = format!("{name}.{}", member.name);
            match name {
                "CO_OD_RAM" => self.add(TableAspect::Names, &place, format!("{of}{counts}")),
                _ => self.add(TableAspect::Layout, &place, format!("{of}{counts}, member {position}")),
            }
            if let Some((_, value)) = values.get(position) {
                self.add(TableAspect::Values, &place, plain(value));
            }
        }
    }
}

fn shown(index: u64, sub: usize) -> String {
    format!("{index:04X}h:{sub:02X}")
}

fn tokens<'t>(value: &Initialiser<'t>) -> Vec<Token<'t>> {
    match value {
        Initialiser::Value(tokens) => tokens.clone(),
        Initialiser::List(_) => Vec::new(),
    }
}

/// `{index, highest sub-index, attribute, length, data}`; the rows of a record are `{data, attribute, length}`.
fn v1(header: &str, source: &str) -> RowFacts {
    let (macros, declared) = scan(header);
    let (values, mut facts) = (variables(source), RowFacts::default());
    for (name, value) in &macros {
        if ["OD_", "ODL_", "ODA_", "CO_NO_"].iter().any(|start| name.starts_with(start)) {
            facts.add(TableAspect::Names, name, plain_number(value));
        }
    }
    let items = |name| values.get(name).map_or(&[][..], Initialiser::items);
    for at in 0..declared.len() {
        if let [Token::Word("struct"), Token::Word(name), Token::Mark('{'), body @ ..] = &declared[at..]
            && let Some(name) = name.strip_prefix('s')
        {
            facts.memory(name, body, &macros, items(name));
        }
    }
    let known = |attribute: &Initialiser<'_>, length| {
        let attribute = attribute.words().first().and_then(|word| number(word)).unwrap_or_default();
        format!("attribute 0x{attribute:02X}, {} bytes", plain(length))
    };
    for (_, row) in items("CO_OD") {
        let [(_, index), (_, highest), (_, attribute), (_, length), (_, data)] = row.items() else {
            continue;
        };
        let Some(index) = index.words().first().and_then(|word| number(word)) else { continue };
        let record = data.words().last().filter(|name| name.starts_with("OD_record")).map(|name| items(name));
        for (sub, (_, part)) in record.unwrap_or_default().iter().enumerate() {
            let [(_, data), (_, attribute), (_, length)] = part.items() else { continue };
            facts.entry(&shown(index, sub), known(attribute, length), data, &BTreeMap::new());
        }
        if record.is_none() {
            let known = format!("{}, highest sub-index {}", known(attribute, length), plain(highest));
            facts.entry(&format!("{index:04X}h"), known, data, &BTreeMap::new());
        }
    }
    facts
}

/// `{CO_KEY(index, sub-index, flags), type, data}`.
fn keys(_: &str, source: &str) -> RowFacts {
    let (values, mut facts) = (variables(source), RowFacts::default());
    for (_, row) in values.values().flat_map(Initialiser::items) {
        let [(_, key), (_, of), (_, data), ..] = row.items() else { continue };
        let ["CO_KEY", index, sub, flags] = key.words()[..] else { continue };
        let sub = number(sub).and_then(|sub| usize::try_from(sub).ok());
        let (Some(index), Some(sub)) = (number(index), sub) else { continue };
        // `D` is where the value is, and types have a `T` since version 4.2
        let flags: String = flags.replace("CO_OBJ_", "").replace(['_', 'D'], "");
        let of = plain(of);
        let of = of.trim_start_matches("CO_").trim_start_matches('T');
        facts.entry(&shown(index, sub), format!("{of} {flags}"), data, &values);
    }
    facts
}

/// `{access, type, size, data}`, or a macro with them, in a variable whose name ends in `_Index` and the index.
fn indexes(_: &str, source: &str) -> RowFacts {
    let (values, mut facts) = (variables(source), RowFacts::default());
    for (name, rows) in &values {
        let index = name.rsplit_once("_Index").and_then(|(_, index)| u64::from_str_radix(index, 16).ok());
        let rows = rows.items().iter().filter(|_| index.is_some()).enumerate();
        for (sub, (_, row)) in rows {
            let all: Vec<Initialiser<'_>> = match row {
                Initialiser::List(items) => items.iter().map(|(_, item)| item.clone()).collect(),
                Initialiser::Value(row) => {
                    let parts = row
                        .get(2..row.len() - 1)
                        .unwrap_or_default()
                        .split(|token| *token == Token::Mark(','));
                    parts.map(|part| Initialiser::Value(part.to_vec())).collect()
                }
            };
            let [access, of, size, data, ..] = &all[..] else { continue };
            let size = match size.words()[..] {
                ["sizeof", of] => size_of(of).map_or_else(|| of.to_owned(), |size| size.to_string()),
                _ => plain(size),
            };
            let known = format!("{} {}, {size} bytes", plain(access), plain(of));
            facts.entry(&shown(index.unwrap_or_default(), sub), known, data, &values);
        }
    }
    facts
}

fn variables(source: &str) -> BTreeMap<&str, Initialiser<'_>> {
    definitions(&scan(source).1).into_iter().collect()
}

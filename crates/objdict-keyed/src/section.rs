//! Reads maps with a table of their keys, from which the JSON Schema is generated as well.

use super::rules::{FORMER_KEY, MISSING_KEY, OUT_OF_RANGE, UNKNOWN_KEY, WRONG_TYPE};
use super::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings, Severity, listing, misspelled, nearest, say};
use objdict_model::literal::nanoseconds;
use objdict_model::source::{Said, Span};

/// The pattern of a whole string, with [placeholders](crate::notation::PARTS).
pub type Notation = &'static str;

/// A key that a map may have.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// The name in the file.
    pub name: &'static str,
    /// The type of its value.
    pub shape: Shape,
    /// Its meaning: a sentence for the JSON Schema and the documentation.
    pub meaning: &'static str,
    /// An earlier name in this kind of file, with the same meaning.
    pub former: Option<&'static str>,
    /// Whether every map needs it.
    pub is_required: bool,
}

/// An optional key without a former name.
pub const fn key(name: &'static str, shape: Shape, meaning: &'static str) -> Key {
    Key { name, shape, meaning, former: None, is_required: false }
}

impl Key {
    /// Adds a former name, which is a finding only if the present one exists too.
    #[must_use]
    pub const fn formerly(self, former: &'static str) -> Self {
        Self { former: Some(former), ..self }
    }

    /// The key as one that each map must have.
    #[must_use]
    pub const fn required(self) -> Self {
        Self { is_required: true, ..self }
    }
}

/// The present name of a key that some tables contained under a different one.
pub fn present_name<'k>(keys: &[Key], name: &'k str) -> &'k str {
    keys.iter().find(|key| key.former == Some(name)).map_or(name, |key| key.name)
}

/// The type of a value.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// A whole number in a range.
    Integer(i128, i128),
    /// A number above 0, also with a fraction.
    Number,
    /// True or false.
    Flag,
    /// A string.
    Text,
    /// A string in this notation; a number is invalid.
    Spelled(Notation),
    /// One of these keywords.
    Word(&'static [&'static str]),
    /// A whole number in a range, or this keyword.
    IntegerOr(i128, i128, &'static str),
    /// A whole number in a range, or a string in this notation.
    IntegerOrText(i128, i128, Notation),
    /// A time: a string with a unit, or a whole number up to the first value, in units of the second one in
    /// nanoseconds.
    Time(i128, u64),
    /// A number or a string.
    Value,
    /// A value, or a list of values.
    ValueOrList,
    /// A map of values by any names.
    Values,
    /// A map of values by names that are spelled so.
    ValuesOf(Notation),
    /// A map of texts that are spelled so, by any names.
    SpelledByName(Notation),
    /// A map of values by arbitrary names, or a list of values.
    ValuesOrList,
    /// A string, or a list of strings.
    Texts,
    /// A string, or a list of strings, in this notation.
    AllSpelled(Notation),
    /// A list of whole numbers in a range.
    Numerals(i128, i128),
    /// A map with these keys.
    Map(&'static [Key]),
    /// A map, by arbitrary names, of maps with these keys.
    Named(&'static [Key]),
    /// A list of maps with these keys.
    List(&'static [Key]),
    /// A map, by number, of maps with these keys.
    Numbered(i128, i128, &'static [Key]),
    /// A map of numbers in the second range by numbers in the first one.
    Numbers((i128, i128), (i128, i128)),
    /// Content for other programs.
    Foreign,
}

/// All numbers of this many bits.
pub const fn bits(bits: u32) -> Shape {
    Shape::Integer(0, (1 << bits) - 1)
}

/// A map of the file with its key table.
#[derive(Clone, Copy, Debug)]
pub struct KeyedTable<'t> {
    span: Span,
    entries: &'t [Pair],
    keys: &'static [Key],
}

impl<'t> KeyedTable<'t> {
    /// Reports a value that is not a map, and unknown keys.
    pub fn new(
        name: &str,
        tree: &'t KeyedTree,
        keys: &'static [Key],
        findings: &mut Findings,
    ) -> Option<Self> {
        Self::with_unknown(name, tree, keys, |finding, _| finding, findings)
    }

    /// Like `new`, for a map that may contain keys of other programs: an unknown key is a warning, unless it is
    /// obviously a misspelled known one.
    pub fn shared(
        name: &str,
        tree: &'t KeyedTree,
        keys: &'static [Key],
        findings: &mut Findings,
    ) -> Option<Self> {
        let own = || keys.iter().filter(|key| !matches!(key.shape, Shape::Foreign)).map(|key| key.name);
        Self::with_unknown(name, tree, keys, |finding, key| or_foreign(finding, key, own()), findings)
    }

    fn with_unknown(
        name: &str,
        tree: &'t KeyedTree,
        keys: &'static [Key],
        rated: impl Fn(Diagnostic, &str) -> Diagnostic,
        findings: &mut Findings,
    ) -> Option<Self> {
        let Some(entries) = tree.entries() else {
            let message = say!("`{}` is {}, not a table of keys", name, tree.kind_name());
            findings.push(Diagnostic::new(&WRONG_TYPE, tree.span, message).help("write its keys below it"));
            return None;
        };
        let section = Self { span: tree.span, entries, keys };
        for entry in entries {
            let key = entry.key.spelled();
            if let Some(renamed) = keys.iter().find(|known| known.former == Some(&key)) {
                if entries.iter().any(|other| other.key.text() == Some(renamed.name)) {
                    let message = say!("`{}` of `{}` is the former name of `{}`", key, name, renamed.name);
                    let finding = Diagnostic::new(&FORMER_KEY, entry.key.span, message);
                    findings.push(finding.help(say!("remove one of `{}` and `{}`", key, renamed.name)));
                }
            } else if !keys.iter().any(|known| known.name == key) {
                let finding =
                    Diagnostic::new(&UNKNOWN_KEY, entry.key.span, say!("`{}` has no key `{}`", name, key));
                let finding = rated(finding, &key);
                findings.push(match nearest(&key, keys.iter().map(|known| known.name)) {
                    Some(meant) => finding.help(say!("did you mean `{}`?", meant)),
                    None => finding.help("remove it, or correct its name"),
                });
            }
        }
        Some(section)
    }

    /// The span of the map.
    pub const fn span(&self) -> Span {
        self.span
    }

    /// The value of a key.
    pub fn get(&self, name: &str) -> Option<&'t KeyedTree> {
        let key = self.keys.iter().find(|key| key.name == name);
        debug_assert!(key.is_some(), "{name} is not in the table");
        let position = |name: &str| self.entries.iter().position(|entry| entry.key.text() == Some(name));
        // if both names exist, the last one is used
        let at = position(name).max(key.and_then(|key| key.former).and_then(position))?;
        Some(&self.entries[at].value)
    }

    /// The value of a key that must be there.
    pub fn required(&self, owner: &str, name: &str, findings: &mut Findings) -> Option<&'t KeyedTree> {
        let value = self.get(name);
        if value.is_none() {
            let start = Span::new(self.span.start, self.span.start);
            let finding = Diagnostic::new(&MISSING_KEY, start, say!("`{}` has no key `{}`", owner, name));
            findings.push(finding.help(say!("add `{}`", name)));
        }
        value
    }

    /// The type of a key's value according to the table.
    fn shape(&self, name: &str) -> Option<&'static Shape> {
        self.keys.iter().find(|key| key.name == name).map(|key| &key.shape)
    }

    /// The range of a number in the table.
    fn range(&self, name: &str) -> (i128, i128) {
        match self.shape(name) {
            Some(Shape::Integer(low, high) | Shape::IntegerOr(low, high, _)) => (*low, *high),
            _ => (i128::MIN, i128::MAX),
        }
    }

    /// A whole number.
    pub fn integer<T: TryFrom<i128>>(&self, name: &str, findings: &mut Findings) -> Option<Said<T>> {
        let tree = self.get(name)?;
        let number = integer(name, tree, self.range(name), findings)?;
        Some(Said::new(T::try_from(number).ok()?, tree.span))
    }

    /// True or false.
    pub fn flag(&self, name: &str, findings: &mut Findings) -> Option<Said<bool>> {
        let tree = self.get(name)?;
        match &*tree.kind {
            Kind::Bool(flag) => Some(Said::new(*flag, tree.span)),
            Kind::Integer(number) => {
                if !matches!(number, 0 | 1) {
                    let message = say!("`{}` is {}, which is read as true", name, number);
                    let finding = Diagnostic::new(&WRONG_TYPE, tree.span, message);
                    findings.push(finding.severity(Severity::Warning).help("write `true` or `false`"));
                }
                Some(Said::new(*number != 0, tree.span))
            }
            _ => {
                let finding = wrong(name, tree, "true or false");
                findings.push(
                    finding.help("write `true` or `false` without quotes; dcfgen reads any string as true"),
                );
                None
            }
        }
    }

    fn check_value(&self, key: &Key, tree: &KeyedTree, findings: &mut Findings) {
        let name = key.name;
        let list = match &*tree.kind {
            Kind::List(items) => Some(&items[..]),
            _ => None,
        };
        match key.shape {
            Shape::IntegerOr(_, _, word) if tree.text() == Some(word) => {}
            Shape::IntegerOrText(..) if tree.text().is_some() => {}
            Shape::Integer(low, high)
            | Shape::IntegerOr(low, high, _)
            | Shape::IntegerOrText(low, high, _) => {
                integer(name, tree, (low, high), findings);
            }
            Shape::Number => drop(self.number(name, findings)),
            Shape::Flag => drop(self.flag(name, findings)),
            Shape::Text | Shape::Spelled(_) => drop(self.text(name, findings)),
            Shape::Word(_) => drop(self.word(name, findings)),
            Shape::Time(..) => drop(self.time::<i128>(name, findings)),
            Shape::Texts | Shape::AllSpelled(_) => drop(self.texts(name, findings)),
            Shape::Numbers(..) => drop(self.numbers(name, findings)),
            Shape::ValueOrList | Shape::ValuesOrList if list.is_some() => {
                list.into_iter().flatten().for_each(|item| check_scalar(name, item, findings));
            }
            Shape::Value | Shape::ValueOrList => check_scalar(name, tree, findings),
            Shape::Values | Shape::ValuesOf(_) | Shape::SpelledByName(_) | Shape::ValuesOrList => {
                for Pair { key, value } in self.named(name, findings) {
                    check_scalar(&key.spelled(), value, findings);
                }
            }
            Shape::Numerals(low, high) => {
                for item in self.list(name, findings).unwrap_or_default() {
                    integer(name, item, (low, high), findings);
                }
            }
            Shape::Map(keys) => check_map(name, tree, keys, findings),
            Shape::Named(keys) => {
                for Pair { key, value } in self.named(name, findings) {
                    check_map(&key.spelled(), value, keys, findings);
                }
            }
            Shape::List(keys) => {
                for item in self.list(name, findings).unwrap_or_default() {
                    check_map(name, item, keys, findings);
                }
            }
            Shape::Numbered(_, _, keys) => {
                for (_, item) in self.numbered(name, findings) {
                    check_map(name, item.value, keys, findings);
                }
            }
            Shape::Foreign => {}
        }
    }

    /// A number above 0.
    pub fn number(&self, name: &str, findings: &mut Findings) -> Option<Said<f64>> {
        let tree = self.get(name)?;
        let number = match &*tree.kind {
            // numbers of a file are far below 2^53
            Kind::Integer(number) => *number as f64,
            Kind::Float(number) => *number,
            _ => {
                findings
                    .push(wrong(name, tree, "a number").help(say!("write a number, as in `{}: 1.5`", name)));
                return None;
            }
        };
        if number.is_finite() && number > 0.0 {
            return Some(Said::new(number, tree.span));
        }
        let message = say!("`{}` is {}, but must be above 0", name, number);
        findings.push(Diagnostic::new(&OUT_OF_RANGE, tree.span, message).help("write a number above 0"));
        None
    }

    /// A time in its unit.
    pub fn time<T: TryFrom<i128>>(&self, name: &str, findings: &mut Findings) -> Option<Said<T>> {
        let tree = self.get(name)?;
        let Some(&Shape::Time(high, unit)) = self.shape(name) else { return None };
        let number = match tree.text().map(nanoseconds) {
            None => integer(name, tree, (0, high), findings)?,
            Some(Some(time)) if time.is_multiple_of(unit) && i128::from(time / unit) <= high => {
                (time / unit).into()
            }
            Some(time) => {
                let longest = spelled_time(high.saturating_mul(unit.into()));
                let (rule, expected) = match time {
                    Some(time) if time.is_multiple_of(unit) => (&OUT_OF_RANGE, say!("at most {}", longest)),
                    Some(_) => (&OUT_OF_RANGE, say!("a multiple of {}", spelled_time(unit.into()))),
                    None => (&WRONG_TYPE, say!("a time")),
                };
                let message = say!("`{}` is `{}`, but must be {}", name, tree.spelled(), expected);
                let finding = Diagnostic::new(rule, tree.span, message);
                findings.push(finding.help("write a number with a unit, as in `33ms`, `1.5 s` or `250us`"));
                return None;
            }
        };
        Some(Said::new(T::try_from(number).ok()?, tree.span))
    }

    /// A string, or several.
    pub fn texts(&self, name: &str, findings: &mut Findings) -> Vec<Said<&'t str>> {
        let items = self.get(name).map_or(&[][..], |tree| match &*tree.kind {
            Kind::List(items) => items,
            _ => std::slice::from_ref(tree),
        });
        let mut texts = Vec::with_capacity(items.len());
        for item in items {
            match item.text() {
                Some(text) => texts.push(Said::new(text, item.span)),
                None => findings.push(wrong(name, item, "a string").help("write a string in quotes")),
            }
        }
        texts
    }

    /// Numbers of 8 bits by numbers.
    pub fn numbers(&self, name: &str, findings: &mut Findings) -> Vec<(u8, Said<u8>)> {
        let numbered = self.numbered(name, findings);
        let mut numbers = Vec::with_capacity(numbered.len());
        for (sub, tree) in numbered {
            let value = integer(name, tree.value, (0, 255), findings);
            if let (Ok(sub), Some(Ok(value))) = (u8::try_from(sub), value.map(u8::try_from)) {
                numbers.push((sub, Said::new(value, tree.value.span)));
            }
        }
        numbers
    }

    /// The entries of a map by name.
    pub fn named(&self, name: &str, findings: &mut Findings) -> &'t [Pair] {
        let Some(tree) = self.get(name) else { return &[] };
        tree.entries().unwrap_or_else(|| {
            findings.push(wrong(name, tree, "a table of keys").help("write the names as keys below it"));
            &[]
        })
    }

    /// A string; numbers are used as spelled, unless a [notation](Shape::Spelled) would interpret them as
    /// different ones.
    pub fn text(&self, name: &str, findings: &mut Findings) -> Option<Said<String>> {
        let tree = self.get(name)?;
        let is_spelled = matches!(self.shape(name), Some(Shape::Spelled(_)));
        match &*tree.kind {
            Kind::Integer(_) | Kind::Float(_) if !is_spelled => Some(Said::new(tree.spelled(), tree.span)),
            Kind::Text(text) => Some(Said::new(text.clone(), tree.span)),
            _ => {
                findings.push(wrong(name, tree, "a string").help("write a string in quotes"));
                None
            }
        }
    }

    /// The result of `parse` for a string; `expected` describes valid strings, with a help.
    pub fn parsed<T>(
        &self,
        name: &str,
        parse: impl Fn(&str) -> Option<T>,
        expected: [&'static str; 2],
        findings: &mut Findings,
    ) -> Option<Said<T>> {
        let text = self.text(name, findings)?;
        let parsed = parse(&text.value);
        if parsed.is_none() {
            let message = say!("`{}` is not {}", text.value.as_str(), expected[0]);
            findings.push(Diagnostic::new(&WRONG_TYPE, text.at, message).help(expected[1]));
        }
        Some(Said::new(parsed?, text.at))
    }

    /// A string that is one of the keywords of the key.
    pub fn word(&self, name: &str, findings: &mut Findings) -> Option<Said<String>> {
        let text = self.text(name, findings)?;
        let key = self.keys.iter().find(|key| key.name == name);
        let Some(Shape::Word(words)) = key.map(|key| &key.shape) else { return Some(text) };
        if words.contains(&text.value.as_str()) {
            return Some(text);
        }
        let message = say!("`{}` is not a value of `{}`", text.value, name);
        let help = say!("write {}", listing(words.iter().copied()));
        findings.push(Diagnostic::new(&WRONG_TYPE, text.at, message).help(help));
        None
    }

    /// The items of a list.
    pub fn list(&self, name: &str, findings: &mut Findings) -> Option<&'t [KeyedTree]> {
        let tree = self.get(name)?;
        match &*tree.kind {
            Kind::List(items) => Some(items),
            _ => {
                findings.push(
                    wrong(name, tree, "a list").help(
                        "write each item on its own line after `- `, or all in brackets (`[]` for none)",
                    ),
                );
                None
            }
        }
    }

    /// The entries of a map by number, each with its number.
    pub fn numbered(&self, name: &str, findings: &mut Findings) -> Vec<(i128, Said<&'t KeyedTree>)> {
        let Some(tree) = self.get(name) else { return Vec::new() };
        let (low, high) = match self.shape(name) {
            Some(Shape::Numbered(low, high, _) | Shape::Numbers((low, high), _)) => (*low, *high),
            _ => (i128::MIN, i128::MAX),
        };
        let Some(entries) = tree.entries() else {
            findings.push(wrong(name, tree, "a table of keys").help("write the numbers as keys below it"));
            return Vec::new();
        };
        let mut numbered = Vec::with_capacity(entries.len());
        for Pair { key, value } in entries {
            if key.text().is_some() {
                let finding = wrong(name, key, "a number");
                findings.push(finding.help("write the number without quotes"));
            } else if let Some(number) = integer(name, key, (low, high), findings) {
                numbered.push((number, Said::new(value, key.span)));
            }
        }
        numbered
    }
}

/// Reports content of a map and its nested maps that the table does not allow, where there is no finding yet: values
/// that are read only in some cases, or in a different notation.
pub fn check(name: &str, tree: &KeyedTree, keys: &'static [Key], findings: &mut Findings) {
    let mut found = Findings::new();
    check_map(name, tree, keys, &mut found);
    let place = |finding: &Diagnostic| finding.labels.first().map(|label| label.at.clone());
    let known: Vec<_> = findings.iter().map(place).collect();
    for finding in found.into_vec().into_iter().filter(|finding| !known.contains(&place(finding))) {
        findings.push(finding);
    }
}

fn check_map(name: &str, tree: &KeyedTree, keys: &'static [Key], findings: &mut Findings) {
    let Some(section) = KeyedTable::new(name, tree, keys, findings) else { return };
    for key in keys {
        match section.get(key.name) {
            Some(tree) => section.check_value(key, tree, findings),
            None if key.is_required => drop(section.required(name, key.name, findings)),
            None => {}
        }
    }
}

fn check_scalar(name: &str, tree: &KeyedTree, findings: &mut Findings) {
    if matches!(&*tree.kind, Kind::Null | Kind::List(_) | Kind::Map(_)) {
        findings.push(wrong(name, tree, "a value").help("write a number or a string"));
    }
}

/// A finding about an unknown key, which is a warning if it may belong to a different program, that is, if it
/// is not a misspelled known key.
pub fn or_foreign<'a>(
    finding: Diagnostic,
    key: &str,
    words: impl IntoIterator<Item = &'a str>,
) -> Diagnostic {
    match misspelled(key, words) {
        Some(_) => finding.understood(),
        None => finding.severity(Severity::Warning),
    }
}

/// The findings about a file of dcfgen, which silently truncates fractions.
pub fn with_cuts(findings: Findings) -> Findings {
    let cut = |finding: Diagnostic| match finding.rule.id == WRONG_TYPE.id && finding.is_understood {
        true => {
            finding.severity(Severity::Warning).help("write a whole number: dcfgen truncates the fraction")
        }
        false => finding,
    };
    findings.filter_map(|finding| Some(cut(finding)))
}

/// A whole number in a range. Other values that dcfgen silently reads as one are warnings; a fraction is a
/// warning [in its files](with_cuts).
pub fn integer(
    name: &str,
    tree: &KeyedTree,
    (low, high): (i128, i128),
    findings: &mut Findings,
) -> Option<i128> {
    let number = match &*tree.kind {
        Kind::Integer(number) => *number,
        Kind::Float(number) if number.is_finite() && number.abs() < 1e18 => {
            let cut = number.trunc() as i128;
            if number.fract() != 0.0 {
                let message = say!("`{}` is {}, but must be a whole number", name, number);
                let finding = Diagnostic::new(&WRONG_TYPE, tree.span, message).understood();
                findings.push(finding.help("write a whole number"));
            }
            cut
        }
        Kind::Bool(flag) => {
            let message = say!("`{}` is {}, which is read as {}", name, flag.to_string(), u8::from(*flag));
            let finding = Diagnostic::new(&WRONG_TYPE, tree.span, message).severity(Severity::Warning);
            findings.push(finding.help("write a number"));
            (*flag).into()
        }
        Kind::Text(text) if text.parse::<i128>().is_ok() => {
            let finding = wrong(name, tree, "a number").severity(Severity::Warning);
            findings.push(finding.help("write it without quotes"));
            text.parse().ok()?
        }
        _ => {
            findings.push(wrong(name, tree, "a whole number").help(say!(
                "write a number from {} to {}",
                low,
                high
            )));
            return None;
        }
    };
    if (low..=high).contains(&number) {
        return Some(number);
    }
    let message = say!("`{}` is {}, but must be {} to {}", name, number, low, high);
    findings.push(Diagnostic::new(&OUT_OF_RANGE, tree.span, message).help(say!(
        "write a number from {} to {}",
        low,
        high
    )));
    None
}

/// A time in the largest unit that has no fraction.
fn spelled_time(nanoseconds: i128) -> String {
    let units = [(1_000_000_000, "s"), (1_000_000, "ms"), (1000, "us")];
    let unit = units.iter().find(|(length, _)| nanoseconds % length == 0);
    unit.map_or_else(
        || format!("{nanoseconds}ns"),
        |(length, unit)| format!("{}{unit}", nanoseconds / length),
    )
}

/// `cob_id` is a string, but a number is required.
pub fn wrong(name: &str, tree: &KeyedTree, expected: &'static str) -> Diagnostic {
    let message = say!("`{}` is `{}`, {} instead of {}", name, tree.spelled(), tree.kind_name(), expected);
    Diagnostic::new(&WRONG_TYPE, tree.span, message)
}

//! The texts of findings: a template with gaps, and the values for the gaps. The text is rendered for
//! display, in the terms of the syntax of the file.
//!
//! Code must not depend on the wording of a message: it uses the values. Rules use the terms of the model, and a
//! `Vocabulary` replaces them for other syntaxes.

use std::borrow::{Borrow, Cow};
use std::fmt;

use super::notion::{Notion, Vocabulary, section_name};
use super::{Selection, Tool};
use crate::model::{
    Access, ClockTime, CobId, DataType, Date, Field, MappedObject, ObjectList, ObjectType, Part, Pdo,
    PdoKind, PdoMapping, Value,
};
use crate::say;
use crate::source::Encoding;

/// The maximum number of characters quoted from a value; a file may contain lines of any length.
pub const MAX_QUOTED: usize = 80;

/// The text of a finding. [`Display`](fmt::Display) renders it.
///
/// ```
/// use objdict_model::{model::Field, say};
/// let text = say!("`{}` is {}, and {the key} is `{SubNumber}`", Field::LowLimit, 5);
/// assert_eq!(text, "`LowLimit` is 5, and the key is `SubNumber`");
/// ```
#[derive(Clone, Debug)]
pub struct Text {
    content: TextContent,
    /// The vocabulary of a syntax other than CiA 306.
    words: Option<Vocabulary>,
}

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum TextContent {
    /// A fixed text.
    Plain(Cow<'static, str>),
    /// A template with gaps for [`say!`].
    Template(&'static str, Box<[Argument]>),
}

/// The value of a gap.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Argument {
    /// A number, formatted by the gap: `{:04X}`.
    Number(i128),
    /// A quotation from a file, truncated after [`MAX_QUOTED`] characters.
    Value(Box<str>),
    /// The name of a field.
    Key(Field),
    /// A field with a value: `PDOMapping=1`.
    Setting(Field, Box<str>),
    /// Only the value of a field, whose spelling depends on the syntax.
    ValueOf(Field, Box<str>),
    /// The part of the file that describes a part of the device: `[1018sub1]`.
    Section(Part),
    /// A nested text.
    Text(Text),
    /// A text only for syntaxes with object lists.
    OfLists(Text),
    /// Several values with a separator and a final separator.
    Series(Box<[Argument]>, [&'static str; 2]),
}

impl Text {
    /// A template and its values; called by [`say!`], which checks their number.
    pub fn new(template: &'static str, arguments: Box<[Argument]>) -> Self {
        Self { content: TextContent::Template(template, arguments), words: None }
    }

    /// Whether the text is empty.
    pub fn is_empty(&self) -> bool {
        matches!(&self.content, TextContent::Plain(text) if text.is_empty())
    }

    /// The text in the terms of a different syntax.
    #[must_use]
    pub fn in_words(self, words: Vocabulary) -> Self {
        Self { words: Some(words), ..self }
    }

    /// The text followed by `rest`, in the same vocabulary.
    #[must_use]
    pub fn followed_by(self, rest: &Self) -> Self {
        let words = self.words;
        Self { words, ..say!("{}{}", self, rest) }
    }

    /// The common pattern of texts that differ only in numbers and quotations from the file: the template, the names of
    /// fields and parts in it, and the values of gaps such as `{!}`, which state requirements.
    pub fn pattern(&self) -> String {
        let (template, arguments) = match &self.content {
            TextContent::Plain(text) => return text.clone().into_owned(),
            TextContent::Template(template, arguments) => (template, arguments),
        };
        let gaps = template.split('{').skip(1).filter(|gap| gap.starts_with(['}', ':', '!']));
        gaps.zip(arguments).fold((*template).to_owned(), |pattern, (gap, argument)| {
            let argument = if gap.starts_with('!') { argument.shown() } else { argument.pattern() };
            pattern + "\u{0}" + &argument
        })
    }

    /// The rendered text.
    pub fn shown(&self) -> Cow<'_, str> {
        match &self.content {
            TextContent::Plain(text) => Cow::Borrowed(text),
            TextContent::Template(..) => Cow::Owned(self.to_string()),
        }
    }

    /// Whether one of the values is this field, with or without a value.
    pub fn names(&self, field: &Field) -> bool {
        self.any(&|argument| match argument {
            Argument::Key(key) | Argument::Setting(key, _) | Argument::ValueOf(key, _) => key == field,
            _ => false,
        })
    }

    /// Whether one of the values is a matching part.
    pub fn names_part(&self, is_meant: impl Fn(&Part) -> bool) -> bool {
        self.any(&|argument| matches!(argument, Argument::Section(part) if is_meant(part)))
    }

    /// The first quotation from a file.
    pub fn quoted(&self) -> Option<&str> {
        let TextContent::Template(_, arguments) = &self.content else { return None };
        arguments.iter().find_map(|argument| match argument {
            Argument::Value(text) => Some(&**text),
            _ => None,
        })
    }

    /// Visits the numbers and quotations from the file, which rewording does not change.
    pub fn each_value(&self, take: &mut dyn FnMut(&str)) {
        if let TextContent::Template(_, arguments) = &self.content {
            arguments.iter().for_each(|argument| argument.each_value(take));
        }
    }

    fn any(&self, is_meant: &dyn Fn(&Argument) -> bool) -> bool {
        let TextContent::Template(_, arguments) = &self.content else { return false };
        arguments.iter().any(|argument| argument.any(is_meant))
    }

    fn write(&self, words: Option<Vocabulary>, out: &mut dyn fmt::Write) -> fmt::Result {
        let (template, arguments) = match &self.content {
            TextContent::Plain(text) => return out.write_str(text),
            TextContent::Template(template, arguments) => (template, arguments),
        };
        let mut arguments = arguments.iter();
        let mut rest = *template;
        while let Some((before, behind)) = rest.split_once('{') {
            out.write_str(before)?;
            let Some((gap, behind)) = behind.split_once('}') else { return out.write_str(behind) };
            let gap = gap.strip_prefix('!').unwrap_or(gap);
            match gap.strip_prefix(':') {
                None if !gap.is_empty() => out.write_str(&Notion::of(gap).shown(words))?,
                spec => match arguments.next() {
                    Some(argument) => argument.write(spec.unwrap_or_default(), words, out)?,
                    None => out.write_char('…')?,
                },
            }
            rest = behind;
        }
        out.write_str(rest)
    }
}

impl Argument {
    /// A field with a value.
    pub fn setting(field: impl Borrow<Field>, value: impl fmt::Display) -> Self {
        Self::Setting(field.borrow().clone(), cut(&value.to_string()))
    }

    /// The value of a field.
    pub fn value_of(field: impl Borrow<Field>, value: impl fmt::Display) -> Self {
        Self::ValueOf(field.borrow().clone(), cut(&value.to_string()))
    }

    fn shown(&self) -> String {
        let mut text = String::new();
        let _ = self.write("", None, &mut text); // writing to a String cannot fail
        text
    }

    /// See [`Text::each_value`].
    fn each_value(&self, take: &mut dyn FnMut(&str)) {
        match self {
            Self::Number(number) => take(&number.to_string()),
            Self::Value(text) | Self::Setting(_, text) | Self::ValueOf(_, text) => take(text),
            Self::Key(_) | Self::Section(_) => {}
            Self::Text(text) | Self::OfLists(text) => text.each_value(take),
            Self::Series(items, _) => items.iter().for_each(|item| item.each_value(take)),
        }
    }

    /// See [`Text::pattern`].
    fn pattern(&self) -> String {
        match self {
            Self::Number(_) | Self::Value(_) => String::new(),
            Self::Key(field) | Self::Setting(field, _) | Self::ValueOf(field, _) => match field {
                Field::Item(_) => String::new(),
                field => field.name().into_owned(),
            },
            Self::Section(Part::Object(_) | Part::Entry(..) | Part::Module(..)) => String::new(),
            Self::Section(part) => section_name(part),
            Self::Text(text) | Self::OfLists(text) => text.pattern(),
            Self::Series(items, _) => items.first().map_or_else(String::new, Self::pattern),
        }
    }

    fn any(&self, is_meant: &dyn Fn(&Argument) -> bool) -> bool {
        is_meant(self)
            || match self {
                Self::Text(text) | Self::OfLists(text) => text.any(is_meant),
                Self::Series(items, ..) => items.iter().any(|item| item.any(is_meant)),
                _ => false,
            }
    }

    fn write(&self, spec: &str, words: Option<Vocabulary>, out: &mut dyn fmt::Write) -> fmt::Result {
        match self {
            Self::Number(number) => write_number(*number, spec, out),
            Self::Value(text) => out.write_str(text),
            Self::Key(field) => out.write_str(&Notion::Key(&field.name()).shown(words)),
            Self::Setting(field, value) => out.write_str(&Notion::Setting(&field.name(), value).shown(words)),
            Self::ValueOf(field, value) => out.write_str(&Notion::ValueOf(&field.name(), value).shown(words)),
            Self::Section(part) => out.write_str(&Notion::Section(&section_name(part)).shown(words)),
            Self::Text(text) => text.write(words, out),
            Self::OfLists(text) => match words {
                None => text.write(words, out),
                Some(_) => Ok(()),
            },
            Self::Series(items, [between, last]) => {
                for (number, item) in items.iter().enumerate() {
                    out.write_str(match number {
                        0 => "",
                        _ if number + 1 == items.len() => last,
                        _ => between,
                    })?;
                    item.write(spec, words, out)?;
                }
                Ok(())
            }
        }
    }
}

/// "a, b and c".
pub fn series<T: Sayable>(items: impl IntoIterator<Item = T>) -> Argument {
    Argument::Series(items.into_iter().map(|item| item.argument()).collect(), [", ", " and "])
}

/// All items with one separator: "a or b or c".
pub fn joined<T: Sayable>(items: impl IntoIterator<Item = T>, between: &'static str) -> Argument {
    Argument::Series(items.into_iter().map(|item| item.argument()).collect(), [between; 2])
}

/// "`a`, `b` and `c`": all items in backticks.
pub fn listing<T: Sayable>(items: impl IntoIterator<Item = T>) -> Argument {
    series(items.into_iter().map(|item| say!("`{}`", item)))
}

/// "a, b or c".
pub fn series_or<T: Sayable>(items: impl IntoIterator<Item = T>) -> Argument {
    Argument::Series(items.into_iter().map(|item| item.argument()).collect(), [", ", " or "])
}

/// "`a`, `b` or `c`", for example after a negation.
pub fn listing_or<T: Sayable>(items: impl IntoIterator<Item = T>) -> Argument {
    series_or(items.into_iter().map(|item| say!("`{}`", item)))
}

/// A number in the format of [`std::fmt`]: `#` for `0x`, the width with leading zeros, `x` or `X` for hex. `:h` writes it in
/// decimal and, from 10, in hex too, because files have both.
fn write_number(number: i128, spec: &str, out: &mut dyn fmt::Write) -> fmt::Result {
    if spec == "h" {
        return if number > 9 { write!(out, "{number} ({number:#X})") } else { write!(out, "{number}") };
    }
    let (is_marked, width) = spec.strip_prefix('#').map_or((false, spec), |width| (true, width));
    let width: usize = width.trim_end_matches(['x', 'X']).parse().unwrap_or_default();
    match (spec.chars().next_back(), is_marked) {
        (Some('X'), false) => write!(out, "{number:0width$X}"),
        (Some('X'), true) => write!(out, "{number:#0width$X}"),
        (Some('x'), false) => write!(out, "{number:0width$x}"),
        (Some('x'), true) => write!(out, "{number:#0width$x}"),
        _ => write!(out, "{number:0width$}"),
    }
}

/// A quotation, truncated to the maximum length.
fn cut(text: &str) -> Box<str> {
    match text.char_indices().nth(MAX_QUOTED) {
        Some((end, _)) => [text.get(..end).unwrap_or_default(), "…"].concat().into(),
        None => text.into(),
    }
}

/// An external text: quotations in backticks are truncated.
fn cut_quotes(text: String) -> String {
    if text.len() <= MAX_QUOTED {
        return text;
    }
    let parts = text.split('`').enumerate();
    let parts = parts.map(|(number, part)| if number % 2 == 1 { cut(part) } else { part.into() });
    parts.collect::<Vec<Box<str>>>().join("`")
}

/// A value for a gap.
pub trait Sayable {
    /// The value as an argument.
    fn argument(&self) -> Argument;
}

macro_rules! sayable {
    ($($type:ty),*: |$this:ident| $argument:expr) => {
        $(impl Sayable for $type {
            fn argument(&self) -> Argument {
                let $this = self;
                $argument
            }
        })*
    };
}

sayable!(i128: |number| Argument::Number(*number));
sayable!(u8, u16, u32, u64, i32, i64: |number| Argument::Number((*number).into()));
sayable!(usize: |number| Argument::Number(i128::try_from(*number).unwrap_or(i128::MAX)));
sayable!(str, String: |text| Argument::Value(cut(text)));
sayable!(
    ClockTime, CobId, DataType, Date, MappedObject, ObjectType, Pdo<'_>, Encoding, PdoKind, Selection, Tool, f64, char:
    |value| Argument::Value(cut(&value.to_string())));
sayable!(Value: |value| match value {
    Value::Signed(number) => Argument::Number((*number).into()),
    Value::Unsigned(number) => Argument::Number((*number).into()),
    value => Argument::Value(cut(&value.to_string())),
});
sayable!(Access: |access| Argument::ValueOf(Field::AccessType, access.name().into()));
sayable!(PdoMapping: |mapping| Argument::ValueOf(
    Field::PdoMapping,
    match mapping {
        PdoMapping::No => "0",
        PdoMapping::Optional => "1",
        mapping => mapping.name(),
    }
    .into()
));
sayable!(Field: |field| Argument::Key(field.clone()));
sayable!(Part: |part| Argument::Section(part.clone()));
sayable!(ObjectList: |list| Argument::Section(Part::List(*list)));
sayable!(Text: |text| Argument::Text(text.clone()));
sayable!(Argument: |argument| argument.clone());

impl<T: Sayable + ?Sized> Sayable for &T {
    fn argument(&self) -> Argument {
        (**self).argument()
    }
}

impl<T: Sayable + ?Sized> Sayable for Box<T> {
    fn argument(&self) -> Argument {
        (**self).argument()
    }
}

impl<T: Sayable + ToOwned + ?Sized> Sayable for Cow<'_, T> {
    fn argument(&self) -> Argument {
        (**self).argument()
    }
}

impl From<&'static str> for Text {
    fn from(text: &'static str) -> Self {
        Self { content: TextContent::Plain(Cow::Borrowed(text)), words: None }
    }
}

impl From<String> for Text {
    fn from(text: String) -> Self {
        Self { content: TextContent::Plain(Cow::Owned(cut_quotes(text))), words: None }
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(self.words, f)
    }
}

impl fmt::Display for Argument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write("", None, f)
    }
}

impl Default for Text {
    fn default() -> Self {
        "".into()
    }
}

impl PartialEq for Text {
    fn eq(&self, other: &Self) -> bool {
        self.content == other.content
    }
}

impl Eq for Text {}

impl PartialOrd for Text {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Text {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.content.cmp(&other.content)
    }
}

impl PartialEq<&str> for Text {
    fn eq(&self, other: &&str) -> bool {
        self.shown() == *other
    }
}

/// A [`Text`]: a template with gaps, and the values for them.
///
/// `{}` and `{:04X}` are gaps for [`Sayable`] values, in order. Terms whose name depends on the syntax are
/// also in braces: a key `{LowLimit}`, a key with a value `{PDOMapping=1}`, a value of a key
/// `{ObjectType:0x8}`, a section `{[DeviceInfo]}`, or one of the [`WORDS`](crate::diagnostic::WORDS), such
/// as `{the key}`. A wrong number of values or an unknown name does not compile.
#[macro_export]
macro_rules! say {
    ($template:literal $(, $argument:expr)* $(,)?) => {{
        const TEMPLATE: &str = $template;
        const { $crate::diagnostic::assert_template(TEMPLATE, <[&str]>::len(&[$(stringify!($argument)),*])) };
        $crate::diagnostic::Text::new(TEMPLATE, Box::new([$($crate::diagnostic::Sayable::argument(&$argument)),*]))
    }};
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_filled_in_their_order() {
        assert_eq!(say!("{:04X}h, `{}` or {:#x}", 0x1Au8, "a}{", 26), "001Ah, `a}{` or 0x1a");
        assert_eq!(
            say!("`{PDOMapping=1}` in {a section} `{[DeviceInfo]}`"),
            "`PDOMapping=1` in a section `[DeviceInfo]`"
        );
        assert_eq!(say!("add `{}`", Part::Entry(0xA00, 11)), "add `[A00subB]`");
    }

    #[test]
    fn items_are_listed_as_people_write_them() {
        assert_eq!(say!("{}", listing(["a"])), "`a`");
        assert_eq!(say!("{}", listing(["a", "b"])), "`a` and `b`");
        assert_eq!(say!("{}", series([1, 2, 3])), "1, 2 and 3");
        assert_eq!(say!("{}", joined(["a", "b", "c"], " or ")), "a or b or c");
    }

    #[test]
    fn values_are_cut_and_sentences_are_not() {
        let long = "ä".repeat(1_000_000);
        let shown = format!("`{}…`", "ä".repeat(MAX_QUOTED));
        assert_eq!(say!("`{}`", long), shown.as_str());
        assert_eq!(Text::from(format!("`{long}`")), shown.as_str());
        assert_eq!(Text::from("a".repeat(200)).shown().len(), 200);
    }

    #[test]
    fn another_syntax_has_other_words() {
        let words: Vocabulary = |notion| match notion {
            Notion::Key("LowLimit") => Some("lowLimit".to_owned()),
            Notion::ValueOf("LSS_Supported", value) => Some((*value == "1").to_string()),
            _ => None,
        };
        let nested = say!("`{}` of `{}`", Field::LowLimit, "LowLimit");
        let text = say!("{} is {LSS_Supported:1}, `{LowLimit}`", nested).in_words(words);
        assert_eq!(text, "`lowLimit` of `LowLimit` is true, `lowLimit`");
        assert!(text.names(&Field::LowLimit) && !text.names(&Field::HighLimit));
    }
}

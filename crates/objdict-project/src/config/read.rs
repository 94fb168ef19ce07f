//! Reads settings from TOML.
//!
//! The TOML tree is walked by hand instead of being deserialised, so that one invalid setting does not hide the
//! others.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::path::PathPattern;
use super::settings::{Settings, WantedFiles, WantedProfile};
use crate::registry;
use crate::registry::own::{INVALID_TOML, UNKNOWN_SETTING, invalid_setting, unknown_rule};
use objdict_lint::Level;
use objdict_model::diagnostic::{
    At, Diagnostic, Findings, Selection, Severity, Text, Tool, listing, nearest, say,
};
use objdict_model::source::Span;

/// The settings with their meanings, in the order of docs/reference/config.md.
pub const SETTINGS: [(&str, &str); 8] = [
    ("profiles", "Profiles that all files are checked against: numbers, or files."),
    ("patches", "Patches that are applied to the files that they are for."),
    ("node-id", "The node-ID that formulas are evaluated for."),
    ("compat", "Tools that the files must be compatible with."),
    ("deny", "The lowest severity that fails the run: `note`, `warning`, `error`."),
    ("exclude", "Patterns of files that are not checked."),
    ("rules", "The severity of rules and groups: `off`, `note`, `warning`, `error`."),
    ("ignore", "Rules that are not reported in the files of a pattern."),
];

type TomlValue<'a> = Spanned<DeValue<'a>>;

/// The notation of a list.
const LIST: &str = "write strings in quotes between brackets, as in `[\"a\", \"b\"]`";

/// The settings in a text; `None` if it is not TOML.
pub(super) fn read(text: &str, findings: &mut Findings) -> Option<Settings> {
    let (table, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        errors.iter().for_each(|error| findings.push(damage(text, error)));
        return None;
    }
    let mut reader = ConfigReader { settings: Settings::default(), findings };
    for (key, value) in table.get_ref() {
        reader.setting(key, value);
    }
    // a rule overrides its group, regardless of their order
    reader.settings.levels.sort_by_key(|(rules, _)| matches!(rules, Selection::Rule(_)));
    Some(reader.settings)
}

/// The start of a finding.
pub(super) fn start_of(finding: &Diagnostic) -> u32 {
    match finding.labels.first().map(|label| &label.at) {
        Some(At::Span(span)) => span.start,
        _ => 0,
    }
}

/// The syntax error in a text.
fn damage(text: &str, error: &toml::de::Error) -> Diagnostic {
    let span = error.span().map_or(Span::empty(0), |range| span_of(&range));
    let message = error.message().lines().next().unwrap_or("this is not valid TOML").to_owned();
    let finding = Diagnostic::new(&INVALID_TOML, span, message);
    let before = text.get(..span.start as usize).unwrap_or(text);
    let line = before.rsplit(['\n', '\r']).next().unwrap_or_default();
    let behind = text.get(span.start as usize..).unwrap_or_default();
    if behind.starts_with('/') || line.ends_with('/') {
        return finding.help("put rule ids and paths in quotes");
    }
    finding.help("write `name = value`, with strings in quotes and lists in brackets")
}

struct ConfigReader<'f> {
    settings: Settings,
    findings: &'f mut Findings,
}

impl ConfigReader<'_> {
    fn setting(&mut self, key: &Spanned<std::borrow::Cow<'_, str>>, value: &TomlValue<'_>) {
        match &**key.get_ref() {
            "profiles" => {
                let profiles = self.texts("profiles", value);
                let wanted =
                    profiles.into_iter().map(|(name, span)| WantedProfile { name: name.to_owned(), span });
                self.settings.profiles = wanted.collect();
            }
            "patches" => {
                let patterns = self.texts("patches", value);
                let sound = patterns.into_iter().filter(|(text, span)| self.pattern(text, *span).is_some());
                self.settings.patches =
                    sound.map(|(text, span)| WantedFiles { pattern: text.to_owned(), span }).collect();
            }
            "node-id" => self.node_id(value),
            "compat" => {
                for (name, span) in self.texts("compat", value) {
                    match Tool::named(name) {
                        Some(tool) => self.settings.tools.push(tool),
                        None => self.unknown_word(span, name, "tool", &Tool::ALL.map(Tool::name)),
                    }
                }
            }
            "deny" => {
                let severities = [Severity::Note, Severity::Warning, Severity::Error];
                self.settings.deny = self.word("deny", value, &severities, |severity| severity.name());
            }
            "exclude" => {
                let patterns = self.texts("exclude", value);
                let patterns = patterns.into_iter().filter_map(|(text, span)| self.pattern(text, span));
                self.settings.excluded = patterns.collect();
            }
            "rules" => self.rules(value),
            "ignore" => self.ignored(value),
            unknown => {
                let finding = Diagnostic::new(
                    &UNKNOWN_SETTING,
                    span_of(&key.span()),
                    say!("unknown setting `{}`", unknown),
                );
                self.findings.push(match nearest(unknown, SETTINGS.map(|(name, _)| name)) {
                    Some(meant) => finding.help(say!("did you mean `{}`?", meant)),
                    None => {
                        finding.help(say!("the settings are {}", listing(SETTINGS.map(|(name, _)| name))))
                    }
                });
            }
        }
    }

    fn node_id(&mut self, value: &TomlValue<'_>) {
        let number = value.get_ref().as_integer();
        let number = number.and_then(|number| u8::from_str_radix(number.as_str(), number.radix()).ok());
        match number.filter(|number| (1..=127).contains(number)) {
            Some(number) => self.settings.node_id = Some(number),
            None => {
                self.invalid(value, "`node-id` is a number from 1 to 127", "write it as in `node-id = 5`");
            }
        }
    }

    fn rules(&mut self, value: &TomlValue<'_>) {
        let Some(table) = value.get_ref().as_table() else {
            let help = "write `\"cia306/file-name\" = \"off\"` below a line `[rules]`";
            return self.invalid(value, "`rules` is a table of rules and their severities", help);
        };
        for (key, value) in table {
            let name = key.get_ref();
            let level = self.word(name, value, &Level::ALL, |level| level.name());
            match registry::select(name) {
                Some(rules) => self.settings.levels.extend(level.map(|level| (rules, level))),
                None => self.findings.push(unknown_rule(span_of(&key.span()), name)),
            }
        }
    }

    fn ignored(&mut self, value: &TomlValue<'_>) {
        let Some(table) = value.get_ref().as_table() else {
            let help = "write `\"legacy\" = [\"cia306\"]` below a line `[ignore]`";
            return self.invalid(value, "`ignore` is a table of paths and lists of rules", help);
        };
        for (key, value) in table {
            let pattern = self.pattern(key.get_ref(), span_of(&key.span()));
            let mut ignored = Vec::new();
            for (name, span) in self.texts(key.get_ref(), value) {
                match registry::select(name) {
                    Some(rules) => ignored.push(rules),
                    None => self.findings.push(unknown_rule(span, name)),
                }
            }
            self.settings.ignored.extend(pattern.map(|pattern| (pattern, ignored)));
        }
    }

    fn pattern(&mut self, text: &str, span: Span) -> Option<PathPattern> {
        match PathPattern::new(text) {
            Ok(pattern) => Some(pattern),
            Err(error) => {
                let message = say!("`{}` is not a valid path pattern: {}", text, Text::from(error.msg));
                let help = "`*` and `?` match within a name, `**` any number of folders, `[ab]` one of the characters";
                self.findings.push(invalid_setting(span, message).help(help));
                None
            }
        }
    }

    /// The strings of a list with their positions.
    fn texts<'a>(&mut self, name: &str, value: &'a TomlValue<'_>) -> Vec<(&'a str, Span)> {
        let Some(list) = value.get_ref().as_array() else {
            self.invalid(value, say!("`{}` must be a list of strings", name), LIST);
            return Vec::new();
        };
        let mut texts = Vec::new();
        for item in list {
            match item.get_ref().as_str() {
                Some(text) => texts.push((text, span_of(&item.span()))),
                None => self.invalid(item, say!("`{}` must be a list of strings", name), LIST),
            }
        }
        texts
    }

    /// A value that is one of some keywords.
    fn word<T: Copy>(
        &mut self,
        name: &str,
        value: &TomlValue<'_>,
        all: &[T],
        word: fn(&T) -> &'static str,
    ) -> Option<T> {
        let words: Vec<&str> = all.iter().map(word).collect();
        let Some(text) = value.get_ref().as_str() else {
            let help = say!("write one of them, as in `\"{}\"`", words.first().copied().unwrap_or_default());
            self.invalid(value, say!("`{}` must be one of {}, in quotes", name, listing(&words)), help);
            return None;
        };
        let found = all.iter().copied().find(|item| word(item) == text);
        if found.is_none() {
            self.unknown_word(span_of(&value.span()), text, "severity", &words);
        }
        found
    }

    fn unknown_word(&mut self, span: Span, word: &str, what: &str, words: &[&str]) {
        let finding = invalid_setting(span, say!("unknown {} `{}`", what, word));
        self.findings.push(match nearest(word, words.iter().copied()) {
            Some(meant) => finding.help(say!("did you mean `{}`?", meant)),
            None => finding.help(say!("write one of {}", listing(words))),
        });
    }

    fn invalid(&mut self, value: &TomlValue<'_>, message: impl Into<Text>, help: impl Into<Text>) {
        self.findings.push(invalid_setting(span_of(&value.span()), message).help(help));
    }
}

fn span_of(range: &Range<usize>) -> Span {
    Span::new(range.start as u32, range.end as u32)
}

//! The table: rule, tools, reaction. Tested with dcf-tools 2.4.2, canopen 2.4.1 for Python, canopen 6.2.1 of npm and
//! CANopenNode 4; also based on the sources of CANopenEditor of July 2026 and CANopenNode 4, and on the manual of
//! CODESYS.
//!
//! A cause that no rule detects needs a rule in the group `portability`: in `objdict-lint`, or in `objdict-eds`
//! if only the text shows it.

use super::{Effect, Reaction, When};
use objdict_eds::eds;
use objdict_format::Description;
use objdict_model::canopennode::{Cause, unmet};
use objdict_model::diagnostic::Tool::{
    CanOpenEditor, CanOpenNode, Codesys, DcfTools, NodeCanopen, PythonCanopen,
};
use objdict_model::diagnostic::{At, Diagnostic, SourceLabel, Tool};
use objdict_model::literal::{Quirks, integer};
use objdict_model::model::{DataType, Field, ObjectList, Part, Place};
use objdict_model::source::Encoding;

use Effect::{Dropped, Refused, Wrong};

/// Both readers based on Python's INI reader.
const PYTHON: &[Tool] = &[DcfTools, PythonCanopen];
const DCF_TOOLS: &[Tool] = &[DcfTools];
const PYTHON_CANOPEN: &[Tool] = &[PythonCanopen];
const EDITOR: &[Tool] = &[CanOpenEditor];
const CANOPENNODE: &[Tool] = &[CanOpenNode];
const NODE: &[Tool] = &[NodeCanopen];
/// The tools that write files.
const WRITERS: &[Tool] = &[PythonCanopen, CanOpenEditor, NodeCanopen];

const fn row(rule: &'static str, tools: &'static [Tool], effect: Effect, what: &'static str) -> Reaction {
    Reaction { rule, tools, effect, what, when: None }
}

impl Reaction {
    const fn when(self, text: &'static str, holds: fn(&Description, &Diagnostic) -> bool) -> Self {
        Self { when: Some(When { text, holds }), ..self }
    }
}

/// Whether a finding concerns an object with an entry that the stack cannot read.
fn is_read_by_stack(description: &Description, finding: &Diagnostic) -> bool {
    let index = |at: &At| match at {
        At::Place(Place { part: Part::Object(index) | Part::Entry(index, _), .. }) => Some(*index),
        _ => None,
    };
    let Some(found) = finding.labels.first().and_then(|label| index(&label.at)) else { return false };
    let unread = unmet(description.device())
        .into_iter()
        .filter(|unmet| matches!(unmet.cause, Cause::Start | Cause::Entry));
    unread
        .into_iter()
        .any(|unmet| matches!(unmet.place.part, Part::Object(at) | Part::Entry(at, _) if at == found))
}

/// All known reactions, in the order of the rules.
pub static REACTIONS: &[Reaction] = &[
    row("cia301/incomplete-pdo-parameter", CANOPENNODE, Wrong, Cause::Entry.effect())
        .when("of an entry that the stack reads", is_read_by_stack),
    row("cia301/incomplete-sdo-parameter", CANOPENNODE, Wrong, Cause::Entry.effect())
        .when("of an entry that the stack reads", is_read_by_stack),
    row("cia301/mapped-object-missing", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia301/missing-mandatory-object", DCF_TOOLS, Refused, "the file is rejected")
        .when("1000h or 1018h", |_, finding| !helps(finding, |part| *part == Part::Object(0x1001))),
    row("cia301/pdo-without-mapping", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia301/wrong-data-type", CANOPENNODE, Wrong, Cause::Entry.effect())
        .when("of an entry that the stack reads", is_read_by_stack),
    row(
        "cia306/blank-before-equals",
        PYTHON,
        Wrong,
        "an indented line is read as continuation of the value above it",
    )
    .when("a line is indented", |description, _| has_entry(description, is_indented)),
    row("cia306/blank-before-equals", EDITOR, Dropped, "the line is skipped")
        .when("a line is indented or has a tab before `=`", |description, _| {
            has_entry(description, |line| is_indented(line) || has_tab(line))
        }),
    row("cia306/blanks-in-section-name", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/blanks-in-section-name", &[PythonCanopen, NodeCanopen], Dropped, "the section is skipped"),
    row("cia306/blanks-in-section-name", EDITOR, Wrong, "the keys below are read into the previous section"),
    row("cia306/boolean-word", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/boolean-word", PYTHON_CANOPEN, Dropped, "the value is lost"),
    row("cia306/boolean-word", NODE, Wrong, "both words are read as true"),
    row("cia306/byte-order-mark", PYTHON, Refused, "the file is rejected"),
    row("cia306/comment-style", PYTHON, Refused, "the file is rejected").when(
        "with `//`",
        |description, _| {
            description.document().is_some_and(|document| {
                document.lines().any(|line| line.span.of(document.text()).trim_start().starts_with("//"))
            })
        },
    ),
    row("cia306/commissioning-spelling", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/commissioning-spelling", PYTHON_CANOPEN, Dropped, "node-ID and bit rate are lost"),
    row("cia306/duplicate-key", PYTHON, Refused, "the file is rejected")
        .when("in the same case", is_repeated),
    row("cia306/duplicate-key", NODE, Wrong, "the last line applies").when("in the same case", is_repeated),
    row("cia306/duplicate-section", PYTHON, Refused, "the file is rejected")
        .when("in the same case", is_repeated),
    row(
        "cia306/duplicate-section",
        EDITOR,
        Wrong,
        "both become one section, with the first value of each key",
    ),
    row("cia306/duplicate-section", NODE, Wrong, "the last value of each key applies")
        .when("in the same case", is_repeated),
    row("cia306/formula-spelling", DCF_TOOLS, Refused, "the file is rejected")
        .when("`$nodeid` alone", |description, finding| {
            shown(description, finding).eq_ignore_ascii_case("$NODEID")
        }),
    row("cia306/hex-prefix-in-bytes", DCF_TOOLS, Refused, "dcf2dev rejects the value"),
    row("cia306/hex-prefix-in-bytes", PYTHON_CANOPEN, Dropped, "the value is lost")
        .when("with `0x`", |description, finding| has_hex_mark(shown(description, finding))),
    row("cia306/indented-section", PYTHON, Wrong, "the header is read as continuation of the value above it"),
    row("cia306/indented-section", EDITOR, Wrong, "the keys below are read into the previous section"),
    row("cia306/indented-section", NODE, Wrong, "the keys below are read into the previous section"),
    row("cia306/invalid-list-entry", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/junk-line", PYTHON, Refused, "the file is rejected"),
    row("cia306/key-before-section", PYTHON, Refused, "the file is rejected"),
    row("cia306/leading-zero", PYTHON, Refused, "the number is rejected, and usually the file")
        .when("outside [FileInfo], except 00", is_read_number),
    row("cia306/limit-above-type", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/limit-above-type", PYTHON_CANOPEN, Wrong, "the limit is read as a negative number"),
    row("cia306/limits-on-text", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/list-numbering", DCF_TOOLS, Refused, "the file is rejected")
        .when("outside [Comments]", |description, finding| !is_of_comments(description, finding)),
    row("cia306/listed-object-missing", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/low-limit-above-high", NODE, Refused, "the file is rejected").when(
        "of numbers",
        |description, finding| {
            let text = description.source().text();
            let is_formula = |label: &SourceLabel| description.span_of(&label.at).of(text).contains('$');
            !finding.labels.iter().any(is_formula)
        },
    ),
    row("cia306/missing-header", PYTHON, Refused, "the file is rejected"),
    row("cia306/missing-header", NODE, Wrong, "the keys are read into the section above"),
    row("cia306/missing-key", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/missing-key", PYTHON_CANOPEN, Refused, "the file is rejected").when(
        "`DataType` or `AccessType`, except in modules",
        |description, finding| {
            [Field::DataType, Field::AccessType].iter().any(|field| finding.message.names(field))
                && !section_of(description, finding).starts_with(['M', 'm'])
        },
    ),
    row("cia306/missing-key", EDITOR, Dropped, "the object is skipped"),
    row("cia306/missing-key", NODE, Refused, "the file is rejected").when(
        "`DataType`, except in modules",
        |description, finding| {
            finding.message.names(&Field::DataType)
                && !section_of(description, finding).starts_with(['M', 'm'])
        },
    ),
    row("cia306/missing-name", PYTHON, Refused, "the file is rejected")
        .when("no `ParameterName`", is_at_header),
    row("cia306/missing-name", EDITOR, Dropped, "the object is skipped")
        .when("no `ParameterName`", is_at_header),
    row("cia306/missing-name", NODE, Refused, "the file is rejected")
        .when("no `ParameterName`", is_at_header),
    row("cia306/missing-section", DCF_TOOLS, Refused, "the file is rejected")
        .when("a list of objects", |_, finding| {
            finding.message.names_part(|part| matches!(part, Part::List(_)))
        }),
    row("cia306/missing-section", EDITOR, Refused, "the file is rejected").when(
        "[FileInfo], [DeviceInfo] or [MandatoryObjects]",
        |_, finding| {
            let required = [Part::FileInfo, Part::DeviceInfo, Part::List(ObjectList::Mandatory)];
            finding.message.names_part(|part| required.contains(part))
        },
    ),
    row("cia306/misspelt-key", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/misspelt-key", WRITERS, Dropped, "the key is lost"),
    row("cia306/misspelt-section", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/misspelt-section", WRITERS, Dropped, "the section is lost"),
    row("cia306/nested-structure", NODE, Refused, "the file is rejected")
        .when("`ObjectType` of a sub-index", |_, finding| finding.fix.is_some()),
    row("cia306/node-id-last", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/not-ascii", PYTHON, Refused, "the file is rejected")
        .when("not UTF-8", |description, _| is_of_one_byte(description)),
    row("cia306/not-ascii", EDITOR, Wrong, "each such character becomes U+FFFD")
        .when("not UTF-8", |description, _| is_of_one_byte(description)),
    row("cia306/not-ascii", NODE, Wrong, "each such character becomes U+FFFD")
        .when("not UTF-8", |description, _| is_of_one_byte(description)),
    row("cia306/number-suffix", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/number-suffix", PYTHON_CANOPEN, Dropped, "the value is lost"),
    row("cia306/number-suffix", NODE, Wrong, "the number is read as 0; in 64 bits, the file is rejected"),
    row("cia306/object-not-listed", DCF_TOOLS, Dropped, "the object is skipped"),
    row("cia306/octal-number", PYTHON, Refused, "the number is rejected, and usually the file")
        .when("outside [FileInfo]", is_read_number),
    row("cia306/octal-number", NODE, Wrong, "the number is read as decimal"),
    row("cia306/quoted-string", &[PythonCanopen, CanOpenEditor], Wrong, "the quotes become part of the text"),
    row("cia306/real-as-bits", PYTHON_CANOPEN, Dropped, "the value is lost"),
    row("cia306/real-as-bits", NODE, Wrong, "the bits are read as the number"),
    row("cia306/section-spelling", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/section-spelling", WRITERS, Dropped, "the section is skipped")
        .when("with `0x`, `h`, a point or spaces", |_, finding| {
            finding.fix.is_some() && is_decorated(finding)
        }),
    row("cia306/stray-compact-section", DCF_TOOLS, Refused, "the file is rejected"),
    row(
        "cia306/stray-compact-section",
        PYTHON_CANOPEN,
        Wrong,
        "the names create sub-indexes, or the file is rejected",
    )
    .when("in [xxxxName]", is_of_names),
    row("cia306/sub-number-mismatch", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/sub-of-var", NODE, Refused, "the file is rejected"),
    row("cia306/sub-without-object", PYTHON, Refused, "the file is rejected"),
    row("cia306/sub-without-object", NODE, Refused, "the file is rejected"),
    row("cia306/text-after-section", NODE, Wrong, "the keys below are read into the previous section"),
    row("cia306/trailing-comment", PYTHON_CANOPEN, Dropped, "the value is lost")
        .when("with `#` or `//`", |description, finding| !shown(description, finding).contains(" ;")),
    row(
        "cia306/trailing-comment",
        EDITOR,
        Wrong,
        "the comment becomes part of the value, or the object is skipped",
    ),
    row("cia306/twos-complement", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/twos-complement", PYTHON_CANOPEN, Wrong, "a value is read as a positive number"),
    row("cia306/twos-complement", NODE, Refused, "the file is rejected").when(
        "of a default, or of a low limit that is above the high one as a positive number",
        |description, finding| !is_limit(description, finding) || is_read_above_high(description, finding),
    ),
    row("cia306/unclosed-section", PYTHON, Refused, "the file is rejected"),
    row("cia306/unclosed-section", EDITOR, Wrong, "the keys below are read into the previous section"),
    row("cia306/unclosed-section", NODE, Wrong, "the keys below are read into the previous section"),
    row("cia306/unknown-key", DCF_TOOLS, Refused, "the file is rejected")
        .when("outside [Comments]", |description, finding| !is_of_comments(description, finding)),
    row("cia306/unknown-key", &[CanOpenEditor, NodeCanopen], Dropped, "the key is lost"),
    row("cia306/unknown-key", PYTHON_CANOPEN, Dropped, "the key is lost")
        .when("other than `Factor`, `Unit`, `Description`", |description, finding| {
            !eds::is_meaning_key(shown(description, finding))
        }),
    row("cia306/unknown-section", DCF_TOOLS, Refused, "the file is rejected"),
    row("cia306/unknown-section", PYTHON_CANOPEN, Dropped, "the section is lost"),
    row("cia306/unknown-section", EDITOR, Dropped, "the section is lost")
        .when("letters and digits", |description, finding| is_plain(shown(description, finding))),
    row("cia306/unknown-section", EDITOR, Wrong, "the keys below are read into the previous section")
        .when("other characters in the name", |description, finding| !is_plain(shown(description, finding))),
    row("cia306/unsupported-key", DCF_TOOLS, Refused, "the file is rejected").when(
        "`AccessType`, `SubNumber` or `CompactSubObj`",
        |_, finding| {
            let keys = [Field::AccessType, Field::SubNumber, Field::CompactSubObj];
            keys.iter().any(|field| finding.message.names(field))
        },
    ),
    row("cia306/unsupported-key", NODE, Refused, "the file is rejected")
        .when("other than `SubNumber`", |_, finding| !finding.message.names(&Field::SubNumber)),
    row("cia306/wrong-count", DCF_TOOLS, Refused, "the file is rejected")
        .when("outside [Comments]", |description, finding| !is_of_comments(description, finding)),
    row("cia306/wrong-count", PYTHON_CANOPEN, Refused, "the file is rejected")
        .when("no `Lines`", |description, finding| {
            is_of_comments(description, finding) && is_at_header(description, finding)
        }),
    row("cia306/wrong-object-list", DCF_TOOLS, Refused, "the file is rejected")
        .when("not a mandatory object", |_, finding| {
            !helps(finding, |part| *part == Part::List(ObjectList::Mandatory))
        }),
    row("portability/auto-baud-rate", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/bare-node-id", PYTHON_CANOPEN, Dropped, "the value is lost"),
    row("portability/blanks-after-section", NODE, Wrong, "the keys below are read into the previous section"),
    row("portability/commented-section", EDITOR, Wrong, "the keys below are read into the commented section"),
    row("portability/compact-denotations", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/compact-denotations", WRITERS, Dropped, "they are lost"),
    row("portability/compact-names", EDITOR, Wrong, "they are lost, as are default and mapping"),
    row("portability/compact-names", NODE, Dropped, "they are lost"),
    row("portability/compact-parameter-value", DCF_TOOLS, Refused, "the file is rejected"),
    row(
        "portability/compact-storage",
        PYTHON_CANOPEN,
        Dropped,
        "the number of entries is lost, and all sub-indexes of a RECORD are",
    ),
    row(
        "portability/compact-storage",
        EDITOR,
        Wrong,
        "default and mapping are lost, the low limit becomes the high one",
    ),
    row("portability/compact-storage", NODE, Wrong, "the sub-indexes do not exist"),
    row("portability/compact-values", PYTHON_CANOPEN, Wrong, "the default is used instead"),
    row("portability/compact-values", EDITOR, Wrong, "they are lost, as are default and mapping"),
    row("portability/compact-values", NODE, Dropped, "they are lost"),
    row("portability/denotation", PYTHON_CANOPEN, Dropped, "it is lost"),
    row("portability/domain-without-type", PYTHON, Refused, "the file is rejected"),
    row("portability/dummy-usage", PYTHON_CANOPEN, Refused, "the file is rejected"),
    row("portability/dynamic-channels", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/dynamic-channels", WRITERS, Dropped, "the section is lost"),
    row("portability/empty-key", PYTHON_CANOPEN, Refused, "the file is rejected").when(
        "`ObjectType`, `PDOMapping` or a number of [DeviceInfo]",
        |description, finding| {
            ["ObjectType", "PDOMapping"].contains(&shown(description, finding))
                || is_of_device(description, finding)
        },
    ),
    row("portability/empty-key", EDITOR, Dropped, "the object is skipped")
        .when("outside [DeviceInfo]", |description, finding| !is_of_device(description, finding)),
    row("portability/empty-key", NODE, Refused, "the file is rejected")
        .when("of an ARRAY, RECORD or DOMAIN", |description, finding| {
            ["AccessType", "DefaultValue"].contains(&shown(description, finding))
        }),
    row("portability/file-reference", WRITERS, Dropped, "it is lost"),
    row("portability/hash-in-text", DCF_TOOLS, Wrong, "the text ends before the `#`"),
    row("portability/hash-in-text", NODE, Wrong, "the text ends before the `#`"),
    row("portability/hex-baud-rate", PYTHON_CANOPEN, Refused, "the file is rejected"),
    row("portability/hex-count", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/hex-count", PYTHON_CANOPEN, Refused, "the file is rejected")
        .when("in [xxxxName]", is_of_names),
    row("portability/hex-flag", PYTHON, Refused, "the file is rejected").when(
        "`0x` in [DummyUsage]",
        |description, finding| {
            section_of(description, finding).eq_ignore_ascii_case("DummyUsage")
                && has_hex_mark(shown(description, finding))
        },
    ),
    row("portability/hex-flag", EDITOR, Wrong, "everything but `1` is read as 0")
        .when("it means 1", |description, finding| shown(description, finding).ends_with('1')),
    row("portability/implicit-pdo", WRITERS, Dropped, "the PDOs do not exist"),
    row(
        "portability/key-case",
        PYTHON_CANOPEN,
        Refused,
        "the key is not found, which a name, type or access does not forgive",
    ),
    row("portability/key-case", EDITOR, Dropped, "the key is not found, and mostly the object is skipped"),
    row("portability/key-case", NODE, Refused, "the key is not found, which a name or type does not forgive"),
    row("portability/limit-not-read", PYTHON_CANOPEN, Dropped, "the limit is lost"),
    row("portability/long-value", &[Codesys], Dropped, "the entry is not offered for the configuration"),
    row("portability/mapped-bits", CANOPENNODE, Wrong, Cause::Bits.effect()),
    row("portability/mapping-of-structure", NODE, Refused, "the file is rejected"),
    row("portability/modules", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/modules", PYTHON_CANOPEN, Dropped, "the modules are lost"),
    row("portability/modules", NODE, Dropped, "the modules are lost"),
    row("portability/negative-hex", NODE, Wrong, "the number is read as 0")
        .when("below 56 bits", |description, finding| !is_wide(description, finding)),
    row("portability/negative-hex", NODE, Refused, "the file is rejected").when("of 56 or 64 bits", is_wide),
    row("portability/no-error-history", CANOPENNODE, Refused, Cause::NoHistory.effect()),
    row("portability/object-flags", DCF_TOOLS, Dropped, "they are not obeyed"),
    row("portability/object-flags", PYTHON_CANOPEN, Dropped, "they are lost"),
    row("portability/object-links", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/object-links", WRITERS, Dropped, "they are lost"),
    row("portability/parameter-reference", WRITERS, Dropped, "it is lost"),
    row("portability/real-as-decimal", DCF_TOOLS, Wrong, "the digits are taken for bits")
        .when("of digits only", is_digits),
    row("portability/real-as-decimal", DCF_TOOLS, Refused, "the file is rejected")
        .when("with a point, sign or leading zero", |description, finding| !is_digits(description, finding)),
    row("portability/safety-key", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/safety-key", WRITERS, Dropped, "it is lost"),
    row("portability/section-case", PYTHON_CANOPEN, Dropped, "the section is not found"),
    row(
        "portability/section-case",
        EDITOR,
        Refused,
        "the section is not found, which an information section or list does not forgive",
    ),
    row("portability/section-case", NODE, Dropped, "the section is not found"),
    row("portability/semicolon-in-text", PYTHON, Wrong, "the text ends before the `;`"),
    row("portability/semicolon-in-text", NODE, Wrong, "the text ends before the `;`"),
    row("portability/service-count", CANOPENNODE, Refused, Cause::Count.effect()),
    row("portability/service-gap", CANOPENNODE, Wrong, Cause::Gap.effect()),
    row("portability/service-object-missing", CANOPENNODE, Refused, Cause::Missing.effect()),
    row("portability/sparse-names", PYTHON_CANOPEN, Refused, "the file is rejected"),
    row("portability/sparse-names", EDITOR, Wrong, "they are lost, as are default and mapping"),
    row("portability/sub-before-object", PYTHON_CANOPEN, Refused, "the file is rejected"),
    row("portability/sub-before-object", EDITOR, Dropped, "the section is skipped"),
    row("portability/sub-index-255", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/time-value", PYTHON_CANOPEN, Wrong, "days and milliseconds are read as one number"),
    row("portability/tool-list", DCF_TOOLS, Refused, "the file is rejected"),
    row("portability/tool-list", WRITERS, Dropped, "the section is lost"),
    row("portability/type-definition", DCF_TOOLS, Refused, "the file is rejected"),
    row(
        "portability/type-definition",
        PYTHON_CANOPEN,
        Dropped,
        "the definition is lost, and values of the type are",
    ),
    row("portability/unloadable", &[Tool::Lely], Refused, "the file is rejected"),
    row("portability/unquoted-string", DCF_TOOLS, Refused, "dcf2dev stops at it"),
];

/// The text at the place of a finding.
pub(super) fn shown<'a>(description: &'a Description, finding: &Diagnostic) -> &'a str {
    let span = finding.labels.first().map(|label| description.span_of(&label.at)).unwrap_or_default();
    span.of(description.source().text())
}

/// The name of the section that contains the place of a finding; empty before the first section.
pub(super) fn section_of<'a>(description: &'a Description, finding: &Diagnostic) -> &'a str {
    if is_at_header(description, finding) {
        return shown(description, finding);
    }
    let before = before(description, finding);
    let header = before.rsplit(['\n', '\r']).map(str::trim).find(|line| line.starts_with('['));
    header.map_or("", |header| header.trim_matches(['[', ']']))
}

/// Whether the place of a finding is the name in a section header: missing content has no place of its own.
pub(super) fn is_at_header(description: &Description, finding: &Diagnostic) -> bool {
    before(description, finding).trim_end().ends_with('[')
}

fn before<'a>(description: &'a Description, finding: &Diagnostic) -> &'a str {
    let start = finding.labels.first().map_or(0, |label| description.span_of(&label.at).start);
    description.source().text().get(..start as usize).unwrap_or_default()
}

pub(super) fn is_of_comments(description: &Description, finding: &Diagnostic) -> bool {
    section_of(description, finding).eq_ignore_ascii_case("Comments")
}

fn is_of_device(description: &Description, finding: &Diagnostic) -> bool {
    section_of(description, finding).eq_ignore_ascii_case("DeviceInfo")
}

fn is_of_names(description: &Description, finding: &Diagnostic) -> bool {
    section_of(description, finding).to_ascii_lowercase().ends_with("name")
}

/// Whether the text at the second place of a finding is identical to the first.
fn is_repeated(description: &Description, finding: &Diagnostic) -> bool {
    let text = description.source().text();
    let mut places = finding.labels.iter().map(|label| description.span_of(&label.at).of(text));
    places.next() == places.next()
}

/// Whether the first place of a finding is in an entry of an integer type that node-canopen stores in 64
/// bits.
fn is_wide(description: &Description, finding: &Diagnostic) -> bool {
    let place = finding.labels.first().and_then(|label| description.place_of(&label.at));
    let data_type =
        place.and_then(|place| description.device().data_type_of(&place.part, &Field::DefaultValue));
    let wide = [DataType::INTEGER56, DataType::INTEGER64, DataType::UNSIGNED56, DataType::UNSIGNED64];
    data_type.is_some_and(|data_type| wide.contains(&data_type))
}

/// Whether the value at a finding is a decimal number that Python reads as an integer.
fn is_digits(description: &Description, finding: &Diagnostic) -> bool {
    let text = finding.labels.first().map(|label| description.span_of(&label.at));
    let text = text.map_or("", |span| span.of(description.source().text()));
    !text.starts_with('0') && text.bytes().all(|byte| byte.is_ascii_digit())
}

fn is_limit(description: &Description, finding: &Diagnostic) -> bool {
    let before = before(description, finding);
    let line = before.rsplit(['\n', '\r']).next().unwrap_or_default();
    line.trim_start().to_ascii_lowercase().contains("limit")
}

/// Whether the finding is about a low limit that exceeds the high one if both are read as positive numbers.
fn is_read_above_high(description: &Description, finding: &Diagnostic) -> bool {
    let (before, text) = (before(description, finding), description.source().text());
    let start = before.rfind("\n[").unwrap_or(0);
    let end = text[before.len()..].find("\n[").map_or(text.len(), |at| before.len() + at);
    let mut limits = text[start..end].lines().filter_map(|line| line.split_once('='));
    let high = limits.find(|(key, _)| key.trim().eq_ignore_ascii_case("HighLimit"));
    let number = |text: &str| integer(text.trim(), i64::MIN, u64::MAX, &mut Quirks::default()).ok();
    let is_low = before.rsplit('\n').next().is_some_and(|line| line.trim().eq_ignore_ascii_case("LowLimit="));
    is_low
        && number(shown(description, finding))
            .zip(high.and_then(|(_, high)| number(high)))
            .is_some_and(|(low, high)| low > high)
}

/// Whether the text contains an entry whose line satisfies `is_meant`.
fn has_entry(description: &Description, is_meant: fn(&str) -> bool) -> bool {
    description.document().is_some_and(|document| {
        let is_entry =
            |line: &objdict_eds::ini::Line| matches!(line.kind, objdict_eds::ini::LineKind::Entry { .. });
        document.lines().filter(is_entry).any(|line| is_meant(line.span.of(document.text())))
    })
}

fn is_indented(line: &str) -> bool {
    line.starts_with([' ', '\t'])
}

fn has_tab(line: &str) -> bool {
    line.split_once('=').is_some_and(|(key, _)| key.ends_with('\t'))
}

/// Whether the help for a finding names a part.
fn helps(finding: &Diagnostic, is_meant: fn(&Part) -> bool) -> bool {
    finding.help.as_ref().is_some_and(|help| help.names_part(is_meant))
}

/// Whether the name of a section contains `0x` or spaces.
fn is_decorated(finding: &Diagnostic) -> bool {
    let name = finding.message.quoted().unwrap_or_default();
    name.contains(char::is_whitespace) || name.to_ascii_lowercase().contains("0x")
}

fn has_hex_mark(value: &str) -> bool {
    value.get(..2).is_some_and(|mark| mark.eq_ignore_ascii_case("0x"))
}

/// Whether a number is one that Python tools read and whose leading zero they reject.
fn is_read_number(description: &Description, finding: &Diagnostic) -> bool {
    let is_zero = shown(description, finding).bytes().all(|byte| byte == b'0');
    !is_zero && !section_of(description, finding).eq_ignore_ascii_case("FileInfo")
}

/// Whether the text is in a single-byte encoding.
pub(super) fn is_of_one_byte(description: &Description) -> bool {
    let encoding = description.source().encoding();
    !matches!(encoding, Encoding::Utf8 | Encoding::Utf8Bom | Encoding::Utf16Le | Encoding::Utf16Be)
}

/// Whether a name consists of letters and digits.
fn is_plain(name: &str) -> bool {
    name.bytes().all(|byte| byte.is_ascii_alphanumeric())
}

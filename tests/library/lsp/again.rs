//! Objects that an edit does not touch are neither read nor checked again, and the findings equal a fresh check.

use objdict::diagnostic::{Findings, Tool};
use objdict::format::{Description, Format, read, read_after};
use objdict::lint::{KnownObjects, Options};
use objdict::source::SourceFile;
use objdict::workspace::{findings, findings_after};

use super::client::fixture;
use super::random::Numbers;

/// A description that is edited.
struct Edited {
    description: Description,
    known: KnownObjects,
    options: Options,
}

/// All of a finding but the page of its rule.
fn shown(findings: &Findings) -> Vec<String> {
    let counted = findings.omitted().chain(findings.unlisted()).map(|counted| format!("{counted:?}"));
    let shown = findings.iter().map(|found| {
        let (rule, severity, message, help) = (found.rule.id, found.severity, &found.message, &found.help);
        format!(
            "{rule} {severity} {message} {help:?} {:?} {:?} {}",
            found.labels, found.fix, found.is_understood
        )
    });
    counted.chain(shown).collect()
}

impl Edited {
    fn new(text: &str, tools: &[Tool]) -> Self {
        let mut options = Options::default();
        options.tools = tools.to_vec();
        let description = read(SourceFile::from_text("a.eds", text), Format::Eds);
        let mut known = KnownObjects::default();
        let _ = findings_after(&description, &options, &mut known);
        Self { description, known, options }
    }

    /// Edits the text; how many objects were read for it, and how many were checked.
    fn edit(&mut self, text: &str) -> (usize, usize) {
        let source = || SourceFile::from_text("a.eds", text);
        let edited = read_after(source(), Format::Eds, Some(&self.description));
        let fresh = read(source(), Format::Eds);
        assert!(edited.described() == fresh.described(), "{text}");
        assert_eq!(shown(edited.findings()), shown(fresh.findings()), "{text}");
        let found = findings_after(&edited, &self.options, &mut self.known);
        let expected = findings(&fresh, &self.options);
        assert_eq!(
            found.iter().map(shown).collect::<Vec<_>>(),
            expected.iter().map(shown).collect::<Vec<_>>(),
            "{text}"
        );
        let (before, after) = (&self.description.described().objects, &edited.described().objects);
        let read = after.keys().filter(|index| !after.shares(before, index)).count();
        self.description = edited;
        (read, self.known.checked())
    }
}

#[test]
fn an_edit_reads_and_checks_the_objects_around_it() {
    let original = fixture("eds/io-401.eds");
    let section = |index: &str| original.find(&format!("[{index}")).unwrap();
    let inside = section("1018sub1") + 20;
    let next = original[inside..].find("\r\n").unwrap() + inside;
    let with = |at: usize, end: usize, new: &str| format!("{}{new}{}", &original[..at], &original[end..]);
    let all = Edited::new(&original, &[]).description.described().objects.len();
    for (what, text, objects) in [
        ("a value", with(next, next, "1"), 1),
        ("a comment in a section", with(next, next, "\r\n;why"), 1),
        ("a line end", with(next, next + 1, ""), 1),
        ("the header of a sub-index", with(inside - 20, inside - 19, ""), 1),
        ("the header of an object", with(section("1018]") + 4, section("1018]") + 5, "9"), 3),
        ("from one object to the next", with(section("1018]") - 9, section("1018]") + 9, ""), 2),
        ("a list", with(section("OptionalObjects]") + 40, section("OptionalObjects]") + 41, ""), 0),
        ("a key of the file", original.replacen("EDSVersion=4.0", "EDSVersion=4.1", 1), 0),
        ("before the first section", format!("; what\r\n{original}"), 0),
        ("the end", format!("{original}\r\n[2000]\r\nParameterName=a\r\n"), 1),
        ("all line ends", original.replace('\r', ""), all),
    ] {
        assert_ne!(text, original, "{what}");
        let mut edited = Edited::new(&original, &[]);
        assert_eq!(edited.edit(&text), (objects, objects), "{what}: objects read and checked");
    }
}

#[test]
fn whatever_is_edited_is_read_and_checked_as_from_the_start() {
    let small = include_str!("../../support/small.dcf").to_owned();
    let names =
        ["compact", "coupler-modular", "dspic-sensors", "hostile", "io-401", "microcanopen", "minimal"];
    let texts = names.into_iter().map(|name| fixture(&format!("eds/{name}.eds"))).chain([small]);
    let (mut all, mut read) = (0, 0);
    for (number, original) in texts.enumerate() {
        let tools = if number % 2 == 0 { &[][..] } else { &Tool::ALL[..] };
        let mut edited = Edited::new(&original, tools);
        let mut numbers = Numbers::new(37);
        let mut text = original.clone();
        for edit in 0..48 {
            if edit % 12 == 0 {
                text.clone_from(&original);
            }
            text = if edit % 3 == 0 { numbers.edit(&text) } else { numbers.edit_of_lines(&text) };
            let (now, _) = edited.edit(&text);
            read += now;
            all += edited.description.described().objects.len();
        }
    }
    assert!(read * 2 < all, "{read} of {all} objects were read");
}

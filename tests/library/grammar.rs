//! Grammar that reads as translated: its patterns are counted, and long sentences are listed. No count of `grammar.tsv` may rise.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::pages::{MADE_OF_RULES, by_hand, findings, help, pages_for_users};

/// The patterns with their spellings, words and punctuation separated by spaces; `^` is the start of a sentence.
const PATTERNS: [(&str, &[&str]); 15] = [
    ("another", &["another"]),
    ("any more", &["any more"]),
    ("anew", &["anew"]),
    ("beside", &["beside"]),
    ("blank", &["blank", "blanks"]),
    (
        "comma, and, verb",
        &[
            ", and is",
            ", and are",
            ", and can",
            ", and cannot",
            ", and has",
            ", and have",
            ", and does",
            ", and may",
            ", and must",
            ", and then",
            ", and not",
        ],
    ),
    (
        "counts",
        &[
            "counts for",
            "count for",
            "counts from",
            "counts more",
            "counts as",
            "count as",
            "counts too",
            "counts ,",
            "counts .",
            "counts ;",
        ],
    ),
    ("in words", &["in words", "into words"]),
    ("say", &["say", "says", "saying", "said"]),
    ("sum, distance", &["sum", "sums", "distance", "distances"]),
    ("that of", &["that of", "those of"]),
    (
        "the one before",
        &["the one before", "the ones before", "the one that", "the ones that", "those that", "those which"],
    ),
    ("the most, the least", &["the most", "the least"]),
    ("what", &["of what", "and what", "than what", "but what", ", what"]),
    ("whether", &["^ whether"]),
];

/// The longest sentence that is not listed, in words.
const LONG: usize = 30;

/// The sentences of a Markdown text; a piece of code is one word.
fn sentences(text: &str) -> Vec<String> {
    let mut blocks = vec![String::new()];
    let mut in_code = false;
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        let block = blocks.last_mut().unwrap();
        match event {
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(TagEnd::CodeBlock) => in_code = false,
            Event::Code(_) => block.push_str("code"),
            Event::SoftBreak => block.push(' '),
            Event::Text(piece) if !in_code => block.push_str(&piece),
            Event::Start(Tag::Item | Tag::Paragraph | Tag::TableCell | Tag::Heading { .. })
            | Event::End(TagEnd::Item | TagEnd::Paragraph | TagEnd::TableCell | TagEnd::Heading(_)) => {
                blocks.push(String::new());
            }
            _ => {}
        }
    }
    let sentences = blocks
        .iter()
        .flat_map(|block| block.replace("? ", "?. ").split(". ").map(str::to_owned).collect::<Vec<_>>());
    sentences.filter(|sentence| !sentence.trim().is_empty()).collect()
}

/// The words and the punctuation of a sentence, in lower case between spaces.
fn tokens(sentence: &str) -> String {
    let mut tokens = String::from(" ^ ");
    for word in sentence.to_lowercase().split_whitespace() {
        let bare = word.trim_matches(|c: char| !c.is_alphanumeric());
        let mark = word.chars().next_back().filter(|c| ",.;:".contains(*c));
        let _ = match mark {
            Some(mark) => write!(tokens, "{bare} {mark} "),
            None => write!(tokens, "{bare} "),
        };
    }
    tokens
}

/// The sentences of the texts with a name each: pages by hand, rules, findings and help.
fn scopes() -> Vec<(&'static str, Vec<(String, String)>)> {
    let is_by_hand = |page: &PathBuf| !MADE_OF_RULES.iter().any(|made| page.starts_with(made));
    let of = |texts: Vec<(String, String)>| {
        let sentences = texts.into_iter().flat_map(|(place, text)| {
            sentences(&text).into_iter().map(move |sentence| (place.clone(), sentence)).collect::<Vec<_>>()
        });
        sentences.collect()
    };
    let pages = pages_for_users().filter(is_by_hand);
    let pages = pages.map(|page| (page.display().to_string(), by_hand(&page))).collect();
    let rules =
        objdict::registry::rules().into_iter().map(|rule| (rule.id.to_owned(), rule.page())).collect();
    vec![("pages", of(pages)), ("rules", of(rules)), ("findings", of(findings())), ("help", of(help()))]
}

#[test]
fn translated_grammar_does_not_return() {
    let mut places: BTreeMap<(&str, &str), Vec<String>> = BTreeMap::new();
    for (scope, sentences) in scopes() {
        assert!(sentences.len() > 500, "{scope}: {}", sentences.len());
        for (place, sentence) in sentences {
            let tokens = tokens(&sentence);
            let shown = format!("{place}: {}", sentence.trim());
            for (pattern, spellings) in PATTERNS {
                let found = spellings.iter().map(|spelling| tokens.matches(&format!(" {spelling} ")).count());
                (0..found.sum())
                    .for_each(|_| places.entry((scope, pattern)).or_default().push(shown.clone()));
            }
            if scope == "pages" && sentence.split_whitespace().count() > LONG {
                places.entry((scope, "long")).or_default().push(shown);
            }
        }
    }
    let mut text = String::from("texts\tpattern\tcount\n");
    places.iter().for_each(|((scope, pattern), found)| {
        let _ = writeln!(text, "{scope}\t{pattern}\t{}", found.len());
    });
    for sentence in places.get(&("pages", "long")).into_iter().flatten() {
        let _ = writeln!(text, "long: {sentence}");
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library/grammar.tsv");
    if std::env::var_os("OBJDICT_GRAMMAR").is_some_and(|value| value == "write") {
        return fs::write(file, text).unwrap();
    }
    let stored = fs::read_to_string(file).unwrap();
    let stored: BTreeMap<_, usize> = stored
        .lines()
        .filter_map(|line| {
            let mut cells = line.split('\t');
            Some(((cells.next()?, cells.next()?), cells.next()?.parse().ok()?))
        })
        .collect();
    for (key, found) in &places {
        let allowed = stored.get(key).copied().unwrap_or_default();
        assert!(found.len() <= allowed, "{key:?}: {allowed} are allowed:\n{}", found.join("\n"));
    }
    let fewer: Vec<_> =
        stored.iter().filter(|(key, count)| places.get(*key).map_or(0, Vec::len) < **count).collect();
    assert!(fewer.is_empty(), "better than stored, set OBJDICT_GRAMMAR=write to keep it: {fewer:?}");
}

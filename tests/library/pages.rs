//! The Markdown of the project as its readers meet it: links lead somewhere, the site has every page, the words are those of
//! CONTRIBUTING.md, and what pages quote from the program is what it prints.

use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use objdict::build_script::{Builder, Error};
use objdict::format::{self, Format};
use objdict::report::{Concise, Report};
use objdict::source::SourceFile;
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// A text that a user reads, and where it is.
type Text = (String, String);

/// Texts with the words of CONTRIBUTING.md.
const SCOPES: [fn() -> Vec<Text>; 5] = [prose_of_pages, rules, findings, help, comments];

/// Pages that are made of the texts of rules, in the sources.
pub(crate) const MADE_OF_RULES: [&str; 2] = ["docs/reference/portability.md", "docs/rules"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The pages of the project, by their paths.
pub(crate) fn pages() -> Vec<PathBuf> {
    let folders = ["docs", "examples", "fixtures", "crates"].map(|folder| root().join(folder));
    let mut pages: Vec<PathBuf> = folders.iter().flat_map(|folder| below(folder, "md")).collect();
    pages.extend(files(root()).into_iter().filter(|path| has_ending(path, "md")));
    let is_template = |path: &PathBuf| path.components().any(|part| part.as_os_str() == "templates");
    pages.retain(|path| !is_template(path));
    let mut pages: Vec<PathBuf> =
        pages.iter().map(|path| path.strip_prefix(root()).unwrap().to_owned()).collect();
    pages.sort();
    pages
}

fn files(folder: &Path) -> Vec<PathBuf> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect()
}

fn below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for path in files(folder) {
        if path.is_dir() && !path.ends_with("target") {
            found.extend(below(&path, ending));
        } else if has_ending(&path, ending) {
            found.push(path);
        }
    }
    found
}

fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|own| own == ending)
}

pub(crate) fn read(page: &Path) -> String {
    fs::read_to_string(root().join(page)).unwrap()
}

/// A page without what `cargo xtask docs` puts between its marks.
pub(crate) fn by_hand(page: &Path) -> String {
    let text = read(page);
    let mut kept = String::new();
    let mut rest = text.as_str();
    while let Some((before, behind)) = rest.split_once("<!-- end of ") {
        let mark = format!("<!-- {} -->", behind.split_once(" -->").map_or("", |(name, _)| name));
        kept.push_str(before.split_once(mark.as_str()).map_or(before, |(before, _)| before));
        rest = behind.split_once("-->").map_or("", |(_, rest)| rest);
    }
    kept + rest
}

/// What a page says in prose, a piece each with its line: no code.
fn prose(text: &str) -> Vec<(usize, String)> {
    let mut pieces = Vec::new();
    let mut in_block = false;
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(_)) => in_block = true,
            Event::End(TagEnd::CodeBlock) => in_block = false,
            Event::Text(piece) if !in_block => {
                pieces.push((text[..range.start].matches('\n').count() + 1, piece.into_string()));
            }
            _ => {}
        }
    }
    pieces
}

/// The blocks of a page: language (`text` if there is none), line and text.
fn blocks(text: &str) -> Vec<(String, usize, String)> {
    let mut blocks: Vec<(String, usize, String)> = Vec::new();
    let mut in_block = false;
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                let language = match &kind {
                    CodeBlockKind::Fenced(language) if !language.is_empty() => language,
                    _ => "text",
                };
                blocks.push((language.to_owned(), text[..range.start].lines().count() + 1, String::new()));
                in_block = true;
            }
            Event::End(TagEnd::CodeBlock) => in_block = false,
            Event::Text(piece) if in_block => blocks.last_mut().unwrap().2.push_str(&piece),
            _ => {}
        }
    }
    blocks
}

/// The links and pictures of a page with their lines.
fn links(text: &str) -> Vec<(usize, String)> {
    let events = Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter();
    let links = events.filter_map(|(event, range)| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
            Some((text[..range.start].matches('\n').count() + 1, dest_url.into_string()))
        }
        _ => None,
    });
    links.collect()
}

/// The anchors of a page's headings, made as GitHub and mdBook make them.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut anchors = BTreeSet::new();
    let mut times: HashMap<String, usize> = HashMap::new();
    let mut heading: Option<String> = None;
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::Text(piece) | Event::Code(piece) => heading.iter_mut().for_each(|text| *text += &piece),
            Event::End(TagEnd::Heading(_)) => {
                let name = heading.take().unwrap().to_lowercase().replace(' ', "-");
                let is_kept = |c: &char| c.is_alphanumeric() || "-_".contains(*c);
                let name: String = name.chars().filter(is_kept).collect();
                let time = times.entry(name.clone()).or_default();
                anchors.insert(if *time == 0 { name } else { format!("{name}-{time}") });
                *time += 1;
            }
            _ => {}
        }
    }
    anchors
}

/// A path without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => assert!(plain.pop(), "{} leaves the project", path.display()),
            Component::CurDir => {}
            part => plain.push(part),
        }
    }
    plain
}

/// Links without a scheme lead to a file or folder of the project, and their anchors to a heading in it. Pages of the site
/// link to pages of the site only.
#[test]
fn links_lead_somewhere() {
    let mut dead = Vec::new();
    let mut known: HashMap<PathBuf, BTreeSet<String>> = HashMap::new();
    for page in pages() {
        let text = read(&page);
        for (line, link) in links(&text) {
            if link.contains("://") || link.starts_with("mailto:") {
                continue;
            }
            let (path, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = match path {
                "" => page.clone(),
                path => plain(&page.parent().unwrap().join(path)),
            };
            let mut has_anchor = |target: &PathBuf| {
                let anchors = known.entry(target.clone()).or_insert_with(|| anchors(&read(target)));
                anchors.contains(anchor)
            };
            let is_alive = root().join(&target).exists()
                && (anchor.is_empty() || (has_ending(&target, "md") && has_anchor(&target)));
            let leaves_site = page.starts_with("docs") && !target.starts_with("docs");
            if !is_alive || leaves_site {
                dead.push(format!("{}:{line}: {link}", page.display()));
            }
        }
    }
    assert!(dead.is_empty(), "dead links, or links out of the site:\n{}", dead.join("\n"));
}

/// The pages of the site that a page links to.
fn linked_pages(page: &Path) -> BTreeSet<PathBuf> {
    let paths = links(&read(page)).into_iter().filter_map(|(_, link)| {
        let path = link.split('#').next().filter(|path| path.ends_with(".md"))?;
        Some(plain(&page.parent().unwrap().join(path)))
    });
    paths.collect()
}

/// `SUMMARY.md` lists every page of the site. Its top lines are all that the folded sidebar shows, so the home page links to each of
/// them, and each of them to the pages below it.
#[test]
fn the_site_has_every_page() {
    let summary = Path::new("docs/SUMMARY.md");
    let pages = pages().into_iter().filter(|page| page.starts_with("docs") && page != summary);
    assert_eq!(linked_pages(summary), pages.collect());
    let home = Path::new("docs/index.md");
    let mut above: Vec<(usize, PathBuf)> = Vec::new();
    let mut unlinked = Vec::new();
    let mut top_lines = 0;
    for line in read(summary).lines() {
        let Some((indent, link)) = line.split_once("- [") else { continue };
        let page = Path::new("docs").join(link.split_once("](").unwrap().1.trim_end_matches(')'));
        top_lines += usize::from(indent.is_empty());
        above.retain(|(outer, _)| *outer < indent.len());
        let parent = above.last().map_or(home, |(_, page)| page);
        if page != home && !linked_pages(parent).contains(&page) {
            unlinked.push(format!("{} lacks {}", parent.display(), page.display()));
        }
        above.push((indent.len(), page));
    }
    assert!(unlinked.is_empty(), "pages without a link from the page above:\n{}", unlinked.join("\n"));
    assert_eq!(top_lines, 12, "lines of the folded sidebar");
}

/// The main journeys: pages from the home page on, and what the last one shows as the first result.
const JOURNEYS: [(&[&str], &str); 3] = [
    (&["index.md", "install.md", "guides/generate.md"], "build/od.rs"),
    (&["index.md", "install.md", "guides/configure.md"], "node5.cdcf: "),
    (&["index.md", "install.md", "guides/check.md"], "error"),
];

/// A reader comes from the home page to a first result on at most three pages and with at most five commands, one of which installs objdict.
#[test]
fn first_results_are_near() {
    for (pages, result) in JOURNEYS {
        let pages: Vec<PathBuf> = pages.iter().map(|page| Path::new("docs").join(page)).collect();
        assert!(pages.len() <= 3);
        let (home, last) = (linked_pages(&pages[0]), pages.last().unwrap());
        assert!(pages[1..].iter().all(|page| home.contains(page)), "{pages:?}");
        let session: String = blocks(&read(last))
            .into_iter()
            .filter(|(language, ..)| language == "console")
            .map(|(.., text)| text)
            .collect();
        let (before, _) =
            session.split_once(result).unwrap_or_else(|| panic!("{}: no {result}", last.display()));
        let commands = before.lines().filter(|line| line.starts_with("$ ")).count();
        assert!((1..=4).contains(&commands), "{}: {commands} commands", last.display());
    }
}

#[test]
fn the_oldest_rust_is_the_one_that_the_gate_compiles_with() {
    let oldest = env!("CARGO_PKG_RUST_VERSION");
    assert!(read(Path::new("README.md")).contains(&format!("Rust {oldest} or newer")));
}

/// The words to avoid, and what is said instead: the table in CONTRIBUTING.md.
fn words_to_avoid() -> Vec<(String, String)> {
    let page = read(Path::new("CONTRIBUTING.md"));
    let table = page.split_once("| avoid | use |\n|---|---|\n").expect("the table").1;
    let rows = table.lines().take_while(|line| line.starts_with('|'));
    let words = rows.flat_map(|row| {
        let mut cells = row.trim_matches('|').split('|');
        let (avoided, used) = (cells.next().unwrap(), cells.next().unwrap().trim().to_owned());
        let words = avoided.split(',').map(|word| word.trim().trim_matches('`').to_lowercase());
        words.map(move |word| (word, used.clone())).collect::<Vec<_>>()
    });
    words.collect()
}

/// The first of the words to avoid that a text has as a word of its own.
fn avoided<'a>(text: &str, words: &'a [(String, String)]) -> Option<&'a (String, String)> {
    let text = text.to_lowercase();
    let is_letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
    words.iter().find(|(word, _)| {
        let mut places = text.match_indices(word.as_str());
        places.any(|(at, _)| {
            !is_letter(text[..at].chars().next_back()) && !is_letter(text[at + word.len()..].chars().next())
        })
    })
}

/// The pages of the project, without those of single crates.
fn prose_of_pages() -> Vec<Text> {
    let is_in_scope = |page: &PathBuf| {
        !page.starts_with("crates") && !MADE_OF_RULES.iter().any(|made| page.starts_with(made))
    };
    let texts = pages().into_iter().filter(is_in_scope).flat_map(|page| {
        let pieces = prose(&read(&page)).into_iter();
        pieces.map(move |(line, piece)| (format!("{}:{line}", page.display()), piece))
    });
    texts.collect()
}

/// The pages of the rules.
fn rules() -> Vec<Text> {
    let texts = objdict::registry::rules()
        .into_iter()
        .flat_map(|rule| prose(&rule.page()).into_iter().map(move |(_, piece)| (rule.id.to_owned(), piece)));
    texts.collect()
}

/// The findings of the bad fixtures of all rules, as their snapshots have them.
pub(crate) fn findings() -> Vec<Text> {
    let snapshots = files(&root().join("tests/library/snapshots/rules")).into_iter();
    let texts = snapshots.flat_map(|path| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let text = fs::read_to_string(path).unwrap();
        text.lines().flat_map(prose).map(|(_, piece)| (name.clone(), piece)).collect::<Vec<_>>()
    });
    texts.collect()
}

/// The comments of the library and the command, documentation included.
fn comments() -> Vec<Text> {
    let sources = ["src", "crates"].iter().flat_map(|folder| below(&root().join(folder), "rs"));
    let texts = sources.flat_map(|path| {
        let text = fs::read_to_string(&path).unwrap();
        let comment = |(number, line): (usize, &str)| {
            let comment = line.trim_start().strip_prefix("//")?;
            Some((format!("{}:{}", path.display(), number + 1), comment.to_owned()))
        };
        text.lines().enumerate().filter_map(comment).collect::<Vec<_>>()
    });
    texts.collect()
}

/// The help of all commands, as the manual pages have it.
pub(crate) fn help() -> Vec<Text> {
    let folder = tempfile::tempdir().unwrap();
    let status = Command::new(env!("CARGO_BIN_EXE_objdict")).arg("man").arg(folder.path()).status().unwrap();
    assert!(status.success());
    let texts = files(folder.path()).into_iter().flat_map(|path| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let text = fs::read_to_string(path).unwrap().replace('\\', "");
        text.lines().map(|line| (name.clone(), line.to_owned())).collect::<Vec<_>>()
    });
    texts.collect()
}

#[test]
fn the_words_are_those_of_engineers() {
    let words = words_to_avoid();
    assert!(words.len() > 30, "{words:?}");
    for texts in SCOPES {
        let found = texts().into_iter().filter_map(|(place, text)| {
            let (word, used) = avoided(&text, &words)?;
            Some(format!("{place}: `{word}`, say {used}: {text}"))
        });
        let found: Vec<String> = found.collect();
        assert!(found.is_empty(), "{} words to avoid:\n{}", found.len(), found.join("\n"));
    }
}

/// In the changelog a change is a line of at most 30 words, as Keep a Changelog has them.
#[test]
fn a_change_is_a_line() {
    let text = read(Path::new("CHANGELOG.md"));
    let (_, changes) = text.split_once("## [").unwrap();
    let changes: Vec<&str> = changes.lines().skip(1).filter(|line| !line.is_empty()).collect();
    assert!(changes.len() > 50, "{changes:?}");
    let is_heading = |line: &str| line.starts_with('#') || line.starts_with("The first release");
    for change in changes.into_iter().filter(|line| !is_heading(line)) {
        let words = change.strip_prefix("- ").map(|text| text.split_whitespace().count());
        assert!(words.is_some_and(|words| words <= 30), "{change}");
    }
}

/// The code in the tutorials is a piece of the examples, which are built and run.
#[test]
fn tutorials_show_code_of_the_examples() {
    let code: String = [
        "firmware-rust",
        "firmware-rust/src",
        "firmware-c",
        "node-rust",
        "node-rust/src",
        "node-rust/examples",
    ]
    .iter()
    .map(|folder| root().join("examples").join(folder))
    .chain(["examples", "crates/objdict-device/tests/device"].map(|folder| root().join(folder)))
    .flat_map(|folder| files(&folder))
    .filter_map(|path| fs::read_to_string(path).ok())
    .collect();
    for page in ["docs/tutorials/firmware-rust.md", "docs/tutorials/firmware-c.md", "docs/guides/runtime.md"]
    {
        let text = read(Path::new(page));
        let blocks: Vec<&str> = ["```rust,ignore\n", "```c\n", "```cmake\n", "```text\n"]
            .iter()
            .flat_map(|fence| text.split(fence).skip(1))
            .filter_map(|rest| rest.split("```").next())
            .collect();
        assert!(blocks.len() > 2, "{page}: {blocks:?}");
        for block in blocks {
            assert!(code.contains(block), "{page}: not in the examples:\n{block}");
        }
    }
}

/// What a build script without the feature `cli` prints about an error in the example, as Cargo indents it.
fn error_of_a_build_script() -> String {
    let name = "climate-sensor.eds";
    let eds = fs::read_to_string(root().join("examples").join(name)).unwrap();
    let eds = eds.replace("DefaultValue=600\n", "DefaultValue=60000\n");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, &eds).unwrap();
    let builder = Builder::new(&path).out_dir(folder.path()).no_config();
    let Err(Error::Findings { findings, noun, .. }) = builder.generate_to(&mut Vec::new()) else {
        panic!("no finding")
    };
    let description = format::read(SourceFile::from_text(name, &eds), Format::Eds);
    let mut report = Vec::new();
    Concise::new(&mut report).file((&description).into(), &findings).unwrap();
    let mut report = String::from_utf8(report).unwrap();
    assert_eq!(findings.len(), 1, "{report}");
    report += &format!("  help: {}\n", findings.iter().next().unwrap().help.as_ref().unwrap().shown());
    let printed = format!("Error: {:?}\n", Error::Findings { file: name.to_owned(), findings, noun, report });
    let lines = printed.lines().map(|line| format!("  {line}"));
    lines.map(|line| format!("{}\n", line.trim_end())).collect()
}

/// README.md and the site.
pub(crate) fn pages_for_users() -> impl Iterator<Item = PathBuf> {
    pages().into_iter().filter(|page| page.starts_with("docs") || page == Path::new("README.md"))
}

/// Sessions in `console` blocks are run; what a block of text shows is printed too, by the examples or a build script.
#[test]
fn blocks_of_text_are_printed() {
    let printed = [read(Path::new("examples/session.txt")), error_of_a_build_script()];
    let mut found = Vec::new();
    // what the script of docs/reference/json.md prints is compared where it is run (tests/command/recipes.rs)
    for page in pages_for_users().filter(|page| page != Path::new("docs/reference/json.md")) {
        for (_, line, text) in blocks(&read(&page)).into_iter().filter(|(language, ..)| language == "text") {
            found.push(page.display().to_string());
            assert!(
                printed.iter().any(|printed| printed.contains(&text)),
                "{}:{line}: neither of these prints it, make it a tested session (`console`):\n{text}\n{}",
                page.display(),
                printed.join("\n")
            );
        }
    }
    assert_eq!(found, ["docs/guides/cargo.md", "docs/tutorials/firmware-rust.md"]);
}

/// What prose has in backticks or quotation marks, and what blocks of JSON have as a message, with its line.
fn quotes(text: &str) -> Vec<(usize, String)> {
    let mut quotes = Vec::new();
    let mut in_block = false;
    let mut paragraph = String::new();
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        let line = text[..range.start].lines().count() + 1;
        match event {
            Event::Start(Tag::CodeBlock(_)) => in_block = true,
            Event::Code(piece) => {
                paragraph += &format!("`{piece}`");
                quotes.push((line, piece.into_string()));
            }
            Event::Text(piece) if !in_block => paragraph += &piece,
            Event::SoftBreak => paragraph.push(' '),
            Event::End(TagEnd::CodeBlock) => in_block = false,
            Event::End(TagEnd::Paragraph | TagEnd::TableCell | TagEnd::Item | TagEnd::Heading(_)) => {
                let paragraph = std::mem::take(&mut paragraph);
                quotes.extend(paragraph.split('"').skip(1).step_by(2).map(|quote| (line, quote.to_owned())));
            }
            _ => {}
        }
    }
    for (_, line, text) in blocks(text).into_iter().filter(|(language, ..)| language == "json") {
        let messages = text.split("\"message\":").skip(1).filter_map(|rest| rest.split('"').nth(1));
        quotes.extend(messages.map(|message| (line, message.to_owned())));
    }
    quotes
}

/// The runs of words of a message that a source has as they are: behind and before numbers, quoted text and names of files.
/// `None` if the text is code, or too short for a sentence.
fn runs_of_words(quote: &str) -> Option<Vec<String>> {
    const PROGRAMS: [&str; 7] = ["objdict", "cargo", "ip", "chromium", "pip", "network", "dcfgen"];
    let words: Vec<&str> = quote.split_whitespace().collect();
    let is_word = |word: &str| {
        word.trim_end_matches([',', ':', ';']).chars().all(|c| c.is_ascii_lowercase() || c == '-')
    };
    let is_sentence = words.len() > 3
        && words.iter().filter(|word| is_word(word)).count() > 1
        && !PROGRAMS.contains(&words[0])
        && !words.iter().any(|word| word.starts_with('-') || word.contains(['=', '{', '(', '*', '<']));
    let runs = words.split(|word| !is_word(word)).filter(|run| run.len() > 1).map(|run| run.join(" "));
    let runs: Vec<String> = runs.collect();
    (is_sentence && !runs.is_empty()).then_some(runs)
}

/// A message that a page quotes is one of the program: the sources or the expected outputs have a line with its words.
#[test]
fn messages_that_pages_quote_exist() {
    let folders = [("src", "rs"), ("crates", "rs"), ("tests", "snap"), ("tests/cli", "md")];
    let files = folders.iter().flat_map(|(folder, ending)| below(&root().join(folder), ending));
    let mut lines: Vec<String> = Vec::new();
    for path in files {
        // a literal may continue in the next line
        let text = fs::read_to_string(path).unwrap().replace("\\\n", "\u{0}");
        let is_comment = |line: &&str| line.trim_start().starts_with("//");
        let joined = text.lines().filter(|line| !is_comment(line));
        lines.extend(joined.map(|line| line.split('\u{0}').map(str::trim_start).collect()));
    }
    let mut unknown = Vec::new();
    let mut known = 0;
    for page in pages_for_users() {
        for (line, quote) in quotes(&read(&page)) {
            let Some(runs) = runs_of_words(&quote) else { continue };
            match lines.iter().any(|line| runs.iter().all(|run| line.contains(run))) {
                true => known += 1,
                false => unknown.push(format!("{}:{line}: {quote}", page.display())),
            }
        }
    }
    assert!(unknown.is_empty() && known > 0, "not in the sources:\n{}", unknown.join("\n"));
}

/// What pages state of the size and the time of the program, and the test that fails when it is wrong.
const MEASURED: [(&str, &str, &str); 5] = [
    ("at most 20 times its size and 50 MB of memory", "tests/memory/main.rs", "20 * usage.text + 50_000_000"),
    ("at most 1750 bytes of flash", "tests/generate/stacks/figures.rs", "plain.flash <= 1_750"),
    ("takes at most 9,000 bytes of flash", "tests/generate/node_size.rs", "const MINIMAL: usize = 9_000;"),
    ("takes at most 3 KiB", "tests/generate/thumb.rs", "const MOST: usize = 3 * 1024;"),
    ("needs more than 12 crates", ".ci/run", "\"$crates\" -le 12"),
];

/// Sizes and times that no test compares with the program become wrong unnoticed.
#[test]
fn sizes_and_times_are_tested() {
    for (_, test, limit) in MEASURED {
        assert!(read(Path::new(test)).contains(limit), "{test} does not test `{limit}`");
    }
    let units = ["KB", "MB of", "bytes of flash", "bytes of RAM", "bytes of code", "instructions", "crates"];
    let times = ["minutes on", "seconds on", "minutes of", "seconds of", "times faster"];
    let mut untested = Vec::new();
    for page in pages_for_users().filter(|page| !MADE_OF_RULES.iter().any(|made| page.starts_with(made))) {
        for (line, piece) in prose(&by_hand(&page)) {
            let has_number = piece.contains(|c: char| c.is_ascii_digit());
            let is_size = units.iter().any(|unit| piece.contains(unit)) && has_number;
            let is_measured = MEASURED.iter().any(|(stated, ..)| piece.contains(stated));
            if (is_size || times.iter().any(|time| piece.contains(time))) && !is_measured {
                untested.push(format!("{}:{line}: {piece}", page.display()));
            }
        }
    }
    assert!(untested.is_empty(), "no test is known for:\n{}", untested.join("\n"));
}

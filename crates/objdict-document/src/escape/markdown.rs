//! Markdown as forges render it: CommonMark with the tables of GitHub, and what forges do to the text afterwards.
//!
//! A text is the same in a table cell, a heading, a list and a paragraph, so one way of writing serves all. What can be markup for
//! a parser has a backslash or is a character reference; what forges look for in rendered text (`@user`, `:smile:`, `$x$`, links
//! without brackets, `[[page]]`) has its sign in a `<span>` of its own, for there a backslash is gone already. The rest stays as it
//! is: names and numbers are to be readable in the file, too.

use std::fmt;

use askama::filters::Escaper;

use super::shown;

/// What `.md` templates write texts with. A text is to be given in one piece, for how a character is written depends on its
/// neighbours; where a piece begins or ends it is on the safe side.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Markdown;

impl Escaper for Markdown {
    fn write_escaped_str<W: fmt::Write>(&self, mut dest: W, text: &str) -> fmt::Result {
        for (at, character) in text.char_indices() {
            let (before, after) = (&text[..at], &text[at + character.len_utf8()..]);
            let Some(character) = shown(character, after.chars().next()) else { continue };
            match spelling(before, character, after) {
                Spelling::Itself => dest.write_char(character)?,
                Spelling::Backslash => write!(dest, "\\{character}")?,
                Spelling::Reference => write!(dest, "&#{};", u32::from(character))?,
                Spelling::Alone => write!(dest, "<span>{character}</span>")?,
                Spelling::Markup(text) => dest.write_str(text)?,
            }
        }
        Ok(())
    }
}

/// A text as `.md` templates write it.
pub(super) fn escaped(text: &str) -> String {
    let mut written = String::with_capacity(text.len() + 8);
    let _ = Markdown.write_escaped_str(&mut written, text); // a String takes every text
    written
}

/// A sentence with formulas such as `$NODEID+0x180`, which are code.
pub(super) fn worded(text: &str) -> String {
    const NODE_ID: &str = "$NODEID";
    let mut written = String::with_capacity(text.len() + 8);
    let mut rest = text;
    while let Some(start) = rest.find(NODE_ID) {
        let is_sum = |character: char| character.is_ascii_alphanumeric() || character == '+';
        let end =
            rest[start + 1..].find(|character| !is_sum(character)).map_or(rest.len(), |end| start + 1 + end);
        written.push_str(&beside_code(&rest[..start], !written.is_empty(), true));
        written.push_str(&code(&rest[start..end]));
        rest = &rest[end..];
    }
    let has_before = !written.is_empty();
    written + &beside_code(rest, has_before, false)
}

/// A sentence that quotes between backticks, as findings do: what is quoted is code. Where one backtick has no other, none quotes.
pub(super) fn quoting(text: &str) -> String {
    let parts: Vec<&str> = text.split('`').collect();
    if parts.len().is_multiple_of(2) {
        return escaped(text);
    }
    let last = parts.len() - 1;
    let written = parts.iter().enumerate().map(|(number, part)| match number % 2 {
        0 => beside_code(part, number > 0, number < last),
        _ => code(part),
    });
    written.collect()
}

/// A part of a sentence, with blanks as they are where code stands beside them.
fn beside_code(part: &str, has_before: bool, has_after: bool) -> String {
    let start = if has_before { part.len() - part.trim_start_matches(' ').len() } else { 0 };
    let end = if has_after { part.trim_end_matches(' ').len() } else { part.len() };
    match part.get(start..end) {
        Some(inner) if !inner.is_empty() => format!("{}{}{}", &part[..start], escaped(inner), &part[end..]),
        _ if has_before && has_after => part.to_owned(),
        _ => escaped(part),
    }
}

/// A text as code: between backticks, where nothing but a backtick ends it. A cell ends at `|` even there, and generators of sites
/// expand `{{` everywhere, so what has one of these is an element with an escaped text.
pub(crate) fn code(text: &str) -> String {
    let awkward = |character: char| {
        matches!(character, '`' | '|' | '{' | '\\') || shown(character, None) != Some(character)
    };
    let blank =
        text.is_empty() || text.starts_with(char::is_whitespace) || text.ends_with(char::is_whitespace);
    if !blank && !text.contains(awkward) && !text.contains('\n') {
        return format!("`{text}`");
    }
    format!("<code>{}</code>", escaped(text))
}

enum Spelling {
    Itself,
    Backslash,
    Reference,
    /// In an element of its own.
    Alone,
    Markup(&'static str),
}

fn spelling(before: &str, character: char, after: &str) -> Spelling {
    let (previous, next) = (before.chars().next_back(), after.chars().next());
    let starts = before.trim_start_matches('\r').is_empty();
    let word = |neighbour: Option<char>| neighbour.is_some_and(char::is_alphanumeric);
    // what comes behind the text is not known
    let next_is = |wanted: fn(char) -> bool| next.is_none_or(wanted);
    let backslash = match character {
        // a tag alone in a line would be a block of HTML
        '\n' if starts => return Spelling::Markup("<span></span><br>"),
        '\n' => return Spelling::Markup("<br>"),
        '<' => return Spelling::Markup("&lt;"),
        '|' | '{' => return Spelling::Reference,
        // some look for `$x$` in the file, some in what became of it
        '$' => return Spelling::Markup("<span>&#36;</span>"),
        '@' if next_is(|next| !next.is_whitespace()) => return Spelling::Alone,
        ':' if after.starts_with("//") || is_emoji(after) => return Spelling::Alone,
        '.' if ends_with_www(before) => return Spelling::Alone,
        '[' if next == Some('[') => return Spelling::Markup("<span>\\[</span>"),
        _ if character.is_whitespace() && (starts || next.is_none()) => return Spelling::Reference,
        '\\' | '`' | '*' | '~' | '[' | ']' => true,
        '_' => !(word(previous) && word(next)),
        '&' => next_is(|next| next.is_alphanumeric() || next == '#'),
        '!' => next_is(|next| next == '[' || next.is_ascii_digit()),
        '%' => next.is_some_and(char::is_alphanumeric),
        '#' => starts || next_is(|next| next.is_ascii_digit()),
        '>' | '=' | ':' => starts,
        '-' | '+' => starts && next_is(|next| matches!(next, '-' | '+') || next.is_whitespace()),
        '.' | ')' => is_list_number(before) && next_is(char::is_whitespace),
        _ => false,
    };
    if backslash { Spelling::Backslash } else { Spelling::Itself }
}

/// Whether a text behind a colon makes a picture of it: `smile:`, `+1:`, but not the minutes of a time.
fn is_emoji(after: &str) -> bool {
    let in_name = |character: char| character.is_ascii_alphanumeric() || matches!(character, '_' | '+' | '-');
    let name = &after[..after.len() - after.trim_start_matches(in_name).len()];
    let is_number = name.bytes().all(|byte| byte.is_ascii_digit()) && name != "100" && name != "1234";
    !is_number && after[name.len()..].starts_with(':')
}

/// Whether a dot behind the text begins a link without a scheme.
fn ends_with_www(before: &str) -> bool {
    let scheme = before.len().checked_sub(3).and_then(|start| before.get(start..));
    scheme.is_some_and(|scheme| scheme.eq_ignore_ascii_case("www"))
}

/// Whether a dot behind the text would make an item of a list of it.
fn is_list_number(before: &str) -> bool {
    (1..=9).contains(&before.len()) && before.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use pulldown_cmark::{Event, Options, Parser, Tag};

    use super::super::tests::text_of;
    use super::*;

    #[test]
    fn what_is_no_markup_stays_as_it_is() {
        for text in [
            "COB-ID used by RPDO 1",
            "device_name",
            "0x6000",
            "-5",
            "+1.5",
            "1.5",
            "m/s^2",
            "50 %",
            "a & b",
            "x > 3",
            "Bits 0..3: mode (\"fast\")",
            "a, b; c",
            "state: on",
            "12:30:45",
            "Größe 速度",
            "<",
            "a - b",
            "Stop! Go",
        ] {
            let readable = text.replace('<', "&lt;");
            assert_eq!(escaped(text), readable);
        }
    }

    #[test]
    fn what_could_be_markup_is_marked() {
        for (text, written) in [
            ("<script>", "&lt;script>"),
            ("a|b", "a&#124;b"),
            ("]](x)", "\\]\\](x)"),
            ("`a`", "\\`a\\`"),
            ("_a_ b_c", "\\_a\\_ b_c"),
            ("# 1", "\\# 1"),
            ("Module #1", "Module \\#1"),
            ("- 1", "\\- 1"),
            ("1. x", "1\\. x"),
            ("&lt; &", "\\&lt; \\&"),
            ("$a$", "<span>&#36;</span>a<span>&#36;</span>"),
            ("http://a.b www.a.b", "http<span>:</span>//a.b www<span>.</span>a.b"),
            (":smile: @you", "<span>:</span>smile: <span>@</span>you"),
            ("[[page]]", "<span>\\[</span>\\[page\\]\\]"),
            ("{{ x }}", "&#123;&#123; x }}"),
            ("a\r\nb\0", "a<br>b\u{FFFD}"),
        ] {
            assert_eq!(escaped(text), written);
        }
    }

    #[test]
    fn code_is_between_backticks_where_that_is_safe() {
        assert_eq!(code("$NODEID+0x180"), "`$NODEID+0x180`");
        assert_eq!(code("a`b"), "<code>a\\`b</code>");
        assert_eq!(code("a|b"), "<code>a&#124;b</code>");
        assert_eq!(code("{{ x }}"), "<code>&#123;&#123; x }}</code>");
        assert_eq!(code(" "), "<code>&#32;</code>");
    }

    #[test]
    fn formulas_in_sentences_are_code() {
        assert_eq!(worded("CAN-ID $NODEID+0x80, 11 bits"), "CAN-ID `$NODEID+0x80`, 11 bits");
        assert_eq!(quoting("`300` does not fit `a|b`!"), "`300` does not fit <code>a&#124;b</code>\\!");
        assert_eq!(quoting("a ` b"), "a \\` b");
        assert_eq!(worded("a*b $x"), "a\\*b <span>&#36;</span>x");
    }

    /// The text that a reader of Markdown sees, and what it is in: the tags without texts.
    fn read(page: &str) -> (String, Vec<String>) {
        let options = Options::ENABLE_TABLES
            | Options::ENABLE_FOOTNOTES
            | Options::ENABLE_STRIKETHROUGH
            | Options::ENABLE_TASKLISTS
            | Options::ENABLE_HEADING_ATTRIBUTES
            | Options::ENABLE_MATH
            | Options::ENABLE_GFM
            | Options::ENABLE_WIKILINKS
            | Options::ENABLE_DEFINITION_LIST;
        let (mut text, mut tags) = (String::new(), Vec::new());
        for event in Parser::new_ext(page, options) {
            match event {
                Event::Text(part) | Event::Code(part) => text.push_str(&part),
                Event::InlineHtml(html) if &*html == "<br>" => text.push('\n'),
                Event::InlineHtml(html) if ["<span>", "</span>", "<code>", "</code>"].contains(&&*html) => {}
                Event::Start(Tag::Link { dest_url, .. }) => tags.push(format!("link to {dest_url}")),
                Event::Start(tag) => tags.push(format!("{tag:?}")),
                Event::End(_) => {}
                other => tags.push(format!("{other:?}")),
            }
        }
        (text, tags)
    }

    const PLACES: [&str; 7] = [
        "| @ | b |\n| --- | --- |\n",
        "| a | b |\n| --- | --- |\n| @ | |\n",
        "| a | b |\n| --- | --- |\n| | [@](#6000) |\n",
        "# @\n",
        "@\n",
        "* @\n",
        "**@** (@)\n",
    ];

    /// Each place has the texts that it has with a harmless text, and no other tags.
    fn stays_text(text: &str, written: &str) -> Result<(), TestCaseError> {
        for place in PLACES {
            let (frame, tags) = read(&place.replace('@', "harmless"));
            let page = place.replace('@', written);
            let (seen, seen_tags) = read(&page);
            prop_assert_eq!(&seen_tags, &tags, "{:?}", page);
            prop_assert_eq!(&seen, &frame.replace("harmless", &text_of(text)), "{:?}", page);
        }
        Ok(())
    }

    fn hostile() -> impl Strategy<Value = String> {
        let piece = prop_oneof![
            "[a-zA-Z0-9 ]{1,3}",
            "[!-/:-@\\[-`{-~]",
            prop::sample::select(vec![
                "**",
                "__",
                "~~",
                "``",
                "```",
                "[x](y)",
                "](",
                "]]",
                "[[",
                "![",
                "<b>",
                "</td>",
                "<!--",
                "-->",
                "&lt;",
                "&#1;",
                "\\",
                "\\|",
                "|",
                "\n",
                "\r\n",
                "\t",
                "  ",
                "---",
                "===",
                "1. ",
                "- ",
                "# ",
                "> ",
                "[^1]",
                "[ ] ",
                "$",
                "$$",
                "{{",
                "http://a.b",
                "www.a.b",
                "a@b.c",
                "<http://a>",
                ":smile:",
                "#12",
                "\0",
                "\u{202E}",
                "ä",
                "[x]: y",
                "{#id}",
                "`",
            ])
            .prop_map(str::to_owned),
        ];
        prop::collection::vec(piece, 1..8).prop_map(|pieces| pieces.concat())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn any_text_comes_back(text in "(?s).{1,30}") {
            stays_text(&text, &escaped(&text))?;
        }

        #[test]
        fn markup_comes_back(text in hostile()) {
            stays_text(&text, &escaped(&text))?;
        }

        #[test]
        fn sentences_come_back(text in hostile(), other in hostile()) {
            let text = format!("{text}$NODEID+0x180{other}");
            stays_text(&text, &worded(&text))?;
            let text = format!("{} `{}` {}", text.replace('`', ""), other.replace('`', ""), text.replace('`', ""));
            stays_text(&text.replace('`', ""), &quoting(&text))?;
        }

        #[test]
        fn code_comes_back(text in hostile()) {
            stays_text(&text, &code(&text))?;
        }
    }
}

//! Escaping for Markdown on GitHub, GitLab and the like: CommonMark, GitHub tables, and the post-processing
//! of these sites.
//!
//! The same escaping works in table cells, headings, lists and paragraphs. Possible markup gets a backslash
//! or becomes a character reference. Post-processing works on the rendered text, where backslashes are
//! already removed (`@user`, `:smile:`, `$x$`, links without brackets, `[[page]]`), so its special characters
//! get a separate `<span>`. Everything else is unchanged, because names and numbers must also be readable in
//! the source.

use std::fmt;

use askama::filters::Escaper;

use super::shown;
use crate::diagnostic::printable;

/// The escaper of `.md` templates. Pass each text in one piece, because the escaping of a character
/// depends on adjacent ones. At the start and end of a piece the escaper assumes the worst case.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Markdown;

impl Escaper for Markdown {
    fn write_escaped_str<W: fmt::Write>(&self, mut dest: W, text: &str) -> fmt::Result {
        for (at, character) in text.char_indices() {
            let (before, after) = (&text[..at], &text[at + character.len_utf8()..]);
            let Some(character) = shown(character, after.chars().next()) else { continue };
            match spelling(before, character, after) {
                MarkdownSpelling::Itself => dest.write_char(character)?,
                MarkdownSpelling::Backslash => write!(dest, "\\{character}")?,
                MarkdownSpelling::Reference => write!(dest, "&#{};", u32::from(character))?,
                MarkdownSpelling::Alone => write!(dest, "<span>{character}</span>")?,
                MarkdownSpelling::Markup(text) => dest.write_str(text)?,
            }
        }
        Ok(())
    }
}

/// Escapes a text like `.md` templates.
pub(super) fn escaped(text: &str) -> String {
    let mut written = String::with_capacity(text.len() + 8);
    let _ = Markdown.write_escaped_str(&mut written, text); // writing to a String cannot fail
    written
}

/// Escapes a sentence; formulas such as `$NODEID+0x180` become code.
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

/// Escapes a sentence with quotes in backticks, such as a finding; quoted text becomes code. An unpaired
/// backtick quotes nothing.
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

/// Escapes a part of a sentence and preserves spaces next to code.
fn beside_code(part: &str, has_before: bool, has_after: bool) -> String {
    let start = if has_before { part.len() - part.trim_start_matches(' ').len() } else { 0 };
    let end = if has_after { part.trim_end_matches(' ').len() } else { part.len() };
    match part.get(start..end) {
        Some(inner) if !inner.is_empty() => format!("{}{}{}", &part[..start], escaped(inner), &part[end..]),
        _ if has_before && has_after => part.to_owned(),
        _ => escaped(part),
    }
}

/// Formats a text as code in backticks. `|` ends a table cell even in code, and site generators expand `{{`
/// everywhere, so texts with these become an element with escaped text.
pub(crate) fn code(text: &str) -> String {
    let awkward = |character: char| {
        matches!(character, '`' | '|' | '{' | '\\') || shown(character, None) != Some(character)
    };
    let blank =
        text.is_empty() || text.starts_with(char::is_whitespace) || text.ends_with(char::is_whitespace);
    // commands to a CI service must be escaped, which is impossible in code
    let is_awkward = text.contains(awkward) || printable(text) != text;
    if !blank && !is_awkward {
        return format!("`{text}`");
    }
    format!("<code>{}</code>", escaped(text))
}

enum MarkdownSpelling {
    Itself,
    Backslash,
    Reference,
    /// As an element.
    Alone,
    Markup(&'static str),
}

fn spelling(before: &str, character: char, after: &str) -> MarkdownSpelling {
    let (previous, next) = (before.chars().next_back(), after.chars().next());
    let starts = before.trim_start_matches('\r').is_empty();
    let word = |neighbour: Option<char>| neighbour.is_some_and(char::is_alphanumeric);
    // unknown text may follow
    let next_is = |wanted: fn(char) -> bool| next.is_none_or(wanted);
    let backslash = match character {
        // a tag on its own line would start an HTML block
        '\n' if starts => return MarkdownSpelling::Markup("<span></span><br>"),
        '\n' => return MarkdownSpelling::Markup("<br>"),
        '<' => return MarkdownSpelling::Markup("&lt;"),
        '|' | '{' => return MarkdownSpelling::Reference,
        // some renderers search the source for `$x$`, others the rendered text
        '$' => return MarkdownSpelling::Markup("<span>&#36;</span>"),
        '@' if next_is(|next| !next.is_whitespace()) => return MarkdownSpelling::Alone,
        ':' if after.starts_with("//") || is_emoji(after) => return MarkdownSpelling::Alone,
        '.' if ends_with_www(before) => return MarkdownSpelling::Alone,
        '[' if next == Some('[') => return MarkdownSpelling::Markup("<span>\\[</span>"),
        _ if character.is_whitespace() && (starts || next.is_none()) => return MarkdownSpelling::Reference,
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
    if backslash { MarkdownSpelling::Backslash } else { MarkdownSpelling::Itself }
}

/// Whether the text after a colon makes it an emoji: `smile:`, `+1:`, but not the minutes of a time.
fn is_emoji(after: &str) -> bool {
    let in_name = |character: char| character.is_ascii_alphanumeric() || matches!(character, '_' | '+' | '-');
    let name = &after[..after.len() - after.trim_start_matches(in_name).len()];
    let is_number = name.bytes().all(|byte| byte.is_ascii_digit()) && name != "100" && name != "1234";
    !is_number && after[name.len()..].starts_with(':')
}

/// Whether a dot after the text starts a link without a scheme.
fn ends_with_www(before: &str) -> bool {
    let scheme = before.len().checked_sub(3).and_then(|start| before.get(start..));
    scheme.is_some_and(|scheme| scheme.eq_ignore_ascii_case("www"))
}

/// Whether a dot after the text makes it a list item.
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

    /// The rendered text, and the tags without text around it.
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

    /// Checks that a text renders with the same tags as a harmless text.
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

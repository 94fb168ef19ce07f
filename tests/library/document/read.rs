//! What readers see of documentation: the texts of an HTML page, of Markdown as a forge renders it, and of CSV.

use pulldown_cmark::{Event, Options, Parser, Tag};

use crate::support::RULE_PAGES;

/// The text of a page, with line feeds between elements. Every tag must be one that the templates write; the contents of `<style>` and
/// `<script>` are left out.
pub(crate) fn html(page: &str) -> String {
    let mut text = String::new();
    let mut rest = page;
    while let Some(start) = rest.find('<') {
        text.push_str(&resolved(&rest[..start]));
        text.push('\n');
        let tag = Element::read(&rest[start..]);
        for attribute in &tag.attributes {
            text.push_str(attribute);
            text.push('\n');
        }
        rest = &rest[start + tag.length..];
        if ["style", "script"].contains(&tag.name.as_str()) {
            let end = format!("</{}>", tag.name);
            let (contents, after) = rest.split_once(&end).expect("the element ends");
            assert!(!contents.contains("<script") && !contents.contains("<style"), "{contents}");
            rest = after;
        }
    }
    assert_eq!(rest.trim(), "", "the page ends with its element");
    text
}

/// A start or end tag.
struct Element {
    name: String,
    /// The values of attributes that may be texts of a description.
    attributes: Vec<String>,
    length: usize,
}

/// The elements that the templates write.
const ELEMENTS: [&str; 53] = [
    "!DOCTYPE",
    "a",
    "b",
    "body",
    "br",
    "button",
    "circle",
    "code",
    "dd",
    "defs",
    "details",
    "div",
    "dl",
    "dt",
    "em",
    "figcaption",
    "figure",
    "footer",
    "g",
    "h1",
    "h2",
    "h3",
    "h4",
    "h5",
    "head",
    "header",
    "html",
    "input",
    "label",
    "li",
    "line",
    "main",
    "meta",
    "nav",
    "ol",
    "output",
    "p",
    "path",
    "pattern",
    "pre",
    "rect",
    "script",
    "section",
    "small",
    "span",
    "style",
    "summary",
    "svg",
    "table",
    "tbody",
    "text",
    "title",
    "ul",
];
const FURTHER: [&str; 11] =
    ["article", "desc", "td", "th", "thead", "tr", "tspan", "use", "caption", "strong", "col"];

impl Element {
    fn read(page: &str) -> Self {
        let name: String = page[1..]
            .trim_start_matches('/')
            .chars()
            .take_while(|c| c.is_ascii_alphanumeric() || *c == '!')
            .collect();
        assert!(
            ELEMENTS.iter().chain(&FURTHER).any(|known| *known == name),
            "<{name}> of {:?}",
            &page[..page.len().min(80)]
        );
        let (mut quoted, mut length, mut value) = (None, 0, String::new());
        let mut attributes = Vec::new();
        let mut key = String::new();
        for (at, character) in page.char_indices() {
            match (quoted, character) {
                (None, '>') => {
                    length = at + 1;
                    break;
                }
                (None, '"') => (quoted, value) = (Some('"'), String::new()),
                (Some('"'), '"') => {
                    quoted = None;
                    attributes.push(resolved(&value));
                    assert!(!key.trim().starts_with("on"), "{key}");
                    key.clear();
                }
                (Some(_), _) => value.push(character),
                (None, '\'') => panic!("attributes have double quotes: {:?}", &page[..at]),
                (None, _) => key.push(character),
            }
        }
        assert!(length > 0, "the tag ends");
        Self { name, attributes, length }
    }
}

/// A text with its character references resolved.
fn resolved(text: &str) -> String {
    let mut parts = text.split('&');
    let mut resolved = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, after) = part.split_once(';').unwrap_or_else(|| panic!("& in {part:?}"));
        resolved.push_str(match name {
            "amp" => "&",
            "lt" => "<",
            "gt" => ">",
            "quot" => "\"",
            "#34" => "\"",
            "#38" => "&",
            "#39" => "'",
            "#60" => "<",
            "#62" => ">",
            "nbsp" | "#160" => "\u{A0}",
            _ => panic!("&{name};"),
        });
        resolved.push_str(after);
    }
    assert!(!resolved.contains('\0'));
    resolved
}

/// The text of Markdown as forges render it, with line feeds between blocks and cells. Links lead to the page itself or to a file
/// beside it; HTML is what the templates write.
pub(crate) fn markdown(page: &str) -> String {
    let mut text = String::new();
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_MATH
        | Options::ENABLE_GFM;
    for event in Parser::new_ext(page, options) {
        match event {
            Event::Text(part) | Event::Code(part) => text.push_str(&part),
            Event::InlineHtml(tag) if &*tag == "<br>" => text.push('\n'),
            Event::InlineHtml(tag) => assert!(
                ["<span>", "</span>", "<code>", "</code>", "</a>"].contains(&&*tag)
                    || tag.starts_with("<a id=\""),
                "{tag}"
            ),
            Event::Html(block) => text.push_str(&html(&block)),
            Event::Start(Tag::Link { dest_url, .. }) => {
                let leads_out = dest_url.contains(':') || dest_url.starts_with('/');
                assert!(!leads_out || dest_url.starts_with(RULE_PAGES), "{dest_url}");
            }
            Event::Start(Tag::Image { dest_url, .. }) => {
                let picture = dest_url.strip_prefix("network-").and_then(|name| name.strip_suffix(".svg"));
                assert!(picture.is_some_and(|number| number.parse::<u32>().is_ok()), "{dest_url}");
            }
            Event::Start(
                Tag::FootnoteDefinition(_) | Tag::Strikethrough | Tag::CodeBlock(_) | Tag::BlockQuote(_),
            )
            | Event::FootnoteReference(_)
            | Event::InlineMath(_)
            | Event::DisplayMath(_)
            | Event::TaskListMarker(_) => {
                panic!("{event:?} behind {:?}", &text[text.len().saturating_sub(60)..])
            }
            Event::Start(Tag::Emphasis | Tag::Strong | Tag::HtmlBlock)
            | Event::SoftBreak
            | Event::HardBreak => {}
            Event::Start(_) | Event::Rule => text.push('\n'),
            Event::End(_) => {}
        }
    }
    text
}

/// The lines of CSV after RFC 4180, each as its fields.
pub(crate) fn csv(text: &str) -> Vec<Vec<String>> {
    let text = text.strip_prefix('\u{FEFF}').expect("a byte order mark");
    let (mut lines, mut line, mut field, mut is_quoted) = (Vec::new(), Vec::new(), String::new(), false);
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '"' if is_quoted && characters.peek() == Some(&'"') => field.extend(characters.next()),
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => line.push(std::mem::take(&mut field)),
            '\r' if !is_quoted => {
                assert_eq!(characters.next(), Some('\n'));
                line.push(std::mem::take(&mut field));
                lines.push(std::mem::take(&mut line));
            }
            _ => field.push(character),
        }
    }
    assert!(field.is_empty() && line.is_empty() && !is_quoted, "the text ends with a line end");
    lines
}

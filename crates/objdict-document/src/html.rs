//! HTML output: a self-contained page, restricted to its own scripts and styles (Content Security Policy Level 3, W3C).

use super::card::Card;
use super::escape::filters;
use super::page::Page;
use askama::Template;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use hmac_sha256::Hash;
use memchr::memmem;

#[derive(Template)]
#[template(path = "html/page.html")]
struct HtmlPage<'a> {
    page: &'a Page<'a>,
}

#[derive(Template)]
#[template(path = "html/card.html")]
struct CardTemplate<'a> {
    card: &'a Card,
}

/// Writes only the card, for including in a different page.
pub(super) fn write_card(card: &Card) -> String {
    rendered(&CardTemplate { card }, 0)
}

/// Writes the page as HTML.
pub(super) fn write(page: &Page<'_>) -> String {
    // approximate size per entry, to avoid reallocation
    with_policy(rendered(&HtmlPage { page }, 40_000 + 500 * page.entry_count()))
}

/// Renders a template into a buffer of an initial size.
pub(crate) fn rendered(template: &impl Template, room: usize) -> String {
    let mut text = String::with_capacity(room);
    // writing to a String cannot fail, nor do the template filters
    let _ = template.render_into(&mut text);
    text
}

/// The policy is inserted after this; it does not apply to preceding content.
const HEAD: &str = "<meta charset=\"utf-8\">\n";

/// Adds the policy that allows the scripts and styles in a page, by their hashes. Texts of a description are escaped,
/// so none of them starts an element.
pub(crate) fn with_policy(mut page: String) -> String {
    let Some(head) = page.find(HEAD) else { return page };
    let (styles, scripts) = (sources(&page, "<style>", "</style>"), sources(&page, "<script>", "</script>"));
    let policy = format!(
        "default-src 'none'; style-src{styles}; script-src{scripts}; base-uri 'none'; form-action 'none'"
    );
    let element = format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n");
    page.insert_str(head + HEAD.len(), &element);
    page
}

/// The sources that a directive allows: the content of each element.
fn sources(page: &str, start: &str, end: &str) -> String {
    let starts = memmem::find_iter(page.as_bytes(), start);
    let contents = starts.filter_map(|at| Some(page[at + start.len()..].split_once(end)?.0));
    let hashes: Vec<String> = contents
        .map(|content| format!(" 'sha256-{}'", STANDARD.encode(Hash::hash(content.as_bytes()))))
        .collect();
    if hashes.is_empty() { " 'none'".to_owned() } else { hashes.concat() }
}

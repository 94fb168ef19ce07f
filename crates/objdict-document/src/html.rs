//! HTML output: a self-contained page.

use askama::Template;

use super::card::Card;
use super::escape::filters;
use super::page::Page;
use super::policy::with_policy;

#[derive(Template)]
#[template(path = "html/page.html")]
struct HtmlPage<'a> {
    page: &'a Page<'a>,
    version: &'static str,
}

#[derive(Template)]
#[template(path = "html/card.html")]
struct CardTemplate<'a> {
    card: &'a Card,
}

/// Writes the card alone, for a place in a page of others.
pub(super) fn write_card(card: &Card) -> String {
    let mut text = String::new();
    // as below
    let _ = CardTemplate { card }.render_into(&mut text);
    text
}

/// Writes the page as HTML.
pub(super) fn write(page: &Page<'_>) -> String {
    let template = HtmlPage { page, version: env!("CARGO_PKG_VERSION") };
    // approximate size per entry, to avoid reallocation
    let mut text = String::with_capacity(40_000 + 500 * page.entry_count());
    // writing to a String cannot fail, nor do the template filters
    let _ = template.render_into(&mut text);
    with_policy(text)
}

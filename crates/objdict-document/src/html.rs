//! A page of HTML that needs nothing beside it.

use askama::Template;

use super::page::Page;

#[derive(Template)]
#[template(path = "html/page.html")]
struct PageTemplate<'a> {
    page: &'a Page<'a>,
    version: &'static str,
}

/// The page as HTML.
pub(super) fn write(page: &Page<'_>) -> String {
    let template = PageTemplate { page, version: env!("CARGO_PKG_VERSION") };
    // about what an entry takes, so that the text is not moved while it grows
    let mut text = String::with_capacity(40_000 + 500 * page.entry_count());
    // a String takes every text, and no filter of the templates fails
    let _ = template.render_into(&mut text);
    text
}

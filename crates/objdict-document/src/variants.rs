//! The variants of a device beside each other, as a page.

use askama::Template;

use super::escape::filters;
use super::policy::with_policy;

/// The page of the variants.
#[derive(Debug)]
pub struct VariantsPage<'a> {
    /// The file that describes them.
    pub file: &'a str,
    /// The name of the product.
    pub product: &'a str,
    /// The headings of the columns.
    pub headings: &'a [&'a str],
    /// The cells of each variant.
    pub rows: Vec<Vec<String>>,
}

#[derive(Template)]
#[template(path = "html/variants.html")]
struct VariantsTemplate<'a> {
    page: &'a VariantsPage<'a>,
    version: &'static str,
}

impl VariantsPage<'_> {
    /// Writes the page as HTML, which needs no other file.
    pub fn html(&self) -> String {
        let template = VariantsTemplate { page: self, version: env!("CARGO_PKG_VERSION") };
        let mut text = String::with_capacity(20_000);
        // writing to a String cannot fail, nor do the template filters
        let _ = template.render_into(&mut text);
        with_policy(text)
    }
}

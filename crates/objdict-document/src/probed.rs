//! What a device answered beside what its description says, as a page.

use askama::Template;

use super::escape::filters;
use super::policy::with_policy;

/// The page of the answers of a device.
#[derive(Debug)]
pub struct ProbePage<'a> {
    /// The description.
    pub file: &'a str,
    /// How many answers are as described.
    pub summary: String,
    /// Each answer: address, name, what was asked, the answer, and the rule that it contradicts and how; both are empty for one that is
    /// as described.
    pub rows: Vec<[String; 6]>,
}

#[derive(Template)]
#[template(path = "html/probe.html")]
struct ProbeTemplate<'a> {
    page: &'a ProbePage<'a>,
    version: &'static str,
}

impl ProbePage<'_> {
    /// Writes the page as HTML, which needs no other file.
    pub fn html(&self) -> String {
        let template = ProbeTemplate { page: self, version: env!("CARGO_PKG_VERSION") };
        let mut text = String::with_capacity(20_000 + 200 * self.rows.len());
        // writing to a String cannot fail, nor do the template filters
        let _ = template.render_into(&mut text);
        with_policy(text)
    }
}

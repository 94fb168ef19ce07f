//! Writes a page in each format.

use super::card::Card;
use super::context::{Context, Form, Options, Subject};
use super::page::Page;
use super::{csv, html, markdown};
use crate::model::Device;

/// Writes the documentation of a device.
///
/// ```
/// use objdict_document::{Form, Options, Subject};
///
/// # let mut device = objdict_model::model::Device::default();
/// # device.objects.insert(0x6000, objdict_model::model::Object::default());
/// let identifiers = Default::default();
/// let subject =
///     Subject { device: &device, file: "io-401.eds", format: "EDS", findings: None, identifiers: &identifiers };
/// let page = objdict_document::write(&subject, Form::Html, &Options { node_id: Some(5), ..Options::default() });
/// assert!(page.contains(r#"id="6000""#));
/// ```
pub fn write(subject: &Subject<'_>, form: Form, options: &Options) -> String {
    let context = Context::new(subject, options);
    write_page(&Page::new(subject, options, &context), subject.device, form)
}

/// Writes the summary of a device as a piece of HTML without styles, for a notebook.
pub fn card(subject: &Subject<'_>, options: &Options) -> String {
    html::write_card(&Card::new(subject, &Context::new(subject, options)))
}

pub(crate) fn write_page(page: &Page<'_>, device: &Device, form: Form) -> String {
    match form {
        Form::Html => html::write(page),
        Form::Markdown => markdown::write(page),
        Form::Csv => csv::write(page, device),
    }
}

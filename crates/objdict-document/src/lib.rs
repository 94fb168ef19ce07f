//! Documentation generated from a description: pages for reading, tables for programs, a DBC for tools of the bus.
//!
//! A page contains the words in reading order; a [`Form`] writes it. Neither reads files: the findings of
//! `check` and the file name are passed with the device ([`Subject`]).

mod anchor;
mod card;
mod communication;
mod connections;
mod csv;
pub mod dbc;
pub mod describe;
mod details;
mod diagram;
mod downloads;
mod entry;
mod escape;
mod finding;
mod groups;
mod html;
mod layout;
mod markdown;
mod network;
mod object;
mod page;
mod pdos;
mod policy;
mod sentence;
mod services;
mod site;
mod states;
mod text_width;
mod texts;

use std::collections::BTreeMap;

pub use self::finding::Finding;
pub use self::network::SiteNetwork;
use self::page::{Context, Page};
pub use self::site::{Site, SiteFile};
use crate::model::Device;
use objdict_model::{Language, diagnostic, model, source};
use objdict_profile as profile;

/// The documented device with its context.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The device.
    pub device: &'a Device,
    /// The file name shown to readers.
    pub file: &'a str,
    /// The format of the file: `EDS`, `DCF`, `XDD`, `XDC`, `JSON`.
    pub format: &'a str,
    /// The findings of `check`; `None` if it did not run.
    pub findings: Option<&'a [Finding]>,
    /// Identifiers in generated code; empty if unknown.
    pub identifiers: &'a Identifiers,
}

/// Identifiers of objects (no sub-index) and entries in generated code.
pub type Identifiers = BTreeMap<(u16, Option<u8>), CodeName>;

/// The identifiers of an object or an entry in generated code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeName {
    /// The constant in Rust: `od::identity_object::VENDOR_ID`.
    pub rust: String,
    /// The macro in C: `OD_IDENTITY_OBJECT_VENDOR_ID`.
    pub c: String,
}

/// Output forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A self-contained HTML page.
    Html,
    /// A Markdown file with tables, as GitHub and GitLab render them.
    Markdown,
    /// One line per entry.
    Csv,
}

impl Form {
    /// All forms.
    pub const ALL: [Self; 3] = [Self::Html, Self::Markdown, Self::Csv];

    /// The form for a file extension (without the dot).
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|form| form.extension().eq_ignore_ascii_case(extension))
    }

    /// The file extension.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Html => "html",
            Self::Markdown => "md",
            Self::Csv => "csv",
        }
    }
}

/// Options of the documentation.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The title (default: product name).
    pub title: Option<String>,
    /// The node-ID for COB-IDs, 1 to 127 (default: that of the configured node, if any).
    pub node_id: Option<u8>,
    /// The language of names and descriptions, if the description has several (RFC 5646, such as `de`).
    /// Headings and sentences use it if objdict supports it ([`Language::of_tag`]), else English.
    pub language: Option<String>,
}

impl Options {
    /// The language of headings and sentences.
    pub fn own_language(&self) -> Language {
        self.language.as_deref().and_then(Language::of_tag).unwrap_or_default()
    }

    /// The language of description texts.
    pub(crate) fn tag(&self) -> &str {
        self.language.as_deref().unwrap_or("en")
    }
}

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

fn write_page(page: &Page<'_>, device: &Device, form: Form) -> String {
    match form {
        Form::Html => html::write(page),
        Form::Markdown => markdown::write(page),
        Form::Csv => csv::write(page, device),
    }
}

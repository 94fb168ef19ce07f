//! Documentation made of a description: pages that people read, tables that programs read.
//!
//! A page is what is to be said of a device, in words and in the order in which it is said; [`Form`]s write it down. Neither
//! knows a file: what `check` found and what the file is called are given with the device ([`Subject`]).

mod anchor;
mod card;
mod communication;
mod connections;
mod csv;
pub mod describe;
mod details;
mod diagram;
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
mod sentence;
mod services;
mod site;
mod text_width;
mod texts;

use std::collections::BTreeMap;

pub use self::finding::Finding;
use self::page::{Context, Page};
pub use self::site::{Site, SiteFile};
use crate::model::Device;
use objdict_model::{Language, diagnostic, model};
use objdict_profile as profile;

/// What is documented.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The device.
    pub device: &'a Device,
    /// The name of its file, as a reader knows it.
    pub file: &'a str,
    /// The format of the file: `EDS`, `DCF`, `XDD`, `XDC`, `JSON`.
    pub format: &'a str,
    /// What `check` found; `None` where nothing was checked.
    pub findings: Option<&'a [Finding]>,
    /// What generated code calls objects (no sub-index) and entries; empty where that is not known.
    pub identifiers: &'a Identifiers,
}

/// What generated code calls objects (no sub-index) and entries.
pub type Identifiers = BTreeMap<(u16, Option<u8>), CodeName>;

/// What generated code calls an object or an entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeName {
    /// The constant in Rust: `od::identity_object::VENDOR_ID`.
    pub rust: String,
    /// The macro in C: `OD_IDENTITY_OBJECT_VENDOR_ID`.
    pub c: String,
}

/// How documentation is written down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// One page that needs nothing beside it: no network, no other file.
    Html,
    /// One file of tables, as forges render them.
    Markdown,
    /// One line for each entry.
    Csv,
}

impl Form {
    /// All forms.
    pub const ALL: [Self; 3] = [Self::Html, Self::Markdown, Self::Csv];

    /// What the ending of a file, without its point, stands for.
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|form| form.extension().eq_ignore_ascii_case(extension))
    }

    /// The ending of a file.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Html => "html",
            Self::Markdown => "md",
            Self::Csv => "csv",
        }
    }
}

/// What documentation shall be like.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The title; without it, the product's name.
    pub title: Option<String>,
    /// The node that COB-IDs are worked out for, 1 to 127; without it, that of a configured node, if any.
    pub node_id: Option<u8>,
    /// The language of names and descriptions, where the description has them in several (RFC 5646, such as `de`); headings and
    /// sentences are in it where objdict writes in it ([`Language::of_tag`]), else in English.
    pub language: Option<String>,
}

impl Options {
    /// The language of headings and sentences.
    pub fn own_language(&self) -> Language {
        self.language.as_deref().and_then(Language::of_tag).unwrap_or_default()
    }

    /// The language of texts of the description.
    pub(crate) fn tag(&self) -> &str {
        self.language.as_deref().unwrap_or("en")
    }
}

/// The documentation of a device.
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

//! Sites: one page per device, and an index.

use std::collections::BTreeMap;
use std::path::Path;

use askama::Template;

use super::anchor::Anchor;
use super::context::{Context, Form, Options, Subject};
use super::csv::{self, CsvColumn};
use super::escape::{address, filters};
use super::html::with_policy;
use super::network::{NetworkView, SiteNetwork, StatedNode, stated, tables};
use super::page::Page;
use super::texts::LanguageTexts;
use super::write::write_page;
use crate::Language;
use crate::diagnostic::Severity;
use crate::model::PdoKind;

/// A site under construction. Pages are written one by one; only the data for the index and the configured
/// nodes are kept.
///
/// ```
/// use objdict_document::{Form, Options, Site, Subject};
///
/// # let mut device = objdict_model::model::Device::default();
/// # device.objects.insert(0x6000, objdict_model::model::Object::default());
/// let mut site = Site::new(Form::Markdown, &Options::default());
/// let identifiers = Default::default();
/// let subject =
///     Subject { device: &device, file: "io-401.eds", format: "EDS", findings: None, identifiers: &identifiers };
/// let page = site.add(&subject);
/// assert_eq!(page.name, "io-401.md");
/// assert!(site.index()[0].text.contains("(io-401.md)"));
/// ```
#[derive(Debug)]
pub struct Site {
    form: Form,
    options: Options,
    title: Option<String>,
    /// The number of pages per lower-case name.
    taken: BTreeMap<String, usize>,
    devices: Vec<Listed>,
    networks: Vec<SiteNetwork>,
    nodes: Vec<StatedNode>,
    places: SitePlaces,
}

/// The objects and entries of all devices by place and name, each with the numbers of its devices.
type SitePlaces = BTreeMap<(u16, Option<u8>, String), Vec<usize>>;

/// A file of a site.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SiteFile {
    /// Its name; all files are in one folder.
    pub name: String,
    /// Its content.
    pub text: String,
}

/// A device in the index.
#[derive(Debug)]
pub(crate) struct Listed {
    /// The link to its page.
    link: String,
    title: String,
    file: String,
    format: String,
    vendor: String,
    profile: String,
    node_id: Option<u8>,
    node_name: String,
    objects: usize,
    entries: usize,
    rpdos: usize,
    tpdos: usize,
    /// Numbers of errors, warnings and notes; `None` if `check` did not run.
    findings: Option<[usize; 3]>,
}

impl Site {
    /// Creates a site without pages. The title applies to the site; pages are titled by product.
    pub fn new(form: Form, options: &Options) -> Self {
        let reserved: &[&str] = match form {
            Form::Csv => &["index", "links", "messages"],
            Form::Html | Form::Markdown => &["index"],
        };
        Self {
            form,
            title: options.title.clone(),
            options: Options { title: None, ..options.clone() },
            taken: reserved.iter().map(|name| ((*name).to_owned(), 1)).collect(),
            devices: Vec::new(),
            networks: Vec::new(),
            nodes: Vec::new(),
            places: BTreeMap::new(),
        }
    }

    /// Adds a device and returns its page. The page is named after the file, with a number if the name is
    /// taken.
    pub fn add(&mut self, subject: &Subject<'_>) -> SiteFile {
        let name = self.page_name(subject.file);
        let link = address(&name);
        let context = Context::new(subject, &self.options);
        let index = Some(format!("index.{}", self.form.extension()));
        let page = Page { site: index, ..Page::new(subject, &self.options, &context) };
        self.nodes.extend(StatedNode::new(&context, &page.title, &name));
        add_places(&mut self.places, self.devices.len(), &page);
        self.devices.push(Listed::new(subject, &context, &page, link));
        SiteFile { name, text: write_page(&page, subject.device, self.form) }
    }

    fn page_name(&mut self, file: &str) -> String {
        let stem = Path::new(file).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        loop {
            let count = self.taken.entry(stem.to_lowercase()).or_default();
            *count += 1;
            let name = if *count == 1 { stem.clone() } else { format!("{stem}-{count}") };
            // a numbered name may be the name of a different file
            if name == stem || self.taken.insert(name.to_lowercase(), 1).is_none() {
                return format!("{name}.{}", self.form.extension());
            }
        }
    }

    /// Adds a network to the index. Configured nodes outside these are shown as the networks that their
    /// descriptions state.
    pub fn add_network(&mut self, network: SiteNetwork) {
        self.networks.push(network);
    }

    /// Returns the index after all pages and networks are added, and its additional files: diagrams and
    /// tables of networks.
    pub fn index(mut self) -> Vec<SiteFile> {
        let is_given = |node: &StatedNode| {
            let mut pages = self.networks.iter().flat_map(|network| &network.pages);
            pages.any(|page| page.as_ref() == Some(&node.page))
        };
        self.nodes.retain(|node| !is_given(node));
        self.networks.extend(stated(self.nodes, self.options.tag()));
        let language = self.options.own_language();
        let texts = LanguageTexts::of(language);
        let name_of = match self.networks.as_slice() {
            [network] if network.file.is_some() => {
                network.overview.name.as_deref().or(network.file.as_deref())
            }
            _ => None,
        };
        let networks = (1..).zip(&self.networks);
        let index = Index {
            language,
            texts,
            title: self.title.as_deref().or(name_of).unwrap_or(texts.devices),
            devices: &self.devices,
            networks: networks
                .map(|(number, network)| NetworkView::new(network, number, self.form))
                .collect(),
            places: &self.places,
        };
        // writing to a String cannot fail, nor do the template filters
        let text = match self.form {
            Form::Html => with_policy(HtmlIndex { index: &index }.render().unwrap_or_default() + "\n"),
            Form::Markdown => MarkdownIndex { index: &index }.render().unwrap_or_default() + "\n",
            Form::Csv => csv::table(&COLUMNS, &self.devices),
        };
        let mut files = vec![SiteFile { name: format!("index.{}", self.form.extension()), text }];
        let pictures = index.networks.iter().flat_map(NetworkView::pictures);
        files.extend(pictures.map(|(name, text)| SiteFile { name, text }));
        if self.form == Form::Csv && !self.networks.is_empty() {
            let overviews = self.networks.iter().map(|network| &network.overview);
            files.extend(tables(overviews).map(|(name, text)| SiteFile { name: name.to_owned(), text }));
        }
        files
    }
}

impl Listed {
    fn new(subject: &Subject<'_>, context: &Context<'_>, page: &Page<'_>, link: String) -> Self {
        let device = subject.device;
        let info = device.device_info.as_ref();
        let node = device.commissioning.as_ref();
        let found = |severity| {
            move |findings: &[super::Finding]| {
                findings.iter().filter(|finding| finding.severity == severity).count()
            }
        };
        Self {
            link,
            title: page.title.clone(),
            file: subject.file.to_owned(),
            format: subject.format.to_owned(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
            profile: context.decoder.device_profile().unwrap_or_default(),
            node_id: device.node_id().and(context.node_id),
            node_name: node.and_then(|node| node.node_name.clone()).unwrap_or_default(),
            objects: page.object_count(),
            entries: page.entry_count(),
            rpdos: device.pdo_count(PdoKind::Rpdo),
            tpdos: device.pdo_count(PdoKind::Tpdo),
            findings: subject.findings.map(|findings| {
                [Severity::Error, Severity::Warning, Severity::Note].map(|severity| found(severity)(findings))
            }),
        }
    }

    /// The number of findings of a severity; empty if `check` did not run.
    fn found(&self, severity: usize) -> String {
        self.findings.map(|counts| counts[severity].to_string()).unwrap_or_default()
    }

    /// `5 pump`; empty for a device type.
    fn node(&self) -> String {
        let id = self.node_id.map(|id| id.to_string()).unwrap_or_default();
        format!("{id} {}", self.node_name.trim()).trim().to_owned()
    }
}

/// Adds the objects and entries of a device.
fn add_places(places: &mut SitePlaces, number: usize, page: &Page<'_>) {
    let mut add = |anchor: Anchor, name: &str| {
        places.entry((anchor.index, anchor.sub, name.to_owned())).or_default().push(number);
    };
    for object in page.areas.iter().flat_map(|area| &area.objects) {
        add(object.anchor(), &object.name);
        let named = object.entries.iter().filter(|entry| !object.is_single && entry.sub != 0);
        named.for_each(|entry| add(entry.anchor(), &entry.name));
    }
}

/// Data of the index template.
struct Index<'a> {
    language: Language,
    texts: &'static LanguageTexts,
    title: &'a str,
    devices: &'a [Listed],
    networks: Vec<NetworkView<'a>>,
    places: &'a SitePlaces,
}

impl Index<'_> {
    /// The objects and entries of all devices: anchors, names, and the devices that have them.
    fn places(&self) -> impl ExactSizeIterator<Item = (Anchor, &str, Vec<&Listed>)> {
        self.places.iter().map(|((index, sub, name), numbers)| {
            let devices = numbers.iter().filter_map(|&number| self.devices.get(number)).collect();
            (Anchor { index: *index, sub: *sub }, name.as_str(), devices)
        })
    }

    /// Whether any device is a configured node.
    fn has_nodes(&self) -> bool {
        self.devices.iter().any(|device| !device.node().is_empty())
    }
}

#[derive(Template)]
#[template(path = "html/index.html")]
struct HtmlIndex<'a> {
    index: &'a Index<'a>,
}

#[derive(Template)]
#[template(path = "markdown/index.md")]
struct MarkdownIndex<'a> {
    index: &'a Index<'a>,
}

/// The table of devices, one line each. As in the other tables, columns are never renamed, moved or removed.
const COLUMNS: [CsvColumn<Listed>; 15] = [
    ("file", |device| device.file.clone()),
    ("format", |device| device.format.clone()),
    ("table", |device| device.link.clone()),
    ("name", |device| device.title.clone()),
    ("vendor", |device| device.vendor.clone()),
    ("profile", |device| device.profile.clone()),
    ("node_id", |device| device.node_id.map(|id| id.to_string()).unwrap_or_default()),
    ("node_name", |device| device.node_name.clone()),
    ("objects", |device| device.objects.to_string()),
    ("entries", |device| device.entries.to_string()),
    ("rpdos", |device| device.rpdos.to_string()),
    ("tpdos", |device| device.tpdos.to_string()),
    ("errors", |device| device.found(0)),
    ("warnings", |device| device.found(1)),
    ("notes", |device| device.found(2)),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_have_names_of_their_own() {
        let mut site = Site::new(Form::Html, &Options::default());
        let files = ["io.eds", "io.dcf", "IO.xdd", "io-2.eds", "index.eds", "-", "a b#c.eds"];
        let names = files.map(|file| site.page_name(file));
        let expected =
            ["io.html", "io-2.html", "IO-3.html", "io-2-2.html", "index-2.html", "-.html", "a b#c.html"];
        assert_eq!(names, expected);
    }
}

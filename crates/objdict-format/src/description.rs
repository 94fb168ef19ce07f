//! A description that was read: the device together with the text that it came from.
//!
//! It and the parent module import each other, because a description reads and writes every format.

mod edits;

use std::borrow::Cow;
use std::collections::BTreeMap;
#[cfg(feature = "xdd")]
use std::sync::Arc;
use std::sync::OnceLock;

use super::Format;
#[cfg(feature = "xdd")]
use super::Syntax;
#[cfg(feature = "full")]
use super::device_toml;
#[cfg(feature = "full")]
use super::embedded;
#[cfg(feature = "xdd")]
use super::objdictgen;
#[cfg(feature = "full")]
use super::patch::Patched;
use objdict_eds::ini::Document;
use objdict_eds::{eds, ini};
#[cfg(any(feature = "full", not(feature = "xdd")))]
use objdict_model::diagnostic::one_line;
use objdict_model::diagnostic::{At, Findings};
use objdict_model::model::{Device, EMBEDDED_COMMENT, EMBEDDED_SECTION, Place};
#[cfg(feature = "full")]
use objdict_model::source::EditError;
use objdict_model::source::{SourceFile, Span};
#[cfg(feature = "xdd")]
use objdict_xdd::xdd;
#[cfg(feature = "xdd")]
use objdict_xdd::xml::Tree;

/// A description that was read: the device, the text that it came from, and what the reader found.
#[derive(Debug)]
pub struct Description {
    format: Format,
    text: Text,
    /// Which device of the file it is.
    number: usize,
    device: Device,
    findings: Findings,
    /// The description of the type that this node was made from.
    origin: Option<Box<Self>>,
    /// The patches that made the device of what the text says.
    #[cfg(feature = "full")]
    patched: Option<Box<Patched>>,
}

/// The text in the syntax of its format, with what finds places in it; that is made when it is asked for.
#[derive(Debug)]
enum Text {
    /// Lines of an INI file.
    Ini(Document, OnceLock<eds::Locator>),
    /// Elements of XML.
    #[cfg(feature = "xdd")]
    Xml(Arc<Tree>, OnceLock<xdd::Locator>),
    /// A project of objdictgen, which is XML of another kind.
    #[cfg(feature = "xdd")]
    Objdictgen(Tree, OnceLock<objdictgen::Locator>),
    /// Tables of keys.
    #[cfg(feature = "full")]
    Toml(device_toml::Document),
}

/// The name of a file as a description states it: on one line, in any encoding.
#[cfg(any(feature = "full", not(feature = "xdd")))]
pub fn stated_name(name: &str) -> String {
    one_line(name).replace(char::REPLACEMENT_CHARACTER, "_")
}

impl Description {
    pub(super) fn read(source: SourceFile, format: Format) -> Self {
        let (text, device, findings) = match format.syntax() {
            #[cfg(feature = "xdd")]
            Syntax::Xml => {
                let mut damage = Findings::new();
                let tree = Tree::new(source, &mut damage);
                if objdictgen::is_project(&tree) {
                    let (device, findings) = objdictgen::read(&tree);
                    // each project has one
                    let mut damage =
                        damage.filter_map(|found| (found.rule.id != "xml/document-type").then_some(found));
                    damage.append(findings);
                    (Text::Objdictgen(tree, OnceLock::new()), device, damage)
                } else {
                    let (device, findings) = xdd::read(&tree, 0, format.kind());
                    damage.append(findings);
                    (Text::Xml(Arc::new(tree), OnceLock::new()), device, damage)
                }
            }
            #[cfg(feature = "full")]
            Syntax::Toml => {
                let (document, device, findings) = device_toml::Document::read(source);
                (Text::Toml(document), device, findings)
            }
            // a build without XDD finds nothing but junk in one
            _ => {
                let document = Document::new(source);
                let (device, findings) = eds::read(&document, format.kind());
                (Text::Ini(document, OnceLock::new()), device, findings)
            }
        };
        let (device, mut findings) = match format {
            // it has a place for everything
            Format::Toml => (device, findings),
            _ => restored(device, findings),
        };
        let read = Self::new(format, text, 0, device, Findings::new());
        // a source keeps the name of the description that is made of it
        if read.device_count() == 1 && format != Format::Toml {
            eds::file_name::check(&read.device, read.source().name(), &mut findings);
        }
        Self { findings, ..read }
    }

    fn new(format: Format, text: Text, number: usize, device: Device, findings: Findings) -> Self {
        Self {
            format,
            text,
            number,
            device,
            findings,
            origin: None,
            #[cfg(feature = "full")]
            patched: None,
        }
    }

    /// How many devices the file describes. A network of CANopenEditor (`.nxdd`, `.nxdc`) describes several, and this is
    /// the description of the first, unless another is [selected](Self::select).
    pub fn device_count(&self) -> usize {
        match &self.text {
            Text::Ini(..) => 1,
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => 1,
            #[cfg(feature = "full")]
            Text::Toml(..) => 1,
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => xdd::containers(tree).len().max(1),
        }
    }

    /// The description of another device of the same file, counted from 0; `None` where there are fewer.
    #[must_use]
    pub fn select(self, number: usize) -> Option<Self> {
        if number == self.number { Some(self) } else { self.sibling(number) }
    }

    /// The description of a device of the same XML file, counted from 0, which shares the text; `None` where there are fewer.
    /// Those of a `device.toml` behind the first are its variants.
    #[cfg_attr(
        not(feature = "xdd"),
        expect(unused_variables, reason = "only XML and TOML describe several devices")
    )]
    pub fn sibling(&self, number: usize) -> Option<Self> {
        match &self.text {
            #[cfg(feature = "full")]
            Text::Toml(document) if self.number > 0 || document.variant().is_none() => {
                let variant = document.variants().into_iter().nth(number.checked_sub(1)?)?;
                Some(self.of_variant(document, variant, number))
            }
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) if number < xdd::containers(tree).len() => {
                let (device, findings) = xdd::read(tree, number, self.format.kind());
                let (device, findings) = restored(device, findings);
                let (tree, format) = (Arc::clone(tree), self.format);
                let read = Self::new(format, Text::Xml(tree, OnceLock::new()), number, device, findings);
                Some(read.with_patches_of(self))
            }
            _ => None,
        }
    }

    #[cfg(feature = "full")]
    fn of_variant(&self, document: &device_toml::Document, variant: String, number: usize) -> Self {
        let (document, device, findings) = document.read_variant(variant);
        Self::new(self.format, Text::Toml(document), number, device, findings).with_patches_of(self)
    }

    /// The description with the patches that were given for another device of the file.
    #[cfg(feature = "xdd")]
    #[cfg_attr(not(feature = "full"), expect(unused_variables, reason = "there are none"))]
    fn with_patches_of(self, other: &Self) -> Self {
        #[cfg(feature = "full")]
        if let Some(patched) = &other.patched {
            return super::patch::apply(self, &patched.given);
        }
        self
    }

    /// The description of a variant of a `device.toml`, as the only device of the file.
    ///
    /// # Errors
    /// When there is no variant of this name: the names that there are.
    #[cfg(feature = "full")]
    pub(super) fn into_variant(self, name: &str) -> Result<Self, Vec<String>> {
        let Text::Toml(document) = &self.text else { return Err(Vec::new()) };
        let variants = document.variants();
        match variants.iter().any(|variant| variant == name) {
            true => Ok(self.of_variant(document, name.to_owned(), 0)),
            false => Err(variants),
        }
    }

    /// Whether the text alone does not say what the device is: it is a variant, or extends another file. It is not edited then.
    pub fn is_composed(&self) -> bool {
        self.variant().is_some() || self.extended().is_some()
    }

    /// The file that a `device.toml` extends, as it names it, and where it does.
    pub fn extended(&self) -> Option<(&str, Span)> {
        match &self.text {
            #[cfg(feature = "full")]
            Text::Toml(document) => document.extended(),
            _ => None,
        }
    }

    /// Where a `device.toml` names its objects; `None` for another format.
    #[cfg(feature = "full")]
    pub fn toml_mentions(&self) -> Option<Vec<super::mention::Mention>> {
        match &self.text {
            Text::Toml(document) => Some(document.mentions()),
            _ => None,
        }
    }

    /// The files that a `device.toml` extends, which say a part of what the device is.
    pub fn extended_files(&self) -> &[std::path::PathBuf] {
        match &self.text {
            #[cfg(feature = "full")]
            Text::Toml(document) => document.extended_files(),
            _ => &[],
        }
    }

    /// The name of the variant that it describes; `None` of a file as a whole.
    pub fn variant(&self) -> Option<&str> {
        match &self.text {
            #[cfg(feature = "full")]
            Text::Toml(document) => document.variant(),
            _ => None,
        }
    }

    /// What a function makes of each device of the file, from this one on.
    pub fn map_devices<T>(&self, mut make: impl FnMut(&Self) -> T) -> Vec<T> {
        let mut made = vec![make(self)];
        let others = (self.number + 1..).map_while(|number| self.sibling(number));
        made.extend(others.map(|other| make(&other)));
        made
    }

    /// One of the devices of the file.
    #[cfg(feature = "full")]
    fn device_at(&self, number: usize) -> Cow<'_, Device> {
        if number == self.number {
            return Cow::Borrowed(&self.device);
        }
        Cow::Owned(self.sibling(number).map(|other| other.device).unwrap_or_default())
    }

    /// Which device of the file it describes, counted from 0.
    pub fn number(&self) -> usize {
        self.number
    }

    /// The format that it was read as.
    pub fn format(&self) -> Format {
        self.format
    }

    /// The source.
    pub fn source(&self) -> &SourceFile {
        match &self.text {
            Text::Ini(document, _) => document.source(),
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => tree.source(),
            #[cfg(feature = "xdd")]
            Text::Objdictgen(tree, _) => tree.source(),
            #[cfg(feature = "full")]
            Text::Toml(document) => document.source(),
        }
    }

    /// The text as lines; `None` for one that is no INI file.
    pub fn document(&self) -> Option<&Document> {
        match &self.text {
            Text::Ini(document, _) => Some(document),
            #[cfg(feature = "xdd")]
            Text::Xml(..) | Text::Objdictgen(..) => None,
            #[cfg(feature = "full")]
            Text::Toml(..) => None,
        }
    }

    /// The text as elements; `None` for one that is no XML.
    #[cfg(feature = "xdd")]
    pub fn tree(&self) -> Option<&Tree> {
        match &self.text {
            Text::Ini(..) | Text::Objdictgen(..) => None,
            Text::Xml(tree, _) => Some(tree),
            #[cfg(feature = "full")]
            Text::Toml(..) => None,
        }
    }

    /// Whether the text is a project: of the editors for CANopenNode from before XDD, or of objdictgen. It is read and never
    /// changed.
    pub fn is_project(&self) -> bool {
        match &self.text {
            Text::Ini(..) => false,
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => xdd::is_project(tree),
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => true,
            #[cfg(feature = "full")]
            Text::Toml(..) => false,
        }
    }

    /// Whether the text is a network of devices, of which this is one.
    pub fn is_network(&self) -> bool {
        match &self.text {
            Text::Ini(..) => false,
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => xdd::is_network(tree),
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => false,
            #[cfg(feature = "full")]
            Text::Toml(..) => false,
        }
    }

    /// The description with this device in place of that of its text, made by patches.
    #[cfg(feature = "full")]
    pub(super) fn with_patched(self, device: Device, patched: Patched) -> Self {
        Self { device, patched: Some(Box::new(patched)), ..self }
    }

    /// The patches that were made in it; `None` where none was for it.
    #[cfg(feature = "full")]
    pub fn patched(&self) -> Option<&Patched> {
        self.patched.as_deref()
    }

    /// The description with a text that says what its patches make of it; `None` where none was for it.
    ///
    /// # Errors
    /// When that text cannot be written in the encoding of the file.
    #[cfg(feature = "full")]
    pub fn realised(&self) -> Result<Option<Self>, EditError> {
        match &self.patched {
            None => Ok(None),
            Some(_) if self.is_composed() => Err(EditError::ReadOnly(self.source().name().to_owned())),
            Some(_) => {
                let original =
                    self.unpatched().ok_or_else(|| EditError::ReadOnly(self.source().name().to_owned()))?;
                super::patch::edited(&original, &self.device).map(Some)
            }
        }
    }

    /// What the text says without the patches.
    #[cfg(feature = "full")]
    fn unpatched(&self) -> Option<Self> {
        let mut options = objdict_model::source::SourceOptions::default();
        (options.encoding, options.max_size) = (Some(self.source().encoding()), u64::MAX);
        let source = SourceFile::from_bytes(self.source().name(), self.source().to_bytes(), &options).ok()?;
        super::read(source, self.format).select(self.number)
    }

    /// Whether the text says the same as this device.
    #[cfg(feature = "full")]
    pub(super) fn says(&self, device: &Device) -> bool {
        says_the_same(&self.device, device)
    }

    /// The bytes of the file, put together from what was read: always the bytes as they came.
    pub fn print(&self) -> Vec<u8> {
        match &self.text {
            Text::Ini(document, _) => document.print(),
            #[cfg(feature = "xdd")]
            Text::Xml(..) | Text::Objdictgen(..) => self.source().to_bytes(),
            #[cfg(feature = "full")]
            Text::Toml(..) => self.source().to_bytes(),
        }
    }

    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// The description of a configured node beside that of its type, with which it is then checked too.
    #[must_use]
    pub fn with_origin(self, origin: Self) -> Self {
        Self { origin: Some(Box::new(origin)), ..self }
    }

    /// The description of the type that the node was made from, as far as it was [given](Self::with_origin); labels at
    /// [`At::Node`] point into it.
    pub fn origin(&self) -> Option<&Self> {
        self.origin.as_deref()
    }

    /// The device, without its text.
    pub fn into_device(self) -> Device {
        self.device
    }

    /// The span of a place of the model in the text; `None` for what has no text.
    pub fn locate(&self, place: &Place) -> Option<Span> {
        match &self.text {
            Text::Ini(document, locator) => {
                locator.get_or_init(|| eds::Locator::new(document)).locate(document, place)
            }
            #[cfg(feature = "xdd")]
            Text::Xml(tree, locator) => {
                locator.get_or_init(|| xdd::Locator::new(tree, self.number)).locate(tree, place)
            }
            #[cfg(feature = "xdd")]
            Text::Objdictgen(tree, locator) => {
                locator.get_or_init(|| objdictgen::Locator::new(tree)).locate(tree, place)
            }
            #[cfg(feature = "full")]
            Text::Toml(document) => document.locate(place),
        }
    }

    /// Where a label points in the text; the start of the text for what has none.
    pub fn span_of(&self, at: &At) -> Span {
        match at {
            At::Span(span) => *span,
            At::Patch(..) => Span::default(),
            At::Place(place) | At::Node(_, place) => self.locate(place).unwrap_or_default(),
        }
    }

    /// The place in the model that a label points to; of a label of the text, that of its section or element.
    /// `None` outside the parts of a description.
    pub fn place_of<'a>(&self, at: &'a At) -> Option<Cow<'a, Place>> {
        let span = match at {
            At::Place(place) | At::Node(_, place) => return Some(Cow::Borrowed(place)),
            At::Patch(..) => return None,
            At::Span(span) => span,
        };
        let place = match &self.text {
            Text::Ini(document, locator) => {
                locator.get_or_init(|| eds::Locator::new(document)).place_at(document, span.start)
            }
            #[cfg(feature = "xdd")]
            Text::Xml(tree, locator) => {
                locator.get_or_init(|| xdd::Locator::new(tree, self.number)).place_at(tree, span.start)
            }
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => None,
            #[cfg(feature = "full")]
            Text::Toml(document) => document.place_at(span.start),
        };
        place.map(Cow::Owned)
    }

    /// What the reader of the format found: in the spelling and structure of the text.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// The device as other tools read it, without what is embedded in comments; `None` where nothing is.
    pub fn seen_by_others(&self) -> Option<Device> {
        let document = self.document().filter(|document| document.text().contains(EMBEDDED_COMMENT))?;
        let (mut device, _) = eds::read(document, self.format.kind());
        device.extra.retain(|section| section.name() != EMBEDDED_SECTION);
        Some(device)
    }

    /// What the text shows that other tools choke on, which read `device`; see `compat`.
    pub fn portability_findings(&self, device: &Device) -> Findings {
        let mut findings = Findings::new();
        if let Some(document) = self.document() {
            eds::portability::check(document, device, &mut findings);
        }
        findings
    }

    /// What validation with the schema of CiA 311 refuses in the text of an XDD or XDC.
    pub fn violations(&self) -> Findings {
        match &self.text {
            Text::Ini(..) => Findings::new(),
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) => xdd::findings::violations(tree),
            #[cfg(feature = "xdd")]
            Text::Objdictgen(..) => Findings::new(),
            #[cfg(feature = "full")]
            Text::Toml(..) => Findings::new(),
        }
    }

    /// Whether validation refuses nothing in the text that it does not refuse in another one of this description.
    pub fn is_as_valid_as(&self, other: &Self) -> bool {
        let count = |description: &Self| {
            let mut counts: BTreeMap<&str, u32> = BTreeMap::new();
            description.violations().iter().for_each(|found| *counts.entry(found.rule.id).or_default() += 1);
            counts
        };
        let now = count(self);
        now.is_empty() || {
            let before = count(other);
            now.iter().all(|(rule, now)| before.get(rule).is_some_and(|before| now <= before))
        }
    }

    /// What the text shows beyond that, healthy or not: the lines of an INI file, the structure of XML. It is not looked
    /// for until it is asked for. Of a file with several devices it belongs to the first.
    pub fn text_findings(&self) -> Findings {
        let mut findings = Findings::new();
        match &self.text {
            Text::Ini(document, _) => ini::findings::lines::check(document, &mut findings),
            #[cfg(feature = "xdd")]
            Text::Xml(tree, _) if self.number == 0 => xdd::findings::check(tree, &mut findings),
            #[cfg(feature = "xdd")]
            Text::Xml(..) | Text::Objdictgen(..) => {}
            #[cfg(feature = "full")]
            Text::Toml(..) => {}
        }
        findings
    }
}

/// Whether two devices are the same, but for the order of the sections that the model does not know.
#[cfg(feature = "full")]
fn says_the_same(one: &Device, other: &Device) -> bool {
    let sorted = |device: &Device| {
        let mut device = device.clone();
        device.extra.sort_by_key(|section| section.name().to_ascii_lowercase());
        device
    };
    one == other || sorted(one) == sorted(other)
}

/// A device with what a conversion carried in it at its place again; without JSON and XDD nothing is carried.
fn restored(device: Device, findings: Findings) -> (Device, Findings) {
    #[cfg(feature = "full")]
    let (device, findings) = embedded::restore(device, findings);
    (device, findings)
}

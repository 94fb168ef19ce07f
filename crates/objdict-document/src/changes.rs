//! Pages that compare: the changes between two descriptions (both sides next to each other, and PDOs as diagrams), and tables, such as
//! the variants of a device or its responses compared with its description.

use super::diagram::{Diagram, Grid};
use super::escape::filters;
use super::html::{rendered, with_policy};
use super::layout::FrameLayout;
use super::texts::LanguageTexts;
use crate::Language;
use crate::model::{Device, Entry, PdoKind};
use askama::Template;

/// The page of a comparison.
#[derive(Debug)]
pub struct ChangesPage<'a> {
    /// The old description.
    pub old: ChangedDevice<'a>,
    /// The new description.
    pub new: ChangedDevice<'a>,
    /// The number of changes, as text.
    pub summary: String,
    /// The verdicts, the worst first.
    pub verdicts: Vec<&'static str>,
    /// The audiences: identifiers and titles.
    pub audiences: Vec<(&'static str, &'static str)>,
    /// The changes.
    pub changes: Vec<ChangeRow>,
}

/// One of the descriptions.
#[derive(Clone, Copy, Debug)]
pub struct ChangedDevice<'a> {
    /// The file name shown to readers.
    pub file: &'a str,
    /// The device.
    pub device: &'a Device,
}

/// A change.
#[derive(Clone, Debug)]
pub struct ChangeRow {
    /// The worst verdict.
    pub verdict: &'static str,
    /// The address of the entry.
    pub address: String,
    /// The id of the rule.
    pub rule: &'static str,
    /// The change as a sentence.
    pub message: String,
    /// The old value.
    pub old: String,
    /// The new value.
    pub new: String,
    /// Line and column in the old and in the new description.
    pub places: [String; 2],
    /// The effects on each audience.
    pub effects: Vec<ChangeEffect>,
    /// The PDO that is drawn on both sides.
    pub pdo: Option<(PdoKind, u16)>,
}

/// The effect of a change on an audience.
#[derive(Clone, Debug)]
pub struct ChangeEffect {
    /// The identifier of the audience.
    pub audience: &'static str,
    /// The audience as text.
    pub title: &'static str,
    /// The verdict.
    pub verdict: &'static str,
    /// Why.
    pub reason: &'static str,
}

#[derive(Template)]
#[template(path = "html/changes.html")]
struct ChangesTemplate<'a> {
    page: &'a ChangesPage<'a>,
    title: String,
    rows: Vec<DrawnChange<'a>>,
    grid: Grid,
    t: &'static LanguageTexts,
}

/// A change with its drawings.
struct DrawnChange<'a> {
    change: &'a ChangeRow,
    old: Option<Diagram>,
    new: Option<Diagram>,
}

impl DrawnChange<'_> {
    /// The audiences with the verdict of each, for the filter: `sdo-clients=breaking`.
    fn keys(&self) -> String {
        let keys = self.change.effects.iter().map(|effect| format!("{}={}", effect.audience, effect.verdict));
        keys.collect::<Vec<_>>().join(" ")
    }
}

impl ChangesPage<'_> {
    /// Writes the page as HTML without external files.
    pub fn html(&self) -> String {
        let rows = self.changes.iter().map(|change| DrawnChange {
            old: change.pdo.and_then(|pdo| drawing(self.old.device, pdo)),
            new: change.pdo.and_then(|pdo| drawing(self.new.device, pdo)),
            change,
        });
        let template = ChangesTemplate {
            page: self,
            title: format!("{} → {}", self.old.file, self.new.file),
            rows: rows.collect(),
            grid: Grid::new(),
            t: LanguageTexts::of(Language::English),
        };
        with_policy(rendered(&template, 20_000 + 1000 * self.changes.len()))
    }
}

/// The frame of a PDO, without links, because its entries are not on this page.
fn drawing(device: &Device, (kind, number): (PdoKind, u16)) -> Option<Diagram> {
    let pdo = device.pdo(kind, number)?;
    let name = |entry: &Entry| entry.name.to_string();
    let layout = FrameLayout::new(device, &pdo, &name);
    let mut diagram = Diagram::new(&pdo.to_string(), &layout, Language::English)?;
    diagram.shapes.iter_mut().for_each(|shape| shape.anchor = None);
    Some(diagram)
}

/// A page with one table: the variants of a device, or the checks of one.
#[derive(Debug)]
pub struct TablePage<'a> {
    /// The file that it is about.
    pub file: &'a str,
    /// The heading.
    pub heading: &'a str,
    /// What is below the heading, as text.
    pub summary: String,
    /// The headings of the columns.
    pub headings: &'a [&'a str],
    /// The cells of each row, and whether the last one is emphasized.
    pub rows: Vec<(Vec<String>, bool)>,
}

#[derive(Template)]
#[template(path = "html/table.html")]
struct TableTemplate<'a> {
    page: &'a TablePage<'a>,
}

impl TablePage<'_> {
    /// Writes the page as HTML without external files.
    pub fn html(&self) -> String {
        with_policy(rendered(&TableTemplate { page: self }, 20_000 + 200 * self.rows.len()))
    }
}

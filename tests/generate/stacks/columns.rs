//! The entries of a device in all targets side by side: a column per target, a row per entry. Two cells of a
//! row are equal, or one of the two targets has a note for the entry that explains the difference.

use std::collections::{BTreeMap, BTreeSet};

use objdict::generate::Note;
use objdict::model::Part;

use crate::stacks::truth::Row;

/// The properties in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aspect {
    /// Existence of the entry.
    Entry,
    Type,
    Size,
    Access,
    Mapping,
    Default,
}

/// The properties compared if both targets have an entry.
const ASPECTS: [Aspect; 5] = [Aspect::Type, Aspect::Size, Aspect::Access, Aspect::Mapping, Aspect::Default];

/// The entries of a target.
pub(crate) struct Column {
    pub(crate) target: &'static str,
    /// Properties that the tables of the target do not contain for any entry, as its page says; not compared.
    pub(crate) untold: &'static [Aspect],
    /// Properties that may differ if a note with this text applies to the entry.
    pub(crate) excuses: &'static [(Aspect, &'static str)],
    pub(crate) notes: Vec<Note>,
    pub(crate) cells: BTreeMap<(u16, u8), [String; 5]>,
}

impl Column {
    /// Parses a dump in the format of [`Row`].
    pub(crate) fn of_dump(target: &'static str, dump: &str, notes: Vec<Note>) -> Self {
        let cells = dump.lines().map(cell).collect::<Option<_>>();
        let cells = cells.unwrap_or_else(|| panic!("{target}: no dump\n{dump}"));
        Self { target, untold: &[], excuses: &[], notes, cells }
    }

    pub(crate) fn of_rows(target: &'static str, rows: &[Row], notes: Vec<Note>) -> Self {
        let dump: String = rows.iter().map(|row| format!("{row}\n")).collect();
        Self::of_dump(target, &dump, notes)
    }

    /// Whether a note of the target explains a difference.
    fn is_excused(&self, (index, sub): (u16, u8), aspect: Aspect) -> bool {
        let is_about = |part: &Part, message: &str| match *part {
            Part::Entry(of, at) => (of, at) == (index, sub),
            Part::Object(of) => of == index,
            Part::Device => message.contains(&format!("{index:04X}h")),
            _ => false,
        };
        let says = |text: &str| {
            self.notes.iter().any(|note| {
                note.message.contains(text) && note.places().any(|place| is_about(&place.part, &note.message))
            })
        };
        self.excuses.iter().any(|&(of, text)| of == aspect && says(text))
    }

    fn tells(&self, aspect: Aspect) -> bool {
        !self.untold.contains(&aspect)
    }
}

/// The address and the cell of a line.
fn cell(line: &str) -> Option<((u16, u8), [String; 5])> {
    let mut words = line.split(' ');
    let index = u16::from_str_radix(words.next()?, 16).ok()?;
    let sub = u8::from_str_radix(words.next()?, 16).ok()?;
    let (data_type, size, access) = (words.next()?, words.next()?, words.next()?);
    let (access, mapping) = access.split_at_checked(2)?;
    let cell = [data_type, size, access, mapping, words.next()?];
    words.next().is_none().then_some(((index, sub), cell.map(str::to_owned)))
}

/// Differences between two columns without a note.
fn differences(a: &Column, b: &Column) -> Vec<String> {
    let rows: BTreeSet<(u16, u8)> = a.cells.keys().chain(b.cells.keys()).copied().collect();
    let mut differences = Vec::new();
    let excused = |at, aspect| a.is_excused(at, aspect) || b.is_excused(at, aspect);
    for at in rows {
        let place = format!("{:04X}sub{:X}", at.0, at.1);
        let (in_a, in_b) = match (a.cells.get(&at), b.cells.get(&at)) {
            (Some(in_a), Some(in_b)) => (in_a, in_b),
            (in_a, _) if !excused(at, Aspect::Entry) => {
                let has = if in_a.is_some() { a } else { b };
                differences.push(format!("{place}: only {} has it", has.target));
                continue;
            }
            _ => continue,
        };
        for (aspect, (in_a, in_b)) in ASPECTS.into_iter().zip(in_a.iter().zip(in_b)) {
            if a.tells(aspect) && b.tells(aspect) && in_a != in_b && !excused(at, aspect) {
                let (a, b) = (a.target, b.target);
                differences.push(format!("{place}: {aspect:?}: `{in_a}` in {a}, `{in_b}` in {b}"));
            }
        }
    }
    differences
}

/// Compares all columns with each other; returns the number of compared cells.
pub(crate) fn agree(name: &str, columns: &[Column]) -> Result<usize, String> {
    let mut all = Vec::new();
    let mut pairs = 0;
    for (at, a) in columns.iter().enumerate() {
        for b in &columns[at + 1..] {
            all.extend(differences(a, b));
            pairs += a.cells.len().max(b.cells.len());
        }
    }
    all.truncate(20);
    if all.is_empty() { Ok(pairs) } else { Err(format!("{name}:\n{}", all.join("\n"))) }
}

#[test]
fn a_difference_without_a_note_is_seen() {
    let plain = |dump: &str| Column::of_dump("plain", dump, Vec::new());
    let other = |dump: &str| Column { target: "other", ..plain(dump) };
    let dump = "2000 00 05 1 rw-- 01\n2001 00 05 1 rwtp 02\n";
    assert_eq!(agree("same", &[plain(dump), other(dump), plain(dump)]), Ok(6));
    for (wrong, expected) in [
        ("2000 00 05 1 rw-- 01\n", "2001sub0: only plain has it"),
        (&*dump.replace("02\n", "03\n"), "2001sub0: Default: `02` in plain, `03` in other"),
        (&*dump.replace("rwtp", "rw-p"), "2001sub0: Mapping: `tp` in plain, `-p` in other"),
        (&*dump.replace("00 05 1 rw--", "00 06 2 rw--"), "2000sub0: Size: `1` in plain, `2` in other"),
    ] {
        let difference = agree("one", &[plain(dump), other(wrong)]).unwrap_err();
        assert!(difference.contains(expected), "{difference}");
    }
    let untold = Column { untold: &[Aspect::Mapping], ..plain(&dump.replace("rwtp", "rw--")) };
    assert_eq!(agree("untold", &[plain(dump), untold]), Ok(2));
}

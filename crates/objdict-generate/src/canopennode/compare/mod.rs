//! Compares existing tables of a project with generated ones: changes for the application, for stored values and on the
//! bus.

mod c_text;
mod layout;
#[cfg(feature = "stacks")]
pub(crate) mod rows;
mod tables;

use std::collections::{BTreeMap, BTreeSet};

use self::layout::{Located, located};
use self::tables::{ComparedMember, ComparedTables, ListedEntry};
use crate::{OutputFile, TableAspect, TableDifference};

/// The storage group whose values are lost without power.
const VOLATILE: &str = "OD_RAM";

/// Compares a header and its source with generated files; `None` if they are not tables of this stack.
pub(crate) fn compare(header: &str, source: &str, made: &[OutputFile]) -> Option<Vec<TableDifference>> {
    let [new_header, new_source] = texts(made)?;
    let old = TableSide::new(ComparedTables::read(header, source));
    let new = TableSide::new(ComparedTables::read(new_header, new_source));
    if old.tables.groups.is_empty() && old.tables.objects.is_empty() {
        return None;
    }
    let sides = Sides { renamed: renamed(&old, &new), old, new };
    let parts = [sides.names(), sides.macros(), sides.layout(), sides.objects(), sides.values()];
    Some(parts.into_iter().flatten().collect())
}

/// The first header and the first source of generated files.
fn texts(made: &[OutputFile]) -> Option<[&str; 2]> {
    let text = |ending: &str| {
        let file = made.iter().find(|file| file.path.ends_with(ending))?;
        std::str::from_utf8(&file.contents).ok()
    };
    Some([text(".h")?, text(".c")?])
}

/// Tables, and their variables by name, with the group of each.
struct TableSide {
    tables: ComparedTables,
    variables: BTreeMap<String, (String, Located)>,
}

impl TableSide {
    fn new(tables: ComparedTables) -> Self {
        let mut variables = BTreeMap::new();
        for (group, members) in &tables.groups {
            let placed = located(members).0.into_iter();
            variables.extend(placed.map(|variable| (variable.path.clone(), (group.clone(), variable))));
        }
        Self { tables, variables }
    }

    /// The initial value of a variable: 0 if none is written.
    fn start_value(&self, group: &str, path: &str) -> String {
        self.tables.values.get(&format!("{group}.{path}")).cloned().unwrap_or_else(|| "0".to_owned())
    }
}

/// Old names by new ones: same object, position in it and type, if the old name no longer exists.
fn renamed(old: &TableSide, new: &TableSide) -> BTreeMap<String, String> {
    fn only_in<'s>(side: &'s TableSide, other: &'s TableSide) -> impl Iterator<Item = &'s Located> {
        let variables = side.variables.iter().filter(|(path, _)| !other.variables.contains_key(*path));
        variables.map(|(_, (_, variable))| variable)
    }
    let added: BTreeMap<_, _> = only_in(new, old)
        .map(|variable| ((&variable.object, &variable.declaration), &variable.path))
        .collect();
    let former = only_in(old, new);
    let pair = |variable: &Located| {
        let name = added.get(&(&variable.object, &variable.declaration))?;
        Some((variable.path.clone(), (*name).clone()))
    };
    former.filter_map(pair).collect()
}

struct Sides {
    old: TableSide,
    new: TableSide,
    /// The new names of old variables.
    renamed: BTreeMap<String, String>,
}

impl Sides {
    /// The name of an old variable in the new tables.
    fn new_name<'s>(&'s self, path: &'s str) -> &'s str {
        self.renamed.get(path).map_or(path, |name| name)
    }

    /// Variables with a different name, group or type, removed ones and new ones.
    fn names(&self) -> Vec<TableDifference> {
        let mut found = Vec::new();
        let mut add = |place: String, old, new| {
            found.push(TableDifference { aspect: TableAspect::Names, place, old, new });
        };
        for (path, (group, variable)) in &self.old.variables {
            let (place, name) = (format!("{group}.{path}"), self.new_name(path));
            match self.new.variables.get(name) {
                None => add(place, Some(variable.declaration.clone()), None),
                Some((other_group, other)) => {
                    let other_place = format!("{other_group}.{name}");
                    if place != other_place {
                        let (place, other_place) = without_member(&place, &other_place);
                        add(place.to_owned(), Some(place.to_owned()), Some(other_place.to_owned()));
                    }
                    if variable.declaration != other.declaration {
                        add(place, Some(variable.declaration.clone()), Some(other.declaration.clone()));
                    }
                }
            }
        }
        let taken: BTreeSet<&String> = self.renamed.values().collect();
        for (path, (group, variable)) in &self.new.variables {
            if !self.old.variables.contains_key(path) && !taken.contains(path) {
                add(format!("{group}.{path}"), None, Some(variable.declaration.clone()));
            }
        }
        found.dedup(); // a record that moves has a difference for each member
        found
    }

    /// Names of entries that applications use, and numbers of objects for which the stack is compiled.
    fn macros(&self) -> Vec<TableDifference> {
        let (old, new) = (&self.old.tables.macros, &self.new.tables.macros);
        let names: BTreeSet<&String> = old.keys().chain(new.keys()).collect();
        // the value of the others is a list position
        let shown = |name: &str, value: Option<&String>| match name.starts_with("OD_CNT_") {
            true => value.cloned(),
            false => value.map(|_| "defined".to_owned()),
        };
        let differences = names.into_iter().map(|name| TableDifference {
            aspect: TableAspect::Names,
            place: name.clone(),
            old: shown(name, old.get(name)),
            new: shown(name, new.get(name)),
        });
        differences.filter(|difference| difference.old != difference.new).collect()
    }

    /// The first variable of each stored group whose location changes, or the size of the group.
    fn layout(&self) -> Vec<TableDifference> {
        let stored = self.old.tables.groups.iter().filter(|(group, _)| *group != VOLATILE);
        let difference = |(group, members): (&String, &Vec<ComparedMember>)| {
            let (old, old_size) = located(members);
            let at = |variable: &Located| match variable.offset {
                Some(offset) => format!("{} {} at byte {offset}", variable.declaration, variable.path),
                None => format!("{} {}", variable.declaration, variable.path),
            };
            let bytes = |size: Option<u64>| size.map(|size| format!("{size} bytes"));
            let (old, new) = match self.new.tables.groups.get(group) {
                None => (bytes(old_size), None),
                Some(others) => {
                    let (new, new_size) = located(others);
                    let moved = old.iter().zip(&new).find(|(one, other)| {
                        let is_same = (one.offset, &one.declaration) == (other.offset, &other.declaration);
                        !is_same || self.new_name(&one.path) != other.path
                    });
                    match moved {
                        Some((one, other)) => (Some(at(one)), Some(at(other))),
                        None => (bytes(old_size), bytes(new_size)),
                    }
                }
            };
            TableDifference { aspect: TableAspect::Layout, place: group.clone(), old, new }
        };
        stored.map(difference).filter(|difference| difference.old != difference.new).collect()
    }

    /// Objects, sub-indexes, flags and lengths that the stack serves.
    fn objects(&self) -> Vec<TableDifference> {
        let (old, new) = (&self.old.tables.objects, &self.new.tables.objects);
        let mut found = Vec::new();
        let mut add = |place: String, old, new| {
            if old != new {
                found.push(TableDifference { aspect: TableAspect::Objects, place, old, new });
            }
        };
        let indexes: BTreeSet<u16> = old.keys().chain(new.keys()).copied().collect();
        for index in indexes {
            let (before, after) = (old.get(&index), new.get(&index));
            let [was, is] = [before, after]
                .map(|object| object.map(|object| format!("{} with {} entries", object.kind, object.count)));
            add(format!("{index:04X}h"), was, is);
            let (Some(before), Some(after)) = (before, after) else { continue };
            if before.kind != after.kind {
                continue;
            }
            for (sub, entry) in &before.entries {
                if let Some(other) = after.entries.get(sub) {
                    let [was, is] = differing(entry, other).map(Some);
                    add(format!("{index:04X}h:{sub:02X}"), was, is);
                }
            }
        }
        found
    }

    /// Values that the device starts with.
    fn values(&self) -> Vec<TableDifference> {
        let difference = |(path, (group, _)): (&String, &(String, Located))| {
            let name = self.new_name(path);
            let (new_group, _) = self.new.variables.get(name)?;
            let (old, new) = (self.old.start_value(group, path), self.new.start_value(new_group, name));
            let place = format!("{group}.{path}");
            (old != new).then_some(TableDifference {
                aspect: TableAspect::Values,
                place,
                old: Some(old),
                new: Some(new),
            })
        };
        self.old.variables.iter().filter_map(difference).collect()
    }
}

/// Two paths of a member, shortened to the record if the member itself has kept its name.
fn without_member<'p>(old: &'p str, new: &'p str) -> (&'p str, &'p str) {
    let of_record = |place: &'p str| place.rsplit_once('.').filter(|(record, _)| record.contains('.'));
    match (of_record(old), of_record(new)) {
        (Some((record, member)), Some((new_record, new_member))) if member == new_member => {
            (record, new_record)
        }
        _ => (old, new),
    }
}

/// The differing properties of an entry.
fn differing(old: &ListedEntry, new: &ListedEntry) -> [String; 2] {
    let is_other = [old.flags != new.flags, old.length != new.length, old.has_value != new.has_value];
    [old, new].map(|entry| {
        let flags = if entry.flags.is_empty() { "no flags".to_owned() } else { entry.flags.join(" | ") };
        let memory = if entry.has_value { "with a value" } else { "without a value" };
        let texts = [flags, format!("{} bytes", entry.length), memory.to_owned()];
        let shown = texts.into_iter().zip(is_other).filter(|(_, is_other)| *is_other).map(|(text, _)| text);
        shown.collect::<Vec<_>>().join(", ")
    })
}

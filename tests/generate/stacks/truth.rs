//! The expected entries of a device in every stack, derived from the model alone.

use std::collections::HashSet;
use std::fmt;

use objdict::model::{Device, PdoMapping, TypeKind};

use crate::oracle::{facts_of, hex};

/// An entry.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) index: u16,
    pub(crate) sub: u8,
    /// The code of the data type in CiA 301; 0 for a device-specific type, `None` if the stack does not store
    /// it.
    pub(crate) data_type: Option<u16>,
    /// `None` for a device-specific type.
    pub(crate) kind: Option<TypeKind>,
    /// Maximum size of a value in bytes; `None` if the stack does not store it.
    pub(crate) size: Option<usize>,
    pub(crate) read: bool,
    pub(crate) write: bool,
    pub(crate) tpdo: bool,
    pub(crate) rpdo: bool,
    /// The initial value, little-endian; `None` if the stack does not store it.
    pub(crate) default: Option<Vec<u8>>,
}

/// `index sub type size access default`, with `-` for missing or empty values: `2000 00 07 4 rwtp 01000000`.
impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let data_type = self.data_type.map_or("-".to_owned(), |code| format!("{code:02X}"));
        let size = self.size.map_or("-".to_owned(), |size| size.to_string());
        let flags = [(self.read, 'r'), (self.write, 'w'), (self.tpdo, 't'), (self.rpdo, 'p')];
        let access: String = flags.map(|(has, letter)| if has { letter } else { '-' }).iter().collect();
        let default = self.default.as_deref().map_or("-".to_owned(), hex);
        write!(f, "{:04X} {:02X} {data_type} {size} {access} {default}", self.index, self.sub)
    }
}

/// A property that a stack cannot express, and its replacement. The table of a stack is as short as possible.
pub(crate) struct Lack {
    /// The description for readers of the table.
    pub(crate) what: &'static str,
    /// Selects the affected entries.
    pub(crate) of: fn(&Row) -> bool,
    /// The replacement; `None` for nothing.
    pub(crate) instead: fn(Row) -> Option<Row>,
}

/// All entries of a device for a node, by index and sub-index.
pub(crate) fn truth(device: &Device, node_id: u8) -> Vec<Row> {
    facts_of(device)
        .map(|((index, sub), facts)| {
            let carried = |mappings: &[PdoMapping]| mappings.contains(&facts.mapping);
            let tpdo = carried(&[PdoMapping::Optional, PdoMapping::Default, PdoMapping::Tpdo]);
            let rpdo = carried(&[PdoMapping::Optional, PdoMapping::Default, PdoMapping::Rpdo]);
            Row {
                index,
                sub,
                data_type: Some(facts.kind.map_or(0, |_| facts.data_type.0)),
                kind: facts.kind,
                size: Some(facts.size),
                read: facts.access.is_readable(),
                write: facts.access.is_writable(),
                tpdo: tpdo && facts.access.fits_tpdo(),
                rpdo: rpdo && facts.access.fits_rpdo(),
                default: Some(facts.default_on(node_id)),
            }
        })
        .collect()
}

/// The expected entries of a stack with limitations.
pub(crate) fn without(lacks: &[Lack], rows: Vec<Row>) -> Vec<Row> {
    assert!(lacks.iter().all(|lack| !lack.what.is_empty()));
    let instead = |row: Row| {
        lacks.iter().try_fold(row, |row, lack| if (lack.of)(&row) { (lack.instead)(row) } else { Some(row) })
    };
    rows.into_iter().filter_map(instead).collect()
}

/// Reports the first lines of a harness that differ from the expected entries.
pub(crate) fn compare(name: &str, expected: &[Row], output: &str) -> Result<(), String> {
    let expected: Vec<String> = expected.iter().map(Row::to_string).collect();
    let dumped: Vec<&str> = output.lines().collect();
    let known: HashSet<&str> = expected.iter().map(String::as_str).collect();
    let seen: HashSet<&str> = dumped.iter().copied().collect();
    let missing = expected.iter().filter(|row| !seen.contains(row.as_str()));
    let missing = missing.map(|row| format!("expected: {row}")).take(5);
    let surplus = dumped.iter().filter(|row| !known.contains(*row));
    let surplus = surplus.map(|row| format!("dumped:   {row}")).take(5);
    let differences: Vec<String> = missing.chain(surplus).collect();
    if !differences.is_empty() {
        return Err(format!("{name}:\n{}", differences.join("\n")));
    }
    if expected != dumped {
        return Err(format!("{name}: the entries are not in ascending order, or some stand there twice"));
    }
    Ok(())
}

#[test]
fn the_truth_has_one_line_each() {
    let no_times = Lack {
        what: "no mapping, and times without data",
        of: |row| row.kind == Some(TypeKind::TimeOfDay),
        instead: |row| Some(Row { default: None, rpdo: false, ..row }),
    };
    let rows = without(&[no_times], truth(&crate::odd::device(), 5));
    let line = |index| rows.iter().find(|row| row.index == index).map(Row::to_string).unwrap();
    assert_eq!(line(0x3104), "3104 00 06 2 rw-- 8501");
    assert_eq!(line(0x3306), "3306 01 0C 6 rw-- -");
    let dump = rows.iter().map(|row| format!("{row}\n")).collect::<String>();
    assert_eq!(compare("odd", &rows, &dump), Ok(()));
    let wrong = compare("odd", &rows, &dump.replace("3104 00 06 2", "3104 00 06 4")).unwrap_err();
    assert!(wrong.contains("3104 00 06 2") && wrong.contains("3104 00 06 4"), "{wrong}");
}

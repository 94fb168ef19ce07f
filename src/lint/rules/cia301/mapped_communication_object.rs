use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{expected, rule, with_others};
use crate::model::{Access, DataType, Device, Field, Object};
use crate::profile::cia301;

rule! {
    /// a communication object that no PDO may carry is marked as mappable
    ///
    /// ## What it checks
    /// Whether `PDOMapping` is set at a communication object of CiA 301 other than 1001h, 1002h, 1013h, 1026h and the COB-IDs of SDOs, which CiA 301 calls mappable although nobody maps them.
    ///
    /// ## Why it matters
    /// A configuration tool offers the object for a PDO; the device refuses the mapping, or a received PDO changes the communication of the node.
    ///
    /// ## Example
    /// `[1017]` with `PDOMapping=1`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/mapped-communication-object", Warning, Object(check)
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let marked = expected(index, object).filter(|at| at.entry.is_mappable() && !at.facts.mappable);
    // constants and texts are never mappable, which is a rule of its own
    let marked = marked.filter(|at| {
        let length = at.entry.data_type.and_then(DataType::bit_length);
        at.entry.access != Some(Access::Const) && length.is_some()
    });
    let mut places = marked.map(|at| at.place().field(Field::PdoMapping));
    let Some(first) = places.next() else { return };
    let name = cia301::object(index).map_or("", |facts| facts.name);
    let message = format!("{index:04X}h ({name}) is marked as mappable, CiA 301 lets no PDO carry it");
    let finding = Diagnostic::new(&RULE.info, first, message).help("write `PDOMapping=0`");
    findings.push(with_others(finding, places.map(|place| (place, "here too".to_owned()))));
}

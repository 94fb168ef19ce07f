//! Entries, compared with a document.

use super::objects::set;
use super::{Against, Expected};
use crate::diagnostic::{Argument, Diagnostic, Findings, RuleInfo, joined, say};
use crate::model::{Access, DataType, Field, ObjectType, Part, TypeKind};
use crate::profile::Mapping;

/// A data type that the document does not allow. Sub-index 0 has its own rule.
fn wrong_type(at: &Expected<'_>) -> Option<DataType> {
    let wrong = at.entry.data_type.filter(|&data_type| !at.counts() && !at.facts.accepts_type(data_type));
    // other rules report a type that does not exist or that an entry cannot have
    let exists = |data_type: &DataType| match data_type.kind() {
        TypeKind::Reserved | TypeKind::Structure => false,
        TypeKind::Defined => at.against.device.objects.contains_key(&data_type.0),
        _ => true,
    };
    wrong.filter(exists)
}

/// Whether both the data type and the name of an object show that it is not the profile's, but a vendor's object at the
/// same index: `Digital input` with BOOLEANs at 6400h, the analogue inputs.
pub(super) fn is_other_object(at: &Expected<'_>) -> bool {
    if at.against.index < 0x6000 || wrong_type(at).is_none() {
        return false;
    }
    let (name, known) = (at.against.object.name().to_lowercase(), at.against.facts.name.to_lowercase());
    let words = name.split(|char: char| !char.is_alphabetic()).filter(|word| word.len() > 2);
    // plurals, and words without spaces: `ReadAnalogInput16Bit`
    let is_known = |word: &str| {
        let mut parts = known.split(|char: char| !char.is_alphabetic()).filter(|part| part.len() > 2);
        known.contains(word) || parts.any(|part| word.contains(part))
    };
    let (named, all) =
        words.fold((0, 0), |(named, all), word| (named + usize::from(is_known(word)), all + 1));
    all > 0 && named * 2 <= all
}

/// Reports a different data type.
pub(crate) fn wrong_data_type(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let Some(data_type) = wrong_type(at) else { return };
    let types = joined(at.facts.data_types, " or ");
    let document = at.document();
    let message = say!("{} has data type `{}`; {} requires {!}", at, data_type, document, types);
    let finding = Diagnostic::new(rule, at.place().field(Field::DataType), message);
    let required = at.facts.data_types.first().copied().unwrap_or(DataType(0));
    let code = format!("0x{:04X}", required.0);
    let help = say!("write `{}`", Argument::setting(Field::DataType, &code));
    let is_other = is_other_object(at);
    if is_other && at.against.entries().find(is_other_object).is_some_and(|first| first.sub != at.sub) {
        return;
    }
    let finding = finding.help(match is_other {
        true => say!("move the object to 2000h to 5FFFh, or {} if it is {}", help, at.against),
        false => help,
    });
    // other rules reject a number outside its range, and a VAR with the type DOMAIN
    let is_var =
        at.sub.is_none() && at.entry.object_type.is_none_or(|object_type| object_type == ObjectType::Var);
    let is_clear = !is_other && at.entry.fits_type(required) && !(is_var && required == DataType::DOMAIN);
    let fix = is_clear.then(|| set(at.place(), Field::DataType, code));
    findings.push(Diagnostic { fix, ..finding });
}

/// Reports a different access type. A vendor object at the index of a profile object has only one finding,
/// about its data type.
pub(crate) fn wrong_access(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let wrong = at.entry.access.filter(|&access| !at.facts.accepts_access(access));
    // the access type of a compactly stored object may be intended for sub-index 0
    let for_sub_0 = |access: &Access| {
        let facts = at.against.facts.entry(0);
        at.sub.is_none()
            && at.against.object.compact.is_some()
            && facts.is_some_and(|facts| facts.accepts_access(*access))
    };
    let Some(access) = wrong.filter(|access| !for_sub_0(access) && !is_other_object(at)) else { return };
    // older editions have `ro`
    let is_const =
        at.facts.access == [Access::Ro] && (at.counts() || matches!(at.against.index, 0x1008..=0x100A));
    let allowed = if is_const { &[Access::Const, Access::Ro] } else { at.facts.access };
    let first = allowed.first().map_or("ro", |access| access.name());
    let allowed = joined(allowed.iter().map(|access| say!("`{}`", access)), " or ");
    let document = at.document();
    let message = say!("{} has access type `{}`; {} requires {!}", at, access, document, allowed);
    let finding = Diagnostic::new(rule, at.place().field(Field::AccessType), message);
    let finding = finding.help(say!("write `{}`", Argument::setting(Field::AccessType, first)));
    findings.push(finding.fix(set(at.place(), Field::AccessType, first.to_owned())));
}

/// Reports entries that are marked as mappable although the document does not allow them in a PDO.
pub(crate) fn wrong_mapping(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let marked = at.entries().filter(|at| at.entry.is_mappable() && at.facts.mapping == Some(Mapping::No));
    // sub-index 0 of an ARRAY or RECORD is harmless, because it is never mapped
    let marked = marked.filter(|at| !at.counts() && !is_other_object(at));
    // another rule reports constants and strings, which are never mappable
    let marked = marked.filter(|at| {
        let length = at.entry.data_type.and_then(DataType::bit_length);
        at.entry.access != Some(Access::Const) && length.is_some()
    });
    for entry in marked {
        let what = match entry.place().part {
            Part::Entry(..) => say!("{}", entry),
            _ => say!("{}", at),
        };
        let document = at.applied.document();
        let message = say!("{} is marked as mappable; {} does not allow it in a PDO", what, document);
        let fix = set(entry.place(), Field::PdoMapping, "0".to_owned());
        let place = entry.place().field(Field::PdoMapping);
        findings.push(Diagnostic::new(rule, place, message).help(say!("write `{PDOMapping=0}`")).fix(fix));
    }
}

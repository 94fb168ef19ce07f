//! Bits of values, compared with a document.

use super::Expected;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say, series, series_or};
use crate::model::DataType;
use crate::profile::{BitFieldFacts, device_type_index};
use crate::stated;

/// Reports set bits that the document does not define.
pub(crate) fn reserved_bits(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let Some(value) = value(at) else { return };
    let reserved = value & !at.facts.bits().fold(0, |known, field| known | mask(&field));
    if reserved == 0 {
        return;
    }
    let bits: Vec<u32> = (0..64).filter(|bit| reserved >> bit & 1 == 1).collect();
    let (noun, verb, them) = if bits.len() == 1 { ("bit", "is", "it") } else { ("bits", "are", "them") };
    let document = at.document();
    let message = say!("{} {} of {} {} set; {} reserves {}", noun, series(bits), at, verb, document, them);
    let place = at.place().field(at.value_field());
    let digits =
        at.entry.data_type.and_then(DataType::bit_length).map_or(0, |bits| usize::from(bits).div_ceil(4));
    let cleared = format!("0x{:0digits$X}", value & !reserved);
    let finding = Diagnostic::new(rule, place.clone(), message).help(say!("write `{}`", cleared));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", cleared)).set(place, cleared)));
}

/// Reports a group of bits with a value that the document does not define.
pub(crate) fn undefined_field_value(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let Some(value) = value(at) else { return };
    for field in at.facts.bits().filter(|field| field.meanings().len() > 0) {
        if field.meaning(value).is_some() {
            continue;
        }
        let bits = match (field.first, field.last) {
            (first, last) if first == last => say!("bit {}", first),
            (first, last) => say!("bits {} to {}", first, last),
        };
        let message = say!(
            "`{}` is not a value that {} defines for {} ({} of {})",
            field.of(value),
            at.document(),
            field.name,
            bits,
            at
        );
        let known = field.meanings().map(|(range, meaning)| say!("{} ({})", range.start(), meaning));
        let finding = Diagnostic::new(rule, at.place().field(at.value_field()), message);
        findings.push(finding.help(say!("write {}", series_or(known))));
    }
}

/// The value of the bits; `None` if another rule covers it, and for 1000h if each logical device has its own
/// type.
fn value(at: &Expected<'_>) -> Option<u64> {
    let against = &at.against;
    let is_type_of_all =
        against.index == 0x1000 && device_type_index(against.device, against.applied.block) != 0x1000;
    if at.facts.bits().len() == 0 || at.counts() || is_type_of_all {
        return None;
    }
    let [node_id, _] = stated::node_ids(against.device);
    let value = at.entry.value()?.integer_for(node_id)?;
    u64::try_from(value).ok().filter(|_| at.facts.accepts_value(value))
}

fn mask(field: &BitFieldFacts<'_>) -> u64 {
    field.of(u64::MAX).checked_shl(field.first.into()).unwrap_or(0)
}

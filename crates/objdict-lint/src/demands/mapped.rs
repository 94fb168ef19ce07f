//! Objects in PDOs, compared with a document.

use super::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::PdoKind;
use crate::profile::Mapping;
use crate::{Facts, MappedTo};

/// Reports a PDO that maps an entry that the document defines for the other direction, although its access
/// type allows it.
pub(crate) fn mapped_in_wrong_direction(
    rule: &'static RuleInfo,
    facts: &Facts<'_>,
    applied: &Applied<'_>,
    findings: &mut Findings,
) {
    for pdo in &facts.pdos {
        for mapped in &pdo.mapped {
            let (index, sub) = (mapped.object.index, mapped.object.sub);
            let MappedTo::Entry(entry) = &mapped.target else { continue };
            let expected = applied.profile.object_in(applied.block, index);
            let Some(expected) = expected.and_then(|object| object.entry(sub)) else { continue };
            let right = match expected.mapping {
                Some(Mapping::Tpdo) => PdoKind::Tpdo,
                Some(Mapping::Rpdo) => PdoKind::Rpdo,
                _ => continue,
            };
            // another rule reports conflicts with the entry itself
            if right == pdo.pdo.kind || !entry.is_mappable() || !entry.fits_pdo(pdo.pdo.kind) {
                continue;
            }
            let message = say!(
                "{} maps {:04X}h:{:02X} ({}), which {} defines for {!}s",
                pdo.pdo,
                index,
                sub,
                expected.name,
                applied.document(),
                right.name()
            );
            let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
            let finding = Diagnostic::new(rule, place, message);
            findings.push(finding.help(say!("map the object to a {}", right.name())));
        }
    }
}

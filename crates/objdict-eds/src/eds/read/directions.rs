//! The meaning of `rwr` and `rww` in files of CANopenEditor: some versions swap them in an EDS, so the default mapping
//! decides.

use std::collections::BTreeSet;

use crate::diagnostic::Findings;
use crate::eds::findings;
use crate::model::{Access, Device, Entry, Object, PdoKind, PdoMapping};

/// Allows both directions for entries that are mapped by default in the direction that their access type excludes, if
/// the editor wrote the file.
pub(super) fn unite(device: &mut Device, findings: &mut Findings) {
    if !is_of_editor(device) {
        return;
    }
    let mapped: BTreeSet<(u16, u8, PdoKind)> = device
        .pdos()
        .flat_map(|pdo| pdo.mapped().map(|object| (object.index, object.sub, pdo.kind)).collect::<Vec<_>>())
        .collect();
    let mut united = Vec::new();
    for (index, sub, kind) in mapped {
        let entry = device.objects.get_mut(&index).and_then(|object| entry_mut(object, sub));
        let excluded = match kind {
            PdoKind::Rpdo => Access::Rwr,
            PdoKind::Tpdo => Access::Rww,
        };
        let is_mappable = |entry: &Entry| entry.pdo_mapping == Some(PdoMapping::Optional);
        if let Some(entry) = entry.filter(|entry| entry.access == Some(excluded) && is_mappable(entry)) {
            entry.access = Some(Access::Rw);
            united.push(((index, sub), kind, excluded));
        }
    }
    if let Some(&((index, sub), kind, access)) = united.first() {
        findings.push(findings::mapped_otherwise(device, (index, sub), (kind, access), united.len()));
    }
}

/// Whether the file contains the comments in which the editor stores the storage location of entries.
fn is_of_editor(device: &Device) -> bool {
    let is_stored = |entry: &Entry| entry.stack.as_ref().is_some_and(|stack| stack.storage_group.is_some());
    device.objects.values().any(|object| is_stored(&object.main))
}

fn entry_mut(object: &mut Object, sub: u8) -> Option<&mut Entry> {
    if sub == 0 && !object.object_type().has_subs() {
        return Some(&mut object.main);
    }
    object.subs.get_mut(sub)
}

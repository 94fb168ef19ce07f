//! The order of dcfgen (dcf-tools of lely-core), for managers whose files must remain comparable with its
//! output.

use super::{Arranger, EntryKey, INVALID, Stage};
use crate::download::Step;
use crate::download::settings::WritableEntries;

/// The services that dcfgen configures first, in its order.
const SERVICES: [u16; 6] = [0x1016, 0x1012, 0x1017, 0x100C, 0x100D, 0x1029];

/// Returns the steps that write every wanted entry: services, RPDOs, TPDOs, all others.
pub(in crate::download) fn arrange(settings: &mut WritableEntries<'_>) -> Vec<Step> {
    let mut wanted = settings.wanted();
    wanted.sort_by_key(|&key| rank(key));
    let mut arranger = Arranger { settings, steps: Vec::new() };
    for keys in wanted.chunk_by(|&a, &b| communication(a).is_some() && communication(a) == communication(b)) {
        match communication(keys[0]) {
            Some(communication) => arranger.pdo_of_dcfgen(communication),
            None => keys.iter().for_each(|&key| arranger.write(Stage::Pdo, key)),
        }
    }
    arranger.steps.into_iter().map(|(_, step)| step).collect()
}

/// The communication parameter of the PDO that an entry belongs to.
fn communication((index, _): EntryKey) -> Option<u16> {
    matches!(index, 0x1400..=0x1BFF).then_some(index & !0x0200)
}

/// The position of an entry in the order.
fn rank(key: EntryKey) -> (usize, u16, EntryKey) {
    if let Some(communication) = communication(key) {
        return (SERVICES.len(), communication, key);
    }
    let service = SERVICES.iter().position(|&index| index == key.0);
    (service.unwrap_or(SERVICES.len() + 1), 0, key)
}

impl Arranger<'_, '_> {
    /// Marks a PDO as not valid with its new CAN-ID, writes its parameters and its mapping, and marks it as
    /// valid.
    fn pdo_of_dcfgen(&mut self, communication: u16) {
        let cob_id = (communication, 1);
        let new = self.settings.target_number(cob_id);
        let present = self.settings.default_number(cob_id);
        if let Some(off) = new.map(|new| new | INVALID).filter(|&off| present != Some(off)) {
            self.put_number(Stage::Pdo, cob_id, off);
        }
        self.parameters(communication);
        self.mapping(Stage::Pdo, communication + 0x200);
        if let Some(new) = new.filter(|new| new & INVALID == 0) {
            self.put_number(Stage::Pdo, cob_id, new);
        }
    }
}

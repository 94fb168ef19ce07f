//! Values that CiA 301 reserves.

use super::NetworkCheck;
use crate::compiled::{PdoState, Slave, indexes};
use crate::diagnostic::{Diagnostic, Severity, say};
use crate::model::{CobId, PdoKind};
use crate::rules::INVALID_VALUE;

/// Whether an overflow value of the SYNC counter (1019h) is reserved.
pub(super) const fn is_reserved_overflow(overflow: u8) -> bool {
    matches!(overflow, 1 | 241..)
}

/// Whether the transmission type of a PDO is reserved. Transmission on request also qualifies, because
/// receivers cannot wait for it.
const fn is_reserved_type(state: &PdoState) -> bool {
    matches!((state.pdo.kind, state.transmission), (_, 241..=251) | (PdoKind::Rpdo, 252 | 253))
}

impl NetworkCheck<'_, '_> {
    pub(super) fn reserved(&mut self) {
        let compiled = self.compiled;
        for slave in compiled.nodes() {
            let overflow = slave.services().sync_counter_overflow;
            if let Some(overflow) = overflow.filter(|overflow| is_reserved_overflow(*overflow)) {
                let finding = self.reserved_value(slave, (0x1019, 0), overflow);
                self.findings.push(finding.help("write 0 for SYNC without a counter, or 2 to 240"));
            }
            let mut seen = Vec::new();
            let valid = slave.pdos.iter().filter(|state| state.cob_id & CobId::BIT_31 == 0);
            for state in valid.filter(|state| is_reserved_type(state)) {
                let at = (indexes(state.pdo).0, 2);
                let said = slave.said(at.0, at.1);
                // the PDOs of a link have one type
                if said.is_some() && seen.contains(&said) {
                    continue;
                }
                seen.push(said);
                let finding = self.reserved_value(slave, at, state.transmission);
                let help = match state.pdo.kind {
                    PdoKind::Tpdo => {
                        "write 0 to 240 for synchronous, 254 or 255 for event-driven, 252 or 253 for requested PDOs"
                    }
                    PdoKind::Rpdo => "write 0 to 240 for synchronous, 254 or 255 for event-driven PDOs",
                };
                let finding = finding.help(help);
                let is_default = !self.is_needed(slave, state);
                self.findings.push(if is_default { finding.severity(Severity::Warning) } else { finding });
            }
        }
    }

    fn reserved_value(&self, slave: &Slave, (index, sub): (u16, u8), value: u8) -> Diagnostic {
        let name = &self.network.nodes[slave.node].name;
        let entry = if sub == 0 { say!("{:04X}h", index) } else { say!("{:04X}h:{:02X}", index, sub) };
        let message = say!("{} of `{}` is {}, which is reserved in CiA 301", entry, name.value, value);
        Diagnostic::new(&INVALID_VALUE, slave.said(index, sub).unwrap_or(name.at), message)
            .label_each(slave.origin(self.network, index, sub), "in the description")
            .understood()
    }
}

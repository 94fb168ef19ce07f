//! PDOs without a counterpart.

use super::NetworkCheck;
use crate::diagnostic::{Diagnostic, joined, say};
use crate::model::PdoKind;
use crate::rules::{RPDO_WITHOUT_SENDER, TPDO_WITHOUT_RECEIVER};
use crate::unlinked::{UnlinkedPdo, UnlinkedPdos};

/// The maximum number of CAN-IDs in a message.
const MAX_LISTED: usize = 8;

impl NetworkCheck<'_, '_> {
    /// PDOs that no other node sends or receives: one finding for each configured one, and one per node and direction
    /// for those that are valid by default.
    pub(super) fn unlinked(&mut self) {
        let UnlinkedPdos { configured, default } =
            UnlinkedPdos::new(self.network, self.compiled, self.messages);
        let single = configured.iter().map(|pdo| self.alone(pdo));
        // PDOs that `unused-pdos` cannot disable are reported separately
        let default = default.iter().filter(|((node, _), _)| self.network.switches_off(*node).is_none());
        let several = default.filter_map(|(_, pdos)| match pdos.as_slice() {
            [pdo] => Some(self.alone(pdo)),
            pdos => self.together(pdos),
        });
        let findings: Vec<_> = single.chain(several).collect();
        findings.into_iter().for_each(|finding| self.findings.push(finding));
    }

    fn alone(&self, UnlinkedPdo { can_id, pdo, party }: &UnlinkedPdo) -> Diagnostic {
        let described = self.described(party);
        // without a COB-ID the network file may state other parameters
        let name = self.network.nodes[party.node].name.at;
        let stated = || self.compiled.node(party.node)?.stated(self.network, *pdo);
        let at = if name == party.at { stated().unwrap_or(party.at) } else { party.at };
        let finding = match pdo.kind {
            PdoKind::Rpdo => {
                let message = format!("no node sends {can_id}, which {described} receives");
                Diagnostic::new(&RPDO_WITHOUT_SENDER, at, message)
                    .help("correct the CAN-ID, or switch the RPDO off")
            }
            PdoKind::Tpdo => {
                let message = format!("no node receives {can_id}, which {described} sends");
                Diagnostic::new(&TPDO_WITHOUT_RECEIVER, at, message)
                    .help("switch the TPDO off, or link its entries")
            }
        };
        finding.label_each(self.can_id_origin(*can_id, party), "the CAN-ID")
    }

    /// The PDOs of a node in one direction.
    fn together(&self, pdos: &[UnlinkedPdo]) -> Option<Diagnostic> {
        let first = pdos.first()?;
        let (rule, what) = match first.pdo.kind {
            PdoKind::Rpdo => (&RPDO_WITHOUT_SENDER, "wait for frames that no node sends"),
            PdoKind::Tpdo => (&TPDO_WITHOUT_RECEIVER, "send frames that no node receives"),
        };
        let listed = joined(pdos.iter().take(MAX_LISTED).map(|pdo| pdo.can_id.to_string()), ", ");
        let rest = if pdos.len() > MAX_LISTED { ", …" } else { "" };
        let name = self.name(&first.party);
        let message = say!("{} {}s of `{}` {}: {}{}", pdos.len(), first.pdo.kind, name, what, listed, rest);
        let finding = Diagnostic::new(rule, first.party.at, message)
            .label_each(self.can_id_origin(first.can_id, &first.party), "the CAN-ID of the first");
        Some(finding.help("link their entries, or switch them off by `unused-pdos = \"off\"` (network.toml)"))
    }
}

//! Downloads that a node rejects: each node receives them in order, as during boot-up.

use std::collections::BTreeSet;

use super::NetworkCheck;
use crate::compiled::Slave;
use crate::diagnostic::{At, Diagnostic, Severity, say};
use crate::download::{Objection, PlanError};
use crate::effective::switched_on;
use crate::model::PdoKind;
use crate::rules::REFUSED_DOWNLOAD;

impl NetworkCheck<'_, '_> {
    pub(super) fn downloads(&mut self) {
        // nodes that are already configured have the values that the manager stores
        if self.network.is_as_described {
            return;
        }
        for slave in &self.compiled.slaves {
            let device = switched_on(self.network, &self.network.nodes[slave.node]);
            match slave.sent(self.network.order) {
                Ok(downloads) => {
                    let verification = downloads.verify(&device, Some(slave.node_id));
                    // consequences of a rejected download of a PDO are rejected too
                    let mut seen = BTreeSet::new();
                    let first = verification.aborts().filter(|refused| seen.insert(group(refused.index)));
                    first.for_each(|refused| self.refused_download(slave, refused));
                }
                Err(error) => self.unsent(slave, &error),
            }
        }
    }

    fn refused_download(&mut self, slave: &Slave, refused: &Objection) {
        let (index, sub) = (refused.index, refused.sub);
        let name = &self.network.nodes[slave.node].name;
        let origin = slave.origin(self.network, index, sub);
        let own: Vec<At> = slave.said_of(index).chain(origin.clone()).collect();
        let is_known = |finding: &Diagnostic| {
            let mut labels = finding.labels.iter();
            finding.severity == Severity::Error && labels.any(|label| own.contains(&label.at))
        };
        if self.findings.iter().any(is_known) {
            return;
        }
        let message = say!(
            "`{}` rejects the download to {:04X}h:{:02X}: {}",
            name.value,
            index,
            sub,
            refused.kind.to_string()
        );
        let at = slave.said(index, sub).unwrap_or(name.at);
        let help =
            refused.kind.help().unwrap_or_else(|| "correct the value, or remove the setting".to_owned());
        let finding = Diagnostic::new(&REFUSED_DOWNLOAD, at, message).help(help);
        self.findings.push(finding.label_each(origin, "in the description").understood());
    }

    fn unsent(&mut self, slave: &Slave, error: &PlanError) {
        let node = &self.network.nodes[slave.node];
        let PlanError::Problems(problems) = error else { return };
        for problem in problems {
            let message = say!(
                "{} of `{}` cannot be sent: {}",
                problem.place.to_string(),
                node.name.value,
                problem.kind.to_string()
            );
            let place = At::Node(slave.node, problem.place.clone());
            let finding = Diagnostic::new(&REFUSED_DOWNLOAD, node.file.at, message).label(place, "the value");
            self.findings.push(finding.help("correct the description; `objdict check` shows where"));
        }
    }
}

/// The object, for a PDO its communication parameter.
fn group(index: u16) -> u16 {
    if PdoKind::of_mapping(index).is_some() { index & !0x0200 } else { index }
}

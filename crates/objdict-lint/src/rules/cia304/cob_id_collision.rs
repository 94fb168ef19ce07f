use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Srdo, rule};

rule! {
    "cia304/cob-id-collision", Error, Facts(check);
    summary: "two SRDOs of the device have the same COB-ID",
    checks: "Whether the COB-IDs of all active SRDOs (information direction 1 or 2) differ.",
    why: "The device cannot distinguish the two SRDOs; one that is sent disturbs one that is received.",
    example: "`[1301sub5]` and `[1302sub5]`, both with `DefaultValue=0x101`",
    remedy: "Give each SRDO its own pair of COB-IDs.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let mut seen: Vec<(i128, usize)> = Vec::new();
    for (at, srdo) in facts.srdos.iter().enumerate().filter(|(_, srdo)| srdo.is_on()) {
        // `invalid-cob-id-pair` checks that the second COB-ID follows the first
        let Some(cob_id) = srdo.cob_id(facts, 5) else { continue };
        let place = |at: usize| {
            let index = facts.srdos.get(at).map_or(0x1301, Srdo::communication_index);
            facts.device.value_place(index, 5)
        };
        match seen.iter().find(|(other, _)| *other == cob_id) {
            Some(&(_, first)) => {
                let message = say!(
                    "{} has the same COB-IDs as SRDO {}",
                    srdo,
                    facts.srdos.get(first).map_or(0, |srdo| srdo.number)
                );
                let finding =
                    Diagnostic::new(&RULE.info, place(at), message).label(place(first), "first used here");
                findings.push(finding.help("give each SRDO its own pair of COB-IDs"));
            }
            None => seen.push((cob_id, at)),
        }
    }
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Field, PdoKind, Place};
use crate::{Facts, PdoFacts, rule};

const RECEIVE: [&str; 3] = ["rpdo", "receive", "rxpdo"];
const TRANSMIT: [&str; 3] = ["tpdo", "transmit", "txpdo"];

rule! {
    "naming/wrong-pdo-direction", Warning, Pdo(check);
    summary: "the name of a PDO has the wrong direction",
    checks: "Whether names of RPDO objects (14xxh and 16xxh) mention only a transmit PDO or TPDO, or names of TPDO objects (18xxh and 1Axxh) only a receive PDO or RPDO.",
    why: "Users who configure the device by names configure the wrong PDO. Usually the object was copied.",
    example: "`ParameterName=Receive PDO 1 parameter` in `[1800]`",
    remedy: "Correct the name or the index.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",
}

fn check(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let (own, other) = match pdo.kind {
        PdoKind::Rpdo => (RECEIVE, TRANSMIT),
        PdoKind::Tpdo => (TRANSMIT, RECEIVE),
    };
    let objects = [(pdo.communication_index(), pdo.communication), (pdo.mapping_index(), pdo.mapping)];
    for (index, object) in objects.into_iter().filter_map(|(index, object)| Some((index, object?))) {
        let name = object.name();
        let says = |words: [&str; 3]| words.iter().any(|word| contains(name, word));
        if says(other) && !says(own) {
            let message = say!("{:04X}h belongs to {}, but is named `{}`", index, pdo, name);
            let place = Place::object(index).field(Field::ParameterName);
            findings.push(Diagnostic::new(&RULE.info, place, message).help("correct the name or the index"));
            return;
        }
    }
}

/// Whether a name contains a word, ignoring case.
fn contains(name: &str, word: &str) -> bool {
    name.as_bytes().windows(word.len()).any(|part| part.eq_ignore_ascii_case(word.as_bytes()))
}

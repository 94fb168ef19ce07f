use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Field, PdoKind, Place};
use crate::{Facts, PdoFacts, rule};

const RECEIVE: [&str; 3] = ["rpdo", "receive", "rxpdo"];
const TRANSMIT: [&str; 3] = ["tpdo", "transmit", "txpdo"];

rule! {
    "naming/wrong-pdo-direction", Warning, Pdo(check);
    summary: "a PDO is named after the other direction",
    checks: "Whether the names of the objects of RPDOs (14xxh and 16xxh) do not speak of a transmit PDO or TPDO only, and those of TPDOs (18xxh and 1Axxh) of a receive PDO or RPDO only.",
    why: "Whoever configures the device by the names configures the wrong PDO. Mostly the object was copied.",
    example: "`ParameterName=Receive PDO 1 parameter` in `[1800]`",
    remedy: "Correct the name, or the index.",
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
            let message = say!("{:04X}h is of {}, and is called `{}`", index, pdo, name);
            let place = Place::object(index).field(Field::ParameterName);
            findings.push(Diagnostic::new(&RULE.info, place, message).help("correct the name, or the index"));
            return;
        }
    }
}

/// Whether a name has a word in it, whatever the case of its letters.
fn contains(name: &str, word: &str) -> bool {
    name.as_bytes().windows(word.len()).any(|part| part.eq_ignore_ascii_case(word.as_bytes()))
}

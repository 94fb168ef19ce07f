use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/denotation", Note, Device(check);
    summary: "a denotation is lost to a tool",
    checks: "Whether an entry of a DCF has a `Denotation`. The first one is shown, others are named.",
    why: "python-canopen does not read it and writes files without it: the name in the application is gone.",
    example: "`Denotation=Pump 3`",
    remedy: "Repeat in `ParameterName` what a reader of the other tool must know.",
    source: "python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device)
        .filter(|(_, entry)| {
            entry.configured.as_ref().is_some_and(|configured| configured.denotation.is_some())
        })
        .map(|(place, _)| place.field(Field::Denotation));
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, say!("`{Denotation}` is not known to all tools"))
        .help(say!("repeat what matters in `{ParameterName}`"));
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

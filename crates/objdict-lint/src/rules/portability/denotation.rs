use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/denotation", Note, Device(check);
    summary: "a tool drops a denotation",
    checks: "Whether an entry of a DCF has a `Denotation`. The first one is shown with the others.",
    why: "python-canopen does not read the denotation and writes files without it: the application's name of the entry is lost.",
    example: "`Denotation=Pump 3`",
    remedy: "Repeat important denotations in `ParameterName`.",
    source: "python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device)
        .filter(|(_, entry)| {
            entry.configured.as_ref().is_some_and(|configured| configured.denotation.is_some())
        })
        .map(|(place, _)| place.field(Field::Denotation));
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, say!("not all tools read `{Denotation}`"))
        .help(say!("repeat important denotations in `{ParameterName}`"));
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

use crate::configured::Configured;
use crate::diagnostic::{Findings, say};
use crate::model::{Entry, Field, Value};
use crate::rule;

rule! {
    "configuration/different-limits", Warning, Configured(check);
    summary: "an entry of a configuration has other limits than in its EDS",
    checks: "Whether `LowLimit` and `HighLimit` of each entry of a DCF are those of its EDS, where both state them.",
    why: "A tool that checks values with the DCF accepts what the device rejects, or the reverse.",
    example: "`HighLimit=200` in the DCF, and `HighLimit=100` in the EDS",
    remedy: "Write the limit of the EDS, or check with the EDS of the device.",
    source: "CiA 306-1 §4.6.3.2, §5.3",
}

type Limit = fn(&Entry) -> Option<&Value>;

fn check(configured: &Configured<'_>, findings: &mut Findings) {
    let limits: [(Field, Limit); 2] = [
        (Field::LowLimit, |entry| entry.low_limit.as_ref()),
        (Field::HighLimit, |entry| entry.high_limit.as_ref()),
    ];
    for pair in configured.pairs() {
        for (field, limit) in &limits {
            let Some((is, original)) = limit(pair.entry).zip(limit(&pair.original)) else { continue };
            if configured.differ(is, original) {
                let message =
                    say!("`{}` of {} is {:h}, but {:h} in the {EDS}", field, pair.name(), is, original);
                let finding = configured.finding(&RULE.info, &pair, field.clone(), message);
                findings.push(finding.help(say!("write the limit of the {EDS}")));
            }
        }
    }
}

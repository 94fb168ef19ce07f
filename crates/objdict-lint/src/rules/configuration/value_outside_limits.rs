use std::cmp::Ordering;

use crate::configured::Configured;
use crate::diagnostic::{At, Diagnostic, Findings, say};
use crate::model::{Field, Place, Value};
use crate::{rule, stated};

rule! {
    "configuration/value-outside-limits", Error, Configured(check);
    summary: "a configured value is outside the limits of the EDS",
    checks: "Whether each `ParameterValue` of a DCF is between `LowLimit` and `HighLimit` of its EDS. A value outside the limits of the DCF itself is `cia306/value-outside-limits`.",
    why: "The device rejects the download with abort code 06090031h or 06090032h.",
    example: "`ParameterValue=150` in the DCF, and `HighLimit=100` in the EDS",
    remedy: "Configure a value that the device accepts.",
    source: "CiA 306-1 §4.6.3.2, §5.3.1",
}

fn check(configured: &Configured<'_>, findings: &mut Findings) {
    let node_id = configured.node_id();
    for pair in configured.pairs() {
        let Some(value) = pair.entry.configured_value() else { continue };
        let beyond = |limit: Option<&Value>, order| {
            limit.is_some_and(|limit| stated::compare(value, limit, node_id) == Some(order))
        };
        let original = &pair.original;
        let sides = [
            (Field::LowLimit, &pair.entry.low_limit, &original.low_limit, Ordering::Less),
            (Field::HighLimit, &pair.entry.high_limit, &original.high_limit, Ordering::Greater),
        ];
        let exceeded = sides
            .into_iter()
            .find(|(_, own, limit, order)| beyond(limit.as_ref(), *order) && !beyond(own.as_ref(), *order));
        // limits of a signature, not of what is read
        let Some((field, _, Some(limit), _)) = exceeded.filter(|_| !matches!(pair.index, 0x1010 | 0x1011))
        else {
            continue;
        };
        let message =
            say!("{} is configured as {:h}, but `{}` is {:h} in the {EDS}", pair.name(), value, field, limit);
        let place = configured.device.value_place(pair.index, pair.sub.unwrap_or_default());
        let finding = Diagnostic::new(&RULE.info, place, message);
        let sub = pair.sub.map_or(Place::object(pair.index), |sub| Place::entry(pair.index, sub));
        let finding = finding.label(At::Node(0, sub.field(field)), say!("in the {EDS}"));
        findings.push(finding.help("configure a value that the device accepts"));
    }
}

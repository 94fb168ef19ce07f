use crate::configured::{Configured, Pair};
use crate::diagnostic::{Findings, say};
use crate::model::Field;
use crate::rule;

rule! {
    "configuration/different-default", Warning, Configured(check);
    summary: "an entry of a configuration has another default than in its EDS",
    checks: "Whether each entry of a DCF has the `DefaultValue` of its EDS, where both state one. Formulas are evaluated for the node-ID of the DCF. The identity (1018h) is checked by other rules; of a coupler, what its modules change is not checked.",
    why: "Tools download what differs from the default. With another default in the DCF they leave out a value that the device does not have.",
    example: "`DefaultValue=100` in the DCF, and `DefaultValue=0` in the EDS",
    remedy: "Write the value as `ParameterValue`, and the default of the EDS as `DefaultValue`.",
    source: "CiA 306-1 §4.6.3.2, §5.3.1",
}

fn check(configured: &Configured<'_>, findings: &mut Findings) {
    // the modules of a coupler change the module list, and count in the arrays that they extend
    let is_of_modules =
        |pair: &Pair<'_>| configured.origin.is_modular() && (pair.index == 0x1027 || pair.sub == Some(0));
    for pair in configured.pairs().filter(|pair| pair.index != 0x1018 && !is_of_modules(pair)) {
        let Some((is, original)) = pair.entry.default.as_ref().zip(pair.original.default.as_ref()) else {
            continue;
        };
        if configured.differ(is, original) {
            let message = say!("the default of {} is {:h}, but {:h} in the {EDS}", pair.name(), is, original);
            let finding = configured.finding(&RULE.info, &pair, Field::DefaultValue, message);
            findings.push(
                finding.help(say!("write the value as `{ParameterValue}`, and the default of the {EDS}")),
            );
        }
    }
}

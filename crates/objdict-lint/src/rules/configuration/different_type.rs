use crate::configured::Configured;
use crate::diagnostic::{Findings, say};
use crate::model::Field;
use crate::rule;

rule! {
    "configuration/different-type", Error, Configured(check);
    summary: "an entry of a configuration has another data type than in its EDS",
    checks: "Whether each entry of a DCF has the `DataType` of its EDS, where both state one.",
    why: "A download has the length of the wrong type: the device rejects it with abort code 06070010h, or takes other bytes.",
    example: "`DataType=0x0005` in the DCF, and `DataType=0x0006` in the EDS",
    remedy: "Write the data type of the EDS, or check with the EDS of the device.",
    source: "CiA 306-1 §4.6.3.2, §5.3",
}

fn check(configured: &Configured<'_>, findings: &mut Findings) {
    for pair in configured.pairs() {
        let Some((is, original)) = pair.entry.data_type.zip(pair.original.data_type) else { continue };
        if is != original {
            let message = say!("{} has data type `{}`, but `{}` in the {EDS}", pair.name(), is, original);
            let finding = configured.finding(&RULE.info, &pair, Field::DataType, message);
            findings.push(finding.help(say!("write the data type of the {EDS}")));
        }
    }
}

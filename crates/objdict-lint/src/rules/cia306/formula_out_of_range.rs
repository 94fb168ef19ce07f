use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{DataType, Field, Value};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/formula-out-of-range", Error, Entry(check);
    summary: "a formula exceeds the range of its data type",
    checks: "Whether `$NODEID` plus the number fits the data type for every node-ID from 1 to 127, or, in a DCF, for the node-ID of the node.",
    why: "On some nodes the value is truncated, which gives a wrong COB-ID or node-ID.",
    example: "`DefaultValue=$NODEID+0x90` of an UNSIGNED8",
    remedy: "Choose a larger data type, or correct the number.",
    source: "CiA 306-1 §4.3",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let Some(data_type) = entry.data_type else { return };
    let fields = [
        (&Field::DefaultValue, entry.default.as_ref()),
        (&Field::LowLimit, entry.low_limit.as_ref()),
        (&Field::HighLimit, entry.high_limit.as_ref()),
        (&Field::ParameterValue, entry.configured_value()),
    ];
    for (field, value) in fields {
        if let Some(value @ Value::NodeId(_)) = value {
            check_formula(at, data_type, field, value, findings);
        }
    }
}

fn check_formula(
    at: &EntryAt<'_>,
    data_type: DataType,
    field: &Field,
    value: &Value,
    findings: &mut Findings,
) {
    let Some((_, highest)) = data_type.integer_range() else { return };
    let [_, node_id] = stated::node_ids(at.device);
    let Some(result) = value.integer_for(node_id).filter(|&result| result > highest) else { return };
    let message = say!(
        "`{}` is {} on node {}, but the maximum of {} is {}",
        value,
        result,
        node_id,
        data_type,
        highest
    );
    let finding = Diagnostic::new(&RULE.info, at.field(field.clone()), message)
        .label(at.field(Field::DataType), "the type");
    findings.push(finding.help("choose a larger data type, or correct the number"));
}

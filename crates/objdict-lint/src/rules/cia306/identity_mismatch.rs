use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, Severity, say};
use crate::model::{Device, Field, Part, Place, Value};
use crate::rule;

rule! {
    "cia306/identity-mismatch", Error, Device(check), fix Unsafe;
    summary: "`[DeviceInfo]` and the identity object disagree",
    checks: "Whether `VendorNumber`, `ProductNumber` and `RevisionNumber` equal 1018h sub-indexes 1, 2 and 3, where both values are given. In a DCF, the configured value counts before the default. The finding is a warning if one of the two is 0, because it was probably never filled in, and if only the configured value differs.",
    why: "A tool looks up the EDS by the values read from 1018h. With different numbers in `[DeviceInfo]`, the tool finds no EDS or the wrong one.",
    example: "`VendorNumber=0x59` and `DefaultValue=0x5A` in `[1018sub1]`",
    remedy: "Write the number that the device reports in both places.",
    source: "CiA 306-1 §4.5",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let numbers = [
        (1, Field::VendorNumber, info.vendor_number),
        (2, Field::ProductNumber, info.product_number),
        (3, Field::RevisionNumber, info.revision_number),
    ];
    for (sub, field, stated) in numbers {
        let (Some(stated), Some(entry)) = (stated, device.entry(0x1018, sub)) else { continue };
        let is_stated = |value: i128| value == i128::from(stated);
        let Some(value) = entry.value().and_then(Value::as_integer).filter(|&value| !is_stated(value)) else {
            continue;
        };
        // the value of one node, which a tool may have read from it
        let is_of_node = entry.default.as_ref().and_then(Value::as_integer).is_some_and(is_stated);
        let title = say!("write `{}`", Argument::setting(&field, format_args!("0x{value:X}")));
        // which of the two is right is the decision of the author
        let fix =
            Fix::risky(title).set(Place::of(Part::DeviceInfo).field(field.clone()), format!("0x{value:X}"));
        let message = say!("`{}` is {:h}, but 1018h sub-index {} is {:h}", field, stated, sub, value);
        let finding = Diagnostic::new(&RULE.info, Place::of(Part::DeviceInfo).field(field), message)
            .severity(if stated == 0 || value == 0 || is_of_node {
                Severity::Warning
            } else {
                Severity::Error
            })
            .label(device.value_place(0x1018, sub), "the identity object");
        let finding = finding.help("write the number that the device reports in both places");
        findings.push(if value > 0 { finding.fix(fix) } else { finding });
    }
}

use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Part, Place, Segment};
use crate::rule;

rule! {
    "cia306/dynamic-channels-flag", Error, Device(check), fix Unsafe;
    summary: "`DynamicChannelsSupported` and `[DynamicChannels]` disagree",
    checks: "Whether a device with dynamic channels describes their segments, and whether a device with described segments sets `DynamicChannelsSupported`.",
    why: "A programming tool places network variables in the segments. Without segments there is no place for them, and without the flag the tool does not look for segments.",
    example: "`DynamicChannelsSupported=1` without `[DynamicChannels]`",
    remedy: "Add the section with `NrOfSeg` and the segments, or write 0.",
    source: "CiA 306-1 §4.5, CiA 302-4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let supported = info.dynamic_channels_supported;
    let flag = Place::of(Part::DeviceInfo).field(Field::DynamicChannelsSupported);
    match (supported, &device.dynamic_channels) {
        (Some(number), None) if number > 0 => {
            let message =
                say!("`{DynamicChannelsSupported}` is {}, but `{[DynamicChannels]}` is missing", number);
            let fix = Fix::risky(say!("write `{DynamicChannelsSupported=0}`")).set(flag.clone(), "0");
            let finding = Diagnostic::new(&RULE.info, flag, message).fix(fix);
            findings.push(finding.help(say!("describe the segments in `{[DynamicChannels]}`, or write 0")));
        }
        (Some(0), Some(channels)) if !channels.segments.iter().all(Segment::is_empty) => {
            let message = say!("`{[DynamicChannels]}` has segments, but `{DynamicChannelsSupported}` is 0");
            let fix = Fix::risky(say!("write `{DynamicChannelsSupported=1}`")).set(flag.clone(), "1");
            let finding = Diagnostic::new(&RULE.info, flag, message)
                .fix(fix)
                .label(Place::of(Part::DynamicChannels), "segments");
            findings
                .push(finding.help(say!("write `{DynamicChannelsSupported=1}`, or remove the {section}")));
        }
        _ => {}
    }
}

//! Dynamic channels and their network variables.

use crate::diagnostic::{Findings, Fix, Severity, counted, listing_or, say};
use crate::model::{Device, DeviceKind, DynamicChannels, Field, Part, Place, Segment};
use crate::rule::rules;

rules! {
    "cia306/described-network-variable" = DESCRIBED_NETWORK_VARIABLE, Error,
        Device(described_network_variable);
    summary: "network variables of dynamic channels are described as objects",
    checks: "Whether the EDS of a device with dynamic channels describes objects A000h to AFFFh.",
    why: "The application program of such a device defines these objects; the EDS only describes their segments. Objects described in addition conflict with the program.",
    example: "`DynamicChannelsSupported=1` and `[A040]`",
    remedy: "Remove the objects, or write `DynamicChannelsSupported=0` if they never change.",
    source: "CiA 306-1 §4.6.3.4.3",

    "cia306/dynamic-channels-flag" = DYNAMIC_CHANNELS_FLAG, Error, Device(dynamic_channels_flag), fix Unsafe;
    summary: "`DynamicChannelsSupported` and `[DynamicChannels]` disagree",
    checks: "Whether a device with dynamic channels describes their segments, and whether a device with described segments sets `DynamicChannelsSupported`.",
    why: "A programming tool places network variables in the segments. Without segments there is no place for them, and without the flag the tool does not look for segments.",
    example: "`DynamicChannelsSupported=1` without `[DynamicChannels]`",
    remedy: "Add the section with `NrOfSeg` and the segments, or write 0.",
    source: "CiA 306-1 §4.5, CiA 302-4",

    "cia306/invalid-segment" = INVALID_SEGMENT, Error, Device(invalid_segment);
    summary: "a segment of the dynamic channels is not valid",
    checks: "Whether each segment has type, direction and range, whether the range is within A000h to BFFFh in ascending order, and whether ranges overlap.",
    why: "A programming tool takes the indexes of network variables from these ranges.",
    example: "`Range1=0xA0BF-0xA080`",
    remedy: "Write the first and last index: `Range1=0xA080-0xA0BF`.",
    source: "CiA 302-4, CiA 306-1 §4.6.3.4.3",
}

fn described_network_variable(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    if device.kind == DeviceKind::Node || info.dynamic_channels_supported.is_none_or(|number| number == 0) {
        return;
    }
    let mut variables = device.objects.range(0xA000..=0xAFFF);
    let Some((&first, _)) = variables.next() else { return };
    let objects = counted(1 + variables.count(), "object is", "objects are");
    let message = say!("the device has dynamic channels, but {} described in A000h to AFFFh", objects);
    let finding = DESCRIBED_NETWORK_VARIABLE
        .at(Place::object(first), message)
        .label(Place::of(Part::DeviceInfo).field(Field::DynamicChannelsSupported), "dynamic channels");
    findings.push(finding.help(say!("remove the objects, or write `{DynamicChannelsSupported=0}`")));
}

fn dynamic_channels_flag(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let supported = info.dynamic_channels_supported;
    let flag = Place::of(Part::DeviceInfo).field(Field::DynamicChannelsSupported);
    match (supported, &device.dynamic_channels) {
        (Some(number), None) if number > 0 => {
            let message =
                say!("`{DynamicChannelsSupported}` is {}, but `{[DynamicChannels]}` is missing", number);
            let fix = Fix::risky(say!("write `{DynamicChannelsSupported=0}`")).set(flag.clone(), "0");
            let finding = DYNAMIC_CHANNELS_FLAG.at(flag, message).fix(fix);
            findings.push(finding.help(say!("describe the segments in `{[DynamicChannels]}`, or write 0")));
        }
        (Some(0), Some(channels)) if !channels.segments.iter().all(Segment::is_empty) => {
            let message = say!("`{[DynamicChannels]}` has segments, but `{DynamicChannelsSupported}` is 0");
            let fix = Fix::risky(say!("write `{DynamicChannelsSupported=1}`")).set(flag.clone(), "1");
            let finding = DYNAMIC_CHANNELS_FLAG
                .at(flag, message)
                .fix(fix)
                .label(Place::of(Part::DynamicChannels), "segments");
            findings
                .push(finding.help(say!("write `{DynamicChannelsSupported=1}`, or remove the {section}")));
        }
        _ => {}
    }
}

fn invalid_segment(device: &Device, findings: &mut Findings) {
    let Some(channels) = &device.dynamic_channels else { return };
    let info = device.device_info.as_ref();
    let is_unused = info.is_none_or(|info| info.dynamic_channels_supported.unwrap_or_default() == 0);
    for (number, segment) in (1..).zip(&channels.segments) {
        // some tools write empty keys
        let severity = if is_unused && segment.is_empty() { Severity::Note } else { Severity::Error };
        check_segment_keys(channels, number, segment, severity, findings);
        if let Some(range) = segment.range {
            check_segment_range(channels, number, range, findings);
        }
    }
}

fn segment_field(word: &str, number: usize) -> Field {
    Field::Named(format!("{word}{number}").into())
}

fn segment_place(word: &str, number: usize) -> Place {
    Place::of(Part::DynamicChannels).field(segment_field(word, number))
}

fn check_segment_keys(
    channels: &DynamicChannels,
    number: usize,
    segment: &Segment,
    severity: Severity,
    findings: &mut Findings,
) {
    let direction = segment.direction.as_deref().is_some_and(|direction| !direction.is_empty());
    let stated =
        [("Type", segment.data_type.is_some()), ("Dir", direction), ("Range", segment.range.is_some())];
    let missing: Vec<Field> = stated
        .into_iter()
        .filter(|(_, stated)| !stated)
        .map(|(word, _)| segment_field(word, number))
        .filter(|field| channels.invalid_values.get(field).is_none())
        .collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("segment {} of the dynamic channels has no {}", number, listing_or(&missing));
    let finding = INVALID_SEGMENT.at(Place::of(Part::DynamicChannels), message).severity(severity);
    findings.push(finding.help("write `TypeN`, `DirN`, `RangeN` and `PPOffsetN` for each segment"));
}

fn check_segment_range(
    channels: &DynamicChannels,
    number: usize,
    (low, high): (u16, u16),
    findings: &mut Findings,
) {
    let at = segment_place("Range", number);
    let range = say!("{:04X}h to {:04X}h", low, high);
    if low > high {
        let finding = INVALID_SEGMENT.at(at, say!("the range {} is in descending order", range));
        findings.push(finding.help("write the smaller index first"));
    } else if low < 0xA000 || high > 0xBFFF {
        let message = say!("the range {} is not within A000h to BFFFh, the area of network variables", range);
        findings.push(INVALID_SEGMENT.at(at, message).help("write a range from 0xA000 to 0xBFFF"));
    } else {
        let before = (1..number).zip(&channels.segments);
        let overlaps = |range: (u16, u16)| range.0 <= high && low <= range.1;
        let other = before.into_iter().find(|(_, segment)| segment.range.is_some_and(overlaps));
        if let Some((other, _)) = other {
            let message = say!("the ranges of segments {} and {} overlap", other, number);
            let finding =
                INVALID_SEGMENT.at(at, message).label(segment_place("Range", other), "the other range");
            findings.push(finding.help("write separate ranges for the segments"));
        }
    }
}

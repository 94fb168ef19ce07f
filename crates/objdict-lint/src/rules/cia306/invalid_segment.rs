use crate::diagnostic::{Diagnostic, Findings, Severity, listing_or, say};
use crate::model::{Device, DynamicChannels, Field, Part, Place, Segment};
use crate::rule;

rule! {
    "cia306/invalid-segment", Error, Device(check);
    summary: "a segment of the dynamic channels is not valid",
    checks: "Whether each segment has type, direction and range, whether the range is within A000h to BFFFh in ascending order, and whether ranges overlap.",
    why: "A programming tool takes the indexes of network variables from these ranges.",
    example: "`Range1=0xA0BF-0xA080`",
    remedy: "Write the first and last index: `Range1=0xA080-0xA0BF`.",
    source: "CiA 302-4, CiA 306-1 §4.6.3.4.3",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(channels) = &device.dynamic_channels else { return };
    let info = device.device_info.as_ref();
    let is_unused = info.is_none_or(|info| info.dynamic_channels_supported.unwrap_or_default() == 0);
    for (number, segment) in (1..).zip(&channels.segments) {
        // some tools write empty keys
        let severity = if is_unused && segment.is_empty() { Severity::Note } else { Severity::Error };
        check_keys(channels, number, segment, severity, findings);
        if let Some(range) = segment.range {
            check_range(channels, number, range, findings);
        }
    }
}

fn field(word: &str, number: usize) -> Field {
    Field::Named(format!("{word}{number}").into())
}

fn place(word: &str, number: usize) -> Place {
    Place::of(Part::DynamicChannels).field(field(word, number))
}

fn check_keys(
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
        .map(|(word, _)| field(word, number))
        .filter(|field| channels.invalid_values.get(field).is_none())
        .collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("segment {} of the dynamic channels has no {}", number, listing_or(&missing));
    let finding = Diagnostic::new(&RULE.info, Place::of(Part::DynamicChannels), message).severity(severity);
    findings.push(finding.help("write `TypeN`, `DirN`, `RangeN` and `PPOffsetN` for each segment"));
}

fn check_range(channels: &DynamicChannels, number: usize, (low, high): (u16, u16), findings: &mut Findings) {
    let at = place("Range", number);
    let range = say!("{:04X}h to {:04X}h", low, high);
    if low > high {
        let finding = Diagnostic::new(&RULE.info, at, say!("the range {} is in descending order", range));
        findings.push(finding.help("write the smaller index first"));
    } else if low < 0xA000 || high > 0xBFFF {
        let message = say!("the range {} is not within A000h to BFFFh, the area of network variables", range);
        findings.push(Diagnostic::new(&RULE.info, at, message).help("write a range from 0xA000 to 0xBFFF"));
    } else {
        let before = (1..number).zip(&channels.segments);
        let overlaps = |range: (u16, u16)| range.0 <= high && low <= range.1;
        let other = before.into_iter().find(|(_, segment)| segment.range.is_some_and(overlaps));
        if let Some((other, _)) = other {
            let message = say!("the ranges of segments {} and {} overlap", other, number);
            let finding =
                Diagnostic::new(&RULE.info, at, message).label(place("Range", other), "the other range");
            findings.push(finding.help("write separate ranges for the segments"));
        }
    }
}

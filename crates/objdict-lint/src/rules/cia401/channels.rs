//! The channels of an I/O module: its device type, its PDOs with their defaults, events, interrupt limits, error values and
//! scaling.

use crate::demands::{self, Against, Applied, Expected};
use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, RuleInfo, Severity, counted_bits, say, series};
use crate::model::{Device, MappedObject, Object, Part, PdoKind, Place};
use crate::profile::{device_type_index, index_in, number_of};
use crate::rule::rules;
use crate::{Facts, MappedTo, PdoFacts, channels};

rules! {
    source: "CiA 401 (1000h)";

    "cia401/analogue-events-off" = ANALOGUE_EVENTS_OFF, Note, Applied(analogue_events_off);
    summary: "a configuration maps analogue inputs into an event-driven TPDO but leaves their events disabled",
    checks: "If a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries analogue inputs, a configuration (DCF or XDC) must set 6423h and select an event in 6421h. In a device description this is not a finding: the profile disables the events by default.",
    why: "The device never sends the TPDO: while 6423h is false or 6421h is 0, a change of an analogue input is not an event. This is the most common reason for missing analogue values.",
    example: "`[1801sub2]` with 255, `[1801sub5]` with 0, and `[6423]` with `DefaultValue=0` and no `ParameterValue`",
    remedy: "Set `ParameterValue=1` at 6423h, select an event in 6421h, set an event timer, or send the TPDO on SYNC.",
    source: "CiA 401 (6421h, 6423h)",

    "cia401/channels-not-in-device-type" = CHANNELS_NOT_IN_DEVICE_TYPE, Warning,
        Applied(channels_not_in_device_type), fix Unsafe;
    summary: "the module has channels that are missing from its device type",
    checks: "1000h must indicate each kind of channel that the description has objects for: bit 16 for digital inputs, bit 17 for digital outputs, bit 18 for analogue inputs, bit 19 for analogue outputs.",
    why: "A master that relies on the device type does not use these channels.",
    example: "`[6401]`, and `[1000]` with `DefaultValue=0x00030191`",
    remedy: "Set the bit, in the description and in the device.",

    "cia401/channels-without-pdo" = CHANNELS_WITHOUT_PDO, Warning, Applied(channels_without_pdo);
    summary: "channels of an I/O module have no PDO",
    checks: "A module with more than 8 bytes of digital inputs or outputs, or more than 12 words of analogue ones, must map the last of them or have a PDO above PDO 4. Channels of modules of a modular device are ignored.",
    why: "The default PDOs are full, so the remaining channels are accessible by SDO only, which is too slow for process data.",
    example: "`[6000sub0]` with `DefaultValue=12`, and no TPDO above TPDO 4",
    remedy: "Add PDOs from PDO 5 on for the remaining channels, not valid by default.",
    source: "CiA 401, default PDOs; CiA 301 §7.5.2.35 (PDO 5 and above)",

    "cia401/device-type-without-channels" = DEVICE_TYPE_WITHOUT_CHANNELS, Error,
        Applied(device_type_without_channels), fix Unsafe;
    summary: "the device type indicates channels that the module does not have",
    checks: "For each kind of channel that 1000h indicates, an object of any width must be described. Bit 16 is for digital inputs (6000h, 6100h, 6120h or 6020h to 6027h), bit 17 for digital outputs (6200h, 6300h, 6320h, 6220h to 6227h), bit 18 for analogue inputs (6400h to 6404h), bit 19 for analogue outputs (6410h to 6414h). In a device with several logical devices the types are in 67FFh and each object 800h further. Channels that a module of a modular device may add are not reported. PDOs of channels that the module does not have are not required.",
    why: "A master relies on the device type: it uses the channels and the PDOs that carry them. In real files the device type is nearly always copied from a larger device of the same family.",
    example: "`[1000]` with `DefaultValue=0x000F0191`, and no analogue channels",
    remedy: "Clear the bit, or describe the channels.",

    "cia401/digital-events-off" = DIGITAL_EVENTS_OFF, Warning, Applied(digital_events_off);
    summary: "the events of digital inputs are switched off",
    checks: "If a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries digital inputs, a configuration (DCF or XDC) must not disable their events. It must not set 6005h to false, or all masks of 6006h, 6007h and 6008h to 0. `cia401/wrong-default` checks the defaults.",
    why: "The TPDO waits for an event that the inputs never raise: the master sees no change of the inputs.",
    example: "`[6005]` with `ParameterValue=0` and `[1800sub2]` with `ParameterValue=255`",
    remedy: "Write `ParameterValue=1` to 6005h, set the bits of the inputs in a mask, or set the event timer of the TPDO.",
    source: "CiA 401 (6005h to 6008h)",

    "cia401/error-mode-without-value" = ERROR_MODE_WITHOUT_VALUE, Warning, Against(error_mode_without_value);
    summary: "an error mode has no error value",
    checks: "Outputs with an error mode must also have the error value: 6207h for 6206h, 6307h for 6306h, 6327h for 6326h, 6260h to 6267h for 6250h to 6257h, 6444h or 6445h for 6443h. Objects that a module of a modular device may add are not reported.",
    why: "If the master fails, an output with an error mode assumes its error value. Without an error value the state of the output is undefined.",
    example: "`[6206]` without `[6207]`",
    remedy: "Describe the error value or remove the error mode.",
    source: "CiA 401 (6206h, 6207h, 6443h to 6445h)",

    "cia401/interrupt-limits-crossed" = INTERRUPT_LIMITS_CROSSED, Warning, Applied(interrupt_limits_crossed);
    summary: "the lower interrupt limit of an analogue input is above the upper one",
    checks: "6425h and 642Bh (lower limits) must not be above 6424h and 642Ah (upper limits), channel by channel.",
    why: "An input raises an event above the upper limit and below the lower one. If the limits are crossed, each value raises an event and the TPDO floods the network.",
    example: "`[6424sub1]` with `DefaultValue=100`, `[6425sub1]` with `DefaultValue=200`",
    remedy: "Swap the limits.",
    source: "CiA 401 (6424h, 6425h, 642Ah, 642Bh)",

    "cia401/wrong-default-mapping" = WRONG_DEFAULT_MAPPING, Warning,
        Applied(wrong_default_mapping), fix Unsafe;
    summary: "the default mapping of an I/O module's PDO differs from CiA 401",
    checks: "In an EDS, the default mapping of PDO 1 to 4 must follow the profile, as far as the module has channels. RPDO 1 carries the first 8 bytes of digital outputs (6200h), RPDOs 2 to 4 the first 12 words of analogue outputs (6411h). TPDO 1 carries the first 8 bytes of digital inputs (6000h), TPDOs 2 to 4 the first 12 words of analogue inputs (6401h). A PDO that carries only some of its channels is a note. The rule does not apply if bit 23 of 1000h declares a manufacturer-specific mapping. It does not apply to devices with several logical devices, to PDOs that map nothing or to PDOs whose entries are invalid.",
    why: "The default mapping makes modules of different vendors interchangeable: a master that knows the profile uses it without configuration. In real files, most deviating PDOs carry fewer channels than available, which affects only the missing channels.",
    example: "`[1A00sub1]` with `DefaultValue=0x64010110`",
    remedy: "Use the mapping of the profile, or set bit 23 of 1000h.",
    source: "CiA 401, default PDOs",

    "cia401/wrong-transmission-type" = WRONG_TRANSMISSION_TYPE, Warning,
        Applied(wrong_transmission_type), fix Unsafe;
    summary: "a default PDO of an I/O module has a transmission type other than 255",
    checks: "In an EDS, the default transmission type of PDO 1 to 4, as far as the module has channels for them, must be 255: sent when an input changes, applied immediately. The rule does not apply to TPDOs of analogue inputs that are sent every 1 to 240 SYNCs or to PDOs that are not valid by default. It does not apply if bit 23 of 1000h declares a manufacturer-specific mapping, or to devices with several logical devices.",
    why: "Without configuration, a master gets no inputs from a module that waits for a SYNC. With 254 the vendor, not the profile, defines when the PDO is sent.",
    example: "`[1800sub2]` with `DefaultValue=254`",
    remedy: "Write `DefaultValue=255`, in the description and in the device.",
    source: "CiA 401, default PDOs",

    "cia401/zero-scaling" = ZERO_SCALING, Error, Expected(zero_scaling);
    summary: "an analogue channel is configured with a scaling of 0",
    checks: "A configuration (DCF or XDC) must not set an element of 642Fh, 6432h, 6442h or 6447h to 0. `cia401/wrong-default` checks the defaults.",
    why: "The value of the channel is multiplied by 0, so an input always reads its offset and an output never changes.",
    example: "`[6432sub1]` with `ParameterValue=0`",
    remedy: "Write 1 for no scaling.",
    source: "CiA 401 (642Fh, 6432h, 6442h, 6447h)",
}

fn channels_not_in_device_type(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let index = device_type_index(device, block);
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer());
    let Some(value) = value.filter(|_| number_of(device, block) == applied.profile.number) else { return };
    let unnamed = channels::KINDS.iter().filter(|kind| value >> kind.bit & 1 == 0);
    let unnamed: Vec<_> = unnamed.filter_map(|kind| Some((kind, kind.first_in(device, block)?))).collect();
    if unnamed.is_empty() {
        return;
    }
    let names = series(unnamed.iter().map(|(kind, _)| kind.name));
    let message = say!("the device has {}, but its device type does not state them", names);
    let right = unnamed.iter().fold(value, |value, (kind, _)| value | 1 << kind.bit);
    let place = device.value_place(index, 0);
    let mut finding = CHANNELS_NOT_IN_DEVICE_TYPE.at(place.clone(), message);
    for (kind, index) in unnamed {
        finding = finding.label(Place::object(index), kind.name);
    }
    let text = format!("0x{right:08X}");
    let finding = finding.help(say!("write `{}`", text));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", text)).set(place, text)));
}

/// The number of elements that the default PDOs carry: PDO 1, and PDOs 2 to 4.
const DEFAULT_BYTES: u8 = 8;
const DEFAULT_WORDS: u8 = 12;

/// The last PDO with a default mapping.
const LAST_DEFAULT_PDO: u16 = 4;

fn channels_without_pdo(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let channels = channels::of_device(facts.device).filter(|_| applied.block == 0);
    let Some(channels) = channels else { return };
    let arrays = [
        (PdoKind::Tpdo, 0x6000, channels.digital_inputs, DEFAULT_BYTES),
        (PdoKind::Rpdo, 0x6200, channels.digital_outputs, DEFAULT_BYTES),
        (PdoKind::Tpdo, 0x6401, channels.analog_inputs, DEFAULT_WORDS),
        (PdoKind::Rpdo, 0x6411, channels.analog_outputs, DEFAULT_WORDS),
    ];
    for (kind, index, number, room) in arrays.into_iter().filter(|(_, _, number, room)| number > room) {
        let mut pdos = facts.pdos.iter().filter(|pdo| pdo.pdo.kind == kind);
        let carries = |object: MappedObject| object.entry() == (index, number);
        if pdos.any(|pdo| {
            pdo.pdo.number > LAST_DEFAULT_PDO || pdo.mapped.iter().any(|mapped| carries(mapped.object))
        }) {
            continue;
        }
        let kind = kind.name();
        let message = say!(
            "{:04X}h has {} elements, but {}s 1 to 4 have room for only {} of them",
            index,
            number,
            kind,
            room
        );
        let finding = CHANNELS_WITHOUT_PDO.at(facts.device.value_place(index, 0), message);
        findings.push(finding.help(say!("add {}s from {} 5 on for the remaining elements", kind, kind)));
    }
}

fn device_type_without_channels(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let index = device_type_index(device, block);
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer());
    let missing: Vec<_> = channels::only_stated(device, block).collect();
    let Some(value) = value.filter(|_| !missing.is_empty()) else { return };
    let names = series(missing.iter().map(|kind| kind.name));
    let message = say!("the device type states {}, but their objects are missing", names);
    let cleared = missing.iter().fold(value, |value, kind| value & !(1 << kind.bit));
    let place = device.value_place(index, 0);
    let finding = DEVICE_TYPE_WITHOUT_CHANNELS.at(place.clone(), message);
    let text = format!("0x{cleared:08X}");
    let finding = finding.help(say!("write `{}` or describe the channels", text));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", text)).set(place, text)));
}

fn wrong_default_mapping(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for (pdo, right) in channels::default_pdos(facts, applied) {
        let found: Vec<MappedObject> = pdo.mapped.iter().map(|mapped| mapped.object).collect();
        if found.is_empty() || found == right || !is_mapping_readable(pdo) {
            continue;
        }
        let is_shorter = right.starts_with(&found);
        let differs = found.iter().zip(&right).position(|(found, right)| found != right);
        let pair = differs.and_then(|at| Some((found.get(at)?, right.get(at)?)));
        let message = match pair.filter(|(found, right)| (found.index, found.sub) == (right.index, right.sub))
        {
            Some((found, right)) => say!(
                "{} maps {} of {:04X}h:{:02X}, but CiA 401 maps {}",
                pdo.pdo,
                counted_bits(found.bits),
                found.index,
                found.sub,
                right.bits
            ),
            None => {
                say!("{} maps {}, but CiA 401 maps {}", pdo.pdo, shown_mapping(&found), shown_mapping(&right))
            }
        };
        let slot = differs.and_then(|at| pdo.mapped.get(at)).map_or(0, |mapped| mapped.slot);
        let place = device.value_place(pdo.pdo.mapping_index(), slot);
        let finding = WRONG_DEFAULT_MAPPING.at(place, message);
        let finding = finding.help("use the mapping of the profile or set bit 23 of 1000h");
        let finding = if is_shorter { finding.severity(Severity::Note) } else { finding };
        findings.push(match mapping_of_profile(device, pdo, &right) {
            Some(fix) => finding.fix(fix),
            None => finding,
        });
    }
}

/// Whether the mapping is complete and no other rule reports it.
fn is_mapping_readable(pdo: &PdoFacts<'_>) -> bool {
    let fits = |target: &MappedTo<'_>| match target {
        MappedTo::Entry(entry) => entry.is_mappable() && entry.fits_pdo(pdo.pdo.kind),
        MappedTo::Dummy | MappedTo::Elsewhere => true,
        _ => false,
    };
    let slots = || pdo.pdo.used_slots();
    let is_counted = pdo.pdo.mapped_count.is_some_and(|count| slots().count() == usize::from(count));
    let is_stated = slots().all(|slot| slot.object.is_some_and(|object| !object.is_unused()));
    is_counted && is_stated && pdo.lengths_are_right() && pdo.mapped.iter().all(|mapped| fits(&mapped.target))
}

/// The mapping of the profile, if there are entries for it.
fn mapping_of_profile(device: &Device, pdo: &PdoFacts<'_>, right: &[MappedObject]) -> Option<Fix> {
    let index = pdo.pdo.mapping_index();
    let object = device.object(index).filter(|object| object.compact.is_none())?;
    let count = u8::try_from(right.len()).ok()?;
    let fix = Fix::risky("write the mapping of the profile");
    let fix = fix.set(device.value_place(index, 0), count.to_string());
    (1..=count).zip(right).try_fold(fix, |fix, (sub, mapped)| {
        let number = format!("0x{:04X}{:02X}{:02X}", mapped.index, mapped.sub, mapped.bits);
        object.subs.get(sub).map(|_| fix.set(device.value_place(index, sub), number))
    })
}

/// Runs of sub-indexes: `6401h:01 to 04`.
fn shown_mapping(mapped: &[MappedObject]) -> Argument {
    let mut runs: Vec<(MappedObject, u8)> = Vec::new();
    for object in mapped {
        match runs.last_mut() {
            Some((first, last)) if first.index == object.index && last.checked_add(1) == Some(object.sub) => {
                *last = object.sub;
            }
            _ => runs.push((*object, object.sub)),
        }
    }
    series(runs.iter().map(|(first, last)| match first.sub == *last {
        true => say!("{:04X}h:{:02X}", first.index, last),
        false => say!("{:04X}h:{:02X} to {:02X}", first.index, first.sub, last),
    }))
}

fn wrong_transmission_type(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    for (pdo, mapped) in channels::default_pdos(facts, applied) {
        let pdo = &pdo.pdo;
        // the profile disables the events of analogue inputs (6423h), so 255 without 6423h would send nothing
        let is_sampled = mapped.iter().any(|mapped| mapped.index == 0x6401);
        let is_right = |found: u8| match found {
            255 => true,
            1..=240 => is_sampled,
            // another rule reports reserved transmission types
            _ => matches!(found, 241..=251),
        };
        let wrong = pdo.transmission_type.filter(|&found| !is_right(found));
        let Some(found) = wrong.filter(|_| pdo.is_valid() != Some(false)) else { continue };
        let message = say!("transmission type `{}` of {} differs from CiA 401 (255)", found, pdo);
        let place = facts.device.value_place(pdo.communication_index(), 2);
        let finding = WRONG_TRANSMISSION_TYPE.at(place.clone(), message).help("write 255");
        findings.push(finding.fix(Fix::risky("write `255`").set(place, "255")));
    }
}

fn analogue_events_off(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let switches = [(0x6423, 0, "is true"), (0x6421, 1, "selects one")];
    let off = switches.into_iter().find(|&(index, ..)| facts.is_configured_off(at(index)));
    let Some((index, sub, condition)) = off else { return };
    let Some(pdo) = facts.waiting_tpdo(&(at(0x6400)..=at(0x6404))) else { return };
    let message =
        say!("{} is never sent: analogue inputs raise no events until {:04X}h {}", pdo, at(index), condition);
    let finding = ANALOGUE_EVENTS_OFF.at(device.value_place(at(index), sub), message);
    let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
    let help =
        if sub == 0 { say!("write `{ParameterValue=1}`") } else { say!("select an event, such as 7,") };
    findings.push(finding.help(say!("{} or set the event timer of the TPDO", help)));
}

/// The masks of the inputs with 8 bits: any change, to 1, to 0.
const EVENT_MASKS: [u16; 3] = [0x6006, 0x6007, 0x6008];

fn digital_events_off(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let inputs = |last: u16| at(0x6000)..=at(last);
    let is_set = |index: u16| {
        let mut entries = device.object(index).into_iter().flat_map(Object::described);
        entries.any(|(_, entry)| entry.configured_value().is_some())
    };
    let masks: Vec<u16> =
        EVENT_MASKS.map(at).into_iter().filter(|&mask| device.object(mask).is_some()).collect();
    let is_masked = masks.iter().all(|&mask| facts.is_configured_off(mask));
    let first = masks.iter().copied().find(|&mask| is_set(mask)).filter(|_| is_masked);
    let (index, pdo, help) = if facts.is_configured_off(at(0x6005)) && is_set(at(0x6005)) {
        let help = say!("write `{ParameterValue=1}` or set the event timer of the TPDO");
        (at(0x6005), facts.waiting_tpdo(&inputs(0x6128)), help)
    } else if let Some(first) = first {
        let help = say!("set the bits of the inputs in {:04X}h or the event timer of the TPDO", first);
        (first, facts.waiting_tpdo(&inputs(0x6000)), help)
    } else {
        return;
    };
    let Some(pdo) = pdo else { return };
    let sub = u8::from(index != at(0x6005));
    let message = say!("{} is never sent: {:04X}h disables digital input events", pdo, index);
    let finding = DIGITAL_EVENTS_OFF.at(device.value_place(index, sub), message);
    let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
    findings.push(finding.help(help));
}

/// The error values for an error mode, of the first logical device.
fn error_values(mode: u16) -> &'static [u16] {
    match mode {
        0x6206 => &[0x6207],
        0x6306 => &[0x6307],
        0x6326 => &[0x6327],
        0x6443 => &[0x6444, 0x6445],
        _ => &[],
    }
}

fn error_mode_without_value(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let block = at.applied.block;
    let mode = at.index - (index_in(block, at.facts.first) - at.facts.first);
    let counted_bits = [mode.saturating_add(0x10)];
    let values = if matches!(mode, 0x6250..=0x6257) { &counted_bits } else { error_values(mode) };
    let mut indexes = values.iter().map(|&index| index_in(block, index));
    let Some(first) = indexes.clone().next().filter(|_| !at.object.orphan) else { return };
    if !indexes.any(|index| demands::is_there(at.device, index)) {
        let message = say!("{} has no error value ({:04X}h)", at, first);
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help(say!("describe the error value: `{}`", Part::Object(first))));
    }
}

fn interrupt_limits_crossed(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for [upper, lower] in [[0x6424, 0x6425], [0x642A, 0x642B]] {
        let [upper, lower] = [upper, lower].map(|index| index_in(applied.block, index));
        let Some(object) = device.object(lower).filter(|_| device.objects.contains_key(&upper)) else {
            continue;
        };
        for (sub, _) in object.stated().filter(|&(sub, _)| sub > 0) {
            let value = |index: u16| device.value(index, sub)?.as_real();
            let (Some(high), Some(low)) = (value(upper), value(lower)) else { continue };
            if low > high {
                let message = say!(
                    "the lower limit `{}` of input {} is above the upper limit `{}`",
                    low.to_string(),
                    sub,
                    high.to_string()
                );
                let finding = INTERRUPT_LIMITS_CROSSED.at(device.value_place(lower, sub), message);
                let finding = finding.label(device.value_place(upper, sub), "the upper limit");
                findings.push(finding.help("swap the limits"));
            }
        }
    }
}

fn zero_scaling(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let is_scaling = matches!(at.against.facts.first, 0x642F | 0x6432 | 0x6442 | 0x6447);
    let value = at.entry.configured_value().filter(|_| is_scaling && !at.counts());
    if value.and_then(crate::model::Value::as_real) == Some(0.0) {
        let message = say!("the scaling of {} is `0`", at);
        let finding = Diagnostic::new(rule, at.place().field(at.value_field()), message);
        findings.push(finding.help("write 1 for no scaling"));
    }
}

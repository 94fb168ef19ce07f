//! The profile and the features that come closest to an existing device.

use super::base::{base, newest_version};
use super::demanded::{Demanded, OF_CLASS_2, channels};
use super::features::{
    Describes, EncoderClass, FEATURES, Feature, FeatureKind, FeatureValue, Features, VALUE_TYPES,
};
use objdict_model::model::{Device, Object, PdoKind};

/// The profile of a device and its features, without defaults. With them, [`base`](super::base()) generates the closest
/// device: with the same communication objects, channels, modes and PDOs.
///
/// The profile is 301 if the device's profile is not in [`PROFILES`](super::PROFILES).
pub fn infer(device: &Device) -> (u16, Features) {
    let profile = device.profile().filter(|&profile| newest_version(profile).is_some()).unwrap_or(301);
    let mut features = of_profile(device, profile);
    for feature in FEATURES.iter().filter(|feature| feature.is_of(profile)) {
        let plan = Demanded { profile, features: features.clone() };
        if let Some(value) = value(device, &plan, feature) {
            // values outside the range of the feature remain unset
            let _ = features.set(feature.word, &value);
        }
    }
    // the default SYNC depends on whether there are PDOs, not on their content
    (features.rpdos, features.tpdos) = (Some(device.pdos().next().is_some().into()), Some(0));
    let mut features = without_usual(profile, features);
    (features.rpdos, features.tpdos) = (None, None);
    of_pdos(device, profile, &mut features);
    (profile, features)
}

/// The features that depend on code for the profile.
fn of_profile(device: &Device, profile: u16) -> Features {
    let has = |index: u16| device.object(index).is_some();
    let mut features = Features::default();
    match profile {
        404 => {
            let mut types = (0u16..).map(|at| 0x1000 * at).zip(VALUE_TYPES);
            let used = types.find(|(offset, _)| has(0x6130 + offset) || has(0x6300 + offset));
            features.value_type = used.map(|(_, value_type)| value_type);
        }
        406 => {
            features.encoder_type = Some(bits(device, 0x1000, 16..=31));
            // some of these are for rotary encoders only
            let of_class_2 = OF_CLASS_2.iter().filter(|index| has(**index)).count();
            features.encoder_class = (of_class_2 > OF_CLASS_2.len() / 2).then_some(EncoderClass::C2);
        }
        _ => {}
    }
    features.lss = device.device_info.as_ref().and_then(|info| info.lss_supported);
    features
}

/// The value of a feature, as far as the objects that it describes determine it.
fn value(device: &Device, plan: &Demanded, feature: &Feature) -> Option<FeatureValue> {
    let elements = |index: u16| device.object(index).and_then(Object::highest_sub).unwrap_or(0).into();
    let has = |index: u16| device.object(index).is_some();
    if let FeatureKind::Bits { index, .. } = feature.kind {
        let set = feature.kind.bits().into_iter().filter(|(bit, _)| bits(device, index, *bit..=*bit) == 1);
        return Some(FeatureValue::Names(set.map(|(_, name)| name).collect()));
    }
    let number: u16 = match feature.describes {
        Describes::Objects(objects) => objects.iter().all(|index| has(*index)).into(),
        Describes::Bit(index, bit) => bits(device, index, bit..=bit),
        Describes::Elements(index) => elements(index),
        Describes::Series(first) => (0..=u8::MAX.into()).find(|at| !has(first + at)).unwrap_or_default(),
        Describes::Channels(_) => {
            let (index, lines) = channels(plan.profile, feature)?;
            elements(plan.channel_index(index)) * lines
        }
        Describes::Other => return None,
    };
    Some(match feature.kind {
        FeatureKind::Flag => FeatureValue::Flag(number != 0),
        _ => FeatureValue::Number(number.into()),
    })
}

/// Bits of the value of an object; 0 if it has none.
fn bits(device: &Device, index: u16, bits: std::ops::RangeInclusive<u8>) -> u16 {
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer()).unwrap_or_default();
    let width = u32::from(bits.end() - bits.start()) + 1;
    u16::try_from((value >> bits.start()) & ((1 << width) - 1)).unwrap_or_default()
}

/// The features that differ from the defaults.
fn without_usual(profile: u16, mut features: Features) -> Features {
    let made = |features: &Features| base(profile, 1, features).ok();
    let device = made(&features);
    for feature in FEATURES {
        let mut fewer = features.clone();
        fewer.unset(feature.word);
        if fewer != features && made(&fewer) == device {
            features = fewer;
        }
    }
    features
}

/// The numbers of PDOs, and the maximum sub-indexes of their parameters.
fn of_pdos(device: &Device, profile: u16, features: &mut Features) {
    let usual = base(profile, 1, features).unwrap_or_default();
    let numbers = |device: &Device, kind| -> Vec<u16> {
        device.pdos().filter(|pdo| pdo.kind == kind).map(|pdo| pdo.number).collect()
    };
    let count = |kind| -> Option<u16> {
        let there = numbers(device, kind);
        let first = (1..).zip(&there).take_while(|(number, of)| number == *of).count();
        if there == numbers(&usual, kind) { None } else { u16::try_from(first).ok() }
    };
    (features.rpdos, features.tpdos) = (count(PdoKind::Rpdo), count(PdoKind::Tpdo));
    let highest = |kind, usual: u16| -> Option<u16> {
        let pdos = device.pdos().filter(|pdo| pdo.kind == kind);
        let highest = most_frequent(pdos.filter_map(|pdo| pdo.communication?.highest_sub()));
        highest.map(u16::from).filter(|highest| *highest != usual && (2..=6).contains(highest))
    };
    (features.rpdo_parameters, features.tpdo_parameters) =
        (highest(PdoKind::Rpdo, 2), highest(PdoKind::Tpdo, 5));
    let usual = base(profile, 1, features).unwrap_or_default();
    let rooms = |device: &Device| -> Vec<Option<u8>> {
        device.pdos().map(|pdo| pdo.mapping?.highest_sub().filter(|room| (1..=64).contains(room))).collect()
    };
    if rooms(&usual) != rooms(device) {
        features.mapping_entries = most_frequent(rooms(device).into_iter().flatten()).map(u16::from);
    }
}

/// The number that occurs most often.
fn most_frequent(numbers: impl Iterator<Item = u8>) -> Option<u8> {
    let mut counts = [0u16; 256];
    for number in numbers {
        counts[usize::from(number)] += 1;
    }
    (0..=u8::MAX)
        .filter(|number| counts[usize::from(*number)] > 0)
        .max_by_key(|number| counts[usize::from(*number)])
}

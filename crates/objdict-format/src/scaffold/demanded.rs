//! The requirements of a profile and features: objects, counts and the device type.

use objdict_model::model::DataType;

use super::features::{Describes, EncoderClass, FEATURES, Feature, FeatureValue, Features, VALUE_TYPES};

/// Additional objects of an encoder of class C2 compared with C1: scaling, preset, cyclic timer, alarms, warnings,
/// versions, operating time, offset (CiA 406).
pub(super) const OF_CLASS_2: [u16; 14] = [
    0x6001, 0x6002, 0x6003, 0x6005, 0x6200, 0x6503, 0x6504, 0x6505, 0x6506, 0x6507, 0x6508, 0x6509, 0x650A,
    0x650B,
];
/// Modes of operation, their display, and the supported ones.
const OF_DRIVES: [u16; 3] = [0x6060, 0x6061, 0x6502];
/// Requirements of modes that the document does not specify, by their bits in 6502h: the data and time of an
/// interpolation, which a vendor may define differently, and the actual value for a target.
const OF_MODES: [(u32, u16); 3] = [(1 << 6, 0x60C1), (1 << 6, 0x60C2), (1 << 10, 0x6077)];
/// Sensor, operating mode, unit, decimal digits and status of an analogue input, in addition to its process
/// value (CiA 404).
const OF_MEASURED: [u16; 5] = [0x6110, 0x6112, 0x6131, 0x6132, 0x6150];
/// Likewise for an analogue output: unit, decimal digits and type.
const OF_OUTPUTS: [u16; 3] = [0x6301, 0x6302, 0x6310];

/// The bit of 1000h for a servo drive.
const SERVO_DRIVE: u32 = 1 << 17;

/// A profile with features, all of which have a value.
#[derive(Clone, Debug)]
pub struct Demanded {
    pub(super) profile: u16,
    pub(super) features: Features,
}

impl Demanded {
    /// The plan of a device with a profile and its features.
    pub fn new(profile: u16, features: &Features) -> Self {
        let mut all = features.clone();
        for (field, usual) in [
            (&mut all.rpdo_parameters, 2),
            (&mut all.tpdo_parameters, 5),
            (&mut all.identity_entries, 4),
            (&mut all.encoder_type, 2),
        ] {
            field.get_or_insert(usual);
        }
        for field in [&mut all.heartbeat, &mut all.emcy, &mut all.device_name] {
            field.get_or_insert(true);
        }
        all.restore = all.restore.or(all.store);
        all.cycle_period = all.cycle_period.or(all.sync_producer);
        all.time = all.time.or(all.time_producer);
        if [all.sync_producer, all.cycle_period, all.sync_window, all.sync_counter].contains(&Some(true)) {
            all.sync.get_or_insert(true);
        }
        all.value_type.get_or_insert(DataType::REAL32);
        all.drive_types.get_or_insert(SERVO_DRIVE);
        all.encoder_class.get_or_insert(EncoderClass::C1);
        Self { profile, features: all }
    }

    /// The number of a feature; 1 or 0 for a flag.
    pub(super) fn amount(&self, feature: &Feature) -> u16 {
        match self.features.get(feature.word) {
            Some(FeatureValue::Flag(flag)) => flag.into(),
            Some(FeatureValue::Number(number)) => u16::try_from(number).unwrap_or_default(),
            _ => 0,
        }
    }

    /// The communication objects, except those of PDOs and those that the profile implies.
    pub(super) fn communication(&self) -> Vec<u16> {
        let mut indexes = vec![0x1000, 0x1001];
        for feature in FEATURES {
            let amount = self.amount(feature);
            match feature.describes {
                Describes::Objects(objects) if amount > 0 => indexes.extend(objects),
                Describes::Elements(index) if amount > 0 => indexes.push(index),
                Describes::Series(first @ 0x1200..=0x12FF) => indexes.extend(first..first + amount),
                _ => {}
            }
        }
        indexes
    }

    /// The objects of the profile for the features; the document requires others that depend on them.
    pub(super) fn requested(&self) -> Vec<u16> {
        let arrays = FEATURES.iter().filter(|feature| self.amount(feature) > 0);
        let arrays =
            arrays.filter_map(|feature| Some(self.channel_index(channels(self.profile, feature)?.0)));
        let features = &self.features;
        let has = |channels: Option<u16>| channels.is_some_and(|count| count > 0);
        let others: &[&[u16]] = match self.profile {
            402 => &[&OF_DRIVES],
            404 => match (has(features.analog_inputs), has(features.analog_outputs)) {
                (true, true) => &[&OF_MEASURED, &OF_OUTPUTS],
                (true, false) => &[&OF_MEASURED],
                (false, true) => &[&OF_OUTPUTS],
                (false, false) => &[],
            },
            406 if features.encoder_class == Some(EncoderClass::C2) => &[&OF_CLASS_2],
            _ => &[],
        };
        let modes = features.modes.filter(|_| self.profile == 402).unwrap_or_default();
        let of_modes = OF_MODES.into_iter().filter(|(bit, _)| modes & bit != 0).map(|(_, index)| index);
        arrays.chain(others.concat()).chain(of_modes).collect()
    }

    /// The array with the channels: CiA 404 has one for each type of process values.
    pub(super) fn channel_index(&self, index: u16) -> u16 {
        let at = VALUE_TYPES.iter().position(|of| Some(*of) == self.features.value_type).unwrap_or_default();
        match (self.profile, index, u16::try_from(at)) {
            (404, 0x6130 | 0x6300, Ok(at)) => index + 0x1000 * at,
            _ => index,
        }
    }

    /// The value of 1000h.
    pub(super) fn device_type(&self) -> u32 {
        let features = &self.features;
        let additional = match self.profile {
            401 => bits([
                features.digital_inputs,
                features.digital_outputs,
                features.analog_inputs,
                features.analog_outputs,
            ]),
            402 => features.drive_types.unwrap_or_default(),
            404 => bits([
                features.digital_inputs,
                features.analog_inputs,
                features.digital_outputs,
                features.analog_outputs,
            ]),
            406 => u32::from(features.encoder_type.unwrap_or_default()) << 16,
            _ => return 0,
        };
        additional | u32::from(self.profile)
    }

    /// The number of sub-indexes after sub-index 0; `None` if no feature determines it.
    pub(super) fn count(&self, index: u16) -> Option<u8> {
        let features = &self.features;
        let elements = |channels: Option<u16>, lines: u16| channels.unwrap_or_default().div_ceil(lines);
        let of_feature = || {
            let of_object = |feature: &&Feature| feature.describes == Describes::Elements(index);
            FEATURES.iter().find(of_object).map(|feature| self.amount(feature))
        };
        let count = match (self.profile, index) {
            (401, 0x6000..=0x61FF) => Some(elements(features.digital_inputs, 8)),
            (401, 0x6200..=0x63FF) => Some(elements(features.digital_outputs, 8)),
            (401, 0x6400..=0x640F | 0x6420..=0x643F) => features.analog_inputs,
            (401, 0x6410..=0x641F | 0x6440..=0x645F) => features.analog_outputs,
            (404, 0x6000..) => match index & 0x0F00 {
                0x000 => Some(elements(features.digital_inputs, 8)),
                0x100 => features.analog_inputs,
                0x200 => Some(elements(features.digital_outputs, 8)),
                _ => features.analog_outputs,
            },
            _ => of_feature(),
        };
        count.and_then(|count| u8::try_from(count).ok())
    }
}

/// The bits of 1000h from 16 on, one a kind of channels.
fn bits(channels: [Option<u16>; 4]) -> u32 {
    let there = channels.iter().enumerate().filter(|(_, count)| count.is_some_and(|count| count > 0));
    there.fold(0, |bits, (bit, _)| bits | 0x1_0000 << bit)
}

/// The array of a profile with the channels, and the number of channels per element.
pub(super) fn channels(profile: u16, feature: &Feature) -> Option<(u16, u16)> {
    let Describes::Channels(arrays) = feature.describes else { return None };
    arrays.iter().find(|(of, ..)| *of == profile).map(|&(_, index, lines)| (index, lines))
}

//! The device that a profile requires for a set of features.

use std::time::{SystemTime, UNIX_EPOCH};

use super::demanded::{Demanded, channels};
use super::features::{FEATURES, Feature, FeatureValue, Features};
use super::objects::ObjectMaker;
use super::{Wanted, device_info, pdos};
use objdict_model::model::{ClockTime, DataType, Date, Device, DummyUsage, ObjectLists};
use objdict_profile as profile;
use objdict_profile::Profile;

/// The profiles for which devices can be generated, each with its newest version; version 1 is the first.
///
/// A version never changes: descriptions that state it would become different devices. If newer data or code changes
/// the result, the version is incremented, and the change states its first (`since`) or last (`until`) version: in a
/// row of `data/*.toml`, in a row of `FEATURES`, or in a branch in this folder. [`base`] uses those that apply to the
/// requested version; the rules use only those without `until`. `tests/library/new.rs` has a digest of the result of
/// each version.
pub const PROFILES: &[(u16, u16)] = &[(301, 1), (401, 1), (402, 1), (404, 1), (406, 1)];

/// The reason why there is no device for a profile and features.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BaseError {
    /// The profile is not supported.
    Profile(u16),
    /// The profile has no such version.
    Version {
        /// The profile.
        profile: u16,
        /// The requested version.
        version: u16,
    },
    /// The profile does not have the feature.
    Feature {
        /// The profile.
        profile: u16,
        /// The word of the feature.
        word: &'static str,
    },
    /// The profile has fewer channels.
    TooMany {
        /// The profile.
        profile: u16,
        /// The word of the feature.
        word: &'static str,
        /// The highest number.
        highest: u16,
    },
}

objdict_model::error_messages! { BaseError: {
    Self::Profile(profile) => "CiA {profile} is not supported";
    Self::Version { profile, version } => "CiA {profile} has no version {version}";
    Self::Feature { profile, word } => "CiA {profile} has no `{word}`";
    Self::TooMany { profile, word, highest } => "CiA {profile} has at most {highest} `{word}`";
} }

impl BaseError {
    /// The supported values.
    pub fn help(&self) -> String {
        let list = |numbers: Vec<String>| numbers.join(", ");
        match self {
            Self::Profile(_) => {
                let known = PROFILES.iter().map(|(profile, _)| profile.to_string());
                format!("these are supported: {}", list(known.collect()))
            }
            Self::Version { profile, .. } => {
                let newest = newest_version(*profile).unwrap_or_default();
                format!(
                    "these are known: {}",
                    list((1..=newest).map(|version| format!("{profile}@{version}")).collect())
                )
            }
            Self::Feature { word, .. } => {
                let profiles = Feature::named(word).map_or(&[][..], |feature| feature.profiles);
                format!("only CiA {} has it", list(profiles.iter().map(u16::to_string).collect()))
            }
            Self::TooMany { highest, .. } => format!("write a number up to {highest}"),
        }
    }
}

/// The newest version for a profile; `None` if the profile is not supported.
pub fn newest_version(profile: u16) -> Option<u16> {
    PROFILES.iter().find(|(of, _)| *of == profile).map(|(_, newest)| *newest)
}

/// Generates a device with exactly the objects that a profile and CiA 301 require for these features. Identity and
/// names remain open; [`identify`](super::identify) copies them from the device information.
///
/// # Errors
/// If the profile or the version is not in [`PROFILES`], or if the profile does not have a feature.
pub fn base(profile: u16, version: u16, features: &Features) -> Result<Device, BaseError> {
    let newest = newest_version(profile).ok_or(BaseError::Profile(profile))?;
    if !(1..=newest).contains(&version) {
        return Err(BaseError::Version { profile, version });
    }
    for feature in FEATURES {
        let Some(value) = features.get(feature.word) else { continue };
        if !feature.is_of(profile) {
            return Err(BaseError::Feature { profile, word: feature.word });
        }
        let highest = most_channels(profile, feature);
        if let (FeatureValue::Number(number), Some(highest)) = (value, highest)
            && number > highest.into()
        {
            return Err(BaseError::TooMany { profile, word: feature.word, highest });
        }
    }
    let documents = documents(profile);
    let maker = ObjectMaker { plan: Demanded::new(profile, features), documents: &documents };
    Ok(device(&maker))
}

/// CiA 301, and the document of a device profile.
pub fn documents(profile: u16) -> Vec<&'static Profile> {
    profile::named("301").into_iter().chain(profile::of_number(profile)).collect()
}

/// The channels that the arrays of a profile have room for.
fn most_channels(profile: u16, feature: &Feature) -> Option<u16> {
    let (index, lines) = channels(profile, feature)?;
    let highest = profile::of_number(profile)?.object(index)?.highest_sub();
    Some(u16::from(highest) * lines)
}

fn device(maker: &ObjectMaker<'_>) -> Device {
    let mut device = Device {
        dummy_usage: Some(DummyUsage {
            types: (1..=7).map(|code| (DataType(code), code >= 5)).collect(),
            ..DummyUsage::default()
        }),
        comments: Some(Vec::new()),
        ..Device::default()
    };
    for index in maker.plan.communication() {
        maker.add(&mut device, index);
    }
    for index in maker.plan.requested() {
        if maker.is_for(&device, index) {
            maker.add(&mut device, index);
        }
    }
    maker.complete(&mut device, FIRST_OF_PROFILE);
    pdos::add(&mut device, maker);
    maker.complete(&mut device, 0);
    // the transmission types of the PDOs can be changed to synchronous ones
    if maker.plan.features.sync.unwrap_or_else(|| device.pdos().next().is_some()) {
        maker.add(&mut device, 0x1005);
    }
    device.lists = ObjectLists::naming(device.objects.keys().copied());
    device.device_info = Some(device_info(&maker.plan, &device));
    device
}

const FIRST_OF_PROFILE: u16 = 0x6000;

/// The vendor-ID of a device without a stated vendor, which CiA never assigns.
pub const NO_VENDOR: u32 = 0xFFFF_FFFF;

/// The start of a day.
pub const MIDNIGHT: ClockTime = ClockTime { hour: 0, minute: 0, second: 0, nanosecond: 0, utc_offset: None };

impl Wanted {
    /// Generates a device of a profile, dated now, with placeholders for everything that its author must fill
    /// in.
    pub fn to_fill_in(profile: u16, file_name: &str) -> Option<Self> {
        let (date, time) = now()?;
        Some(Self {
            profile,
            features: Features::default(),
            file_name: file_name.to_owned(),
            vendor_name: "Vendor".to_owned(),
            vendor_id: NO_VENDOR,
            product_name: "Device".to_owned(),
            product_code: 1,
            revision: 0x0001_0000,
            author: "Vendor".to_owned(),
            date,
            time,
        })
    }
}

/// Date and time of `SOURCE_DATE_EPOCH`, otherwise the current ones, in Coordinated Universal Time; `None` if
/// the clock has no valid date.
pub fn now() -> Option<(Date, ClockTime)> {
    let epoch = std::env::var("SOURCE_DATE_EPOCH").ok().and_then(|text| text.parse().ok());
    let now = || SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let seconds: u64 = epoch.unwrap_or_else(now);
    let minutes = seconds / 60 % (24 * 60);
    let time = u8::try_from(minutes / 60).ok().zip(u8::try_from(minutes % 60).ok());
    let time = time.and_then(|(hour, minute)| ClockTime::new(hour, minute)).unwrap_or(MIDNIGHT);
    Date::after_1970(seconds / (24 * 60 * 60)).map(|date| (date, time))
}

//! Profiles, as a page offers them.

use objdict::scaffold::{FEATURES, Feature, FeatureKind, PROFILES};
use serde_json::{Value, json};

/// What a page asks for a feature.
fn feature(feature: &Feature) -> Value {
    let (kind, range) = match feature.kind {
        FeatureKind::Flag => ("flag", None),
        FeatureKind::Number { lowest, highest } => ("number", Some([lowest, highest])),
        FeatureKind::Bits { .. } => ("names", None),
        _ => ("name", None),
    };
    json!({
        "word": feature.word,
        "kind": kind,
        "range": range,
        "names": feature.kind.names(),
        "meaning": feature.meaning,
        "is_general": feature.profiles.is_empty(),
    })
}

/// The profiles that devices are made of, with their features.
pub(crate) fn list() -> Value {
    let rows = PROFILES.iter().map(|&(number, ..)| {
        let profile = objdict::profile::of_number(number);
        let title =
            profile.map_or_else(|| "without a profile".to_owned(), |profile| profile.title.to_string());
        let features = FEATURES.iter().filter(|feature| feature.is_of(number)).map(feature);
        json!({ "number": number, "title": title, "features": features.collect::<Vec<_>>() })
    });
    rows.collect::<Vec<_>>().into()
}

/// Objects of a range are listed one by one up to so many.
const MAX_RANGE: usize = 8;

/// The objects of a profile and of CiA 301, and whether a device has them.
pub(crate) fn objects(profile: u16, has: impl Fn(u16) -> bool) -> Value {
    let of_profile = objdict::profile::of_number(profile);
    let documents = objdict::profile::named("301").into_iter().chain(of_profile);
    let objects = documents.flat_map(objdict::profile::Profile::objects);
    let rows = objects.flat_map(|facts| {
        (facts.first..=facts.last).take(MAX_RANGE).map(move |index| (index, facts.name, facts.object_type()))
    });
    let rows: Vec<Value> = rows
        .map(|(index, name, kind)| json!({ "index": index, "name": name, "kind": kind.name(), "has": has(index) }))
        .collect();
    rows.into()
}

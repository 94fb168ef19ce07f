//! The parameter groups of an XDD.

use std::collections::HashMap;

use super::anchor::Anchor;
use super::context::Context;
use crate::model::{Device, Parameter, ParameterGroup};

/// Maximum nesting depth; deeper groups are shown at this level.
const MAX_DEPTH: usize = 8;

/// A group of parameters.
pub(crate) struct ShownGroup<'a> {
    /// Nesting depth.
    pub(crate) depth: usize,
    /// Empty if there is none.
    pub(crate) name: &'a str,
    /// Empty if there is none.
    pub(crate) description: &'a str,
    /// The objects and entries of its parameters.
    pub(crate) members: Vec<GroupParameter>,
}

/// A member of a group.
pub(crate) struct GroupParameter {
    /// The anchor in the page; `None` for a parameter without an entry.
    pub(crate) anchor: Option<Anchor>,
    /// Its name, or the id of a parameter without name and entry.
    pub(crate) name: String,
}

/// All groups, each before its subgroups.
pub(super) fn groups<'a>(context: &Context<'a>) -> Vec<ShownGroup<'a>> {
    let mut groups = Vec::new();
    let top: Vec<&ParameterGroup> =
        context.device.application.iter().flat_map(|process| &process.groups).collect();
    if top.is_empty() {
        return groups;
    }
    let members = GroupParameters::new(context.device);
    for group in top {
        add(context, &members, group, 0, &mut groups);
    }
    groups
}

fn add<'a>(
    context: &Context<'a>,
    members: &GroupParameters<'a>,
    group: &'a ParameterGroup,
    depth: usize,
    groups: &mut Vec<ShownGroup<'a>>,
) {
    groups.push(ShownGroup {
        depth: depth.min(MAX_DEPTH),
        name: group.labels.name_in(context.tag).unwrap_or_default(),
        description: group.labels.description_in(context.tag).unwrap_or_default(),
        members: group.parameters.iter().map(|id| members.member(context, id)).collect(),
    });
    for inner in &group.groups {
        add(context, members, inner, depth + 1, groups);
    }
}

/// The parameters of a device by their ids.
struct GroupParameters<'a> {
    /// Places of parameters with an entry.
    places: HashMap<&'a str, (u16, Option<u8>)>,
    /// Parameters without an entry, or with several.
    free: HashMap<&'a str, &'a Parameter>,
}

impl<'a> GroupParameters<'a> {
    /// For equal ids the first parameter applies.
    fn new(device: &'a Device) -> Self {
        let mut places = HashMap::new();
        for (&index, object) in &device.objects {
            for (sub, entry) in object.described() {
                let id = entry.parameter.as_ref().map(|parameter| &*parameter.unique_id);
                if let Some(id) = id.filter(|id| !id.is_empty()) {
                    places.entry(id).or_insert((index, sub));
                }
            }
        }
        let mut free = HashMap::new();
        for parameter in device.application.iter().flat_map(|process| &process.parameters) {
            free.entry(&*parameter.unique_id).or_insert(parameter);
        }
        Self { places, free }
    }

    fn member(&self, context: &Context<'a>, id: &str) -> GroupParameter {
        let place = self.places.get(id).copied().or_else(|| implied(id));
        let found = place.and_then(|(index, sub)| {
            let object = context.device.object(index)?;
            let main = || Some(&object.main).filter(|_| sub.is_none());
            Some((Anchor { index, sub }, sub.and_then(|sub| object.subs.get(sub)).or_else(main)?))
        });
        match found {
            Some((anchor, entry)) => {
                GroupParameter { anchor: Some(anchor), name: context.name(entry).to_owned() }
            }
            None => {
                let label = self.free.get(id).and_then(|parameter| parameter.labels.name_in(context.tag));
                GroupParameter { anchor: None, name: label.map_or(id, str::trim).to_owned() }
            }
        }
    }
}

/// The place encoded in the id of a parameter without its own id; see [`Parameter::usual_id`].
fn implied(id: &str) -> Option<(u16, Option<u8>)> {
    let (digits, has_sub) = match id.strip_prefix("UID_OBJ_") {
        Some(digits) => (digits, false),
        None => (id.strip_prefix("UID_SUB_")?, true),
    };
    let number = u32::from_str_radix(digits, 16).ok()?;
    let place = match has_sub {
        false => (u16::try_from(number).ok()?, None),
        true => (u16::try_from(number >> 8).ok()?, Some((number & 0xFF) as u8)),
    };
    (Parameter::usual_id(place.0, place.1) == id).then_some(place)
}

#[cfg(test)]
mod tests {
    use super::implied;

    #[test]
    fn usual_ids_name_their_places() {
        assert_eq!(implied("UID_OBJ_1018"), Some((0x1018, None)));
        assert_eq!(implied("UID_SUB_10180A"), Some((0x1018, Some(10))));
        for other in ["UID_OBJ_", "UID_OBJ_+018", "UID_SUB_1018", "UID_PARAM_1018", ""] {
            assert_eq!(implied(other), None, "{other}");
        }
    }
}

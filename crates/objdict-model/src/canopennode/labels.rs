//! Count labels: the service of CANopenNode that an object belongs to.

use std::collections::BTreeMap;

use crate::model::Object;

/// The indexes of each label.
const LABELS: &[(&str, u16, u16)] = &[
    ("NMT", 0x1000, 0x1000),
    ("EM", 0x1001, 0x1001),
    ("SYNC", 0x1005, 0x1005),
    ("SYNC_PROD", 0x1006, 0x1006),
    ("STORAGE", 0x1010, 0x1010),
    ("TIME", 0x1012, 0x1012),
    ("EM_PROD", 0x1014, 0x1014),
    ("HB_CONS", 0x1016, 0x1016),
    ("HB_PROD", 0x1017, 0x1017),
    ("SDO_SRV", 0x1200, 0x127F),
    ("SDO_CLI", 0x1280, 0x12FF),
    ("GFC", 0x1300, 0x1300),
    ("SRDO", 0x1301, 0x1340),
    ("RPDO", 0x1400, 0x15FF),
    ("TPDO", 0x1800, 0x19FF),
];

/// The objects of each label. The labels are in the order of their first objects.
#[derive(Debug, Default)]
pub struct Counters {
    labels: Vec<String>,
    objects: BTreeMap<String, Vec<u16>>,
}

impl Counters {
    /// Counts objects.
    pub fn new<'a>(objects: impl Iterator<Item = (u16, &'a Object)>) -> Self {
        let mut counters = Self::default();
        for (index, object) in objects {
            let Some(label) = label(index, object) else { continue };
            if !counters.objects.contains_key(&label) {
                counters.labels.push(label.clone());
            }
            counters.objects.entry(label).or_default().push(index);
        }
        counters
    }

    /// The objects of a label, by index.
    pub(crate) fn of(&self, label: &str) -> &[u16] {
        self.objects.get(label).map_or(&[], Vec::as_slice)
    }

    /// The number of objects of a label.
    pub fn count(&self, label: &str) -> usize {
        self.of(label).len()
    }

    /// Labels and their counts.
    pub fn iter(&self) -> impl Iterator<Item = (&str, usize)> {
        self.labels.iter().map(|label| (label.as_str(), self.count(label)))
    }
}

/// The label of an object: that of the description, even if empty, otherwise that of its index.
fn label(index: u16, object: &Object) -> Option<String> {
    let stated = object.main.stack.as_ref().and_then(|stack| stack.count_label.as_deref());
    if let Some(stated) = stated {
        let word = stated.trim().replace(|c: char| !c.is_ascii_alphanumeric() && c != '_', "_");
        let is_array = word.starts_with("ARR_"); // an ARRAY counts its elements
        return (!word.is_empty()).then(|| if is_array { format!("{word}_") } else { word });
    }
    let of_index = LABELS.iter().find(|(_, first, last)| (*first..=*last).contains(&index));
    of_index.map(|(label, ..)| (*label).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Entry;

    #[test]
    fn what_the_description_states_comes_first() {
        let stated = |label: &str| {
            let mut main = Entry::default();
            main.stack_mut().count_label = Some(label.into());
            Object { main, ..Object::default() }
        };
        assert_eq!(label(0x1000, &Object::default()).as_deref(), Some("NMT"));
        assert_eq!(label(0x19FF, &Object::default()).as_deref(), Some("TPDO"));
        assert_eq!(label(0x2000, &Object::default()), None);
        assert_eq!(label(0x2000, &stated("my label")).as_deref(), Some("my_label"));
        assert_eq!(label(0x1000, &stated("")), None);
        assert_eq!(label(0x2000, &stated("ARR_1003")).as_deref(), Some("ARR_1003_"));
    }
}

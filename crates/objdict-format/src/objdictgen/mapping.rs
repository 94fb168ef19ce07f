//! objdictgen's definitions of objects: names, types and structures, for CiA 301 from a table and for others
//! from the project.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::pickle::{Pickle, PickleDatum};
use objdict_model::model::{Access, DataType};
use objdict_xdd::xml::Element;

/// The structure of an object, as bits of its `struct`.
const ALIKE: i64 = 4;
const SEVERAL_INDEXES: i64 = 8;

/// The maximum number of descriptions of several objects: real profiles have some dozens.
const MOST_SERIES: usize = 64;

/// A description of an object, or of several with equidistant indexes.
#[derive(Default)]
pub(super) struct DescriptionForm<'a> {
    pub(super) name: Option<Cow<'a, str>>,
    structure: Option<i64>,
    /// The distance between the indexes, and their number.
    step: i64,
    count: i64,
    pub(super) callback: Option<bool>,
    subs: Vec<SubForm<'a>>,
}

/// A description of an entry, or of several consecutive ones.
#[derive(Clone, Default)]
pub(super) struct SubForm<'a> {
    pub(super) name: Option<Cow<'a, str>>,
    pub(super) data_type: Option<DataType>,
    pub(super) access: Option<Access>,
    pub(super) mappable: Option<bool>,
    /// Their number, if stated.
    count: Option<i64>,
}

/// The descriptions of one source.
#[derive(Default)]
pub(super) struct ObjectMapping<'a> {
    forms: BTreeMap<u16, DescriptionForm<'a>>,
    /// The first index of each object that is one of several.
    series: BTreeMap<u16, u16>,
}

impl<'a> DescriptionForm<'a> {
    pub(super) fn is_array(&self) -> Option<bool> {
        self.structure.map(|structure| structure & ALIKE != 0)
    }

    /// The description of a sub-index.
    fn sub(&self, sub: u8) -> Option<&SubForm<'a>> {
        let wanted = i64::from(sub);
        if self.is_array() == Some(true) {
            let elements =
                self.subs.get(1).filter(|elements| elements.count.is_none_or(|count| wanted <= count));
            return if sub == 0 { self.subs.first() } else { elements };
        }
        let mut first = 0_i64;
        self.subs.iter().find(|form| {
            first = first.saturating_add(form.count.unwrap_or(1));
            wanted < first
        })
    }

    fn read(pickle: &Pickle<'a>, map: Element<'a>) -> Self {
        let mut form = DescriptionForm { step: 1, ..Self::default() };
        for (key, value) in pickle.fields(map) {
            match &*key {
                "name" => form.name = pickle.text(value),
                "struct" => form.structure = pickle.number(value),
                "incr" => form.step = pickle.number(value).unwrap_or(1),
                "nbmax" => form.count = pickle.number(value).unwrap_or(0),
                "callback" => form.callback = pickle.flag(value),
                "values" => {
                    if let Some(PickleDatum::List(list)) = pickle.datum(value) {
                        let maps = list.children_named("item").filter_map(|item| match pickle.datum(item) {
                            Some(PickleDatum::Map(map)) => Some(map),
                            _ => None,
                        });
                        form.subs = maps.take(256).map(|map| SubForm::read(pickle, map)).collect();
                    }
                }
                _ => {}
            }
        }
        form
    }
}

impl<'a> SubForm<'a> {
    fn read(pickle: &Pickle<'a>, map: Element<'a>) -> Self {
        let mut form = Self::default();
        for (key, value) in pickle.fields(map) {
            match &*key {
                "name" => form.name = pickle.text(value),
                "type" => {
                    form.data_type =
                        pickle.number(value).and_then(|number| u16::try_from(number).ok()).map(DataType);
                }
                "access" => form.access = pickle.text(value).and_then(|access| Access::from_name(&access)),
                "pdo" => form.mappable = pickle.flag(value),
                "nbmax" => form.count = pickle.number(value),
                _ => {}
            }
        }
        form
    }
}

impl<'a> ObjectMapping<'a> {
    /// The descriptions of a map in the project; those that the device does not use are skipped.
    pub(super) fn read(pickle: &Pickle<'a>, map: Element<'a>) -> Self {
        let forms = pickle.numbered(map).filter_map(|(index, value)| match pickle.datum(value)? {
            PickleDatum::Map(map) => Some((index, DescriptionForm::read(pickle, map))),
            _ => None,
        });
        Self::new(forms.collect())
    }

    fn new(forms: BTreeMap<u16, DescriptionForm<'a>>) -> Self {
        let mut series = BTreeMap::new();
        let several = forms.iter().filter(|(_, form)| form.structure.unwrap_or(0) & SEVERAL_INDEXES != 0);
        for (&first, form) in several.take(MOST_SERIES) {
            let step = form.step.max(1);
            let numbers = (1..form.count.min(1 << 16)).map_while(|number| {
                number.checked_mul(step).and_then(|distance| u16::try_from(i64::from(first) + distance).ok())
            });
            for index in numbers.filter(|index| !forms.contains_key(index)) {
                series.entry(index).or_insert(first);
            }
        }
        Self { forms, series }
    }

    /// The descriptions of CiA 301 as objdictgen has them.
    pub(super) fn of_cia301() -> ObjectMapping<'static> {
        let mut forms: BTreeMap<u16, DescriptionForm<'static>> = BTreeMap::new();
        let mut last = 0;
        for line in include_str!("objects.txt").lines() {
            let (facts, name) = line.split_once(": ").unwrap_or_default();
            let mut words = facts.split_ascii_whitespace();
            let number = words.next().and_then(|word| u16::from_str_radix(word, 16).ok()).unwrap_or_default();
            let second = words.next().unwrap_or_default();
            let count = |word: &str| i64::from_str_radix(word.strip_prefix('x')?, 16).ok();
            let name = Some(Cow::Borrowed(name));
            if line.starts_with(' ') {
                let mut sub = SubForm { name, data_type: Some(DataType(number)), ..SubForm::default() };
                (sub.access, sub.mappable) = (Access::from_name(second), Some(false));
                for word in words {
                    match count(word) {
                        Some(count) => sub.count = Some(count),
                        None => sub.mappable = Some(word == "pdo"),
                    }
                }
                if let Some(form) = forms.get_mut(&last) {
                    form.subs.push(sub);
                }
            } else {
                let structure = i64::from_str_radix(second, 16).ok();
                let mut form = DescriptionForm { name, structure, step: 1, ..DescriptionForm::default() };
                for word in words {
                    match count(word) {
                        Some(count) => form.count = count,
                        None => form.callback = Some(word == "callback"),
                    }
                }
                last = number;
                forms.insert(number, form);
            }
        }
        ObjectMapping::new(forms)
    }

    fn form(&self, index: u16) -> Option<(u16, &DescriptionForm<'a>)> {
        let first = self.series.get(&index).copied().unwrap_or(index);
        self.forms.get(&first).map(|form| (first, form))
    }
}

/// The description of an object: from the project, supplemented by CiA 301.
pub(super) struct DescribedObject<'m, 'a> {
    index: u16,
    of_project: Option<(u16, &'m DescriptionForm<'a>)>,
    of_cia301: Option<(u16, &'m DescriptionForm<'a>)>,
}

impl<'m, 'a> DescribedObject<'m, 'a> {
    /// `None` if none of the mappings, the last of which is that of CiA 301, defines the object.
    pub(super) fn new(mappings: &'m [ObjectMapping<'a>], index: u16) -> Option<Self> {
        let (of_cia301, of_project) = mappings.split_last()?;
        let of_project = of_project.iter().find_map(|mapping| mapping.form(index));
        let of_cia301 = of_cia301.form(index);
        (of_project.is_some() || of_cia301.is_some()).then_some(Self { index, of_project, of_cia301 })
    }

    /// A property of the object, with the first index of its series.
    fn first<T>(&self, fact: impl Fn(&'m DescriptionForm<'a>) -> Option<T>) -> Option<(u16, T)> {
        let forms = [self.of_project, self.of_cia301].into_iter().flatten();
        forms.into_iter().find_map(|(first, form)| Some((first, fact(form)?)))
    }

    pub(super) fn fact<T>(&self, fact: impl Fn(&'m DescriptionForm<'a>) -> Option<T>) -> Option<T> {
        self.first(fact).map(|(_, found)| found)
    }

    /// The number of the object in its series, from 0.
    pub(super) fn number(&self) -> i64 {
        let Some((first, form)) = self.of_project.or(self.of_cia301) else { return 0 };
        i64::from(self.index.saturating_sub(first)) / form.step.max(1)
    }

    pub(super) fn sub(&self, sub: u8) -> SubForm<'a> {
        let of_project = self.of_project.and_then(|(_, form)| form.sub(sub)).cloned().unwrap_or_default();
        let of_cia301 = self.of_cia301.and_then(|(_, form)| form.sub(sub)).cloned().unwrap_or_default();
        SubForm {
            name: of_project.name.or(of_cia301.name),
            data_type: of_project.data_type.or(of_cia301.data_type),
            access: of_project.access.or(of_cia301.access),
            mappable: of_project.mappable.or(of_cia301.mappable),
            count: None,
        }
    }
}

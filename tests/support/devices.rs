//! Arbitrary devices: whatever a description may say, healthy or not.

use std::collections::BTreeMap;

use objdict::model::{
    Access, BaudRates, ClockTime, Commissioning, Compact, Configured, DataType, Date, Device, DeviceInfo,
    DeviceKind, DummyUsage, DynamicChannels, Entry, Extension, ExtensionCount, Extra, ExtraSection, Field,
    FileInfo, InvalidValues, Module, Modules, ObjFlags, Object, ObjectLists, ObjectType, PdoMapping, Reason,
    SafetyMapping, Segment, Subs, Time, ToolCommand, TypeKind, Value,
};
use proptest::collection::{btree_map, btree_set, vec};
use proptest::option;
use proptest::prelude::*;
use proptest::sample::{select, subsequence};

/// What the texts of a device may consist of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Texts {
    /// What a line of an INI file can hold: printable ASCII without blanks at its ends.
    Ascii,
    /// Anything that is text.
    Any,
}

impl Texts {
    /// A text of a field, perhaps empty.
    fn text(self) -> BoxedStrategy<String> {
        match self {
            Self::Ascii => prop_oneof!["[ -~]{0,12}", "[;#\"=\\[\\]$0-9a-z]{0,4}"]
                .prop_map(|text| text.trim().to_owned())
                .boxed(),
            Self::Any => prop_oneof![any::<String>(), "[ -~]{0,12}"].boxed(),
        }
    }

    /// A text of a field that is missing where it is empty.
    fn some_text(self) -> BoxedStrategy<Box<str>> {
        let text = self.text().prop_map(|text| if text.is_empty() { "x".to_owned() } else { text });
        text.prop_map(String::into).boxed()
    }

    /// A string as a value: blanks at its ends count.
    fn string(self) -> BoxedStrategy<Box<str>> {
        match self {
            Self::Ascii => prop_oneof!["[ -~]{0,12}", "[ \"]{0,4}"].prop_map(String::into).boxed(),
            Self::Any => any::<String>().prop_map(String::into).boxed(),
        }
    }

    fn extra(self) -> BoxedStrategy<Extra> {
        let keys = subsequence(vec!["Colour", "Group", "Vendor:Key", "1_Sub0", "Übung"], 0..=2);
        let keys = keys
            .prop_filter("ISO 646", move |keys| self == Self::Any || keys.iter().all(|key| key.is_ascii()));
        let extra = (keys, vec(self.text(), 2)).prop_map(|(keys, values)| {
            let mut extra = Extra::default();
            keys.into_iter().zip(values).for_each(|(key, value)| extra.push(key, &value));
            extra
        });
        prop_oneof![4 => Just(Extra::default()), 1 => extra].boxed()
    }
}

fn data_type() -> BoxedStrategy<Option<DataType>> {
    let own = [DataType(0x40), DataType(0x60), DataType(0x23)];
    let types: Vec<DataType> = DataType::STATIC.iter().copied().chain(own).collect();
    option::weighted(0.9, select(types)).boxed()
}

/// A value of a data type.
fn value(data_type: Option<DataType>, texts: Texts) -> BoxedStrategy<Value> {
    let Some(data_type) = data_type else { return texts.some_text().prop_map(Value::Raw).boxed() };
    if let Some((low, high)) = data_type.integer_range() {
        let number = prop_oneof![low..=high, Just(low), Just(high), 0i128..=1]
            .prop_map(move |number| Value::from_integer(number, data_type).unwrap());
        let formula = prop_oneof![0u64..=1, any::<u64>()].prop_map(Value::NodeId);
        return match data_type.is_integer() {
            true => prop_oneof![4 => number, 1 => formula].boxed(),
            false => number.boxed(),
        };
    }
    match data_type.kind() {
        TypeKind::Real32 => any::<u32>().prop_map(|bits| Value::Real32(f32::from_bits(bits))).boxed(),
        TypeKind::Real64 => any::<u64>().prop_map(|bits| Value::Real64(f64::from_bits(bits))).boxed(),
        TypeKind::VisibleString | TypeKind::UnicodeString => texts.string().prop_map(Value::Text).boxed(),
        TypeKind::OctetString | TypeKind::Domain => {
            vec(any::<u8>(), 0..6).prop_map(|bytes| Value::Bytes(bytes.into())).boxed()
        }
        TypeKind::TimeOfDay | TypeKind::TimeDifference => (any::<u16>(), 0u32..1 << 28)
            .prop_map(|(days, milliseconds)| Value::Time(Time { days, milliseconds }))
            .boxed(),
        _ => texts.some_text().prop_map(Value::Raw).boxed(),
    }
    .boxed()
}

fn configured(data_type: Option<DataType>, texts: Texts) -> BoxedStrategy<Option<Box<Configured>>> {
    let text = || option::weighted(0.2, texts.some_text());
    let configured = (option::of(value(data_type, texts)), text(), text(), text(), text()).prop_map(
        |(value, denotation, upload_file, download_file, reference_designator)| Configured {
            value,
            denotation,
            upload_file,
            download_file,
            reference_designator,
        },
    );
    let some = configured.prop_map(|configured| Some(Box::new(configured)));
    let some =
        some.prop_map(|configured| configured.filter(|configured| **configured != Configured::default()));
    prop_oneof![2 => Just(None), 1 => some].boxed()
}

fn safety() -> BoxedStrategy<Option<Box<SafetyMapping>>> {
    let safety = (option::of(any::<bool>()), any::<u32>())
        .prop_map(|(srdo_mapping, srad)| SafetyMapping { srdo_mapping, inverted_srad: Some(srad) });
    option::weighted(0.1, safety.prop_map(Box::new)).boxed()
}

/// An entry with this object type.
fn entry(object_type: Option<ObjectType>, texts: Texts) -> BoxedStrategy<Entry> {
    data_type()
        .prop_flat_map(move |data_type| {
            // a DOMAIN whose type is not stated has the type DOMAIN all the same
            let of = match (data_type, object_type) {
                (None, Some(ObjectType::Domain)) => Some(DataType::DOMAIN),
                _ => data_type,
            };
            let limit = || option::weighted(0.3, value(of, texts));
            let facts = (
                texts.text(),
                option::of(select(Access::ALL.to_vec())),
                option::of(select(vec![PdoMapping::No, PdoMapping::Optional])),
                option::weighted(0.2, any::<u32>().prop_map(ObjFlags)),
                safety(),
                texts.extra(),
                any::<bool>(),
            );
            let values = (option::of(value(of, texts)), limit(), limit(), configured(of, texts));
            (facts, values).prop_map(move |(facts, (default, low_limit, high_limit, configured))| {
                let (name, access, pdo_mapping, flags, safety, extra, damaged) = facts;
                let mut entry = Entry {
                    name: name.into(),
                    object_type,
                    data_type,
                    access,
                    pdo_mapping,
                    default,
                    low_limit,
                    high_limit,
                    flags,
                    configured,
                    safety,
                    extra,
                    invalid_values: InvalidValues::default(),
                    ..Entry::default()
                };
                if damaged {
                    damage(&mut entry);
                }
                entry
            })
        })
        .boxed()
}

/// Texts that are not valid values, in fields without a value, in the order in which a reader finds them.
fn damage(entry: &mut Entry) {
    if entry.access.is_none() {
        entry.invalid_values.push(Field::AccessType, "sometimes", Reason::UnknownWord);
    }
    if entry.default.is_none() && entry.data_type.is_some_and(DataType::is_integer) {
        entry.invalid_values.push(Field::DefaultValue, "0x1G", Reason::NotANumber);
    }
}

fn subs(texts: Texts) -> BoxedStrategy<Subs> {
    let object_type = select(vec![Some(ObjectType::Var), None, Some(ObjectType::Domain)]);
    let sub = object_type.prop_flat_map(move |object_type| entry(object_type, texts));
    btree_map(prop_oneof![0u8..4, any::<u8>()], sub, 0..4).prop_map(|subs| subs.into_iter().collect()).boxed()
}

fn compact(data_type: Option<DataType>, texts: Texts) -> BoxedStrategy<Compact> {
    (1u8..=6)
        .prop_flat_map(move |count| {
            let names = btree_map(1..=count, texts.text().prop_map(String::into), 0..3);
            let values = btree_map(1..=count, value(data_type, texts), 0..3);
            let denotations = btree_map(1..=count, texts.text().prop_map(String::into), 0..3);
            (names, values, denotations).prop_map(move |(names, values, denotations)| Compact {
                count,
                names: names.into_iter().collect(),
                values: values.into_iter().collect(),
                denotations: denotations.into_iter().collect(),
                ..Compact::default()
            })
        })
        .boxed()
}

fn object(texts: Texts) -> BoxedStrategy<Object> {
    let single =
        select(vec![None, Some(ObjectType::Var), Some(ObjectType::Domain), Some(ObjectType::DefType)])
            .prop_flat_map(move |object_type| entry(object_type, texts))
            .prop_map(|main| Object { main, ..Object::default() });
    let structured = || select(vec![ObjectType::Array, ObjectType::Record, ObjectType::DefStruct]);
    let with_subs = (structured(), subs(texts), texts.text()).prop_map(|(object_type, subs, name)| {
        let count = subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
        let main = Entry { name: name.into(), object_type: Some(object_type), ..Entry::default() };
        Object { main, sub_number: u8::try_from(count).ok(), subs, ..Object::default() }
    });
    let compact = structured()
        .prop_flat_map(move |object_type| entry(Some(object_type), texts))
        .prop_flat_map(move |main| {
            let compact = compact(main.data_type, texts);
            compact.prop_map(move |compact| {
                let main = Entry { invalid_values: InvalidValues::default(), ..main.clone() };
                Object { main, compact: Some(Box::new(compact)), ..Object::default() }
            })
        });
    let orphan = subs(texts).prop_filter("something must be described", |subs| !subs.is_empty());
    let orphan = orphan.prop_map(|subs| Object { orphan: true, subs, ..Object::default() });
    let links = prop_oneof![9 => Just(Vec::new()), 1 => vec(1u16.., 1..3)];
    (prop_oneof![6 => single, 6 => with_subs, 3 => compact, 1 => orphan], links)
        .prop_map(|(object, links)| Object { links, ..object })
        .boxed()
}

fn objects(texts: Texts) -> BoxedStrategy<BTreeMap<u16, Object>> {
    btree_map(
        prop_oneof![0x40u16..0x60, 0x1000u16..0x1020, 0x2000u16.., 0x1400u16..0x1C00],
        object(texts),
        0..6,
    )
    .boxed()
}

fn date() -> BoxedStrategy<Date> {
    (0u16..10_000, 1u8..=12, 1u8..=28)
        .prop_map(|(year, month, day)| Date::new(year, month, day).unwrap())
        .boxed()
}

fn clock_time() -> BoxedStrategy<ClockTime> {
    (0u8..24, 0u8..60).prop_map(|(hour, minute)| ClockTime::new(hour, minute).unwrap()).boxed()
}

fn file_info(texts: Texts) -> BoxedStrategy<FileInfo> {
    let text = || option::of(texts.text());
    let texts_of = (text(), text(), text(), text(), text(), text());
    let times = (option::of(clock_time()), option::of(date()), option::of(clock_time()), option::of(date()));
    (texts_of, times, any::<(Option<u8>, Option<u8>)>(), texts.extra(), any::<bool>())
        .prop_map(|(texts, times, (file_version, file_revision), extra, damaged)| {
            let (file_name, eds_version, description, created_by, modified_by, last_eds) = texts;
            let (creation_time, creation_date, modification_time, modification_date) = times;
            let mut invalid_values = InvalidValues::default();
            if damaged && creation_date.is_none() {
                invalid_values.push(Field::CreationDate, "31.02.2024", Reason::NotADate);
            }
            FileInfo {
                file_name,
                file_version,
                file_revision,
                eds_version,
                description,
                creation_time,
                creation_date,
                created_by,
                modification_time,
                modification_date,
                modified_by,
                last_eds,
                extra,
                invalid_values,
                ..FileInfo::default()
            }
        })
        .boxed()
}

fn device_info(texts: Texts) -> BoxedStrategy<DeviceInfo> {
    let text = || option::of(texts.text());
    let numbers = any::<(Option<u32>, Option<u32>, Option<u32>)>();
    let counts = (option::of(0u16..=512), option::of(0u16..=512), option::of(0u8..=64));
    let flags = any::<(Option<bool>, Option<bool>, Option<bool>, Option<bool>, Option<bool>)>();
    let rates = any::<(Option<bool>, Option<bool>, Option<bool>, Option<bool>)>();
    (
        (text(), text(), text()),
        numbers,
        flags,
        rates,
        (counts, any::<(Option<u8>, Option<u8>)>()),
        texts.extra(),
    )
        .prop_map(|(texts, numbers, flags, rates, (counts, (channels, compact_pdo)), extra)| DeviceInfo {
            vendor_name: texts.0,
            vendor_number: numbers.0,
            product_name: texts.1,
            product_number: numbers.1,
            revision_number: numbers.2,
            order_code: texts.2,
            baud_rates: BaudRates {
                kbit_10: rates.0,
                kbit_500: rates.1,
                kbit_1000: rates.2,
                auto: rates.3,
                ..BaudRates::default()
            },
            simple_boot_up_master: flags.0,
            simple_boot_up_slave: flags.1,
            granularity: counts.2,
            dynamic_channels_supported: channels,
            group_messaging: flags.2,
            rpdo_count: counts.0,
            tpdo_count: counts.1,
            lss_supported: flags.3,
            compact_pdo,
            safety_supported: flags.4,
            extra,
            invalid_values: InvalidValues::default(),
            ..DeviceInfo::default()
        })
        .boxed()
}

fn dummy_usage(texts: Texts) -> BoxedStrategy<DummyUsage> {
    let types = btree_map((1u16..0x20).prop_map(DataType), any::<bool>(), 0..4);
    (types, texts.extra())
        .prop_map(|(types, extra)| DummyUsage { types, extra, invalid_values: InvalidValues::default() })
        .boxed()
}

fn commissioning(texts: Texts) -> BoxedStrategy<Commissioning> {
    let text = || option::of(texts.text());
    let numbers = any::<(Option<u8>, Option<u16>, Option<u32>, Option<u32>, Option<bool>)>();
    ((text(), text(), text(), text()), numbers, texts.extra())
        .prop_map(|(texts, numbers, extra)| Commissioning {
            node_id: numbers.0,
            node_name: texts.0,
            node_reference_designator: texts.1,
            baud_rate: numbers.1,
            net_number: numbers.2,
            network_name: texts.2,
            net_reference_designator: texts.3,
            manager: numbers.4,
            lss_serial_number: numbers.3,
            extra,
            invalid_values: InvalidValues::default(),
        })
        .boxed()
}

fn extension(texts: Texts) -> BoxedStrategy<Extension> {
    let count =
        prop_oneof![(1u8..).prop_map(ExtensionCount::Subs), (1u8..).prop_map(ExtensionCount::SharedBits)];
    (entry(None, texts), option::of(count), any::<Option<u8>>())
        .prop_map(|(entry, count, obj_extend)| Extension { entry, count, obj_extend })
        .boxed()
}

fn boxed<T>(map: std::collections::BTreeMap<u16, T>) -> std::collections::BTreeMap<u16, Box<T>> {
    map.into_iter().map(|(index, item)| (index, Box::new(item))).collect()
}

fn module(texts: Texts) -> BoxedStrategy<Module> {
    let text = || option::of(texts.text());
    let lists = (vec(1u16.., 0..3), vec(1u16.., 0..3));
    let objects = (
        btree_map(0x6000u16..0x6010, object(texts), 0..2),
        btree_map(0x6000u16..0x6010, extension(texts), 0..2),
    );
    (
        text(),
        text(),
        any::<(Option<u8>, Option<u8>)>(),
        vec(texts.text(), 0..2),
        lists,
        objects,
        texts.extra(),
    )
        .prop_map(|(product_name, order_code, versions, comments, lists, (fixed, extensions), extra)| {
            Module {
                product_name,
                product_version: versions.0,
                product_revision: versions.1,
                order_code,
                comments,
                fixed_list: lists.0,
                fixed: fixed
                    .into_iter()
                    .map(|(index, object)| (index, of_module(object)))
                    .filter(|(_, object)| !object.orphan || !object.subs.is_empty())
                    .map(|(index, object)| (index, Box::new(object)))
                    .collect(),
                extension_list: lists.1,
                extensions: boxed(extensions),
                extra,
                invalid_values: InvalidValues::default(),
            }
        })
        .boxed()
}

/// What modules bring has neither compact storage nor links.
fn of_module(object: Object) -> Object {
    let sub_number = if object.compact.is_some() { Some(0) } else { object.sub_number };
    Object { sub_number, compact: None, links: Vec::new(), ..object }
}

fn modules(texts: Texts) -> BoxedStrategy<Modules> {
    let supported = btree_map(1u16..5, module(texts), 0..3);
    (supported, any::<u16>(), option::of(vec(any::<u16>(), 0..4)))
        .prop_map(|(supported, declared, connected)| Modules {
            declared: Some(declared),
            supported,
            connected,
            ..Modules::default()
        })
        .boxed()
}

fn dynamic_channels(texts: Texts) -> BoxedStrategy<DynamicChannels> {
    let text = || option::of(texts.some_text());
    let segment = (any::<u16>(), text(), any::<Option<(u16, u16)>>(), text()).prop_map(
        |(data_type, direction, range, offset)| Segment {
            data_type: Some(DataType(data_type)),
            direction,
            range,
            offset,
            ..Segment::default()
        },
    );
    (vec(segment, 0..3), texts.extra())
        .prop_map(|(segments, extra)| DynamicChannels {
            segments,
            extra,
            invalid_values: InvalidValues::default(),
        })
        .boxed()
}

fn tools(texts: Texts) -> BoxedStrategy<Vec<ToolCommand>> {
    vec((texts.text(), texts.text()).prop_map(|(name, command)| ToolCommand { name, command }), 0..3).boxed()
}

fn extra_sections(texts: Texts) -> BoxedStrategy<Vec<ExtraSection>> {
    let names = subsequence(vec!["VendorSpecific", "ToolInfos", "2000Value2"], 0..=2);
    (names, vec(texts.extra(), 2))
        .prop_map(|(names, entries)| {
            let sections = names.into_iter().zip(entries);
            sections.map(|(name, entries)| ExtraSection::new(name, &entries)).collect()
        })
        .boxed()
}

/// A device; its objects are in the lists, or in other lists.
pub(crate) fn device(texts: Texts) -> BoxedStrategy<Device> {
    let info = (
        option::of(file_info(texts)),
        option::of(device_info(texts)),
        option::of(dummy_usage(texts)),
        option::of(vec(texts.text(), 0..3)),
        option::of(commissioning(texts)),
    );
    let lists = (btree_set(1u16.., 0..3), option::of(vec(1u16.., 0..3)), any::<bool>());
    let rest = (
        option::weighted(0.3, modules(texts)),
        option::weighted(0.3, dynamic_channels(texts)),
        tools(texts),
        extra_sections(texts),
    );
    (info, objects(texts), lists, rest, any::<bool>())
        .prop_map(|(info, objects, lists, rest, is_node)| {
            let (file_info, device_info, dummy_usage, comments, commissioning) = info;
            let (modules, dynamic_channels, tools, extra) = rest;
            let optional =
                if lists.2 { objects.keys().copied().collect() } else { lists.0.into_iter().collect() };
            Device {
                kind: if is_node { DeviceKind::Node } else { DeviceKind::Type },
                file_info,
                device_info,
                dummy_usage,
                comments,
                commissioning: commissioning.filter(|_| is_node),
                lists: ObjectLists { mandatory: lists.1, optional: Some(optional), manufacturer: None },
                objects: objects.into_iter().collect(),
                modules,
                dynamic_channels,
                tools,
                extra,
                ..Device::default()
            }
        })
        .boxed()
}

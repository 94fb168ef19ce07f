//! Any values of the parts.

use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;

use crate::model::{
    AllowedValues, AllowedValuesTemplate, ApplicationProcess, Characteristic, CharacteristicsList,
    CombinedState, Compliance, ConnectedModule, Connection, Count, DataTypeRef, Date, DeviceFunction,
    DeviceIdentity, DeviceManager, DeviceVersion, Dictionary, EnumValue, FunctionInstance, FunctionInstances,
    FunctionType, Label, Labels, Led, LedColor, LedColors, LedOn, LedState, LedType, MemberRef,
    ModuleInterface, ModuleObjects, ModuleRange, ModuleRanges, ModuleType, OwnAddressing, OwnInterface,
    Parameter, ParameterAccess, ParameterGroup, ParameterTemplate, Picture, ProfileHeader, Property,
    ScaledValue, SimpleType, Subrange, Support, TextRef, TypeDefinition, TypeShape, Unit, ValueRange,
    VarDeclaration, VariableRef, VersionInfo,
};
use crate::xdd::shape::Identity;

/// Any value that an XML document can carry.
pub(super) trait Any: Sized + std::fmt::Debug + 'static {
    fn any() -> BoxedStrategy<Self>;
}

fn any<T: Any>() -> BoxedStrategy<T> {
    T::any()
}

/// Texts that are hard to carry: markup, quotes, white space of every kind at every place, other scripts.
const TEXT: &str =
    "[a-zA-Z0-9 ]{0,8}|[<>&\"' \t\r\n;#\\]x]{1,6}|&(amp|#10);|]]>|<!--|[ -~\u{80}-\u{FF}ж本😀\u{FEFF}]{0,6}";

impl Any for Box<str> {
    fn any() -> BoxedStrategy<Self> {
        TEXT.prop_map(Box::from).boxed()
    }
}

impl<T: Any> Any for Option<T> {
    fn any() -> BoxedStrategy<Self> {
        option::of(T::any()).boxed()
    }
}

impl<T: Any> Any for Vec<T> {
    fn any() -> BoxedStrategy<Self> {
        vec(T::any(), 0..3).boxed()
    }
}

impl<T: Any> Any for Box<T> {
    fn any() -> BoxedStrategy<Self> {
        T::any().prop_map(Box::new).boxed()
    }
}

impl Any for Date {
    fn any() -> BoxedStrategy<Self> {
        (0..=9999_u16, 1..=12_u8, 1..=31_u8)
            .prop_filter_map("no date", |(y, m, d)| Self::new(y, m, d))
            .boxed()
    }
}

macro_rules! numbers {
    ($($Number:ty)+) => {$(
        impl Any for $Number {
            fn any() -> BoxedStrategy<Self> {
                proptest::arbitrary::any::<Self>().boxed()
            }
        }
    )+};
}

numbers! { bool u8 u32 }

macro_rules! words {
    ($($Words:ty)+) => {$(
        impl Any for $Words {
            fn any() -> BoxedStrategy<Self> {
                select(Self::ALL).boxed()
            }
        }
    )+};
}

words! { LedColor LedColors LedOn LedType ParameterAccess SimpleType Support }

/// Any value of every field.
macro_rules! parts {
    ($($Part:ident { $($field:ident),+ })+) => {$(
        impl Any for $Part {
            fn any() -> BoxedStrategy<Self> {
                // all of them are there
                let $Part { $($field: _),+ } = $Part::default();
                let part = Just($Part::default()).boxed();
                $(let part = (part, any()).prop_map(|(mut part, value)| {
                    part.$field = value;
                    part
                }).boxed();)+
                part
            }
        }
    )+};
}

parts! {
    TextRef { dictionary, text_id, uri }
    Parameter {
        unique_id, labels, data_type, access, access_list, support, persistent, offset, multiplier, template,
        conditional_support, denotation, actual_value, default_value, substitute_value, allowed_values, unit, properties
    }
    ScaledValue { value, offset, multiplier, labels }
    AllowedValues { template, values, ranges }
    ValueRange { min, max, step }
    Unit { multiplier, uri, labels }
    Property { name, value }
    ParameterTemplate { parameter }
    AllowedValuesTemplate { unique_id, allowed }
    ApplicationProcess {
        data_types, function_types, functions, parameter_templates, allowed_values_templates, parameters, groups
    }
    TypeDefinition { name, unique_id, labels, shape }
    Subrange { low, high }
    EnumValue { labels, value }
    Count { unique_id, access, labels, default_value, allowed_values }
    VarDeclaration {
        name, unique_id, labels, data_type, start, size, signed, offset, multiplier, initial_value,
        conditional_support, default_value, allowed_values, unit
    }
    FunctionType { name, unique_id, package, labels, versions, inputs, outputs, configuration, functions }
    VersionInfo { organization, version, author, date, labels }
    FunctionInstances { instances, connections }
    FunctionInstance { name, unique_id, function_type, labels }
    Connection { source, destination, description }
    VariableRef { position, instances, variable, members }
    MemberRef { unique_id, index }
    DeviceManager { leds, combined_states, module_interfaces, own_interface }
    Led { colors, kind, labels, states }
    LedState { unique_id, state, color, flashing_period, impulse_width, impulses, labels }
    CombinedState { labels, states }
    ModuleInterface { unique_id, max_modules, unused_slots, multiple, labels, files, module_types, connected }
    ModuleType { unique_id, kind }
    ConnectedModule { child, position, address }
    OwnInterface { child_id, kind, max_count }
    ModuleObjects { interfaces, own }
    ModuleRanges { interface, addressing, ranges }
    ModuleRange { name, module_type, base_index, max_index, max_sub_index, sort_mode, sort_number, sort_step }
    OwnAddressing { child, address_min, address_max, addressing }
    DeviceFunction { characteristics, compliance, pictures, dictionaries }
    CharacteristicsList { category, characteristics }
    Characteristic { name, contents }
    Compliance { name, range, labels }
    Picture { uri, number, labels }
    Dictionary { lang, id, uri }
    DeviceVersion { kind, version }
    ProfileHeader { identification, revision, name, source, date, additional_information, interface_types }
}

impl Any for Label {
    fn any() -> BoxedStrategy<Self> {
        prop_oneof![
            (any(), any()).prop_map(|(lang, text)| Self::Name { lang, text }),
            (any(), any(), any()).prop_map(|(lang, text, uri)| Self::Description { lang, text, uri }),
            any().prop_map(Self::NameRef),
            any().prop_map(Self::DescriptionRef),
        ]
        .boxed()
    }
}

impl Any for Labels {
    fn any() -> BoxedStrategy<Self> {
        any().prop_map(Self).boxed()
    }
}

impl Any for DataTypeRef {
    fn any() -> BoxedStrategy<Self> {
        prop_oneof![
            any().prop_map(Self::Simple),
            any().prop_map(Self::Defined),
            vec(any(), 1..3).prop_map(Self::Variables),
        ]
        .boxed()
    }
}

impl Any for TypeShape {
    fn any() -> BoxedStrategy<Self> {
        prop_oneof![
            (any(), any()).prop_map(|(ranges, element)| Self::Array { ranges, element }),
            any().prop_map(|members| Self::Struct { members }),
            (any(), any(), any()).prop_map(|(size, values, base)| Self::Enum { size, values, base }),
            (any(), any()).prop_map(|(count, base)| Self::Derived { count, base }),
        ]
        .boxed()
    }
}

impl Any for ParameterGroup {
    fn any() -> BoxedStrategy<Self> {
        let flat =
            (any(), any(), any(), any()).prop_map(|(unique_id, kind_of_access, labels, parameters)| Self {
                unique_id,
                kind_of_access,
                labels,
                groups: Vec::new(),
                parameters,
            });
        let nested = flat.prop_recursive(3, 6, 2, |group| {
            (group.clone(), vec(group, 0..2)).prop_map(|(group, groups)| Self { groups, ..group })
        });
        nested.boxed()
    }
}

impl Any for DeviceIdentity {
    fn any() -> BoxedStrategy<Self> {
        let texts = (any(), any(), any(), any(), any(), any());
        let values = (any(), any());
        (texts, values)
            .prop_map(|(texts, (versions, build_date))| {
                let (
                    vendor_text,
                    device_family,
                    product_family,
                    product_text,
                    specification_revision,
                    instance_name,
                ) = texts;
                Self {
                    vendor_text,
                    device_family,
                    product_family,
                    product_text,
                    further_order_numbers: Vec::new(),
                    versions,
                    build_date,
                    specification_revision,
                    instance_name,
                    read_only: Vec::new(),
                }
            })
            .boxed()
    }
}

/// An identity in which any element that is there says whether it is read-only.
impl Any for Identity {
    fn any() -> BoxedStrategy<Self> {
        (any(), any(), any(), any(), any(), any(), vec(any(), 20))
            .prop_map(|(vendor_name, vendor_id, product_name, product_id, order_numbers, rest, marks)| {
                let mut identity =
                    Self { vendor_name, vendor_id, product_name, product_id, order_numbers, rest };
                identity.rest.read_only = names(&identity)
                    .into_iter()
                    .zip(marks)
                    .filter_map(|(name, mark): (_, Option<bool>)| Some((name.into(), mark?)))
                    .collect();
                identity
            })
            .boxed()
    }
}

/// The elements of an identity that may say that they are read-only, in their order.
fn names(identity: &Identity) -> Vec<String> {
    let Identity { vendor_name, vendor_id, product_name, product_id, order_numbers, rest } = identity;
    let numbered = |name: &'static str, count: usize| {
        (0..count).map(move |at| if at == 0 { name.to_owned() } else { format!("{name}[{}]", at + 1) })
    };
    let one = |name: &'static str, is_there: bool| numbered(name, usize::from(is_there));
    let names = one("vendorName", vendor_name.is_some())
        .chain(one("vendorID", vendor_id.is_some()))
        .chain(one("vendorText", true))
        .chain(one("deviceFamily", true))
        .chain(one("productFamily", rest.product_family.is_some()))
        .chain(one("productName", product_name.is_some()))
        .chain(one("productID", product_id.is_some()))
        .chain(one("productText", true))
        .chain(numbered("orderNumber", order_numbers.len()))
        .chain(numbered("version", rest.versions.len()))
        .chain(one("specificationRevision", rest.specification_revision.is_some()))
        .chain(one("instanceName", rest.instance_name.is_some()));
    names.collect()
}

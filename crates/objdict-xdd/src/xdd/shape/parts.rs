//! Parts of the model that have their own elements.

use std::any::Any;

use crate::model::{
    AllowedValues, AllowedValuesTemplate, Characteristic, CharacteristicsList, CombinedState, Compliance,
    ConnectedModule, Connection, Count, DataTypeRef, Dictionary, EnumValue, FunctionInstance,
    FunctionInstances, FunctionType, Label, Labels, Led, LedState, MemberRef, ModuleInterface, ModuleRange,
    ModuleRanges, ModuleType, OwnAddressing, OwnInterface, Parameter, ParameterGroup, ParameterTemplate,
    Picture, Property, ScaledValue, SimpleType, Subrange, TextRef, TypeDefinition, TypeShape, Unit,
    ValueRange, VarDeclaration, VariableRef, VersionInfo,
};
use crate::xml::{Name, n};

/// A part that is one element.
pub(crate) trait Part: PartialEq + Any {
    /// An empty part for an element of a name.
    fn new(name: Name) -> Self;

    /// The name of its element, if parts of this type can have several.
    fn name(&self) -> Option<Name> {
        None
    }
}

/// A field that stores such parts.
pub(crate) trait Parts {
    /// Adds a part for an element of a name; `None` if the field is full.
    fn add(&mut self, name: Name) -> Option<&mut dyn Any>;

    /// Calls `put` for each part, with the name of its element if there are several.
    fn each(&self, put: &mut dyn FnMut(Option<Name>, &dyn Any));
}

/// A part that always exists; an empty one is not written.
impl<T: Part> Parts for T {
    fn add(&mut self, name: Name) -> Option<&mut dyn Any> {
        if *self == T::new(name) { Some(self) } else { None }
    }

    fn each(&self, put: &mut dyn FnMut(Option<Name>, &dyn Any)) {
        if *self != T::new(Name::OTHER) {
            put(self.name(), self);
        }
    }
}

impl<T: Part> Parts for Option<T> {
    fn add(&mut self, name: Name) -> Option<&mut dyn Any> {
        if self.is_some() { None } else { Some(self.insert(T::new(name))) }
    }

    fn each(&self, put: &mut dyn FnMut(Option<Name>, &dyn Any)) {
        self.iter().for_each(|part| put(part.name(), part));
    }
}

impl Parts for Option<Box<Count>> {
    fn add(&mut self, name: Name) -> Option<&mut dyn Any> {
        if self.is_some() { None } else { Some(&mut **self.insert(Box::new(Count::new(name)))) }
    }

    fn each(&self, put: &mut dyn FnMut(Option<Name>, &dyn Any)) {
        self.iter().for_each(|part| put(part.name(), &**part));
    }
}

impl<T: Part> Parts for Vec<T> {
    fn add(&mut self, name: Name) -> Option<&mut dyn Any> {
        self.push(T::new(name));
        self.last_mut().map(|last| last as &mut dyn Any)
    }

    fn each(&self, put: &mut dyn FnMut(Option<Name>, &dyn Any)) {
        self.iter().for_each(|part| put(part.name(), part));
    }
}

/// Parts with one element name, or with any.
macro_rules! parts {
    ($($Part:ty),+ $(,)?) => {$(
        impl Part for $Part {
            fn new(_: Name) -> Self {
                Self::default()
            }
        }
    )+};
}
pub(super) use parts;

parts! {
    AllowedValues, AllowedValuesTemplate, Characteristic, CharacteristicsList, CombinedState, Compliance,
    ConnectedModule, Connection, Count, Dictionary, EnumValue, FunctionInstance,
    FunctionInstances, FunctionType, Labels, Led, LedState, MemberRef, ModuleInterface, ModuleRange,
    ModuleRanges, ModuleType, OwnAddressing, OwnInterface, Parameter, ParameterGroup,
    ParameterTemplate, Picture, Property, ScaledValue, Subrange, Unit, ValueRange, VarDeclaration, VariableRef, VersionInfo,
}

impl Part for Label {
    fn new(name: Name) -> Self {
        let empty = Box::<str>::default;
        match name {
            n::description => Self::Description { lang: empty(), uri: None, text: empty() },
            n::labelRef => Self::NameRef(TextRef::default()),
            n::descriptionRef => Self::DescriptionRef(TextRef::default()),
            _ => Self::Name { lang: empty(), text: empty() },
        }
    }

    fn name(&self) -> Option<Name> {
        Some(match self {
            Self::Name { .. } => n::label,
            Self::Description { .. } => n::description,
            Self::NameRef(_) => n::labelRef,
            Self::DescriptionRef(_) => n::descriptionRef,
        })
    }
}

impl Part for TypeDefinition {
    fn new(name: Name) -> Self {
        let shape = match name {
            n::r#struct => TypeShape::Struct { members: Vec::new() },
            n::r#enum => TypeShape::Enum { size: None, values: Vec::new(), base: None },
            n::derived => TypeShape::Derived { count: None, base: None },
            _ => TypeShape::Array { ranges: Vec::new(), element: None },
        };
        Self { shape, ..Self::default() }
    }

    fn name(&self) -> Option<Name> {
        Some(match self.shape {
            TypeShape::Array { .. } => n::array,
            TypeShape::Struct { .. } => n::r#struct,
            TypeShape::Enum { .. } => n::r#enum,
            TypeShape::Derived { .. } => n::derived,
        })
    }
}

/// An empty element such as `UDINT`.
impl Parts for Option<SimpleType> {
    fn add(&mut self, name: Name) -> Option<&mut dyn Any> {
        if self.is_some() {
            return None;
        }
        Some(self.insert(SimpleType::from_name(name.text())?))
    }

    fn each(&self, put: &mut dyn FnMut(Option<Name>, &dyn Any)) {
        self.iter().for_each(|simple| put(Some(Name::of(simple.name())), simple));
    }
}

/// An element such as `UDINT`, a `dataTypeIDRef`, or several `variableRef`.
impl Parts for Option<DataTypeRef> {
    fn add(&mut self, name: Name) -> Option<&mut dyn Any> {
        if self.is_none() {
            *self = Some(match name {
                n::variableRef => DataTypeRef::Variables(Vec::new()),
                n::dataTypeIDRef => DataTypeRef::Defined(Box::default()),
                _ => DataTypeRef::Simple(SimpleType::from_name(name.text())?),
            });
        } else if !matches!((&self, name), (Some(DataTypeRef::Variables(_)), n::variableRef)) {
            return None;
        }
        match self.as_mut()? {
            DataTypeRef::Simple(simple) => Some(simple),
            DataTypeRef::Defined(id) => Some(id),
            DataTypeRef::Variables(variables) => variables.add(name),
        }
    }

    fn each(&self, put: &mut dyn FnMut(Option<Name>, &dyn Any)) {
        match self {
            None => {}
            Some(DataTypeRef::Simple(simple)) => put(Some(Name::of(simple.name())), simple),
            Some(DataTypeRef::Defined(id)) => put(Some(n::dataTypeIDRef), id),
            Some(DataTypeRef::Variables(variables)) => {
                variables.iter().for_each(|variable| put(Some(n::variableRef), variable));
            }
        }
    }
}

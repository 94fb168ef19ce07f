//! The versions of CiA 311.

objdict_model::named! {
    /// A version of CiA 311, which a file states as the namespace of its elements.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum XddVersion {
        /// 1.0: every element is in the namespace.
        V1_0 = "1.0",
        /// 1.1: local elements of the schema are in no namespace.
        #[default]
        V1_1 = "1.1",
    }
}

impl XddVersion {
    /// The version with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|version| version.name() == name)
    }

    /// The namespace of elements.
    pub const fn namespace(self) -> &'static str {
        match self {
            Self::V1_0 => "http://www.canopen.org/xml/1.0",
            Self::V1_1 => "http://www.canopen.org/xml/1.1",
        }
    }

    /// The version with this namespace.
    pub fn from_namespace(uri: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|version| version.namespace() == uri)
    }
}

//! Other tools that read descriptions.

named! {
    /// A tool that descriptions can be checked against. Rules of the group `portability` report what it does not
    /// support.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[non_exhaustive]
    pub enum Tool {
        /// The dcf-tools of Lely core.
        DcfTools = "dcf-tools",
        /// The C library of Lely core, which loads descriptions at run time.
        Lely = "lely",
        /// CANopenEditor (libedssharp).
        CanOpenEditor = "canopeneditor",
        /// The library canopen for Python.
        PythonCanopen = "python-canopen",
        /// The package canopen of npm (node-canopen).
        NodeCanopen = "node-canopen",
        /// CODESYS.
        Codesys = "codesys",
        /// CANopenNode 4, whose object dictionary is generated from the description.
        CanOpenNode = "canopennode",
        /// CANchkEDS of Vector, which checks EDS files before certification.
        CanChkEds = "canchkeds",
    }
}

impl Tool {
    /// The tool with a name, ignoring case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|tool| tool.name().eq_ignore_ascii_case(name))
    }
}

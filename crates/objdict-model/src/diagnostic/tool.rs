//! Other tools that read descriptions.

use std::fmt;

/// A tool that descriptions can be checked against. Rules of the group `portability` report what it does not
/// support.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Tool {
    /// The dcf-tools of Lely core.
    DcfTools,
    /// The C library of Lely core, which loads descriptions at run time.
    Lely,
    /// CANopenEditor (libedssharp).
    CanOpenEditor,
    /// The library canopen for Python.
    PythonCanopen,
    /// The package canopen of npm (node-canopen).
    NodeCanopen,
    /// CODESYS.
    Codesys,
    /// CANopenNode 4, whose object dictionary is generated from the description.
    CanOpenNode,
    /// CANchkEDS of Vector, which checks EDS files before certification.
    CanChkEds,
}

impl Tool {
    /// All tools.
    pub const ALL: [Self; 8] = [
        Self::DcfTools,
        Self::Lely,
        Self::CanOpenEditor,
        Self::PythonCanopen,
        Self::NodeCanopen,
        Self::Codesys,
        Self::CanOpenNode,
        Self::CanChkEds,
    ];

    /// The name on the command line and in the configuration.
    pub const fn name(self) -> &'static str {
        match self {
            Self::DcfTools => "dcf-tools",
            Self::Lely => "lely",
            Self::CanOpenEditor => "canopeneditor",
            Self::PythonCanopen => "python-canopen",
            Self::NodeCanopen => "node-canopen",
            Self::Codesys => "codesys",
            Self::CanOpenNode => "canopennode",
            Self::CanChkEds => "canchkeds",
        }
    }

    /// The tool with a name, ignoring case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|tool| tool.name().eq_ignore_ascii_case(name))
    }
}

impl fmt::Display for Tool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

//! Other tools that read descriptions.

use std::fmt;

/// A tool that a description may have to be fit for. Rules of the group `portability` know what it chokes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Tool {
    /// The dcf-tools of Lely core.
    DcfTools,
    /// CANopenEditor (libedssharp).
    CanOpenEditor,
    /// The library canopen for Python.
    PythonCanopen,
    /// CODESYS.
    Codesys,
    /// CANopenNode 4, whose object dictionary is made of the description.
    CanOpenNode,
}

impl Tool {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::DcfTools, Self::CanOpenEditor, Self::PythonCanopen, Self::Codesys, Self::CanOpenNode];

    /// The name that the command line and the configuration take.
    pub const fn name(self) -> &'static str {
        match self {
            Self::DcfTools => "dcf-tools",
            Self::CanOpenEditor => "canopeneditor",
            Self::PythonCanopen => "python-canopen",
            Self::Codesys => "codesys",
            Self::CanOpenNode => "canopennode",
        }
    }

    /// The tool of a name, whatever the case of its letters.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|tool| tool.name().eq_ignore_ascii_case(name))
    }
}

impl fmt::Display for Tool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

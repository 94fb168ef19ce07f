//! Rules: names, severities, pages and selection by name, and the tools that read descriptions.

use std::fmt;

use super::{FixSafety, Severity};
use crate::model::Field;

/// Whether the crates and packages are published to registries. Links of rules depend on it; tests and `cargo xtask`
/// check the documentation and the actions against it.
pub const PUBLISHED: bool = false;

/// The URL of the objdict page, the only absolute address that is independent of a repository; `None` until
/// it exists.
pub const HOME: Option<&str> = if PUBLISHED { Some("https://docs.rs/objdict") } else { None };

/// The properties of a rule for reports and documentation.
#[derive(Debug)]
pub struct RuleInfo {
    /// Group and name, such as `cia306/duplicate-section`. An id is never reused.
    pub id: &'static str,
    /// The default severity of its findings.
    pub severity: Severity,
    /// Whether its findings can have a [fix](super::Fix), and how safe it is.
    pub fix: Option<FixSafety>,
    /// The problem in one sentence: the first line of the page.
    pub summary: &'static str,
    /// The checked condition.
    pub checks: &'static str,
    /// What it needs, without which it reports nothing; empty if that is what it checks.
    pub needs: &'static str,
    /// Why it matters.
    pub why: &'static str,
    /// An example of the defect.
    pub example: &'static str,
    /// How to fix it.
    pub remedy: &'static str,
    /// The documents that define it.
    pub source: &'static str,
    /// The findings that a finding of the rule explains.
    pub explains: &'static [Explained],
    /// The generated tables that a finding of the rule makes wrong.
    pub stops: &'static [Stop],
}

/// Generated tables that an error of this rule makes wrong, unless objdict
/// [reads](super::Diagnostic::is_understood) the intended meaning.
#[derive(Clone, Copy, Debug)]
pub struct Stop {
    /// The name of the target, or `*` for all.
    pub target: &'static str,
    /// The fields that the finding must affect; empty for any.
    pub fields: &'static [Field],
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.target {
            "*" => write!(f, "No table is generated")?,
            target => write!(f, "No table for the target `{target}` is generated")?,
        }
        f.write_str(" from a description with such an error")?;
        if let Some((last, others)) = self.fields.split_last() {
            let others: Vec<String> = others.iter().map(|field| format!("`{}`", field.name())).collect();
            let others = if others.is_empty() { String::new() } else { others.join(", ") + " or " };
            write!(f, " in {others}`{}`", last.name())?;
        }
        f.write_str(", unless its meaning is clear or no entry depends on it.")
    }
}

/// Rules whose findings are consequences of a finding; reports then omit the consequences.
#[derive(Clone, Copy, Debug)]
pub struct Explained {
    /// The location of the consequences.
    pub reach: Reach,
    /// The [names](RuleInfo::name) of the rules, without their groups.
    pub rules: &'static [&'static str],
}

/// The location of a finding's consequences.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Anywhere in the file.
    File,
    /// Anywhere in a file from which no object was read.
    NoObjects,
    /// At the element or line that contains the cause.
    Around,
    /// In the EDS or DCF section that contains the cause.
    Section,
    /// At the object of the cause; if only the text shows the cause, at the object of its section, or in its
    /// element of an XDD or XDC.
    Object,
    /// At the only object that is listed or has sub-indexes but lacks its own section.
    Lost,
    /// At the only object that belongs in the object list of the cause but is not listed.
    List,
    /// At the keys of the missing section that the cause reports.
    Keys,
    /// At the object whose index is the value in the line of the cause.
    Value,
    /// Up to the next section, if the cause looks like a header, and at the object or section in that header.
    Header,
}

impl RuleInfo {
    /// A rule without fixes and page, for findings of callers.
    pub const fn bare(id: &'static str, severity: Severity) -> Self {
        let [summary, checks, needs, why, example, remedy, source] = [""; 7];
        Self {
            id,
            severity,
            fix: None,
            summary,
            checks,
            needs,
            why,
            example,
            remedy,
            source,
            explains: &[],
            stops: &[],
        }
    }

    /// The group: `cia306` of `cia306/duplicate-section`.
    pub fn group(&self) -> &'static str {
        self.id.split_once('/').map_or("", |(group, _)| group)
    }

    /// The name inside the group: `duplicate-section` of `cia306/duplicate-section`.
    pub fn name(&self) -> &'static str {
        self.id.split_once('/').map_or(self.id, |(_, name)| name)
    }

    /// The public address of its page, in the documentation of the crate `objdict`; `None` until it is
    /// [published](PUBLISHED).
    pub fn address(&self) -> Option<String> {
        HOME.map(|home| format!("{home}/latest/objdict/{}", self.page_address()))
    }

    /// The address of its page relative to the documentation of the crate `objdict`, published or not.
    pub fn page_address(&self) -> String {
        format!("rules/{}/{}/index.html", self.group(), self.name().replace('-', "_"))
    }

    /// The page as Markdown: the summary, then a heading and a paragraph for each of the other texts.
    pub fn page(&self) -> String {
        let parts = [
            ("What it checks", self.checks),
            ("What it needs", self.needs),
            ("Why it matters", self.why),
            ("Example", self.example),
            ("How to fix", self.remedy),
            ("Source", self.source),
        ];
        let page = format!("{}\n", self.summary);
        let parts = parts.iter().filter(|(_, text)| !text.is_empty());
        let page = parts.fold(page, |page, (heading, text)| page + &format!("\n## {heading}\n{text}\n"));
        match &*self.stops.iter().map(Stop::to_string).collect::<Vec<_>>().join(" ") {
            "" => page,
            stops => page + &format!("\n## Effect on `objdict generate`\n{stops}\n"),
        }
    }
}

/// A [`RuleInfo`]: `rule_info! { "cia306/name", Error, fix Safe; summary: "…", … }` with all texts of the
/// page; a rule that needs nothing more omits `needs`, one without fixes omits the part `fix`, and one without a `source` has the `SOURCE` of its file. What its findings
/// explain follows, `, explains File ["name", …]`, and which tables they stop: `, stops "canopennode" at [DataType]`, or
/// `, stops "*"` for all.
#[macro_export]
macro_rules! rule_info {
    (
        $id:literal, $severity:ident $(, fix $safety:ident)? $(, explains $reach:ident [$($rule:literal),+])*
            $(, stops $target:literal $(at [$($field:ident),+])?)*;
        summary: $summary:literal,
        checks: $checks:literal,
        $(needs: $needs:literal,)?
        why: $why:literal,
        example: $example:literal,
        remedy: $remedy:literal,
        $(source: $source:literal,)?
    ) => {
        $crate::diagnostic::RuleInfo {
            id: $id,
            severity: $crate::diagnostic::Severity::$severity,
            fix: $crate::fix_of!($($safety)?),
            summary: $summary,
            checks: $checks,
            needs: concat!($($needs)?),
            why: $why,
            example: $example,
            remedy: $remedy,
            source: $crate::source_of!($($source)?),
            explains: &[$(
                $crate::diagnostic::Explained { reach: $crate::diagnostic::Reach::$reach, rules: &[$($rule),+] },
            )*],
            stops: &[$(
                $crate::diagnostic::Stop { target: $target, fields: &[$($($crate::model::Field::$field),+)?] },
            )*],
        }
    };
}

/// Declares the rules of a module with the fields of [`rule_info!`], each a `static RuleInfo`, and their list `RULES`:
/// `"cia306/name" = NAME, Error; summary: "…", …` for each. The default source may be stated once before them.
#[macro_export]
macro_rules! text_rules {
    ($(source: $source:literal;)? $(
        $id:literal = $NAME:ident, $severity:ident $(, fix $safety:ident)?
            $(, explains $reach:ident [$($rule:literal),+])* $(, stops $target:literal $(at [$($field:ident),+])?)*;
        summary: $summary:literal,
        $($part:ident: $text:literal,)+
    )+) => {
        $(const SOURCE: &str = $source;)?

        /// Every rule of this module.
        pub static RULES: &[&$crate::diagnostic::RuleInfo] = &[$(&$NAME),+];

        $(#[doc = $summary] #[allow(unreachable_pub, reason = "most modules use theirs alone")] pub static $NAME: $crate::diagnostic::RuleInfo = $crate::rule_info! {
            $id, $severity $(, fix $safety)? $(, explains $reach [$($rule),+])*
                $(, stops $target $(at [$($field),+])?)*;
            summary: $summary,
            $($part: $text,)+
        };)+
    };
}

/// The source of a rule: its own, or the default of its file.
#[doc(hidden)]
#[macro_export]
macro_rules! source_of {
    () => {
        SOURCE
    };
    ($source:literal) => {
        $source
    };
}

/// The fixes of a rule: none, `Safe`, `Unsafe` or `Mixed`.
#[macro_export]
macro_rules! fix_of {
    () => {
        None
    };
    ($safety:ident) => {
        Some($crate::diagnostic::FixSafety::$safety)
    };
}

/// The rules selected by a name: one rule, or all rules of a group.
#[derive(Clone, Copy, Debug)]
pub enum Selection {
    /// The rules of a group, such as `cia306`.
    Group(&'static str),
    /// One rule.
    Rule(&'static RuleInfo),
}

impl Selection {
    /// Whether a rule is selected.
    pub fn contains(self, rule: &RuleInfo) -> bool {
        match self {
            Self::Group(group) => rule.group() == group,
            Self::Rule(one) => rule.id == one.id,
        }
    }

    /// The name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Group(group) => group,
            Self::Rule(rule) => rule.id,
        }
    }
}

crate::messages! { Selection: { selection => "{}", selection.name(); } }

named! {
    /// A tool against which descriptions can be checked. Rules of the group `portability` report content that it
    /// does not support.
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

//! The rules about spelling and structure that only the text of an EDS or DCF can show.

mod raise;

use super::file_name::FILE_NAME;
use super::read::Item;
use crate::diagnostic::Findings;
use crate::diagnostic::{RuleInfo, text_rule};
use crate::literal::{self, Quirks};
use crate::model::Value;
pub(super) use raise::{
    Twin, duplicate_key, duplicate_section, invalid_list_entry, list_numbering, quoted_name,
    section_spelling, stray_compact_entry, stray_compact_section, unknown_key, unknown_section, wrong_count,
};

/// Every rule of this module.
pub static RULES: &[&RuleInfo] = &[
    &DUPLICATE_SECTION,
    &DUPLICATE_KEY,
    &UNKNOWN_SECTION,
    &UNKNOWN_KEY,
    &SECTION_SPELLING,
    &COMMISSIONING_SPELLING,
    &STRAY_COMPACT_SECTION,
    &WRONG_COUNT,
    &LIST_NUMBERING,
    &INVALID_LIST_ENTRY,
    &FILE_NAME,
];

/// The findings of a value's spelling in a line; `value` is what it was read as.
pub(crate) fn quirks(item: &Item<'_>, quirks: Quirks, value: Option<&Value>, findings: &mut Findings) {
    literal::spelling_in_line(item.value, (item.name_at, item.value_at), quirks, value, findings);
}

text_rule! {
    /// a section stands twice
    ///
    /// ## What it checks
    /// Whether a section name occurs once, whatever the case of its letters and leading zeros in it. The first section is the one that is read; lists are read on.
    ///
    /// ## Why it matters
    /// Some tools take the first one, some the last one, some refuse the file: the device has two dictionaries.
    ///
    /// ## Example
    /// `[1018sub1]` and further down `[1018SUB01]`
    ///
    /// ## How to mend
    /// Keep one of them.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    DUPLICATE_SECTION = "cia306/duplicate-section", Error, fix Unsafe
}

text_rule! {
    /// a key stands twice in a section
    ///
    /// ## What it checks
    /// Whether a key occurs once in its section, whatever the case of its letters. The first one is read. Two equal lines are a warning only.
    ///
    /// ## Why it matters
    /// Some tools take the first value, some the last one, some refuse the file.
    ///
    /// ## Example
    /// `DefaultValue=4` and two lines below `DefaultValue=5`
    ///
    /// ## How to mend
    /// Keep one of them.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    DUPLICATE_KEY = "cia306/duplicate-key", Error, fix Unsafe
}

text_rule! {
    /// a section that the standard does not have
    ///
    /// ## What it checks
    /// Whether each section is one of CiA 306-1 or CiA 306-3. Others are kept.
    ///
    /// ## Why it matters
    /// The standard allows them, dcf-tools refuses them. Perhaps the name is misspelt.
    ///
    /// ## Example
    /// `[ToolInfos]`
    ///
    /// ## How to mend
    /// Check the spelling; remove the section if the tools of your users do not need it.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    UNKNOWN_SECTION = "cia306/unknown-section", Note
}

text_rule! {
    /// a key that its section does not have
    ///
    /// ## What it checks
    /// Whether the standard has the key, and has it in this section. Others are kept.
    ///
    /// ## Why it matters
    /// The standard allows them, dcf-tools refuses them. Perhaps the name is misspelt, and then its value is lost.
    ///
    /// ## Example
    /// `Supported Objects=3`
    ///
    /// ## How to mend
    /// Check the spelling; remove the key if the tools of your users do not need it.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    UNKNOWN_KEY = "cia306/unknown-key", Note, fix Unsafe
}

text_rule! {
    /// the name of an object's section is misspelt
    ///
    /// ## What it checks
    /// Whether the names of objects are an index in hex without `0x` and leading zeros, and `sub` with a sub-index in hex without leading zeros. What can be understood is read. Leading zeros, which many readers understand too, are a warning, everything else is an error.
    ///
    /// ## Why it matters
    /// Other tools read another object, or none.
    ///
    /// ## Example
    /// `[1018sub01]`, `[0x1000]`, `[1003sub100]`
    ///
    /// ## How to mend
    /// Write `[1018sub1]`, `[1000]`.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.2
    SECTION_SPELLING = "cia306/section-spelling", Warning, fix Safe
}

text_rule! {
    /// `DeviceComissioning` is spelt with two m
    ///
    /// ## What it checks
    /// Whether the section is called `DeviceComissioning`, as the standard misspells it. Both are read.
    ///
    /// ## Why it matters
    /// python-canopen, dcf-tools and others only know the name of the standard: the node-ID is lost to them.
    ///
    /// ## Example
    /// `[DeviceCommissioning]`
    ///
    /// ## How to mend
    /// Write `[DeviceComissioning]`.
    ///
    /// ## Source
    /// CiA 306-1 §5.4
    COMMISSIONING_SPELLING = "cia306/commissioning-spelling", Warning, fix Safe
}

text_rule! {
    /// names, values or denotations of an object that is not stored compactly
    ///
    /// ## What it checks
    /// Whether an object with `CompactSubObj` belongs to each `[xxxxName]`, `[xxxxValue]` and `[xxxxDenotation]`, and whether their numbers are 1 to `CompactSubObj`.
    ///
    /// ## Why it matters
    /// The names and values apply to nothing.
    ///
    /// ## Example
    /// `[2000Value]` beside a `[2000]` with `SubNumber`
    ///
    /// ## How to mend
    /// Give the object `CompactSubObj`, or write the values into its sub-indexes.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.4.2
    STRAY_COMPACT_SECTION = "cia306/stray-compact-section", Error
}

text_rule! {
    /// a count is not the number of what it counts
    ///
    /// ## What it checks
    /// Whether `SupportedObjects`, `NrOfEntries`, `Lines`, `ObjectLinks`, `NrOfSeg` and `Items` are the number of numbered keys that follow. All keys are read, whatever the count says.
    ///
    /// ## Why it matters
    /// Tools that trust the count do not see the objects behind it.
    ///
    /// ## Example
    /// `SupportedObjects=3` with four entries
    ///
    /// ## How to mend
    /// Write the right number.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.1
    WRONG_COUNT = "cia306/wrong-count", Error, fix Safe
}

text_rule! {
    /// the keys of a list are not 1, 2, 3 …
    ///
    /// ## What it checks
    /// Whether a list's keys are decimal numbers from 1 without gaps.
    ///
    /// ## Why it matters
    /// Tools that count from 1 stop at the gap.
    ///
    /// ## Example
    /// `1=0x1000`, `2=0x1001`, `4=0x1018`
    ///
    /// ## How to mend
    /// Number the entries again.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.1
    LIST_NUMBERING = "cia306/list-numbering", Error, fix Safe
}

text_rule! {
    /// an entry of a list is no index
    ///
    /// ## What it checks
    /// Whether each value of an object list is an index from 1h to FFFFh.
    ///
    /// ## Why it matters
    /// The object that was meant is in no list, so many tools do not see it.
    ///
    /// ## Example
    /// `3=0x10180`
    ///
    /// ## How to mend
    /// Write the index in hex: `3=0x1018`.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.1
    INVALID_LIST_ENTRY = "cia306/invalid-list-entry", Error
}

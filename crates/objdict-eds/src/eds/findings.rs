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
    DUPLICATE_SECTION = "cia306/duplicate-section", Error, fix Unsafe;
    summary: "a section stands twice",
    checks: "Whether a section name occurs once, whatever the case of its letters and leading zeros in it. The first section is the one that is read; lists are read on.",
    why: "Some tools take the first one, some the last one, some refuse the file: the device has two dictionaries.",
    example: "`[1018sub1]` and further down `[1018SUB01]`",
    remedy: "Keep one of them.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    DUPLICATE_KEY = "cia306/duplicate-key", Error, fix Unsafe;
    summary: "a key stands twice in a section",
    checks: "Whether a key occurs once in its section, whatever the case of its letters. The first one is read. Two equal lines are a warning only.",
    why: "Some tools take the first value, some the last one, some refuse the file.",
    example: "`DefaultValue=4` and two lines below `DefaultValue=5`",
    remedy: "Keep one of them.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    UNKNOWN_SECTION = "cia306/unknown-section", Note;
    summary: "a section that the standard does not have",
    checks: "Whether each section is one of CiA 306-1 or CiA 306-3. Others are kept.",
    why: "The standard allows them, dcf-tools refuses them. Perhaps the name is misspelt.",
    example: "`[ToolInfos]`",
    remedy: "Check the spelling; remove the section if the tools of your users do not need it.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    UNKNOWN_KEY = "cia306/unknown-key", Note, fix Unsafe;
    summary: "a key that its section does not have",
    checks: "Whether the standard has the key, and has it in this section. Others are kept.",
    why: "The standard allows them, dcf-tools refuses them. Perhaps the name is misspelt, and then its value is lost.",
    example: "`Supported Objects=3`",
    remedy: "Check the spelling; remove the key if the tools of your users do not need it.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    SECTION_SPELLING = "cia306/section-spelling", Warning, fix Safe;
    summary: "the name of an object's section is misspelt",
    checks: "Whether the names of objects are an index in hex without `0x` and leading zeros, and `sub` with a sub-index in hex without leading zeros. What can be understood is read. Leading zeros, which many readers understand too, are a warning, everything else is an error.",
    why: "Other tools read another object, or none.",
    example: "`[1018sub01]`, `[0x1000]`, `[1003sub100]`",
    remedy: "Write `[1018sub1]`, `[1000]`.",
    source: "CiA 306-1 §4.6.3.2",
}

text_rule! {
    COMMISSIONING_SPELLING = "cia306/commissioning-spelling", Warning, fix Safe;
    summary: "`DeviceComissioning` is spelt with two m",
    checks: "Whether the section is called `DeviceComissioning`, as the standard misspells it. Both are read.",
    why: "python-canopen, dcf-tools and others only know the name of the standard: the node-ID is lost to them.",
    example: "`[DeviceCommissioning]`",
    remedy: "Write `[DeviceComissioning]`.",
    source: "CiA 306-1 §5.4",
}

text_rule! {
    STRAY_COMPACT_SECTION = "cia306/stray-compact-section", Error;
    summary: "names, values or denotations of an object that is not stored compactly",
    checks: "Whether an object with `CompactSubObj` belongs to each `[xxxxName]`, `[xxxxValue]` and `[xxxxDenotation]`, and whether their numbers are 1 to `CompactSubObj`.",
    why: "The names and values apply to nothing.",
    example: "`[2000Value]` beside a `[2000]` with `SubNumber`",
    remedy: "Give the object `CompactSubObj`, or write the values into its sub-indexes.",
    source: "CiA 306-1 §4.6.3.4.2",
}

text_rule! {
    WRONG_COUNT = "cia306/wrong-count", Error, fix Safe;
    summary: "a count is not the number of what it counts",
    checks: "Whether `SupportedObjects`, `NrOfEntries`, `Lines`, `ObjectLinks`, `NrOfSeg` and `Items` are the number of numbered keys that follow. All keys are read, whatever the count says.",
    why: "Tools that trust the count do not see the objects behind it.",
    example: "`SupportedObjects=3` with four entries",
    remedy: "Write the right number.",
    source: "CiA 306-1 §4.6.3.1",
}

text_rule! {
    LIST_NUMBERING = "cia306/list-numbering", Error, fix Safe;
    summary: "the keys of a list are not 1, 2, 3 …",
    checks: "Whether a list's keys are decimal numbers from 1 without gaps.",
    why: "Tools that count from 1 stop at the gap.",
    example: "`1=0x1000`, `2=0x1001`, `4=0x1018`",
    remedy: "Number the entries again.",
    source: "CiA 306-1 §4.6.3.1",
}

text_rule! {
    INVALID_LIST_ENTRY = "cia306/invalid-list-entry", Error;
    summary: "an entry of a list is no index",
    checks: "Whether each value of an object list is an index from 1h to FFFFh.",
    why: "The object that was meant is in no list, so many tools do not see it.",
    example: "`3=0x10180`",
    remedy: "Write the index in hex: `3=0x1018`.",
    source: "CiA 306-1 §4.6.3.1",
}

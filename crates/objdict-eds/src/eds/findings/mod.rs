//! The rules about spelling and structure that need the text of an EDS or DCF.

mod idle;
mod raise;

use super::item::Item;
use crate::diagnostic::{Findings, text_rules};
use crate::literal::{self, Quirks};
use crate::model::Value;
pub use idle::idle;
pub(super) use raise::{
    DuplicateKind, date_spelling, duplicate_key, duplicate_section, invalid_list_entry, list_numbering,
    mapped_otherwise, missing_header, misspelt_key, misspelt_section, quoted_name, repeated_number,
    section_spelling, stray_compact_entry, stray_compact_section, unknown_key, unknown_section, wrong_count,
};

/// Reports the spelling of a value in a line; `value` is the parsed value.
pub(crate) fn quirks(item: &Item<'_>, quirks: Quirks, value: Option<&Value>, findings: &mut Findings) {
    literal::spelling_in_line(item.value, (item.name_at, item.value_at), quirks, value, findings);
}

text_rules! {
    source: "CiA 306-1 §4.2";

    "cia306/duplicate-section" = DUPLICATE_SECTION, Error, fix Safe, stops "*";
    summary: "a section is defined twice",
    checks: "Each section name must occur only once; case and leading zeros are ignored. The first section is read; lists are continued.",
    why: "Some tools read the first section, some the last one, some reject the file.",
    example: "`[1018sub1]` and later `[1018SUB01]`",
    remedy: "Keep one of them.",

    // a list contains one number twice and lacks a different one
    "cia306/duplicate-key" = DUPLICATE_KEY, Error, fix Safe,
        explains Section ["wrong-count"], explains Value ["object-not-listed"], stops "*";
    summary: "a key is defined twice in a section",
    checks: "Each key must occur only once in its section; case is ignored. The first one is read. Two equal lines are only a warning. In a list whose count is right, both entries are read if a single number is used twice and only one number is left.",
    why: "Some tools read the first value, some the last one, some reject the file.",
    example: "`DefaultValue=4` and later `DefaultValue=5`",
    remedy: "Keep one of them.",

    // the keys belong to a different sub-index of the same object, or to an object that is listed or has
    // sub-indexes
    "cia306/missing-header" = MISSING_HEADER, Error,
        explains Section ["unknown-key", "unsupported-key", "invalid-value", "value-outside-limits"],
        explains File ["wrong-pdo-count"],
        explains Object [
            "sub-number-mismatch", "missing-sub-0", "missing-sub-index", "wrong-highest-sub-index", "gap-in-mapping",
            "gap-in-array", "wrong-mapping-count", "incomplete-pdo-parameter", "incomplete-sdo-parameter",
            "mapped-object-missing", "missing-vendor-id", "lss-without-identity"
        ],
        explains Lost [
            "listed-object-missing", "sub-without-object", "mapped-object-missing", "link-to-missing-object",
            "stray-compact-section", "missing-mandatory-object", "missing-object", "pdo-without-mapping"
        ],
        stops "*";
    summary: "the header of a section is missing",
    checks: "The keys of an object or sub-index must not start again inside a section. This is reported if `ParameterName`, or a key below an empty line, is defined again, and so is one of the next three. The keys are reported once, not each as defined twice.",
    why: "The object or sub-index does not exist for readers. Its keys are read into the section above, or the file is rejected.",
    example: "`[1000]` with its keys, an empty line, and the keys of `[1001]` without this header",
    remedy: "Write the header above the first repeated key.",

    "cia306/unknown-section" = UNKNOWN_SECTION, Note, fix Safe;
    summary: "the standard does not define a section",
    checks: "Reports a section that neither CiA 306-1 nor CiA 306-3 defines. Unknown sections are kept.",
    why: "The standard allows unknown sections, but dcf-tools rejects them.",
    example: "`[ToolInfos]`",
    remedy: "Check the spelling, or remove the section if no tool needs it. With `--compat dcf-tools` the fix comments out its lines.",

    "cia306/unknown-key" = UNKNOWN_KEY, Note, fix Mixed;
    summary: "the standard does not define a key in its section",
    checks: "Reports a key that the standard does not define in this section. Unknown keys are kept. A number in hex, such as `0xF` in `[2000Name]`, is a warning: the entry is lost.",
    why: "The standard allows unknown keys, but dcf-tools rejects them.",
    example: "`Unit=ms`",
    remedy: "Check the spelling, or remove the key if no tool needs it. With `--compat dcf-tools` the fix comments out the line, for review if python-canopen or CANopenEditor reads the key.",

    "cia306/misspelt-section" = MISSPELT_SECTION, Warning, fix Unsafe;
    summary: "the name of a section is misspelt",
    checks: "Reports an undefined section whose name is almost the name of a missing one. The section is read as the missing one, so its absence is not reported. Sections of objects and sub-indexes have the rule `cia306/section-spelling`.",
    why: "Other tools ignore the section: the objects of a misspelt list are not listed.",
    example: "`[OptionalObject]`",
    remedy: "Write `[OptionalObjects]`.",

    "cia306/misspelt-key" = MISSPELT_KEY, Warning, fix Mixed;
    summary: "the name of a key is misspelt",
    checks: "Reports an undefined key whose name is almost the name of a key that the section lacks. It may contain spaces or one wrong letter, in longer names two. The key is read as the missing one, so its absence is not reported. Like a missing one, a misspelt `ObjectType`, `DataType`, `AccessType`, `SubNumber` or list count is an error.",
    why: "Other tools ignore the key: the value, limit or type has no effect.",
    example: "`DefualtValue=250`, `Supported Objects=3`",
    remedy: "Write `DefaultValue=250`, `SupportedObjects=3`.",

    "cia306/section-spelling" = SECTION_SPELLING, Warning, fix Safe;
    summary: "the name of an object's section is misspelt",
    checks: "The section name of an object must be a hex index without `0x` and leading zeros. The section name of a sub-index appends `sub` and a hex sub-index without leading zeros. Recognisable names such as `[1018h]`, `[$1018]` and `[1018.1]` are read. Leading zeros, which many readers accept, are a warning. Everything else is an error, such as a sub-index in decimal above FEh.",
    why: "Other tools read a different object or none.",
    example: "`[1018sub01]`, `[0x1000]`, `[1000h]`, `[1003sub100]`",
    remedy: "Write `[1018sub1]`, `[1000]`.",
    source: "CiA 306-1 §4.6.3.2",

    "cia306/commissioning-spelling" = COMMISSIONING_SPELLING, Warning, fix Safe;
    summary: "`DeviceComissioning` is spelt with two m",
    checks: "The section must be called `DeviceComissioning`, with the misspelling of the standard. Both spellings are read.",
    why: "python-canopen, dcf-tools and others only know the standard's spelling and do not find the node-ID.",
    example: "`[DeviceCommissioning]`",
    remedy: "Write `[DeviceComissioning]`.",
    source: "CiA 306-1 §5.4",

    "cia306/stray-compact-section" = STRAY_COMPACT_SECTION, Error;
    summary: "names, values or denotations belong to an object without compact storage",
    checks: "`[xxxxName]`, `[xxxxValue]` and `[xxxxDenotation]` must belong to an object with `CompactSubObj`. Their numbers must be 1 to `CompactSubObj`.",
    why: "The names and values have no effect.",
    example: "`[2000Value]` and a `[2000]` with `SubNumber`",
    remedy: "Add `CompactSubObj` to the object, or move the values to its sub-indexes.",
    source: "CiA 306-1 §4.6.3.4.2",

    "cia306/wrong-count" = WRONG_COUNT, Error, fix Safe, explains List ["object-not-listed"];
    summary: "a count does not match the number of entries",
    checks: "`SupportedObjects`, `NrOfEntries`, `Lines`, `ObjectLinks`, `NrOfSeg` and `Items` must equal the number of numbered keys that follow. All keys are read, regardless of the count. An empty section `[DynamicChannels]` of a device without dynamic channels is a note.",
    why: "Tools that rely on the count do not see the entries above it.",
    example: "`SupportedObjects=3` with four entries",
    remedy: "Correct the count.",
    source: "CiA 306-1 §4.6.3.1",

    // a number is missing, and therefore the entry
    "cia306/list-numbering" = LIST_NUMBERING, Error, fix Safe,
        explains Section ["wrong-count"], explains List ["object-not-listed"];
    summary: "the keys of a list are not consecutive",
    checks: "The keys of a list must be decimal numbers from 1 without gaps. The keys of comments must be `Line1` and so on; violations there are a warning.",
    why: "Tools that count from 1 stop at the gap.",
    example: "`1=0x1000`, `2=0x1001`, `4=0x1018`",
    remedy: "Renumber the entries.",
    source: "CiA 306-1 §4.6.3.1",

    "cia306/invalid-list-entry" = INVALID_LIST_ENTRY, Error, fix Unsafe;
    summary: "a list entry is not a valid index",
    checks: "Each value of an object list must be an index from 1h to FFFFh.",
    why: "The intended object is not listed, so many tools do not see it.",
    example: "`3=0x10180`",
    remedy: "Write the index in hex: `3=0x1018`.",
    source: "CiA 306-1 §4.6.3.1",

    "cia306/mapped-otherwise" = MAPPED_OTHERWISE, Note;
    summary: "in a CANopenEditor file, mapped entries have the other direction",
    checks: "RPDOs must not map entries with `AccessType=rwr`, and TPDOs must not map entries with `rww`. This applies to files with the comment `;StorageLocation`, as written by CANopenEditor. Such entries are read as `rw`, because its versions use the pair both ways. In other files `cia301/wrong-mapping-direction` reports them.",
    why: "Other tools offer the entries only for the other direction, and CANopenNode marks the PDOs as not valid.",
    example: "`[1600sub1]` with `DefaultValue=0x62000108`, and `[6200sub1]` with `AccessType=rwr`",
    remedy: "Write `rww` for an output, `rwr` for an input, or `rw` for both.",
    source: "CANopenEditor",

    "cia306/date-spelling" = DATE_SPELLING, Warning, fix Mixed;
    summary: "a date or time is not in the standard's format",
    checks: "Dates must be written `mm-dd-yyyy` and times `hh:mmAM` or `hh:mmPM`. Other orders, names of months, two-digit years, single digits, seconds and 24-hour times are read. A date that can be two days is read with the month first, and its fix needs review. So does the fix of a time with seconds, for which the standard has no field.",
    why: "Tools that show or compare dates ignore such a value or mistake the day for the month.",
    example: "`CreationDate=07-Feb-2016`, `CreationTime=15:23`",
    remedy: "Write `02-07-2016` and `03:23PM`.",
    source: "CiA 306-1 §4.4",

    "cia306/file-name" = FILE_NAME, Note, fix Unsafe;
    summary: "`FileName` differs from the name of the file",
    checks: "`FileName` must be the name of the file, ignoring case. Folders are not compared, and standard input has no name. The share of files is high because files of the corpus were renamed when they were collected. Before that, one in five differed. They were copies for a different device, had a title instead of a file name, or kept the name from the computer of origin.",
    why: "The file was copied or renamed, and users look for a file that does not exist. A modified copy may be mistaken for the original.",
    example: "`FileName=drive.eds` in `drive_v2.eds`",
    remedy: "Write the name of the file in `FileName`, or rename the file. The name in the file shows the origin of a copy, so the fix needs review: `--fix --unsafe-fixes --select cia306/file-name` applies only this fix.",
    source: "CiA 306-1 §4.4",
}

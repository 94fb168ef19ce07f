//! The rules about XML itself, reported while the tree is built because only the text reveals the errors.

use std::borrow::Cow;

use crate::diagnostic::{RuleInfo, text_rules};

text_rules! {
    source: "XML 1.0 §3.1";

    // content after the element is read as part of it, or not at all
    "xml/unclosed-element" = UNCLOSED_ELEMENT, Error, explains File [
        "unknown-element", "missing-element", "stray-text", "missing-profile", "dangling-unique-id-ref",
        "dangling-data-type-id-ref", "missing-key", "missing-sub-0", "sub-number-mismatch", "wrong-pdo-count",
        "no-baud-rate", "vendor-id-zero", "no-error-control", "missing-mandatory-object", "missing-object",
        "missing-sub-index", "mapped-object-missing", "pdo-without-mapping", "wrong-mapping-count",
        "incomplete-pdo-parameter", "device-type-without-channels", "wrong-object-count", "dangling-parameter-ref",
        "dangling-function-ref", "duplicate-label", "wrong-order", "emergency-without-cob-id",
        "controlword-not-mapped", "unbound-prefix"
    ], stops "*";
    summary: "an element has no end tag",
    checks: "Each start tag needs an end tag before the parent element or the file ends.",
    why: "XML parsers reject the whole file. A truncated file shows this error.",
    example: r#"`<label lang="en">Device type` and then `</CANopenObject>`"#,
    remedy: "Add the end tag; if the file is truncated, get it again.",

    // likewise, if the start tag is missing
    "xml/stray-end-tag" = STRAY_END_TAG, Error, explains File [
        "unknown-element", "missing-element", "stray-text", "missing-profile", "dangling-unique-id-ref",
        "dangling-data-type-id-ref", "missing-key", "missing-sub-0", "sub-number-mismatch", "wrong-pdo-count",
        "no-baud-rate", "vendor-id-zero", "no-error-control", "missing-mandatory-object", "missing-object",
        "missing-sub-index", "mapped-object-missing", "pdo-without-mapping", "wrong-mapping-count",
        "incomplete-pdo-parameter", "device-type-without-channels", "wrong-object-count", "dangling-parameter-ref",
        "dangling-function-ref", "duplicate-label", "wrong-order", "emergency-without-cob-id",
        "controlword-not-mapped", "unbound-prefix"
    ];
    summary: "an end tag does not match a start tag",
    checks: "An end tag must have the name of the element that it closes. A name that differs only in case or prefix closes the open element; other end tags without a matching start tag are ignored.",
    why: "XML parsers reject the whole file.",
    example: "`<q1:deviceFamily>…</deviceFamily>`",
    remedy: "Write the name of the start tag, or remove the end tag.",
    source: "XML 1.0 §3, WFC: Element Type Match",

    "xml/no-root" = NO_ROOT, Error;
    summary: "the file has no elements",
    checks: "The file must have at least one element.",
    why: "A file that has only white space or comments, or is not XML, does not describe a device.",
    example: "A text file with the extension `.xdd`.",
    remedy: "Use an XDD or XDC file.",
    source: "XML 1.0 §2.1",

    "xml/second-root" = SECOND_ROOT, Error, stops "*";
    summary: "a second element follows the root",
    checks: "Only comments and processing instructions may follow the root element. Elements after it are not read.",
    why: "XML parsers reject the file. Often two files were concatenated, or an end tag is too early.",
    example: "`</ISO15745ProfileContainer><ISO15745ProfileContainer>`",
    remedy: "Split the file, or move the element into the root.",
    source: "XML 1.0 §2.1",

    "xml/text-outside-root" = TEXT_OUTSIDE_ROOT, Error;
    summary: "text precedes or follows the root",
    checks: "Only white space, comments, processing instructions and the document type may surround the root element.",
    why: "XML parsers reject the file. A NUL or a Ctrl-Z at the end comes from old tools, a line of text from a web page or a merge.",
    example: "`</ISO15745ProfileContainer>x`",
    remedy: "Remove the text.",
    source: "XML 1.0 §2.1",

    "xml/unclosed-tag" = UNCLOSED_TAG, Error, stops "*";
    summary: "a tag has no `>`",
    checks: "Each tag needs its `>` before the next `<`.",
    why: "XML parsers reject the file or read the following text as part of the tag.",
    example: r#"`<label lang="en"` and in the next line `<label lang="de">`"#,
    remedy: "Add the `>`.",

    "xml/unclosed-markup" = UNCLOSED_MARKUP, Error, stops "*";
    summary: "a comment, a CDATA section or a processing instruction has no end",
    checks: "Each `<!--` needs its `-->`, each `<![CDATA[` its `]]>` and each `<?` its `?>`. The text up to the next `<` is skipped.",
    why: "XML parsers reject the file. A comment without an end hides the rest of the device.",
    example: "`<!-- objects of the application ->`",
    remedy: "Add the end mark.",
    source: "XML 1.0 §2.5, §2.6, §2.7",

    "xml/unknown-markup" = UNKNOWN_MARKUP, Error;
    summary: "markup that starts with `<!` is not valid XML",
    checks: "Markup that starts with `<!` must be a comment, a CDATA section or, before the root, a document type.",
    why: "XML parsers reject the file.",
    example: "`<!ELEMENT label ANY>` between objects",
    remedy: "Remove the markup, or write a comment as `<!-- … -->`.",
    source: "XML 1.0 §2.1, §3.1",

    "xml/lone-less-than" = LONE_LESS_THAN, Error;
    summary: "a `<` does not start a tag",
    checks: "In text, a `<` must be followed by a name, `/`, `!` or `?`. Any other `<` is read as a character.",
    why: "XML parsers reject the file.",
    example: r#"`<description lang="en">valid if speed < 3000</description>`"#,
    remedy: "Write `&lt;`.",
    source: "XML 1.0 §2.4",

    "xml/double-hyphen" = DOUBLE_HYPHEN, Error;
    summary: "a comment contains `--`",
    checks: "Reports a `--` between `<!--` and `-->`; `--->` contains one.",
    why: "XML parsers reject the file, although many editors show the comment as valid.",
    example: "`<!-- ---- objects ---- -->`",
    remedy: "Write `==` or `- -`.",
    source: "XML 1.0 §2.5",

    "xml/cdata-end-in-text" = CDATA_END_IN_TEXT, Error;
    summary: "text contains `]]>`",
    checks: "`]]>` must not occur outside CDATA sections.",
    why: "XML parsers reject the file.",
    example: r#"`<label lang="en">gain[index[2]]>1</label>`"#,
    remedy: "Write `]]&gt;`.",
    source: "XML 1.0 §2.4",

    "xml/misplaced-declaration" = MISPLACED_DECLARATION, Error;
    summary: "the XML declaration is not at the start of the file",
    checks: "`<?xml … ?>` must be at the very start of the file.",
    why: "XML parsers reject the file: they read the declaration and its encoding only from the first bytes.",
    example: r#"A blank line before `<?xml version="1.0"?>`."#,
    remedy: "Remove the text before the declaration, or the second declaration.",
    source: "XML 1.0 §2.8",

    "xml/bad-declaration" = BAD_DECLARATION, Error;
    summary: "the XML declaration is malformed",
    checks: "The declaration must have `version`, then `encoding`, then `standalone`, each with a valid value. Only `version` is mandatory.",
    why: "XML parsers reject the file.",
    example: r#"`<?xml encoding="utf-8"?>`"#,
    remedy: r#"Write `<?xml version="1.0" encoding="UTF-8"?>`."#,
    source: "XML 1.0 §2.8",

    "xml/bad-target" = BAD_TARGET, Error;
    summary: "a processing instruction has an invalid target",
    checks: "A name and white space must follow `<?`, and the name must not be `xml` in any case.",
    why: "XML parsers reject the file.",
    example: r#"`<?XML version="1.0"?>`"#,
    remedy: "Write `<?xml` in lower case at the start of the file, or remove the instruction.",
    source: "XML 1.0 §2.6",

    "xml/document-type" = DOCUMENT_TYPE, Warning;
    summary: "the file has a document type",
    checks: "Reports a `<!DOCTYPE … >`. Entities that it declares as text are expanded, up to 1 MiB; external files are never read. A malformed document type is an error.",
    why: "No CANopen profile has one. Tools reject it for security: entities can read files of the user and exhaust memory.",
    example: r#"`<!DOCTYPE ISO15745ProfileContainer SYSTEM "canopen.dtd">`"#,
    remedy: "Remove the document type and replace its entities with their text.",
    source: "XML 1.0 §2.8; CiA 311",

    "xml/encoding" = ENCODING, Error;
    summary: "the encoding of the file differs from the declared one",
    checks: "`encoding` in the XML declaration must match the bytes of the file: a byte order mark, valid UTF-8, or neither. A file without a declaration is UTF-8.",
    why: "Parsers follow the declaration: they reject the file, or show `Â°` for `°`.",
    example: r#"`<?xml version="1.0" encoding="utf-16"?>` in a file of one byte a character"#,
    remedy: "Declare the actual encoding, preferably UTF-8.",
    source: "XML 1.0 §4.3.3",

    "xml/limit" = LIMIT, Error, stops "*";
    summary: "the file exceeds a limit of the reader",
    checks: "Elements may be nested at most 256 deep, with at most 256 attributes each. A name may have at most 32,000 bytes. The file may have at most 4 million elements and 1 MiB of text from its own entities. Anything beyond a limit is not read.",
    why: "No device needs that much; a file that does is designed to exhaust memory.",
    example: "A thousand `<a>` in each other.",
    remedy: "Check the origin of the file.",
    source: "none; XML has no limits",

    "xml/forbidden-character" = FORBIDDEN_CHARACTER, Error;
    summary: "the file contains a character that XML forbids",
    checks: "The file must not contain control characters other than tab, LF and CR, nor U+FFFE and U+FFFF.",
    why: "XML parsers reject the file. Such characters come from truncated names or from device memory.",
    example: "A NUL in `<vendorName>`.",
    remedy: "Remove the character; XML cannot represent it.",
    source: "XML 1.0 §2.2",

    "xml/bad-reference" = BAD_REFERENCE, Error;
    summary: "a `&` does not start a reference",
    checks: "A name or a number and `;` must follow each `&`, and the number must be a character that XML allows. An invalid reference is read as text.",
    why: "XML parsers reject the file.",
    example: "`<vendorName>Miller & Sons</vendorName>`",
    remedy: "Write `&amp;` for `&`.",
    source: "XML 1.0 §4.1",

    "xml/unknown-entity" = UNKNOWN_ENTITY, Error;
    summary: "a reference names an unknown entity",
    checks: "Each `&name;` must be one of `&lt;` `&gt;` `&amp;` `&quot;` `&apos;` or be declared as text in the document type. Entities that are external files or markup are not read. An unknown reference is read as text.",
    why: "XML parsers reject the file. Names such as `&nbsp;` and `&deg;` exist only in HTML.",
    example: r#"`<label lang="en">Temperature in &deg;C</label>`"#,
    remedy: "Write the character itself, or its number such as `&#176;`.",
    source: "XML 1.0 §4.1, WFC: Entity Declared",

    "xml/bad-name" = BAD_NAME, Error;
    summary: "the name of an element or attribute is not a valid XML name",
    checks: "A name must start with a letter or `_` and continue with letters, digits, `-`, `.` and `_`. It may have one `:` with text before and after it.",
    why: "XML parsers reject the file.",
    example: "`<1018>`",
    remedy: "Write the name as in CiA 311.",
    source: "XML 1.0 §2.3; Namespaces in XML 1.0 §4",

    "xml/unbound-prefix" = UNBOUND_PREFIX, Error;
    summary: "a prefix is not declared",
    checks: "An `xmlns:` attribute of the element or a parent element must declare the prefix of each element and attribute.",
    why: "XML parsers reject the file. The declaration is usually lost when a part of a different file is copied.",
    example: r#"`<ProfileBody xsi:type="ProfileBody_Device_CANopen">` without `xmlns:xsi`"#,
    remedy: r#"Declare the prefix at the root, for example `xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"`."#,
    source: "Namespaces in XML 1.0 §5, NSC: Prefix Declared",

    "xml/bad-namespace" = BAD_NAMESPACE, Error;
    summary: "a namespace declaration is invalid",
    checks: "`xmlns:prefix` must have a value. The prefixes `xml` and `xmlns` and their namespaces must not be redefined.",
    why: "XML parsers reject the file.",
    example: r#"`<ISO15745ProfileContainer xmlns:q1="">`"#,
    remedy: "Remove the declaration, or write its namespace.",
    source: "Namespaces in XML 1.0 §3, §5",

    "xml/duplicate-attribute" = DUPLICATE_ATTRIBUTE, Error, stops "*";
    summary: "an element has an attribute twice",
    checks: "All attributes of an element must have different names, also after prefixes are replaced by their namespaces. The first one is used.",
    why: "XML parsers reject the file.",
    example: r#"`<CANopenObject index="1000" index="1001"/>`"#,
    remedy: "Remove one of the two.",
    source: "XML 1.0 §3.1, WFC: Unique Att Spec; Namespaces in XML 1.0 §6.3",

    "xml/missing-blank" = MISSING_BLANK, Error;
    summary: "a space is missing before an attribute",
    checks: "White space must separate an attribute from the preceding name or attribute.",
    why: "XML parsers reject the file.",
    example: r#"`<CANopenObject index="1000"name="Device type"/>`"#,
    remedy: "Add a space.",

    "xml/missing-value" = MISSING_VALUE, Error;
    summary: "an attribute has no value",
    checks: "Each attribute needs a `=` and a value. Attributes without a value are ignored.",
    why: "XML parsers reject the file; only HTML has such attributes.",
    example: "`<dummyUsage entry/>`",
    remedy: r#"Add a value, or remove the attribute."#,

    "xml/unquoted-value" = UNQUOTED_VALUE, Error;
    summary: "an attribute value has no quotes",
    checks: r#"Each value must be in `"` or `'`. A value without quotes ends at the next white space."#,
    why: "XML parsers reject the file.",
    example: "`<CANopenObject index=1000/>`",
    remedy: "Put quotes around the value.",

    "xml/unclosed-value" = UNCLOSED_VALUE, Error, stops "*";
    summary: "an attribute value has no closing quote",
    checks: "A value must end with its opening quote character. Otherwise it ends at the end of the tag or at the next attribute.",
    why: "XML parsers reject the file and report the error at the next quote, far from the cause.",
    example: r#"`<CANopenObject index="1000 name="Device type"/>`"#,
    remedy: "Add the closing quote.",

    "xml/less-than-in-value" = LESS_THAN_IN_VALUE, Error;
    summary: "an attribute value contains `<`",
    checks: "Attribute values must not contain `<`.",
    why: "XML parsers reject the file.",
    example: r#"`<CANopenObject index="2000" name="speed < 3000"/>`"#,
    remedy: "Write `&lt;`.",
    source: "XML 1.0 §3.1, WFC: No < in Attribute Values",

    "xml/junk-in-tag" = JUNK_IN_TAG, Error;
    summary: "a tag contains something other than attributes",
    checks: "After its name, a start tag may contain only attributes and an end tag nothing.",
    why: "XML parsers reject the file.",
    example: r#"`<label lang="en",>`"#,
    remedy: "Remove the text.",
}

/// Every rule of this module.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    RULES.iter().copied()
}

/// The help of a finding: the remedy from the page of the rule.
pub(super) fn advice(rule: &RuleInfo) -> String {
    let advice = rule.remedy.trim_end_matches('.');
    let mut letters = advice.chars();
    letters.next().map(|first| first.to_ascii_lowercase()).into_iter().chain(letters).collect()
}

/// A piece of the file for a message, shortened if it is long.
pub(super) fn shown(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(40) {
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
        None => Cow::Borrowed(text),
    }
}

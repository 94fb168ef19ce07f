//! The rules about characters, references, names and attributes.

use crate::diagnostic::text_rules;

text_rules! {
    source: "XML 1.0 §3.1";

    "xml/forbidden-character" = FORBIDDEN_CHARACTER, Error;
    summary: "the file contains a character that XML forbids",
    checks: "Whether the file contains control characters other than tab, LF and CR, or U+FFFE and U+FFFF.",
    why: "XML parsers reject the file. Such characters come from truncated names or from device memory.",
    example: "A NUL in `<vendorName>`.",
    remedy: "Remove the character; XML cannot represent it.",
    source: "XML 1.0 §2.2",

    "xml/bad-reference" = BAD_REFERENCE, Error;
    summary: "a `&` does not start a reference",
    checks: "Whether each `&` is followed by a name or a number and `;`, and whether the number is that of a character that XML allows. An invalid reference is read as text.",
    why: "XML parsers reject the file.",
    example: "`<vendorName>Miller & Sons</vendorName>`",
    remedy: "Write `&amp;` for `&`.",
    source: "XML 1.0 §4.1",

    "xml/unknown-entity" = UNKNOWN_ENTITY, Error;
    summary: "a reference names an unknown entity",
    checks: "Whether each `&name;` is one of `&lt;` `&gt;` `&amp;` `&quot;` `&apos;` or declared as text in the document type. Entities that are external files or markup are not read. An unknown reference is read as text.",
    why: "XML parsers reject the file. Names such as `&nbsp;` and `&deg;` exist only in HTML.",
    example: r#"`<label lang="en">Temperature in &deg;C</label>`"#,
    remedy: "Write the character itself, or its number such as `&#176;`.",
    source: "XML 1.0 §4.1, WFC: Entity Declared",

    "xml/bad-name" = BAD_NAME, Error;
    summary: "the name of an element or attribute is not a valid XML name",
    checks: "Whether names start with a letter or `_`, continue with letters, digits, `-`, `.` and `_`, and have at most one `:`, with text before and after it.",
    why: "XML parsers reject the file.",
    example: "`<1018>`",
    remedy: "Write the name as in CiA 311.",
    source: "XML 1.0 §2.3; Namespaces in XML 1.0 §4",

    "xml/unbound-prefix" = UNBOUND_PREFIX, Error;
    summary: "a prefix is not declared",
    checks: "Whether the prefix of each element and attribute is declared by an `xmlns:` attribute of the element or a parent element.",
    why: "XML parsers reject the file. The declaration is mostly lost when part of another file is copied.",
    example: r#"`<ProfileBody xsi:type="ProfileBody_Device_CANopen">` without `xmlns:xsi`"#,
    remedy: r#"Declare the prefix at the root, for example `xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"`."#,
    source: "Namespaces in XML 1.0 §5, NSC: Prefix Declared",

    "xml/bad-namespace" = BAD_NAMESPACE, Error;
    summary: "a namespace declaration is invalid",
    checks: "Whether `xmlns:prefix` has a value, and whether the prefixes `xml` and `xmlns` and their namespaces are not redefined.",
    why: "XML parsers reject the file.",
    example: r#"`<ISO15745ProfileContainer xmlns:q1="">`"#,
    remedy: "Remove the declaration, or write its namespace.",
    source: "Namespaces in XML 1.0 §3, §5",

    "xml/duplicate-attribute" = DUPLICATE_ATTRIBUTE, Error, stops "*";
    summary: "an element has an attribute twice",
    checks: "Whether all attributes of an element have different names, also after prefixes are replaced by their namespaces. The first one is used.",
    why: "XML parsers reject the file.",
    example: r#"`<CANopenObject index="1000" index="1001"/>`"#,
    remedy: "Remove one of the two.",
    source: "XML 1.0 §3.1, WFC: Unique Att Spec; Namespaces in XML 1.0 §6.3",

    "xml/missing-blank" = MISSING_BLANK, Error;
    summary: "a space is missing before an attribute",
    checks: "Whether white space separates an attribute from the preceding name or attribute.",
    why: "XML parsers reject the file.",
    example: r#"`<CANopenObject index="1000"name="Device type"/>`"#,
    remedy: "Add a space.",

    "xml/missing-value" = MISSING_VALUE, Error;
    summary: "an attribute has no value",
    checks: "Whether each attribute has a `=` and a value. Attributes without a value are ignored.",
    why: "XML parsers reject the file; only HTML has such attributes.",
    example: "`<dummyUsage entry/>`",
    remedy: r#"Add a value, or remove the attribute."#,

    "xml/unquoted-value" = UNQUOTED_VALUE, Error;
    summary: "an attribute value has no quotes",
    checks: r#"Whether each value is in `"` or `'`. A value without quotes ends at the next white space."#,
    why: "XML parsers reject the file.",
    example: "`<CANopenObject index=1000/>`",
    remedy: "Put quotes around the value.",

    "xml/unclosed-value" = UNCLOSED_VALUE, Error, stops "*";
    summary: "an attribute value has no closing quote",
    checks: "Whether a value ends with its opening quote character. A value without one ends at the end of the tag or at the next attribute.",
    why: "XML parsers reject the file, and report the error at the next quote, far from the cause.",
    example: r#"`<CANopenObject index="1000 name="Device type"/>`"#,
    remedy: "Add the closing quote.",

    "xml/less-than-in-value" = LESS_THAN_IN_VALUE, Error;
    summary: "an attribute value contains `<`",
    checks: "Whether values contain `<`.",
    why: "XML parsers reject the file.",
    example: r#"`<CANopenObject index="2000" name="speed < 3000"/>`"#,
    remedy: "Write `&lt;`.",
    source: "XML 1.0 §3.1, WFC: No < in Attribute Values",

    "xml/junk-in-tag" = JUNK_IN_TAG, Error;
    summary: "a tag contains something other than attributes",
    checks: "Whether start tags have only attributes after their names, and end tags nothing.",
    why: "XML parsers reject the file.",
    example: r#"`<label lang="en",>`"#,
    remedy: "Remove the text.",
}

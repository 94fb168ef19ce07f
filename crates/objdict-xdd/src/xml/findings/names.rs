//! The rules about characters, references, names and attributes.

use crate::diagnostic::text_rules;

text_rules! {
    /// the file has a character that XML forbids
    ///
    /// ## What it checks
    /// Whether there are control characters other than tab, LF and CR, or U+FFFE and U+FFFF.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file. Such characters come from names that were cut in the middle or read from the memory of a device.
    ///
    /// ## Example
    /// A NUL in `<vendorName>`.
    ///
    /// ## How to mend
    /// Remove the character; XML has no way to write it.
    ///
    /// ## Source
    /// XML 1.0 §2.2
    FORBIDDEN_CHARACTER = "xml/forbidden-character", Error;

    /// a `&` starts no reference
    ///
    /// ## What it checks
    /// Whether each `&` is followed by a name or a number and `;`, and whether the number is one of a character that XML allows. A bad reference is read as the text it is.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<vendorName>Miller & Sons</vendorName>`
    ///
    /// ## How to mend
    /// Write `&amp;` for `&`.
    ///
    /// ## Source
    /// XML 1.0 §4.1
    BAD_REFERENCE = "xml/bad-reference", Error;

    /// a reference names an entity that is not known
    ///
    /// ## What it checks
    /// Whether each `&name;` is one of `&lt;` `&gt;` `&amp;` `&quot;` `&apos;` or declared as text in the document type. An entity that is another file or markup is not read. The reference is read as the text it is.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file. Names such as `&nbsp;` and `&deg;` are of HTML.
    ///
    /// ## Example
    /// `<label lang="en">Temperature in &deg;C</label>`
    ///
    /// ## How to mend
    /// Write the character itself, or its number: `&#176;`.
    ///
    /// ## Source
    /// XML 1.0 §4.1, WFC: Entity Declared
    UNKNOWN_ENTITY = "xml/unknown-entity", Error;

    /// the name of an element or attribute is no name of XML
    ///
    /// ## What it checks
    /// Whether names start with a letter or `_`, go on with letters, digits, `-`, `.` and `_`, and have at most one `:`, with something before and behind it.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<1018>`
    ///
    /// ## How to mend
    /// Spell the name as CiA 311 does.
    ///
    /// ## Source
    /// XML 1.0 §2.3; Namespaces in XML 1.0 §4
    BAD_NAME = "xml/bad-name", Error;

    /// a prefix is not declared
    ///
    /// ## What it checks
    /// Whether the prefix of each element and attribute is declared by an `xmlns:` attribute of the element itself or of one around it.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file. The prefix is mostly lost when a part of another file is copied.
    ///
    /// ## Example
    /// `<ProfileBody xsi:type="ProfileBody_Device_CANopen">` without `xmlns:xsi`
    ///
    /// ## How to mend
    /// Declare the prefix at the root, for example `xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"`.
    ///
    /// ## Source
    /// Namespaces in XML 1.0 §5, NSC: Prefix Declared
    UNBOUND_PREFIX = "xml/unbound-prefix", Error;

    /// a declaration of a namespace is not allowed
    ///
    /// ## What it checks
    /// Whether `xmlns:prefix` has a value, and whether the prefixes `xml` and `xmlns` and their namespaces stay what they are.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<ISO15745ProfileContainer xmlns:q1="">`
    ///
    /// ## How to mend
    /// Remove the declaration, or give it its namespace.
    ///
    /// ## Source
    /// Namespaces in XML 1.0 §3, §5
    BAD_NAMESPACE = "xml/bad-namespace", Error;

    /// an element has an attribute twice
    ///
    /// ## What it checks
    /// Whether the names of all attributes of an element differ, also when prefixes are replaced by their namespaces. The first one is read.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<CANopenObject index="1000" index="1001"/>`
    ///
    /// ## How to mend
    /// Remove one of them.
    ///
    /// ## Source
    /// XML 1.0 §3.1, WFC: Unique Att Spec; Namespaces in XML 1.0 §6.3
    DUPLICATE_ATTRIBUTE = "xml/duplicate-attribute", Error;

    /// no blank stands before an attribute
    ///
    /// ## What it checks
    /// Whether blanks part an attribute from the name or the attribute before it.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<CANopenObject index="1000"name="Device type"/>`
    ///
    /// ## How to mend
    /// Add a blank.
    ///
    /// ## Source
    /// XML 1.0 §3.1
    MISSING_BLANK = "xml/missing-blank", Error;

    /// an attribute has no value
    ///
    /// ## What it checks
    /// Whether each attribute has a `=` and a value. One without is not read.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file; only HTML has such attributes.
    ///
    /// ## Example
    /// `<dummyUsage entry/>`
    ///
    /// ## How to mend
    /// Write `entry="…"`, or remove the attribute.
    ///
    /// ## Source
    /// XML 1.0 §3.1
    MISSING_VALUE = "xml/missing-value", Error;

    /// the value of an attribute has no quotes
    ///
    /// ## What it checks
    /// Whether each value stands in `"` or `'`. Without quotes it is read up to the next blank.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<CANopenObject index=1000/>`
    ///
    /// ## How to mend
    /// Put quotes around the value.
    ///
    /// ## Source
    /// XML 1.0 §3.1
    UNQUOTED_VALUE = "xml/unquoted-value", Error;

    /// the value of an attribute has no closing quote
    ///
    /// ## What it checks
    /// Whether a value ends with the quote that it starts with. Without one it is read up to the end of the tag or to the attribute behind it.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file, and name a place far behind, where the next quote is.
    ///
    /// ## Example
    /// `<CANopenObject index="1000 name="Device type"/>`
    ///
    /// ## How to mend
    /// Add the quote.
    ///
    /// ## Source
    /// XML 1.0 §3.1
    UNCLOSED_VALUE = "xml/unclosed-value", Error;

    /// the value of an attribute has a `<` in it
    ///
    /// ## What it checks
    /// Whether values are free of `<`.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<CANopenObject index="2000" name="speed < 3000"/>`
    ///
    /// ## How to mend
    /// Write `&lt;`.
    ///
    /// ## Source
    /// XML 1.0 §3.1, WFC: No < in Attribute Values
    LESS_THAN_IN_VALUE = "xml/less-than-in-value", Error;

    /// a tag has something in it that is no attribute
    ///
    /// ## What it checks
    /// Whether start tags have nothing but attributes behind their names, and end tags nothing at all.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<label lang="en",>`
    ///
    /// ## How to mend
    /// Remove it.
    ///
    /// ## Source
    /// XML 1.0 §3.1
    JUNK_IN_TAG = "xml/junk-in-tag", Error;
}

//! The rules about the structure of a document: elements, markup, encoding and limits.

use crate::diagnostic::text_rules;

text_rules! {
    /// an element has no end tag
    ///
    /// ## What it checks
    /// Whether each start tag has its end tag, before the element around it ends and before the file does.
    ///
    /// ## Why it matters
    /// XML parsers refuse the whole file. A file that was cut off while it was saved or loaded shows just this.
    ///
    /// ## Example
    /// `<label lang="en">Device type` and then `</CANopenObject>`
    ///
    /// ## How to mend
    /// Add the end tag; where the file ends early, fetch it again.
    ///
    /// ## Source
    /// XML 1.0 §3.1
    UNCLOSED_ELEMENT = "xml/unclosed-element", Error;

    /// an end tag ends no element
    ///
    /// ## What it checks
    /// Whether each end tag has the name of the element that it closes. One that closes no element at all is passed over; one that is spelled like the open element but for case or prefix closes it.
    ///
    /// ## Why it matters
    /// XML parsers refuse the whole file.
    ///
    /// ## Example
    /// `<q1:deviceFamily>…</deviceFamily>`
    ///
    /// ## How to mend
    /// Spell the end tag like its start tag, or remove it.
    ///
    /// ## Source
    /// XML 1.0 §3, WFC: Element Type Match
    STRAY_END_TAG = "xml/stray-end-tag", Error;

    /// the file has no element
    ///
    /// ## What it checks
    /// Whether there is any element in the file.
    ///
    /// ## Why it matters
    /// A file of blanks or comments, or of something else than XML, describes no device.
    ///
    /// ## Example
    /// A text file with the ending `.xdd`.
    ///
    /// ## How to mend
    /// Give the right file.
    ///
    /// ## Source
    /// XML 1.0 §2.1
    NO_ROOT = "xml/no-root", Error;

    /// a second element stands behind the root
    ///
    /// ## What it checks
    /// Whether the file ends with its outermost element but for comments and processing instructions. What stands behind it is not read.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file. Often two files were put together into one, or an end tag is there too early.
    ///
    /// ## Example
    /// `</ISO15745ProfileContainer><ISO15745ProfileContainer>`
    ///
    /// ## How to mend
    /// Make two files of it, or put the element into the root.
    ///
    /// ## Source
    /// XML 1.0 §2.1
    SECOND_ROOT = "xml/second-root", Error;

    /// text stands before or behind the root
    ///
    /// ## What it checks
    /// Whether there is anything but blanks, comments, processing instructions and the document type around the outermost element.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file. A NUL or a Ctrl-Z at the end comes from old tools, a line of text from a web page or a merge.
    ///
    /// ## Example
    /// `</ISO15745ProfileContainer>x`
    ///
    /// ## How to mend
    /// Remove the text.
    ///
    /// ## Source
    /// XML 1.0 §2.1
    TEXT_OUTSIDE_ROOT = "xml/text-outside-root", Error;

    /// a tag has no `>`
    ///
    /// ## What it checks
    /// Whether each tag has its `>` before the next `<`.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file or take what follows for a part of the tag.
    ///
    /// ## Example
    /// `<label lang="en"` and in the next line `<label lang="de">`
    ///
    /// ## How to mend
    /// Add the `>`.
    ///
    /// ## Source
    /// XML 1.0 §3.1
    UNCLOSED_TAG = "xml/unclosed-tag", Error;

    /// a comment, a CDATA section or a processing instruction has no end
    ///
    /// ## What it checks
    /// Whether each `<!--` has its `-->`, each `<![CDATA[` its `]]>`, each `<?` its `?>`. The markup up to the next `<` is passed over.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file. Without its end, a comment hides the rest of the device.
    ///
    /// ## Example
    /// `<!-- objects of the application ->`
    ///
    /// ## How to mend
    /// Add the end.
    ///
    /// ## Source
    /// XML 1.0 §2.5, §2.6, §2.7
    UNCLOSED_MARKUP = "xml/unclosed-markup", Error;

    /// markup that starts with `<!` is none that XML has
    ///
    /// ## What it checks
    /// Whether what starts with `<!` is a comment, a CDATA section or, before the root, a document type.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<!ELEMENT label ANY>` between objects
    ///
    /// ## How to mend
    /// Remove it; a comment is `<!-- … -->`.
    ///
    /// ## Source
    /// XML 1.0 §2.1, §3.1
    UNKNOWN_MARKUP = "xml/unknown-markup", Error;

    /// a `<` starts no tag
    ///
    /// ## What it checks
    /// Whether each `<` in the text is followed by a name, `/`, `!` or `?`. A lone one is read as a character.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<description lang="en">valid if speed < 3000</description>`
    ///
    /// ## How to mend
    /// Write `&lt;`.
    ///
    /// ## Source
    /// XML 1.0 §2.4
    LONE_LESS_THAN = "xml/lone-less-than", Error;

    /// a comment has `--` in it
    ///
    /// ## What it checks
    /// Whether there is a `--` between `<!--` and `-->`; `--->` has one.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file, although many an editor shows the comment as one.
    ///
    /// ## Example
    /// `<!-- ---- objects ---- -->`
    ///
    /// ## How to mend
    /// Write `==` or `- -`.
    ///
    /// ## Source
    /// XML 1.0 §2.5
    DOUBLE_HYPHEN = "xml/double-hyphen", Error;

    /// a text has `]]>` in it
    ///
    /// ## What it checks
    /// Whether `]]>` stands outside CDATA sections.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<label lang="en">gain[index[2]]>1</label>`
    ///
    /// ## How to mend
    /// Write `]]&gt;`.
    ///
    /// ## Source
    /// XML 1.0 §2.4
    CDATA_END_IN_TEXT = "xml/cdata-end-in-text", Error;

    /// the XML declaration is not the first thing in the file
    ///
    /// ## What it checks
    /// Whether `<?xml … ?>` stands at the very start.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file: they look for the declaration, and the encoding in it, in the first bytes only.
    ///
    /// ## Example
    /// A blank line before `<?xml version="1.0"?>`.
    ///
    /// ## How to mend
    /// Remove what stands before it, or the second declaration.
    ///
    /// ## Source
    /// XML 1.0 §2.8
    MISPLACED_DECLARATION = "xml/misplaced-declaration", Error;

    /// the XML declaration is malformed
    ///
    /// ## What it checks
    /// Whether the declaration has `version`, then `encoding`, then `standalone`, of which only the first must be there, and each with a value that XML knows.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<?xml encoding="utf-8"?>`
    ///
    /// ## How to mend
    /// Write `<?xml version="1.0" encoding="UTF-8"?>`.
    ///
    /// ## Source
    /// XML 1.0 §2.8
    BAD_DECLARATION = "xml/bad-declaration", Error;

    /// a processing instruction has no good target
    ///
    /// ## What it checks
    /// Whether `<?` is followed by a name and a blank, and that name is not `xml` in any case.
    ///
    /// ## Why it matters
    /// XML parsers refuse the file.
    ///
    /// ## Example
    /// `<?XML version="1.0"?>`
    ///
    /// ## How to mend
    /// Write `<?xml` in small letters at the start of the file; elsewhere remove the instruction.
    ///
    /// ## Source
    /// XML 1.0 §2.6
    BAD_TARGET = "xml/bad-target", Error;

    /// the file has a document type
    ///
    /// ## What it checks
    /// Whether there is a `<!DOCTYPE … >`. Of the entities that it declares, those that stand for text are read, up to 1 MiB; nothing is ever read from another file. A document type that is malformed is an error.
    ///
    /// ## Why it matters
    /// No profile of CANopen has one. Tools refuse it for safety, because entities can read files of the user and fill his memory.
    ///
    /// ## Example
    /// `<!DOCTYPE ISO15745ProfileContainer SYSTEM "canopen.dtd">`
    ///
    /// ## How to mend
    /// Remove it, and write the texts that its entities stand for.
    ///
    /// ## Source
    /// XML 1.0 §2.8; CiA 311
    DOCUMENT_TYPE = "xml/document-type", Warning;

    /// the file is not in the encoding that it names
    ///
    /// ## What it checks
    /// Whether `encoding` in the XML declaration agrees with the bytes of the file: a byte order mark, valid UTF-8, or neither. A file without declaration is UTF-8.
    ///
    /// ## Why it matters
    /// Parsers follow the declaration: they refuse the file, or show `Â°` for `°`.
    ///
    /// ## Example
    /// `<?xml version="1.0" encoding="utf-16"?>` in a file of one byte a character
    ///
    /// ## How to mend
    /// Name the encoding that the file is in, best UTF-8.
    ///
    /// ## Source
    /// XML 1.0 §4.3.3
    ENCODING = "xml/encoding", Error;

    /// the file is beyond a limit of this reader
    ///
    /// ## What it checks
    /// Elements nest 256 deep, an element has 256 attributes, a name 32,000 bytes, the file 4 million elements and 1 MiB of text from its own entities. What is beyond is not read.
    ///
    /// ## Why it matters
    /// No device needs as much; files that do are made to fill the memory of tools.
    ///
    /// ## Example
    /// A thousand `<a>` in each other.
    ///
    /// ## How to mend
    /// Look who made the file.
    ///
    /// ## Source
    /// none; XML has no limits
    LIMIT = "xml/limit", Error;
}

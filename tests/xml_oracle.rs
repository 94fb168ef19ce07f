//! Another reader of XML, roxmltree, says of the same texts whether they are well-formed, and sees the same elements,
//! attributes and texts in those that are.

// a fixture that cannot be read is a failed test
#![allow(clippy::unwrap_used)]

use std::fmt::Write;

use objdict::diagnostic::Findings;
use objdict::format::xml::{Element, Tree};
use objdict::source::SourceFile;

fn read(text: &str) -> (Tree, Findings) {
    let mut findings = Findings::new();
    let tree = Tree::new(SourceFile::from_text("test.xdd", text), &mut findings);
    (tree, findings)
}

fn messages(findings: &Findings) -> Vec<String> {
    findings.iter().map(|finding| format!("{}: {}", finding.rule.id, finding.message)).collect()
}

fn theirs(text: &str) -> Result<roxmltree::Document<'_>, roxmltree::Error> {
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..roxmltree::ParsingOptions::default() };
    roxmltree::Document::parse_with_options(text, options)
}

/// Names, namespaces, attributes and texts, a line each.
fn our_outline(tree: &Tree) -> String {
    fn show(element: Element<'_>, outline: &mut String) {
        let text = element.text();
        writeln!(outline, "{:?} {} {text:?} {:?}", element.namespace(), element.name(), element.span())
            .unwrap();
        for attribute in element.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            writeln!(outline, "  {:?} {name} {value:?}", attribute.namespace()).unwrap();
        }
        for child in element.children() {
            show(child, outline);
        }
    }
    let mut outline = String::new();
    show(tree.root().unwrap(), &mut outline);
    outline
}

fn their_outline(document: &roxmltree::Document<'_>) -> String {
    let mut outline = String::new();
    for element in document.descendants().filter(roxmltree::Node::is_element) {
        let name = element.tag_name();
        let text: String =
            element.children().filter(roxmltree::Node::is_text).filter_map(|text| text.text()).collect();
        let (start, end) = (element.range().start as u32, element.range().end as u32);
        let span = objdict::source::Span::new(start, end);
        let namespace = name.namespace().filter(|uri| !uri.is_empty());
        writeln!(outline, "{namespace:?} {} {text:?} {span:?}", name.name()).unwrap();
        for attribute in element.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            writeln!(outline, "  {:?} {name} {value:?}", attribute.namespace()).unwrap();
        }
    }
    outline
}

/// What the two readers disagree about; `None` when they agree.
fn disagreement(text: &str) -> Option<String> {
    let (tree, findings) = read(text);
    match (theirs(text), tree.is_complete()) {
        (Ok(document), true) => {
            let (ours, theirs) = (our_outline(&tree), their_outline(&document));
            (ours != theirs).then(|| format!("ours:\n{ours}\ntheirs:\n{theirs}"))
        }
        (Err(_), false) => None,
        (Err(error), true) => Some(format!("roxmltree: {error}")),
        (Ok(_), false) => Some(format!("ours: {:?}", messages(&findings))),
    }
}

/// Texts with one defect each, and the rules that find it.
const DEFECTS: &[(&str, &[&str])] = &[
    ("<a><b></a>", &["unclosed-element"]),
    ("<a><b>", &["unclosed-element", "unclosed-element"]),
    ("<a></b></a>", &["stray-end-tag"]),
    ("<a><b></B></a>", &["stray-end-tag"]),
    ("<a/></a>", &["stray-end-tag"]),
    ("", &["no-root"]),
    ("<!-- -->", &["no-root"]),
    ("<a/><b/>", &["second-root"]),
    ("<a/><b><c></b>", &["second-root"]),
    ("x<a/>", &["text-outside-root"]),
    ("<a/>\0", &["forbidden-character", "text-outside-root"]),
    ("<a/>&amp;", &["text-outside-root"]),
    ("<a/><![CDATA[x]]>", &["text-outside-root"]),
    ("<a <b/></a>", &["unclosed-tag"]),
    ("<a></a", &["unclosed-tag"]),
    ("<a><b></b <c/></a>", &["unclosed-tag"]),
    ("<a><!-- ></a>", &["unclosed-markup"]),
    ("<a><![CDATA[ ]></a>", &["unclosed-markup"]),
    ("<a><?x ></a>", &["unclosed-markup"]),
    ("<a><!ELEMENT b></a>", &["unknown-markup"]),
    ("<a><![cdata[x]]></a>", &["unknown-markup"]),
    ("<a>1 < 2</a>", &["lone-less-than"]),
    ("<a>1 <2</a>", &["lone-less-than"]),
    ("<a><!-- -- --></a>", &["double-hyphen"]),
    ("<a><!-- ---></a>", &["double-hyphen"]),
    ("<a>]]></a>", &["cdata-end-in-text"]),
    ("\n<?xml version='1.0'?><a/>", &["misplaced-declaration"]),
    ("<a><?xml version='1.0'?></a>", &["misplaced-declaration"]),
    ("<?xml encoding='utf-8'?><a/>", &["bad-declaration"]),
    ("<?xml version='1.0'encoding='utf-8'?><a/>", &["bad-declaration"]),
    ("<?xml version='1.0' standalone='yes' encoding='utf-8'?><a/>", &["bad-declaration"]),
    ("<a><?XML x?></a>", &["bad-target"]),
    ("<a><? x?></a>", &["bad-target"]),
    ("<a>\u{1}</a>", &["forbidden-character"]),
    ("<a b='\u{FFFF}'/>", &["forbidden-character"]),
    ("<a>AT&T</a>", &["bad-reference"]),
    ("<a>&#0;</a>", &["bad-reference"]),
    ("<a>&#xD800;</a>", &["bad-reference"]),
    ("<a b='&'/>", &["bad-reference"]),
    ("<a>&nbsp;</a>", &["unknown-entity"]),
    ("<a b='&deg;'/>", &["unknown-entity"]),
    ("<1/>", &["bad-name"]),
    ("<a 1='2'/>", &["bad-name"]),
    ("<a b$='2'/>", &["bad-name"]),
    ("<:a/>", &["bad-name"]),
    ("<b:a/>", &["unbound-prefix"]),
    ("<a b:c=''/>", &["unbound-prefix"]),
    ("<a><b xmlns:c='d'/><c:e/></a>", &["unbound-prefix"]),
    ("<a xmlns:b=''/>", &["bad-namespace"]),
    ("<a xmlns:xml='b'/>", &["bad-namespace"]),
    ("<a xmlns='http://www.w3.org/2000/xmlns/'/>", &["bad-namespace"]),
    ("<a b='1' b='2'/>", &["duplicate-attribute"]),
    ("<a xmlns:c='x' xmlns:d='x' c:b='1' d:b='2'/>", &["duplicate-attribute"]),
    ("<a xmlns='x' xmlns='x'/>", &["duplicate-attribute"]),
    ("<a b='1'c='2'/>", &["missing-blank"]),
    ("<a b c='2'/>", &["missing-value"]),
    ("<a b= c='2'/>", &["missing-value"]),
    ("<a b=1/>", &["unquoted-value"]),
    ("<a b='1/>", &["unclosed-value"]),
    ("<a b='1 c='2'/>", &["unclosed-value"]),
    ("<a><b c='1>\n<d e='2'/></b></a>", &["unclosed-value"]),
    ("<a b='<'/>", &["less-than-in-value"]),
    ("<a / b='1'/>", &["junk-in-tag"]),
    ("<a></a b='1'>", &["junk-in-tag"]),
];

/// What roxmltree lets pass although XML or its namespaces forbid it.
const LENIENT: &[&str] =
    &["<a><?XML x?></a>", "<a>&#xD800;</a>", "<:a/>", "<a xmlns:b=''/>", "<a xmlns='x' xmlns='x'/>"];

#[test]
fn each_defect_is_found_once() {
    let mut wrong = String::new();
    for (text, rules) in DEFECTS {
        let (_, findings) = read(text);
        let found: Vec<&str> = findings.iter().map(|finding| finding.rule.name()).collect();
        if &found != rules {
            writeln!(wrong, "{text}: {:?}", messages(&findings)).unwrap();
        }
        if theirs(text).is_ok() != LENIENT.contains(text) {
            writeln!(wrong, "{text}: not as expected for roxmltree").unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn healthy_texts_are_seen_alike() {
    for text in [
        "<a/>",
        "\u{FEFF}<a/>",
        "<?xml version=\"1.0\" encoding='utf-8' standalone='yes' ?>\n<!-- x --><a b='c' />\n<?x y?>\n",
        "<a>1<b>2</b>3<![CDATA[<&\r\n]]>4&lt;&#x41;<!-- 5 --><?p 6?>7\r\n8</a>",
        "<a b='1\n2&#10;3\t&quot;' c=\"'&apos;&amp;amp;\"></a >",
        "<a xmlns='x' xmlns:q='y'><q:b q:c='1' c='2' xml:lang='en'><d xmlns=''><e/></d></q:b><b xmlns:q='z' q:c=''/></a>",
        "<Größe ß='1'/>",
        "<!DOCTYPE a><a/>",
        "<!DOCTYPE a [<!ENTITY b 'c'>]><a d='&b;'>&b;&b;</a>",
    ] {
        if let Some(disagreement) = disagreement(text) {
            panic!("{text}\n{disagreement}");
        }
    }
}

//! Another reader of XML, roxmltree, says of the same texts whether they are well-formed, and sees the same elements,
//! attributes and texts in those that are.
//!
//! Where roxmltree lets pass what XML or its namespaces forbid, we go by the standards: [`LENIENT`] and [`is_lenient`] are
//! the whole list. There is nothing that roxmltree refuses and we take, but for what no text here has: it knows limits too.

use std::fmt::Write;
use std::time::{Duration, Instant};

use objdict::diagnostic::{Diagnostic, Findings};
use objdict::source::{SourceFile, SourceOptions, Span};
use objdict_xdd::xml::{Element, Tree};
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::RngSeed;

use crate::support;

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
        // of the other side, see below, a CR of a reference cannot be distinguished from others
        let text = element.text().replace('\r', "\n");
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
        // it leaves a CR before a reference as it is, against XML 1.0 §2.11
        let text = text.replace('\r', "\n");
        let (start, end) = (element.range().start as u32, element.range().end as u32);
        let span = Span::new(start, end);
        let namespace = name.namespace().filter(|uri| !uri.is_empty());
        writeln!(outline, "{namespace:?} {} {text:?} {span:?}", name.name()).unwrap();
        for attribute in element.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            writeln!(outline, "  {:?} {name} {value:?}", attribute.namespace()).unwrap();
        }
    }
    outline
}

/// Whether a finding is about something that roxmltree does not look at: the parts of an XML declaration, the name of a
/// processing instruction, a colon at the start of a name, a prefix that is declared to mean nothing, `xmlns` twice, and
/// the encoding, for it reads text. Limits are ours alone.
fn is_lenient(finding: &Diagnostic) -> bool {
    let message = finding.message.shown();
    let has_colon_name = || message.contains("`:") || message.contains("`</:");
    match finding.rule.name() {
        "bad-declaration" | "bad-target" | "bad-namespace" | "encoding" | "limit" => true,
        "bad-name" | "stray-end-tag" => has_colon_name(),
        "duplicate-attribute" => message.contains("`xmlns"),
        _ => false,
    }
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
        (Ok(_), false) if findings.iter().any(is_lenient) => None,
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

#[test]
fn every_fixture_is_seen_alike() {
    let mut files = 0;
    for path in support::files("", &["xdd", "xdc", "nxdd", "xml"]) {
        let source = SourceFile::open(&path, &SourceOptions::default()).unwrap();
        if let Some(disagreement) = disagreement(source.text()) {
            panic!("{}\n{disagreement}", path.display());
        }
        files += 1;
    }
    assert!(files > 60);
}

/// What a document of the tests is made of.
#[derive(Clone, Debug)]
enum Node {
    Element(&'static str, Vec<(&'static str, String)>, Vec<Node>),
    Text(String),
    Raw(&'static str),
}

fn print(node: &Node, text: &mut String) {
    match node {
        Node::Element(name, attributes, children) => {
            write!(text, "<{name} xmlns:q='urn:q'").unwrap();
            for (number, (name, value)) in attributes.iter().enumerate() {
                let is_new = attributes[..number].iter().all(|(other, _)| other != name);
                let value = value.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
                if is_new {
                    write!(text, "\n {name} = \"{value}\"").unwrap();
                }
            }
            if children.is_empty() {
                return text.push_str("/>");
            }
            text.push('>');
            children.iter().for_each(|child| print(child, text));
            write!(text, "</{name}>").unwrap();
        }
        Node::Text(raw) => {
            text.push_str(&raw.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;"));
        }
        Node::Raw(raw) => text.push_str(raw),
    }
}

const RAW: [&str; 7] = [
    "<!-- > - <a> -->",
    "<![CDATA[<&]] >]]>",
    "<?p x='<'?>",
    "&#xE9;&#9;",
    "&apos;",
    "\r\n",
    "<e xmlns='urn:e'/>",
];

fn arb_node() -> impl Strategy<Value = Node> {
    let names = prop::sample::select(vec!["a", "b", "q:c", "Größe", "d-1.e"]);
    let keys = prop::sample::select(vec!["i", "j", "q:j", "xml:lang", "xmlns"]);
    let attributes = prop::collection::vec((keys, "[ -~\té\n]{1,8}"), 0..4);
    let leaf = prop_oneof![
        "[ -~\r\né]{0,12}".prop_map(Node::Text),
        prop::sample::select(RAW.to_vec()).prop_map(Node::Raw)
    ];
    let start = (names, attributes);
    let root = move |inner: BoxedStrategy<Node>| {
        (start.clone(), prop::collection::vec(inner, 0..5))
            .prop_map(|((name, attributes), children)| Node::Element(name, attributes, children))
    };
    let nested = leaf.prop_recursive(4, 24, 5, {
        let root = root.clone();
        move |inner| root(inner.boxed())
    });
    root(nested.boxed())
}

fn arb_document() -> impl Strategy<Value = String> {
    arb_node().prop_map(|node| {
        let mut text = String::from("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n");
        print(&node, &mut text);
        text
    })
}

/// A change of a text: what goes in, where, and how many characters go away there.
type Mutation = (Index, usize, String);

const MARKS: [&str; 24] = [
    "<",
    ">",
    "/",
    "=",
    "'",
    "\"",
    "&",
    ";",
    "!",
    "?",
    "-",
    "--",
    ":",
    "]]>",
    "<a>",
    "</a>",
    "<!--",
    "-->",
    "<![CDATA[",
    "&x;",
    "\u{1}",
    "\u{FEFF}",
    " b ",
    " c=1",
];

fn arb_mutations() -> impl Strategy<Value = Vec<Mutation>> {
    let mark = prop_oneof![
        Just(String::new()),
        prop::sample::select(MARKS.to_vec()).prop_map(str::to_owned),
        "[ -~]"
    ];
    prop::collection::vec((any::<Index>(), 0..3usize, mark), 1..4)
}

fn mutated(text: &str, mutations: &[Mutation]) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    for (at, away, new) in mutations {
        let at = at.index(characters.len() + 1);
        let end = (at + away).min(characters.len());
        characters.splice(at..end, new.chars());
    }
    characters.into_iter().collect()
}

/// Calls everything that a tree has, and sees that its spans are spans of its text and lie in each other.
fn walk(tree: &Tree) {
    let text = tree.text();
    let Some(root) = tree.root() else { return };
    for element in std::iter::once(root).chain(root.descendants()) {
        let is_inside = |inner: Span, outer: Span| outer.start <= inner.start && inner.end <= outer.end;
        let span = element.span();
        assert!(text.get(span.start as usize..span.end as usize).is_some());
        for inner in [element.tag_span(), element.inner_span(), element.text_span()] {
            assert!(inner.start <= inner.end && is_inside(inner, span), "{element:?}");
        }
        assert!(is_inside(element.name_span(), element.tag_span()));
        assert_eq!(tree.element(element.id()).span(), span);
        if let Some(parent) = element.parent() {
            assert!(is_inside(span, parent.inner_span()), "{element:?}");
            assert!(parent.children().any(|child| child.id() == element.id()));
        }
        let _ = (element.text(), element.namespace(), element.prefix(), element.is_empty_tag());
        for attribute in element.attributes() {
            assert!(is_inside(attribute.value_span(), attribute.span()));
            assert!(is_inside(attribute.span(), element.tag_span()), "{attribute:?}");
            let _ = (attribute.value(), attribute.namespace(), attribute.prefix());
        }
    }
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(311),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(config(256))]

    #[test]
    fn a_made_document_is_seen_alike(text in arb_document()) {
        let (tree, findings) = read(&text);
        prop_assert!(findings.is_empty(), "{text}\n{:?}", messages(&findings));
        prop_assert_eq!(disagreement(&text), None, "{}", text);
        walk(&tree);
    }

    #[test]
    fn a_damaged_document_is_judged_alike(text in arb_document(), mutations in arb_mutations()) {
        let text = mutated(&text, &mutations);
        let (tree, findings) = read(&text);
        prop_assert_eq!(disagreement(&text), None, "{}", text);
        prop_assert_eq!(tree.is_complete(), !findings.has_errors());
        walk(&tree);
    }

    #[test]
    fn any_text_is_read(text in ".{0,64}", pieces in prop::collection::vec(prop::sample::select(MARKS.to_vec()), 0..24)) {
        walk(&read(&text).0);
        let text = pieces.concat();
        prop_assert_eq!(disagreement(&text), None, "{}", text);
        walk(&read(&text).0);
    }
}

/// A text of `count` pieces between a start and an end.
fn repeated(start: &str, piece: &str, end: &str) -> String {
    format!("{start}{}{end}", piece.repeat((1 << 18) / piece.len()))
}

/// Reads a text of about 256 KB that was made to be slow, and gives the rules that found something.
fn read_hostile(name: &str, text: &str) -> Vec<&'static str> {
    let start = Instant::now();
    let (tree, findings) = read(text);
    let _ = tree.root().map(|root| root.text().len());
    // a debug build needs a second; what is quadratic needs minutes
    let time = start.elapsed();
    assert!(time < Duration::from_secs(30), "{name}: {time:?}");
    let mut rules: Vec<_> = findings.iter().map(|finding| finding.rule.name()).collect();
    rules.sort_unstable();
    rules.dedup();
    rules
}

#[test]
fn hostile_texts_end_soon() {
    let nested = read_hostile("elements in each other", &repeated("", "<a>", ""));
    assert_eq!(nested, ["limit", "unclosed-element"]);
    assert_eq!(read_hostile("attributes", &repeated("<a", " b='1'", "/>")), ["duplicate-attribute", "limit"]);
    assert_eq!(read_hostile("elements", &repeated("<a>", "<b/>", "</a>")), [""; 0]);
    assert_eq!(read_hostile("end tags", &repeated("<a>", "</b>", "</a>")), ["stray-end-tag"]);
    assert_eq!(read_hostile("references", &repeated("<a>", "&b;", "</a>")), ["unknown-entity"]);
    assert_eq!(read_hostile("a name", &repeated("<", "a", "/>")), ["limit"]);
    for (piece, rule) in [
        ("<!--", "unclosed-markup"),
        ("<![CDATA[", "unclosed-markup"),
        ("<?p ", "unclosed-markup"),
        ("<a b='", "unclosed-value"),
        ("<a b='1 \"", "unclosed-value"),
        ("<a <a \"", "junk-in-tag"),
        ("</a '", "stray-end-tag"),
        ("<!DOCTYPE a [", "document-type"),
        ("<", "lone-less-than"),
        ("&", "bad-reference"),
        ("<1", "lone-less-than"),
    ] {
        let rules = read_hostile(piece, &repeated("<r>", piece, ""));
        assert!(rules.contains(&rule) && rules.len() < 8, "{piece}: {rules:?}");
    }
}

#[test]
fn entities_do_not_grow() {
    let mut text = String::from("<!DOCTYPE a [<!ENTITY l0 'ha'>");
    for level in 1..30 {
        let inner = format!("&l{};", level - 1).repeat(10);
        write!(text, "<!ENTITY l{level} '{inner}'>").unwrap();
    }
    text.push_str("]><a>&l29;</a>");
    assert_eq!(read_hostile("laughter", &text), ["document-type", "unknown-entity"]);
    let big = "x".repeat(60_000);
    let many = format!("<!DOCTYPE a [<!ENTITY b '{big}'>]><a>{}</a>", "&b;".repeat(1000));
    assert_eq!(read_hostile("one entity often", &many), ["document-type", "limit", "unknown-entity"]);
    let (tree, _) = read(&many);
    assert!(tree.root().unwrap().text().len() < 1 << 20);
    let file = "<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/hostname'>]><a>&b;</a>";
    assert_eq!(read(file).0.root().unwrap().text(), "&b;");
}

#[test]
fn namespaces_do_not_multiply() {
    let mut text = String::new();
    for level in 0..200 {
        text.push_str("<a");
        for number in 0..200 {
            write!(text, " xmlns:n{level}x{number}='u{number}'").unwrap();
        }
        text.push('>');
    }
    text.push_str(&"<n199x1:b n0x1:c=''/>".repeat(10_000));
    text.push_str(&"</a>".repeat(200));
    assert_eq!(read_hostile("namespaces", &text), [""; 0]);
}

//! Pictures of networks.

use std::collections::BTreeSet;

use objdict::network::{Overview, graph};
use roxmltree::{Document, Node};

use crate::links::{many, open};

/// A ring of nodes, the first of which is the manager.
fn overview(nodes: usize, name: &str) -> Overview {
    let bus = format!("[bus]\nname = '{name}'\nbit-rate = 1000\nsync = '10ms'\nmanager = 'n0'\n");
    let file = open(&format!("graph{nodes}"), &(bus + &many(nodes)));
    Overview::new(file.network().unwrap(), file.compiled().unwrap())
}

fn number(node: Node<'_, '_>, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

#[test]
fn nothing_overlaps_in_pictures_of_few_and_of_many_nodes() {
    for nodes in [2, 10, 11, 127] {
        let overview = overview(nodes, "a <b> & \"c\"");
        let svg = graph::svg(&overview, |can_id| can_id.to_string());
        let document = Document::parse(&svg).unwrap();
        let root = document.root_element();
        let boxes: Vec<Node<'_, '_>> = root
            .descendants()
            .filter(|node| node.attribute("class").is_some_and(|class| class.starts_with("box")))
            .collect();
        assert_eq!(boxes.len(), nodes);
        for pair in boxes.windows(2) {
            assert!(number(pair[0], "x") + number(pair[0], "width") < number(pair[1], "x"), "{nodes}");
        }
        let last = boxes.last().unwrap();
        assert!(number(*last, "x") + number(*last, "width") < number(root, "width"));
        let arrows: Vec<&str> = root
            .descendants()
            .filter(|node| matches!(node.attribute("class"), Some("pdo" | "other")))
            .map(|node| node.attribute("d").unwrap())
            .collect();
        let rows: BTreeSet<&str> = arrows.iter().map(|path| path.split(['H', ' ']).nth(1).unwrap()).collect();
        assert_eq!(rows.len(), arrows.len(), "a row for each message");
        let pdos = overview.links.len();
        assert!(pdos >= nodes - 1 && arrows.len() > pdos, "{nodes}: {pdos}");
        let is_active = |node: Node<'_, '_>| {
            node.tag_name().name() == "script"
                || node.attributes().any(|a| a.name().starts_with("on") || a.name() == "href")
        };
        assert!(!root.descendants().any(is_active), "no scripts, no links");
        assert!(svg.contains("a &#60;b&#62; &#38; &#34;c&#34;"), "{}", &svg[..300]);
    }
}

#[test]
fn a_graph_for_graphviz_has_an_arrow_for_each_receiver() {
    let mut overview = overview(3, "line");
    let dot = graph::dot(&overview);
    let arrows = |label: &str| dot.lines().filter(|line| line.contains(label)).count();
    assert_eq!((arrows("000h NMT"), arrows("TPDO 1")), (2, 2), "{dot}");
    overview.nodes[1].name = "say \"hi\" \\ \n".to_owned();
    let dot = graph::dot(&overview);
    let lines: Vec<&str> = dot.lines().collect();
    assert_eq!((lines[0], *lines.last().unwrap()), ("digraph network {", "}"));
    assert!(dot.contains(r#"n1 [label="2 say \"hi\" \\ "#), "{dot}");
    for line in &lines[1..lines.len() - 1] {
        let escaped = line.replace(r"\\", "").replace(r#"\""#, "");
        assert!(
            line.starts_with("  ") && line.ends_with(';') && escaped.matches('"').count() % 2 == 0,
            "{line}"
        );
    }
}

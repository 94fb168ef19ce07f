//! Networks: an index with all that is known of the network, and a page for each node.

use std::fs;

use objdict::document::{Finding, Form, Options, Site, SiteFile, SiteNetwork, Subject};
use objdict::format::network::NetworkFile;
use objdict::format::{self, Format};
use objdict::network::{DcfgenMode, TimingOptions};
use objdict::report::Location;
use objdict::source::SourceFile;

use super::{german, read, without_style};
use crate::network::{new_folder, open, path};
use crate::support;

/// The site of a network: the pages of its nodes, then the index and what is beside it.
fn site(file: &NetworkFile, form: Form, options: &Options) -> Vec<SiteFile> {
    let mut site = Site::new(form, options);
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let mut pages = vec![None; file.network().unwrap().nodes.len()];
    let mut files = Vec::new();
    for (position, dcf) in build.each_dcf() {
        // a name with a line end is not that of a DCF
        let Ok(dcf) = dcf else { continue };
        let source = SourceFile::from_bytes(&dcf.name, dcf.bytes, &Default::default()).unwrap();
        let description = format::read(source, Format::Dcf);
        let (device, identifiers) = (description.device(), Default::default());
        let page = site.add(&Subject {
            device,
            file: &dcf.name,
            format: "DCF",
            findings: None,
            identifiers: &identifiers,
        });
        pages[position] = Some(page.name.clone());
        files.push(page);
    }
    let line = |finding| Location::line_of(file.into(), finding);
    let findings = file.check().iter().map(|finding| Finding::new(finding, line(finding))).collect();
    let overview = build.overview(options.language.as_deref().unwrap_or("en"));
    let timing = build.timing(&TimingOptions::default(), overview.language);
    site.add_network(SiteNetwork {
        overview,
        timing,
        file: Some("plant.toml".to_owned()),
        pages,
        findings: Some(findings),
    });
    files.extend(site.index());
    files
}

fn named<'a>(files: &'a [SiteFile], name: &str) -> &'a str {
    let names: Vec<&str> = files.iter().map(|file| &*file.name).collect();
    &files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("{name} is not in {names:?}")).text
}

#[test]
fn the_network_of_chapter_4_looks_like_this() {
    let file = open("chapter4.toml");
    let html = site(&file, Form::Html, &Options::default());
    let (before, objects) =
        named(&html, "index.html").split_once("<section aria-labelledby=\"all-title\">").unwrap();
    insta::assert_snapshot!("network.html", without_style(&format!("{before}<script></script>")));
    assert!(objects.contains("left.html#6000sub1"));
    let markdown = site(&file, Form::Markdown, &german());
    insta::assert_snapshot!("network.md", named(&markdown, "index.md"));
    assert!(named(&markdown, "network-1.svg").starts_with("<svg "));
    for form in Form::ALL {
        let files = site(&file, form, &german());
        let (left, index) = (format!("left.{}", form.extension()), format!("index.{}", form.extension()));
        assert!(named(&files, &index).contains(&left), "the index leads to {left}");
        assert!(form == Form::Csv || named(&files, &left).contains(&index), "{left} leads back");
    }
}

/// What is wrong in the network is on its page, and who sends a CAN-ID that another node sends too.
#[test]
fn findings_of_a_network_are_on_its_page() {
    let bad = support::fixtures().join("rules/network/duplicate-can-id/bad.yml");
    let file = NetworkFile::open(&bad, &Default::default()).unwrap();
    for (form, mark) in [(Form::Html, "sent by several nodes"), (Form::Markdown, "**sent by several nodes**")]
    {
        let files = site(&file, form, &Options::default());
        let index = named(&files, &format!("index.{}", form.extension()));
        assert!(index.contains("network/duplicate-can-id") && index.contains("line "), "{index}");
        assert_eq!(index.matches(mark).count(), 2);
    }
}

/// A row for each entry of each link and for each message, under columns that stay.
#[test]
fn networks_have_tables() {
    let files = site(&open("chapter4.toml"), Form::Csv, &Options::default());
    let links = read::csv(named(&files, "links.csv"));
    let columns =
        "network,can_id,sender,sender_pdo,receiver,receiver_pdo,bit,bits,from,from_name,to,to_name,too_short";
    assert_eq!(links[0].join(","), columns);
    assert_eq!(
        links[2][1..11].join(" "),
        "0x18B left TPDO 1 plc RPDO 1 8 8 0x6000:02 Digital inputs / Digital inputs2 0x5200:02"
    );
    let messages = read::csv(named(&files, "messages.csv"));
    assert_eq!(messages[0].join(","), "network,can_id,senders,receivers,bytes,trigger,period_us");
    assert_eq!((links.len(), messages.len()), (23, 31));
    assert!(links.iter().all(|line| line.len() == links[0].len()));
    assert_eq!(messages[7].join("|"), "chapter 4|0x18B|TPDO 1 of left|RPDO 1 of plc|5|sync/1|33000");
}

/// What `sdo:` says of a drive is in all forms, in its order and after what the other keys make; each entry leads to its object.
#[test]
fn downloads_are_on_the_pages_in_order() {
    let file = open("cell.yml");
    for (form, name) in [(Form::Html, "html"), (Form::Markdown, "md")] {
        let files = site(&file, form, &Options::default());
        let (index, left) = (named(&files, &format!("index.{name}")), named(&files, &format!("left.{name}")));
        for (page, prefix) in [(index, format!("left.{name}")), (left, String::new())] {
            let link = |entry: &str| match form {
                Form::Html => format!("href=\"{prefix}#{entry}\""),
                _ => format!("]({prefix}#{entry})"),
            };
            let downloads = page.split("Downloads").last().unwrap();
            // the links of single entries lead to their objects
            let entries = ["1017", "1400sub1", "1803sub1", "6060", "6083"];
            let mut rest = downloads;
            for entry in entries {
                let found = rest.find(link(entry).trim_end_matches(['"', ')']));
                rest = &rest[found.unwrap_or_else(|| panic!("{form:?}: no {entry} in {rest}"))..];
            }
        }
    }
    let files = site(&file, Form::Csv, &Options::default());
    let downloads = read::csv(named(&files, "downloads.csv"));
    assert_eq!(downloads[0].join(","), "network,node_id,node,number,entry,name,value");
    let left: Vec<_> = downloads.iter().filter(|line| line[2] == "left").collect();
    let last: Vec<String> = left[left.len() - 2..].iter().map(|line| line[3..].join("|")).collect();
    assert_eq!(last, ["33|0x6060|Modes of operation|-3", "34|0x6083|Profile acceleration|2000"]);
    let table = read::csv(named(&files, "left.csv"));
    let column = table[0].iter().position(|name| name == "downloads").unwrap();
    let of = |index: &str, sub: &str| {
        table.iter().find(|line| line[0] == index && line[1] == sub).map(|line| &*line[column])
    };
    assert_eq!(of("0x6083", "0x00"), Some("34 = 2000"));
    assert_eq!(of("0x1400", "0x01"), Some("3 = 2147484171; 9 = 523"));
}

/// Names of networks, nodes and entries come out as themselves.
#[test]
fn hostile_names_of_networks_stay_texts() {
    const NAMES: [&str; 6] = [
        "<script>alert(1)</script> t1",
        "\"><svg onload=alert(1)> t2",
        "</style></title> | ]]( `code` t3",
        "[link](javascript:alert(1)) ![picture](x) t4",
        "=cmd|'/c calc'!A1 &amp; @user t5",
        "two\nlines \u{202e} t6",
    ];
    let quoted = |name: &str| serde_json::Value::from(name).to_string();
    let folder = new_folder("hostile-network");
    let island = fs::read_to_string(path("island.eds")).unwrap();
    let island = island.replace("I/O island", NAMES[3]).replace("=Digital inputs", &format!("={}", NAMES[4]));
    fs::write(folder.join("island.eds"), island).unwrap();
    let text = format!(
        "[bus]\nname = {}\nmanager = 'one'\n[node.one]\nfile = 'island.eds'\nid = 1\n[node.{}]\nfile = 'island.eds'\nid = 2\n\
         [[link]]\nfrom = {}\nto = 'one.6200:1'\n[node.{}]\nfile = 'island.eds'\nid = 2\n",
        quoted(NAMES[0]),
        quoted(NAMES[1]),
        quoted(&format!("{}.6000:1", NAMES[1])),
        quoted(NAMES[2]),
    );
    fs::write(
        folder.join("network.toml"),
        text + "[node.\"two\\nlines \\u202e t6\"]\nfile = 'island.eds'\nid = 3\n",
    )
    .unwrap();
    let file = NetworkFile::open(&folder.join("network.toml"), &Default::default()).unwrap();
    let html = read::html(named(&site(&file, Form::Html, &Options::default()), "index.html"));
    let markdown = read::markdown(named(&site(&file, Form::Markdown, &Options::default()), "index.md"));
    for name in NAMES {
        let seen = name.replace('\u{202e}', "\u{FFFD}");
        assert!(html.contains(&seen), "{name}: {html}");
        assert!(markdown.contains(&seen), "{name}: {markdown}");
    }
    let files = site(&file, Form::Csv, &Options::default());
    for field in ["links.csv", "messages.csv", "downloads.csv"]
        .into_iter()
        .flat_map(|name| read::csv(named(&files, name)).concat())
    {
        let is_formula =
            field.parse::<f64>().is_err() && field.trim_start().starts_with(['=', '+', '-', '@']);
        assert!(!is_formula, "{field:?}");
    }
}

//! Documentation in its three forms: what it looks like, and that every text of a description comes out of it as that text.
mod network;
mod read;

use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use objdict::document::{self, CodeName, Finding, Form, Identifiers, Options, Site, Subject};
use objdict::format::Description;
use objdict::generate;
use objdict::model::{Device, Value};
use objdict::report::{Location, grouped};

fn open(path: &str) -> Description {
    objdict::format::open(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(path),
        &Default::default(),
    )
    .unwrap()
}

/// The documentation of a fixture.
fn unchecked(path: &str, form: Form, options: &Options) -> String {
    let description = open(path);
    let (device, format) = (description.device(), description.format().name());
    let subject = Subject { device, file: path, format, findings: None, identifiers: &Default::default() };
    document::write(&subject, form, options)
}

/// The documentation of a fixture with what `check` finds in it.
fn page(path: &str, form: Form, options: &Options) -> String {
    let description = open(path);
    let findings = grouped(&description, objdict::check_with(&description, &Default::default()));
    let findings: Vec<Finding> = findings
        .iter()
        .map(|finding| Finding::new(finding, Location::line_of((&description).into(), finding)))
        .collect();
    let subject = Subject {
        device: description.device(),
        file: Path::new(path).file_name().unwrap().to_str().unwrap(),
        format: description.format().name(),
        findings: Some(&findings),
        identifiers: &identifiers(description.device()),
    };
    document::write(&subject, form, options)
}

/// What code that is generated with defaults calls its entries.
fn identifiers(device: &Device) -> Identifiers {
    let names = generate::identifiers(device).unwrap_or_default();
    names.into_iter().map(|of| ((of.index, of.sub), CodeName { rust: of.rust, c: of.c })).collect()
}

fn german() -> Options {
    Options { language: Some("de".to_owned()), ..Options::default() }
}

#[test]
fn pages_look_like_this() {
    for (path, options) in [
        ("eds/io-401.eds", Options::default()),
        ("dcf/drive-402-node8.dcf", Options::default()),
        ("xdd/press-402.xdd", german()),
    ] {
        let name = Path::new(path).file_name().unwrap().to_str().unwrap();
        insta::assert_snapshot!(format!("{name}.html"), without_style(&page(path, Form::Html, &options)));
        insta::assert_snapshot!(format!("{name}.md"), page(path, Form::Markdown, &options));
        insta::assert_snapshot!(format!("{name}.csv"), page(path, Form::Csv, &options).replace('\r', ""));
    }
}

/// A page without its style and script, which are looked at in a browser.
fn without_style(page: &str) -> String {
    let mut rest = page.to_owned();
    for element in ["style", "script"] {
        let (start, end) = (format!("<{element}>"), format!("</{element}>"));
        let (before, after) = rest.split_once(&start).unwrap();
        rest = format!("{before}{start}{end}{}", after.split_once(&end).unwrap().1);
    }
    rest
}

/// The texts of a device that tries to leave its places: each ends with a number of its own.
fn hostile_texts(device: &Device) -> BTreeSet<String> {
    fn collect(value: &serde_json::Value, texts: &mut BTreeSet<String>) {
        match value {
            serde_json::Value::String(text) => {
                let number = text.split('\r').next().unwrap().rsplit_once(" t").map(|(_, number)| number);
                if number.is_some_and(|number| {
                    !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
                }) {
                    texts.insert(text.clone());
                }
            }
            serde_json::Value::Array(values) => values.iter().for_each(|value| collect(value, texts)),
            serde_json::Value::Object(fields) => fields.values().for_each(|value| collect(value, texts)),
            _ => {}
        }
    }
    let mut texts = BTreeSet::new();
    collect(&serde_json::to_value(device).unwrap(), &mut texts);
    texts
}

/// A text as readers see it: what steers a terminal or the direction of a text is U+FFFD.
fn seen(text: &str) -> String {
    let is_seen = |c: char| {
        c == '\n'
            || !(c.is_control()
                || ('\u{202A}'..='\u{202E}').contains(&c)
                || ('\u{2066}'..='\u{2069}').contains(&c))
    };
    text.replace("\r\n", "\n").chars().map(|c| if is_seen(c) { c } else { '\u{FFFD}' }).collect()
}

/// Every text comes out as itself: in HTML and Markdown the same ones; in CSV those of entries.
#[test]
fn hostile_texts_stay_texts() {
    for (path, shown_at_least) in [("document/hostile.dcf", 55), ("document/hostile.xdd", 45)] {
        let description = open(path);
        let texts = hostile_texts(description.device());
        let html = read::html(&page(path, Form::Html, &Options::default()));
        let markdown = read::markdown(&page(path, Form::Markdown, &Options::default()));
        let csv = read::csv(&page(path, Form::Csv, &Options::default()));
        let shown = |page: &str| -> BTreeSet<&String> {
            texts.iter().filter(|text| page.contains(&seen(text))).collect()
        };
        let (in_html, in_markdown) = (shown(&html), shown(&markdown));
        assert_eq!(in_html, in_markdown, "{path}");
        assert!(in_html.len() >= shown_at_least, "{path}: {} of {texts:#?}", in_html.len());

        let fields: Vec<String> = csv.concat().iter().map(|field| field.replace('\'', "")).collect();
        let in_field = |text: &String| {
            let text = seen(text).replace('\'', "").replace('\n', " ");
            fields.iter().any(|field| field.contains(&text))
        };
        let names: Vec<String> =
            description.device().objects.values().map(|object| object.name().to_owned()).collect();
        assert!(names.iter().filter(|name| texts.contains(*name)).all(in_field), "{path}");
        assert!(csv.iter().all(|line| line.len() == csv[0].len()), "{path}");
    }
}

/// No field of a table is a formula, wherever a spreadsheet thinks that it begins.
#[test]
fn spreadsheets_compute_nothing() {
    for path in
        ["document/hostile.dcf", "document/hostile.xdd", "eds/hostile.eds", "broken/hostile-unicode.eds"]
    {
        for field in read::csv(&page(path, Form::Csv, &Options::default())).concat() {
            for part in field.split(';') {
                let is_number = part.parse::<f64>().is_ok();
                assert!(
                    is_number || !part.trim_start().starts_with(['=', '+', '-', '@']),
                    "{path}: {field:?}"
                );
            }
        }
    }
}

/// The same lines and fields come out of Python's reader.
#[test]
fn python_reads_the_tables() {
    const SCRIPT: &str = "import csv, io, json, sys\n\
        text = io.TextIOWrapper(sys.stdin.buffer, encoding='utf-8-sig', newline='')\n\
        print(json.dumps(list(csv.reader(text, strict=True))))";
    if !crate::support::skips::has("python3", "python3") {
        return;
    }
    for path in
        ["document/hostile.dcf", "document/hostile.xdd", "xdd/press-402.xdd", "dcf/drive-402-node8.dcf"]
    {
        let table = unchecked(path, Form::Csv, &german());
        let python =
            Command::new("python3").args(["-c", SCRIPT]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut python = python.unwrap();
        python.stdin.take().unwrap().write_all(table.as_bytes()).unwrap();
        let lines: Vec<Vec<String>> =
            serde_json::from_slice(&python.wait_with_output().unwrap().stdout).unwrap();
        assert_eq!(lines, read::csv(&table), "{path}");
    }
}

/// A text that is not valid for its field has a column of its own, and none among the values.
#[test]
fn values_that_cannot_be_read_have_a_column() {
    let table = read::csv(&page("broken/c-suffix-numbers.eds", Form::Csv, &Options::default()));
    let of = |column: &str| {
        let at = table[0].iter().position(|name| name == column).unwrap();
        table[1..].iter().map(|line| &*line[at]).filter(|text| !text.is_empty()).collect::<Vec<_>>()
    };
    let invalid = of("invalid_values");
    assert!(invalid.iter().any(|text| text.starts_with("DefaultValue = ")), "{invalid:?}");
    assert!(of("default").iter().all(|text| !text.contains('`')), "{:?}", of("default"));
}

/// The columns are a promise: they may grow at the end.
#[test]
fn columns_stay() {
    let table = unchecked("eds/io-401.eds", Form::Csv, &german());
    let header = table.lines().next().unwrap().trim_start_matches('\u{FEFF}');
    let promised = "index,sub,object_name,name,object_type,data_type,bits,access,pdo,default,value,changed,low_limit,\
        high_limit,unit,meaning,denotation,description,object_description,name_in_file,object_name_in_file,default_formula,value_formula,mapped_in,\
        named_values,bit_fields,groups,facts,keys,object_facts,object_keys,links,invalid_values";
    assert!(header.starts_with(promised), "{header}");
}

/// Every entry of a device is in every form.
#[test]
fn nothing_is_left_out() {
    for path in ["eds/all-types.eds", "eds/compact.eds", "dcf/manager-302-node1.dcf", "xdd/drive-402.xdd"] {
        let description = open(path);
        let objects = &description.device().objects;
        let count: usize = objects.values().map(|object| object.entries().count().max(1)).sum();
        assert_eq!(read::csv(&page(path, Form::Csv, &Options::default())).len(), count + 1, "{path}");
        let (html, markdown) =
            (unchecked(path, Form::Html, &german()), unchecked(path, Form::Markdown, &german()));
        for (index, object) in objects {
            for anchor in object.entries().map(|(sub, _)| format!("id=\"{index:04X}sub{sub:X}\"")) {
                assert!(html.contains(&anchor), "{path}: {anchor}");
                assert!(markdown.contains(&anchor), "{path}: {anchor}");
            }
        }
    }
}

#[test]
fn several_devices_make_a_site() {
    let files =
        ["dcf/io-401-node5.dcf", "dcf/drive-402-node8.dcf", "document/hostile.dcf", "xdd/press-402.xdd"];
    for form in Form::ALL {
        let mut site = Site::new(form, &Options { title: Some("Line <1>".to_owned()), ..Options::default() });
        for path in files {
            let description = open(path);
            let file = Path::new(path).file_name().unwrap().to_str().unwrap();
            let format = description.format().name();
            let (device, identifiers) = (description.device(), Default::default());
            let page =
                site.add(&Subject { device, file, format, findings: Some(&[]), identifiers: &identifiers });
            assert_eq!(Path::new(&page.name).extension().unwrap().to_str().unwrap(), form.extension());
        }
        let files = site.index();
        let names: Vec<&str> = files.iter().map(|file| &*file.name).collect();
        let index = &files[0].text;
        match form {
            Form::Html => {
                assert_eq!(names, ["index.html"]);
                assert!(read::html(index).contains("Line <1>"));
            }
            Form::Markdown => {
                assert_eq!(names, ["index.md", "network-1.svg", "network-1-timeline.svg"]);
                insta::assert_snapshot!("index.md", index);
            }
            Form::Csv => {
                assert_eq!(names, ["index.csv", "links.csv", "messages.csv", "downloads.csv"]);
                insta::assert_snapshot!("index.csv", index.replace('\r', ""));
            }
        }
    }
}

/// A page links to a workbench where there is one, and only there.
#[test]
fn pages_lead_to_the_workbench_that_is_stated() {
    let address = "https://example.com/workbench/?a=1&b=2";
    let links = [
        (Form::Html, "<a href=\"https://example.com/workbench/?a=1&amp;b=2\">Werkbank öffnen</a>"),
        (Form::Markdown, "[Werkbank öffnen](<https://example.com/workbench/?a=1&b=2>)"),
    ];
    for (form, link) in links {
        let stated = Options { workbench: Some(address.to_owned()), ..german() };
        let page = unchecked("eds/drive-402.eds", form, &stated);
        assert!(page.contains(link) && page.contains("und dort diese Datei wählen: eds/drive"), "{page}");
        assert!(!unchecked("eds/drive-402.eds", form, &german()).contains("Werkbank"));
    }
}

/// A number in 1000h that no document of CiA has, in all forms, and on the index.
#[test]
fn a_profile_number_is_not_a_document() {
    let mut device = open("eds/drive-402.eds").device().clone();
    device.objects.get_mut(&0x1000).unwrap().main.default = Some(Value::Unsigned(0x0100));
    let subject = Subject {
        device: &device,
        file: "servo.eds",
        format: "EDS",
        findings: None,
        identifiers: &Default::default(),
    };
    for form in Form::ALL {
        let mut site = Site::new(form, &Options::default());
        let page = site.add(&subject).text;
        let index = site.index().swap_remove(0).text;
        for text in [page, index] {
            assert!(text.contains("profile number 256 (not a CiA profile)"), "{form:?}: {text}");
            assert!(!text.contains("CiA 256"), "{form:?}");
        }
    }
}

/// Findings of one cause are one, as `check` shows them; each of their places is a link.
#[test]
fn findings_of_one_cause_are_joined() {
    let html = page("broken/c-suffix-numbers.eds", Form::Html, &Options::default());
    let markdown = page("broken/c-suffix-numbers.eds", Form::Markdown, &Options::default());
    let (in_html, in_markdown) =
        (html.split_once("id=\"findings\"").unwrap().1, markdown.split_once("id=\"findings\"").unwrap().1);
    assert!(
        in_html.contains("more like this") && in_html.contains("<small>also at <a href=\"#"),
        "{in_html}"
    );
    assert!(in_markdown.contains("<br>also at [0x"), "{in_markdown}");
}

/// What bold means, and where the PDOs are that carry an entry.
#[test]
fn changed_values_have_a_legend_and_pdos_are_linked() {
    let words = "Values in bold are configured and differ from the default.";
    let dcf = page("dcf/drive-402-node8.dcf", Form::Html, &Options::default());
    assert_eq!(dcf.matches(words).count(), 2);
    assert!(dcf.contains("<dd><a href=\"#rpdo1\">RPDO 1</a></dd>"), "6040h is mapped in RPDO 1");
    assert!(dcf.contains("<code>x01x 0111</code> operation enabled"), "states are masks");
    let markdown = page("dcf/drive-402-node8.dcf", Form::Markdown, &Options::default());
    assert_eq!(markdown.matches(words).count(), 2);
    assert!(markdown.contains("[RPDO 1](#rpdo1)") && markdown.contains("`x01x 0111` operation enabled"));
    assert!(!page("eds/drive-402.eds", Form::Html, &Options::default()).contains(words));
}

/// The states, commands and transitions of CiA 402 and the codes of its EMCY are on the page of a drive, and of no other device.
#[test]
fn a_drive_has_its_state_machine_and_error_codes() {
    let html = page("eds/drive-402.eds", Form::Html, &Options::default());
    let markdown = page("eds/drive-402.eds", Form::Markdown, &Options::default());
    for row in [
        "<tr><td>x01x 0001</td><td>ready to switch on</td></tr>",
        "<tr><td>0xxx x110</td><td>shutdown</td></tr>",
        "<tr><td>2</td><td>switch on disabled</td><td>ready to switch on</td><td>shutdown</td></tr>",
        "<code>0x8611</code><span>following error</span>",
        "<code>0x8130</code><span>heartbeat or guarding lost</span>",
    ] {
        assert!(html.contains(row), "{row}");
    }
    for row in ["| `0xxx x110` | shutdown |", "| 0x8611 | following error |", "[0x6041](#6041)"] {
        assert!(markdown.contains(row), "{row}");
    }
    let io = page("eds/io-401.eds", Form::Html, &Options::default());
    assert!(!io.contains("id=\"states\"") && !io.contains("id=\"error-codes\""));
}

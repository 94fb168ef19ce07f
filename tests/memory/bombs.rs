//! Files that are made to take much more memory or time than their size.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// A file of any size.
pub(crate) struct Bomb {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    /// Its text of about so many bytes.
    pub(crate) text: Box<dyn Fn(usize) -> String>,
}

/// What is done with a file.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    File,
    Network,
}

/// A text of about so many bytes between two others: lines with their numbers.
fn repeated(start: &str, line: impl Fn(usize) -> String, end: &str, bytes: usize) -> String {
    let mut text = start.to_owned();
    for number in 0.. {
        if text.len() - start.len() >= bytes {
            break;
        }
        text.push_str(&line(number));
    }
    text + end
}

/// Where the fixtures are.
pub(crate) fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures")
}

fn fixture(path: &str) -> String {
    fs::read_to_string(fixtures().join(path)).unwrap()
}

type Lines = fn(usize) -> String;

pub(crate) fn all() -> Vec<Bomb> {
    [eds(), elements(), parameters(), others(), networks()].into_iter().flatten().collect()
}

fn bomb(name: &'static str, kind: Kind, text: impl Fn(usize) -> String + 'static) -> Bomb {
    Bomb { name, kind, text: Box::new(text) }
}

/// The index of an object that belongs to a number, and its sub-index.
fn index(number: usize) -> usize {
    0x2000 + number % 0x7FFF
}

fn sub(number: usize) -> String {
    format!("[{:X}sub{:X}]\n", 0x2000 + number / 255 % 0x7FFF, number % 255)
}

/// Records as real devices have them.
fn ordinary(number: usize) -> String {
    let (index, sub) = (0x2000 + number / 254 % 0x7FFF, number % 254);
    let record = format!("[{index:X}]\nParameterName=Record {index:X}\nObjectType=0x9\nSubNumber=254\n");
    let start = if sub == 0 { record } else { String::new() };
    start
        + &format!(
            "[{index:X}sub{sub:X}]\nParameterName=Parameter {sub}\nObjectType=0x7\nDataType=0x0007\nAccessType=rw\nDefaultValue=0x10\nPDOMapping=0\n"
        )
}

/// Lines of EDS and DCF, behind a small device.
fn eds() -> Vec<Bomb> {
    const OBJECT: &str = "[2000]\nParameterName=x\nDataType=5\nAccessType=rw\n";
    let lines: [(&str, &'static str, Lines); 29] = [
        ("ordinary.eds", "", ordinary),
        ("junk.eds", "", |_| "x\n".to_owned()),
        ("blank.eds", "", |_| "\n".to_owned()),
        ("brackets.eds", "", |_| "[]\n".to_owned()),
        ("openings.eds", "", |_| "[".to_owned()),
        ("sections.eds", "", |number| format!("[a{number}]\n")),
        ("sections-with-key.eds", "", |number| format!("[section{number}]\nKey=value\n")),
        ("unclosed-headers.eds", "", |number| format!("[Section{number:X}\n")),
        ("same-section.eds", "", |_| "[2000]\nParameterName=x\n".to_owned()),
        ("long.eds", "[1008]\nParameterName=n\nDataType=9\nDefaultValue=", |_| "x".repeat(1000)),
        ("comments.eds", "[Comments]\n", |number| format!("Line{number}=\n")),
        ("unknown-keys.eds", OBJECT, |number| format!("k{number:x}=1\n")),
        ("same-key.eds", OBJECT, |_| "DataType=5\n".to_owned()),
        ("list.eds", "[OptionalObjects]\n", |number| format!("{number}=0x1000\n")),
        ("list-backwards.eds", "[OptionalObjects]\n", |number| format!("{}=0x1000\n", 9_999_999 - number)),
        ("objects.eds", "", |number| format!("[{:X}]\n", index(number))),
        ("links.eds", "", |number| format!("[{:X}ObjectLinks]\n1=0x1000\n", index(number))),
        ("subs.eds", "", sub),
        ("small-subs.eds", "", |number| sub(number) + "DataType=5\n"),
        ("full-subs.eds", "", |number| sub(number) + "ParameterName=a\nDataType=5\nAccessType=rw\n"),
        ("invalid-subs.eds", "", |number| {
            sub(number)
                + "DataType=x\nPDOMapping=x\nAccessType=x\nObjectType=x\nLowLimit=x\nHighLimit=x\nDefaultValue=x\n"
        }),
        ("compact.eds", "", |number| {
            format!(
                "[{:X}]\nParameterName=a\nObjectType=8\nDataType=5\nAccessType=rw\nCompactSubObj=254\n",
                index(number)
            )
        }),
        ("compact-values.eds", "[2000]\nCompactSubObj=254\nDataType=5\n[2000Value]\n", |number| {
            format!("{number}=1\n")
        }),
        ("modules.eds", "", |number| format!("[M{number}ModuleInfo]\n[M{number}Comments]\n")),
        ("module-objects.eds", "", |number| {
            format!("[M{number}FixedObjects]\n1=0x2000\n[M{number}Fixed2000]\nParameterName=a\n")
        }),
        ("denotations.dcf", "", |number| format!("[{:X}Denotation]\n1=a\n", index(number))),
        ("values.dcf", "", |number| sub(number) + "DataType=7\nParameterValue=1\n"),
        ("downloads.dcf", "", |number| sub(number) + "DataType=0xF\nDownloadFile=a\n"),
        ("connected.dcf", "[ConnectedModules]\n", |number| format!("{number}=1\n")),
    ];
    let of = |(name, start, line): (&'static str, &'static str, Lines)| {
        bomb(name, Kind::File, move |bytes| {
            let device =
                fixture(if name.ends_with("dcf") { "dcf/drive-402-node8.dcf" } else { "eds/minimal.eds" });
            repeated(&format!("{device}\n{start}"), line, "\n", bytes)
        })
    };
    lines.into_iter().map(of).collect()
}

/// The text of an XDD up to the end of an element, and behind that.
fn around(path: &str, end: &str) -> (String, String) {
    let text = fixture(path);
    let at = text.find(end).unwrap();
    (text[..at].to_owned(), text[at..].to_owned())
}

/// Elements of an object list.
fn elements() -> Vec<Bomb> {
    let lines: [(&str, &'static str, Lines, &'static str); 14] = [
        ("objects.xdd", "", |_| "<CANopenObject/>".to_owned(), ""),
        ("qualified-objects.xdd", "", |_| "<q2:CANopenObject/>".to_owned(), ""),
        (
            "subs.xdd",
            "<CANopenObject index=\"2000\" objectType=\"9\" name=\"a\">",
            |_| "<CANopenSubObject/>".to_owned(),
            "</CANopenObject>",
        ),
        (
            "full-objects.xdd",
            "",
            |number| {
                format!(
                    "<CANopenObject index=\"{:04X}\" name=\"o\" objectType=\"7\" dataType=\"0005\" accessType=\"rw\"/>\n",
                    index(number)
                )
            },
            "",
        ),
        (
            "values.xdc",
            "",
            |number| {
                format!(
                    "<CANopenObject index=\"{:04X}\" name=\"o\" objectType=\"7\" dataType=\"0005\" accessType=\"rw\" actualValue=\"1\"/>\n",
                    index(number)
                )
            },
            "",
        ),
        (
            "same-object.xdd",
            "",
            |_| "<CANopenObject index=\"2000\" name=\"a\" objectType=\"7\"/>\n".to_owned(),
            "",
        ),
        (
            "invalid-objects.xdd",
            "",
            |_| {
                "<CANopenObject index=\"x\" dataType=\"x\" accessType=\"x\" PDOmapping=\"x\" objectType=\"x\" lowLimit=\"x\" highLimit=\"x\" defaultValue=\"x\"/>".to_owned()
            },
            "",
        ),
        ("unknown.xdd", "", |_| "<zz/>".to_owned(), ""),
        ("deep.xdd", "", |_| "<a>".to_owned(), ""),
        ("attributes.xdd", "<a ", |number| format!("a{number:x}=\"\" "), "/>"),
        ("same-attribute.xdd", "<CANopenObject index=\"2000\" ", |_| "a=\"\" ".to_owned(), "/>"),
        ("comments.xdd", "", |_| "<!---->".to_owned(), ""),
        ("instructions.xdd", "", |_| "<?a?>".to_owned(), ""),
        ("references.xdd", "", |_| "&#65;".to_owned(), ""),
    ];
    let of = |(name, start, line, end): (&'static str, &'static str, Lines, &'static str)| {
        bomb(name, Kind::File, move |bytes| {
            let (before, behind) = around("xdd/valve.xdd", "</q2:CANopenObjectList>");
            repeated(&(before + start), line, &format!("{end}{behind}"), bytes)
        })
    };
    lines.into_iter().map(of).collect()
}

/// Elements of an application process.
fn parameters() -> Vec<Bomb> {
    const PARAMETERS: &str = "</q1:parameterList>";
    const TYPES: &str = "</q1:dataTypeList>";
    let lines: [(&str, &'static str, &'static str, Lines, &'static str); 6] = [
        ("parameters.xdd", PARAMETERS, "", |number| format!("<q1:parameter uniqueID=\"P{number}\"/>\n"), ""),
        ("empty-parameters.xdd", PARAMETERS, "", |_| "<q1:parameter/>".to_owned(), ""),
        (
            "labels.xdd",
            PARAMETERS,
            "<q1:parameter uniqueID=\"PP\">",
            |_| "<label lang=\"en\">a</label>".to_owned(),
            "</q1:parameter>",
        ),
        (
            "values.xdd",
            TYPES,
            "<q1:enum name=\"e\" uniqueID=\"EE\">",
            |_| "<q1:enumValue value=\"1\"/>".to_owned(),
            "</q1:enum>",
        ),
        ("structs.xdd", TYPES, "", |number| format!("<q1:struct name=\"e\" uniqueID=\"S{number}\"/>"), ""),
        (
            "variables.xdd",
            TYPES,
            "<q1:struct name=\"e\" uniqueID=\"SS\">",
            |number| format!("<q1:varDeclaration uniqueID=\"V{number}\"/>"),
            "</q1:struct>",
        ),
    ];
    let of =
        |(name, list, start, line, end): (&'static str, &'static str, &'static str, Lines, &'static str)| {
            bomb(name, Kind::File, move |bytes| {
                let (before, behind) = around("xdd/valve.xdd", list);
                repeated(&(before + start), line, &format!("{end}{behind}"), bytes)
            })
        };
    lines.into_iter().map(of).collect()
}

/// Other formats.
fn others() -> Vec<Bomb> {
    let json = |start: &'static str, line: Lines, end: &'static str| {
        move |bytes| {
            let start = format!("{{\"version\":1,\"kind\":\"device\",\"device\":{{{start}");
            repeated(&start, line, &format!("{end}}}}}"), bytes)
        }
    };
    vec![
        bomb("lists.json", Kind::File, |bytes| "[".repeat(bytes)),
        bomb(
            "comments.json",
            Kind::File,
            json("\"objects\":{},\"comments\":[", |_| "\"\",".to_owned(), "\"\"]"),
        ),
        bomb(
            "objects.json",
            Kind::File,
            json("\"objects\":{", |number| format!("\"0x{:04X}\":{{}},", index(number)), "\"0xA000\":{}}"),
        ),
        bomb("objects.toml", Kind::File, |bytes| {
            let line = |number| format!("{:04X}={{}} # as short as is read\n", number % 0xFFFF);
            repeated("format=\"objdict-device/1\"\n[object]\n", line, "", bytes)
        }),
        bomb("ranges.toml", Kind::File, |bytes| {
            let line =
                |number| format!("{:04X}.sub.0-FE={{}} # {:60}\n", number % 0xFFFF, "as short as is read");
            repeated("format=\"objdict-device/1\"\n[object]\n", line, "", bytes)
        }),
        bomb("raw.toml", Kind::File, |bytes| {
            repeated(
                "format=\"objdict-device/1\"\n[raw]\n\"/comments\"=[",
                |_| "\"\",".to_owned(),
                "]",
                bytes,
            )
        }),
        bomb("deep.toml", Kind::File, |bytes| {
            "format=\"objdict-device/1\"\nx=".to_owned() + &"[".repeat(bytes)
        }),
        bomb("junk.cdcf.txt", Kind::File, |bytes| repeated("", |_| "x\n".to_owned(), "", bytes)),
        bomb("downloads.cdcf.txt", Kind::File, |bytes| {
            let line = |number| format!("{:04X}:{:02X} UNSIGNED8 1\n", index(number), number % 250);
            repeated("", line, "", bytes)
        }),
        bomb("nodes.cpj", Kind::File, |bytes| {
            let line = |number| format!("Node{number}Present=1\n");
            repeated("[Topology]\nNodes=1\n", line, "", bytes)
        }),
        bomb("topologies.cpj", Kind::File, |bytes| {
            repeated("[Topology]\n", |number| format!("[Topology{number}]\n"), "", bytes)
        }),
    ]
}

/// A network of the containers of CANopenEditor.
fn containers(line: impl Fn(&str) -> String, bytes: usize) -> String {
    let device = fixture("nxdd/line.nxdd");
    let (start, end) = ("<ISO15745ProfileContainer", "</ISO15745ProfileContainer>");
    let (first, last) = (device.find(start).unwrap(), device.find(end).unwrap() + end.len());
    let container = line(&device[first..last]);
    repeated(&device[..first], |_| container.clone(), &device[first..], bytes)
}

fn networks() -> Vec<Bomb> {
    const BUS: &str = "[bus]\nname = \"x\"\nbit-rate = 250\n";
    let mut bombs = Vec::new();
    for (name, kind) in [("empty.nxdd", Kind::File), ("empty-network.nxdd", Kind::Network)] {
        bombs.push(bomb(name, kind, |bytes| containers(|_| "<ISO15745ProfileContainer/>".to_owned(), bytes)));
    }
    for (name, kind) in [("devices.nxdd", Kind::File), ("devices-network.nxdd", Kind::Network)] {
        bombs.push(bomb(name, kind, |bytes| containers(str::to_owned, bytes)));
    }
    bombs.push(bomb("nodes.toml", Kind::Network, |bytes| {
        let line = |number| format!("[node.a{number}]\nfile=\"m.eds\"\nid={}\n", number % 127 + 1);
        repeated(BUS, line, "", bytes)
    }));
    bombs.push(bomb("tables.toml", Kind::Network, |bytes| {
        repeated(BUS, |number| format!("[a{number}]\n"), "", bytes)
    }));
    bombs.push(bomb("links.toml", Kind::Network, |bytes| {
        repeated(BUS, |_| "[[link]]\n".to_owned(), "", bytes)
    }));
    bombs.push(bomb("nodes.yml", Kind::Network, |bytes| {
        let mut text = String::from("master: {node_id: 1}\n");
        for number in 0..bytes / 32 {
            let _ = writeln!(text, "n{number}: {{dcf: m.eds, node_id: {}}}", number % 127 + 1);
        }
        text
    }));
    bombs.push(bomb("list.yml", Kind::Network, |bytes| {
        repeated("master: {node_id: 1}\na: [", |_| "[],".to_owned(), "0]\n", bytes)
    }));
    bombs
}

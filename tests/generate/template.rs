//! Custom templates: renders the template of docs/targets/template.md, compiles it and runs it.

use std::path::Path;

use objdict::generate::{GenerateError, Generated, Options, Target, generate};
use objdict::model::Device;

use crate::compile::{c_compiler, cc};
use crate::devices::{device, devices, for_all};
use crate::oracle::{facts_of, hex};
use crate::processors::build;
use crate::support;

/// The template on the page.
fn example() -> String {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/targets/template.md");
    let page = std::fs::read_to_string(page).unwrap();
    let start = page.split("```jinja\n").nth(1).unwrap();
    start.split("```").next().unwrap().to_owned()
}

fn render(template: &Path, device: &Device) -> Result<Generated, GenerateError> {
    let mut options = Options::default();
    options.template = Some(template.to_owned());
    generate(device, Target::named("template")?, &options)
}

/// Renders a template for a small device.
fn rendered(name: &str, source: &str) -> Result<String, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, source).unwrap();
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    let generated = render(&path, &minimal).map_err(|error| error.to_string())?;
    Ok(String::from_utf8(generated.files[0].contents.clone()).unwrap())
}

/// Prints the rows in the format of the test.
const MAIN: &str = r#"#include <stdint.h>
#include <stdio.h>
typedef struct { uint16_t index; uint8_t sub; uint8_t plus_node_id; uint32_t length; const uint8_t *bytes; const char *name; } row_t;
extern const row_t rows[];
extern const uint32_t row_count;
int main(void)
{
    for (uint32_t at = 0; at < row_count; at++) {
        printf("%04X %02X ", rows[at].index, rows[at].sub);
        for (uint32_t byte = 0; byte < rows[at].length; byte++) {
            printf("%02X", rows[at].bytes[byte]);
        }
        printf("%s\n", rows[at].length == 0 ? "-" : "");
    }
    return 0;
}
"#;

#[test]
fn the_example_compiles_and_has_every_entry() {
    let Some(compiler) = c_compiler() else { return };
    for_all(&devices(), |(name, device)| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let folder = folder.path();
        let path = folder.join("table.c.j2");
        std::fs::write(&path, example()).map_err(|error| error.to_string())?;
        let generated = render(&path, device).map_err(|error| format!("{name}: {error}"))?;
        assert_eq!(generated.files[0].path, "table.c");
        std::fs::write(folder.join("table.c"), &generated.files[0].contents)
            .map_err(|error| error.to_string())?;
        std::fs::write(folder.join("main.c"), MAIN).map_err(|error| error.to_string())?;
        let mut cc = cc(&compiler, folder);
        cc.args(["-o", "run", "table.c", "main.c"]);
        let expected: String = facts_of(device)
            .map(|((index, sub), facts)| format!("{index:04X} {sub:02X} {}\n", hex(&facts.default_on(0))))
            .collect();
        build(&cc).expect(&[], &expected).map_err(|error| format!("{name}: {error}"))
    });
}

#[test]
fn the_device_is_that_of_the_json() {
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    let json: serde_json::Value =
        serde_json::from_str(&objdict::format::json::write_device(&minimal)).unwrap();
    let source = "{{ version }} {{ kind }}\n{% for index, object in device.objects|items %}\n{{ index|number }} {{ object.name }}\n{% endfor %}\n";
    let text = rendered("objects.txt.j2", source).unwrap();
    let mut expected = format!("{} {}\n", json["version"], json["kind"].as_str().unwrap());
    for (index, object) in json["device"]["objects"].as_object().unwrap() {
        let number = u16::from_str_radix(&index[2..], 16).unwrap();
        expected.push_str(&format!("{number} {}\n", object["name"].as_str().unwrap()));
    }
    assert_eq!(text, expected);
}

#[test]
fn what_is_nested_deep_has_a_stack() {
    let sum = format!("{{{{ 1{} }}}}", "+1".repeat(8_000));
    assert_eq!(rendered("my.j2", &sum).unwrap(), "8001");
    let branches = format!("{{% if 0 %}}{}{{% else %}}a{{% endif %}}", "{% elif 0 %}".repeat(1_000));
    assert_eq!(rendered("my.j2", &branches).unwrap(), "a");
    let lists = "{% set ns = namespace(a=[1]) %}{% for i in range(100000) %}{% set ns.a = [ns.a] %}{% endfor %}{{ ns.a }}";
    assert_eq!(rendered("my.j2", lists).unwrap().len(), 200_003);
}

#[test]
fn errors_name_file_and_line() {
    for (source, expected) in [
        ("a\n{% for %}\n", "my.j2:2: syntax error: "),
        ("a\n\n{{ devise.objects }}\n", "my.j2:3: undefined value"),
        ("{{ device|shout }}", "my.j2:1: unknown filter: "),
        ("\n{{ 'ten'|number }}", "my.j2:2: invalid operation: `ten` is not a number"),
        (
            "{% for a in range(9999) %}{% for b in range(9999) %}\n{{ a }}{% endfor %}{% endfor %}",
            "my.j2:2: engine ran out of fuel",
        ),
        (
            r#"{{ "%1000000000s"|format("x") }}"#,
            "my.j2:1: invalid operation: `format` would produce more than",
        ),
        (
            r#"{{ "%0*d"|format(500000000, 1) }}"#,
            "my.j2:1: invalid operation: `format` would produce more than",
        ),
        (
            r#"{{ "x"|indent(4000000000, true) }}"#,
            "my.j2:1: invalid operation: `indent` would produce more than",
        ),
        (
            r#"{{ "x"|indent(width=4000000000) }}"#,
            "my.j2:1: invalid operation: `indent` would produce more than",
        ),
        (r#"{{ ("x" * 10000)|replace("x", "y" * 10000) }}"#, "my.j2:1: invalid operation: `replace` would"),
        (
            r#"{{ range(100000)|join("x" * 1000000) }}"#,
            "my.j2:1: invalid operation: `join` would produce more than",
        ),
        (
            "{{ [1]|slice(100000000)|list|length }}",
            "my.j2:1: invalid operation: `slice` would produce more than",
        ),
        (
            "{{ [1]|batch(100000000, 0)|length }}",
            "my.j2:1: invalid operation: `batch` would produce more than",
        ),
        (&format!("{{{{ 1{} }}}}", "+1".repeat(30_000)), "my.j2: a tag has more than 16384 bytes"),
        (
            &format!("{{% if 0 %}}{}{{% endif %}}", "{% elif 0 %}".repeat(30_000)),
            "my.j2: there are more than 1000",
        ),
    ] {
        let error = rendered("my.j2", source).unwrap_err();
        assert!(error.starts_with(expected), "`{error}` where `{expected}` was expected");
    }
    assert!(rendered("my.c", "").unwrap_err().starts_with("my.c: name the template after its output"));
    assert!(rendered(".j2", "").unwrap_err().starts_with(".j2: name the template after its output"));
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    let missing = render(Path::new("no/such.j2"), &minimal).unwrap_err().to_string();
    assert!(missing.starts_with("such.j2: cannot read `no/such.j2`: "), "{missing}");
    let none = generate(&minimal, Target::named("template").unwrap(), &Options::default()).unwrap_err();
    assert!(matches!(none, GenerateError::NoTemplate));
}

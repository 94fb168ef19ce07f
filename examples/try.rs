//! try
use std::path::Path;
fn main() {
    for f in std::env::args().skip(1) {
        let d = objdict::format::open(Path::new(&f), &Default::default()).unwrap();
        let bytes = std::fs::read(&f).unwrap();
        assert_eq!(d.document().print(), bytes, "{f}");
        let findings = objdict::check(&d);
        for x in &findings {
            let at = d.source().line_column(d.span_of(&x.labels[0].at).start);
            println!("{f}:{}:{}: {} {} {}", at.line, at.column, x.severity, x.rule.id, x.message);
        }
    }
}

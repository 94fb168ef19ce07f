//! The pictures of a terminal in README.md: what the commands print, with their colours. `OBJDICT_PICTURES=write` draws them anew.

use std::path::Path;
use std::process::Command;

use anstyle_svg::Term;

fn drawn(line: &str, columns: u16) -> String {
    let mut command = Command::new(crate::program());
    let output = command.args(line.split(' ')).args(["--color", "always"]).output().unwrap();
    let printed = String::from_utf8(output.stdout).unwrap();
    let text = format!("\u{1B}[1m$ objdict {line}\u{1B}[0m\n{printed}");
    Term::new().min_width_px(usize::from(columns) * 8).render_svg(&text)
}

#[test]
fn the_pictures_of_the_readme_are_what_is_printed() {
    let readme = std::fs::read_to_string("README.md").unwrap();
    for (name, line) in [
        ("check.svg", "check fixtures/torture/20_pdo_map_wrong_len.eds fixtures/torture/09_rev_nodeid.eds"),
        ("boot.svg", "network boot fixtures/network/chapter4.toml --summary"),
    ] {
        let (path, picture) = (Path::new("docs/images").join(name), drawn(line, 80));
        if std::env::var("OBJDICT_PICTURES").is_ok_and(|value| value == "write") {
            std::fs::write(&path, &picture).unwrap();
        }
        let shown = std::fs::read_to_string(&path).unwrap();
        assert!(
            shown == picture,
            "{name} is stale: OBJDICT_PICTURES=write cargo test --test command pictures"
        );
        assert!(readme.contains(&format!("docs/images/{name}")), "README.md does not show {name}");
    }
}

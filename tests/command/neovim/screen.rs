//! The pictures of docs/guides/editors.md: the screen of Neovim, with what the server says.

use std::fmt::Write as _;
use std::path::Path;

use anstyle_svg::Term;

use super::{Neovim, drive, to, version};
use crate::support::skips::skip;

/// A part of a row: text, foreground, background, and whether it is bold.
type Run = (String, i64, i64, u8);

/// The cells as a terminal is sent them; the lines at the end that nothing is in are left out.
fn printed(rows: &[Vec<Run>]) -> String {
    let mut text = String::new();
    let last = rows.iter().rposition(|runs| runs.iter().any(|(text, ..)| !text.trim().is_empty()));
    for runs in rows.iter().take(last.map_or(0, |last| last + 1)) {
        for (part, fore, back, bold) in runs {
            if *bold == 1 {
                text += "\u{1B}[1m";
            }
            for (layer, colour) in [(38, *fore), (48, *back)] {
                if colour >= 0 {
                    let _ = write!(
                        text,
                        "\u{1B}[{layer};2;{};{};{}m",
                        colour >> 16 & 255,
                        colour >> 8 & 255,
                        colour & 255
                    );
                }
            }
            let _ = write!(text, "{part}\u{1B}[0m");
        }
        text.push('\n');
    }
    text
}

/// The screen, drawn.
fn drawn(neovim: &Neovim) -> String {
    neovim.value("execute('redraw!')");
    neovim.call("screen", |said| said == "written");
    let cells = std::fs::read_to_string(neovim.path("screen.json")).unwrap();
    let rows: Vec<Vec<Run>> = serde_json::from_str(&cells).unwrap();
    Term::new().min_width_px(800).render_svg(&printed(&rows))
}

#[test]
fn the_pictures_of_the_editor_are_what_it_shows() {
    let Some(version) = version() else { return };
    if !version.starts_with("v0.7.") {
        skip(format_args!("the pictures are of Neovim 0.7, and this is {version}"));
        return;
    }
    let page = std::fs::read_to_string("docs/guides/editors.md").unwrap();
    let at_mapping = format!("{}zt", to("\\[1A00sub0\\]"));
    let check = |name: &str, picture: &str| {
        let path = Path::new("docs/images").join(name);
        if std::env::var("OBJDICT_PICTURES").is_ok_and(|value| value == "write") {
            std::fs::write(&path, picture).unwrap();
        }
        let shown = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(shown == picture, "{name} is stale: OBJDICT_PICTURES=write cargo test --test command neovim");
        assert!(page.contains(&format!("images/{name}")), "docs/guides/editors.md does not show {name}");
    };
    let neovim = Neovim::open("drive-402.eds", &drive().replace("0x60410010", "0x60410020"));
    neovim.keys(&at_mapping);
    neovim.findings(|found| !found.is_empty());
    check("editor-findings.svg", &drawn(&neovim));
    let neovim = Neovim::open("drive-402.eds", &drive());
    neovim.keys(&format!("{at_mapping}{}$:lua vim.lsp.buf.hover()<CR>", to("DefaultValue=0x60410010")));
    neovim.call("floating", |text| !text.is_empty());
    check("editor-hover.svg", &drawn(&neovim));
    let neovim = Neovim::open("drive-402.eds", &drive());
    neovim.keys(&format!("{at_mapping}{}0f=C=<C-x><C-o>", to("DefaultValue=0x60410010")));
    neovim.until("pumvisible()", "1");
    check("editor-completion.svg", &drawn(&neovim));
}

//! The page printed.

use std::fs;
use std::process::Command;

use crate::page::Page;

/// Everything that has an address, and whether it takes room.
const PLACES: &str = "[...document.querySelectorAll('.o, tbody tr')]";

#[test]
fn paper_has_every_entry() {
    for fixture in ["eds/io-401.eds", "dcf/drive-402-node8.dcf", "xdd/press-402.xdd"] {
        let Some(page) = Page::open(fixture, "") else { return };
        page.medium("print", "light");
        let missing = format!("{PLACES}.filter(of => !of.getBoundingClientRect().height).map(of => of.id)");
        assert_eq!(page.texts(&missing), [""; 0], "{fixture}");
        for part in ["nav", "#tools", ".skip"] {
            assert!(
                page.is(&format!("!document.querySelector('{part}').checkVisibility()")),
                "{fixture}: {part}"
            );
        }
        let pdf = page.pdf();
        assert!(pdf.starts_with(b"%PDF-"));
        let Some(text) = text_of(&pdf) else { return };
        let words = page.texts(
            "[...document.querySelectorAll('.o h4, .s tbody tr > td:nth-child(2)')].map(of => of.firstChild.data?.trim() || of.lastChild.data.trim())",
        );
        assert!(words.len() > 50, "{fixture}");
        let text = squeezed(&text);
        for word in words {
            assert!(text.contains(&squeezed(&word)), "{fixture}: `{word}` is not on paper");
        }
    }
}

#[test]
fn paper_is_white_though_the_screen_is_dark() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    page.medium("print", "dark");
    assert_eq!(page.text("getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)");
    assert_eq!(page.text("getComputedStyle(document.body).color"), "rgb(0, 0, 0)");
}

/// The text without blanks: where lines break is not the point.
fn squeezed(text: &str) -> String {
    text.chars().filter(|character| !character.is_whitespace()).collect()
}

/// What `pdftotext` reads; `None` where there is none.
fn text_of(pdf: &[u8]) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("page.pdf");
    fs::write(&path, pdf).unwrap();
    let output = match Command::new("pdftotext").arg("-raw").arg(&path).arg("-").output() {
        Ok(output) => output,
        Err(_) if std::env::var("CI").is_ok_and(|ci| ci == "true") => panic!("no pdftotext"),
        Err(_) => return None,
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).unwrap())
}

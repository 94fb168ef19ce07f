//! The page printed.

use std::fs;
use std::process::Command;

use crate::page::Page;
use crate::support::skips::skip_unless_ci;

/// Everything that has an address, and whether it takes room.
const PLACES: &str = "[...document.querySelectorAll('.o, tbody tr')]";

#[test]
fn paper_has_every_entry() {
    for fixture in ["eds/io-401.eds", "dcf/drive-402-node8.dcf", "xdd/press-402.xdd"] {
        let Some(page) = Page::open(fixture, "") else { return };
        page.medium("print", "light");
        let missing = format!("{PLACES}.filter(of => !of.getBoundingClientRect().height).map(of => of.id)");
        assert_eq!(page.texts(&missing), [""; 0], "{fixture}");
        assert!(page.is("document.querySelector('nav').checkVisibility()"), "{fixture}: contents");
        for part in ["footer", "#tools", ".skip"] {
            assert!(
                page.is(&format!("!document.querySelector('{part}').checkVisibility()")),
                "{fixture}: {part}"
            );
        }
        let pdf = page.pdf();
        assert!(pdf.starts_with(b"%PDF-"));
        let Some(text) = read(&pdf, "-raw") else { return };
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

/// Each page says which device it is about and which page it is, and but for the last one it is full.
#[test]
fn paper_has_page_numbers_and_running_heads() {
    for (fixture, title) in [
        ("dcf/drive-402-node8.dcf", "Servo drive SD400"),
        ("eds/io-401.eds", "IO module 16DIO 2AIO"),
        ("eds/encoder-406.eds", ""),
    ] {
        let Some(page) = Page::open(fixture, "") else { return };
        let pdf = page.pdf();
        let Some(text) = read(&pdf, "-layout") else { return };
        let pages: Vec<&str> = text.trim_end_matches('\u{c}').split('\u{c}').collect();
        assert!(pages.len() > 3, "{fixture}: {} pages", pages.len());
        assert!(pages[0].contains("Contents"), "{fixture}: {}", pages[0]);
        for (number, text) in (1..).zip(&pages) {
            let last = squeezed(text.trim_end().lines().last().unwrap());
            assert!(last.ends_with(&format!("{number}/{}", pages.len())), "{fixture}: {last:?}");
            let first = text.trim_start().lines().next().unwrap();
            assert!(first.contains(title), "{fixture}, page {number}: {first:?}");
        }
        let ends = ends(&read(&pdf, "-bbox").unwrap());
        let full = &ends[..ends.len() - 1];
        assert!(full.iter().all(|end| *end > 0.7), "{fixture}: {full:?}");
    }
}

/// Where the text of each page ends, as a share of its height; the margins do not count.
fn ends(boxes: &str) -> Vec<f64> {
    let number = |line: &str, name: &str| -> f64 {
        line.split_once(&format!("{name}=\"")).unwrap().1.split('"').next().unwrap().parse().unwrap()
    };
    let pages = boxes.split("<page ").skip(1).map(|page| {
        let height = number(page, "height");
        let words =
            page.lines().filter(|line| line.contains("<word")).map(|line| number(line, "yMax") / height);
        words.filter(|end| *end < 0.945).fold(0.0, f64::max)
    });
    pages.collect()
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

/// What `pdftotext` reads in this form; `None` where there is none.
fn read(pdf: &[u8], form: &str) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("page.pdf");
    fs::write(&path, pdf).unwrap();
    let Ok(output) = Command::new("pdftotext").arg(form).arg(&path).arg("-").output() else {
        skip_unless_ci("no `pdftotext`: install the package `poppler-utils`");
        return None;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).unwrap())
}

//! The page of `objdict decode --html`: the time line, the plots, and the script that shows a part of them.

use std::fs;

use crate::page::Page;

/// The page of a log of three nodes.
pub(crate) fn cell(options: &[&str]) -> Option<Page> {
    Page::of_logs(&[&["fixtures/logs/cell.log", "--with", "fixtures/network/cell.yml"], options].concat())
}

/// What is to be seen in a drawing, as its words.
fn words(page: &Page, drawing: &str) -> Vec<String> {
    page.texts(&format!(
        "[...document.querySelectorAll(`{drawing} .fit:not(.small)`)].map(word => word.textContent)"
    ))
}

/// A place in the first plot of a name, in parts of its width.
fn place(page: &Page, name: &str, part: f64) -> (f64, f64) {
    page.eval(&format!(
        "plot = [...document.querySelectorAll('svg.time')].find(of => of.ariaLabel.startsWith('{name}')),
         plot.scrollIntoView({{ block: 'center' }}), box = plot.getBoundingClientRect(), 0"
    ));
    (page.number(&format!("box.x + box.width * {part}")), page.number("box.y + box.height / 2"))
}

/// What the plots say at the pointer.
fn said(page: &Page) -> Vec<String> {
    page.texts("[...document.querySelectorAll('.timed output')].map(of => of.textContent)")
}

#[test]
fn states_and_values_are_drawn() {
    let Some(page) = cell(&["--plot", "left.6041", "--plot", "left.Position actual value"]) else { return };
    let lanes = page.texts("[...document.querySelectorAll('.lane > b')].map(of => of.textContent).filter(of => of)");
    assert_eq!(lanes, ["Time", "no node", "counter", "left", "right", "node 127"]);
    assert!(words(&page, "[aria-label='what left sends']").contains(&"operational".to_owned()));
    assert!(words(&page, "svg.words").contains(&"operation enabled".to_owned()));
    assert_eq!(page.number("document.querySelectorAll('.mark').length"), 1.0);
    assert!(page.text("document.querySelector('.mark').textContent").contains("EMCY 4310h"));
    let facts = page.texts("[...document.querySelectorAll('.timed summary small')].map(of => of.textContent)");
    assert_eq!(facts, ["25 values", "25 values, lowest 1000, mean 2713.6, highest 5090"]);
}

#[test]
fn the_pointer_shows_values_and_a_drag_shows_a_part() {
    let Some(page) = cell(&["--plot", "left.6041", "--plot", "left.6064"]) else { return };
    page.resize(1280, 900);
    let ticks = || page.texts("[...document.querySelectorAll('.ticks text')].map(of => of.textContent)");
    assert_eq!(ticks(), ["0.0 s", "0.1 s", "0.2 s", "0.3 s", "0.4 s"]);
    // 0.3 s of 0.470742 s: the drive has just begun to move
    let (x, y) = place(&page, "left 6064", 0.3 / 0.470_742);
    page.mouse("mouseMoved", x, y);
    page.settle();
    assert_eq!(said(&page), ["operation enabled", "1040"]);
    // from there to 0.4 s
    let (end, _) = place(&page, "left 6064", 0.4 / 0.470_742);
    page.mouse("mousePressed", x, y);
    page.mouse("mouseMoved", (x + end) / 2.0, y);
    page.mouse("mouseMoved", end, y);
    page.mouse("mouseReleased", end, y);
    page.settle();
    assert_eq!(ticks(), ["0.35 s", "0.40 s"]);
    let (middle, y) = place(&page, "left 6064", 0.5);
    page.mouse("mouseMoved", middle, y);
    page.settle();
    assert_eq!(said(&page), ["operation enabled", "2230"]);
    // by the keyboard
    page.eval("document.querySelector('.steer button').focus()");
    page.press("0");
    page.settle();
    assert_eq!(ticks().len(), 5);
    page.press("+");
    page.settle();
    assert!(page.text("document.querySelector('.steer output').textContent").starts_with("0.1"));
}

#[test]
fn a_page_without_a_script_is_whole() {
    let Some(page) = cell(&[]) else { return };
    page.without_script();
    page.open(&page.path, "");
    assert!(words(&page, "[aria-label='what left sends']").contains(&"operational".to_owned()));
    assert!(page.is("document.querySelector('.steer').hidden"));
}

#[test]
fn narrow_windows_have_no_second_scroll_bar() {
    let Some(page) = cell(&[]) else { return };
    for width in [320, 400, 2560] {
        page.resize(width, 900);
        page.settle();
        assert!(page.is("document.documentElement.scrollWidth <= innerWidth"), "{width}");
    }
}

#[test]
fn texts_of_logs_and_descriptions_stay_texts() {
    let name = "<script>window.hacked=1</script>\"><img src=x onerror=window.hacked=2>";
    let folder = tempfile::tempdir().unwrap();
    let eds = fs::read_to_string("fixtures/eds/drive-402.eds").unwrap();
    let hostile = eds.replace("ParameterName=Position actual value", &format!("ParameterName={name}"));
    assert_ne!(hostile, eds);
    fs::write(folder.path().join("drive.eds"), hostile).unwrap();
    let log = fs::read_to_string("fixtures/logs/cell.log").unwrap();
    fs::write(folder.path().join("a.log"), log.replace("can0", "<b>&'\"can").replace(" 18B#", " 185#")).unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let with = format!("5={}", file("drive.eds"));
    let Some(page) = Page::of_logs(&[&file("a.log"), "--with", &with]) else { return };
    assert!(page.is("window.hacked === undefined"));
    assert_eq!(page.number("document.querySelectorAll('img, b:not(.lane > b)').length"), 0.0);
    assert_eq!(page.text("document.querySelector('h2').textContent"), "Channel <b>&'\"can");
}

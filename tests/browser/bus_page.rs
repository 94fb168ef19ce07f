//! The page of the traffic of a bus: cursor, zoom, links, sizes, and names that would do harm.

use std::fs;

use crate::layout::{assert_contrast, assert_fits};
use crate::page::Page;
use crate::tab::Tab;

pub(crate) const DRIVE_LOG: [&str; 3] = ["fixtures/logs/drive.asc", "--with", "5=fixtures/eds/drive-402.eds"];

/// The drawing of `Position actual value`.
const POSITION: &str = ".area[aria-label*='6064:00']";

fn drive() -> Option<Page> {
    Some(Page::of_logs(Tab::new()?, &DRIVE_LOG))
}

/// Which part of the width a time in seconds from the first frame on has, while all is shown.
fn part(page: &Page, seconds: f64) -> f64 {
    page.number(&format!(
        "(({{ start, length, zero }}) => ({seconds} * 1e9 - Number(BigInt(start) - BigInt(zero))) / Number(length))(drawings.dataset)"
    ))
}

/// What is shown of the time, as a part of all of it.
fn shown(page: &Page) -> f64 {
    page.number(&format!("document.querySelector(\"{POSITION} .zoom\").viewBox.baseVal.width")) / 1000.0
}

#[test]
fn the_cursor_reads_all_plots() {
    let Some(page) = drive() else { return };
    // the values of the frames at 0.053991 and 0.058991
    for (seconds, position, state) in [(0.0385, "1700", "switched on"), (0.0435, "1950", "operation enabled")]
    {
        let at = part(&page, seconds);
        page.drag(POSITION, at, at);
        let read = |name: &str| {
            page.text(&format!(
                "[...document.querySelectorAll('.plot')].find(of => of.textContent.includes('{name}')).querySelector('output').textContent"
            ))
        };
        assert_eq!((read("6064:00"), read("6041:00")), (position.to_owned(), state.to_owned()));
        let moment: f64 = page.text("moment.textContent").split(',').next().unwrap().parse().unwrap();
        assert!((moment - 0.015991 - seconds).abs() < 0.0002, "{moment}");
    }
    let before = page.text("moment.textContent");
    page.press("ArrowRight");
    assert!(page.text("moment.textContent") > before, "keys move the cursor");
}

#[test]
fn time_is_zoomed_by_drag_wheel_and_keys() {
    let Some(page) = drive() else { return };
    let near = |shown: f64, wanted: f64| (shown - wanted).abs() < 0.01;
    assert!(near(shown(&page), 1.0));
    page.drag(POSITION, 0.5, 0.75);
    assert!(near(shown(&page), 0.25), "{}", shown(&page));
    let labels = page.texts("[...document.querySelector('.ticks').children].map(tick => tick.textContent)");
    assert!(
        labels.iter().any(|label| label == "40 ms") && !labels.iter().any(|label| label == "0 ms"),
        "{labels:?}"
    );
    page.press("-");
    assert!(near(shown(&page), 0.5), "{}", shown(&page));
    page.wheel(POSITION, 0.5, -100, true);
    assert!(near(shown(&page), 0.4), "{}", shown(&page));
    page.press("0");
    assert!(near(shown(&page), 1.0));
    page.click("#in");
    assert!(near(shown(&page), 0.5));
}

#[test]
fn plots_are_hidden_and_links_lead_to_moments() {
    let Some(page) = drive() else { return };
    let plots = "[...document.querySelectorAll('.plot')].filter(of => of.checkVisibility()).length";
    assert_eq!(page.number(plots), 3.0);
    page.click("#shown input");
    assert_eq!(page.number(plots), 2.0);
    page.click(".events.abort a");
    let moment = page.text("moment.textContent");
    assert!(moment.starts_with("0.041991") && moment.contains("above the high limit"), "{moment}");
    assert!(page.is("document.querySelector('.mark:target').classList.contains('abort')"));
}

#[test]
fn without_script_all_is_there() {
    let Some(tab) = Tab::new() else { return };
    tab.without_script();
    let page = Page::of_logs(tab, &DRIVE_LOG);
    assert!(page.is("tools.hidden && document.querySelectorAll('.line, .mark').length > 5"));
    assert!(page.is("document.querySelector('.word:not([visibility])').checkVisibility()"));
    assert_fits(&page, "without script");
}

#[test]
fn the_page_fits_and_stands_out() {
    for (log, with) in
        [(DRIVE_LOG[0], DRIVE_LOG[2]), ("fixtures/logs/chapter4.log", "fixtures/network/chapter4.toml")]
    {
        let Some(tab) = Tab::new() else { return };
        let page = Page::of_logs(tab, &[log, "--with", with]);
        for width in [2560, 1280, 768, 400, 320] {
            page.resize(width, 900);
            page.settle();
            assert_fits(&page, &format!("{log} at {width}"));
        }
        page.resize(1280, 900);
        for scheme in ["light", "dark"] {
            page.medium("screen", scheme);
            assert_contrast(&page, &format!("{log}, {scheme}"));
        }
        let drawings = page.spoken().into_iter().filter(|of| of.role == "image").count();
        assert!(drawings >= 6, "each drawing has a name: {drawings}");
    }
}

#[test]
fn names_of_nodes_and_signals_stay_text() {
    let folder = tempfile::tempdir().unwrap();
    let name = "<script>window.hacked=1</script>\"><img src=x onerror=window.hacked=2>";
    let description = fs::read_to_string("fixtures/eds/drive-402.eds").unwrap();
    let hostile = description
        .replace("ParameterName=Position actual value", &format!("ParameterName={name}\u{202e}\u{7}"));
    assert_ne!(hostile, description);
    let path = folder.path().join("<b>&'\"x.eds");
    fs::write(&path, hostile).unwrap();
    let log = folder.path().join("<i onclick='x'>\u{202e}.asc");
    fs::copy(DRIVE_LOG[0], &log).unwrap();
    let Some(tab) = Tab::new() else { return };
    let with = format!("5={}", path.display());
    let page =
        Page::of_logs(tab, &[log.to_str().unwrap(), "--with", &with, "--plot", "6064", "--plot", "<u>"]);
    assert!(page.is("window.hacked === undefined && document.scripts.length === 1"));
    assert_eq!(
        page.number("document.querySelectorAll('img, b, u, i:not(.legend i), [onclick], [onerror]').length"),
        0.0
    );
    assert!(page.text("document.querySelector('figcaption').textContent").contains(name));
    assert!(page.is("!/[\\u0007\\u202e]/.test(document.body.textContent)"));
}

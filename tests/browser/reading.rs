//! Those who do not see the page, have no mouse, or allow no script.

use crate::page::Page;
use crate::tab::Spoken;

const FIXTURES: [&str; 3] = ["eds/io-401.eds", "dcf/drive-402-node8.dcf", "xdd/press-402.xdd"];

#[test]
fn the_page_has_landmarks() {
    for fixture in FIXTURES {
        let Some(page) = Page::open(fixture, "") else { return };
        let spoken = page.spoken();
        let of = |role: &str| spoken.iter().filter(|spoken| spoken.role == role).collect::<Vec<_>>();
        for role in ["banner", "main", "navigation", "search", "contentinfo"] {
            assert_eq!(of(role).len(), 1, "{fixture}: {role}");
        }
        assert!(of("region").iter().all(|region| !region.name.is_empty()), "{fixture}");
        assert_eq!(page.text("document.documentElement.lang"), "en");
        assert!(!page.text("document.title").is_empty());
    }
}

#[test]
fn headings_are_in_order() {
    for fixture in FIXTURES {
        let Some(page) = Page::open(fixture, "") else { return };
        let spoken = page.spoken();
        let headings: Vec<&Spoken> = spoken.iter().filter(|spoken| spoken.role == "heading").collect();
        assert_eq!(headings[0].level, Some(1), "{fixture}");
        assert_eq!(headings.iter().filter(|heading| heading.level == Some(1)).count(), 1, "{fixture}");
        for pair in headings.windows(2) {
            let (before, after) = (pair[0].level.unwrap(), pair[1].level.unwrap());
            assert!(after <= before + 1, "{fixture}: {:?} after {:?}", pair[1], pair[0]);
        }
        assert!(headings.iter().all(|heading| !heading.name.is_empty()), "{fixture}");
    }
}

#[test]
fn everything_has_a_name() {
    for fixture in FIXTURES {
        let Some(page) = Page::open(fixture, "") else { return };
        page.eval("document.querySelectorAll('details').forEach(of => of.open = true)");
        page.settle();
        let wanted = ["button", "link", "searchbox", "textbox", "image", "columnheader", "rowheader"];
        let spoken = page.spoken();
        for part in spoken.iter().filter(|part| wanted.contains(&&*part.role)) {
            assert!(!part.name.is_empty(), "{fixture}: {part:?}");
        }
        let tables = "[...document.querySelectorAll('table')]";
        let headless = format!(
            "{tables}.filter(of => ![...of.tHead.rows[0].cells].every(cell => cell.tagName == 'TH' && cell.scope == 'col' && cell.textContent)
                || ![...of.tBodies[0].rows].every(row => row.cells.length == of.tHead.rows[0].cells.length))
                .map(of => of.outerHTML.slice(0, 300))"
        );
        assert_eq!(page.texts(&headless), [""; 0], "{fixture}");
        let nameless = "[...document.querySelectorAll('svg:not([aria-hidden=true])')]
            .filter(of => of.getAttribute('role') != 'img' || !(of.getAttribute('aria-label') || of.querySelector('title')
                || document.getElementById(of.getAttribute('aria-labelledby'))))
            .map(of => of.outerHTML.slice(0, 200))";
        assert_eq!(page.texts(nameless), [""; 0], "{fixture}");
    }
}

#[test]
fn the_keyboard_reaches_everything() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    page.press("Tab");
    assert_eq!(page.text("document.activeElement.className"), "skip");
    let on_screen = "document.activeElement.getBoundingClientRect()";
    assert!(page.is(&format!("{on_screen}.left >= 0 && {on_screen}.top >= 0 && {on_screen}.height > 10")));
    let (mut reached, mut unseen) = (Vec::new(), Vec::new());
    for _ in 0..400 {
        page.press("Tab");
        if page.is("document.activeElement === document.body") {
            break;
        }
        let here = page.text(
            "(of => of.id || of.getAttribute('href') || of.closest('[id]').id + ' ' + of.tagName)(document.activeElement)",
        );
        if !page.is("(style => style.outlineStyle != 'none' && parseFloat(style.outlineWidth) >= 1)
            (getComputedStyle(document.activeElement))")
        {
            unseen.push(here.clone());
        }
        reached.push(here);
    }
    assert_eq!(unseen, [""; 0], "the focus is not to be seen");
    for wanted in
        ["filter", "expand", "collapse", "#device", "#objects", "#1000", "6000 SUMMARY", "#1018sub1"]
    {
        assert!(reached.iter().any(|here| here == wanted), "{wanted} is not in {reached:?}");
    }
}

#[test]
fn the_skip_link_skips() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    page.press("Tab");
    page.press("Enter");
    page.wait("scrollY > 0");
    page.press("Tab");
    assert!(page.is("document.querySelector('#objects').contains(document.activeElement)"));
}

#[test]
fn nothing_needs_script() {
    for fixture in FIXTURES {
        let Some(page) = Page::open(fixture, "") else { return };
        let texts =
            "[...document.querySelectorAll('.o, tbody tr, .card, .found, .group')].map(of => of.textContent)";
        let (with, shown) = (page.texts(texts), page.objects());
        let Some(page) = Page::without_script(fixture, "") else { return };
        assert_eq!(page.texts(texts), with, "{fixture}");
        assert_eq!(page.objects(), shown, "{fixture}");
        assert!(page.is("!document.querySelector('#filter').checkVisibility()"));
        // arrays are opened by the browser itself
        page.click("[id='1003'] > summary > span");
        page.wait("document.getElementById('1003').open");
        assert!(!page.rows("1003").is_empty());
    }
}

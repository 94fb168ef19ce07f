//! What fits, on a telephone and on a desk, in light and dark.

use std::path::Path;

use crate::page::{Page, make};
use crate::support::{files, fixtures};
use crate::tab::Tab;

#[test]
fn no_page_is_wider_than_its_window() {
    let Some(tab) = Tab::new() else { return };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("page.html");
    let healthy = ["eds", "dcf", "xdd", "xdc"].map(|ending| files(ending, &[ending])).concat();
    for description in healthy {
        // German words are longer
        make(&description, &["--lang", "de"], &path);
        tab.resize(1280, 900);
        tab.open(&path, "");
        tab.eval("document.querySelectorAll('details').forEach(of => of.open = true)");
        for width in [1280, 1000, 768, 400, 320] {
            tab.resize(width, 800);
            tab.settle();
            assert_fits(&tab, &format!("{} at {width}", description.display()));
        }
        assert_eq!(tab.complaints(), [""; 0], "{}", description.display());
        assert_eq!(tab.requests(), [""; 0], "{}", description.display());
    }
}

#[test]
fn a_site_leads_to_its_pages() {
    for (files, pages) in [("dcf", 5), ("network/chapter4.toml", 5), ("network/wider.yml", 3)] {
        let Some(tab) = Tab::new() else { return };
        leads_to_its_pages(&tab, files, pages);
    }
}

fn leads_to_its_pages(tab: &Tab, files: &str, count: usize) {
    let folder = tempfile::tempdir().unwrap();
    make(&fixtures().join(files), &["--lang", "de"], folder.path());
    let index = folder.path().join("index.html");
    tab.open(&index, "");
    let lost = "[...document.links].map(link => link.getAttribute('href'))
        .filter(to => to.startsWith('#') && !document.getElementById(to.slice(1)))";
    assert_eq!(tab.texts(lost), [""; 0]);
    for width in [1280, 400, 320] {
        tab.resize(width, 800);
        tab.settle();
        assert_fits(tab, &format!("the index of {files} at {width}"));
    }
    for scheme in ["light", "dark"] {
        tab.medium("screen", scheme);
        assert_contrast(tab, &format!("the index of {files}, {scheme}"));
    }
    let pages = tab.texts(
        "[...new Set([...document.links].map(link => link.href))].filter(to => to.startsWith('file:') && !to.includes('/index.html'))",
    );
    let mut addresses: Vec<&str> = pages.iter().map(|to| to.split('#').next().unwrap()).collect();
    addresses.sort_unstable();
    addresses.dedup();
    assert_eq!(addresses.len(), count, "{addresses:?}");
    for page in addresses {
        tab.open(Path::new(page.strip_prefix("file://").unwrap()), "");
        assert!(tab.is("document.querySelector('#objects') !== null"), "{page}");
        // each entry that the index names is there
        let anchors: Vec<&str> =
            pages.iter().filter_map(|to| to.strip_prefix(page)?.strip_prefix('#')).collect();
        for anchor in anchors {
            assert!(tab.is(&format!("document.getElementById('{anchor}') !== null")), "{page}#{anchor}");
        }
        assert!(tab.is("document.querySelector(\"nav a[href='index.html']\").checkVisibility()"), "{page}");
    }
    assert_eq!(tab.complaints(), [""; 0]);
    assert_eq!(tab.requests(), [""; 0]);
}

#[test]
fn an_index_is_filtered_and_sorted() {
    let Some(tab) = Tab::new() else { return };
    let folder = tempfile::tempdir().unwrap();
    make(&fixtures().join("dcf"), &[], folder.path());
    tab.open(&folder.path().join("index.html"), "");
    let devices = "[...document.querySelectorAll('#devices tbody tr')].filter(row => !row.hidden).map(row => row.cells[0].innerText.split('\\n')[0])";
    let all = tab.texts(devices);
    tab.eval("document.querySelectorAll('#devices thead button')[0].click()");
    tab.eval("document.querySelectorAll('#devices thead button')[0].click()");
    let mut sorted = all.clone();
    sorted.sort();
    sorted.reverse();
    assert_eq!(tab.texts(devices), sorted);
    tab.eval("filter.focus()");
    tab.write("encoder");
    assert_eq!(tab.texts(devices), ["Multi-turn encoder 13x12"]);
    tab.eval("filter.value = ''");
    tab.write("6040h");
    assert!(tab.texts("[...document.querySelectorAll('#all li')].filter(of => of.checkVisibility()).map(of => of.lastElementChild.getAttribute('href'))")
        .contains(&"drive-402-node8.html#6040".to_owned()));
    assert_eq!(tab.complaints(), [""; 0]);
}

#[track_caller]
pub(crate) fn assert_fits(tab: &Tab, what: &str) {
    let window = "document.scrollingElement";
    if tab.is(&format!("{window}.scrollWidth > {window}.clientWidth")) {
        let wide = tab.texts(
            "[...document.body.querySelectorAll('*')]
                .filter(of => of.getBoundingClientRect().right > document.scrollingElement.clientWidth + 1)
                .slice(0, 5).map(of => of.outerHTML.slice(0, 200))",
        );
        panic!("{what}: wider than the window: {wide:#?}");
    }
}

#[test]
fn texts_stand_out_in_light_and_dark() {
    for (fixture, scheme) in [
        ("dcf/drive-402-node8.dcf", "light"),
        ("dcf/drive-402-node8.dcf", "dark"),
        ("xdd/press-402.xdd", "dark"),
    ] {
        let Some(page) = Page::open(fixture, "1018sub1") else { return };
        page.medium("screen", scheme);
        page.eval("document.querySelectorAll('details').forEach(of => of.open = true)");
        assert_contrast(&page, &format!("{fixture}, {scheme}"));
    }
    let Some(page) = Page::open("broken/wrong-counts.eds", "") else { return };
    assert!(page.number("document.querySelectorAll('.found li').length") > 0.0);
    page.eval("document.querySelectorAll('.found').forEach(of => of.open = true)");
    for scheme in ["light", "dark"] {
        page.medium("screen", scheme);
        assert_contrast(&page, &format!("findings, {scheme}"));
    }
}

/// Every text has a contrast of 4.5 to what is behind it, 3 where it is large (WCAG 2.1, 1.4.3).
#[track_caller]
pub(crate) fn assert_contrast(page: &Tab, what: &str) {
    page.settle();
    let weak = page.texts(include_str!("contrast.js"));
    assert!(weak.is_empty(), "{what}: {weak:#?}");
}

#[test]
fn a_weak_contrast_is_seen() {
    let Some(tab) = Tab::new() else { return };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("page.html");
    std::fs::write(
        &path,
        "<body style='background: #fff'><p style='color: #777'>weak<p style='color: #767676'>strong
        <div style='background: #000'><b style='color: #333'>in the dark</b></div>
        <svg width=50 height=20><rect width=50 height=20 fill=#222 /><text y=15 fill=#444>bits</text></svg>",
    )
    .unwrap();
    tab.open(&path, "");
    let weak = tab.texts(include_str!("contrast.js")).join("\n");
    for (text, is_weak) in [("weak", true), ("strong", false), ("in the dark", true), ("bits", true)] {
        assert_eq!(weak.contains(text), is_weak, "{text}: {weak}");
    }
}

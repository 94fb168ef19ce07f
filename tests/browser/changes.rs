//! The pages of `objdict diff` and `objdict variants`: both sides, drawings of PDOs, the filter; the table.

use crate::page::Page;

fn open() -> Option<Page> {
    Page::of_changes("bases/drive.eds", "diff/drive-2.eds")
}

/// The rules of the changes that are to be seen.
fn rules(page: &Page) -> Vec<String> {
    page.texts(
        "[...document.querySelectorAll('.change')].filter(of => of.checkVisibility()).map(of => of.querySelector('h2 small').textContent)",
    )
}

fn choose(page: &Page, list: &str, value: &str) {
    page.eval(&format!("{list}.value = '{value}', {list}.dispatchEvent(new Event('change'))"));
    page.settle();
}

#[test]
fn changes_are_filtered_by_verdict_and_audience() {
    let Some(page) = open() else { return };
    let all = rules(&page);
    assert!(all.contains(&"change/pdo-mapping-changed".to_owned()) && all.len() > 5, "{all:?}");
    assert_eq!(page.text("hits.textContent"), "");
    choose(&page, "verdict", "breaking");
    assert_eq!(
        rules(&page),
        ["change/pdo-mapping-changed", "change/access-narrowed", "change/mapping-narrowed"]
    );
    assert_eq!(page.text("hits.textContent"), format!("3 / {}", all.len()));
    // the verdict is the one for the audience
    choose(&page, "audience", "configurations");
    assert_eq!(rules(&page), ["change/access-narrowed", "change/mapping-narrowed"]);
    choose(&page, "verdict", "risky");
    assert!(rules(&page).contains(&"change/pdo-mapping-changed".to_owned()));
    choose(&page, "verdict", "");
    choose(&page, "audience", "");
    assert_eq!(rules(&page), all);
}

#[test]
fn pdos_are_drawn_before_and_after_beside_each_other() {
    let Some(page) = open() else { return };
    page.eval("mapping = [...document.querySelectorAll('.change')].find(of => of.querySelector('small').textContent.includes('mapping'))");
    assert_eq!(page.number("mapping.querySelectorAll('.old svg .f0, .old svg .f1').length"), 1.0);
    assert_eq!(page.number("mapping.querySelectorAll('.new svg .f0, .new svg .f1').length"), 2.0);
    let top = |side: &str| {
        page.number(&format!("mapping.querySelector('.{side} svg').getBoundingClientRect().top"))
    };
    let left = |side: &str| {
        page.number(&format!("mapping.querySelector('.{side} svg').getBoundingClientRect().left"))
    };
    assert_eq!(top("old"), top("new"));
    assert!(left("old") < left("new"));
    // below each other where there is no room
    page.resize(360, 800);
    assert!(top("old") < top("new"));
    assert!(page.is("document.documentElement.scrollWidth <= innerWidth"));
}

#[test]
fn variants_are_rows_of_a_table() {
    let Some(page) = Page::printed("variants", &["toml/family.toml"]) else { return };
    let names = "[...document.querySelectorAll('tbody tr')].map(row => row.cells[0].textContent)";
    assert_eq!(page.texts(names), ["", "io8", "io8-fast"]);
    assert_eq!(page.text("document.querySelector('h1').textContent"), "IO module");
}

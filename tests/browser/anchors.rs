//! Addresses of objects and entries, and parts that open on demand.

use crate::page::Page;
use crate::support::RULE_PAGES;
use crate::tab::Tab;

/// Whether an element is in the window and nothing lies over it, as an expression.
fn in_view(id: &str) -> String {
    format!(
        "(() => {{
            const found = document.getElementById('{id}'), box = found.getBoundingClientRect();
            if (!box.height || box.top < 0 || box.bottom > innerHeight) return false;
            const there = document.elementFromPoint(box.x + 30, box.top + 8);
            return found.contains(there);
        }})()"
    )
}

fn background(page: &Tab, id: &str) -> String {
    page.text(&format!("getComputedStyle(document.getElementById('{id}')).backgroundColor"))
}

#[test]
fn an_address_leads_to_an_object() {
    let Some(page) = Page::open("eds/io-401.eds", "6000") else { return };
    page.wait(&in_view("6000"));
    assert_ne!(background(&page, "6000"), background(&page, "6002"));
    page.open(&page.path, "1018");
    page.wait(&in_view("1018"));
    assert!(!page.is(&in_view("6000")));
}

#[test]
fn an_address_leads_into_what_is_closed() {
    for fixture in ["eds/io-401.eds", "eds/drive-402.eds"] {
        let Some(page) = Page::open(fixture, "1003sub2") else { return };
        page.wait(&in_view("1003sub2"));
        assert_ne!(background(&page, "1003sub2"), background(&page, "1003sub1"));
    }
    let Some(page) = Page::open("eds/drive-402.eds", "607Dsub1") else { return };
    page.wait(&in_view("607Dsub1"));
}

#[test]
fn an_address_leads_there_without_script() {
    let Some(page) = Page::without_script("eds/io-401.eds", "6000sub1") else { return };
    page.wait("document.getElementById('6000sub1').closest('details').open");
    page.wait(&in_view("6000sub1"));
}

#[test]
fn an_address_undoes_the_filter() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    page.eval("filter.focus()");
    page.write("heartbeat");
    assert_eq!(page.objects(), ["1016", "1017"]);
    page.eval("location.hash = '6401sub2'");
    page.settle();
    assert_eq!(page.objects().len(), 28);
    page.wait(&in_view("6401sub2"));
    // an address of nothing, or one that is no text, changes nothing
    for hash in ["7000", "%", "%FF", "<b>", ""] {
        page.eval(&format!("location.hash = '{hash}'"));
        page.settle();
    }
}

#[test]
fn every_link_has_its_place() {
    for fixture in ["eds/io-401.eds", "dcf/drive-402-node8.dcf", "xdd/press-402.xdd", "eds/manager-302.eds"] {
        let Some(page) = Page::open(fixture, "") else { return };
        let links = "[...document.links].map(link => link.getAttribute('href'))";
        let outside = page.texts(&format!("{links}.filter(to => !to.startsWith('#'))"));
        assert!(outside.iter().all(|to| to.starts_with(RULE_PAGES)), "{fixture}: {outside:?}");
        let inside = format!("{links}.filter(to => to.startsWith('#'))");
        let lost = page.texts(&format!("{inside}.filter(to => !document.getElementById(to.slice(1)))"));
        assert_eq!(lost, [""; 0], "{fixture}");
        let twice = "(ids => ids.filter((id, at) => ids.indexOf(id) < at))
            ([...document.querySelectorAll('[id]')].map(of => of.id))";
        assert_eq!(page.texts(twice), [""; 0], "{fixture}");
    }
}

#[test]
fn arrays_are_closed_until_asked_for() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    assert_eq!(page.rows("6000"), [""; 0]);
    assert_eq!(page.rows("1018").len(), 5);
    let summary = "[id='6000'] > summary";
    // beside the link in it
    page.click(&format!("{summary} > span"));
    assert_eq!(page.rows("6000"), ["6000sub0", "6000sub1", "6000sub2"]);
    page.click(&format!("{summary} > span"));
    assert_eq!(page.rows("6000"), [""; 0]);
    page.eval(&format!("document.querySelector(\"{summary}\").focus()"));
    page.press("Enter");
    assert_eq!(page.rows("6000").len(), 3);
    page.press("Space");
    assert_eq!(page.rows("6000"), [""; 0]);
}

#[test]
fn everything_can_be_opened_at_once() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    let closed = "document.querySelectorAll('.o:is(details):not([open])').length";
    assert!(page.number(closed) > 5.0);
    page.click("#expand");
    assert_eq!(page.number(closed), 0.0);
    page.click("#collapse");
    assert!(page.number(closed) > 5.0);
    assert_eq!(page.rows("1018").len(), 5, "records stay");
}

#[test]
fn the_contents_lead_to_the_parts() {
    let Some(page) = Page::open("xdd/press-402.xdd", "") else { return };
    for link in page.texts("[...document.querySelectorAll('nav a')].map(link => link.getAttribute('href'))") {
        page.click(&format!("nav a[href='{link}']"));
        assert_eq!(page.text("location.hash"), link);
        let heading = page.number(&format!(
            "document.querySelector('[id=\"{}\"] :is(h2, h3)').getBoundingClientRect().top",
            &link[1..]
        ));
        let height = page.number("innerHeight");
        assert!((0.0..height).contains(&heading), "{link}: {heading}");
    }
}

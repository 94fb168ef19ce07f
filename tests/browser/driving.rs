//! The browser does what the other tests believe it does, on pages of a few lines: a test that cannot fail proves nothing.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

use serde_json::json;
use tempfile::TempDir;

use crate::tab::{Spoken, Tab};

/// A page with this body in a folder that lives as long as the test.
fn page(folder: &TempDir, body: &str) -> PathBuf {
    let path = folder.path().join("page.html");
    let head = "<!doctype html><html lang=en><meta charset=utf-8><title>A page</title>";
    fs::write(&path, format!("{head}{body}")).unwrap();
    path
}

fn open(body: &str) -> Option<(Tab, TempDir)> {
    let tab = Tab::new()?;
    let folder = tempfile::tempdir().unwrap();
    tab.open(&page(&folder, body), "");
    Some((tab, folder))
}

#[test]
fn expressions_have_values() {
    let Some((tab, _folder)) = open("<p id=a>ä</p>") else { return };
    assert_eq!(tab.eval("({ a: [1, null], b: document.title })"), json!({ "a": [1, null], "b": "A page" }));
    assert_eq!(tab.text("document.querySelector('#a').textContent"), "ä");
    assert_eq!(tab.texts("['a', 'b']"), ["a", "b"]);
    assert_eq!(tab.number("innerWidth"), 1280.0);
    tab.eval("setTimeout(() => window.later = true, 50)");
    tab.wait("window.later === true");
    let thrown = catch_unwind(AssertUnwindSafe(|| tab.eval("missing.member"))).unwrap_err();
    assert!(thrown.downcast_ref::<String>().unwrap().contains("missing is not defined"), "{thrown:?}");
}

#[test]
fn complaints_are_heard() {
    let body = "<script>
        console.log('unremarkable');
        console.warn('doubtful');
        console.error('wrong', 7);
        setTimeout(() => { throw new Error('thrown late') });
        undefinedFunction();
    </script>";
    let Some((tab, folder)) = open(body) else { return };
    let complaints = tab.complaints().join("\n");
    for expected in ["doubtful", "wrong", "thrown late", "undefinedFunction is not defined"] {
        assert!(complaints.contains(expected), "{expected} is not in:\n{complaints}");
    }
    assert!(!complaints.contains("unremarkable"));
    tab.open(&page(&folder, "<script>syntax error</script>"), "");
    assert_eq!(tab.complaints().len(), 1);
    tab.open(&page(&folder, "<p>Nothing wrong</p><script>console.log('unremarkable')</script>"), "");
    assert_eq!(tab.complaints(), [""; 0]);
}

#[test]
fn requests_are_seen() {
    let body = "<img src='data:image/gif;base64,R0lGODlhAQABAAAAACw=' alt=''><img src=missing.png alt=''>
        <script src=http://127.0.0.1:9/script.js></script>";
    let Some((tab, _folder)) = open(body) else { return };
    let requests = tab.requests();
    assert_eq!(requests.len(), 2, "{requests:?}");
    assert!(requests.iter().any(|url| url.ends_with("/missing.png")));
    assert!(requests.iter().any(|url| url == "http://127.0.0.1:9/script.js"));
    assert!(!tab.complaints().is_empty());
}

#[test]
fn keys_and_clicks_are_real() {
    let body = "<style>main { height: 3000px }</style><main><a href=#end>End</a><input id=box>
        <details><summary>More</summary><p id=inside>Inside</p></details></main>
        <button id=end onclick='this.textContent = event.isTrusted'>Press</button>
        <script>addEventListener('keydown', event => { if (event.key == 'Escape') box.value = '' })</script>";
    let Some((tab, _folder)) = open(body) else { return };
    tab.press("Tab");
    assert_eq!(tab.text("document.activeElement.textContent"), "End");
    assert!(tab.is("document.activeElement.matches(':focus-visible')"));
    tab.press("Tab");
    tab.write("0x60Ü");
    assert_eq!(tab.text("box.value"), "0x60Ü");
    tab.press("Backspace");
    assert_eq!(tab.text("box.value"), "0x60");
    tab.press("Escape");
    assert_eq!(tab.text("box.value"), "");
    tab.press("Tab");
    tab.press("Enter");
    assert!(tab.is("inside.checkVisibility()"));
    tab.press("Space");
    assert!(tab.is("!document.querySelector('details').open"));
    tab.press("Shift+Tab");
    assert_eq!(tab.text("document.activeElement.id"), "box");
    tab.click("#end");
    assert_eq!(tab.text("end.textContent"), "true");
    assert!(tab.number("scrollY") > 1000.0);
    tab.click("a");
    assert_eq!(tab.text("location.hash"), "#end");
    let missing = catch_unwind(AssertUnwindSafe(|| tab.click("#missing"))).unwrap_err();
    assert!(missing.downcast_ref::<String>().unwrap().starts_with("#missing is not there"));
}

#[test]
fn fragments_are_places() {
    let body = "<style>p { margin-top: 3000px }</style><p id=far>Far</p>";
    let Some((tab, folder)) = open(body) else { return };
    let path = page(&folder, body);
    tab.open(&path, "far");
    assert!(tab.number("scrollY") > 1000.0);
    assert_eq!(tab.text("document.querySelector(':target').id"), "far");
    tab.open(&path, "");
    assert_eq!(tab.number("scrollY"), 0.0);
}

#[test]
fn windows_and_media_can_be_chosen() {
    let body = "<style>
        p { width: 600px; color: black }
        @media (prefers-color-scheme: dark) { p { color: white } }
        @media print { p { color: red } }
    </style><p>Text</p>";
    let Some((tab, _folder)) = open(body) else { return };
    let overflows = "document.scrollingElement.scrollWidth > document.scrollingElement.clientWidth";
    let colour = "getComputedStyle(document.querySelector('p')).color";
    assert!(!tab.is(overflows));
    tab.resize(400, 800);
    assert!(tab.is(overflows));
    assert_eq!(tab.text(colour), "rgb(0, 0, 0)");
    tab.medium("screen", "dark");
    assert_eq!(tab.text(colour), "rgb(255, 255, 255)");
    tab.medium("print", "light");
    assert_eq!(tab.text(colour), "rgb(255, 0, 0)");
}

#[test]
fn scripts_can_be_switched_off() {
    let Some(tab) = Tab::new() else { return };
    let folder = tempfile::tempdir().unwrap();
    let path = page(&folder, "<noscript>none</noscript><script>document.title = 'changed'</script>");
    tab.without_script();
    tab.open(&path, "");
    assert_eq!(tab.text("document.title"), "A page");
}

#[test]
fn pages_become_pictures_and_paper() {
    let body =
        "<style>p { height: 2000px; margin: 0 } * + p { break-before: page }</style><p>One</p><p>Two</p>";
    let Some((tab, _folder)) = open(body) else { return };
    tab.resize(320, 200);
    assert_eq!(png_size(&tab.screenshot(false)), (320, 200));
    let (width, height) = png_size(&tab.screenshot(true));
    assert_eq!(width, 320);
    assert!(height > 4000, "{height}");
    assert!(tab.pdf().starts_with(b"%PDF-"));
}

fn png_size(png: &[u8]) -> (u32, u32) {
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}

#[test]
fn screen_readers_get_it() {
    let body =
        "<header><h1>Title</h1></header><main><h3>Below</h3><svg role=img aria-label=Bits></svg></main>";
    let Some((tab, _folder)) = open(body) else { return };
    let spoken = tab.spoken();
    let said = |role: &str, name: &str, level| Spoken { role: role.into(), name: name.into(), level };
    for expected in [
        said("banner", "", None),
        said("heading", "Title", Some(1)),
        said("main", "", None),
        said("heading", "Below", Some(3)),
        said("image", "Bits", None),
    ] {
        assert!(spoken.contains(&expected), "{expected:?} is not in {spoken:#?}");
    }
}

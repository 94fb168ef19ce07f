//! Texts of a description stay texts.

use std::fs;

use crate::page::{Page, make};
use crate::support::RULE_PAGES;
use crate::tab::Tab;

/// What would run or leave its place if anything did.
const NAMES: [&str; 12] = [
    "<script>window.hacked = 1</script>",
    "</script><script>window.hacked = 2</script>",
    "<img src=x onerror=window.hacked=3>",
    "\"><svg onload=window.hacked=4>",
    "' onmouseover='window.hacked=5",
    "</style></title></textarea><b>bold</b>",
    "<!-- comment",
    "--> ]]> &lt;b&gt; &amp; &#60;i&#62;",
    "| ]]( `code` ``` [link](javascript:window.hacked=6)",
    "javascript:window.hacked=7",
    "nul \0 and bell \u{7} and \u{202e}turned",
    "{{ 7 * 7 }} {% raw %} ${window.hacked=8}",
];

/// An EDS with the names above, wherever a description has texts.
fn description() -> String {
    let fixture = fs::read_to_string("fixtures/eds/io-401.eds").unwrap();
    let mut names = NAMES.iter().cycle();
    let mut text = String::new();
    for line in fixture.lines() {
        let keys = ["ParameterName", "VendorName", "ProductName", "OrderCode", "Description", "CreatedBy"];
        match line.split_once('=') {
            Some((key, _)) if keys.contains(&key) || key.starts_with("Line") && key != "Lines" => {
                text.push_str(&format!("{key}={}\n", names.next().unwrap()));
            }
            _ => text.push_str(&format!("{line}\n")),
        }
    }
    text
}

#[test]
fn names_stay_text() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("<b>&'\"><script>window.hacked=0</script>.eds".replace('/', ""));
    fs::write(&path, description()).unwrap();
    for options in [&[][..], &["--title", NAMES[0], "--lang", "de"]] {
        let Some(page) = Page::with(&path, options, "") else { return };
        assert!(page.is("window.hacked === undefined"));
        assert_eq!(page.number("document.scripts.length"), 1.0);
        assert_eq!(page.number("document.querySelectorAll('b:not(.found b), img, i, textarea, [onload], [onmouseover], [onerror]').length"), 0.0);
        let links = page.texts("[...document.links].map(link => link.getAttribute('href'))");
        assert!(links.iter().all(|to| to.starts_with('#') || to.starts_with(RULE_PAGES)), "{links:?}");
        let text = page.text("document.querySelector('#objects').textContent");
        for name in NAMES.iter().filter(|name| !name.contains('\0')) {
            assert!(text.contains(name), "`{name}` is not in the page");
        }
        assert!(!text.contains('\0') && text.contains("nul "), "the character that HTML has not");
        // what reads the page again for the filter must not believe it either
        page.eval("filter.focus()");
        page.write("<script>");
        assert!(!page.objects().is_empty());
        page.click("#expand");
        assert!(page.is("window.hacked === undefined"));
        page.medium("print", "light");
        assert!(page.is("window.hacked === undefined"));
    }
}

/// The policy of a page names its own script and style by their hashes, and Chromium keeps to it.
#[test]
fn a_page_runs_its_own_script_alone() {
    let Some(tab) = Tab::new() else { return };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("page.html");
    make("fixtures/eds/io-401.eds".as_ref(), &[], &path);
    let page = fs::read_to_string(&path).unwrap();
    let foreign = "<script>window.hacked = 1</script><style>body { display: none }</style>\
                   <img src=x onerror=window.hacked=2><header>";
    fs::write(&path, page.replacen("<header>", foreign, 1)).unwrap();
    tab.open(&path, "");
    assert!(tab.is("window.hacked === undefined && getComputedStyle(document.body).display !== 'none'"));
    assert!(tab.is("!document.querySelector('#tools').hidden"), "the page's own script runs");
    assert!(!tab.complaints().is_empty(), "what is refused is said");
}

//! The filter box: what it finds, as one types.

use crate::page::Page;
use crate::support::fixtures;
use crate::tab::Tab;

/// Types into the filter, which is emptied first.
fn type_into_filter(page: &Tab, text: &str) {
    page.eval("filter.focus()");
    page.press("Escape");
    page.write(text);
    page.settle();
}

fn told(page: &Tab) -> String {
    page.text("hits.textContent")
}

#[test]
fn objects_are_found_by_index() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    let all = page.objects();
    assert_eq!(all.len(), 28);
    for text in ["6000", "0x6000", "6000h", "0X6000"] {
        type_into_filter(&page, text);
        assert_eq!(page.objects(), ["6000"], "{text}");
    }
    // as one types
    type_into_filter(&page, "6");
    assert!(page.objects().contains(&"6411".to_owned()));
    page.write("4");
    assert_eq!(page.objects(), ["6401", "6411"]);
    assert!(told(&page).starts_with("2 / 28"), "{}", told(&page));
    page.write("1");
    page.press("Backspace");
    assert_eq!(page.objects(), ["6401", "6411"]);
    page.press("Escape");
    assert_eq!(page.objects(), all);
    assert_eq!(told(&page), "");
}

#[test]
fn entries_are_found_by_sub_index() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    for text in ["6000sub1", "6000:1", "6000:01", "6000.1", "0x6000sub1", "6000h:01"] {
        type_into_filter(&page, text);
        assert_eq!(page.objects(), ["6000"], "{text}");
        assert_eq!(page.rows("6000"), ["6000sub1"], "{text}");
    }
    page.press("Escape");
    assert_eq!(page.rows("6000"), [""; 0], "it is closed again");
    type_into_filter(&page, "1018sub0");
    assert_eq!(page.rows("1018"), ["1018sub0"]);
    page.press("Escape");
    assert_eq!(page.rows("1018").len(), 5, "it stays open");
}

#[test]
fn objects_are_found_by_name_type_and_access() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    let cases: [(&str, &[&str]); 9] = [
        ("heartbeat", &["1016", "1017"]),
        ("HEARTBEAT producer", &["1017"]),
        ("polarity output", &["6202"]),
        ("visible_string", &["1008", "1009", "100A"]),
        ("integer16 rww", &["6411"]),
        ("rww", &["6200", "6411"]),
        ("visible const", &["1008", "1009", "100A"]),
        ("polarity rw", &["6002", "6202"]),
        ("8-bit rww unsigned8", &["6200"]),
    ];
    for (text, expected) in cases {
        type_into_filter(&page, text);
        assert_eq!(page.objects(), expected, "{text}");
        assert!(told(&page).starts_with(&format!("{} / 28", expected.len())), "{text}: {}", told(&page));
    }
    // of an object that is found by an entry only that one is shown
    type_into_filter(&page, "polarity of inputs 9");
    assert_eq!(page.rows("6002"), ["6002sub2"]);
    // access types are words of their own: not every object with `ro` in its name
    type_into_filter(&page, "ro");
    assert!(!page.objects().contains(&"1017".to_owned()), "`Producer` is not access `ro`");
}

#[test]
fn an_empty_result_is_reported() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    for text in ["nowhere", "\\", "(", "[*", "6000 heartbeat"] {
        type_into_filter(&page, text);
        assert_eq!(page.objects(), [""; 0], "{text}");
        assert_eq!(told(&page), page.text("hits.dataset.none"), "{text}");
    }
    assert!(page.is("[...document.querySelectorAll('.area')].every(area => !area.checkVisibility())"));
    page.press("Escape");
    assert_eq!(page.objects().len(), 28);
    assert!(page.is("[...document.querySelectorAll('.area')].every(area => area.checkVisibility())"));
    // what changes is said to those who do not see it
    assert!(page.spoken().iter().any(|spoken| spoken.role == "status"));
}

#[test]
fn a_slash_leads_to_the_filter() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    page.press("/");
    page.write("6/");
    assert_eq!(page.text("filter.value"), "6/");
}

#[test]
fn names_of_the_file_are_found_though_others_are_shown() {
    let german = Page::with(&fixtures().join("xdd/press-402.xdd"), &["--lang", "de"], "");
    let Some(page) = german else { return };
    for text in ["steuerwort", "controlword"] {
        type_into_filter(&page, text);
        assert_eq!(page.objects(), ["6040"], "{text}");
    }
}

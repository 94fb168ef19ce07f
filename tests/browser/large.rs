//! A device that is as large as they come.

use std::fmt::Write;
use std::fs;
use std::time::Instant;

use crate::page::{Page, make};
use crate::tab::Tab;

/// An EDS of 2 MB with 10,000 entries: records, arrays and variables in the area of the manufacturer.
fn description() -> String {
    let mut text = fs::read_to_string("fixtures/eds/minimal.eds").unwrap();
    let (start, _) = text.split_once("[ManufacturerObjects]").unwrap();
    text.truncate(start.len());
    let mut objects = String::from("\n[ManufacturerObjects]\nSupportedObjects=1990\n");
    let mut sections = String::new();
    for number in 0..1990 {
        let index = 0x2000 + number;
        writeln!(objects, "{}=0x{index:04X}", number + 1).unwrap();
        let entry = |section: &str, name: &str, data_type: u8, access: &str| {
            let range = "LowLimit=0\nHighLimit=255\n";
            format!(
                "\n[{section}]\nParameterName={name}\nObjectType=0x7\nDataType=0x{data_type:04X}\nAccessType={access}\n{range}DefaultValue=0x{:02X}\nPDOMapping=1\nObjFlags=0x0\n;{:-<60}\n",
                number % 256,
                ""
            )
        };
        if number % 4 == 0 {
            sections.push_str(&entry(&format!("{index:04X}"), &format!("Setting {number}"), 5, "rww"));
            continue;
        }
        let (kind, object_type) = if number % 4 == 1 { ("Record", 9) } else { ("Channels", 8) };
        write!(
            sections,
            "\n[{index:04X}]\nParameterName={kind} {number}\nObjectType=0x{object_type:X}\nSubNumber=7\n\
            \n[{index:04X}sub0]\nParameterName=Highest sub-index supported\nObjectType=0x7\nDataType=0x0005\nAccessType=const\nDefaultValue=6\nPDOMapping=0\n"
        )
        .unwrap();
        for sub in 1..=6 {
            let name = format!("{kind} {number}, channel {sub}, threshold of the upper band");
            sections.push_str(&entry(&format!("{index:04X}sub{sub:X}"), &name, 5, "rww"));
        }
    }
    text + &objects + &sections
}

#[test]
fn a_large_device_is_filtered() {
    let Some(tab) = Tab::new() else { return };
    let folder = tempfile::tempdir().unwrap();
    let (source, path) = (folder.path().join("large.eds"), folder.path().join("page.html"));
    let text = description();
    assert!(text.len() > 2_000_000, "{}", text.len());
    fs::write(&source, text).unwrap();
    make(&source, &[], &path);
    let begin = Instant::now();
    tab.open(&path, "");
    let opened = begin.elapsed();
    assert!(tab.number("document.querySelectorAll('.o:not(details), tbody tr').length") > 10_000.0);
    tab.eval(
        "window.tasks = []; new PerformanceObserver(list => tasks.push(...list.getEntries().map(of => of.duration)))
            .observe({ type: 'longtask', buffered: true })",
    );
    let longest = |tab: &Tab| {
        tab.settle();
        tab.number("(longest => (tasks.length = 0, longest))(Math.max(0, ...tasks))")
    };
    let size = fs::metadata(&path).unwrap().len();
    println!("{size} bytes opened in {opened:?}, longest task {} ms", longest(&tab));
    tab.eval("filter.focus()");
    for (keys, hits) in
        [("2100", 1), ("threshold", 1492), ("rww channel 3", 1492), ("setting 1988", 1), ("nowhere", 0)]
    {
        tab.press("Escape");
        println!("Escape: longest task {} ms", longest(&tab));
        for key in keys.chars() {
            let begin = Instant::now();
            tab.press(&key.to_string());
            println!("{key:?}: painted after {:?}, longest task {} ms", begin.elapsed(), longest(&tab));
        }
        let found = "document.querySelectorAll('.o:not([hidden])').length";
        assert_eq!(tab.number(found), f64::from(hits), "{keys}");
    }
    tab.press("Escape");
    tab.click("#expand");
    println!("expand all: longest task {} ms", longest(&tab));
    tab.open(&path, "27C5sub3");
    tab.wait("scrollY > 0");
    assert!(tab.is("(box => box.top >= 0 && box.bottom <= innerHeight)(document.getElementById('27C5sub3').getBoundingClientRect())"));
    assert_eq!(tab.complaints(), [""; 0]);
}

#[test]
fn the_page_of_a_large_device_is_small() {
    let Some(page) = Page::open("eds/minimal.eds", "") else { return };
    let size = fs::metadata(&page.path).unwrap().len();
    assert!(size < 60_000, "{size} bytes before there is anything to say");
}

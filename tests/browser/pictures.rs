//! The pictures of the README and of docs/guides/decode.md, made anew by `OBJDICT_SCREENSHOTS=docs/images cargo test --test browser pictures`.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::bus_page::DRIVE_LOG;
use crate::page::Page;
use crate::tab::Tab;

/// Wide enough for the contents beside the page, narrow enough to be read where the README shows it.
const WIDTH: u32 = 1180;

#[test]
fn pictures_are_made_where_they_are_wanted() {
    let Some(folder) = env::var_os("OBJDICT_SCREENSHOTS").map(PathBuf::from) else { return };
    fs::create_dir_all(&folder).unwrap();

    let Some(page) = Page::open("dcf/drive-402-node8.dcf", "") else { return };
    page.resize(WIDTH, 1060);
    page.medium("screen", "light");
    page.eval("document.querySelector('#pdos h2').scrollIntoView()");
    save(&page, &folder.join("page-light.png"));

    let Some(page) = Page::open("dcf/drive-402-node8.dcf", "") else { return };
    page.resize(WIDTH, 640);
    page.medium("screen", "dark");
    page.click("#filter");
    page.write("position");
    page.eval("document.querySelector('#objects h2').scrollIntoView()");
    page.settle();
    save(&page, &folder.join("page-dark.png"));

    let Some(tab) = Tab::new() else { return };
    tab.resize(WIDTH, 820);
    let page = Page::of_logs(tab, &DRIVE_LOG);
    page.medium("screen", "light");
    page.drag(".plot:nth-of-type(3) .area", 0.58, 0.58);
    page.eval("scrollTo(0, 0)");
    save(&page, &folder.join("traffic.png"));
}

/// Writes what the window shows, with a palette where `pngquant` makes one: a third of the bytes.
fn save(page: &Page, path: &Path) {
    page.settle();
    fs::write(path, page.screenshot(false)).unwrap();
    let palette = ["--force", "--skip-if-larger", "--ext", ".png", "64"];
    let _ = Command::new("pngquant").args(palette).arg(path).status();
}

//! The button that copies what names or reads an entry.

use crate::page::Page;
use crate::support::fixtures;

/// What the button offers at an entry.
fn offered(page: &Page, id: &str) -> Vec<String> {
    page.eval(&format!(
        "document.getElementById('{id}').dispatchEvent(new PointerEvent('pointerover', {{ bubbles: true }}));
         document.getElementById('copy').click()"
    ));
    let offered = page.texts("[...document.querySelectorAll('#copies code')].map(of => of.textContent)");
    page.eval("document.getElementById('copies').hidePopover()");
    offered
}

#[test]
fn an_entry_is_named_and_read() {
    let options = ["--node-id", "5"];
    let Some(page) = Page::with(&fixtures().join("eds/io-401.eds"), &options, "") else { return };
    assert_eq!(
        offered(&page, "1000"),
        ["1000:00", "605#4000100000000000", "OD_DEVICE_TYPE", "od::DEVICE_TYPE"]
    );
    assert_eq!(
        offered(&page, "1018sub1"),
        ["1018:01", "605#4018100100000000", "OD_IDENTITY_OBJECT_VENDOR_ID", "od::identity_object::VENDOR_ID"]
    );
    assert_eq!(offered(&page, "1018"), ["1018", "OD_IDENTITY_OBJECT", "od::identity_object::INDEX"]);
    page.press("Escape");
    page.eval("document.querySelector('[id=\"6000\"] a').focus()");
    page.press("Tab");
    assert_eq!(page.text("document.activeElement.id"), "copy");
}

#[test]
fn without_a_node_the_can_id_is_open() {
    let Some(page) = Page::open("eds/io-401.eds", "") else { return };
    assert_eq!(offered(&page, "6000sub1")[1], "6xx#4000600100000000");
}

//! Abort codes and their meanings.

use objdict_device::Abort;

#[test]
fn codes_of_the_standard_have_names_and_all_others_are_kept() {
    for code in [0x0503_0000, 0x0504_0005, 0x0601_0002, 0x0602_0000, 0x0604_0042, 0x060A_0023, 0x0800_0024] {
        let abort = Abort::from(code);
        assert!(!matches!(abort, Abort::Other(_)), "{abort}");
        assert_eq!(u32::from(abort), code);
    }
    assert_eq!(Abort::from(0x0800_0025), Abort::Other(0x0800_0025));
    assert_eq!(Abort::Other(7).code(), 7);
}

#[test]
fn an_error_shows_the_code_and_its_meaning() {
    let error: &dyn core::error::Error = &Abort::ReadOnly;
    assert_eq!(error.to_string(), "SDO abort 06010002h: attempt to write a read-only entry");
    assert_eq!(Abort::Other(1).to_string(), "SDO abort 00000001h: unknown abort code");
}

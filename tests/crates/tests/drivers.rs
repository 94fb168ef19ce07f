//! The features of `objdict-device`: frames of a driver, by way of `embedded-can`, and values that threads share.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use objdict_device::{Frame, Shared};
use socketcan::{CanDataFrame, CanFrame, EmbeddedFrame, ExtendedId, StandardId};

#[test]
fn frames_come_from_a_driver_and_go_to_it() {
    let id = StandardId::new(0x605).unwrap();
    let driven: CanFrame = EmbeddedFrame::new(id, &[1, 2, 3]).unwrap();
    let frame = Frame::from_driver(&driven).unwrap();
    assert_eq!(Some(frame), Frame::new(0x605, &[1, 2, 3]));
    let back: CanDataFrame = frame.to_driver().unwrap();
    assert_eq!((back.id(), back.data()), (id.into(), &[1, 2, 3][..]));
}

#[test]
fn remote_frames_and_long_identifiers_are_left_out() {
    let remote: CanFrame = EmbeddedFrame::new_remote(StandardId::new(0x605).unwrap(), 8).unwrap();
    let long: CanFrame = EmbeddedFrame::new(ExtendedId::new(0x605).unwrap(), &[1]).unwrap();
    assert_eq!([Frame::from_driver(&remote), Frame::from_driver(&long)], [None, None]);
}

#[test]
fn interrupts_and_the_main_program_share_values() {
    static COUNT: Shared<u32> = Shared::new(0);
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| (0..1000).for_each(|_| COUNT.with(|count| *count += 1).unwrap()));
        }
    });
    assert_eq!(COUNT.with(|count| (*count, COUNT.with(|_| ()))), Some((4000, None)));
}

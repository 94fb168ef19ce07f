//! Values of all types survive a round trip through serde.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use serde::Serialize;
use serde::de::DeserializeOwned;

include!(concat!(env!("OUT_DIR"), "/serde.rs"));

/// Compares bytes after a round trip, because some REAL values are not equal to themselves.
fn round<T: Serialize + DeserializeOwned>(values: T) {
    let bytes = postcard::to_stdvec(&values).unwrap();
    let back: T = postcard::from_bytes(&bytes).unwrap();
    assert_eq!(postcard::to_stdvec(&back).unwrap(), bytes);
}

#[test]
fn values_come_back() {
    assert!(DEVICES.len() > 5);
    for (name, round) in DEVICES {
        for node_id in [1, 5, 127] {
            eprintln!("{name}");
            round(node_id);
        }
    }
}

#[test]
fn values_are_lists_of_numbers() {
    let mut data = minimal::Data::new(5);
    data.put(minimal::PRODUCER_HEARTBEAT_TIME, 250);
    let json = serde_json::to_string(&data).unwrap();
    // index, sub-index, number of bytes, bytes
    assert!(json.starts_with("[5,4096,0,4,0,0,0,0,") && json.contains(",4119,0,2,250,0,"), "{json}");
    assert_eq!(serde_json::from_str::<minimal::Data>(&json).unwrap(), data);
    let some = serde_json::from_str::<minimal::Data>("[9,4119,0,2,7,0]").unwrap();
    assert_eq!((some.node_id(), some.get(minimal::PRODUCER_HEARTBEAT_TIME)), (9, 7));
}

#[test]
fn what_the_table_cannot_hold_is_refused() {
    for json in [
        "[]",
        "[300]",
        "[5,4119]",
        "[5,4119,0,2,7]",
        "[5,4119,0,1,7]",
        "[5,4119,0,3,7,0,0]",
        "[5,16384,0,1,0]",
        "[5,4104,0,1,65]",
    ] {
        assert!(serde_json::from_str::<minimal::Data>(json).is_err(), "{json}");
    }
}

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
fn values_are_people_s_in_json() {
    let mut data = minimal::Data::new(5);
    data.producer_heartbeat_time = 250;
    let json = serde_json::to_string(&data).unwrap();
    assert!(json.contains("\"producer_heartbeat_time\":250"), "{json}");
    assert_eq!(serde_json::from_str::<minimal::Data>(&json).unwrap(), data);
    let mut data = odd::Data::new(5);
    data.texts[0].set(b"hello").unwrap();
    data.all[200] = 77;
    let bytes = postcard::to_stdvec(&data).unwrap();
    let back: odd::Data = postcard::from_bytes(&bytes).unwrap();
    assert_eq!((back.texts[0].as_slice(), back.all[200]), (&b"hello"[..], 77));
}

#[test]
fn too_many_bytes_are_refused() {
    let json = serde_json::to_string(&odd::Octets::<3>::new(b"abc")).unwrap();
    assert_eq!(json, "[97,98,99]");
    assert!(serde_json::from_str::<odd::Octets<3>>(&json).is_ok());
    let error = serde_json::from_str::<odd::Octets<2>>(&json).unwrap_err();
    assert!(error.to_string().contains("at most 2 bytes"), "{error}");
}

//! A session with the node: what a client asks, and what goes over the bus. `examples/session.txt` is what it prints.

use climate_sensor::{Node, Sdo, od};

fn main() {
    let mut node = Node::new(od::NODE_ID);
    node.measure(231, 455);
    let requests: [(&str, Sdo); 11] = [
        ("vendor-ID", [0x40, 0x18, 0x10, 0x01, 0, 0, 0, 0]),
        ("heartbeat", [0x40, 0x17, 0x10, 0x00, 0, 0, 0, 0]),
        ("heartbeat is 500", [0x2B, 0x17, 0x10, 0x00, 0xF4, 0x01, 0, 0]),
        ("heartbeat", [0x40, 0x17, 0x10, 0x00, 0, 0, 0, 0]),
        ("temperature", [0x40, 0x00, 0x20, 0x01, 0, 0, 0, 0]),
        ("temperature is read only", [0x2B, 0x00, 0x20, 0x01, 0, 0, 0, 0]),
        ("limit above its limit", [0x2B, 0x10, 0x20, 0x02, 0x53, 0x03, 0, 0]),
        ("one byte of two", [0x2F, 0x10, 0x20, 0x02, 0x14, 0, 0, 0]),
        ("no such object", [0x40, 0x00, 0x30, 0x00, 0, 0, 0, 0]),
        ("no such sub-index", [0x40, 0x00, 0x20, 0x07, 0, 0, 0, 0]),
        ("limit is 20.0", [0x2B, 0x10, 0x20, 0x02, 0xC8, 0x00, 0, 0]),
    ];
    for (what, request) in requests {
        print(what, request.as_slice());
        let answer = node.answer(request);
        print("", answer.as_ref().map_or(&[], Sdo::as_slice));
    }
    send(&node);
    node.measure(231, 455);
    send(&node);
    node.measure(-250, 990);
    send(&node);
}

fn send(node: &Node) {
    if let Some(frame) = node.tpdo1() {
        print(&format!("TPDO 1, CAN-ID {:03X}", frame.id), &frame.data);
    }
}

fn print(what: &str, bytes: &[u8]) {
    let bytes: String = bytes.iter().map(|byte| format!(" {byte:02X}")).collect();
    println!("{what:<25}{bytes}");
}

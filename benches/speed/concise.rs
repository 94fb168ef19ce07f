//! Packing a device of 2,000 entries into a concise DCF, taking the stream apart, and playing it against the dictionary; beside
//! it copying the stream, which is the least that anybody does with it.
//!
//! `cargo bench concise`: the ratio of two rows of one run is the figure; absolute ones depend on the machine.

use divan::Bencher;
use divan::counter::ItemsCount;
use objdict::download::{ConciseDcf, PlanOptions, Scope};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};

/// Records of four UNSIGNED32 each, all configured.
fn device(entries: u16) -> Device {
    let mut device = Device::default();
    for number in 0..entries / 4 {
        let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
        let entry = |sub: u8| {
            let mut entry = Entry {
                name: "Position control gain".into(),
                data_type: Some(DataType::UNSIGNED32),
                access: Some(Access::Rw),
                default: Some(Value::Unsigned(0)),
                high_limit: Some(Value::Unsigned(0x7FFF_FFFF)),
                ..Entry::default()
            };
            entry.configured_mut().value = Some(Value::Unsigned(u64::from(number) << 8 | u64::from(sub)));
            entry
        };
        let subs = (1..=4).map(|sub| (sub, entry(sub))).collect();
        device.objects.insert(0x2000 + number, Object { main, subs, ..Object::default() });
    }
    device
}

fn pack(device: &Device) -> Option<Vec<u8>> {
    let options = PlanOptions { scope: Scope::All, ..PlanOptions::default() };
    let plan = ConciseDcf::plan(device, &options).ok()?;
    plan.into_concise(|_| Err(())).ok()?.write().ok()
}

#[divan::bench(args = [2_000, 8_000])]
fn plan_and_write(bencher: Bencher<'_, '_>, entries: u16) {
    let device = device(entries);
    bencher.counter(ItemsCount::new(entries)).bench(|| pack(&device).map_or(0, |stream| stream.len()));
}

#[divan::bench(args = [2_000, 8_000])]
fn parse(bencher: Bencher<'_, '_>, entries: u16) {
    let stream = pack(&device(entries)).unwrap_or_default();
    bencher.counter(ItemsCount::new(entries)).bench(|| ConciseDcf::parse(&stream).is_ok());
}

#[divan::bench(args = [2_000, 8_000])]
fn verify(bencher: Bencher<'_, '_>, entries: u16) {
    let device = device(entries);
    let stream = ConciseDcf::parse(&pack(&device).unwrap_or_default()).unwrap_or_default();
    bencher.counter(ItemsCount::new(entries)).bench(|| stream.verify(&device, Some(5)).is_accepted());
}

#[divan::bench(args = [2_000, 8_000])]
fn copy(bencher: Bencher<'_, '_>, entries: u16) {
    let stream = pack(&device(entries)).unwrap_or_default();
    bencher.counter(ItemsCount::new(entries)).bench(|| divan::black_box(&stream).clone());
}

//! Finding, reading and writing entries in a generated Rust table of 157 entries.
//!
//! `cargo bench lookup`. Each call visits every entry once, in an order without a pattern; `items` is the number
//! of entries a second. tests/generate/bench_table.rs keeps the table up to date.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};

/// The table.
mod od {
    include!("lookup/od.rs"); // and so it stays as the generator wrote it, which `cargo fmt` would not leave it
}

/// All addresses, mixed: 89 has no divisor in common with 157.
fn addresses() -> Vec<(u16, u8)> {
    let count = od::ENTRIES.len();
    (0..count)
        .map(|number| od::ENTRIES[number * 89 % count])
        .map(|entry| (entry.index(), entry.sub()))
        .collect()
}

#[divan::bench]
fn find(bencher: Bencher<'_, '_>) {
    let addresses = addresses();
    bencher.counter(ItemsCount::new(addresses.len())).bench_local(|| {
        for &(index, sub) in &addresses {
            let _ = black_box(od::find(black_box(index), sub));
        }
    });
}

#[divan::bench]
fn find_nothing(bencher: Bencher<'_, '_>) {
    let addresses = addresses();
    bencher.counter(ItemsCount::new(addresses.len())).bench_local(|| {
        for &(index, _) in &addresses {
            let _ = black_box(od::find(black_box(index), 0xF0));
        }
    });
}

#[divan::bench]
fn read(bencher: Bencher<'_, '_>) {
    let addresses = addresses();
    let data = od::Data::new(5);
    bencher.counter(ItemsCount::new(addresses.len())).bench_local(|| {
        let mut buffer = [0; 8];
        for &(index, sub) in &addresses {
            let _ = black_box(data.read(black_box(index), sub, &mut buffer));
        }
    });
}

#[divan::bench]
fn write(bencher: Bencher<'_, '_>) {
    let addresses = addresses();
    let mut data = od::Data::new(5);
    bencher.counter(ItemsCount::new(addresses.len())).bench_local(|| {
        for &(index, sub) in &addresses {
            let _ = black_box(data.write(black_box(index), sub, &[1, 0, 0, 0]));
        }
    });
}

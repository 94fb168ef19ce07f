//! The main loop of a node as a task of embassy, with an asynchronous driver: it sleeps until a frame arrives or something is due.

#![no_std]

use embassy_executor::Spawner;
use embassy_futures::select::{Either, select};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::channel::Channel;
use embassy_time::{Instant, Timer};
use node_embedded::od;
use objdict_device::{Frame, NmtCommand, Received};

/// What the CAN interrupts fill and empty. The driver of a board, such as that of `embassy-stm32`, has `read().await` and
/// `write().await` instead, whose frames `Frame::from_driver` and `Frame::to_driver` convert.
static RECEIVED: Channel<CriticalSectionRawMutex, Frame, 16> = Channel::new();
static TO_SEND: Channel<CriticalSectionRawMutex, Frame, 16> = Channel::new();

/// Starts the task; `main` of the firmware calls it.
pub fn start(spawner: Spawner) {
    spawner.must_spawn(node());
}

fn now() -> u64 {
    Instant::now().as_micros()
}

#[embassy_executor::task]
async fn node() {
    let mut device = od::node::<64, 1>(od::NODE_ID);
    TO_SEND.send(device.boot(now())).await;
    loop {
        let due = device.next(now()).map_or(Instant::MAX, Instant::from_micros);
        if let Either::First(frame) = select(RECEIVED.receive(), Timer::at(due)).await {
            match device.receive(&frame, now()) {
                Received::Answer(answer) => TO_SEND.send(answer).await,
                Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) => {
                    TO_SEND.send(device.boot(now())).await;
                }
                _ => {}
            }
        }
        // here the application works with the values, `device.dictionary`
        device.pdos.request_changed(&mut device.dictionary);
        while let Some(frame) = device.poll(now()) {
            TO_SEND.send(frame).await;
        }
    }
}

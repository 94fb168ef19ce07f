//! The main loop of a node with RTIC: the CAN interrupt and a timer interrupt share it.

#![no_std]

/// The tasks. The interrupts are those of a chip without CAN, which RTIC has for examples; take those of your CAN controller.
#[rtic::app(device = lm3s6965)]
mod app {
    use node_embedded::od;
    use objdict_device::{Frame, NmtCommand, Received};

    /// The time in microseconds, which the timer interrupt counts.
    type Time = u64;

    #[shared]
    struct Shared {
        device: od::Node<64, 1>,
        now: Time,
    }

    #[local]
    struct Local {
        can: Can,
    }

    /// The driver of a board has these two functions, such as those of `embedded_can::nb::Can`.
    pub struct Can;

    impl Can {
        fn receive(&mut self) -> Option<Frame> {
            None
        }

        fn send(&mut self, _: &Frame) {}
    }

    #[init]
    fn init(_: init::Context) -> (Shared, Local) {
        let (mut can, mut device) = (Can, od::node::<64, 1>(od::NODE_ID));
        can.send(&device.boot(0));
        (Shared { device, now: 0 }, Local { can })
    }

    /// Each millisecond: the node sends what is due.
    #[task(binds = TIMER_0A, shared = [now], priority = 2)]
    fn tick(mut context: tick::Context) {
        context.shared.now.lock(|now| *now += 1000);
        rtic::pend(lm3s6965::Interrupt::GPIOA);
    }

    /// Frames have arrived, or something is due.
    #[task(binds = GPIOA, shared = [device, now], local = [can], priority = 1)]
    fn serve(context: serve::Context) {
        let serve::SharedResources { mut device, mut now, .. } = context.shared;
        let (now, can) = (now.lock(|now| *now), context.local.can);
        device.lock(|device| {
            while let Some(frame) = can.receive() {
                match device.receive(&frame, now) {
                    Received::Answer(answer) => can.send(&answer),
                    Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) => {
                        can.send(&device.boot(now));
                    }
                    _ => {}
                }
            }
            // here the application works with the values, `device.dictionary`
            device.pdos.request_changed(&mut device.dictionary);
            while let Some(frame) = device.poll(now) {
                can.send(&frame);
            }
        });
    }
}

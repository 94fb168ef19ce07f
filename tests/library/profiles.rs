//! The documents of CiA as data: conditions, decoding, default mapping, and profiles in TOML.

mod condition {
    use objdict::model::{DataType, Device, Entry, Object, Value};
    use objdict::profile::Condition;

    fn device() -> Device {
        let mut device = Device::default();
        for (index, value) in [(0x1000, 0x0003_0191), (0x6401, 6), (0x6000, 0)] {
            let value = Value::from_integer(value, DataType::UNSIGNED32);
            let main = Entry { default: value, ..Entry::default() };
            device.objects.insert(index, Object { main, ..Object::default() });
        }
        device
    }

    fn holds(text: &str) -> Option<bool> {
        text.parse::<Condition>().unwrap().holds(&device(), 0)
    }

    #[test]
    fn conditions_ask_the_description() {
        assert_eq!(holds("6000h"), Some(true));
        assert_eq!(holds("not 6000h or 6040h"), Some(false));
        assert_eq!(holds("1000h[16] and 1000h[17]"), Some(true));
        assert_eq!(holds("1000h[18]"), Some(false));
        assert_eq!(holds("1000h[16..31] in 1..2, 3"), Some(true));
        assert_eq!(holds("1000h[0..15] = 0x191"), Some(true));
        assert_eq!(holds("6401h:0 > 4"), Some(true));
        assert_eq!(holds("6401 != 6"), Some(false));
        assert_eq!(holds("6000h and (6040h or not 6041h)"), Some(true));
    }

    #[test]
    fn what_the_description_does_not_say_decides_nothing() {
        assert_eq!(holds("6502h[0]"), None);
        assert_eq!(holds("6502h[0] or 6000h"), Some(true));
        assert_eq!(holds("6502h[0] and 6040h"), Some(false));
        assert_eq!(holds("6502h[0] and 6000h"), None);
    }

    #[test]
    fn other_texts_are_no_conditions() {
        let error = |text: &str| text.parse::<Condition>().unwrap_err().to_string();
        assert_eq!(error("6040h and"), "expected an index such as `6040h` at the end of the condition");
        assert_eq!(error("6040h 6041h"), "expected `and`, `or` or the end at `6041h`");
        assert_eq!(error("(6040h"), "expected `)` at the end of the condition");
        assert_eq!(error("16040h"), "expected an index such as `6040h` at `16040h`");
        assert_eq!(error("1000h[70]"), "expected bits from 0 to 63, such as `16` or `16..31` at `70..70`");
        assert_eq!(error(&"not ".repeat(99)), "expected fewer brackets at `not not not not not`");
        assert_eq!(error("6000h > many"), "expected a number at `many`");
    }
}

mod words {
    use objdict::model::Device;
    use objdict::profile::Condition;

    #[test]
    fn conditions_are_sentences() {
        let words = |text: &str| text.parse::<Condition>().unwrap().in_words(&Device::default(), 0);
        assert_eq!(words("6040h"), "6040h is described");
        assert_eq!(words("not 1A00h:2"), "1A00h sub-index 2 is not described");
        assert_eq!(words("1000h[16] and not 1000h[23]"), "1000h bit 16 is set and bit 23 is not");
        assert_eq!(words("6502h[2] or 6502h[8]"), "6502h bit 2 is set or bit 8 is set");
        assert_eq!(words("not 1000h[16..31] in 1..5, 10"), "1000h bits 16 to 31 are not 1 to 5 or 10");
        assert_eq!(words("6401h > 4"), "6401h is at least 5");
        assert_eq!(
            words("6040h and (6041h or not 6060h)"),
            "6040h is described and (6041h is described or 6060h is not described)"
        );
        assert_eq!(
            words("not (6040h or 6041h[0..3] = 0)"),
            "6040h is not described and 6041h bits 0 to 3 are not 0"
        );
    }
}

mod decoding {
    use objdict::model::{DataType, Device, Entry, Object, Value};
    use objdict::profile::{bits, named, of_object, standard};

    #[test]
    fn every_object_of_a_document_has_a_sentence() {
        for profile in standard() {
            for facts in profile.objects() {
                let about = facts.about.unwrap_or_default();
                assert!(about.ends_with('.') && about.len() < 160, "{} {:04X}", profile.group, facts.first);
            }
        }
    }

    #[test]
    fn bits_of_the_profile_come_before_those_for_all_devices() {
        let entry = Entry {
            data_type: Some(DataType::UNSIGNED32),
            default: Some(Value::Unsigned(402)),
            ..Entry::default()
        };
        let mut drive = Device::default();
        drive.objects.insert(0x1000, Object { main: entry, ..Object::default() });
        let names = |device: &Device, index, sub| {
            let documents = of_object(device, index).map(|(_, facts)| facts);
            bits(documents, sub).iter().map(|field| (field.first, field.name)).collect::<Vec<_>>()
        };
        let shown = names(&drive, 0x1000, 0);
        assert_eq!(shown[..2], [(0, "device profile number"), (16, "frequency converter")]);
        assert_eq!(names(&Device::default(), 0x1000, 0)[1], (16, "additional information"));
        assert_eq!(names(&drive, 0x6840, 0)[0], (0, "switch on"));
        assert_eq!(names(&drive, 0x1802, 1)[3], (31, "validity"));
        assert_eq!(of_object(&drive, 0x2040).count(), 0);
    }

    #[test]
    fn words_of_a_drive() {
        let meaning = |index, number| {
            let facts =
                named("402").and_then(|profile| profile.object(index)).and_then(|facts| facts.entry(0));
            facts.and_then(|facts| facts.meaning(number)).unwrap_or_default()
        };
        let shown = meaning(0x6041, 0x0237);
        assert_eq!(shown, "state: operation enabled, voltage enabled, remote");
        assert_eq!(meaning(0x6060, -3), "mode: manufacturer-specific");
        assert_eq!(meaning(0x6060, 8), "mode: cyclic synchronous position");
        assert_eq!(meaning(0x6502, 0x0001_0001), "profile position, of the manufacturer: 1");
        assert_eq!(meaning(0x6502, 0), "no bit is set");
        assert_eq!(meaning(0x607A, 7), "");
    }
}

mod default_mapping {
    use objdict::profile::default_mapping::{Channels, of_channels};

    fn shown(channels: Channels) -> Vec<String> {
        let names = of_channels(&channels).into_iter().map(|pdo| {
            let (first, last) = (pdo.mapped.first().unwrap(), pdo.mapped.last().unwrap());
            let subs = format!("{:02X}-{:02X}", first.sub, last.sub);
            format!("{} {}: {:04X}:{subs}", pdo.kind.name(), pdo.number, first.index)
        });
        names.collect()
    }

    #[test]
    fn the_figures_of_the_default_mapping() {
        let all = Channels { digital_inputs: 8, digital_outputs: 8, analog_inputs: 12, analog_outputs: 12 };
        assert_eq!(
            shown(all),
            [
                "RPDO 1: 6200:01-08",
                "RPDO 2: 6411:01-04",
                "RPDO 3: 6411:05-08",
                "RPDO 4: 6411:09-0C",
                "TPDO 1: 6000:01-08",
                "TPDO 2: 6401:01-04",
                "TPDO 3: 6401:05-08",
                "TPDO 4: 6401:09-0C",
            ]
        );
    }

    #[test]
    fn few_channels_shorten_it_and_many_lengthen_it() {
        assert_eq!(
            shown(Channels { analog_inputs: 5, ..Channels::default() }),
            ["TPDO 2: 6401:01-04", "TPDO 3: 6401:05-05"]
        );
        let many = Channels { digital_outputs: 9, analog_outputs: 13, ..Channels::default() };
        assert_eq!(
            shown(many),
            [
                "RPDO 1: 6200:01-08",
                "RPDO 2: 6411:01-04",
                "RPDO 3: 6411:05-08",
                "RPDO 4: 6411:09-0C",
                "RPDO 5: 6411:0D-0D",
                "RPDO 6: 6200:09-09",
            ]
        );
    }
}

mod machine {
    use objdict::profile::named;

    #[test]
    fn transitions_lead_from_state_to_state() {
        let machine = named("402").unwrap().state_machine().unwrap();
        let is_state = |name: &str| machine.states.iter().any(|(_, state)| *state == name);
        assert_eq!((machine.states.len(), machine.transitions.len()), (8, 17));
        for (number, transition) in (0..).zip(&machine.transitions) {
            assert_eq!(transition.number, number);
            assert!(is_state(transition.to), "{transition:?}");
            assert!(is_state(transition.from) || matches!(number, 0 | 13), "{transition:?}");
        }
        let is_used =
            |name: &str| machine.transitions.iter().any(|of| of.by.split(", ").any(|by| by == name));
        assert!(machine.commands.iter().all(|(_, name)| is_used(name)), "{:?}", machine.commands);
        assert!(machine.commands.iter().all(|(mask, _)| mask.len() == 9), "{:?}", machine.commands);
    }

    #[test]
    fn errors_of_a_drive_have_names() {
        let drive = named("402").unwrap();
        assert_eq!(drive.error(0x8611), Some("following error"));
        assert_eq!(drive.error(0x8612), Some("reference limit"));
        assert_eq!(drive.error(0x5115), Some("low voltage of a supply of the manufacturer"));
        assert_eq!(drive.error(0xFF00), None);
        let codes: Vec<u64> = drive.errors().flat_map(|(codes, _)| codes).collect();
        assert!(codes.is_sorted(), "{codes:X?}");
        assert_eq!(named("401").unwrap().errors().len(), 0);
    }
}

mod mask {
    use objdict::profile::{Values, named};

    #[test]
    fn the_states_of_a_drive_are_masks() {
        let profile = named("402").unwrap();
        let field = profile.object(0x6041).unwrap().entry(0).unwrap().bits().next().unwrap();
        let shown = field.masked();
        let shown: Vec<_> = shown
            .iter()
            .map(|(values, name)| match values {
                Values::Mask(mask) => format!("{mask} {name}"),
                Values::Range(range) => panic!("{range:?} {name}"),
            })
            .collect();
        let states = [
            "x0xx 0000 not ready to switch on",
            "x00x 0111 quick stop active",
            "x0xx 1000 fault",
            "x0xx 1111 fault reaction active",
            "x01x 0001 ready to switch on",
            "x01x 0011 switched on",
            "x01x 0111 operation enabled",
            "x1xx 0000 switch on disabled",
        ];
        assert_eq!(shown, states);
    }

    #[test]
    fn other_values_stay_numbers() {
        let profile = named("402").unwrap();
        let modes = profile.object(0x6060).unwrap().entry(0).unwrap().bits().next().unwrap().masked();
        assert!(modes.iter().all(|(values, _)| matches!(values, Values::Range(_))), "{modes:?}");
    }
}

mod standard {
    use std::collections::BTreeSet;
    use std::path::Path;

    use objdict::model::{Access, Device};
    use objdict::profile::{Need, Profile, named};

    #[test]
    fn constants_are_what_the_documents_say() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/objdict-profile/data");
        for constant in objdict::profile::standard() {
            let group = constant.group;
            let text = std::fs::read_to_string(folder.join(format!("{group}.toml"))).unwrap();
            let profile = Profile::from_toml(&text).unwrap_or_else(|error| {
                let line = error.span.map(|span| text[..span.start as usize].lines().count());
                panic!("{group}.toml:{}: {}", line.unwrap_or_default(), error.message)
            });
            let is_same = Profile { group, ..profile } == *constant;
            assert!(is_same, "{group}.toml has changed: run `cargo xtask profiles`");
            assert!(constant.objects().len() > 0, "{group}");
            let number = group.strip_prefix("cia").unwrap();
            assert_eq!(&*constant.document, format!("CiA {number}"));
            assert_eq!(named(number).map(|found| found.group), Some(group));
        }
        assert_eq!(std::fs::read_dir(folder).unwrap().count(), objdict::profile::standard().count());
    }

    /// `fixtures/objects.csv` was collected apart from the data: a difference is a mistake in one of them. What the data accept in
    /// addition, because editions or real devices differ, is behind a `+`.
    #[test]
    fn types_and_access_are_those_of_the_object_tables() {
        let table = std::fs::read_to_string(crate::support::fixtures().join("objects.csv")).unwrap();
        let plain = |access: Access| match access {
            Access::Const => Access::Ro,
            Access::Rwr | Access::Rww => Access::Rw,
            access => access,
        };
        let names = |cell: &str| cell.split(['|', '+']).map(str::to_owned).collect::<BTreeSet<_>>();
        let mut wrong = Vec::new();
        for line in table.lines().skip(1) {
            let [document, index, sub, types, access] = line.split(',').collect::<Vec<_>>()[..] else {
                panic!("{line}");
            };
            let (index, sub) =
                (u16::from_str_radix(index, 16).unwrap(), u8::from_str_radix(sub, 16).unwrap());
            let profile = named(document).unwrap();
            let Some(entry) = profile.object(index).and_then(|object| object.entry(sub)) else {
                wrong.push(format!("{line}: no entry"));
                continue;
            };
            let found: BTreeSet<_> = entry.data_types.iter().map(ToString::to_string).collect();
            if !types.is_empty() && names(types) != found {
                wrong.push(format!("{line}: {found:?}"));
            }
            let found: BTreeSet<_> = entry.access.iter().map(|&found| plain(found).to_string()).collect();
            if !access.is_empty() && names(access) != found {
                wrong.push(format!("{line}: {found:?}"));
            }
        }
        assert!(table.lines().count() > 600 && wrong.is_empty(), "{}", wrong.join("\n"));
    }

    #[test]
    fn a_device_without_management_needs_no_document_about_it() {
        let profile = named("302").unwrap();
        assert!(profile.objects().all(|facts| matches!(facts.first, 0x102A | 0x1F00..=0x1FFF)));
        let bare = Device::default();
        assert!(profile.objects().all(|facts| !facts.is_demanded(&bare, 0)));
    }

    #[test]
    fn objects_are_found_by_index() {
        let profile = named("301").unwrap();
        for facts in profile.objects() {
            for index in [facts.first, facts.last] {
                assert_eq!(profile.object(index).map(|found| found.first), Some(facts.first));
            }
            assert_eq!(facts.entry(0).map(|entry| entry.first), Some(0), "{:04X}", facts.first);
            assert!(facts.entry(0xFF).is_none());
        }
        for index in [0, 0xFFF, 0x1004, 0x101F, 0x1300, 0x1C00, 0x2000, 0xFFFF] {
            assert!(profile.object(index).is_none(), "{index:04X}");
        }
    }

    #[test]
    fn access_types_that_stand_for_each_other() {
        let profile = named("301").unwrap();
        let access = |index, sub: u8, access| {
            let facts = profile.object(index).and_then(|facts| facts.entry(sub));
            facts.map(|facts| facts.accepts_access(access))
        };
        assert_eq!(access(0x1018, 1, Access::Const), Some(true));
        assert_eq!(access(0x1018, 1, Access::Rw), Some(false));
        assert_eq!(access(0x1600, 1, Access::Rww), Some(true));
        assert_eq!(access(0x1600, 1, Access::Wo), Some(false));
        assert_eq!(access(0x1800, 4, Access::Wo), Some(true));
    }

    #[test]
    fn every_device_has_three_objects() {
        let profile = named("301").unwrap();
        let needed = profile.objects().filter(|facts| facts.need == Need::Mandatory);
        assert_eq!(needed.map(|facts| facts.first).collect::<Vec<_>>(), [0x1000, 0x1001, 0x1018]);
    }
}

mod toml {
    use objdict::model::{DataType, ObjectType, Value};
    use objdict::profile::{Need, Profile};

    const HEAD: &str = "document = \"Q\"\ntitle = \"drives\"\n";

    #[test]
    fn a_profile_is_read() {
        let text = r#"
[[object]]
index = 0x2100
name = "Torque"
need = "if 2000h"
data-type = ["INTEGER16", "INTEGER32"]
access = "rw"
mapping = "rpdo"
values = [0, [100, 200]]
default = -1

[[object]]
index = 0x2000
last = 0x200F
name = "Phase"
object-type = "RECORD"
need = "mandatory"
entries = [
    { sub = 0, data-type = "UNSIGNED8", access = "const", values = [[1, 3]] },
    { sub = 1, last = 3, name = "State", bits = [{ at = [0, 1], name = "mode", values = { 0 = "off", "1..3" = "on" } }] },
]
"#;
        let profile = Profile::from_toml(&format!("{HEAD}{text}")).unwrap();
        assert_eq!(profile.group, "custom");
        let phase = profile.object(0x2007).unwrap();
        assert_eq!((phase.need, phase.object_type()), (Need::Mandatory, ObjectType::Record));
        let state = phase.entry(2).unwrap();
        assert_eq!(state.bits().next().and_then(|field| field.meaning(0b110)), Some("on"));
        assert!(phase.entry(4).is_none());
        let torque = profile.object(0x2100).unwrap().entry(0).unwrap();
        assert_eq!(torque.default, Some(&Value::Signed(-1)));
        assert!(torque.accepts_value(150) && !torque.accepts_value(50));
    }

    #[test]
    fn elements_are_short_for_the_entries_of_an_array() {
        let array = |elements: &str| {
            let text = format!(
                "{HEAD}[[object]]\nindex = 0x2000\nname = \"Input\"\nas-many-as = [0x2100]\n\
                 data-type = \"INTEGER16\"\naccess = \"ro\"\nelements = {elements}\n"
            );
            Profile::from_toml(&text)
        };
        let inputs = array("[1, 254]").unwrap();
        let inputs = inputs.object(0x2000).unwrap();
        assert_eq!(inputs.object_types, [ObjectType::Array, ObjectType::Record]);
        assert_eq!(inputs.as_many_as, [0x2100]);
        let subs: Vec<_> = inputs.entries().map(|entry| (entry.first, entry.last)).collect();
        assert_eq!(subs, [(0, 0), (1, 1), (2, 254)]);
        let [count, first, others] = [0, 1, 2].map(|sub| inputs.entry(sub).unwrap());
        assert_eq!((count.values, count.data_types), (&[1..=254][..], &[DataType::UNSIGNED8][..]));
        assert!(first.is_mandatory() && !others.is_mandatory());
        assert_eq!((others.data_types, others.name), (&[DataType::INTEGER16][..], "Input"));
        let first = |elements: &str| {
            let nodes = array(elements).unwrap();
            let first = nodes.object(0x2000).and_then(|nodes| nodes.entry(1)).unwrap();
            (first.is_mandatory(), first.last)
        };
        assert_eq!(first("127"), (true, 127));
        assert_eq!(first("[0, 4]"), (false, 1));
        let message = array("255").unwrap_err().message;
        assert_eq!(message, "`elements` must be a number from 1 to 254, or a minimum and a maximum");
    }

    #[test]
    fn an_error_says_where() {
        let error = |object: &str| {
            let text = format!("{HEAD}[[object]]\nindex = 0x2000\nname = \"x\"\n{object}\n");
            let error = Profile::from_toml(&text).unwrap_err();
            let shown = error.span.map_or("", |span| span.of(&text)).to_owned();
            (error.message, shown)
        };
        let (message, at) = error("data-type = \"UNSIGNED9\"");
        assert!(message.starts_with("`UNSIGNED9` is unknown, expected a data type"), "{message}");
        assert_eq!(at, "\"UNSIGNED9\"");
        let (message, at) = error("need = \"if 2001h and\"");
        assert_eq!(message, "expected an index such as `6040h` at the end of the condition");
        assert_eq!(at, "\"if 2001h and\"");
        let help = |object: &str| {
            let text = format!("{HEAD}[[object]]\nindex = 0x2000\nname = \"x\"\n{object}\n");
            Profile::from_toml(&text).unwrap_err().help.unwrap_or_default()
        };
        assert_eq!(help("data-type = \"UNSINGED16\""), "did you mean `UNSIGNED16`?");
        assert_eq!(help("acess = \"rw\""), "did you mean `access`?");
        assert_eq!(help("need = \"manditory\""), "did you mean `mandatory`?");
        assert_eq!(help("need = \"if 2001h and\""), "");
        let (message, at) = error("colour = 1");
        assert!(message.contains("unknown field `colour`"), "{message}");
        assert_eq!(at, "colour");
        let (message, _) = error("data-type = \"UNSIGNED8\"\ndefault = 300");
        assert_eq!(message, "the default `300` is not a valid UNSIGNED8");
        let (message, _) = error("[[object]]\nindex = 0x2000\nname = \"y\"");
        assert_eq!(message, "2000h is defined twice");
    }
}

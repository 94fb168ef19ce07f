// Executes operations from standard input on the table of od.rs, one per line:
//   i NN            sets all values to the defaults of the node NN
//   r IIII SS NNNN  reads into a buffer of NNNN bytes
//   w IIII SS BYTES writes; `-` for no bytes
//   t               prints the table
// All numbers are hexadecimal. Answers are `ok BYTES` or `abort CODE`, one per line.

mod od {
    include!("od.rs");
}

fn hex(bytes: &[u8]) -> String {
    if bytes.is_empty() {
        return String::from("-");
    }
    bytes.iter().map(|byte| format!("{byte:02X}")).collect()
}

fn bytes(text: &str) -> Vec<u8> {
    let text = text.trim_matches('-');
    (0..text.len() / 2).map(|at| u8::from_str_radix(&text[2 * at..2 * at + 2], 16).unwrap()).collect()
}

fn number(text: &str) -> u32 {
    u32::from_str_radix(text, 16).unwrap()
}

fn table(node_id: u8) {
    let limit = |limit: Option<u64>| limit.map_or(String::from("-"), |limit| format!("{limit:X}"));
    for entry in &od::ENTRIES {
        println!(
            "{:04X} {:02X} {:02X} {}{}{}{}{} {} {} {} {}",
            entry.index(),
            entry.sub(),
            entry.data_type(),
            u8::from(entry.is_readable()),
            u8::from(entry.is_writable()),
            u8::from(entry.fits_tpdo()),
            u8::from(entry.fits_rpdo()),
            u8::from(entry.adds_node_id()),
            entry.size(),
            hex(entry.default_bytes()),
            limit(entry.low_limit(node_id)),
            limit(entry.high_limit(node_id)),
        );
    }
}

const NODE_1: od::Data = od::Data::new(1);

fn main() {
    let mut data = NODE_1;
    for line in std::io::stdin().lines() {
        let line = line.unwrap();
        let words: Vec<&str> = line.split(' ').collect();
        let answer = match words[..] {
            ["i", node_id] => {
                data = od::Data::new(number(node_id) as u8);
                continue;
            }
            ["t"] => {
                table(data.node_id());
                continue;
            }
            ["r", index, sub, size] => {
                let mut buffer = vec![0xEE; number(size) as usize];
                data.read(number(index) as u16, number(sub) as u8, &mut buffer)
                    .map(|length| hex(&buffer[..length]))
            }
            ["w", index, sub, value] => {
                data.write(number(index) as u16, number(sub) as u8, &bytes(value)).map(|()| String::from("-"))
            }
            _ => panic!("{line}"),
        };
        match answer {
            Ok(bytes) => println!("ok {bytes}"),
            Err(abort) => println!("abort {:08X}", abort.code()),
        }
    }
}

use super::*;

/// The frames of a log, one a line: time, channel, CAN-ID, what it is, data; then what is not understood.
pub(super) fn read(log: &[u8]) -> Vec<String> {
    read_in(log, log.len().max(1))
}

pub(super) fn read_in(log: &[u8], buffer: usize) -> Vec<String> {
    let source = io::BufReader::with_capacity(buffer, log);
    let mut reader = LogReader::new(source, LogOptions::default());
    let mut lines = Vec::new();
    while let Some(frame) = reader.next_frame().unwrap() {
        let LoggedFrame { time, can_id, is_extended, .. } = frame;
        let digits: Vec<String> = frame.data().iter().map(|byte| format!("{byte:02X}")).collect();
        let marks = [
            (frame.is_remote, " remote"),
            (frame.is_error, " error"),
            (frame.is_fd, " fd"),
            (frame.is_sent == Some(true), " sent"),
            (frame.is_sent == Some(false), " received"),
        ];
        let marks: String = marks.iter().filter(|(is, _)| *is).map(|(_, mark)| *mark).collect();
        let width = if is_extended { 8 } else { 3 };
        let channel = reader.channel(frame.channel);
        lines.push(format!("{time} {channel} {can_id:0width$X}{marks} {}", digits.join("")));
    }
    lines.extend(reader.bad_lines().iter().map(|bad| format!("line {}: {}", bad.line, bad.reason)));
    assert_eq!(reader.bad_count().min(MAX_BAD_LINES as u64), reader.bad_lines().len() as u64);
    lines
}

#[test]
fn what_people_paste() {
    let messages = b"Timestamp: 1699584944.440580    ID: 0701    S Rx                DL:  1    00                          Channel: can0\n\
        Timestamp: 1699584944.440581    ID: 18eff105    X Tx E R            DL:  8    Channel: can1\n\
        Timestamp: 1699584944.440582    ID: 0fff    S Rx                DL:  1    00\n\
        Timestamp: 1699584944.440583    ID: 0185    S Rx                DL:  2    00\n";
    let expected = [
        "1699584944.440580 can0 701 received 00",
        "1699584944.440581 can1 18EFF105 remote error sent ",
        "line 3: the CAN-ID is not valid",
        "line 4: a byte of the data is missing or not a number",
    ];
    assert_eq!(read(messages), expected);
    let words = b"132.000074  60C  40 02 65 00 00 00 00 00\n\
        132.000419  58C  43 02 65 00 25 02 00 00  node 12: 6502:00 = 25h\n\
        132.000420  can1  080                           SYNC\n\
        132.000420  707  remote                   guarding request to node 7\n\
        132.000420  can1  004                           error frame: controller\n\
        132.000421  can1  00000185  01  ab ad\n\
        132.000422  185  01 x\n\
        132.000423  185  01 02 03 04 05 06 07 08 09\n\
        later  185  01\n";
    let expected = [
        "132.000074  60C 4002650000000000",
        "132.000419  58C 4302650025020000",
        "132.000420 can1 080 ",
        "132.000420  707 remote ",
        "132.000420 can1 004 error ",
        "132.000421 can1 00000185 01",
        "line 7: the data are not bytes in hexadecimal digits",
        "line 8: there are more data than a frame has",
        "line 9: the time is not a number",
    ];
    assert_eq!(read(words), expected);
    let rows = b"Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n\
        166064000,00000701,false,Rx,0,1,00,,,,,,,\n\
        166064001,18EFF105,true,Tx,1,2,01,FF,,,,,,\n\
        166064002,00000701,false,Rx,0,2,00,,,,,,,\n\
        166064003,18EFF105,false,Rx,0,0,,,,,,,,\n";
    let expected = [
        "166.064000 0 701 received 00",
        "166.064001 1 18EFF105 sent 01FF",
        "line 4: a byte of the data is missing or not a number",
        "line 5: the CAN-ID is not valid",
    ];
    assert_eq!(read(rows), expected);
    let former = b"Time Stamp,ID,Extended,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n5,00000701,false,0,1,00,,,,,,,\n";
    assert_eq!(read(former), ["0.000005 0 701 00"]);
}

/// python-can wrote it with containers of 100 bytes, which objects span.
#[test]
fn what_blf_has() {
    let log = std::fs::read("../../fixtures/logs/short.blf").unwrap();
    let expected = [
        "0.000712871 1 705 received 00",
        "0.001812934 1 605 sent 4017100000000000",
        "0.002712965 1 585 received 4B17100064000000",
        "0.005812883 1 185 received 370201",
        "0.102812767 1 705 received 05",
        "0.200712919 2 18EFF105 received 0102",
        "0.210712909 1 705 remote received ",
        "0.220712900 1 000 error ",
        "0.230712890 1 185 fd received 000102030405060708090A0B",
    ];
    assert_eq!(read(&log), expected);
    for buffer in [8, 64] {
        assert_eq!(read_in(&log, buffer), expected, "{buffer}");
    }
    // a file that is cut, and every change of a byte, is read without a panic
    assert_eq!(read(&log[..log.len() - 40]).last().unwrap(), "line 9: the file ends in an object");
    let no_object = [&log[..144], &[b'x'; 40]].concat();
    assert_eq!(read(&no_object), ["line 1: the object is malformed"]);
    for at in 0..log.len() {
        read(&log[..at]);
        let mut other = log.clone();
        other[at] ^= 0x81;
        read(&other);
    }
}

#[test]
fn what_busmaster_logs() {
    let log = b"***BUSMASTER Ver 2.4.0***\n***PROTOCOL CAN***\n***HEX***\n***SYSTEM MODE***\n\
        ***<Time><Tx/Rx><Channel><CAN ID><Type><DLC><DataBytes>***\n\
        10:48:41:6660 Rx 1 0x702 s 1 05 \n10:48:41:7660 Tx 1 0x602 s 8 40 18 10 01 00 00 00 00 \n\
        10:48:41:7670 Rx 2 0x18EFF105 x 1 0A\n10:48:41:7680 Rx 1 0x702 sr 1\nnothing\n***[STOP LOGGING SESSION]***\n";
    let expected = [
        "38921.6660 1 702 received 05",
        "38921.7660 1 602 sent 4018100100000000",
        "38921.7670 2 18EFF105 received 0A",
        "38921.7680 1 702 remote received ",
        "line 10: the time is not a number",
    ];
    assert_eq!(read(log), expected);
    let relative = b"***BUSMASTER Ver 3.2.2***\n***DEC***\n***RELATIVE MODE***\n\
        00:00:00:1000 Rx 1 1794 s 1 127\n00:00:00:0500 Rx 1 1794 s 1 5\n";
    assert_eq!(read(relative), ["0.1000 1 702 received 7F", "0.1500 1 702 received 05"]);
}

#[test]
fn comments_and_frames_alone() {
    let log = b"; written by hand\n# a comment\n// another\n(1.0) can0 702#05\n# in the middle\n(1.1) can0 702#05\n";
    assert_eq!(read(log), ["1.0 can0 702 05", "1.1 can0 702 05"]);
    // of a pipe the lines behind may not be there yet
    assert_eq!(read_in(b"# a comment\n(1.0) can0 702#05\n", 12), ["1.0 can0 702 05"]);
    let words = b"# a comment\n132.000074  60C  40 02\n; another\n";
    assert_eq!(read(words), ["132.000074  60C 4002"]);
    let alone = b"# for cansend\n602#4018100100000000\n582#R\n\n18EFF105#0102\n602#401\n";
    let expected = [
        "0  602 4018100100000000",
        "0  582 remote ",
        "0  18EFF105 0102",
        "line 6: the data are not pairs of hexadecimal digits",
    ];
    assert_eq!(read(alone), expected);
    // the heads of other forms
    assert_eq!(read(b";$FILEVERSION=1.1\n;  1)  0.0  Rx\n"), [""; 0]);
    assert_eq!(read(b"// version 9.0.0\n0.1 1  705  Rx  d 1 05\n"), ["0.1 1 705 received 05"]);
}

#[test]
fn a_capture_of_another_bus_says_which() {
    let head = [0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 1, 0, 0, 0];
    let packet = [1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 0, 0];
    let text = "line 1: the packet is of Ethernet, link type 1, not of SocketCAN (link type 227)";
    assert_eq!(read(&[&head[..], &packet].concat()), [text]);
}

#[test]
fn what_candump_logs() {
    let log = b"(1436509052.249713) can0 18B#0102040811\n\
        (1436509052.249714) can1 00000185#01 R\r\n\
        (1436509052.249715) can0 705#R\n\
        (1436509052.249716) can0 705#R1 T\n\
        (1436509052.249717) can0 185##1000102030405060708\n\
        (1436509052.249718) can0 20000004#0004000000000000\n\
        (1436509052.249719) can0 000#\n\
        \n\
        (1436509052.24972) can0 18B#010\n\
        (1436509052.249721) can0 18#01\n\
        (1436509052.249722) can0 FFF#01\n\
        (1436509052.249723) can0 185#000102030405060708\n\
        nothing\n\
        (1436509052.249724) can0 185#.01.02";
    let expected = [
        "1436509052.249713 can0 18B 0102040811",
        "1436509052.249714 can1 00000185 received 01",
        "1436509052.249715 can0 705 remote ",
        "1436509052.249716 can0 705 remote sent ",
        "1436509052.249717 can0 185 fd 000102030405060708",
        "1436509052.249718 can0 004 error 0004000000000000",
        "1436509052.249719 can0 000 ",
        "1436509052.249724 can0 185 0102",
        "line 9: the data are not pairs of hexadecimal digits",
        "line 10: the CAN-ID is not valid",
        "line 11: the CAN-ID is not valid",
        "line 12: there are more data than a frame has",
        "line 13: there is no frame in the line",
    ];
    assert_eq!(read(log), expected);
    for buffer in 1..64 {
        assert_eq!(read_in(log, buffer), expected, "{buffer}");
    }
}

#[test]
fn what_candump_prints() {
    let log = b"  can0  18B   [5]  01 02 04 08 11\n \
        (2024-02-29 10:31:00.123456)  can0  RX - -  18FEF100   [8]  01 02 03 04 05 06 07 08   '........'\n \
        (2024-05-07 10:31:00.123456)  can0  605   [0]  remote request\n  \
        can0  TX B -  123  [12]  01 02 03 04 05 06 07 08 09 0A 0B 0C\n  \
        can0  20000088   [8]  00 00 00 02 00 00 00 00   ERRORFRAME\n\
        \tprotocol-violation{{tx-recessive-bit-error}{}}\n  \
        can0  185   [2]  01\n";
    let expected = [
        "0 can0 18B 0102040811",
        "1709202660.123456 can0 18FEF100 received 0102030405060708",
        "1715077860.123456 can0 605 remote ",
        "0 can0 123 fd sent 0102030405060708090A0B0C",
        "0 can0 088 error 0000000200000000",
        "line 7: a byte of the data is missing or not a number",
    ];
    assert_eq!(read(log), expected);
}

#[test]
fn times_from_frame_to_frame() {
    let distances =
        b" (000.000000)  can0  080   [0]\n (000.003000)  can0  080   [0]\n (000.001000)  can0  080   [0]\n";
    assert_eq!(read(distances), ["0.000000 can0 080 ", "0.003000 can0 080 ", "0.004000 can0 080 "]);
    let from_start =
        b" (000.000000)  can0  080   [0]\n (000.003000)  can0  080   [0]\n (000.003500)  can0  080   [0]\n";
    assert_eq!(read(from_start)[2], "0.003500 can0 080 ");
    let options = LogOptions { has_distances: Some(true) };
    let times = LogReader::new(&from_start[..], options).map(|frame| frame.unwrap().time.to_string());
    assert_eq!(times.last().as_deref(), Some("0.006500"));
}

#[test]
fn asc() {
    let log = b"date Sat Sep 30 10:06:13.191 PM 2017\n\
        base hex  timestamps absolute\n\
        internal events logged\n\
        // version 9.0.0\n\
        Begin Triggerblock Sat Sep 30 10:06:13.191 PM 2017\n   \
        0.000000 Start of measurement\n   \
        0.015991 CAN 1 Status:chip status error passive - TxErr: 132 RxErr: 0\n   \
        2.501000 1  ErrorFrame\n  \
        17.876976 1  18B             Rx   d 5 01 02 04 08 11  Length = 240015 BitCount = 124 ID = 1785\n  \
        20.105214 2  18EBFF00x       Tx   d 0\n  \
        20.2 1  705  Rx   r 1\n  \
        30.300981 CANFD   3 Tx     50005x                                   0 0 9 12 14 00 00 20 00 50 7A 60 46 50 02 50 130000 130 201000 0 0 0 0 0\n  \
        30.4 CANFD   1 Rx        185  Feedback                          1 0 2  2 01 02 140000 73 200050 7a60\n  \
        31.000000 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%\n  \
        31.1 1  185 Rx d 2 01\n  \
        31.2 what is this\n\
        End TriggerBlock\n";
    let expected = [
        "2.501000 1 000 error ",
        "17.876976 1 18B received 0102040811",
        "20.105214 2 18EBFF00 sent ",
        "20.2 1 705 remote received ",
        "30.300981 3 00050005 fd sent 1400002000507A6046500250",
        "30.4 1 185 received 0102",
        "line 15: a byte of the data is missing or not a number",
        "line 16: the channel is not a number",
    ];
    assert_eq!(read(log), expected);
    let relative = b"base dec  timestamps relative\n 1.0 1 395 Rx d 1 10\n 0.5 1 395 Rx d 1 255\n";
    assert_eq!(read(relative), ["1.0 1 18B received 0A", "1.5 1 18B received FF"]);
}

#[test]
fn trc() {
    let first = b";   Message Number\n     1)      1841  0001  8  00 01 02 03 04 05 06 07 \n     2)     13354  00000401  0\n     3) 2 0705 1 RTR\n     4) 5 FFFFFFFF 4 00 00 00 08\n";
    let expected =
        ["1.841  001 0001020304050607", "13.354  00000401 ", "0.002  705 remote ", "0.005  000 error "];
    assert_eq!(read(first), expected);
    let second = b";$FILEVERSION=1.1\n     1)      1059.9  Rx         0300  2  00 04\n     2) 1060.0 Warng FFFFFFFF 4 00 00 00 08 BUSHEAVY\n";
    assert_eq!(read(second), ["1.0599  300 received 0004"]);
    let third = b";$FILEVERSION=1.3\n 1) 1059.900 2 Tx 0300 - 2 00 04\n";
    assert_eq!(read(third), ["1.059900 2 300 sent 0004"]);
    let fourth = b";$FILEVERSION=2.0\n;$COLUMNS=N,O,T,I,d,l,D\n 1 1059.900 DT 0300 Rx 2 00 04\n 2 1060.000 FB 0301 Rx 12 00 01 02 03 04 05 06 07 08 09 0A 0B\n 3 1061.000 RR 0705 Tx 1\n 4 1062 ST Rx 00 00 00 08\n";
    let expected = [
        "1.059900  300 received 0004",
        "1.060000  301 fd received 000102030405060708090A0B",
        "1.061000  705 remote sent ",
    ];
    assert_eq!(read(fourth), expected);
    let fifth = b";$FILEVERSION=2.1\n;$STARTTIME=43008.920986006946\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n 1 1059.900 DT 1 0300 Rx - 2 00 04\n 2 1060 FD 1 0301 Rx - 9 00 01 02 03 04 05 06 07 08 09 0A 0B\n 3 1061 DT 1 0300 Rx - 2 00\n";
    let expected = [
        "1.059900 1 300 received 0004",
        "1.060 1 301 fd received 000102030405060708090A0B",
        "line 6: a byte of the data is missing or not a number",
    ];
    assert_eq!(read(fifth), expected);
}

#[test]
fn csv_of_python_can() {
    let log = b"timestamp,arbitration_id,extended,remote,error,dlc,data\n1436509052.249713,0x18b,0,0,0,5,AQIECBE=\n0.0,0x18feee00,1,0,0,0,\n5e-05,0x705,0,1,0,1,\n1.5,0x800,0,0,0,0,\n";
    let expected = [
        "1436509052.249713  18B 0102040811",
        "0.0  18FEEE00 ",
        "0.000050000  705 remote ",
        "line 5: the CAN-ID is not valid",
    ];
    assert_eq!(read(log), expected);
}

/// A packet of SocketCAN.
fn packet(id: u32, flags: u8, data: &[u8]) -> Vec<u8> {
    let mut packet = id.to_be_bytes().to_vec();
    packet.extend([data.len() as u8, flags, 0, 0]);
    packet.extend(data);
    packet
}

#[test]
fn packets() {
    let mut log = Vec::new();
    for word in [0xA1B2_3C4D_u32, 0x0004_0002, 0, 0, 65535, 227] {
        log.extend(word.to_be_bytes());
    }
    let packets = [
        packet(0x18B, 0, &[1, 2, 4, 8, 17]),
        packet(0x98FE_EE00, 4, &[0; 12]),
        packet(0x4000_0705, 0, &[]),
        packet(0x2000_0004, 0, &[0; 8]),
        vec![0; 7],
    ];
    for (at, packet) in (0..).zip(&packets) {
        for word in [1_436_509_052_u32, 249_713_000 + at, packet.len() as u32, packet.len() as u32] {
            log.extend(word.to_be_bytes());
        }
        log.extend(packet);
    }
    log.extend([0, 0]);
    let expected = [
        "1436509052.249713000  18B 0102040811",
        "1436509052.249713001  18FEEE00 fd 000000000000000000000000",
        "1436509052.249713002  705 remote ",
        "1436509052.249713003  004 error 0000000000000000",
        "line 5: the packet is too short for a frame",
        "line 6: the file ends in a packet",
    ];
    assert_eq!(read(&log), expected);
    assert_eq!(read_in(&log, 3 + 1), expected);
}

/// A block of pcapng.
fn block(kind: u32, content: &[u8]) -> Vec<u8> {
    let mut content = content.to_vec();
    content.resize(content.len().next_multiple_of(4), 0);
    let length = (content.len() as u32 + 12).to_le_bytes();
    [&kind.to_le_bytes()[..], &length, &content, &length].concat()
}

#[test]
fn blocks() {
    let section = [&0x1A2B_3C4D_u32.to_le_bytes()[..], &[1, 0, 0, 0], &[0xFF; 8]].concat();
    let can = [
        &[227, 0, 0, 0, 0, 0, 0, 0][..],
        &[2, 0, 4, 0],
        b"can0",
        &[9, 0, 1, 0, 9, 0, 0, 0],
        &[14, 0, 8, 0, 10, 0, 0, 0, 0, 0, 0, 0],
        &[0; 4],
    ]
    .concat();
    let ethernet = [1, 0, 0, 0, 0, 0, 0, 0];
    let enhanced = |interface: u32, nanoseconds: u64, packet: &[u8]| {
        let length = packet.len() as u32;
        let words = [interface, (nanoseconds >> 32) as u32, nanoseconds as u32, length, length];
        let mut content: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        content.extend(packet);
        block(6, &content)
    };
    let log = [
        block(0x0A0D_0D0A, &section),
        block(1, &can),
        block(1, &ethernet),
        enhanced(0, 1_436_509_042_249_713_001, &packet(0x18B, 0, &[1, 2, 4, 8, 17])),
        block(5, &[0; 12]),
        enhanced(1, 5, &[0; 60]),
        enhanced(7, 5, &[0; 60]),
    ]
    .concat();
    let expected = [
        "1436509052.249713001 can0 18B 0102040811",
        "line 6: the packet is of Ethernet, link type 1, not of SocketCAN (link type 227)",
        "line 7: the block is malformed",
    ];
    assert_eq!(read(&log), expected);
}

/// A capture of a machine that writes the high byte first.
#[test]
fn blocks_in_big_endian() {
    let block = |kind: u32, content: &[u8]| {
        let length = (content.len() as u32 + 12).to_be_bytes();
        [&kind.to_be_bytes()[..], &length, content, &length].concat()
    };
    let section = [&[0x1A, 0x2B, 0x3C, 0x4D, 0, 1, 0, 0][..], &[0xFF; 8]].concat();
    let can = [
        &[0, 227, 0, 0, 0, 0, 0, 0][..],
        &[0, 2, 0, 4],
        b"can0",
        &[0, 9, 0, 1, 9, 0, 0, 0],
        &[0, 14, 0, 8, 0, 0, 0, 0, 0, 0, 0, 10],
        &[0; 4],
    ]
    .concat();
    let packet = packet(0x18B, 0, &[1, 2, 4, 8, 17]);
    let nanoseconds = 1_436_509_042_249_713_001_u64.to_be_bytes();
    let length = (packet.len() as u32).to_be_bytes();
    let mut enhanced = [&[0; 4][..], &nanoseconds, &length, &length, &packet].concat();
    enhanced.resize(enhanced.len().next_multiple_of(4), 0);
    let log = [block(0x0A0D_0D0A, &section), block(1, &can), block(6, &enhanced)].concat();
    assert_eq!(read(&log), ["1436509052.249713001 can0 18B 0102040811"]);
}

#[test]
fn what_is_no_log_ends() {
    assert_eq!(read(b""), [""; 0]);
    assert_eq!(read(b"[FileInfo]\nFileName=x.eds\n").len(), 2);
    let long = [b"(1.0) can0 185#".as_slice(), &[b'0'; 1 << 16], b"\n(2.0) can0 185#00\n"].concat();
    assert_eq!(read_in(&long, 1 << 10), ["2.0 can0 185 00", "line 1: the line is too long"]);
}

#[test]
fn any_bytes_are_read() {
    let seeds: [&[u8]; 8] = [
        b"(1436509052.249713) can0 18B##10102040811 R\n",
        b"  can0  RX - -  18B   [5]  01 02 04 08 11\n",
        b"base hex  timestamps relative\n 30.4 CANFD 1 Rx 185 N 1 0 2 2 01 02 140000 73 200050 7a60\n",
        b";$FILEVERSION=2.1\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n 1 1059.900 FD 1 0300 Rx - 2 00 04\n",
        b"timestamp,arbitration_id,extended,remote,error,dlc,data\n1436509052.2,0x18b,0,0,0,5,AQIECBE=\n",
        b" (2024-02-29 10:31:00.123456)  can0  605   [0]  remote request\n",
        &[
            0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 227, 0, 0, 0, 1, 0,
            0, 0, 1, 0,
        ],
        &[
            0x0A, 0x0D, 0x0D, 0x0A, 12, 0, 0, 0, 0x4D, 0x3C, 0x2B, 0x1A, 1, 0, 0, 0, 20, 0, 0, 0, 227, 0, 0,
            0, 0, 0, 0, 0,
        ],
    ];
    let mut random = 1_u32;
    for seed in seeds {
        for _ in 0..2000 {
            let mut log = [seed, seed].concat();
            for _ in 0..4 {
                random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let at = (random >> 8) as usize % log.len();
                log[at] =
                    if random & 0x40 == 0 { b" 0.x()#R9\nF-~"[random as usize % 13] } else { random as u8 };
            }
            read_in(&log, 1 + random as usize % 50);
        }
    }
}

//! Tables that spreadsheets write (RFC 4180).

/// The records, each with its line number from 1, delimited as in the first line by commas, semicolons or tabs. Lines
/// that start with `#` are comments.
pub fn records(text: &str) -> Vec<(usize, Vec<String>)> {
    let first = text.lines().find(|line| !is_skipped(line)).unwrap_or_default();
    let separator = [';', '\t'].into_iter().find(|&separator| first.contains(separator)).unwrap_or(',');
    let (mut records, mut record, mut cell, mut is_quoted) = (Vec::new(), Vec::new(), String::new(), false);
    let (mut line, mut start) = (1, 1);
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        line += usize::from(character == '\n');
        match character {
            '"' if is_quoted && characters.peek() == Some(&'"') => {
                cell.push('"');
                characters.next();
            }
            '"' => is_quoted = !is_quoted,
            _ if is_quoted => cell.push(character),
            '\r' => {}
            '\n' => {
                record.push(std::mem::take(&mut cell));
                records.push((start, std::mem::take(&mut record)));
                start = line;
            }
            _ if character == separator => record.push(std::mem::take(&mut cell)),
            _ => cell.push(character),
        }
    }
    record.push(cell);
    records.push((start, record));
    records.retain(|(_, record)| !is_skipped(&record[0]) || record.len() > 1);
    records
}

fn is_skipped(line: &str) -> bool {
    line.trim().is_empty() || line.starts_with('#')
}

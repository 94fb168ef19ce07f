//! The course of a state in bounded memory.

/// The most words; what comes behind them is one of the others.
const MAX_WORDS: usize = 48;

/// The course of a state: how long it has each of its words. When there are too many changes, neighbours become one run that has
/// the words of both, so no word is lost.
#[derive(Clone, Debug)]
pub struct Bands {
    words: Vec<String>,
    runs: Vec<BandRun>,
    capacity: usize,
    /// The most words in a row that a run has.
    room: u64,
    count: u64,
}

/// A time with a word, or with several where there were too many changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BandRun {
    /// When it begins, in nanoseconds.
    pub from: i64,
    /// When it was seen last, in nanoseconds.
    pub to: i64,
    /// The positions of its words, a bit each.
    pub words: u64,
    /// The position of the last word.
    pub last: usize,
    /// How many words there were in a row.
    pub changes: u64,
}

impl Bands {
    /// A course without a word, of at most `capacity` runs; there are at least two.
    pub fn new(capacity: usize) -> Self {
        let capacity = capacity.max(2).next_multiple_of(2);
        Self { words: Vec::new(), runs: Vec::new(), capacity, room: 1, count: 0 }
    }

    /// Adds the word of a time in nanoseconds.
    pub fn add(&mut self, time: i64, word: &str) {
        self.count += 1;
        let last = self.position(word);
        match self.runs.last_mut() {
            Some(run) if run.last == last => run.to = run.to.max(time),
            Some(run) if run.changes < self.room => {
                run.words |= 1 << last;
                (run.last, run.to) = (last, run.to.max(time));
                run.changes += 1;
            }
            _ => {
                if self.runs.len() == self.capacity {
                    self.runs = self.runs.chunks(2).map(BandRun::of_neighbours).collect();
                    self.room *= 2;
                }
                self.runs.push(BandRun { from: time, to: time, words: 1 << last, last, changes: 1 });
            }
        }
    }

    /// Begins with one word that came so many times between two times.
    pub fn begin(&mut self, [from, to]: [i64; 2], word: &str, count: u64) {
        self.add(from, word);
        self.add(to, word);
        self.count = count;
    }

    fn position(&mut self, word: &str) -> usize {
        self.words.iter().position(|known| known == word).unwrap_or_else(|| {
            if self.words.len() < MAX_WORDS {
                self.words.push(word.to_owned());
            } else if self.words.len() == MAX_WORDS {
                self.words.push("others".to_owned());
            }
            self.words.len() - 1
        })
    }

    /// The words in the order in which they came.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// The runs in the order in which they came.
    pub fn runs(&self) -> &[BandRun] {
        &self.runs
    }

    /// How often a word was given.
    pub const fn count(&self) -> u64 {
        self.count
    }

    /// How often the word became another.
    pub fn changes(&self) -> u64 {
        self.runs.iter().map(|run| run.changes).sum::<u64>().saturating_sub(1)
    }
}

impl BandRun {
    /// Whether it has one word.
    pub const fn is_single(&self) -> bool {
        self.words.is_power_of_two()
    }

    fn of_neighbours(pair: &[Self]) -> Self {
        pair[1..].iter().fold(pair[0], |all, later| Self {
            from: all.from.min(later.from),
            to: all.to.max(later.to),
            words: all.words | later.words,
            last: later.last,
            changes: all.changes + later.changes,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_last_until_the_next_one() {
        let mut bands = Bands::new(10);
        for (time, word) in [(0, "stopped"), (5, "stopped"), (9, "operational"), (12, "stopped")] {
            bands.add(time, word);
        }
        assert_eq!(bands.words(), ["stopped", "operational"]);
        let runs: Vec<_> = bands.runs().iter().map(|run| (run.from, run.to, run.last)).collect();
        assert_eq!((runs, bands.changes(), bands.count()), (vec![(0, 5, 0), (9, 9, 1), (12, 12, 0)], 2, 4));
    }

    #[test]
    fn no_word_is_lost() {
        let mut bands = Bands::new(100);
        for number in 0..1_000_000_i64 {
            bands.add(number, if number == 777_777 { "fault" } else { ["on", "off"][(number % 2) as usize] });
        }
        assert!((50..=100).contains(&bands.runs().len()));
        assert_eq!((bands.changes(), bands.words().len()), (999_999, 3));
        let fault = 1 << bands.words().iter().position(|word| word == "fault").unwrap();
        let with: Vec<_> = bands.runs().iter().filter(|run| run.words & fault != 0).collect();
        assert!(with.len() == 1 && with[0].from <= 777_777 && with[0].to >= 777_777 && !with[0].is_single());
    }

    #[test]
    fn words_are_bounded() {
        let mut bands = Bands::new(4);
        (0..1000).for_each(|number| bands.add(number, &number.to_string()));
        assert_eq!((bands.words().len(), bands.words()[MAX_WORDS].as_str()), (MAX_WORDS + 1, "others"));
        assert!(bands.runs().len() <= 4);
    }
}

//! The rows of the table of equations and their tags, read when this crate is compiled.

/// Text of the table of equations: what no doc comment says of them. A row begins with its tag, a remark with `#`.
pub const ROWS: &str = include_str!("rows.txt");

/// Number of equations.
pub(super) const COUNT: usize = {
    let (mut count, mut at) = (0, 0);
    while let Some(row) = next(at) {
        count += 1;
        at = row.end;
    }
    count
};

/// Tags of the equations, in the order of their rows.
pub const TAGS: [&str; COUNT] = {
    let mut tags = [""; COUNT];
    let (mut k, mut at) = (0, 0);
    while let Some(row) = next(at) {
        tags[k] = row.tag;
        k += 1;
        at = row.end;
    }
    tags
};

/// Place of a tag in [`TAGS`].
///
/// # Panics
/// When no equation has the tag; in a constant, as in [`cite!`](crate::cite), this is an error of the compiler.
pub const fn place(tag: &str) -> usize {
    let mut place = 0;
    while !is_same(tag.as_bytes(), TAGS[place].as_bytes()) {
        place += 1;
        assert!(
            place < COUNT,
            "no row of the table of equations has this tag"
        );
    }
    place
}

struct ProvenanceRow {
    tag: &'static str,
    /// Begin of the next line.
    end: usize,
}

/// The first row from the line on that begins at byte `at`.
const fn next(mut at: usize) -> Option<ProvenanceRow> {
    let text = ROWS.as_bytes();
    while at < text.len() {
        let end = behind(b'\n', at);
        if text[at] != b'#' && text[at] != b'\n' {
            let tag = ROWS.split_at(behind(b' ', at) - 1).0.split_at(at).1;
            return Some(ProvenanceRow { tag, end });
        }
        at = end;
    }
    None
}

/// Place behind the first `byte` from `at` on.
const fn behind(byte: u8, mut at: usize) -> usize {
    let text = ROWS.as_bytes();
    while at < text.len() && text[at] != byte {
        at += 1;
    }
    at + 1
}

const fn is_same(one: &[u8], other: &[u8]) -> bool {
    if one.len() != other.len() {
        return false;
    }
    let mut k = 0;
    while k < one.len() {
        if one[k] != other[k] {
            return false;
        }
        k += 1;
    }
    true
}

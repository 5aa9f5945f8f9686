//! Upper bound of the width of text in common fonts, for margins that fit on every machine.

/// Font size of axis names on narrow pages, where letters are largest relative to the drawing.
pub(super) const NAME: f64 = 17.0;
/// Font size of ticks and letters on narrow pages.
pub(super) const TICK: f64 = 15.5;
/// Font size of names in a separate file.
pub(super) const NAME_ALONE: f64 = 12.0;
/// Font size of the bold title in a separate file.
pub(super) const TITLE_ALONE: f64 = 14.0;
/// Height of a line above its base line \[em\], of Noto Sans.
pub(super) const ASCENT: f64 = 1.07;
/// Height of a line below its base line \[em\], of Noto Sans.
pub(super) const DESCENT: f64 = 0.3;

/// Advance widths of the ASCII characters from the space \[em/1000\]: the largest of DejaVu Sans 2.37, Liberation Sans 2.1
/// and Noto Sans 2.2, from the tables `hmtx` of their files.
const ASCII: [u16; 95] = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 551, 838, 318, 361, 318, 372, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 556, 1015, 684, 686, 722, 770, 667,
    611, 778, 752, 339, 500, 667, 557, 907, 760, 787, 667, 787, 722, 667, 611, 732, 684, 989, 685,
    667, 685, 390, 372, 390, 838, 556, 500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 413, 521, 392, 634, 592, 818, 592, 592, 525, 636, 551, 636, 838,
];
/// Width of bold relative to regular text. In these fonts the largest ratio of a letter is 1.24 and of a word 1.15.
const BOLD: f64 = 1.15;

/// Width of `text` in letters of `size` in the widest common font.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let em = |letter: char| match letter {
        ' '..='~' => f64::from(ASCII[letter as usize - ' ' as usize]) / 1000.0,
        // Superscript and subscript digits.
        '⁰'..='⁹' | '²' | '³' | '¹' | '₀'..='₉' => 0.401,
        '⁻' => 0.528,
        '·' => 0.32,
        '°' => 0.5,
        'À'..='ÿ' | 'Ā'..='ſ' | 'Α'..='ω' | 'µ' | '–' | '−' => 0.838,
        _ => 1.0,
    };
    size * text.chars().map(em).sum::<f64>()
}

/// Width of a bold title.
fn bold(text: &str, size: f64) -> f64 {
    BOLD * width(text, size)
}

/// Breaks `text` at spaces into lines of at most `most`; a longer word is a separate line.
fn wrapped(text: &str, most: f64, width: impl Fn(&str) -> f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}")) <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Breaks a name into lines of at most `most` on a narrow page.
pub(super) fn name_lines(name: &str, most: f64) -> Vec<String> {
    wrapped(name, most, |text| width(text, NAME))
}

/// Breaks the title of a separate file into lines of at most `most`.
pub(super) fn title_lines(title: &str, most: f64) -> Vec<String> {
    wrapped(title, most, |text| bold(text, TITLE_ALONE))
}

/// Largest width of `texts` in letters of `size`.
pub(super) fn widest<'a>(texts: impl IntoIterator<Item = &'a str>, size: f64) -> f64 {
    texts
        .into_iter()
        .map(|text| width(text, size))
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_as_wide_as_in_the_widest_font() {
        // DejaVu Sans: 1303/2048 for a digit, 1716/2048 for the minus sign, 651/2048 for the point.
        let em = (2.0 * 1303.0 + 1716.0 + 651.0) / 2048.0;
        assert!((width("−1.5", 10.0) - 10.0 * em).abs() < 0.01);
        assert!(width("Λ*", 10.0) > 10.0 * (1401.0 + 1024.0) / 2048.0);
    }

    #[test]
    fn long_names_are_broken_at_blanks_into_lines_that_fit() {
        let lines = name_lines("load share by Lambda*, dry asperities", 200.0);
        assert_eq!(lines, ["load share by", "Lambda*, dry", "asperities"]);
        assert!(lines.iter().all(|line| width(line, NAME) <= 200.0));
        assert_eq!(name_lines("a-word-that-is-too-long", 20.0).len(), 1);
    }
}

//! Content security policy of a page: only the scripts and the style of the program are permitted, by their SHA-256.
//! Any other script or style in a page is blocked. Images are only drawings of the page itself, on the way to a PNG file.

use sha2::{Digest, Sha256};

use crate::chart;

/// Zoom and read-off of every chart.
pub(super) const CHARTS: &str = include_str!("chart.js");
/// Motion along the path of contact: gears, flanks, and the cursor of all charts.
pub(super) const PATH: &str = concat!(include_str!("player.js"), include_str!("path.js"));
/// Animation of a lubricated contact.
pub(super) const FRAMES: &str = concat!(include_str!("player.js"), include_str!("frames.js"));

/// Style of every page.
pub(super) fn style() -> String {
    format!("{}{}", chart::STYLE, include_str!("page.css"))
}

/// Policy of every page, for the `meta` element of its head.
///
/// ```
/// assert!(!asperity_report::html::policy().contains("unsafe"));
/// ```
#[must_use]
pub fn policy() -> String {
    let scripts = [CHARTS, PATH, FRAMES].map(source).join(" ");
    format!(
        "default-src 'none'; style-src {}; script-src {scripts}; img-src data:; base-uri 'none'; form-action 'none'",
        source(&style())
    )
}

/// Source expression of the inline script or style `text`.
#[must_use]
pub fn source(text: &str) -> String {
    format!("'sha256-{}'", base64(&Sha256::digest(text.as_bytes())))
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for group in bytes.chunks(3) {
        let byte = |k: usize| u32::from(group.get(k).copied().unwrap_or_default());
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let is_padding = digit > group.len();
            let index = bits >> (18 - 6 * digit) & 63;
            text.push(if is_padding {
                '='
            } else {
                char::from(DIGITS[index as usize])
            });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_rfc_4648() {
        for (text, expected) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(text.as_bytes()), expected);
        }
    }

    #[test]
    fn the_sum_of_nothing_is_the_known_one() {
        assert_eq!(
            source(""),
            "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='"
        );
    }
}

//! Text files as a stream of lines, in constant memory.
//!
//! Bytes are read in chunks, decoded, and split at the line end that the head of the file uses. Format, dialect and
//! header are determined from the head. A reader can read the lines again from the start.

use std::io::{ErrorKind, Read, Seek, SeekFrom};

use encoding_rs::Decoder;

use super::encoding;
use super::error::ReadFault;
use super::options::Encoding;

/// Size of the head in bytes: some ten thousand rows.
const HEAD: u64 = 256 << 10;
/// Bytes read at a time.
const CHUNK: usize = 64 << 10;
/// Maximum length of a decoded line in bytes: SDF may have a million heights on one.
const LONGEST_LINE: usize = 16 << 20;

/// Bytes that can be read again from the start.
pub(super) trait Stream: Read + Seek {}

impl<T: Read + Seek> Stream for T {}

/// A line with its number in the file from 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    pub number: usize,
    /// Without its end; a stray CR before CR LF belongs to the end.
    pub text: &'a str,
    /// The line with its end.
    pub whole: &'a str,
}

impl<'a> Line<'a> {
    fn new(number: usize, whole: &'a str) -> Self {
        let text = whole.trim_end_matches(['\r', '\n']);
        Self {
            number,
            text,
            whole,
        }
    }

    /// Whether the line is blank, or a mark for the end of the data: signs of a comment without text.
    pub(super) fn is_blank(&self) -> bool {
        self.text
            .trim_start_matches(|c: char| c == '#' || c.is_whitespace())
            .is_empty()
    }
}

/// The first bytes of a stream and its length.
pub(super) struct Start {
    pub bytes: Vec<u8>,
    pub size: u64,
}

impl Start {
    pub(super) fn read(stream: &mut dyn Stream) -> Result<Self, ReadFault> {
        let mut bytes = Vec::new();
        let size = stream.seek(SeekFrom::End(0))?;
        stream.rewind()?;
        stream.take(HEAD).read_to_end(&mut bytes)?;
        Ok(Self { bytes, size })
    }
}

/// The decoded start of a text: whole lines, all of them when the file is short.
pub(super) struct Head {
    pub text: String,
    end: char,
}

impl Head {
    /// The head that is all of `text`.
    pub(super) fn from_text(text: &str) -> Self {
        let end = if text.contains('\r') && !text.contains('\n') {
            '\r'
        } else {
            '\n'
        };
        Self {
            text: without_filling(text).to_owned(),
            end,
        }
    }

    /// The lines of the head, blank ones too.
    pub(super) fn lines(&self) -> impl Iterator<Item = Line<'_>> {
        let lines = self.text.split_inclusive(self.end).enumerate();
        lines.map(|(at, line)| Line::new(at + 1, line))
    }
}

/// A text file that is read line by line, as often as needed.
pub(super) struct TextSource<'s> {
    pub file: &'s str,
    pub encoding: Encoding,
    stream: &'s mut dyn Stream,
    size: u64,
    end: char,
    /// Whether the encoding was guessed from the head.
    guessed: bool,
    malformed: bool,
}

impl<'s> TextSource<'s> {
    /// The text of a stream with the beginning `start`; a stated encoding overrides the detected one.
    pub(super) fn new(
        file: &'s str,
        stream: &'s mut dyn Stream,
        start: &Start,
        stated: Option<Encoding>,
    ) -> (Head, Self) {
        let whole = start.bytes.len() as u64 >= start.size;
        let known = stated.or_else(|| encoding::by_mark(&start.bytes));
        let encoding = known.unwrap_or_else(|| encoding::guess(&start.bytes, whole));
        let mut decoder = encoding.decoder();
        let mut text = String::new();
        decode(&mut decoder, &start.bytes, &mut text, whole);
        let mut head = Head::from_text(&text);
        if let Some(last) = text.rfind(head.end).filter(|_| !whole) {
            head.text.truncate(last + 1);
        }
        let text = Self {
            file,
            encoding,
            stream,
            size: start.size,
            end: head.end,
            guessed: known.is_none() && encoding == Encoding::Utf8,
            malformed: false,
        };
        (head, text)
    }

    /// Whether later bytes were invalid in the encoding guessed from the head, so that the text is wrong.
    pub(super) fn is_malformed(&self) -> bool {
        self.malformed
    }

    /// The byte that ends a line.
    pub(super) fn line_end(&self) -> u8 {
        self.end as u8
    }

    /// The lines from the start.
    pub(super) fn lines(&mut self) -> Result<TextLines<'_, 's>, ReadFault> {
        self.stream.rewind()?;
        Ok(TextLines {
            decoder: self.encoding.decoder(),
            raw: vec![0; usize::try_from(self.size).map_or(CHUNK, |size| size.min(CHUNK))],
            buffer: String::new(),
            start: 0,
            complete: 0,
            number: 0,
            left: self.size,
            ended: false,
            text: self,
        })
    }
}

/// Text without the zeros and end-of-file marks that fill up its end.
fn without_filling(text: &str) -> &str {
    text.trim_end_matches(['\0', '\u{1a}'])
}

/// Appends the characters of `bytes`; returns whether some bytes were invalid.
fn decode(decoder: &mut Decoder, bytes: &[u8], text: &mut String, last: bool) -> bool {
    // The maximum decoded length, so that a single call decodes all bytes.
    let most = decoder.max_utf8_buffer_length(bytes.len());
    text.reserve(most.unwrap_or(CHUNK));
    decoder.decode_to_string(bytes, text, last).2
}

/// Iteration over lines, from a buffer with a chunk and the incomplete line before it.
pub(super) struct TextLines<'t, 's> {
    text: &'t mut TextSource<'s>,
    decoder: Decoder,
    raw: Vec<u8>,
    buffer: String,
    /// Start of the next line.
    start: usize,
    /// End of the last complete line.
    complete: usize,
    /// Number of lines read.
    number: usize,
    /// Bytes of the stream not yet read.
    left: u64,
    ended: bool,
}

impl TextLines<'_, '_> {
    /// The next line, including blank ones; `None` at the end.
    pub(super) fn next(&mut self) -> Result<Option<Line<'_>>, ReadFault> {
        while self.start == self.complete && !self.ended {
            self.fill()?;
        }
        let rest = &self.buffer[self.start..];
        let length = rest.find(self.text.end).map_or(rest.len(), |at| at + 1);
        if length == 0 {
            return Ok(None);
        }
        let whole = &rest[..length];
        self.start += length;
        self.number += 1;
        Ok(Some(Line::new(self.number, whole)))
    }

    /// The byte that ends a line.
    pub(super) fn end(&self) -> u8 {
        self.text.line_end()
    }

    /// The complete lines in the buffer with their ends; may be empty.
    pub(super) fn at_hand(&self) -> &[u8] {
        self.buffer
            .as_bytes()
            .get(self.start..self.complete)
            .unwrap_or_default()
    }

    /// Skips `lines` lines of `bytes` bytes, which were read from [`at_hand`](Self::at_hand).
    pub(super) fn pass(&mut self, lines: usize, bytes: usize) {
        self.number += lines;
        self.start += bytes;
    }

    /// Appends another chunk to the rest of the buffer, which is the beginning of a line.
    fn fill(&mut self) -> Result<(), ReadFault> {
        self.buffer.drain(..self.start);
        (self.start, self.complete) = (0, 0);
        let before = self.buffer.len();
        if before > LONGEST_LINE {
            return Err(ReadFault::too_large(
                "a line",
                before as u64,
                LONGEST_LINE as u64,
            ));
        }
        let count = self.read()?;
        self.left -= count as u64;
        let bytes = &self.raw[..count];
        let failed = decode(&mut self.decoder, bytes, &mut self.buffer, count == 0);
        self.text.malformed |= failed && self.text.guessed;
        if let Some(last) = self.buffer[before..].rfind(self.text.end) {
            self.complete = before + last + 1;
        }
        if count == 0 || self.text.malformed {
            self.ended = true;
            let length = without_filling(&self.buffer).len();
            self.buffer.truncate(length);
        }
        Ok(())
    }

    fn read(&mut self) -> Result<usize, ReadFault> {
        let most = usize::try_from(self.left).map_or(CHUNK, |left| left.min(self.raw.len()));
        loop {
            match self.text.stream.read(&mut self.raw[..most]) {
                Ok(count) => return Ok(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(source) => return Err(source.into()),
            }
        }
    }
}

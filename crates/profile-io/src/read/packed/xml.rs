//! Traversal of an XML stream: every element with its path, in constant memory.

use std::io::{BufRead, BufReader, Read};

use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::Event;

/// Maximum nesting; the formats have six levels.
const DEEPEST: usize = 32;

/// An element at its end tag.
pub(super) struct Leaf<'a> {
    /// Local names from the root to this element.
    pub path: &'a [String],
    /// Attributes by local name.
    pub attributes: &'a [(String, String)],
    /// Text of the element itself, trimmed.
    pub text: &'a str,
}

impl Leaf<'_> {
    /// Local name of the element.
    pub(super) fn name(&self) -> &str {
        self.path.last().map_or("", String::as_str)
    }

    /// Local name of the enclosing element.
    pub(super) fn parent(&self) -> &str {
        let above = self.path.len().checked_sub(2);
        above.map_or("", |at| self.path[at].as_str())
    }

    /// Value of an attribute.
    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(known, _)| known == name);
        found.map(|(_, value)| value.as_str())
    }
}

/// One open element.
struct OpenElement {
    attributes: Vec<(String, String)>,
    text: String,
}

/// Calls `leaf` for every element at its end tag; false if the XML is malformed or nested too deeply. `leaf` stops the
/// traversal by returning false.
pub(super) fn walk(stream: impl Read, mut leaf: impl FnMut(Leaf<'_>) -> bool) -> bool {
    let mut reader = Reader::from_reader(BufReader::new(stream));
    let mut buffer = Vec::new();
    let mut path: Vec<String> = Vec::new();
    let mut open: Vec<OpenElement> = Vec::new();
    loop {
        buffer.clear();
        match next(&mut reader, &mut buffer) {
            Some(Event::Start(element)) => {
                if path.len() == DEEPEST {
                    return false;
                }
                path.push(element.local_name().as_ref().to_owned());
                open.push(OpenElement {
                    attributes: attributes(&element),
                    text: String::new(),
                });
            }
            Some(Event::Empty(element)) => {
                path.push(element.local_name().as_ref().to_owned());
                let goes_on = leaf(Leaf {
                    path: &path,
                    attributes: &attributes(&element),
                    text: "",
                });
                path.pop();
                if !goes_on {
                    return true;
                }
            }
            Some(Event::Text(text)) => {
                if let Some(last) = open.last_mut() {
                    last.text.push_str(&text);
                }
            }
            Some(Event::CData(text)) => {
                if let Some(last) = open.last_mut() {
                    last.text.push_str(&text);
                }
            }
            // An entity such as &#181; is an event of its own.
            Some(Event::GeneralRef(name)) => {
                if let Some(last) = open.last_mut()
                    && let Ok(text) = unescape(&format!("&{};", &*name))
                {
                    last.text.push_str(&text);
                }
            }
            Some(Event::End(_)) => {
                let Some(last) = open.pop() else {
                    return false;
                };
                let goes_on = leaf(Leaf {
                    path: &path,
                    attributes: &last.attributes,
                    text: last.text.trim(),
                });
                path.pop();
                if !goes_on {
                    return true;
                }
            }
            Some(Event::Eof) => return path.is_empty(),
            Some(_) => {}
            None => return false,
        }
    }
}

fn next<'b, R: BufRead>(reader: &mut Reader<R>, buffer: &'b mut Vec<u8>) -> Option<Event<'b>> {
    reader.read_event_into(buffer).ok()
}

fn attributes(element: &quick_xml::events::BytesStart<'_>) -> Vec<(String, String)> {
    const MOST: usize = 32;
    let known = element.attributes().take(MOST).filter_map(Result::ok);
    known
        .map(|attribute| {
            let name = attribute.key.local_name().as_ref().to_owned();
            let value = unescape(&attribute.value);
            let value = value.unwrap_or_else(|_| attribute.value.clone());
            (name, value.into_owned())
        })
        .collect()
}

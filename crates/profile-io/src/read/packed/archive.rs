//! Members of zip files, with a limit of their unpacked size.
//!
//! A zip of some kilobytes can unpack to gigabytes. Members are streamed, never unpacked as a whole, and limited to a
//! size proportional to their packed size: heights are compressed to about a tenth, a flat trace to a hundredth.

use std::io::{BufReader, Read};

use asperity_core::is_of_system;
use zip::ZipArchive;

use crate::read::areal::held::most_unpacked;
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::text::Stream;

/// Maximum number of members; X3P has four, a workbook some dozens.
const MOST_MEMBERS: usize = 10_000;

/// An opened zip file.
pub(super) struct Archive<'a> {
    format: Format,
    zip: ZipArchive<BufReader<&'a mut dyn Stream>>,
    /// Names by index, empty for files that a system added.
    names: Vec<String>,
    size: u64,
}

impl<'a> Archive<'a> {
    /// Opens the archive of `size` bytes in `stream`.
    pub(super) fn open(
        format: Format,
        stream: &'a mut dyn Stream,
        size: u64,
    ) -> Result<Self, ReadFault> {
        let damaged = || damaged(format, "the zip directory cannot be read", "");
        let zip = ZipArchive::new(BufReader::new(stream)).map_err(|_| damaged())?;
        if zip.len() > MOST_MEMBERS {
            return Err(damaged());
        }
        let names = zip
            .file_names()
            .map(|name| match name {
                Ok(name) if !is_of_system(&name) => name.replace('\\', "/"),
                _ => String::new(),
            })
            .collect();
        Ok(Self {
            format,
            zip,
            names,
            size,
        })
    }

    /// Full name of the member called `name` in the outermost folder.
    pub(super) fn find(&self, name: &str) -> Option<String> {
        let called = |full: &&String| {
            let last = full.rsplit('/').next().unwrap_or_default();
            last.eq_ignore_ascii_case(name)
        };
        let members = self.names.iter().filter(called);
        members
            .min_by_key(|full| full.matches('/').count())
            .cloned()
    }

    /// Whether there is a member with this full name.
    pub(super) fn holds(&self, full: &str) -> bool {
        self.names.iter().any(|name| name == full)
    }

    /// The content of a member.
    pub(super) fn bytes(&mut self, full: &str) -> Result<Vec<u8>, ReadFault> {
        let format = self.format;
        self.read(full, |stream| {
            let mut bytes = Vec::new();
            match stream.read_to_end(&mut bytes) {
                Ok(_) => Ok(bytes),
                Err(_) => Err(damaged(format, "a member cannot be unpacked", full)),
            }
        })
    }

    /// Passes the content of a member to `read`, limited to the permitted size.
    pub(super) fn read<T>(
        &mut self,
        full: &str,
        read: impl FnOnce(&mut Bounded<'_>) -> Result<T, ReadFault>,
    ) -> Result<T, ReadFault> {
        let missing = || damaged(self.format, "a member is missing", full);
        let at = self.names.iter().position(|name| name == full);
        let at = at.ok_or_else(missing)?;
        let unreadable = |_| damaged(self.format, "a member cannot be unpacked", full);
        let member = self.zip.by_index(at).map_err(unreadable)?;
        let packed = member.compressed_size().min(self.size);
        let limit = most_unpacked(packed);
        if member.size() > limit {
            return Err(ReadFault::too_large(
                "an unpacked member",
                member.size(),
                limit,
            ));
        }
        let mut bounded = Bounded {
            inner: Box::new(member),
            left: limit,
            over: false,
        };
        let result = read(&mut bounded);
        if bounded.over {
            return Err(ReadFault::too_large("an unpacked member", limit + 1, limit));
        }
        result
    }
}

/// The content of the member called `name` of the archive in `stream`.
pub(crate) fn member(
    format: Format,
    stream: &mut dyn Stream,
    size: u64,
    name: &str,
) -> Result<Vec<u8>, ReadFault> {
    let mut archive = Archive::open(format, stream, size)?;
    let full = archive.find(name).unwrap_or_else(|| name.to_owned());
    archive.bytes(&full)
}

/// A reader that returns an error when its limit is exceeded.
pub(super) struct Bounded<'a> {
    inner: Box<dyn Read + 'a>,
    left: u64,
    over: bool,
}

impl Read for Bounded<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.inner.read(buffer)?;
        if count as u64 > self.left {
            self.over = true;
            return Err(std::io::Error::other("larger than allowed"));
        }
        self.left -= count as u64;
        Ok(count)
    }
}

/// Format of a zip file by its members: an X3P contains a main.xml, a workbook a folder xl, a PLUX an index.xml and its
/// heights.
pub(crate) fn content(stream: &mut dyn Stream, size: u64) -> Format {
    match Archive::open(Format::Archive, stream, size) {
        Ok(archive) if archive.holds("xl/workbook.xml") => Format::Excel,
        Ok(archive) if archive.holds("content.xml") && archive.holds("mimetype") => Format::Excel,
        Ok(archive) if archive.holds("index.xml") && archive.find("LAYER_0.raw").is_some() => {
            Format::SensofarPlux
        }
        Ok(archive) if archive.find("main.xml").is_some() => Format::X3p,
        _ => Format::Archive,
    }
}

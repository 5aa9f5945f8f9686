//! Files that the page holds, by name.

use std::collections::BTreeMap;
use std::io;

/// Files in memory by their names, which have no folders: a browser tells none.
#[derive(Debug, Clone, Default)]
pub struct Files(BTreeMap<String, Vec<u8>>);

impl Files {
    /// Keeps `bytes` as the file `name`.
    pub fn hold(&mut self, name: &str, bytes: Vec<u8>) {
        self.0.insert(name.to_owned(), bytes);
    }

    /// The file that a case names: as it stands there, or else by the name after its folders.
    ///
    /// # Errors
    /// When there is no such file; the names of those that are there go with it.
    ///
    /// ```
    /// let mut files = asperity_web::Files::default();
    /// files.hold("pinion.csv", vec![1]);
    /// assert_eq!(files.find("../profiles/pinion.csv").unwrap(), [1]);
    /// assert!(files.find("wheel.csv").is_err());
    /// ```
    pub fn find(&self, name: &str) -> io::Result<&[u8]> {
        let bare = name.rsplit(['/', '\\']).next().unwrap_or(name);
        let found = self.0.get(name).or_else(|| self.0.get(bare));
        found.map(Vec::as_slice).ok_or_else(|| {
            let names: Vec<&str> = self.0.keys().map(String::as_str).collect();
            let reason = if names.is_empty() { "no file has been chosen".to_owned() } else { format!("not among the files chosen ({})", names.join(", ")) };
            io::Error::new(io::ErrorKind::NotFound, reason)
        })
    }
}

//! The text of a case file with the places of its keys.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use asperity_core::message::{IN_MEMORY, Place};

/// A case file's text with an index of its keys.
#[derive(Debug, Clone)]
pub struct Source {
    pub(crate) name: String,
    /// Whether the text is JSON, not TOML.
    #[cfg(feature = "case-files")]
    pub(crate) is_json: bool,
    pub(crate) text: String,
    pub(crate) values: BTreeMap<String, Range<usize>>,
    pub(crate) keys: BTreeMap<String, Range<usize>>,
    pub(crate) written: BTreeMap<String, String>,
    /// Symbols and short forms in the text, each with the path of its key.
    pub(crate) symbols: Vec<[String; 2]>,
    /// Keys that were set after the text was read.
    pub(crate) changed: BTreeSet<String>,
    /// The mesh that this is the source of, if the text describes a gear train.
    mesh: Option<Arc<MeshKeys>>,
}

/// Mesh of a gear train, whose keys have other places in the text than those of an ordinary case.
#[derive(Debug, Clone)]
pub(crate) struct MeshKeys {
    /// Name of the mesh, for messages.
    pub name: String,
    /// Tables of the case of the mesh with those of the train; a table follows the tables below it.
    pub tables: Vec<(String, String)>,
}

impl MeshKeys {
    /// The key of the train for `key` of the mesh; `None` if both are the same.
    pub(crate) fn in_train(&self, key: &str) -> Option<String> {
        self.tables.iter().find_map(|(of_mesh, of_train)| {
            let rest = key.strip_prefix(of_mesh.as_str())?;
            (rest.is_empty() || rest.starts_with('.')).then(|| format!("{of_train}{rest}"))
        })
    }
}

impl Source {
    /// The source of a case built in memory: no text, so that places name only keys.
    pub fn in_memory() -> Self {
        Self::without_text(IN_MEMORY)
    }

    /// A source of this name without text, so that places name only keys.
    pub(crate) fn without_text(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            #[cfg(feature = "case-files")]
            is_json: false,
            text: String::new(),
            values: BTreeMap::new(),
            keys: BTreeMap::new(),
            written: BTreeMap::new(),
            symbols: Vec::new(),
            changed: BTreeSet::new(),
            mesh: None,
        }
    }

    /// The source of one mesh of the gear train in this text.
    pub(crate) fn of_mesh(&self, mesh: &Arc<MeshKeys>) -> Self {
        Self {
            mesh: Some(Arc::clone(mesh)),
            ..self.clone()
        }
    }

    /// The key of the gear train for `key` of its mesh; `key` itself if both are the same.
    pub(crate) fn key_in_train(&self, key: Cow<'static, str>) -> Cow<'static, str> {
        let in_train = self.mesh.as_ref().and_then(|mesh| mesh.in_train(&key));
        in_train.map_or(key, Cow::from)
    }

    /// The mesh of a gear train that this is the source of.
    pub(crate) fn mesh(&self) -> Option<&Arc<MeshKeys>> {
        self.mesh.as_ref()
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Name of the file as the user gave it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Every key path in the file: `gears.module`.
    pub fn key_paths(&self) -> impl Iterator<Item = &str> {
        self.keys.keys().map(String::as_str)
    }

    /// Symbols in the text, each with the path of the key that it is read as.
    pub(crate) fn symbols(&self) -> impl Iterator<Item = [&str; 2]> {
        let shown = |pair: &&[String; 2]| !is_within(&pair[1], &pair[0]);
        self.symbols
            .iter()
            .filter(shown)
            .map(|pair| pair.each_ref().map(String::as_str))
    }

    /// Place of the value of `key`; the nearest enclosing table if the key is missing.
    pub fn place_of(&self, key: &str) -> Place {
        self.nearest(&self.values, key)
    }

    /// Place of the name of `key`.
    pub(crate) fn place_of_key(&self, key: &str) -> Place {
        self.nearest(&self.keys, key)
    }

    /// The value of `key` as written in the file; `None` for a table or a missing key.
    pub fn written(&self, key: &str) -> Option<&str> {
        let in_train = self.mesh.as_ref().and_then(|mesh| mesh.in_train(key));
        let key = in_train.as_deref().unwrap_or(key);
        self.written.get(key).map(String::as_str)
    }

    fn nearest(&self, index: &BTreeMap<String, Range<usize>>, key: &str) -> Place {
        let Some(mesh) = &self.mesh else {
            return self.nearest_in(index, key);
        };
        match mesh.in_train(key) {
            Some(in_train) => Place {
                mesh: Some(mesh.name.clone()),
                ..self.nearest_in(index, &in_train).about(key)
            },
            None => self.nearest_in(index, key),
        }
    }

    fn nearest_in(&self, index: &BTreeMap<String, Range<usize>>, key: &str) -> Place {
        if self.changed.iter().any(|changed| is_within(key, changed)) {
            return Place {
                file: format!("{} (changed)", self.name),
                ..self.at_span(None).about(key)
            };
        }
        let mut path = key;
        loop {
            if let Some(span) = index.get(path) {
                return self
                    .at_span((!span.is_empty()).then(|| span.clone()))
                    .about(key);
            }
            match path.rfind('.') {
                Some(at) => path = &path[..at],
                None => return self.at_span(None).about(key),
            }
        }
    }

    pub(crate) fn at_span(&self, span: Option<Range<usize>>) -> Place {
        let before = span.as_ref().and_then(|span| self.text.get(..span.start));
        Place {
            file: self.name.clone(),
            key: None,
            line: before.map(|before| 1 + before.matches('\n').count()),
            column: before
                .map(|before| 1 + before.chars().rev().take_while(|c| *c != '\n').count()),
            span,
            mesh: None,
        }
    }
}

/// Whether `path` is `key` or below it.
pub(crate) fn is_within(path: &str, key: &str) -> bool {
    let rest = path.strip_prefix(key);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

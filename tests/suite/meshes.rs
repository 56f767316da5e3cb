//! The real meshes, which are in a folder next to the repository on some machines, and their manifest.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// One line of the manifest.
pub struct Row {
    pub path: PathBuf,
    columns: HashMap<String, String>,
}

impl Row {
    /// The text in a column.
    pub fn text(&self, column: &str) -> &str {
        &self.columns[column]
    }

    /// The number in a column.
    pub fn number(&self, column: &str) -> usize {
        self.text(column).parse().unwrap_or_else(|_| panic!("{}: {column}", self.name()))
    }

    /// The number of a `key=number` entry in the notes, 0 if there is none.
    pub fn noted(&self, key: &str) -> usize {
        let entries = self.text("notes").split("; ").filter_map(|entry| entry.split_once('='));
        entries.into_iter().find(|(name, _)| *name == key).map_or(0, |(_, value)| value.parse().unwrap())
    }

    pub fn name(&self) -> &str {
        self.text("file")
    }

    pub fn bytes(&self) -> Vec<u8> {
        fs::read(&self.path).unwrap_or_else(|error| panic!("{}: {error}", self.path.display()))
    }
}

fn folder() -> PathBuf {
    std::env::var_os("CREASE_MESHES")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/meshes"), PathBuf::from)
}

/// One file by its name in the manifest; `None`, with a message, if the meshes are not available.
pub fn path(name: &str) -> Option<PathBuf> {
    let path = folder().join(name);
    let there = path.exists();
    if !there {
        println!("skipped: {name} is not at {}", folder().display());
    }
    there.then_some(path)
}

/// The files of a folder with one of these extensions; none, with a message, if the meshes are not available.
pub fn rows(folder: &str, extensions: &[&str]) -> Vec<Row> {
    let meshes = self::folder();
    let Ok(manifest) = fs::read_to_string(meshes.join("MANIFEST.tsv")) else {
        println!("skipped: the real meshes are not at {}", meshes.display());
        return Vec::new();
    };
    let mut lines = manifest.lines().map(|line| line.split('\t'));
    let header: Vec<&str> = lines.next().expect("a manifest has a header").collect();
    let rows = lines.map(|fields| {
        let columns: HashMap<String, String> =
            header.iter().zip(fields).map(|(name, field)| (name.to_string(), field.to_owned())).collect();
        Row { path: meshes.join(&columns["file"]), columns }
    });
    rows.filter(|row| {
        let extension = row.path.extension().and_then(|extension| extension.to_str()).unwrap_or("");
        row.name().starts_with(folder) && extensions.contains(&extension)
    })
    .collect()
}

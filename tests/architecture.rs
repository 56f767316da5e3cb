//! The architecture, as a test: which module may use which, which outside crate belongs where, how long a file
//! may be, and where `unsafe` may stand.
//!
//! The check reads tokens, not types: paths that begin with `crate`, `super` or the name of an outside crate.
//! Unit tests (`#[cfg(test)] mod tests`, last in their file, or a file of its own whose name ends in `tests.rs`) are not
//! held to layers or length.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Every module and its layer. A module uses lower layers only, so modules of one layer do not see each other.
const LAYERS: &[(&str, u32)] = &[
    ("num", 0),
    ("mesh", 1),
    ("text", 1),
    ("surface", 2),
    ("io", 2),
    ("normals", 2),
    ("shade", 2),
    ("quality", 3),
    ("raster", 3),
    ("pipeline", 3),
    ("metric", 4),
    ("artefact", 5),
    ("trade", 5),
    ("plan", 6),
    ("report", 7),
    ("cli", 8),
];

/// The program's own module: in the binary only, and above everything.
const PROGRAM: &str = "cli";

/// Every dependency and the modules that may name it.
const OUTSIDE: &[(&str, &[&str])] = &[
    ("ab_glyph", &["report"]),
    ("anyhow", &["cli"]),
    ("base64", &["io", "report"]),
    ("bevy_mikktspace", &["io"]),
    ("bytemuck", &["num", "mesh", "surface", "io", "normals", "raster"]),
    ("clap", &["cli"]),
    ("clap_complete", &["cli"]),
    ("clap_mangen", &["cli"]),
    ("dashu", &["trade"]),
    ("fast_float2", &["io"]),
    ("fluent_bundle", &["text"]),
    (
        "glam",
        &[
            "num", "mesh", "surface", "io", "normals", "shade", "quality", "raster", "pipeline", "metric",
            "artefact", "trade", "report", "cli",
        ],
    ),
    ("gltf", &["io"]),
    ("ignore", &["cli"]),
    ("image", &["report"]),
    ("indicatif", &["cli"]),
    (
        "libm",
        &[
            "num", "text", "mesh", "surface", "io", "normals", "shade", "quality", "raster", "metric",
            "artefact", "trade", "report",
        ],
    ),
    ("maud", &["report"]),
    ("memchr", &["io"]),
    ("mimalloc", &["cli"]),
    ("png", &["report"]),
    ("pulldown_latex", &["report"]),
    ("pulp", &["num"]),
    (
        "rayon",
        &[
            "mesh", "surface", "io", "normals", "quality", "raster", "pipeline", "metric", "artefact",
            "trade", "cli",
        ],
    ),
    ("rustc_hash", &["mesh", "surface", "io", "normals", "quality", "pipeline"]),
    (
        "serde",
        &[
            "num", "surface", "text", "io", "shade", "raster", "quality", "metric", "artefact", "trade",
            "plan", "report", "cli",
        ],
    ),
    ("serde_json", &["io", "report", "cli"]),
    ("shlex", &["io"]),
    ("spade", &["mesh", "surface"]),
    ("tempfile", &["cli"]),
    (
        "thiserror",
        &[
            "num", "mesh", "surface", "io", "normals", "shade", "raster", "pipeline", "metric", "artefact",
            "report",
        ],
    ),
    ("tobj", &["io"]),
    ("toml", &["raster"]),
    ("zmij", &["io"]),
];

/// Words that no file, type, function, constant or test is named with; CONTRIBUTING.md says what to write.
const NOT_IN_NAMES: &[&str] = &[
    "told", "tells", "odd", "again", "apart", "abroad", "doubts", "beside", "plainly", "nobody", "made_up",
    "bent", "strays", "orbits", "worth", "aslant", "hollows", "reads",
];

/// The longest a file may be, unit tests not counted.
const LONGEST: usize = 400;

#[test]
fn the_source_keeps_its_layers() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    collect(&root.join("src"), &root.join("src"), &mut files);
    assert!(files.len() > 10, "found only {} source files", files.len());
    let found: Vec<String> = files.iter().flat_map(|(path, source)| breaches(path, source)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn no_folder_has_more_than_twenty_files() {
    const MOST: usize = 20;
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    collect(&root.join("src"), &root.join("src"), &mut files);
    let mut counts = BTreeMap::new();
    for (path, _) in &files {
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        *counts.entry(folder).or_insert(0) += 1;
    }
    let crowded: Vec<_> = counts.iter().filter(|&(_, &count)| count > MOST).collect();
    assert!(counts.len() > 20 && crowded.is_empty(), "more than {MOST} files side by side: {crowded:?}");
}

#[test]
fn names_are_the_terms_of_the_field() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let contributing = fs::read_to_string(root.join("CONTRIBUTING.md")).unwrap();
    for word in NOT_IN_NAMES {
        assert!(contributing.contains(word), "CONTRIBUTING.md does not list {word}");
    }
    let mut files = Vec::new();
    for folder in ["src", "tests", "benches"] {
        collect(root, &root.join(folder), &mut files);
    }
    let mut found = Vec::new();
    for (path, source) in &files {
        let stems = path.split('/').map(|part| part.trim_end_matches(".rs").to_owned());
        let names = stems.chain(declared_names(&tokens(source)));
        let words = names.filter_map(|name| Some((forbidden_word(&name)?, name.clone())));
        found.extend(words.map(|(word, name)| format!("{path}: {name} has the word {word}")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    for (name, word) in
        [("is_told", "told"), ("LookAgain", "again"), ("with_made_up", "made_up"), ("ODD", "odd")]
    {
        assert_eq!(forbidden_word(name), Some(word), "{name}");
    }
    assert_eq!(["threads", "bend", "toldyou"].map(forbidden_word), [None; 3]);
}

/// The names that a file declares: functions, types, modules and constants.
fn declared_names(tokens: &[Token]) -> Vec<String> {
    const KEYWORDS: [&str; 8] = ["fn", "struct", "enum", "trait", "type", "mod", "const", "static"];
    let is_keyword = |token: &Token| KEYWORDS.contains(&token.text.as_str());
    tokens.windows(2).filter(move |pair| is_keyword(&pair[0])).map(|pair| pair[1].text.clone()).collect()
}

/// The first word of a name that is not a term: between underscores, or from one capital to the next.
fn forbidden_word(name: &str) -> Option<&'static str> {
    let mut words = String::from("_");
    let mut was_lower = false;
    for c in name.chars() {
        if c.is_uppercase() && was_lower {
            words.push('_');
        }
        was_lower = c.is_lowercase();
        words.extend(c.to_lowercase());
    }
    words.push('_');
    NOT_IN_NAMES.iter().copied().find(|word| words.contains(&format!("_{word}_")))
}

#[test]
fn every_dependency_is_in_the_table() {
    let manifest = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml")).unwrap();
    let declared: BTreeSet<String> = dependencies(&manifest);
    assert!(declared.contains("glam"), "the manifest was not understood: {declared:?}");
    let known: BTreeSet<&str> = OUTSIDE.iter().map(|(name, _)| *name).collect();
    let missing: Vec<&String> = declared.iter().filter(|name| !known.contains(name.as_str())).collect();
    assert!(missing.is_empty(), "in Cargo.toml but not in the table of tests/architecture.rs: {missing:?}");
}

#[test]
fn planted_breaches_are_found() {
    let long = "//\n".repeat(LONGEST + 1);
    let planted: &[(&str, &str, &str)] = &[
        ("mesh/a.rs", "use crate::normals::Weight;", "mesh may not use normals"),
        ("io/obj/mod.rs", "use crate::{mesh::Mesh, normals};", "io may not use normals"),
        ("io/obj/mod.rs", "use super::super::normals::Weight;", "io may not use normals"),
        ("num/mod.rs", "fn f() { let x = super::mesh::Faces::new(); }", "num may not use mesh"),
        ("normals/a.rs", "fn f(x: crate::io::Format) {}", "normals may not use io"),
        ("mesh/a.rs", "use crate::{num, io::{self}};", "mesh may not use io"),
        ("report/a.rs", "use crate::cli::Args;", "report may not use cli"),
        ("report/a.rs", "use crate::nowhere::X;", "nowhere is in no layer"),
        ("elsewhere/a.rs", "", "elsewhere is in no layer"),
        ("normals/a.rs", "use serde_json::Value;", "normals may not name serde_json"),
        ("mesh/a.rs", "fn f() { clap::Parser::parse() }", "mesh may not name clap"),
        ("num/a.rs", "extern crate tobj;", "num may not name tobj"),
        ("num/a.rs", "fn f() { unsafe { g() } }", "unsafe"),
        ("num/a.rs", "#[cfg(test)]\nmod tests { fn f() {} }\nfn after() {}", "tests come last"),
        ("num/a.rs", "#[cfg(test)]\nmod tests { }\nuse crate::mesh;", "num may not use mesh"),
        ("num/a.rs", &long, "401 lines"),
        ("num/a.rs", "mod b_tests;", "declare it under #[cfg(test)]"),
        ("num/b_tests.rs", "fn f() { unsafe { g() } }", "unsafe"),
        ("normals/a.rs", "use dashu::float::FBig;", "normals may not name dashu"),
    ];
    for (path, source, expected) in planted {
        let found = breaches(path, source);
        assert!(found.iter().any(|breach| breach.contains(expected)), "{path}: {source:?} gave {found:?}");
    }
}

#[test]
fn what_is_allowed_passes() {
    let long_tests = format!("fn f() {{}}\n#[cfg(test)]\nmod tests {{\n{}}}\n", "//\n".repeat(LONGEST));
    let allowed: &[(&str, &str)] = &[
        (
            "normals/a.rs",
            "use crate::mesh::Mesh; use crate::num; use super::recipe::Weight; use glam::DVec3;",
        ),
        ("normals/a/b.rs", "use super::super::field; use crate::normals::Weight;"),
        ("lib.rs", "pub mod io; pub use crate::normals::Weight;"),
        ("main.rs", "mod cli; fn main() { crate::cli::main() }"),
        ("cli/a.rs", "use crease::io::Format; use super::args::Args; use crate::cli::output;"),
        (
            "num/a.rs",
            "// use crate::mesh;\n/* unsafe /* nested */ clap:: */ const S: &str = \"crate::mesh\";",
        ),
        ("num/a.rs", "const R: &str = r#\"\"crate::io\"\"#; const C: char = '\"'; fn f<'a>(x: &'a u8) {}"),
        ("num/a.rs", "#![deny(unsafe_code)] mod gltf_like {} fn f() { my::clap::g() }"),
        ("num/a.rs", "fn f() {}\n#[cfg(test)]\nmod tests { use crate::normals; }\n"),
        ("num/a.rs", &long_tests),
        ("num/a.rs", "#[cfg(test)]\nmod b_tests;"),
        ("num/b_tests.rs", "use crate::trade::exact; use dashu::float::FBig;"),
    ];
    for (path, source) in allowed {
        assert_eq!(breaches(path, source), Vec::<String>::new(), "{path}: {source:?}");
    }
}

/// Everything wrong with one file, whose path is relative to `src`.
fn breaches(path: &str, source: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut add = |what: String| found.push(format!("src/{path}: {what}"));
    let tokens = tokens(source);
    let (code, lines) = match split_tests(&tokens) {
        _ if path.ends_with("tests.rs") => (&tokens[..0], 0),
        Tests::None => (&tokens[..], source.lines().count()),
        Tests::Last { start } => (&tokens[..start], tokens[start].line),
        Tests::Inside => {
            add("unit tests come last in a file".into());
            (&tokens[..], source.lines().count())
        }
    };
    if lines > LONGEST {
        add(format!("{lines} lines without tests; {LONGEST} is the most"));
    }
    for name in loose_tests(&tokens) {
        add(format!("mod {name} holds unit tests by its name; declare it under #[cfg(test)]"));
    }
    if tokens.iter().any(|token| token.text == "unsafe") {
        add("there is no unsafe code here".into());
    }
    if path == "lib.rs" {
        return found;
    }
    let module_path = module_path(path);
    let module = module_path[0].as_str();
    let Some(layer) = layer_of(module) else {
        found.push(format!("src/{path}: {module} is in no layer; add it to the table"));
        return found;
    };
    for used in used_modules(code, &module_path) {
        match layer_of(&used) {
            _ if used == module => {}
            None => found.push(format!("src/{path}: {used} is in no layer; add it to the table")),
            Some(other) if other < layer && used != PROGRAM => {}
            Some(_) => found.push(format!("src/{path}: {module} may not use {used}")),
        }
    }
    for used in outside_crates(code) {
        let allowed = OUTSIDE.iter().find(|(name, _)| *name == used).map_or(&[][..], |(_, modules)| modules);
        if !allowed.contains(&module) {
            found.push(format!("src/{path}: {module} may not name {used}"));
        }
    }
    found
}

/// The modules in files of their own that are called tests but are compiled without them.
fn loose_tests(tokens: &[Token]) -> Vec<&str> {
    const HEAD: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];
    let declared = (0..tokens.len()).filter(|&at| is(tokens, at, "mod") && is(tokens, at + 2, ";"));
    let named = declared.filter(|&at| tokens[at + 1].text.ends_with("tests"));
    let is_marked =
        |at: usize| (0..HEAD.len()).all(|k| at >= HEAD.len() && is(tokens, at - HEAD.len() + k, HEAD[k]));
    named.filter(|&at| !is_marked(at)).map(|at| tokens[at + 1].text.as_str()).collect()
}

fn layer_of(module: &str) -> Option<u32> {
    LAYERS.iter().find(|(name, _)| *name == module).map(|(_, layer)| *layer)
}

/// The module that a file is, as a path from the crate's root: `io/obj/mod.rs` is `io::obj`.
fn module_path(path: &str) -> Vec<String> {
    let stem = path.strip_suffix(".rs").unwrap_or(path);
    let stem = stem.strip_suffix("/mod").unwrap_or(stem);
    let stem = if stem == "main" { PROGRAM } else { stem };
    stem.split('/').map(str::to_owned).collect()
}

/// The top-level modules that `crate::…` and `super::…` paths lead to.
fn used_modules(tokens: &[Token], module_path: &[String]) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    let mut at = 0;
    while at < tokens.len() {
        let starts_path = at == 0 || tokens[at - 1].text != "::";
        let mut base = match tokens[at].text.as_str() {
            "crate" if starts_path => Vec::new(),
            "super" if starts_path => module_path[..module_path.len() - 1].to_vec(),
            _ => {
                at += 1;
                continue;
            }
        };
        at += 1;
        while is(tokens, at, "::") && is(tokens, at + 1, "super") {
            base.pop();
            at += 2;
        }
        if !is(tokens, at, "::") {
            continue;
        }
        match base.first() {
            Some(top) => {
                used.insert(top.clone());
            }
            None => used.extend(heads(tokens, at + 1)),
        }
    }
    used
}

/// The first names after `crate::`: one, or those of a group in braces.
fn heads(tokens: &[Token], at: usize) -> Vec<String> {
    if !is(tokens, at, "{") {
        return tokens.get(at).map(|token| token.text.clone()).into_iter().collect();
    }
    let mut names = Vec::new();
    let mut depth = 0;
    for pair in tokens[at..].windows(2) {
        match pair[0].text.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            break;
        }
        if depth == 1 && matches!(pair[0].text.as_str(), "{" | ",") && pair[1].text != "}" {
            names.push(pair[1].text.clone());
        }
    }
    names
}

/// The crates of the table that a path of the code begins with.
fn outside_crates(tokens: &[Token]) -> BTreeSet<&'static str> {
    let mut used = BTreeSet::new();
    for (at, token) in tokens.iter().enumerate() {
        let Some((name, _)) = OUTSIDE.iter().find(|(name, _)| *name == token.text) else { continue };
        let continues_path = at >= 2 && is(tokens, at - 1, "::") && tokens[at - 2].is_name();
        let after_use = at >= 1 && (is(tokens, at - 1, "use") || is(tokens, at - 1, "crate"));
        if !continues_path && (is(tokens, at + 1, "::") || after_use) {
            used.insert(*name);
        }
    }
    used
}

fn is(tokens: &[Token], at: usize, text: &str) -> bool {
    tokens.get(at).is_some_and(|token| token.text == text)
}

/// Where a file keeps its unit tests.
enum Tests {
    None,
    /// In a module that ends the file and begins with this token.
    Last {
        start: usize,
    },
    /// Followed by other code.
    Inside,
}

fn split_tests(tokens: &[Token]) -> Tests {
    const HEAD: [&str; 8] = ["#", "[", "cfg", "(", "test", ")", "]", "mod"];
    let start =
        tokens.windows(HEAD.len()).position(|w| w.iter().zip(HEAD).all(|(token, text)| token.text == text));
    let Some(start) = start.filter(|&start| is(tokens, start + HEAD.len() + 1, "{")) else {
        return Tests::None;
    };
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate().skip(start + HEAD.len()) {
        match token.text.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ => continue,
        }
        if depth == 0 {
            return if at + 1 == tokens.len() { Tests::Last { start } } else { Tests::Inside };
        }
    }
    Tests::Inside
}

/// A name, `::`, or one character of anything else.
struct Token {
    text: String,
    /// Counted from 0.
    line: usize,
}

impl Token {
    fn is_name(&self) -> bool {
        self.text.starts_with(|c: char| c.is_alphabetic() || c == '_')
    }
}

/// Rust source as tokens, without comments, literals and lifetimes.
fn tokens(source: &str) -> Vec<Token> {
    let chars: Vec<char> = source.chars().collect();
    let mut tokens = Vec::new();
    let (mut at, mut line) = (0, 0);
    while at < chars.len() {
        let end = skip(&chars, at);
        if end > at {
            line += chars[at..end].iter().filter(|&&c| c == '\n').count();
            at = end;
            continue;
        }
        let start = at;
        at += 1;
        if is_word(chars[start]) {
            while at < chars.len() && is_word(chars[at]) {
                at += 1;
            }
        } else if chars[start] == ':' && chars.get(at) == Some(&':') {
            at += 1;
        }
        tokens.push(Token { text: chars[start..at].iter().collect(), line });
    }
    tokens
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The end of the blank, comment, literal or lifetime that starts here; `at` itself if none does.
fn skip(chars: &[char], at: usize) -> usize {
    let next = chars.get(at + 1).copied().unwrap_or('\0');
    let find =
        |from: usize, stop: char| (from..chars.len()).find(|&i| chars[i] == stop).unwrap_or(chars.len());
    match chars[at] {
        c if c.is_whitespace() => at + 1,
        '/' if next == '/' => find(at, '\n'),
        '/' if next == '*' => {
            let (mut depth, mut end) = (0, at);
            while end + 1 < chars.len() {
                match (chars[end], chars[end + 1]) {
                    ('/', '*') => (depth, end) = (depth + 1, end + 2),
                    ('*', '/') => (depth, end) = (depth - 1, end + 2),
                    _ => end += 1,
                }
                if depth == 0 {
                    return end;
                }
            }
            chars.len()
        }
        '"' => quoted(chars, at + 1, '"'),
        'r' | 'b' if at == 0 || !is_word(chars[at - 1]) => {
            let raw = at + usize::from(chars[at] == 'b' && next == 'r');
            let hashes = chars[raw + 1..].iter().take_while(|&&c| c == '#').count();
            if chars[raw] == 'r' && chars.get(raw + 1 + hashes) == Some(&'"') {
                let body = raw + 2 + hashes;
                let closes =
                    |i: usize| chars[i] == '"' && (1..=hashes).all(|k| chars.get(i + k) == Some(&'#'));
                return (body..chars.len()).find(|&i| closes(i)).map_or(chars.len(), |i| i + 1 + hashes);
            }
            match next {
                '"' if chars[at] == 'b' => quoted(chars, at + 2, '"'),
                '\'' if chars[at] == 'b' => quoted(chars, at + 2, '\''),
                _ => at,
            }
        }
        '\'' if next == '\\' || chars.get(at + 2) == Some(&'\'') => quoted(chars, at + 1, '\''),
        '\'' => (at + 1..chars.len()).find(|&i| !is_word(chars[i])).unwrap_or(chars.len()),
        _ => at,
    }
}

/// The end of a literal whose content starts here.
fn quoted(chars: &[char], mut at: usize, quote: char) -> usize {
    while at < chars.len() && chars[at] != quote {
        at += if chars[at] == '\\' { 2 } else { 1 };
    }
    (at + 1).min(chars.len())
}

/// The names in the manifest's `[dependencies]`, as Rust spells them.
fn dependencies(manifest: &str) -> BTreeSet<String> {
    let section = manifest.split("\n[dependencies]\n").nth(1).unwrap_or("");
    let section = section.split("\n[").next().unwrap_or("");
    section.lines().filter_map(|line| Some(line.split_once('=')?.0.trim().replace('-', "_"))).collect()
}

fn collect(root: &Path, folder: &Path, files: &mut Vec<(String, String)>) {
    let mut entries: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            collect(root, &path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let name = path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
            files.push((name, fs::read_to_string(&path).unwrap()));
        }
    }
}

//! The architecture, as a test: which module may use which, which outside crate belongs where, how long a file
//! may be, and where `unsafe` may stand.
//!
//! The check reads tokens, not types: paths that begin with `crate`, `super` or the name of an outside crate.
//! Unit tests (`#[cfg(test)] mod tests`, last in their file, or a file of its own whose name ends in `tests.rs`) are not
//! held to layers or length.

mod imports;
mod source;

use source::{PROGRAM, Tests, Token, collect, is, module_path, split_tests, tokens};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

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
    ("dashu_base", &["trade"]),
    ("dashu_float", &["trade"]),
    ("draco_core", &["io"]),
    ("fast_float2", &["io"]),
    ("flate2", &["io"]),
    ("fluent_bundle", &["text"]),
    (
        "glam",
        &[
            "num", "mesh", "surface", "io", "normals", "shade", "quality", "raster", "pipeline", "metric",
            "artefact", "trade", "plan", "report", "cli",
        ],
    ),
    ("gltf", &["io"]),
    ("image", &["report"]),
    ("indicatif", &["cli"]),
    (
        "libm",
        &[
            "num", "text", "mesh", "surface", "io", "normals", "shade", "quality", "raster", "metric",
            "artefact", "trade", "plan", "report",
        ],
    ),
    ("maud", &["report"]),
    ("memchr", &["io"]),
    ("meshoptimizer_rs", &["io"]),
    ("mimalloc", &["cli"]),
    ("png", &["report"]),
    ("pulldown_latex", &["report"]),
    ("pulp", &["num"]),
    (
        "rayon",
        &[
            "num", "mesh", "surface", "io", "normals", "quality", "raster", "pipeline", "metric", "artefact",
            "trade", "cli",
        ],
    ),
    ("rustc_hash", &["mesh", "surface", "io", "normals", "quality", "pipeline", "report"]),
    (
        "serde",
        &[
            "text", "num", "mesh", "surface", "normals", "io", "shade", "raster", "quality", "pipeline",
            "metric", "artefact", "trade", "plan", "report", "cli",
        ],
    ),
    ("serde_json", &["io", "report", "cli"]),
    ("shlex", &["io"]),
    ("spade", &["mesh", "surface"]),
    ("strsim", &["cli"]),
    ("tempfile", &["cli"]),
    ("walkdir", &["cli"]),
    ("xxhash_rust", &["cli"]),
    (
        "thiserror",
        &[
            "num", "mesh", "surface", "io", "normals", "shade", "quality", "raster", "pipeline", "metric",
            "artefact", "plan", "report",
        ],
    ),
    ("quick_xml", &["io"]),
    ("tobj", &["io"]),
    ("zip", &["io"]),
    ("toml", &["raster"]),
    ("toml_edit", &["plan"]),
    ("zmij", &["io"]),
    // In the manifest for their features only.
    ("num_complex", &[]),
    ("once_cell", &[]),
];

/// Words that no file, type, function, constant or test is named with, from the list in CONTRIBUTING.md.
static NOT_IN_NAMES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("CONTRIBUTING.md")).unwrap();
    let (_, list) =
        page.split_once("- No name of a file, type, function, constant or test has: ").expect("the list");
    list.split_once('.')
        .expect("the end of the list")
        .0
        .split(',')
        .map(|word| word.trim().to_owned())
        .collect()
});

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
    assert!(NOT_IN_NAMES.len() >= 18, "{:?}", *NOT_IN_NAMES);
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

#[test]
fn files_do_not_import_each_other_in_a_circle() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    collect(&root, &root, &mut files);
    let found = imports::loops(&files);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn planted_import_loops_are_found() {
    let find = |sources: &[(&str, &str)]| {
        let owned: Vec<_> =
            sources.iter().map(|(path, source)| ((*path).to_owned(), (*source).to_owned())).collect();
        imports::loops(&owned)
    };
    let a = ("io/a.rs", "use super::b::B; pub struct A;");
    let looped: &[&[(&str, &str)]] = &[
        &[a, ("io/b.rs", "use super::a::A; pub struct B;")],
        &[a, ("io/b.rs", "pub struct B; fn f(_: crate::io::a::A) {}")],
        &[a, ("io/b.rs", "use super::a; pub struct B; fn f(_: a::A) {}")],
        // Through a re-export, to the file that defines the item.
        &[a, ("io/mod.rs", "mod a; mod b; pub use a::A;"), ("io/b.rs", "use super::A; pub struct B;")],
        // A folder's own code, and a file in it that uses this code.
        &[("io/mod.rs", "mod a; use a::A; pub struct M;"), ("io/a.rs", "use super::M; pub struct A;")],
        &[("io/mod.rs", "mod a; fn f() { a::g() } pub struct M;"), ("io/a.rs", "use super::{M}; fn g() {}")],
    ];
    for sources in looped {
        assert_eq!(find(sources).len(), 1, "{sources:?}");
    }
    let straight: &[&[(&str, &str)]] = &[
        &[a, ("io/b.rs", "pub struct B;"), ("io/mod.rs", "mod a; mod b; pub use a::A; pub use b::B;")],
        &[a, ("io/b.rs", "pub struct B;\n#[cfg(test)]\nmod tests { use super::super::a::A; }")],
        &[a, ("io/b.rs", "pub struct B; // super::a::A")],
        // Layers hold between modules.
        &[("io/a.rs", "use crate::mesh::b::B;"), ("mesh/b.rs", "use crate::io::a::A;")],
    ];
    for sources in straight {
        assert_eq!(find(sources), Vec::<String>::new(), "{sources:?}");
    }
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
    NOT_IN_NAMES.iter().map(String::as_str).find(|word| words.contains(&format!("_{word}_")))
}

#[test]
fn every_dependency_is_in_the_table() {
    let manifest = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml")).unwrap();
    let declared: BTreeSet<String> = dependencies(&manifest);
    assert!(declared.contains("glam"), "the manifest was not understood: {declared:?}");
    let known: BTreeSet<&str> = OUTSIDE.iter().map(|(name, _)| *name).collect();
    let missing: Vec<&String> = declared.iter().filter(|name| !known.contains(name.as_str())).collect();
    assert!(
        missing.is_empty(),
        "in Cargo.toml but not in the table of tests/architecture/main.rs: {missing:?}"
    );
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
        ("normals/a.rs", "use dashu_float::FBig;", "normals may not name dashu_float"),
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
        ("num/b_tests.rs", "use crate::trade::exact; use dashu_float::FBig;"),
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

/// The names in the manifest's `[dependencies]`, as Rust spells them.
fn dependencies(manifest: &str) -> BTreeSet<String> {
    let section = manifest.split("\n[dependencies]\n").nth(1).unwrap_or("");
    let section = section.split("\n[").next().unwrap_or("");
    section.lines().filter_map(|line| Some(line.split_once('=')?.0.trim().replace('-', "_"))).collect()
}

//! The graph of imports between source files, and its loops.
//!
//! An import points to the file that defines the item: re-exports are followed, and `mod` and `pub use` make no edge of
//! their own. Only edges within one top-level module count; between modules the layers already forbid loops.

use crate::source::{PROGRAM, Tests, Token, is, module_path, split_tests, tokens};
use std::collections::{BTreeMap, BTreeSet};

/// A path of names from the crate's root.
type Names = Vec<String>;

/// What one file declares and uses.
struct File {
    path: String,
    module: Names,
    /// The names that `use` brings in, public or not, with their full paths.
    imports: BTreeMap<String, Names>,
    /// The modules whose items it takes by `use …::*`.
    globs: Vec<Names>,
    /// Full paths that its code depends on.
    used: BTreeSet<Names>,
}

/// The loops between the files of each module: every strongly connected set of two or more files, with the edges in it.
pub fn loops(sources: &[(String, String)]) -> Vec<String> {
    let modules: BTreeSet<Names> = sources.iter().map(|(path, _)| module_path(path)).collect();
    let files: BTreeMap<Names, File> =
        sources.iter().map(|(path, source)| (module_path(path), parse(path, source, &modules))).collect();
    let mut edges: BTreeMap<&Names, BTreeSet<&Names>> = BTreeMap::new();
    for (module, file) in &files {
        let targets = file.used.iter().filter_map(|path| defining(path, &files, 0));
        let inner = targets.filter(|target| *target != module && target[0] == module[0]);
        edges.insert(module, inner.collect());
    }
    let mut reports = Vec::new();
    let mut seen = BTreeSet::new();
    for module in files.keys() {
        if seen.contains(module) {
            continue;
        }
        let forward = reachable(module, &edges);
        let circle: Vec<&Names> = forward
            .iter()
            .copied()
            .filter(|other| *other == module || reachable(other, &edges).contains(module))
            .collect();
        seen.extend(circle.iter().copied());
        if circle.len() > 1 {
            let links = circle.iter().flat_map(|from| {
                let inner = edges[*from].iter().filter(|to| circle.contains(to));
                inner.map(|to| format!("    {} uses {}", files[*from].path, files[*to].path))
            });
            let links: Vec<String> = links.collect();
            reports.push(format!("import loop of {} files:\n{}", circle.len(), links.join("\n")));
        }
    }
    reports
}

fn reachable<'a>(start: &'a Names, edges: &BTreeMap<&'a Names, BTreeSet<&'a Names>>) -> BTreeSet<&'a Names> {
    let mut found = BTreeSet::from([start]);
    let mut open = vec![start];
    while let Some(next) = open.pop() {
        open.extend(edges[next].iter().copied().filter(|to| found.insert(to)));
    }
    found
}

/// The file that defines what a path names, through re-exports.
fn defining<'a>(path: &Names, files: &'a BTreeMap<Names, File>, depth: usize) -> Option<&'a Names> {
    let length = (1..=path.len()).rev().find(|&length| files.contains_key(&path[..length]))?;
    let (module, file) = files.get_key_value(&path[..length])?;
    let Some(name) = path.get(length).filter(|_| depth < 8) else { return Some(module) };
    if let Some(target) = file.imports.get(name) {
        let mut whole = target.clone();
        whole.extend_from_slice(&path[length + 1..]);
        return defining(&whole, files, depth + 1).or(Some(module));
    }
    let in_glob = file.globs.iter().find_map(|glob| {
        let target = files.get(glob)?;
        target.imports.contains_key(name).then(|| [glob.as_slice(), &path[length..]].concat())
    });
    in_glob.and_then(|whole| defining(&whole, files, depth + 1)).or(Some(module))
}

fn parse(path: &str, source: &str, modules: &BTreeSet<Names>) -> File {
    let all = tokens(source);
    let code = match split_tests(&all) {
        _ if path.ends_with("tests.rs") => &all[..0],
        Tests::Last { start } => &all[..start],
        Tests::None | Tests::Inside => &all[..],
    };
    let mut file = File {
        path: path.to_owned(),
        module: module_path(path),
        imports: BTreeMap::new(),
        globs: Vec::new(),
        used: BTreeSet::new(),
    };
    let mut bodies = Vec::new();
    let mut at = 0;
    while at < code.len() {
        // `use<'a>` bounds a type; it imports nothing.
        if is(code, at, "use") && !is(code, at + 1, "<") {
            let is_public = at > 0 && (is(code, at - 1, "pub") || is(code, at - 1, ")"));
            let end = (at..code.len()).find(|&end| is(code, end, ";")).unwrap_or(code.len());
            let mut leaves = Vec::new();
            tree(&code[at + 1..end], Vec::new(), &mut leaves);
            for (names, alias) in leaves {
                let Some(full) = absolute(&names, &file.module, modules) else { continue };
                if alias == "*" {
                    file.globs.push(full.clone());
                } else {
                    file.imports.insert(alias, full.clone());
                }
                if !is_public {
                    file.used.insert(full);
                }
            }
            at = end;
        } else {
            bodies.push(at);
        }
        at += 1;
    }
    for at in bodies {
        let is_start = code[at].is_name() && is(code, at + 1, "::") && (at == 0 || !is(code, at - 1, "::"));
        if !is_start {
            continue;
        }
        let mut names = vec![code[at].text.clone()];
        let mut next = at + 1;
        while is(code, next, "::") && code.get(next + 1).is_some_and(Token::is_name) {
            names.push(code[next + 1].text.clone());
            next += 2;
        }
        let imported = file.imports.get(&names[0]).filter(|full| modules.contains(*full));
        let full = match imported {
            Some(full) => Some([full, &names[1..]].concat()),
            None => absolute(&names, &file.module, modules),
        };
        file.used.extend(full);
    }
    file
}

/// The leaves of a `use` tree: the path as written, and the name that it gets.
fn tree(tokens: &[Token], base: Names, leaves: &mut Vec<(Names, String)>) {
    let mut names = base;
    let mut at = 0;
    while at < tokens.len() {
        match tokens[at].text.as_str() {
            "{" => {
                let mut depth = 0;
                let mut start = at + 1;
                for end in at..tokens.len() {
                    match tokens[end].text.as_str() {
                        "{" => depth += 1,
                        "}" => depth -= 1,
                        _ => {}
                    }
                    let is_end = depth == 0 || depth == 1 && is(tokens, end, ",");
                    if is_end && end > start {
                        tree(&tokens[start..end], names.clone(), leaves);
                    }
                    if is_end {
                        start = end + 1;
                    }
                    if depth == 0 {
                        return;
                    }
                }
                return;
            }
            "as" => {
                let alias = tokens.get(at + 1).map_or("_", |token| token.text.as_str());
                leaves.push((names, alias.to_owned()));
                return;
            }
            "*" => {
                leaves.push((names, "*".to_owned()));
                return;
            }
            "::" => {}
            "self" if !names.is_empty() => {}
            name => names.push(name.to_owned()),
        }
        at += 1;
    }
    let alias = names.last().cloned().unwrap_or_default();
    leaves.push((names, alias));
}

/// A written path from the crate's root; `None` for paths into other crates.
fn absolute(names: &[String], module: &Names, modules: &BTreeSet<Names>) -> Option<Names> {
    let supers = names.iter().take_while(|name| *name == "super").count();
    match names.first()?.as_str() {
        // The program's root is the folder of its own module, and its other names are the library's.
        "crate" => Some(names[1..].to_vec()),
        "self" => Some([module, &names[1..]].concat()),
        "super" if supers <= module.len() => {
            Some([&module[..module.len() - supers], &names[supers..]].concat())
        }
        PROGRAM if module[0] == PROGRAM => Some(names.to_vec()),
        first => {
            let child = [module.as_slice(), &[first.to_owned()]].concat();
            modules.contains(&child).then(|| [module, names].concat())
        }
    }
}

//! Source files as tokens: enough of Rust's grammar for names and paths, without types.

use std::fs;
use std::path::Path;

/// The name of the program's module, whose root is `main.rs`.
pub const PROGRAM: &str = "cli";

/// The module that a file is, as a path from the crate's root: `io/obj/mod.rs` is `io::obj`.
pub fn module_path(path: &str) -> Vec<String> {
    let stem = path.strip_suffix(".rs").unwrap_or(path);
    let stem = stem.strip_suffix("/mod").unwrap_or(stem);
    let stem = if stem == "main" { PROGRAM } else { stem };
    stem.split('/').map(str::to_owned).collect()
}

pub fn is(tokens: &[Token], at: usize, text: &str) -> bool {
    tokens.get(at).is_some_and(|token| token.text == text)
}

/// Where a file keeps its unit tests.
pub enum Tests {
    None,
    /// In a module that ends the file and begins with this token.
    Last {
        start: usize,
    },
    /// Followed by other code.
    Inside,
}

pub fn split_tests(tokens: &[Token]) -> Tests {
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
pub struct Token {
    pub text: String,
    /// Counted from 0.
    pub line: usize,
}

impl Token {
    pub fn is_name(&self) -> bool {
        self.text.starts_with(|c: char| c.is_alphabetic() || c == '_')
    }
}

/// Rust source as tokens, without comments, literals and lifetimes.
pub fn tokens(source: &str) -> Vec<Token> {
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

pub fn collect(root: &Path, folder: &Path, files: &mut Vec<(String, String)>) {
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

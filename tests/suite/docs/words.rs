//! Texts have no words of our own: pages, help, messages, comments, and the texts of the Python package and the laboratory.

use super::{pages, root, sources};
use std::fs;
use std::process::Command;
use std::sync::LazyLock;

/// The words that have no everyday use in texts, from the list in CONTRIBUTING.md.
static NOT_IN_TEXT: LazyLock<Vec<String>> = LazyLock::new(|| {
    let page = fs::read_to_string(root().join("CONTRIBUTING.md")).unwrap();
    let (_, list) =
        page.split_once("- No page, help text, message, report or comment has: ").expect("the list");
    let words = list.split_once('.').expect("the end of the list").0.split(',');
    words.map(|word| word.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
});

/// The words of a text that have no everyday use in it. The terms of mathematics are allowed.
fn words_of_our_own(text: &str) -> Vec<&'static str> {
    let plain: String = text
        .to_lowercase()
        .chars()
        .map(|c| if c.is_alphanumeric() || c == '-' || c == '_' { c } else { ' ' })
        .collect();
    let padded = format!(" {} ", plain.split_whitespace().collect::<Vec<_>>().join(" "));
    let mathematics = ["odd number", "odd length", "odd significand"];
    let padded = mathematics.iter().fold(padded, |text, term| text.replace(term, ""));
    let words = NOT_IN_TEXT.iter().map(String::as_str);
    words.filter(|word| padded.contains(&format!(" {word} "))).collect()
}

/// A page without the lists of words that names and texts do not have, which are items of a list that start with "No".
fn without_word_lists(page: &str) -> String {
    let items = page.split("\n- ");
    items.filter(|item| !item.starts_with("No ")).collect::<Vec<_>>().join("\n- ")
}

#[test]
fn pages_are_in_plain_words() {
    assert!(NOT_IN_TEXT.len() >= 15, "{:?}", *NOT_IN_TEXT);
    let others = ["fuzz/README.md", "bindings/python/README.md"].map(|name| root().join(name));
    let others = others.map(|path| (path.clone(), fs::read_to_string(path).unwrap()));
    for (page, text) in pages().into_iter().chain(others) {
        let text = without_word_lists(&text);
        // Code is exempt: indented and fenced blocks, and names in backquotes.
        let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("    ")).collect();
        let outside: Vec<String> =
            lines.split(|line| line.starts_with("```")).step_by(2).map(|lines| lines.join("\n")).collect();
        let prose: String = outside.concat().split('`').step_by(2).collect();
        assert_eq!(words_of_our_own(&prose), Vec::<&str>::new(), "{}", page.display());
    }
    for (name, scene) in sources(&root().join("data/scenes"), ".toml") {
        let comments = scene.lines().filter_map(|line| Some(line.split_once('#')?.1)).collect::<Vec<_>>();
        assert_eq!(words_of_our_own(&without_names(&comments.join(" "))), Vec::<&str>::new(), "{name}");
    }
    assert_eq!(words_of_our_own("What is TOLD, if\nneed be."), ["told", "if need be"]);
    assert!(words_of_our_own("retold; an oddity; besides").is_empty());
}

/// The string literals and the comments of a source file. Comments on consecutive lines are one.
fn literals_and_comments(source: &str) -> [Vec<String>; 2] {
    let (mut found, mut comments) = (Vec::new(), Vec::<String>::new());
    let mut rest = source;
    while let Some(at) = rest.find(['"', '\'', '/']) {
        let (before, here) = rest.split_at(at);
        let characters: Vec<char> = here.chars().take(4).collect();
        if here.starts_with("//") {
            let (comment, after) = here.split_once('\n').unwrap_or((here, ""));
            match comments.last_mut().filter(|_| before.trim().is_empty()) {
                Some(last) => last.push_str(comment),
                None => comments.push(comment.to_owned()),
            }
            rest = after;
        } else if characters[0] == '/' {
            rest = &here[1..];
        } else if characters[0] == '\'' {
            // A character literal, else a lifetime.
            let length = match characters[..] {
                ['\'', '\\', ..] => 1 + here[2..].find('\'').map_or(0, |end| end + 2),
                ['\'', c, '\'', ..] => 2 + c.len_utf8(),
                _ => 1,
            };
            rest = &here[length..];
        } else if before.ends_with('r') || before.ends_with('#') {
            let hashes = before.chars().rev().take_while(|&c| c == '#').count();
            let end = format!("\"{}", "#".repeat(hashes));
            let (text, after) = here[1..].split_once(&end).unwrap_or(("", ""));
            found.push(text.to_owned());
            rest = after;
        } else {
            let mut is_escaped = false;
            let end = here[1..].find(|c| {
                let ends = c == '"' && !is_escaped;
                is_escaped = c == '\\' && !is_escaped;
                ends
            });
            let end = end.unwrap_or(here.len() - 2) + 1;
            found.push(here[1..end].replace("\\\n", " "));
            rest = &here[end + 1..];
        }
    }
    [found, comments]
}

/// A text without names in backquotes.
fn without_names(text: &str) -> String {
    text.split('`').step_by(2).collect()
}

#[test]
fn messages_and_texts_are_in_plain_words() {
    let mut bad = Vec::new();
    let mut count = 0;
    let mut check = |name: &str, text: &str| {
        count += 1;
        let words = words_of_our_own(&without_names(text));
        if !words.is_empty() {
            bad.push(format!("{name}: {words:?} in {text:?}"));
        }
    };
    let code = |source: &str| source.split("#[cfg(test)]\nmod ").next().unwrap().to_owned();
    let folders = ["src", "tests", "benches", "bindings/web/src", "bindings/python/src"];
    for (name, source) in folders.map(|it| sources(&root().join(it), ".rs")).concat() {
        let [_, comments] = literals_and_comments(&source);
        comments.iter().for_each(|comment| check(&name, comment));
        let is_read = name.starts_with("src/") || name.starts_with("bindings/");
        if is_read && !name.ends_with("tests.rs") {
            literals_and_comments(&code(&source))[0].iter().for_each(|text| check(&name, text));
        }
    }
    for name in ["Cargo.toml", ".ci/run", ".ci/compare"] {
        let source = fs::read_to_string(root().join(name)).unwrap();
        let comments = source.lines().filter(|line| line.trim_start().starts_with('#'));
        check(name, &comments.collect::<Vec<_>>().join(" "));
    }
    for (name, text) in sources(&root().join("src"), ".txt") {
        check(&name, &text);
    }
    for (folder, ending) in [("bindings/web/page", "en.json"), ("bindings/python/python", ".py")] {
        for (name, text) in sources(&root().join(folder), ending) {
            text.lines().for_each(|line| check(&name, line));
        }
    }
    // A text may go on in the next line.
    for (name, texts) in sources(&root().join("src"), ".en.ftl") {
        let lines = texts.lines().filter(|line| !line.starts_with('#')).collect::<Vec<_>>().join("\n");
        lines.replace("\n ", " ").lines().for_each(|text| check(&name, text));
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
    assert!(count > 5000, "only {count} texts were found");
    let source = "fn f<'a>(c: char) { c == '\"'; g(\"a \\\"b\\\" \\\n  told\", r#\"c\"d\"#) } // \"no\"\n#[cfg(test)]\nmod t { \"x\" } // an odd\n// number, `told`, if\n/// need be";
    assert_eq!(literals_and_comments(&code(source))[0], ["a \\\"b\\\"    told", "c\"d"]);
    let [_, comments] = literals_and_comments(source);
    assert_eq!(comments, ["// \"no\"", "// an odd// number, `told`, if/// need be"]);
    assert_eq!(words_of_our_own(&without_names(&comments[1])), ["if need be"]);
}

#[test]
fn help_is_short_and_in_plain_words() {
    let help = |args: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_crease")).args(args).env("COLUMNS", "100").output();
        String::from_utf8(output.unwrap().stdout).unwrap()
    };
    for verb in ["normals", "inspect", "render", "artefact", "surface", "trade", "stress", "plan", "journal"]
    {
        let (short, long) = (help(&[verb, "-h"]), help(&[verb, "--help"]));
        assert!(short.lines().count() < 45, "{verb}: {} lines\n{short}", short.lines().count());
        for line in short.lines().chain(long.lines()) {
            assert!(line.chars().count() <= 100, "{verb}: {line}");
        }
        let examples = |text: &str| text.lines().filter(|line| line.starts_with("  crease ")).count();
        assert_eq!((examples(&short), examples(&long)), (3, 3), "{verb}");
        for text in [short, long] {
            assert_eq!(words_of_our_own(&without_names(&text)), Vec::<&str>::new(), "{verb}");
        }
    }
    let scenes = help(&["render", "--scene-help"]);
    assert!(scenes.contains("cut-off") && !scenes.contains("|---"), "{scenes}");
    assert!(scenes.lines().all(|line| line.chars().count() <= 100), "{scenes}");
    let verbs = help(&["--help"]);
    let order = ["normals", "inspect", "render", "artefact", "surface", "trade", "stress", "plan"];
    let places = order.map(|verb| verbs.find(&format!("\n  {verb} ")).unwrap());
    assert!(places.is_sorted(), "{verbs}");
}

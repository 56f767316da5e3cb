//! README and docs: every command runs and prints what the page shows, every link leads somewhere, every word is plain.
//!
//! In a block marked `console`, a line `$ COMMAND` is run by a shell, and the lines after it are what it prints to standard
//! output. `…` alone matches any lines, at the end of a line the rest of it. `? N` is the exit code, 0 if omitted. An indented
//! `crease` command has to succeed, whatever it prints. The commands of a page run in order, in one folder that has a copy of
//! `data/`. Indented `cargo` commands must name what exists, and commands in running text options that their verb has.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The words that have no everyday use in texts, from the list in CONTRIBUTING.md.
static NOT_IN_TEXT: LazyLock<Vec<String>> = LazyLock::new(|| {
    let page = fs::read_to_string(root().join("CONTRIBUTING.md")).unwrap();
    let (_, list) =
        page.split_once("- No page, help text, message, report or comment has: ").expect("the list");
    let words = list.split_once('.').expect("the end of the list").0.split(',');
    words.map(|word| word.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
});

/// README.md and all pages of docs/ and data/, with their text.
fn pages() -> Vec<(PathBuf, String)> {
    let docs = fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = docs.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    let others = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "data/README.md"];
    paths.extend(others.map(|name| root().join(name)));
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect()
}

/// A command of a page, what it should print, and its exit code.
#[derive(Debug, PartialEq)]
struct Example {
    command: String,
    output: Vec<String>,
    code: i32,
}

/// The indented commands of a page, outside fenced blocks, that start with a word; a `\` at the end continues a line.
fn indented(page: &str, program: &str) -> Vec<String> {
    let text: String = page.replace("\\\n", " ").split("```").step_by(2).collect();
    let commands = text.lines().filter_map(|line| line.strip_prefix("    "));
    commands.filter(|line| line.split_whitespace().next() == Some(program)).map(str::to_owned).collect()
}

fn examples(page: &str) -> Vec<Example> {
    let mut found: Vec<Example> = Vec::new();
    let mut in_console = false;
    for line in page.lines() {
        if line.starts_with("```") {
            in_console = line == "```console";
        } else if let Some(command) = line.strip_prefix("$ ").filter(|_| in_console) {
            found.push(Example { command: command.to_owned(), output: Vec::new(), code: 0 });
        } else if in_console && let Some(example) = found.last_mut() {
            match line.strip_prefix("? ") {
                Some(code) => example.code = code.parse().unwrap(),
                None => example.output.push(line.to_owned()),
            }
        }
    }
    found
}

/// Whether lines are what a pattern with `…` describes.
fn matches(pattern: &[String], lines: &[&str]) -> bool {
    match (pattern.split_first(), lines.split_first()) {
        (None, None) => true,
        (Some((first, rest)), _) if first == "…" => {
            matches(rest, lines) || !lines.is_empty() && matches(pattern, &lines[1..])
        }
        (Some((first, rest)), Some((line, lines))) => {
            let same = match first.strip_suffix('…') {
                Some(start) => line.starts_with(start.trim_end()),
                None => line == first,
            };
            same && matches(rest, lines)
        }
        _ => false,
    }
}

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy_folder(&entry.path(), &target)
        } else {
            fs::copy(entry.path(), target).map(drop).unwrap()
        }
    }
}

#[cfg(unix)]
#[test]
fn commands_print_what_the_pages_show() {
    let program = Path::new(env!("CARGO_BIN_EXE_crease"));
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(
        std::iter::once(program.parent().unwrap().to_owned()).chain(std::env::split_paths(&path)),
    );
    let path = path.unwrap();
    let (mut failures, mut count) = (Vec::new(), 0);
    for (page, text) in pages() {
        let folder = tempfile::tempdir().unwrap();
        copy_folder(&root().join("data"), &folder.path().join("data"));
        fs::create_dir_all(folder.path().join("tests/gallery")).unwrap();
        let any_output = |command: String| {
            // All surfaces take minutes, and the tests of `trade` check them.
            let command = command.split('#').next().unwrap().trim_end().to_owned();
            let is_long = command == "crease trade" || command.starts_with("crease trade -");
            let command =
                if is_long && !command.contains("--quick") { command + " --quick" } else { command };
            Example { command, output: vec!["…".to_owned()], code: 0 }
        };
        // The tests of `trade` run it without options.
        let indented = indented(&text, "crease").into_iter().map(any_output);
        let indented = indented.filter(|example| example.command != "crease trade --quick");
        for example in examples(&text).into_iter().chain(indented) {
            count += 1;
            let mut shell = Command::new("sh");
            shell.args(["-c", &example.command]).current_dir(folder.path());
            let output = shell.env("PATH", &path).env("NO_COLOR", "1").output().unwrap();
            let printed = String::from_utf8_lossy(&output.stdout);
            let lines: Vec<&str> = printed.lines().collect();
            if output.status.code() != Some(example.code) || !matches(&example.output, &lines) {
                let errors = String::from_utf8_lossy(&output.stderr);
                let code = output.status.code();
                failures.push(format!(
                    "{}: $ {}\nexit {code:?}\n{printed}{errors}",
                    page.display(),
                    example.command
                ));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
    assert!(count >= 20, "only {count} commands were found");
}

/// The scenes that the page of scene files shows can be drawn.
#[test]
fn scenes_on_pages_are_drawn() {
    let page = fs::read_to_string(root().join("docs/scenes.md")).unwrap();
    let blocks = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next());
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for scene in blocks {
        fs::write(folder.path().join("scene.toml"), scene).unwrap();
        let mut program = Command::new(env!("CARGO_BIN_EXE_crease"));
        program.args(["render", "scene.toml", "--size", "32x24", "-o", "scene.png"]);
        let output = program.current_dir(folder.path()).output().unwrap();
        assert!(output.status.success() && output.stderr.is_empty(), "{scene}{output:?}");
        count += 1;
    }
    assert!(count >= 2, "only {count} scenes were found");
}

#[test]
fn patterns_match_what_they_should() {
    let page = "$ not here\n```console\n$ a | b\nx 1\ny …\n…\n$ c\n? 3\n```\n```\n$ nor here\n```\n";
    let found = examples(page);
    assert_eq!(found.len(), 2);
    assert_eq!((found[0].command.as_str(), found[0].code, found[1].code), ("a | b", 0, 3));
    let good: [&[&str]; 3] = [&["x 1", "y 2"], &["x 1", "y", "z", "z"], &["x 1", "y 2", "", "q"]];
    let bad: [&[&str]; 4] = [&["x 1"], &["x 2", "y 2"], &["x 1", "z", "y 2"], &[]];
    assert!(good.iter().all(|lines| matches(&found[0].output, lines)));
    assert!(!bad.iter().any(|lines| matches(&found[0].output, lines)));
    assert!(matches(&found[1].output, &[]) && !matches(&found[1].output, &["x"]));
}

/// What a page names with `cargo`, in indented lines and between backquotes: benches, tests, modules and packages.
#[test]
fn cargo_commands_name_what_exists() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let tests: String =
        sources(&root().join("tests/suite"), ".rs").into_iter().map(|(_, text)| text).collect();
    let exists = |command: &str| {
        let words: Vec<&str> = command.split_whitespace().collect();
        words.windows(2).all(|pair| match pair[0] {
            "--bench" => manifest.contains(&format!("[[bench]]\nname = \"{}\"\n", pair[1])),
            "--manifest-path" => root().join(pair[1]).exists(),
            "suite" => {
                let group = pair[1].split("::").next().unwrap();
                pair[1].starts_with('-')
                    || tests.contains(&format!("fn {}", pair[1]))
                    || root().join(format!("tests/suite/{group}.rs")).exists()
            }
            "unit" => {
                let module = root().join("src").join(pair[1].trim_end_matches(':').replace("::", "/"));
                module.is_dir() || module.with_extension("rs").exists()
            }
            _ => true,
        })
    };
    let of_page = |text: &str| {
        let prose: String = text.split("```").step_by(2).collect();
        let quoted =
            prose.split('`').skip(1).step_by(2).filter(|code| code.contains("cargo ")).map(str::to_owned);
        quoted.chain(indented(text, "cargo")).collect::<Vec<_>>()
    };
    let commands: Vec<String> = pages().iter().flat_map(|(_, text)| of_page(text)).collect();
    let missing: Vec<&String> = commands.iter().filter(|command| !exists(command)).collect();
    assert!(missing.is_empty() && commands.len() >= 30, "{missing:?} of {commands:?}");
    assert!(!exists("cargo bench --bench no_such_bench") && !exists("cargo test --test suite no_such_test"));
    assert!(!exists("cargo suite no_such_group::test") && !exists("cargo unit no::such_module"));
}

/// A command in running text has options of its verb.
#[test]
fn commands_in_running_text_have_options_that_exist() {
    let help = |verb: &str| {
        let output = Command::new(env!("CARGO_BIN_EXE_crease")).args([verb, "--help"]).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let is_known = |command: &str| {
        let mut words = command.split_whitespace().skip(1).filter(|word| *word != "VERB");
        let Some(verb) = words.next() else { return true };
        let help = help(verb);
        let is_option = |word: &&str| word.starts_with('-') && word.len() > 1;
        let names = words.filter(is_option).map(|word| word.split('=').next().unwrap());
        !help.is_empty()
            && names.into_iter().all(|name| help.split([' ', ',', '\n']).any(|word| word == name))
    };
    let (mut unknown, mut count) = (Vec::new(), 0);
    for (page, text) in pages() {
        let prose: String = text.split("```").step_by(2).collect();
        for command in prose.split('`').skip(1).step_by(2).filter(|code| code.starts_with("crease ")) {
            count += 1;
            if !is_known(command) {
                unknown.push(format!("{}: {command}", page.display()));
            }
        }
    }
    assert!(unknown.is_empty(), "{}", unknown.join("\n"));
    assert!(count >= 30, "only {count} commands were found");
    assert!(!is_known("crease normals IN --no-such-option") && is_known("crease normals IN --crease 40"));
}

#[test]
fn links_lead_somewhere() {
    let slug = |heading: &str| -> String {
        let kept = heading.to_lowercase();
        kept.chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
            .map(|c| if c == ' ' { '-' } else { c })
            .collect()
    };
    let headings = |text: &str| -> Vec<String> {
        text.lines()
            .filter(|line| line.starts_with('#'))
            .map(|line| slug(line.trim_start_matches('#').trim()))
            .collect()
    };
    let (mut broken, mut count) = (Vec::new(), 0);
    for (page, text) in pages() {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            count += 1;
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { page.clone() } else { page.parent().unwrap().join(file) };
            let has_anchor = || {
                anchor.is_empty()
                    || fs::read_to_string(&target)
                        .is_ok_and(|text| headings(&text).iter().any(|h| h == anchor))
            };
            if !target.exists() || !has_anchor() {
                broken.push(format!("{}: {link}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    assert!(count >= 40, "only {count} links were found");
}

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

/// All files of a kind below a folder, with their paths from the root.
fn sources(folder: &Path, ending: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            found.extend(sources(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            let name = path.strip_prefix(root()).unwrap().to_string_lossy().replace('\\', "/");
            found.push((name, fs::read_to_string(path).unwrap()));
        }
    }
    found.sort();
    found
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

#[test]
fn the_readme_is_short_and_its_library_examples_work() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.lines().count() <= 250, "{} lines", readme.lines().count());
    let marked = include_str!("docs.rs").split("// README example: begin\n").skip(1);
    let examples: Vec<&str> = marked.filter_map(|rest| rest.split("// README example: end").next()).collect();
    assert_eq!(examples.len(), 2);
    for line in examples.concat().lines().map(str::trim).filter(|line| !line.is_empty()) {
        assert!(readme.contains(line), "not in the README: {line}");
    }
    slices().unwrap();
    // The example reads from the working folder, which other tests use too: there is no such file in it.
    assert!(files().is_err());
}

#[rustfmt::skip]
fn files() -> Result<(), Box<dyn std::error::Error>> {
    // README example: begin
    use crease::{io, pipeline};

    let loaded = io::read("gear.obj".as_ref(), None, &io::ReadOptions::default())?;
    let revision = pipeline::revise(&loaded, &pipeline::Task::default(), Some(io::Format::Glb), &|_| {});
    let written = io::write(&loaded, revision.edits, io::Format::Glb, &io::WriteOptions::default())?;
    std::fs::write("gear.glb", written.bytes)?;
    // README example: end
    Ok(())
}

#[rustfmt::skip]
fn slices() -> Result<(), Box<dyn std::error::Error>> {
    // README example: begin
    use crease::normals::{Averaging, Scratch, Weight, vertex_normals};

    let positions = [[0.0_f32, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]];
    let triangles = [[0, 2, 1], [0, 1, 3]];
    let (mut normals, mut scratch) = ([[0.0; 3]; 4], Scratch::new()); // reuse the scratch for the next mesh
    let averaging = Averaging { weight: Weight::Angle, ..Averaging::default() };
    let faults = vertex_normals(&positions, &triangles, averaging, &mut scratch, &mut normals)?;
    assert_eq!(normals[0], [0.0, 0.0, 1.0]);
    // README example: end
    assert!(faults.is_empty());
    Ok(())
}

//! The commands of the pages.
//!
//! In a block marked `console`, a line `$ COMMAND` is run by a shell, and the lines after it are what it prints to standard
//! output. `…` alone matches any lines, at the end of a line the rest of it. `? N` is the exit code, 0 if omitted. An indented
//! `crease` command has to succeed, whatever it prints. The commands of a page run in order, in one folder that has a copy of
//! `data/` and the scene of a bench. Commands in running text run too, with small files in place of the names that they have.
//! `.ci/commands` has the commands of other programs; those of `cargo` must name what exists.

use super::{pages, root, sources};
use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::process::Command;

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
        fs::create_dir(folder.path().join("benches")).unwrap();
        fs::copy(root().join("benches/plan.toml"), folder.path().join("benches/plan.toml")).unwrap();
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

/// The commands of a page in running text, whose first word is one of these.
fn in_running_text(page: &str, programs: &[&str]) -> Vec<String> {
    let prose: String = page.split("```").step_by(2).collect();
    let code = prose.split('`').skip(1).step_by(2);
    let words = code.map(|code| code.split_whitespace().collect::<Vec<_>>());
    let commands = words.filter(|words| words.len() > 1 && programs.contains(&words[0]));
    commands.map(|words| words.join(" ")).collect()
}

/// What a command in running text runs: with small files in place of its placeholders, and with smaller pictures and meshes. `None` if
/// it only names a verb or an option.
fn complete(command: &str) -> Option<String> {
    let placeholders = [
        ("IN", "data/gear.obj"),
        ("IN.stl", "data/part.stl"),
        ("OUT", "out.obj"),
        ("FILE", "data/gear.obj"),
        ("PICTURE", "picture.png"),
        ("MESH", "torus.ply"),
        ("WORD", "dark"),
        ("VERB", "normals"),
        ("ID", "silhouette"),
        ("192", "48"),
        ("1000x500", "20x10"),
        ("707x707", "20x20"),
    ];
    let alone = [
        "crease artefact ",
        "crease inspect --explain ",
        "crease render --scene-help",
        "crease plan --explain",
    ];
    let names_a_file = |word: &&str| word.contains('.') || placeholders.iter().any(|(name, _)| name == word);
    let is_complete = command.ends_with("--help") || alone.iter().any(|start| command.starts_with(start));
    if !is_complete && !command.split(' ').any(|word| names_a_file(&word)) && !command.contains(" -o ") {
        return None;
    }
    let mut words: Vec<&str> = command.split(' ').collect();
    for word in &mut words {
        if let Some((_, file)) = placeholders.iter().find(|(name, _)| name == word) {
            *word = file;
        }
    }
    match (words[1], words[2]) {
        ("trade", "-o") => words.push("--quick"),
        ("artefact", id) if id != "list" && !words.contains(&"--size") => words.extend(["--size", "48"]),
        _ => {}
    }
    Some(words.join(" "))
}

/// Those that are complete run in a folder that has the files that they name. The others have options of their verb.
#[cfg(unix)]
#[test]
fn commands_in_running_text_work() {
    let crease = |folder: &Path, command: &str| {
        let mut shell = Command::new("sh");
        shell.args(["-c", &command.replacen("crease", env!("CARGO_BIN_EXE_crease"), 1)]).current_dir(folder);
        let output = shell.output().unwrap();
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.success(), String::from_utf8(output.stdout).unwrap(), errors)
    };
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    copy_folder(&root().join("data"), &folder.join("data"));
    fs::copy(root().join("data/scenes/sphere.toml"), folder.join("scene.toml")).unwrap();
    for (surface, file) in
        [("torus", "torus.ply"), ("wave", "big.obj"), ("wave", "big.ply"), ("wave", "gear.glb")]
    {
        let command = format!("crease surface {surface} --segments 20x20 -o {file}");
        assert!(crease(folder, &command).0, "{command}");
    }
    let help_has = |command: &str| {
        let mut words = command.split(' ').skip(1);
        let verb = words.next().unwrap();
        let (_, help, _) = crease(folder, &format!("crease {verb} --help"));
        let is_option = |word: &&str| word.starts_with('-') && word.len() > 1;
        let mut names = words.filter(is_option).map(|word| word.split('=').next().unwrap());
        !help.is_empty() && names.all(|name| help.split([' ', ',', '\n']).any(|word| word == name))
    };
    let (mut failures, mut run, mut named) = (Vec::new(), 0, 0);
    // Several pages have the same command.
    let mut results = HashMap::new();
    for (page, text) in pages() {
        for command in in_running_text(&text, &["crease"]) {
            let Some(filled) = complete(&command) else {
                named += 1;
                if !help_has(&command) {
                    failures.push(format!("{}: {command}: no such verb or option", page.display()));
                }
                continue;
            };
            run += 1;
            let (is_good, _, errors) =
                results.entry(filled.clone()).or_insert_with(|| crease(folder, &filled));
            if !*is_good {
                failures.push(format!("{}: {command}\n$ {filled}\n{errors}", page.display()));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
    assert!(run >= 25 && named >= 25, "{run} commands were run, {named} only name a verb or an option");
    assert!(!help_has("crease normals --no-such-option") && help_has("crease normals --crease"));
    assert_eq!(complete("crease normals --flip"), None);
    assert_eq!(complete("crease normals IN -o OUT").unwrap(), "crease normals data/gear.obj -o out.obj");
}

/// The commands of README and docs in other programs, in the form that `.ci/commands` has.
fn of_other_programs(page: &str) -> Vec<String> {
    let programs =
        ["cargo", "bash", "sh", "pip", "python", "npm", "perf", "rustup", "node", "time", "xvfb-run"];
    let is_code = |line: &str| {
        let mut words = line.split(' ').skip_while(|word| word.contains('='));
        words.next().is_some_and(|word| programs.contains(&word))
    };
    let text = page.replace("\\\n", " ");
    let outside: String = text.split("```").step_by(2).collect();
    let indented = outside.lines().filter_map(|line| line.strip_prefix("    ")).filter(|line| is_code(line));
    let blocks = page.split("```sh\n").skip(1).filter_map(|rest| rest.split("\n```").next());
    // A block is one command of several lines.
    let joined = |block: &str| {
        let text = block.split_whitespace().collect::<Vec<_>>().join(" ");
        text.replace(" done |", "; done |")
    };
    let quoted = in_running_text(page, &programs);
    indented.map(str::to_owned).chain(blocks.map(joined)).chain(quoted).collect()
}

/// Which of them run in `cargo test`, by `.ci/run`, and by hand.
#[test]
fn commands_of_other_programs_are_run() {
    let list = fs::read_to_string(root().join(".ci/commands")).unwrap();
    let rows = list.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    let listed: Vec<&str> = rows
        .map(|row| {
            let columns: Vec<&str> = row.split('\t').collect();
            assert!(
                matches!(columns[..], ["step" | "quick" | "slow", _] | ["quick" | "slow", _, _]),
                "{row}"
            );
            columns[1]
        })
        .collect();
    let of_users = pages().into_iter().filter(|(page, _)| {
        page.parent().unwrap().ends_with("docs")
            || page.ends_with("README.md") && !page.ends_with("data/README.md")
    });
    let commands: Vec<String> = of_users.flat_map(|(_, text)| of_other_programs(&text)).collect();
    // `cargo test` has the tests that these name.
    let is_test = |command: &str| command.starts_with("cargo suite ") || command.starts_with("cargo unit ");
    let shown: Vec<&str> = commands.iter().map(String::as_str).filter(|command| !is_test(command)).collect();
    let missing: Vec<&&str> = shown.iter().filter(|command| !listed.contains(command)).collect();
    let unused: Vec<&&str> = listed.iter().filter(|command| !shown.contains(command)).collect();
    assert!(missing.is_empty() && unused.is_empty(), "missing: {missing:#?}\nunused: {unused:#?}");
    assert!(listed.len() >= 15, "{listed:?}");
}

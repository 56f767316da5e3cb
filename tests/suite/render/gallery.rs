//! The pictures of docs/render.md and docs/plan.md are what their commands make.

use crate::cli::{code, crease, text};
use std::fs;
use std::path::Path;

/// The largest a picture of the documentation may be, in bytes.
const LARGEST: u64 = 60_000;

#[test]
fn commands_of_the_documentation_make_its_pictures() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let pages =
        ["render", "plan"].map(|name| fs::read_to_string(root.join(format!("docs/{name}.md"))).unwrap());
    let commands =
        pages.iter().flat_map(|page| page.lines()).filter_map(|line| line.strip_prefix("    crease "));
    let mut seen = 0;
    for command in commands.filter(|command| command.contains("tests/gallery/")) {
        let mut args: Vec<String> = words(command);
        let place = args.iter().position(|arg| arg.starts_with("tests/gallery/")).unwrap();
        let kept = root.join(&args[place]);
        let folder = tempfile::tempdir().unwrap();
        let made = folder.path().join(kept.file_name().unwrap());
        args[place] = made.to_str().unwrap().to_owned();
        args[1] = root.join(&args[1]).to_str().unwrap().to_owned();
        let output = crease().args(&args).output().unwrap();
        assert_eq!(code(&output), 0, "{command}: {}", text(&output.stderr));
        if std::env::var_os("CREASE_BLESS").is_some_and(|value| value == "1") {
            fs::create_dir_all(kept.parent().unwrap()).unwrap();
            fs::copy(&made, &kept).unwrap();
        }
        assert!(fs::read(&made).unwrap() == fs::read(&kept).unwrap(), "{command}: another picture");
        assert!(kept.metadata().unwrap().len() < LARGEST, "{} is too large", kept.display());
        seen += 1;
    }
    assert!(seen >= 4, "{seen} pictures");
}

/// The words of a command line with plain single quotes.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (number, part) in line.split('\'').enumerate() {
        match number % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    words
}

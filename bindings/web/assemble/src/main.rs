//! Puts the program, scripts, styles and texts of the laboratory into one page.
//!
//!     assemble PROGRAM.wasm PAGE_FOLDER OUTPUT.html

use anyhow::{Context, Result, bail, ensure};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use wasm_bindgen_cli_support::Bindgen;

/// The largest program after compression, in bytes.
const LARGEST: usize = 4 << 20;

fn main() -> Result<()> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [program, folder, output] = &arguments[..] else {
        bail!("usage: assemble PROGRAM.wasm PAGE_FOLDER OUTPUT.html");
    };
    let work = output.with_extension("parts");
    Bindgen::new()
        .input_path(program)
        .no_modules(true)?
        .typescript(false)
        .generate(&work)
        .with_context(|| format!("{}: the exported functions could not be bound", program.display()))?;
    let stem = program.file_stem().context("a program without a name")?.to_string_lossy().into_owned();
    let binding = read(&work.join(format!("{stem}.js")))?;
    let wasm = work.join(format!("{stem}_bg.wasm"));
    let wasm = fs::read(&wasm).with_context(|| wasm.display().to_string())?;
    let compressed = gzip(&wasm)?;
    ensure!(
        compressed.len() <= LARGEST,
        "the program has {} bytes after compression; the limit is {LARGEST}",
        compressed.len()
    );

    let worker = format!("{binding}\n{}", read(&folder.join("worker.js"))?);
    let texts = format!(
        "{{\"en\":{},\"pt\":{}}}",
        read(&folder.join("texts.en.json"))?,
        read(&folder.join("texts.pt.json"))?
    );
    let mut scripts = Modules { folder, done: BTreeSet::new(), text: String::new() };
    scripts.add("main.js")?;
    let mut page = read(&folder.join("page.html"))?;
    for (mark, content) in [
        ("/*style*/", read(&folder.join("style.css"))?),
        ("/*texts*/", for_element(&texts)),
        ("/*worker*/", for_element(&worker)),
        ("/*program*/", STANDARD.encode(&compressed)),
        ("/*scripts*/", for_element(&scripts.text)),
    ] {
        ensure!(page.matches(mark).count() == 1, "page.html has to have {mark} once");
        page = page.replace(mark, &content);
    }
    fs::write(output, &page).with_context(|| output.display().to_string())?;
    let kib = |bytes: usize| bytes / 1024;
    let sizes = [wasm.len(), compressed.len(), page.len()].map(kib);
    println!("program {} KiB, compressed {} KiB, page {} KiB", sizes[0], sizes[1], sizes[2]);
    Ok(())
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| path.display().to_string())
}

fn gzip(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?)
}

/// Text inside a script element: its end tag must not occur.
fn for_element(text: &str) -> String {
    text.replace("</script", "<\\/script")
}

/// Modules in one text, each after those that it imports. Names at the top level must differ between modules, which the
/// browser checks.
struct Modules<'a> {
    folder: &'a Path,
    done: BTreeSet<String>,
    text: String,
}

impl Modules<'_> {
    fn add(&mut self, name: &str) -> Result<()> {
        if !self.done.insert(name.to_owned()) {
            return Ok(());
        }
        let source = read(&self.folder.join(name))?;
        let mut own = String::new();
        for line in source.lines() {
            if line.starts_with("import ") {
                let from = line.split('\'').nth(1).and_then(|path| path.strip_prefix("./"));
                self.add(
                    from.with_context(|| format!("{name}: {line}: import from './FILE.js' on one line"))?,
                )?;
            } else {
                own.push_str(line.strip_prefix("export ").unwrap_or(line));
                own.push('\n');
            }
        }
        self.text.push_str(&format!("// {name}\n{own}"));
        Ok(())
    }
}

//! Options of large batches: inputs from a list, a share of them, several at a time, and a journal of what is done.

use super::console::HELP;
use super::failure::Failure;
use super::input::{Input, Source};
use super::jobs::Jobs;
use clap::{ArgAction, Args};
use crease::io::Format;
use serde::Deserialize;
use std::io::Read;
use std::path::{Component, Path, PathBuf};
use std::str::FromStr;

#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Batches")]
pub struct BatchArgs {
    #[arg(long, value_name = "FILE")]
    pub manifest: Option<PathBuf>,
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub shard: Option<Shard>,
    #[arg(long, value_name = "FILE")]
    pub journal: Option<PathBuf>,
    #[arg(long, value_name = "N", default_value = "0", value_parser = clap::value_parser!(u8).range(0..=10))]
    pub retries: u8,
    #[arg(long, value_name = "N", default_value = "1", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub jobs: u16,
    #[arg(long, value_name = "BOOL", num_args = 0..=1, require_equals = true, action = ArgAction::Set,
          default_value = "true", default_missing_value = "true", value_parser = bool::from_str)]
    pub keep_going: bool,
    #[arg(long, value_name = "BYTES", value_parser = memory)]
    pub memory: Option<u64>,
}

impl BatchArgs {
    /// The inputs of the manifest, or else those of `otherwise`.
    ///
    /// # Errors
    /// Those of [`manifest`] and of `otherwise`.
    pub fn inputs(
        &self,
        otherwise: impl FnOnce() -> Result<Vec<Input>, Failure>,
    ) -> Result<Vec<Input>, Failure> {
        self.manifest.as_deref().map_or_else(otherwise, manifest)
    }

    /// Whether an input is in the share. Outputs are compared before that, so that no share overwrites the work of another.
    pub fn takes(&self, source: &Source) -> bool {
        self.shard.is_none_or(|shard| shard.takes(&source.name()))
    }

    /// How many inputs are processed at the same time.
    pub fn jobs(&self) -> Jobs {
        Jobs { most: self.jobs.into(), memory: self.memory.unwrap_or_else(free_memory) }
    }
}

/// The memory that an input needs, in bytes: its length times more than the largest ratio measured for its format (docs/speed.md). The
/// external buffers of a glTF are not counted.
pub fn memory_need(source: &Source, format: Option<Format>) -> u64 {
    let format = format.or_else(|| Format::from_path(source.path()?));
    let ratio = match format {
        Some(Format::Obj) => 4,
        Some(Format::Ply) => 6,
        Some(Format::Stl) => 8,
        // Packed text.
        Some(Format::ThreeMf) => 60,
        _ => 12,
    };
    source.length().unwrap_or_default().saturating_mul(ratio)
}

/// Three quarters of the memory that Linux reports as available; elsewhere 4 GiB.
fn free_memory() -> u64 {
    let text = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
    let kibibytes =
        text.lines().find_map(|line| line.strip_prefix("MemAvailable:")?.split_whitespace().next());
    kibibytes.and_then(|number| number.parse::<u64>().ok()).map_or(4 << 30, |number| number * 768)
}

/// `8G`, `512M`, `1000K`, or bytes.
fn memory(text: &str) -> Result<u64, String> {
    let units = [("K", 10), ("M", 20), ("G", 30), ("T", 40)];
    let (number, shift) =
        units.iter().find_map(|(unit, shift)| Some((text.strip_suffix(unit)?, *shift))).unwrap_or((text, 0));
    let bytes = number.parse::<u64>().ok().and_then(|number| number.checked_mul(1 << shift));
    bytes
        .filter(|&bytes| bytes > 0)
        .ok_or_else(|| format!("{text:?} is not a number of bytes such as 8G or 512M"))
}

/// One of several shares of the inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    number: u64,
    shards: u64,
}

impl Shard {
    /// Whether an input belongs to this share. It depends on the name alone, so that all machines agree.
    pub fn takes(self, name: &str) -> bool {
        fnv1a(name.as_bytes()) % self.shards == self.number
    }
}

fn shard(text: &str) -> Result<Shard, String> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((number, shards)) if number < shards => Ok(Shard { number, shards }),
        _ => Err(format!("{text:?} is not I/N with I from 0 to N − 1, such as 0/4")),
    }
}

/// The hash FNV-1a of 64 bits (Fowler, Noll, Vo): a byte is combined by exclusive or, then multiplied.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// A line of a manifest that is an object.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    input: PathBuf,
    output: Option<PathBuf>,
    #[serde(default)]
    options: Vec<String>,
}

/// The largest manifest, in bytes.
const MOST: u64 = 1 << 30;

/// The inputs of a manifest: a path for each line, or a JSON object with `input`, and optionally `output` and `options`. Empty lines
/// are skipped.
///
/// # Errors
/// If the manifest cannot be read, or the first line that is neither.
fn manifest(path: &Path) -> Result<Vec<Input>, Failure> {
    let name = Source::of(path).name();
    let fail =
        |place: &str, found: &str, advice: &str| Failure::input(format!("{place}: {found}{HELP}{advice}"));
    let mut bytes = Vec::new();
    let read = match Source::of(path) {
        Source::Standard => std::io::stdin().lock().take(MOST).read_to_end(&mut bytes),
        Source::File(path) => {
            std::fs::File::open(path).and_then(|file| file.take(MOST).read_to_end(&mut bytes))
        }
    };
    read.map_err(|error| fail(&name, &error.to_string(), "check the path of the manifest"))?;
    if bytes.len() as u64 == MOST {
        return Err(fail(&name, &format!("the manifest has more than {MOST} bytes"), "divide it"));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        fail(&format!("{name}:{line}"), "the line is not UTF-8", "store the manifest as UTF-8")
    })?;
    let mut inputs = Vec::new();
    let lines = text.trim_start_matches('\u{feff}').lines().map(|line| line.trim_end_matches('\r'));
    for (number, line) in lines.enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let place = format!("{name}:{}", number + 1);
        let Line { input, output, options } = if line.trim_start().starts_with('{') {
            serde_json::from_str(line).map_err(|error| {
                // The line of the error is always 1.
                let error = error.to_string().replace(" at line 1 ", " at ");
                fail(
                    &place,
                    &format!("not an object with `input`, and optionally `output` and `options`: {error}"),
                    "write a path, or {\"input\": \"…\", \"output\": \"…\", \"options\": [\"--crease\", \"40\"]}",
                )
            })?
        } else {
            Line { input: PathBuf::from(line), output: None, options: Vec::new() }
        };
        if [Some(&input), output.as_ref()].into_iter().flatten().any(|path| path.as_os_str() == "-") {
            let found = "`-` is standard input or output, which a batch does not use";
            return Err(fail(&place, found, "name a file; `./-` is a file with the name `-`"));
        }
        let source = Source::File(input.clone());
        inputs.push(Input { source, place: below(&input), output, options, line: Some(place) });
    }
    if inputs.is_empty() {
        return Err(fail(&name, "the manifest names no file", "write a path on each line"));
    }
    Ok(inputs)
}

/// The path below an output folder: the same folders, without the root and steps upwards.
fn below(path: &Path) -> PathBuf {
    path.components().filter(|part| matches!(part, Component::Normal(_))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_input_is_in_one_shard_and_shards_are_stable() {
        // Published values of FNV-1a.
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
        for name in ["a.obj", "b/c.stl", "ä.ply"] {
            let takers = (0..5).filter(|i| shard(&format!("{i}/5")).unwrap().takes(name));
            assert_eq!(takers.count(), 1, "{name}");
        }
        for wrong in ["", "1", "4/4", "-1/4", "0/0", "a/b", "1/2/3"] {
            assert!(shard(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_manifest_has_paths_and_objects() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("list");
        std::fs::write(&file, "a/b.obj\n\n{\"input\": \"../c.stl\", \"output\": \"d.glb\"}\r\n").unwrap();
        let inputs = manifest(&file).unwrap();
        assert_eq!(inputs.len(), 2);
        assert_eq!(inputs[0].place, Path::new("a/b.obj"));
        assert_eq!(
            (&*inputs[1].place, inputs[1].output.as_deref()),
            (Path::new("c.stl"), Some(Path::new("d.glb")))
        );
        for (text, found) in [
            ("a.obj\n{\"input\": 7}\n", "list:2: not an object"),
            ("a.obj\n\n-\n", "list:3: `-` is standard input"),
            ("{\"input\": \"a.obj\", \"output\": \"-\"}", "list:1: `-` is standard input"),
            ("{\"input\": \"a\", \"to\": \"glb\"}", "unknown field `to`"),
            ("\n \n", "names no file"),
        ] {
            std::fs::write(&file, text).unwrap();
            let message = manifest(&file).unwrap_err().message;
            assert!(message.contains(found), "{message}");
        }
        std::fs::write(&file, b"a.obj\nb\xff.obj\n").unwrap();
        assert!(manifest(&file).unwrap_err().message.contains("list:2: the line is not UTF-8"));
        assert!(manifest(&folder.path().join("missing")).unwrap_err().message.contains("check the path"));
    }
}

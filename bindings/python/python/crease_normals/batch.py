"""Batches of `crease normals` over processes, or over a Ray cluster.

    python -m crease_normals.batch --manifest list.txt --out out -- --crease 40
    python -m crease_normals.batch --manifest list.txt --out s3://bucket/out --ray auto -- --to glb

The driver divides the inputs into chunks. A worker runs the program on a chunk, so that the outputs have the same bytes as those of
the program alone, and returns the lines of its journal. The driver adds them to the journal of the batch. Paths must mean the same
on all workers; URLs need fsspec.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import socket
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import nullcontext, suppress
from pathlib import Path, PurePosixPath
from typing import IO, Any, Callable, Iterable, Iterator, NamedTuple, Optional
from urllib.parse import unquote

from ._native import check_batch

try:
    import fcntl
except ImportError:
    fcntl = None  # Windows: the journal has no lock.

# Options of the program that the driver sets or that would omit outputs.
FIXED = {"--manifest", "--shard", "--journal", "--dry-run", "--out-dir", "--in-place", "-o", "--output", "--json"}

PROGRAM = [sys.executable, "-m", "crease_normals", "normals"]


class Job(NamedTuple):
    """An input, its output, and options for it alone."""

    input: str
    output: str
    options: list[str]


class Chunk(NamedTuple):
    """Some inputs for one worker, with their entries of the journal so far."""

    jobs: list[Job]
    entries: list[dict[str, Any]]
    options: list[str]


def is_url(name: str) -> bool:
    return "://" in name


def read_manifest(path: str, out: str, options: list[str]) -> list[Job]:
    """The jobs of a manifest: a path or URL on each line, or an object with `input`, and perhaps `output` and `options`.

    Raises ValueError with the number of the line."""
    if not out:
        raise ValueError("--out is empty; name a folder or a URL")
    # Names of files may have carriage returns, and editors write byte order marks.
    source = sys.stdin if path == "-" else open(path, encoding="utf-8-sig", newline="\n")
    jobs, places = [], []
    refused = {word.split("=")[0] for word in options} & FIXED
    if refused:
        raise ValueError(f"{min(refused)} is set by the batch itself")
    with source:
        for number, line in enumerate(source, 1):
            line = line.rstrip("\r\n")
            if not line.strip():
                continue
            entry = {"input": line}
            if line.startswith("{"):
                try:
                    entry = json.loads(line)
                    unknown = entry.keys() - {"input", "output", "options"}
                except ValueError as error:
                    raise ValueError(f"{path}: line {number}: {error}") from None
                own = entry.get("options", [])
                names = [entry.get("input"), entry.get("output", "")]
                is_right = all(isinstance(it, str) for it in [*names, *own]) if isinstance(own, list) else False
                if unknown or not is_right:
                    raise ValueError(f"{path}: line {number}: expected `input`, and optionally `output` and `options`")
            own = list(entry.get("options", []))
            name = absolute(entry["input"])
            output = entry.get("output") or below(out, entry["input"], options + own)
            jobs.append(Job(name, absolute(output), own))
            places.append(f"{path}: line {number}")
    if not jobs:
        raise ValueError(f"{path}: the manifest names no file")
    check_batch([(place, *job) for place, job in zip(places, jobs)], options)
    check_protocols({name.split("://", 1)[0] for job in jobs for name in job[:2] if is_url(name)})
    return jobs


def check_protocols(protocols: set[str]) -> None:
    """Raises ValueError for a protocol that fsspec does not know, and ImportError if a package for it is missing."""
    if protocols:
        import fsspec

        for protocol in sorted(protocols):
            fsspec.get_filesystem_class(protocol)


def absolute(name: str) -> str:
    """A name that means the same in every working folder, with one spelling. `file://` is a path."""
    if name.startswith("file://"):
        name = name[len("file://"):]
    if not is_url(name):
        return os.path.abspath(name)
    protocol, path = name.split("://", 1)
    # The path of an address in memory may begin with a slash.
    return f"{protocol}://{path.lstrip('/') if protocol == 'memory' else path}"


def below(out: str, name: str, options: list[str]) -> str:
    """The output of an input below a folder: the same folders, and the ending that `--to` names."""
    parts = [part for part in PurePosixPath(name.split("://")[-1]).parts if part not in ("/", "..", ".")]
    place = PurePosixPath(*parts)
    words = [word for option in options for word in option.split("=", 1)]
    if "--to" in words:
        place = place.with_suffix("." + words[len(words) - 1 - words[::-1].index("--to") + 1])
    return f"{out.rstrip('/')}/{place}"


def run_chunk(chunk: Chunk) -> list[dict[str, Any]]:
    """Runs the program on a chunk; returns the new entries of its journal. Entries that hold already are not repeated.

    Raises RuntimeError if the program was killed, and ValueError if it refuses the options."""
    with tempfile.TemporaryDirectory(prefix="crease-") as name:
        folder = Path(name)
        copies = Copies(chunk, folder)
        copies.fetch()
        journal = folder / "journal"
        old = [json.dumps(renamed(entry, copies.here)) + "\n" for entry in chunk.entries]
        journal.write_text("".join(old), encoding="utf-8")
        before = journal.stat().st_size
        jobs = [
            {"input": copies.here(job.input), "output": copies.here(job.output), "options": job.options}
            for job in chunk.jobs
        ]
        done = subprocess.run(
            [*PROGRAM, "--manifest", "-", "--journal", str(journal), *chunk.options, "--json"],
            input="".join(json.dumps(job) + "\n" for job in jobs),
            cwd=folder if copies.folders else None,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            errors="replace",
        )
        if done.returncode == 2:
            raise ValueError(done.stderr.strip().removeprefix("error: "))
        if done.returncode not in (0, 3, 4, 5):
            raise RuntimeError(done.stderr.strip() or f"the program ended with {done.returncode}")
        with journal.open(encoding="utf-8") as file:
            file.seek(before)
            # A full disk may cut the last line.
            entries = [json.loads(line) for line in file if line.endswith("}\n")]
        known = {entry.get("output") for entry in [*chunk.entries, *(renamed(entry, copies.there) for entry in entries)]}
        if done.returncode == 4 and any(job.output not in known for job in chunk.jobs):
            raise RuntimeError(done.stderr.strip() or "the journal of a chunk could not be written")
        copies.store(entries)
        return [renamed(entry, copies.there) for entry in entries]


def renamed(entry: dict[str, Any], name: Callable[[str], str]) -> dict[str, Any]:
    """An entry with other names of files."""
    hashes = {key: {name(path): value for path, value in entry.get(key, {}).items()} for key in ("read", "written")}
    output = {"output": name(entry["output"])} if "output" in entry else {}
    return {**entry, "input": name(entry["input"]), **output, **hashes}


class Copies:
    """The files of a chunk that are at URLs, and their copies in a local folder."""

    def __init__(self, chunk: Chunk, root: Path) -> None:
        self.chunk, self.root = chunk, root
        urls = {name.rsplit("/", 1)[0] for job in chunk.jobs for name in (job.input, job.output) if is_url(name)}
        self.folders = {url + "/": f"{number}/" for number, url in enumerate(sorted(urls, key=len, reverse=True))}

    def here(self, name: str) -> str:
        """The local name of a file at a URL. Other names stay."""
        found = ((url, folder) for url, folder in self.folders.items() if name.startswith(url))
        return next((folder + name[len(url) :] for url, folder in found), name)

    def there(self, name: str) -> str:
        """The URL of a local name. Other names stay."""
        name = name.removeprefix(f"{self.root}/")
        found = ((url, folder) for url, folder in self.folders.items() if name.startswith(folder))
        return next((url + name[len(folder) :] for url, folder in found), name)

    def copy(self, url: str, to: Optional[str] = None) -> bool:
        """Copies a file to its local name, and to another one, if there is a file at the URL."""
        import fsspec

        filesystem, path = fsspec.core.url_to_fs(url)
        is_there = filesystem.exists(path)
        for name in {self.here(url), to or self.here(url)} if is_there else ():
            place = self.root / name
            place.parent.mkdir(parents=True, exist_ok=True)
            filesystem.get_file(path, str(place))
        return is_there

    def fetch(self) -> None:
        """Copies inputs, with the files that they refer to, and what an earlier run wrote."""
        for folder in self.folders.values():
            (self.root / folder).mkdir()
        for job in self.chunk.jobs:
            if is_url(job.input) and self.copy(job.input):
                # Also next to the copy of the file that names them, if they are in the folder of another input.
                folder, here = (name.rsplit("/", 1)[0] for name in (job.input, self.here(job.input)))
                for name in companions(self.root / self.here(job.input)):
                    if self.copy(f"{folder}/{name}", f"{here}/{name}"):
                        # The images of a material library.
                        for image in companions(self.root / f"{here}/{name}"):
                            self.copy(f"{folder}/{image}", f"{here}/{image}")
        for name in (name for entry in self.chunk.entries for name in entry.get("written", {})):
            if is_url(name):
                self.copy(name)

    def store(self, entries: list[dict[str, Any]]) -> None:
        """Copies what was written to its URL: companions first, so that a reader of the main file finds them."""
        for entry in entries:
            for name in sorted(entry["written"], key=lambda name: name == entry.get("output")):
                url = self.there(name)
                if is_url(url):
                    import fsspec

                    filesystem, target = fsspec.core.url_to_fs(url)
                    filesystem.makedirs(target.rsplit("/", 1)[0], exist_ok=True)
                    filesystem.put_file(str(self.root / name), target)


# How files name others.
PATTERNS = {
    ".gltf": r'"uri"\s*:\s*"([^"]+)"',
    ".obj": r"(?m)^mtllib[ \t]+(.+?)\s*$",
    ".mtl": r"(?mi)^\s*(?:map_\w+|norm|bump|disp|decal|refl)[ \t]+(?:.*[ \t])?(\S+)\s*$",
}


def companions(path: Path) -> Iterable[str]:
    """The relative names in a glTF, OBJ or MTL file, which lie in its folder or below."""
    pattern = PATTERNS.get(path.suffix.lower())
    found = re.findall(pattern, path.read_text(encoding="utf-8", errors="replace")) if pattern else []
    names = (unquote(name) if path.suffix.lower() == ".gltf" else name for name in found)
    return (name for name in names if ":" not in name and not name.startswith("/") and ".." not in name.split("/"))


def chunks(jobs: list[Job], size: int, known: dict[str, dict[str, Any]], options: list[str]) -> Iterator[Chunk]:
    for start in range(0, len(jobs), size):
        part = jobs[start : start + size]
        yield Chunk(part, [known[job.output] for job in part if job.output in known], options)


def on_processes(all_chunks: Iterator[Chunk], workers: int, retries: int) -> Iterator[tuple[Chunk, Any]]:
    """Runs chunks on local processes; yields each with its entries or its exception. At most two for each worker wait."""

    def tried(chunk: Chunk) -> list[dict[str, Any]]:
        for attempt in range(retries + 1):
            try:
                return run_chunk(chunk)
            except RuntimeError:
                if attempt == retries:
                    raise
        raise AssertionError("unreachable")

    with ThreadPoolExecutor(workers) as pool:
        pending: dict[Future[list[dict[str, Any]]], Chunk] = {}
        for chunk in all_chunks:
            pending[pool.submit(tried, chunk)] = chunk
            while len(pending) >= 2 * workers:
                yield from finished(pending)
        while pending:
            yield from finished(pending)


def finished(pending: dict[Future[Any], Chunk]) -> Iterator[tuple[Chunk, Any]]:
    for future in wait(pending, return_when=FIRST_COMPLETED).done:
        yield pending.pop(future), future.exception() or future.result()


def on_ray(all_chunks: Iterator[Chunk], address: str, retries: int) -> Iterator[tuple[Chunk, Any]]:
    """Runs chunks as tasks of a Ray cluster. If a worker dies, Ray repeats its tasks on another worker."""
    import ray

    if not ray.is_initialized():
        host, _, port = address.removeprefix("ray://").rpartition(":")
        try:
            if host and port.isdecimal():
                # Ray itself tries an address again and again, without a message.
                socket.create_connection((host.strip("[]"), int(port)), timeout=10).close()
            ray.init(address=None if address == "local" else address, log_to_driver=False)
        except OSError as error:
            advice = "start one with `ray start --head`, or choose --ray local"
            raise ValueError(f"no Ray cluster at the address {address!r}: {advice}") from error
    task = ray.remote(max_retries=retries, retry_exceptions=[RuntimeError])(run_chunk)
    most = 2 * max(1, int(ray.cluster_resources().get("CPU", 1)))
    pending: dict[Any, Chunk] = {}

    def ready() -> Iterator[tuple[Chunk, Any]]:
        done, _ = ray.wait(list(pending), num_returns=1)
        for reference in done:
            chunk = pending.pop(reference)
            try:
                yield chunk, ray.get(reference)
            except Exception as error:  # noqa: BLE001 - whatever a task raised belongs to its chunk
                yield chunk, error

    for chunk in all_chunks:
        pending[task.remote(chunk)] = chunk
        while len(pending) >= most:
            yield from ready()
    while pending:
        yield from ready()


def open_journal(path: str) -> IO[str]:
    """Opens the journal for appending, and creates it if there is none. Like the program, it locks the file until it is closed.

    Raises ValueError if another run writes it."""
    file = open(path, "a+", encoding="utf-8", errors="replace")
    if fcntl:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            file.close()
            raise ValueError(f"another run writes the journal {path}; name a journal for each run") from None
        except OSError:
            pass  # A file system without locks.
    return file


def read_entries(file: IO[str]) -> dict[str, dict[str, Any]]:
    """The last entry for each output. Lines that a stopped run left incomplete are skipped, and the last one is ended.

    Raises OSError for a file that has none and is not empty."""
    entries: dict[str, dict[str, Any]] = {}
    file.seek(0)
    line, lines = "", 0
    for line in file:
        lines += 1
        try:
            entry = json.loads(line)
        except ValueError:
            continue
        if isinstance(entry, dict) and "status" in entry:
            entries[entry.get("output", "")] = entry
    # Before its first entry a stopped run may leave a part of that. Other files are not to be changed.
    if lines and not entries and (lines > 1 or line.endswith("\n") or not line.startswith("{")):
        raise OSError(f"{file.name} is not a journal: it has no entry; name another file")
    if line and not line.endswith("\n"):
        file.write("\n")
    return entries


def write_table(path: str, entries: list[dict[str, Any]]) -> None:
    """A row for each input: Parquet by the name, else lines of JSON. An older table is replaced as a whole or not at all."""
    rows = [
        {**entry, "read": json.dumps(entry.get("read", {})), "written": json.dumps(entry.get("written", {}))}
        for entry in entries
    ]
    part = f"{path}.part"
    try:
        if path.endswith(".parquet"):
            import pyarrow
            import pyarrow.parquet

            columns = sorted({key for row in rows for key in row})
            table = pyarrow.table({key: [row.get(key) for row in rows] for key in columns})
            pyarrow.parquet.write_table(table, part)
        else:
            Path(part).write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")
        os.replace(part, path)
    except OSError as error:
        with suppress(OSError):
            os.unlink(part)
        raise OSError(f"{path}: the table was not written: {error}") from error


def run(
    manifest: str,
    out: str,
    options: Optional[list[str]] = None,
    *,
    ray: Optional[str] = None,
    workers: Optional[int] = None,
    chunk: int = 32,
    retries: int = 3,
    journal: Optional[str] = None,
    table: Optional[str] = None,
    report: Callable[[str], None] = lambda _: None,
) -> Counter[str]:
    """Runs a batch and counts the files by outcome: "done", "failed", "skipped" (the journal has them, and nothing has changed).

    `ray` is the address of a cluster ("auto", "local" for a new one, or host:port); without it, `workers` local processes run.
    `journal` is a file to which entries are added, by one run at a time; `table` receives a row for each input.

    Raises ValueError for wrong manifests and options, OSError for files that cannot be read or written."""
    options = list(options or [])
    jobs = read_manifest(manifest, out, options)
    counts: Counter[str] = Counter()
    with open_journal(journal) if journal else nullcontext() as file:
        known = read_entries(file) if file else {}
        parts = chunks(jobs, chunk, known, options)
        owners: dict[str, tuple[str, str]] = {}
        results = on_ray(parts, ray, retries) if ray else on_processes(parts, workers or os.cpu_count() or 1, retries)
        for part, result in results:
            if isinstance(result, ValueError):
                raise result
            if isinstance(result, Exception):
                result = [failed(job, result) for job in part.jobs]
            for entry in (without_clash(entry, owners) for entry in result):
                known[entry.get("output", "")] = entry
                counts[entry["status"]] += 1
                if file:
                    file.write(json.dumps(entry) + "\n")
                if entry["status"] == "failed":
                    report(f"{entry['input']}: {entry.get('error', '')}")
            if file:
                file.flush()
            counts["skipped"] += len(part.jobs) - len(result)
    if table:
        write_table(table, [known[job.output] for job in jobs if job.output in known])
    return counts


def without_clash(entry: dict[str, Any], owners: dict[str, tuple[str, str]]) -> dict[str, Any]:
    """An entry, or its failure if another input of this run wrote one of its files with other bytes. `owners` has the hash of each
    file, and the output that it belongs to."""
    for path, content in entry.get("written", {}).items():
        first, owner = owners.setdefault(path, (content, entry["output"]))
        if first != content:
            error = f"{path} belongs to {owner} too, with other bytes; give both outputs folders of their own"
            return {**entry, "status": "failed", "error": error}
    return entry


def failed(job: Job, error: Exception) -> dict[str, Any]:
    """The entry of a job whose worker could not do it."""
    empty: dict[str, Any] = {"bytes": 0, "crease": "", "options": "", "read": {}, "written": {}, "faults": 0, "seconds": 0.0}
    line = {"input": job.input, "verb": "normals", "line_options": job.options, "output": job.output}
    return {**line, "status": "failed", **empty, "error": str(error)}


def main(words: Optional[list[str]] = None) -> int:
    """The command. Exit codes as of the program: 0, 2 (usage), 4 (journal or table), 5 (some files failed)."""
    parser = argparse.ArgumentParser(
        prog="python -m crease_normals.batch",
        description="Runs `crease normals` over many files, on local processes or on a Ray cluster.",
        epilog="Options after -- are those of `crease normals`, such as: -- --crease 40 --to glb",
    )
    parser.add_argument("--manifest", required=True, help="list of paths or URLs, or lines of JSON; - is standard input")
    parser.add_argument("--out", required=True, help="folder or URL for the outputs")
    parser.add_argument("--ray", metavar="ADDRESS", help="Ray cluster: auto, host:port, or local for a new one")
    parser.add_argument("--workers", type=int, help="local processes (default: one for each processor)")
    parser.add_argument("--chunk", type=int, default=32, help="inputs for one call of the program (default: 32)")
    parser.add_argument("--retries", type=int, default=3, help="further tries for a chunk whose worker died (default: 3)")
    parser.add_argument("--journal", help="file that receives a line for each input; a later run skips what is done")
    parser.add_argument("--table", help="results, a row for each input: .parquet (needs pyarrow) or .jsonl")
    parser.add_argument("options", nargs="*", help=argparse.SUPPRESS)
    args = vars(parser.parse_args(words))
    for name, least in (("workers", 1), ("chunk", 1), ("retries", 0)):
        if args[name] is not None and args[name] < least:
            parser.error(f"--{name} is at least {least}")
    try:
        counts = run(args.pop("manifest"), args.pop("out"), args.pop("options"), report=print_error, **args)
    except ValueError as error:
        parser.error(str(error))
    except (OSError, ImportError) as error:
        print_error(f"error: {error}")
        return 4
    except KeyboardInterrupt:
        print_error("interrupted; with --journal, the same command continues")
        return 130
    print(", ".join(f"{counts[key]} {key}" for key in ("done", "failed", "skipped")))
    return 5 if counts["failed"] else 0


def print_error(text: str) -> None:
    print(text, file=sys.stderr)


if __name__ == "__main__":
    sys.exit(main())

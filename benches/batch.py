"""Speed and memory of batches: python benches/batch.py [SMALL FILES] [LARGE FILES].

Small files are OBJ files of 1 kB, with a journal; large ones are GLB files of a million triangles. All are converted to GLB, in a
temporary folder: TMPDIR chooses the storage. The environment variable CREASE names the program. The table is in docs/batches.md.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
CREASE = os.environ.get("CREASE", str(ROOT / "target/release/crease"))


def run(*options):
    """Seconds and peak memory in bytes of the program."""
    start = time.perf_counter()
    process = subprocess.Popen([CREASE, *map(str, options)])
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - start
    assert status == 0, options
    return seconds, 1024 * usage.ru_maxrss


def batch(files, folder, jobs, *options):
    """The shortest of three runs, and the largest memory."""
    (folder / "list").write_text("".join(f"{file}\n" for file in files))
    runs = []
    for _ in range(3):
        shutil.rmtree(folder / "out", ignore_errors=True)
        (folder / "journal").unlink(missing_ok=True)
        runs.append(run("normals", "--manifest", folder / "list", "--out-dir", folder / "out", "--to", "glb", "--jobs", jobs, "-q", *options))
    return min(seconds for seconds, _ in runs), max(memory for _, memory in runs)


def row(name, files, jobs, seconds, memory):
    size = sum(file.stat().st_size for file in files)
    rates = f"{len(files) / seconds:.0f} | {size / 1e6 / seconds:.1f}" if jobs else " | "
    print(f"| {name} | {len(files)} | {jobs or ''} | {seconds:.2f} | {rates} | {memory / 1e6:.0f} |", flush=True)


def merge(folder, small):
    """Seconds to merge ten journals."""
    text = (folder / "journal").read_text()
    journals = [folder / f"journal-{number}" for number in range(10)]
    for number, journal in enumerate(journals):
        journal.write_text(text.replace('"input":"', f'"input":"{number}'))
    with open(folder / "merged", "wb") as merged:
        start = time.perf_counter()
        subprocess.run([CREASE, "journal", "merge", *journals], stdout=merged, check=True)
        seconds = time.perf_counter() - start
    notes.append(f"journal: {len(text) / small:.0f} bytes a file; merging {10 * small / seconds:.0f} lines a second")


def share(folder, lines):
    """Seconds and memory for an empty share of a long list."""
    with open(folder / "long", "w") as long:
        long.writelines(f"set-{number // 1000}/{number}.obj\n" for number in range(lines))
    words = ["normals", "--manifest", folder / "long", "--out-dir", folder / "out", "--to", "glb", "--dry-run", "-q"]
    seconds, memory = run(*words, "--shard", f"0/{1 << 62}")
    notes.append(f"a share without files of a list of {lines} lines: {seconds:.1f} s, {memory / 1e6:.0f} MB")


notes = []


def main():
    small, large = map(int, [*sys.argv[1:3], *["10000", "20"][len(sys.argv) - 1 :]])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        mesh = (ROOT / "data/bracket.obj").read_text()
        few = []
        for number in range(small):
            file = folder / f"{number // 1000}/{number}.obj"
            file.parent.mkdir(exist_ok=True)
            file.write_text(f"# {number}\n{mesh}")
            few.append(file)
        start = min(run("normals", few[0], "-o", folder / "one.glb", "-q")[0] for _ in range(10))
        print(f"start of a process with one small file: {1e3 * start:.1f} ms\n")
        print("| files | number | jobs | s | files/s | MB/s | peak MB |\n|---|---:|---:|---:|---:|---:|---:|")
        journal = ["--journal", folder / "journal"]
        for count in sorted({max(small // 10, 1), small}):
            for jobs in (1, 2):
                row("small", few[:count], jobs, *batch(few[:count], folder, jobs, *journal))
        again = run("normals", "--manifest", folder / "list", "--out-dir", folder / "out", "--to", "glb", "-q", *journal)
        row("small, again", few, 0, *again)
        merge(folder, small)
        share(folder, 100 * small)
        many = [folder / f"large-{number}.glb" for number in range(large)]
        run("surface", "torus", "--segments", "1000x500", "-o", many[0], "-q")
        for file in many[1:]:
            shutil.copyfile(many[0], file)
        for jobs in (1, 2):
            row("large", many, jobs, *batch(many, folder, jobs, "--crease", "off"))
    print()
    print(*notes, sep="\n")


if __name__ == "__main__":
    main()

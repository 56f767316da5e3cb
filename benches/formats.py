"""Time and memory of conversions to GLB: python benches/formats.py [ROUNDS] [SEGMENTS].

A torus of a million triangles in each format, with `--crease off`, in turn with a copy of the input. Medians; the table is in
docs/speed.md. The environment variable CREASE names the program, TMPDIR chooses the storage.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

CREASE = os.environ.get("CREASE", str(Path(__file__).parent.parent / "target/release/crease"))


def run(words):
    """Seconds and peak memory in bytes of a program."""
    start = time.perf_counter()
    process = subprocess.Popen(list(map(str, words)))
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - start
    assert status == 0, words
    return seconds, 1024 * usage.ru_maxrss


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 8
    segments = sys.argv[2] if len(sys.argv) > 2 else "1000x500"
    print("| from | MB | s | times `cp` | memory ÷ input |\n|---|---:|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for ending in ("obj", "ply", "glb", "stl"):
            file, output = folder / f"torus.{ending}", folder / "out.glb"
            run([CREASE, "surface", "torus", "--segments", segments, "-q", "-o", file])
            own, copies = [], []
            for _ in range(rounds):
                copies.append(run(["cp", file, folder / "copy"])[0])
                own.append(run([CREASE, "normals", file, "--crease", "off", "-q", "-o", output]))
                # The next round writes both anew.
                output.unlink()
                (folder / "copy").unlink()
            seconds, memory = (statistics.median(column) for column in zip(*own))
            size = file.stat().st_size
            factor = seconds / statistics.median(copies)
            print(f"| {ending.upper()} | {size / 1e6:.1f} | {seconds:.2f} | {factor:.1f} | {memory / size:.1f} |", flush=True)


if __name__ == "__main__":
    main()

"""Speed and memory next to other Python packages, in one run: python bench.py [TRIANGLES] [REPEATS].

Each package gets arrays of the types that it stores itself. The shortest of several runs counts. The table is in docs/python.md.
"""

import importlib
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent / "tests"))

from conftest import grid  # noqa: E402

import crease_normals as crease  # noqa: E402


def shortest(call, repeats):
    """Seconds of the shortest run of a call whose argument is made anew, outside the time."""
    times = []
    for _ in range(repeats):
        arguments = call.prepare()
        start = time.perf_counter()
        call.run(arguments)
        times.append(time.perf_counter() - start)
    return min(times)


class Call:
    def __init__(self, run, prepare=lambda: None):
        self.run, self.prepare = run, prepare


def ours(weight, dtype, precision="faithful", threads=None):
    def make(vertices, faces):
        vertices = vertices.astype(dtype)
        return Call(lambda _: crease.vertex_normals(vertices, faces, weight=weight, precision=precision, threads=threads))

    return make


def trimesh(vertices, faces):
    import trimesh

    def prepare():
        return trimesh.Trimesh(vertices, faces, process=False)

    return Call(lambda mesh: mesh.vertex_normals, prepare)


def igl(weight):
    def make(vertices, faces):
        igl = importlib.import_module("igl")
        kind = getattr(igl, f"PER_VERTEX_NORMALS_WEIGHTING_TYPE_{weight.upper()}")
        faces = faces.astype(np.int64)
        return Call(lambda _: igl.per_vertex_normals(vertices, faces, weighting=kind))

    return make


def open3d(vertices, faces):
    o3d = importlib.import_module("open3d")
    arrays = o3d.utility.Vector3dVector(vertices), o3d.utility.Vector3iVector(faces.astype(np.int32))
    # A mesh keeps the normals of its triangles: each run has a new one.
    return Call(lambda mesh: mesh.compute_vertex_normals(), lambda: o3d.geometry.TriangleMesh(*arrays))


def pymeshlab(mode):
    def make(vertices, faces):
        pymeshlab = importlib.import_module("pymeshlab")
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(vertices, faces.astype(np.int32)))
        return Call(lambda _: meshes.compute_normal_per_vertex(weightmode=mode))

    return make


CASES = {
    "area": [
        ("crease, float32", ours("area", np.float32)),
        ("crease, float32, one thread", ours("area", np.float32, threads=1)),
        ("crease, float32, fast", ours("area", np.float32, "fast")),
        ("crease, float64", ours("area", np.float64)),
        ("igl", igl("area")),
        ("Open3D", open3d),
        ("pymeshlab", pymeshlab("By Area")),
    ],
    "angle": [
        ("crease, float32", ours("angle", np.float32)),
        ("crease, float32, one thread", ours("angle", np.float32, threads=1)),
        ("crease, float32, fast", ours("angle", np.float32, "fast")),
        ("crease, float64", ours("angle", np.float64)),
        ("igl", igl("angle")),
        ("trimesh", trimesh),
        ("pymeshlab", pymeshlab("By Angle")),
    ],
}

MEMORY = """
import resource, sys
sys.path.insert(0, {folder!r})
import bench
vertices, faces = bench.grid({side})
make = dict(bench.CASES[{weight!r}])[{name!r}]
call = make(vertices, faces)
argument = call.prepare()
# Peak memory grows from here on by what the call needs.
open("/proc/self/clear_refs", "w").write("5")
def peak(field):
    return int(next(line for line in open("/proc/self/status") if line.startswith(field)).split()[1])
before = peak("VmRSS")
call.run(argument)
print(1024 * (peak("VmHWM") - before))
"""


def memory(weight, name, side):
    """Bytes by which the memory of a fresh process grows during a call; None where Linux does not measure it."""
    code = MEMORY.format(folder=str(Path(__file__).parent), side=side, weight=weight, name=name)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    return int(done.stdout.split()[-1]) if done.returncode == 0 else None


def main():
    triangles = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    side = round((triangles / 2) ** 0.5)
    vertices, faces = grid(side)
    print(f"{len(faces)} triangles, {len(vertices)} vertices, shortest of {repeats} runs\n")
    print("| weight | package | ms | M triangles/s | extra memory, MB |\n|---|---|---:|---:|---:|")
    for weight, calls in CASES.items():
        seconds = {}
        for name, make in calls:
            try:
                seconds[name] = shortest(make(vertices, faces), repeats)
            except ImportError:
                print(f"| {weight} | {name} | not installed | | |")
                continue
            extra = memory(weight, name, side)
            extra = "" if extra is None else f"{extra / 1e6:.0f}"
            print(f"| {weight} | {name} | {1e3 * seconds[name]:.1f} | {len(faces) / 1e6 / seconds[name]:.1f} | {extra} |", flush=True)
        others = {name: time for name, time in seconds.items() if not name.startswith("crease")}
        if others:
            fastest = min(others, key=others.get)
            slowest_of_ours = max(seconds["crease, float32"], seconds["crease, float64"])
            print(f"\n{weight}: the fastest of the others is {fastest}; crease with float64 is {others[fastest] / seconds['crease, float64']:.1f} times as fast, "
                  f"with float32 {others[fastest] / seconds['crease, float32']:.1f} times, at least {others[fastest] / slowest_of_ours:.1f}\n")


if __name__ == "__main__":
    main()

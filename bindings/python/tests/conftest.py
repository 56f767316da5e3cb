"""Meshes that the tests share."""

import os
from pathlib import Path

import numpy as np
import pytest

import crease_normals as crease

ROOT = Path(__file__).resolve().parents[3]
DATA = ROOT / "data"


def grid(side, dtype=np.float64, seed=7):
    """A hilly grid of 2 * side * side triangles, jittered so that all triangles differ."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.linspace(0, 1, side + 1), np.linspace(0, 1, side + 1), indexing="ij")
    step = 1 / side
    x = x + rng.uniform(-0.3, 0.3, x.shape) * step
    y = y + rng.uniform(-0.3, 0.3, y.shape) * step
    z = 0.2 * np.sin(7 * x) * np.cos(5 * y)
    vertices = np.stack([x, y, z], axis=-1).reshape(-1, 3).astype(dtype)
    at = np.arange(side * (side + 1)).reshape(side, side + 1)[:, :-1].ravel()
    a, b, c, d = at, at + side + 1, at + side + 2, at + 1
    faces = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3).astype(np.uint32)
    return vertices, faces


def cube():
    vertices = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=np.float64)
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    indices = np.array(quads, dtype=np.uint32).ravel()
    return vertices, (indices, np.arange(0, 25, 4, dtype=np.uint32))


def triangulated(faces):
    """Polygons as triangles from their first corners."""
    if not isinstance(faces, tuple):
        return faces
    indices, offsets = faces
    fans = (
        (indices[start], indices[at], indices[at + 1])
        for start, end in zip(offsets[:-1], offsets[1:])
        for at in range(start + 1, end - 1)
    )
    return np.array(list(fans), dtype=np.uint32)


def mesh_files():
    """Files of the repository, and real meshes if the folder with them is there."""
    names = ["gear.obj", "bracket.obj", "polygons.obj", "leaf.ply", "part.stl", "part-binary.stl", "mirrored.gltf", "sphere-seam.glb"]
    files = [DATA / name for name in names]
    meshes = Path(os.environ.get("CREASE_MESHES", ROOT.parent / "shared" / "meshes"))
    real = [path for path in sorted(meshes.glob("*/*")) if path.suffix in {".obj", ".ply", ".stl"} and path.parent.name != "bad"]
    return files, [path for path in real if path.stat().st_size < 3_000_000]


def parts_of_files():
    """The meshes of all files that can be read, by name."""
    files, real = mesh_files()
    for path in files + real:
        try:
            parts = crease.read(path).parts
        except crease.ReadError:
            assert path in real, path
            continue
        for number, part in enumerate(parts):
            if len(part.vertices) and len(triangulated(part.faces)):
                yield f"{path.name}#{number}", part


@pytest.fixture(scope="session")
def all_parts():
    files, real = mesh_files()
    if not real:
        print("no folder of real meshes: the files of data/ only")
    parts = dict(parts_of_files())
    assert len(parts) >= len(files)
    return parts


def degrees_between(a, b):
    """Angles between rows, in degrees."""
    a, b = np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64)
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.einsum("ij,ij->i", a, b)))

"""Normals of arrays: types, layouts, results, refusals, memory."""

import subprocess
import sys
import tracemalloc

import numpy as np
import pytest
from conftest import cube, degrees_between, grid, triangulated

import crease_normals as crease

WEIGHTS = ["uniform", "area", "angle", "angle-area", "max", "edge"]


def is_unit(normals):
    return np.allclose(np.linalg.norm(normals.astype(np.float64), axis=1), 1, rtol=0, atol=3e-7)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_the_dtype_of_vertices_is_that_of_normals(dtype):
    vertices, faces = grid(20, dtype)
    before = vertices.copy(), faces.copy()
    for result in [
        crease.vertex_normals(vertices, faces),
        crease.face_normals(vertices, faces),
        crease.corner_normals(vertices, faces)[0],
        crease.split(vertices, faces)[2],
    ]:
        assert result.dtype == dtype and result.shape[1] == 3 and is_unit(result)
    assert (vertices == before[0]).all() and (faces == before[1]).all()


@pytest.mark.parametrize("dtype", ["<i8", "<i4", "<u4", "<u8", "<i2", "<u2", ">i4", ">u4"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_every_integer_type_and_layout_of_faces_is_the_same(dtype, order):
    vertices, faces = grid(20)
    expected = crease.vertex_normals(vertices, faces)
    given = np.array(faces, dtype=dtype, order=order)
    assert (crease.vertex_normals(vertices, given) == expected).all()
    wide = np.zeros((len(faces), 6), dtype=dtype)
    wide[:, ::2] = faces
    assert (crease.vertex_normals(vertices, wide[:, ::2]) == expected).all()


def test_every_layout_of_vertices_is_the_same():
    for dtype in (np.float32, np.float64):
        vertices, faces = grid(20, dtype)
        expected = crease.vertex_normals(vertices, faces)
        misaligned = np.zeros(vertices.nbytes + 1, dtype=np.uint8)[1:].view(dtype).reshape(-1, 3)
        misaligned[:] = vertices
        for given in [
            np.asfortranarray(vertices),
            np.repeat(vertices, 2, axis=0)[::2],
            vertices[::-1][::-1],
            vertices.astype(vertices.dtype.newbyteorder()),
            misaligned,
        ]:
            assert (crease.vertex_normals(given, faces) == expected).all()
        read_only = vertices.copy()
        read_only.flags.writeable = False
        assert (crease.vertex_normals(read_only, faces) == expected).all()


def test_lists_and_integers_are_converted_to_doubles():
    normals = crease.vertex_normals([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert normals.dtype == np.float64 and (normals == [0, 0, 1]).all()
    half = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=np.float16)
    assert crease.face_normals(half, [[0, 1, 2]]).dtype == np.float64


@pytest.mark.parametrize("weight", WEIGHTS + ["quadric", "jet", "best"])
def test_threads_change_no_bit(weight):
    vertices, faces = grid(60, np.float32)
    one = crease.vertex_normals(vertices, faces, weight=weight, threads=1)
    for threads in (None, 2, 3):
        assert (crease.vertex_normals(vertices, faces, weight=weight, threads=threads) == one).all()
    assert is_unit(one)


@pytest.mark.parametrize("weight", WEIGHTS)
@pytest.mark.parametrize("precision", ["faithful", "fast"])
def test_splitting_at_no_angle_is_one_normal_a_vertex(weight, precision):
    vertices, faces = grid(30, np.float32)
    normals = crease.vertex_normals(vertices, faces, weight=weight, precision=precision)
    for crease_angle in (None, 180):
        of_corners, index = crease.corner_normals(vertices, faces, crease=crease_angle, weight=weight, precision=precision)
        assert index.shape == faces.shape and index.dtype == np.uint32
        assert (of_corners[index] == normals[faces]).all()


def test_polygons_and_triangles_agree_on_a_cube():
    vertices, quads = cube()
    triangles = triangulated(quads)
    for weight in WEIGHTS:
        normals, index = crease.corner_normals(vertices, quads, crease=40, weight=weight)
        assert normals.shape == (24, 3) and index.shape == (24,)
        expected = np.repeat(np.array([[0, 0, -1], [0, 0, 1], [0, -1, 0], [0, 1, 0], [-1, 0, 0], [1, 0, 0]]), 4, axis=0)
        assert (normals[index] == expected).all()
    assert (crease.face_normals(vertices, quads) == expected[::4]).all()
    assert (crease.face_normals(vertices, triangles) == np.repeat(expected[::4], 2, axis=0)).all()
    smooth = crease.vertex_normals(vertices, quads)
    assert degrees_between(smooth, vertices - 0.5).max() < 1e-6


def test_split_makes_buffers():
    vertices, quads = cube()
    uv = np.arange(8)
    for faces in (quads, triangulated(quads)):
        new_vertices, new_faces, normals, source = crease.split(vertices, faces, crease=40)
        assert len(new_vertices) == len(normals) == len(source) == 24
        assert (new_vertices == vertices[source]).all() and source.dtype == np.uint32
        old, new = (faces[0], new_faces[0]) if isinstance(faces, tuple) else (faces, new_faces)
        assert (source[new] == old).all() and (uv[source][new] == uv[old]).all()
        expected = crease.face_normals(vertices, faces)
        corners = np.repeat(expected, 4 if isinstance(faces, tuple) else 3, axis=0)
        assert (normals[np.ravel(new)] == corners).all()
        # The new buffers have these normals without any crease.
        assert degrees_between(crease.vertex_normals(new_vertices, new_faces), normals).max() < 1e-6
    assert isinstance(crease.split(vertices, quads)[1], tuple)


def test_welding_joins_equal_positions():
    vertices, faces = grid(10)
    soup, separate = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
    expected = crease.vertex_normals(vertices, faces)[faces].reshape(-1, 3)
    for weld in ("exact", 1e-9):
        normals, index = crease.corner_normals(soup, separate, crease=None, weld=weld)
        assert degrees_between(normals[index].reshape(-1, 3), expected).max() < 1e-6
    flat, index = crease.corner_normals(soup, separate, crease=None)
    assert (flat[index][:, 0] == crease.face_normals(soup, separate)).all()


def test_faults_are_listed():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0], [9, 9, 9]], dtype=np.float32)
    faces = np.array([[0, 1, 2], [0, 1, 3]])
    for weight in ("angle", "quadric"):
        normals, faults = crease.vertex_normals(vertices, faces, weight=weight, return_faults=True)
        assert is_unit(normals)
        found = {(str(fault["element"]), int(fault["index"]), str(fault["reason"])) for fault in faults}
        assert found == {("face", 1, "ZeroArea"), ("vertex", 3, "ZeroArea"), ("vertex", 4, "Unreferenced")}, weight
    _, faults = crease.face_normals(vertices, faces, return_faults=True)
    assert faults.tolist() == [("face", 1, "ZeroArea")]
    *_, faults = crease.corner_normals(vertices, faces, return_faults=True)
    assert ("face", 1, "ZeroArea") in faults.tolist() and faults.dtype.names == ("element", "index", "reason")
    *_, faults = crease.split(*grid(4), return_faults=True)
    assert len(faults) == 0


V, F = [[0.0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]


@pytest.mark.parametrize(
    "arguments, message",
    [
        (dict(vertices=np.zeros((3, 2))), "vertices has the shape (3, 2); (n, 3) was expected"),
        (dict(vertices=np.zeros(3)), "vertices has the shape (3,); (n, 3) was expected"),
        (dict(vertices=np.zeros((0, 3))), "vertices is empty"),
        (dict(vertices=np.zeros((3, 3), dtype=complex)), "vertices has the dtype complex128; use float32 or float64"),
        (dict(vertices=[[0, 0, 0], [1, 0, 0], [0, np.nan, 0]]), "vertices[2] is (0, NaN, 0), which is not finite"),
        (dict(vertices=[[0, 0, 0], [1, -np.inf, 0], [0, 1, 0]]), "vertices[1] is (1, -inf, 0), which is not finite"),
        (dict(faces=[[0, 1, 2, 0]]), "faces has the shape (1, 4); (m, 3) was expected; pass polygons as (indices, offsets)"),
        (dict(faces=np.zeros((0, 3), dtype=int)), "faces is empty"),
        (dict(faces=[[0.0, 1, 2]]), "faces has the dtype float64; use uint32"),
        (dict(faces=[[0, 1, 2], [0, 1, 3]]), "faces[1, 2] is 3, but vertices has 3 rows; indices count from 0"),
        (dict(faces=np.array([[0, 1, 2], [0, 4294967295, 1]], dtype=np.uint32)), "faces[1, 1] is 4294967295, but vertices has 3 rows"),
        (dict(faces=[[0, 1, 2], [0, -1, 1]]), "faces[1, 1] is -1; indices count from 0"),
        (dict(faces=np.array([[0, 1, 2], [0, -1, 1]], dtype=np.int32)), "faces[1, 1] is -1; indices count from 0"),
        (dict(faces=[[0, 1, 2], [0, 1 << 32, 1]]), "faces[1, 1] is 4294967296; the largest index is"),
        (dict(faces=([0, 1, 2], [0, 2])), "offsets must start with 0 and end with 3, the number of indices"),
        (dict(faces=([0, 1, 2], [])), "offsets"),
        (dict(faces=([0, 1, 2, 0], [0, 2, 4])), "offsets[0] is 0 and offsets[1] is 2; a face needs 3 corners"),
        (dict(faces=([0, 1, 2, 0, 1, 2], [0, 6, 3, 6])), "offsets[1] is 6 and offsets[2] is 3; a face needs 3 corners"),
        (dict(faces=([0, 1, 7], [0, 3])), "indices[2] is 7, but vertices has 3 rows"),
        (dict(faces=([0, 1, -7], [0, 3])), "indices[2] is -7; indices count from 0"),
        (dict(faces=([0], [1], [2])), "faces is a tuple of 3; use an array, or (indices, offsets)"),
        (dict(threads=0), "threads is 0; a number from 1 to 1024 was expected"),
        (dict(threads=2000), "threads is 2000"),
    ],
)
def test_wrong_arrays_are_refused(arguments, message):
    arguments = {"vertices": V, "faces": F, **arguments}
    for function in (crease.vertex_normals, crease.face_normals, crease.corner_normals, crease.split):
        with pytest.raises(ValueError) as error:
            function(**arguments)
        assert str(error.value).startswith(message), function


def test_wrong_names_and_angles_are_refused():
    for arguments, message in [
        (dict(weight="angel"), 'weight is "angel"; use one of "uniform", "area", "angle"'),
        (dict(slivers="drop"), 'slivers is "drop"; use one of "exclude", "keep"'),
        (dict(precision="slow"), 'precision is "slow"'),
        (dict(crease=181), "crease is 181; an angle from 0 to 180 degrees"),
        (dict(crease=-1), "crease is -1"),
        (dict(crease=float("nan")), "crease is NaN"),
        (dict(weld="near"), 'weld is "near"; use one of "off", "exact"'),
        (dict(weld=2.0), "weld is 2; a fraction of the diagonal from 0 to 1"),
        (dict(weld=True), 'weld is True; use "off", "exact" or a fraction'),
        (dict(threads=-1), "threads is -1; a number from 1 to 1024"),
        (dict(threads=2**70), "threads is 1180591620717411303424; a number"),
    ]:
        with pytest.raises(ValueError) as error:
            crease.corner_normals(V, F, **arguments)
        assert str(error.value).startswith(message)
    with pytest.raises(TypeError):
        crease.vertex_normals(V, F, wieght="area")


def test_results_go_into_a_given_array():
    vertices, faces = grid(20, np.float32)
    out = np.full_like(vertices, 7)
    result = crease.vertex_normals(vertices, faces, out=out)
    assert np.shares_memory(result, out) and (out == crease.vertex_normals(vertices, faces)).all()
    per_face = np.empty((len(faces), 3), dtype=np.float32)
    crease.face_normals(vertices, faces, out=per_face)
    assert (per_face == crease.face_normals(vertices, faces)).all()


def test_wrong_outputs_are_refused_and_stay_unchanged():
    vertices, faces = grid(4, np.float32)
    read_only = np.full_like(vertices, 7)
    read_only.flags.writeable = False
    message = "out must be a C-contiguous array of float32 with the shape (25, 3)"
    for out, expected in [
        (read_only, "out is read-only; pass an array that can be written"),
        (np.full(vertices.shape, 7.0), message),
        (np.full((24, 3), 7, dtype=np.float32), message),
        (np.full((3, 25), 7, dtype=np.float32).T, message),
        ([[0.0] * 3] * 25, message),
        (vertices, "out shares memory with vertices"),
        (np.frombuffer(vertices.data, dtype=np.float32).reshape(-1, 3), "out shares memory with vertices"),
    ]:
        before = np.array(out)
        with pytest.raises(ValueError) as error:
            crease.vertex_normals(vertices, faces, out=out)
        assert str(error.value).startswith(expected)
        assert (np.array(out) == before).all()
    # An error in the faces is found before anything is written.
    out = np.full_like(vertices, 7)
    with pytest.raises(ValueError):
        crease.vertex_normals(vertices, [[0, 1, 25]], out=out)
    assert (out == 7).all()


def test_float_and_uint32_arrays_are_not_copied():
    """Except for its result, a call allocates nothing in NumPy; a conversion would."""
    vertices, faces = grid(300, np.float32)
    out = np.empty_like(vertices)
    crease.vertex_normals(vertices, faces, out=out)

    def peak(*arguments, **options):
        tracemalloc.start()
        crease.vertex_normals(*arguments, **options)
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return most

    assert peak(vertices, faces, out=out) < 10_000
    assert peak(vertices.astype(np.float64), faces) < vertices.nbytes * 2 + 10_000
    # The measurement sees copies.
    assert peak(np.asfortranarray(vertices), faces, out=out) >= vertices.nbytes


FORKED = """
import os, sys
import numpy as np
import crease_normals as crease
v, f = np.array([[0., 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]])
crease.vertex_normals(v, f)
child = os.fork()
if child == 0:
    os._exit(0 if (crease.vertex_normals(v, f) == [0, 0, 1]).all() else 1)
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs fork")
def test_a_forked_process_has_threads_of_its_own():
    assert subprocess.run([sys.executable, "-W", "ignore", "-c", FORKED], timeout=60).returncode == 0

"""Files, diagnosis, pictures, plans and the program."""

import errno
import json
import os
import pydoc
import re
import shutil
import signal
import subprocess
import sys
import time
import zlib

import numpy as np
import pytest
from conftest import DATA, ROOT, degrees_between, grid

import crease_normals as crease

PROGRAM = [sys.executable, "-m", "crease_normals"]
ENVIRONMENT = {**os.environ, "NO_COLOR": "1"}


def run(*words, code=0, **options):
    done = subprocess.run([*PROGRAM, *map(str, words)], capture_output=True, env=ENVIRONMENT, timeout=300, **options)
    assert done.returncode == code, done.stderr.decode()
    return done.stdout.decode(), done.stderr.decode()


def ply_bytes(vertices, faces):
    """A binary PLY of triangles in single precision."""
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty float x\nproperty float y\n"
        f"property float z\nelement face {len(faces)}\nproperty list uchar uint vertex_indices\nend_header\n"
    )
    rows = np.zeros(len(faces), dtype=[("n", "u1"), ("v", "<u4", 3)])
    rows["n"], rows["v"] = 3, faces
    return header.encode() + np.asarray(vertices, "<f4").tobytes() + rows.tobytes()


def ply_normals(path, count):
    """The normals of a binary PLY whose vertices are positions and normals in single precision."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    properties = re.findall(rb"property (\w+) (\w+)", head.split(b"element face")[0])
    assert [name for _, name in properties] == [b"x", b"y", b"z", b"nx", b"ny", b"nz"]
    return np.frombuffer(body, "<f4", 6 * count).reshape(-1, 6)[:, 3:]


def png_pixels(path):
    """The pixels of a PNG of 8 bits with three components, without interlacing (ISO/IEC 15948, section 9)."""
    data, at, compressed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        chunk = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height = np.frombuffer(chunk[:8], ">u4").tolist()
            assert chunk[8:] == bytes([8, 2, 0, 0, 0])
        compressed += chunk if kind == b"IDAT" else b""
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(compressed), np.uint8).reshape(height, 1 + 3 * width)
    pixels = np.zeros((height + 1, width + 1, 3), dtype=int)
    for y, row in enumerate(rows, 1):
        for x, value in enumerate(row[1:].reshape(width, 3).astype(int), 1):
            left, up, corner = pixels[y, x - 1], pixels[y - 1, x], pixels[y - 1, x - 1]
            distances = [np.abs(up - corner), np.abs(left - corner), np.abs(left + up - 2 * corner)]
            paeth = np.choose(np.argmin(distances, axis=0), [left, up, corner])
            pixels[y, x] = (value + [0, left, up, (left + up) // 2, paeth][row[0]]) % 256
    return pixels[1:, 1:]


@pytest.mark.parametrize("weight", ["uniform", "area", "angle", "angle-area", "max", "edge", "quadric", "jet"])
def test_arrays_give_the_bits_of_the_program(tmp_path, weight):
    vertices, faces = grid(24, np.float32)
    (tmp_path / "in.ply").write_bytes(ply_bytes(vertices, faces))
    options = ["--weight", weight, "--crease", "off", "--weld", "off", "--emit", "vertex", "-q"]
    run("normals", tmp_path / "in.ply", "-o", tmp_path / "out.ply", *options)
    expected = ply_normals(tmp_path / "out.ply", len(vertices))
    assert crease.vertex_normals(vertices, faces, weight=weight).tobytes() == expected.tobytes()


def test_a_file_is_read_changed_and_written(tmp_path):
    mesh = crease.read(DATA / "part.stl")
    assert (mesh.format, mesh.path, len(mesh.parts)) == ("stl", DATA / "part.stl", 1)
    [counts] = mesh.normals(crease=40)
    assert (counts["vertices"], counts["splits"], counts["edges"]["crease"]) == (192, 32, 32)
    mesh.write(tmp_path / "part.glb")
    run("normals", DATA / "part.stl", "--crease", 40, "-o", tmp_path / "program.glb", "-q")
    assert (tmp_path / "part.glb").read_bytes() == (tmp_path / "program.glb").read_bytes()
    assert "192 vertices, 64 faces" in repr(mesh)


@pytest.mark.parametrize("name", ["part.stl", "gear.obj", "leaf.ply", "mirrored.gltf", "sphere-seam.glb"])
@pytest.mark.parametrize("ending", [None, "ply", "stl", "glb", "obj"])
def test_written_files_are_those_of_the_program(tmp_path, name, ending):
    output = f"out.{ending or name.split('.')[1]}"
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    options = {"weight": "area", "crease_rule": "cone", "when": "always", "hard_edges": ("uv", "material")}
    mesh = crease.read(DATA / name)
    mesh.normals(crease=30, **options)
    mesh.write(tmp_path / "a" / output)
    words = ["--weight", "area", "--crease-rule", "cone", "--when", "always", "--hard-edges", "uv,material"]
    run("normals", DATA / name, "--crease", 30, *words, "-o", tmp_path / "b" / output, "-q")
    files = [sorted(path.name for path in (tmp_path / folder).iterdir()) for folder in "ab"]
    assert files[0] == files[1] and output in files[0]
    for file in files[0]:
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes(), file


def test_parts_have_arrays_that_the_functions_take():
    [part] = crease.read(DATA / "polygons.obj").parts
    indices, offsets = part.faces
    assert len(offsets) > 1 and offsets[-1] == len(indices) and max(np.diff(offsets)) > 4
    mesh = crease.read(DATA / "polygons.obj")
    mesh.normals(crease=40, groups="ignore")
    normals, index = mesh.parts[0].normals
    expected, expected_index = crease.corner_normals(part.vertices, part.faces, crease=40, weld="exact")
    assert degrees_between(normals[index], expected[expected_index]).max() < 1e-9
    [sphere] = crease.read(DATA / "sphere-seam.glb").parts
    assert sphere.vertices.dtype == np.float32 and sphere.faces.dtype == np.uint32 and sphere.name is not None
    assert crease.read(DATA / "gear.obj").parts[0].normals is None


def test_read_errors_have_path_and_position(tmp_path):
    path = tmp_path / "wrong.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
    with pytest.raises(crease.ReadError) as error:
        crease.read(path)
    found = error.value
    assert (found.path, found.line, found.offset, found.pointer) == (path, 4, None, None)
    assert str(found).startswith(f"{path}: line 4: ") and found.help and isinstance(found, ValueError)
    (tmp_path / "cut.ply").write_bytes(ply_bytes(*grid(4, np.float32))[:-5])
    with pytest.raises(crease.ReadError) as error:
        crease.read(str(tmp_path / "cut.ply"))
    assert error.value.offset > 0 and error.value.line is None
    for function in (crease.read, crease.inspect, crease.render, crease.plan):
        with pytest.raises(crease.ReadError) as error:
            function(tmp_path / "missing.obj")
        assert error.value.path == tmp_path / "missing.obj" and "no such file" in str(error.value), function
    with pytest.raises(ValueError, match='format is "fbx"; use obj, ply, stl, gltf or glb'):
        crease.read(path, format="fbx")


def test_write_errors_keep_the_old_file(tmp_path):
    mesh = crease.read(DATA / "part.stl")
    with pytest.raises(ValueError, match="is a folder; name a file in it"):
        mesh.write(tmp_path)
    with pytest.raises(ValueError, match="unknown output format"):
        mesh.write(tmp_path / "out.fbx")
    old = tmp_path / "old.glb"
    old.write_bytes(b"old")
    old.chmod(0o444)
    with pytest.raises(crease.WriteError, match="write-protected"):
        mesh.write(old)
    assert issubclass(crease.WriteError, OSError)
    if os.path.exists("/proc/self"):
        # Linux makes no files there.
        with pytest.raises(crease.WriteError, match="could not write /proc/out.glb: there is no such file") as error:
            mesh.write("/proc/out.glb")
        assert error.value.errno == errno.ENOENT
    assert old.read_bytes() == b"old" and len(list(tmp_path.iterdir())) == 1


def test_each_computation_begins_with_the_file(tmp_path):
    mesh, fresh = crease.read(DATA / "part.stl"), crease.read(DATA / "part.stl")
    mesh.normals(merge=0.2)
    with pytest.raises(ValueError, match="merge with a fraction moves vertices"):
        mesh.write(tmp_path / "moved.stl")
    for it, name in ((mesh, "again"), (fresh, "fresh")):
        it.normals(crease=40)
        it.write(tmp_path / f"{name}.glb")
    assert (tmp_path / "again.glb").read_bytes() == (tmp_path / "fresh.glb").read_bytes()
    mesh.normals(emit="face")
    with pytest.raises(ValueError, match='emit="face" writes ply or stl, not glb'):
        mesh.write(tmp_path / "face.glb")


def test_unknown_options_are_refused():
    mesh = crease.read(DATA / "part.stl")
    for call, message in [
        (lambda: mesh.normals(wieght="area"), "unknown option --wieght; did you mean --weight?"),
        (lambda: mesh.normals(weight="angel"), 'unknown value "angel" of --weight; did you mean angle?'),
        (lambda: mesh.normals(crease=400), 'wrong value "400" of --crease'),
        (lambda: crease.render(DATA / "part.stl", shading="fong"), 'unknown value "fong" of --shading; did you mean'),
        (lambda: crease.render(DATA / "part.stl", output="x.png"), "unexpected option output; use the program for it"),
        (lambda: mesh.normals(scale=2), "unexpected option scale; use the program for it"),
        (lambda: mesh.normals(shard="0/2"), "unexpected option shard; use the program for it"),
        (lambda: crease.inspect(DATA / "part.stl", against="x.obj"), "unexpected option against; use the program for it"),
        (lambda: crease.inspect(DATA / "part.stl", only="flat"), 'wrong value "flat" of --only: no finding has this id'),
        (lambda: crease.plan(DATA / "scenes/sphere.toml", tolerance=-1), 'the value "-1" of --tolerance is not a'),
    ]:
        with pytest.raises(ValueError) as error:
            call()
        assert str(error.value).startswith(message)


def test_inspect_is_the_diagnosis_of_the_program():
    for name in ("morph.gltf", "part.stl", "slivers.obj"):
        report = crease.inspect(DATA / name)
        expected = json.loads(run("inspect", DATA / name, "--json")[0])
        assert expected["findings"] == report.json["findings"]
        assert [finding.id for finding in report.findings] == [it["id"] for it in expected["findings"]]
        assert (report.verdict, report.json["counts"]) == (expected["verdict"], expected["counts"])
    report = crease.inspect(DATA / "morph.gltf")
    assert report.findings[0].id == "wrong-morph-normals" and report.findings[0].severity == "warning"
    assert report.fix.startswith("crease normals ") and report.findings[0].places
    assert crease.inspect(DATA / "morph.gltf", severity="error").findings == []


def test_pictures_are_those_of_the_program(tmp_path):
    scene = DATA / "scenes" / "sphere.toml"
    image = crease.render(scene, size=(64, 48), shading="phong")
    assert image.shape == (48, 64, 3) and image.dtype == np.uint8 and len(np.unique(image)) > 20
    assert (image == crease.render(scene, size=(64, 48), shading="phong", threads=1)).all()
    run("render", scene, "--size", "64x48", "--shading", "phong", "-o", tmp_path / "picture.png", "-q")
    assert (image == png_pixels(tmp_path / "picture.png")).all()
    deep = crease.render(scene, size=(64, 48), shading="phong", bits=16)
    assert deep.dtype == np.uint16 and np.abs(deep / 257 - image).max() <= 0.51
    camera = {"eye": (0, 0, 9), "target": (0, 0, 0)}
    near = crease.render(DATA / "gear.obj", size=(40, 30), camera=camera, light=["directional towards=0,0,1"], background="#0000ff")
    assert near.shape == (30, 40, 3) and (near[0, 0] == [0, 0, 255]).all()


def test_plans_are_those_of_the_program(tmp_path):
    scene = DATA / "scenes" / "sphere.toml"
    plan = crease.plan(scene, tolerance=2, size=(64, 48))
    run("plan", scene, "--tolerance", 2, "--size", "64x48", "-o", tmp_path / "lean.toml", "-q")
    assert plan.text == (tmp_path / "lean.toml").read_text()
    assert plan.planned["work"] <= plan.declared["work"] and len(plan.decisions) == len(plan.json["decisions"])


def test_the_program_runs_as_a_module_and_as_a_command(tmp_path):
    assert run("--version")[0] == f"crease {crease.__version__}\n"
    assert "is required" in run("normals", code=2)[1]
    assert "no such file" in run("inspect", tmp_path / "missing.obj", code=3)[1]
    run("inspect", DATA / "morph.gltf", "--fail-on", "warning", "-q", code=1)
    command = shutil.which("crease", path=os.path.dirname(sys.executable))
    assert command, "the wheel installs the command"
    assert subprocess.run([command, "--version"], capture_output=True).stdout == f"crease {crease.__version__}\n".encode()
    page = tmp_path / "page.html"
    run("plan", DATA / "scenes/sphere.toml", "--size", "32x24", "--html", page, "-o", tmp_path / "lean.toml", "-q")
    assert "crease plan " in page.read_text() and "crease_normals" not in page.read_text()


def test_parts_have_the_faces_that_are_written(tmp_path):
    mesh = crease.read(DATA / "gear.obj")
    mesh.normals(flip=True)
    mesh.write(tmp_path / "flipped.obj")
    (part,), (written,), (stored,) = mesh.parts, crease.read(tmp_path / "flipped.obj").parts, crease.read(DATA / "gear.obj").parts
    corners, offsets = part.faces
    assert (corners == written.faces[0]).all() and (corners != stored.faces[0]).any()
    of_faces = crease.face_normals(part.vertices, part.faces)
    for normals, index in (part.normals, written.normals):
        assert (np.einsum("ij,ij->i", normals[index[offsets[:-1]]], of_faces) > 0.5).all()


LONG = """
import numpy as np, sys, time
sys.path.insert(0, {tests!r})
from conftest import grid
import crease_normals as crease
vertices, faces = grid({side})
print("ready", flush=True)
try:
    crease.vertex_normals(vertices, faces, weight="jet", threads=1)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def take_interrupts():
    """Processes in the background of a shell ignore them."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGINT")
def test_ctrl_c_ends_long_calls():
    code = LONG.format(tests=str(ROOT / "bindings/python/tests"), side=1500)
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, preexec_fn=take_interrupts)
    assert process.stdout.readline() == "ready\n"
    time.sleep(1)
    start = time.monotonic()
    process.send_signal(signal.SIGINT)
    assert process.stdout.readline() == "interrupted\n"
    # Without the signal the fits take many seconds.
    assert time.monotonic() - start < 3
    process.wait(timeout=60)


PICTURE = """
import crease_normals as crease, sys, time
print("ready", flush=True)
try:
    crease.render({path!r}, size=(8000, 8000), shading="traced", samples=16, threads=1)
except KeyboardInterrupt:
    print("interrupted", flush=True)
crease.render({path!r}, size=(32, 24), threads=1)
before = time.process_time()
time.sleep(2)
print(time.process_time() - before, flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGINT")
def test_ctrl_c_ends_pictures():
    code = PICTURE.format(path=str(DATA / "gear.obj"))
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, preexec_fn=take_interrupts)
    assert process.stdout.readline() == "ready\n"
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    assert process.stdout.readline() == "interrupted\n"
    # The picture of a minute no longer uses a processor.
    assert float(process.stdout.readline()) < 1
    process.wait(timeout=60)


@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGINT")
def test_ctrl_c_ends_the_program(tmp_path):
    (tmp_path / "large.ply").write_bytes(ply_bytes(*grid(1500, np.float32)))
    words = ["normals", "large.ply", "--weight", "jet", "--threads", "1", "-o", "out.ply", "-q"]
    process = subprocess.Popen([*PROGRAM, *words], cwd=tmp_path)
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=5) == -signal.SIGINT
    assert not (tmp_path / "out.ply").exists()


def test_help_is_complete():
    for name in ("vertex_normals", "face_normals", "corner_normals", "split", "read", "render", "inspect", "plan"):
        text = pydoc.plain(pydoc.render_doc(getattr(crease, name)))
        assert all(section in text for section in ("Parameters", "Returns", "Raises")), name
        assert "threads" in text and "..." not in text.splitlines()[2], name
    for name in crease.__all__:
        assert name == "__version__" or getattr(crease, name).__doc__


def test_stubs_name_what_the_module_has():
    stubs = (ROOT / "bindings/python/python/crease_normals/_native.pyi").read_text()
    from crease_normals import _native

    names = {name for name in dir(_native) if not name.startswith("_")} | {"__VERSION__"}
    assert names <= set(re.findall(r"^(?:class |def )?(\w+)", stubs, re.M))
    for name in ("vertex_normals", "corner_normals", "split", "face_normals", "read"):
        documented = re.findall(r"(\w+)=", getattr(_native, name).__text_signature__)
        stub = re.search(rf"def {name}\((.*?)\) ->", stubs, re.S)[1]
        assert documented == re.findall(r"^\s*(\w+): .*=", stub, re.M), name


def test_the_example_of_the_page_runs_as_printed(tmp_path, monkeypatch):
    page = (ROOT / "docs/python.md").read_text()
    code = re.search(r"```python\n(.*?)```", page, re.S)[1]
    shutil.copy(DATA / "part.stl", tmp_path)
    shutil.copy(DATA / "scenes/sphere.toml", tmp_path / "scene.toml")
    monkeypatch.chdir(tmp_path)
    vertices, faces = grid(8)
    names = {"V": vertices, "F": faces}
    exec(compile(code, "docs/python.md", "exec"), names)
    assert names["image"].shape == (480, 640, 3) and len(names["N2"]) == len(names["source"])
    assert names["report"].findings[0].id and (tmp_path / "part.glb").exists() and names["plan"].text

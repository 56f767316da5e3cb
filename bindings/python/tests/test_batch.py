"""Batches over processes and over a Ray cluster."""

import json
import os
import random
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from crease_normals import batch

TRIANGLE = "v 0 0 0\nv {} 0 0\nv 0 1 0\nf 1 2 3\n"


@pytest.fixture()
def work(tmp_path, monkeypatch):
    """A folder with forty meshes and a manifest, in which the test runs."""
    monkeypatch.chdir(tmp_path)
    os.mkdir("in")
    make_meshes(40)
    return tmp_path


def make_meshes(count):
    names = [f"in/{number:02}.obj" for number in range(count)]
    for number, name in enumerate(names):
        with open(name, "w") as file:
            file.write(TRIANGLE.format(number + 1))
    with open("list", "w") as file:
        file.writelines(f"{name}\n" for name in names)


def alone(*options):
    """The bytes that the program writes without the driver, by name."""
    words = ["normals", "--manifest", "list", "--out-dir", "alone", "-q", *options]
    subprocess.run([sys.executable, "-m", "crease_normals", *words], check=True)
    return files("alone/in")


def files(folder):
    return {name: open(f"{folder}/{name}", "rb").read() for name in sorted(os.listdir(folder))}


def test_processes_write_the_bytes_of_the_program_alone(work):
    counts = batch.run("list", "out", ["--crease", "30"], workers=2, chunk=7, journal="journal", table="table.jsonl")
    assert counts == {"done": 40, "skipped": 0}
    assert files("out/in") == alone("--crease", "30")
    assert sum(1 for _ in open("table.jsonl")) == 40
    # Only what changed is done again.
    (work / "in/03.obj").write_text(TRIANGLE.format(99))
    os.remove("out/in/05.obj")
    counts = batch.run("list", "out", ["--crease", "30"], workers=2, chunk=7, journal="journal")
    assert counts == {"done": 2, "skipped": 38}


def test_failures_are_counted_and_wrong_options_refused(work, capsys):
    (work / "in/01.obj").write_text("v 0 0 nan\nf 1 1 1\n")
    words = ["--manifest", "list", "--out", "out", "--workers", "1", "--journal", "journal"]
    assert batch.main([*words, "--", "--to", "ply"]) == 5
    said = capsys.readouterr()
    assert said.out == "39 done, 1 failed, 0 skipped\n" and "01.obj: line 1" in said.err
    assert os.path.exists("out/in/00.ply")
    for wrong in (["--", "--creese"], ["--chunk", "0"]):
        with pytest.raises(SystemExit):
            batch.main([*words, *wrong])
    (work / "list").write_text('in/00.obj\n{"input": 7}\n')
    with pytest.raises(ValueError, match="line 2"):
        batch.run("list", "out")
    (work / "list").write_text('in/00.obj\n{"input": "in/01.obj", "output": "out/in/00.obj"}\n')
    with pytest.raises(ValueError, match="would both be written to"):
        batch.run("list", "out")
    for line, message in [
        ('{"input": "in/01.obj", "options": ["--creese", "4"]}', "line 2: unknown option --creese"),
        ('{"input": "in/01.obj", "output": "other/new/../in/00.obj"}', "would both be written to"),
        ("in/01.txt", "line 2: unknown output format"),
    ]:
        (work / "list").write_text(f"in/00.obj\n{line}\n")
        with pytest.raises(ValueError, match=message):
            batch.run("list", "other")
    assert not os.path.exists("other"), "errors of the manifest are found before anything is written"


def test_unknown_protocols_are_refused(work):
    pytest.importorskip("fsspec")
    (work / "list").write_text("in/00.obj\nunknown://a/b.obj\n")
    with pytest.raises(ValueError, match="Protocol not known: unknown"):
        batch.run("list", "other")
    assert not os.path.exists("other")


def test_an_address_without_a_cluster_is_an_error(work):
    pytest.importorskip("ray")
    with pytest.raises(ValueError, match="no Ray cluster at the address 'localhost:1'"):
        batch.run("list", "out", ray="localhost:1")


def test_a_journal_has_one_writer(work):
    if not batch.fcntl:
        pytest.skip("no locks on this system")
    with batch.open_journal("journal"):
        with pytest.raises(ValueError, match="another run writes the journal journal"):
            batch.run("list", "out", workers=1, journal="journal")
        words = ["normals", "--manifest", "list", "--out-dir", "out", "--journal", "journal"]
        done = subprocess.run([sys.executable, "-m", "crease_normals", *words], capture_output=True, text=True)
        assert done.returncode == 2 and "another run writes the journal" in done.stderr
    assert not os.path.exists("out")
    # Half a line of a stopped run is ended before the next entry.
    (work / "journal").write_text('{"output": "x", "sta')
    assert batch.run("list", "out", workers=1, journal="journal")["done"] == 40
    assert len([json.loads(line) for line in open("journal").readlines()[1:]]) == 40


def test_other_files_are_no_journals(work):
    before = (work / "list").read_bytes()
    for name in ("list", "in/00.obj"):
        with pytest.raises(OSError, match="is not a journal"):
            batch.run("list", "out", workers=1, journal=name)
    assert (work / "list").read_bytes() == before and not os.path.exists("out")


def test_companions_of_two_outputs_do_not_replace_each_other_unnoticed(work, capsys):
    for folder, colour in (("a", "1 0 0"), ("b", "0 1 0")):
        os.mkdir(folder)
        (work / f"{folder}/m.mtl").write_text(f"newmtl m\nKd {colour}\n")
        (work / f"{folder}/{folder}.obj").write_text("mtllib m.mtl\nusemtl m\n" + TRIANGLE.format(1))
    lines = [json.dumps({"input": f"{name}/{name}.obj", "output": f"both/{name}.obj"}) for name in "ab"]
    (work / "list").write_text("\n".join(lines))
    assert batch.main(["--manifest", "list", "--out", "out", "--workers", "1", "--chunk", "1"]) == 5
    said = capsys.readouterr()
    assert said.out == "1 done, 1 failed, 0 skipped\n" and "m.mtl belongs to" in said.err


def test_manifests_may_have_a_byte_order_mark_and_names_a_carriage_return(work):
    os.rename("in/01.obj", "in/a\rb.obj")
    (work / "list").write_bytes(b"\xef\xbb\xbfin/00.obj\r\nin/a\rb.obj\r\n")
    assert batch.run("list", "out", workers=1) == {"done": 2, "skipped": 0}
    assert sorted(os.listdir("out/in")) == ["00.obj", "a\rb.obj"]


def test_one_file_at_two_addresses_is_one_file(work):
    (work / "list").write_text('{"input": "memory://a/x.stl", "output": "memory:///a/x.stl"}\n')
    with pytest.raises(ValueError, match="would overwrite the input"):
        batch.run("list", "out")
    with pytest.raises(ValueError, match="--out is empty"):
        batch.run("list", "")


def test_a_table_is_replaced_as_a_whole(work):
    os.mkdir("table.jsonl.part")
    (work / "table.jsonl").write_text("old")
    with pytest.raises(OSError, match="table.jsonl: the table was not written"):
        batch.run("list", "out", table="table.jsonl")
    assert (work / "table.jsonl").read_text() == "old"


def test_a_table_is_written_as_parquet(work):
    parquet = pytest.importorskip("pyarrow.parquet")
    batch.run("list", "out", table="table.parquet")
    table = parquet.read_table("table.parquet")
    assert table.num_rows == 40 and set(table["status"].to_pylist()) == {"done"}


def test_urls_are_read_and_written_with_their_companions(work):
    fsspec = pytest.importorskip("fsspec")
    memory = fsspec.filesystem("memory")
    for name in ("00", "01"):
        memory.pipe(f"/bucket/in/{name}.obj", (work / f"in/{name}.obj").read_bytes())
    (work / "list").write_text(f"memory://bucket/in/00.obj\nmemory://bucket/in/01.obj\nfile://{work}/in/02.obj\n")
    run = lambda: batch.run("list", "memory://out", ["--to", "gltf"], workers=2, chunk=2, journal="journal")  # noqa: E731
    assert run() == {"done": 3, "skipped": 0}
    names = [name for name in memory.find("/out") if name.endswith("00.gltf") or name.endswith("00.bin")]
    assert names == ["/out/bucket/in/00.bin", "/out/bucket/in/00.gltf"]
    assert json.loads(memory.cat("/out/bucket/in/00.gltf"))["buffers"][0]["uri"] == "00.bin"
    assert run() == {"skipped": 3}
    # A buffer that was lost.
    memory.rm("/out/bucket/in/00.bin")
    memory.pipe("/bucket/in/01.obj", TRIANGLE.format(7).encode())
    assert run() == {"done": 2, "skipped": 1}


def test_companions_of_urls_are_found_and_compared(work):
    fsspec = pytest.importorskip("fsspec")
    memory = fsspec.filesystem("memory")
    (work / "in/m.mtl").write_text("newmtl m\nKd 1 0 0\n")
    (work / "in/00.obj").write_text("mtllib m.mtl\nusemtl m\n" + TRIANGLE.format(1))
    for name in ("m.mtl", "00.obj"):
        memory.pipe(f"/both/{name}", (work / f"in/{name}").read_bytes())
    # A buffer in the folder of another input.
    subprocess.run([sys.executable, "-m", "crease_normals", "normals", "in/01.obj", "-o", "x.gltf", "-q"], check=True)
    text = (work / "x.gltf").read_text()
    assert '"x.bin"' in text
    memory.pipe("/both/x.gltf", text.replace('"x.bin"', '"bin/x.bin"').encode())
    memory.pipe("/both/bin/x.bin", (work / "x.bin").read_bytes())
    memory.pipe("/both/bin/02.obj", (work / "in/02.obj").read_bytes())
    (work / "list").write_text("memory://both/00.obj\nmemory://both/x.gltf\nmemory://both/bin/02.obj\n")
    run = lambda: batch.run("list", "memory://found", workers=1, journal="journal")  # noqa: E731
    assert run() == {"done": 3, "skipped": 0}
    read = {name for line in open("journal") for name in json.loads(line)["read"]}
    assert read >= {"memory://both/m.mtl", "memory://both/bin/x.bin"}
    assert all(name.startswith("memory://both/") for name in read)
    assert run() == {"skipped": 3}
    memory.pipe("/both/m.mtl", b"newmtl m\nKd 0 1 0\n")
    assert run() == {"done": 1, "skipped": 2}


def test_a_cluster_that_is_not_there_is_a_usage_error(work, monkeypatch, capsys):
    pytest.importorskip("ray")
    monkeypatch.delenv("RAY_ADDRESS", raising=False)
    with pytest.raises(SystemExit) as end:
        batch.main(["--manifest", "list", "--out", "out", "--ray", "auto"])
    assert end.value.code == 2 and "`ray start --head`" in capsys.readouterr().err


def test_killed_workers_of_a_cluster_lose_nothing(work):
    """One worker is killed in a batch of 40 files; with CREASE_LONG, twenty in one of 2000, at random moments."""
    ray = pytest.importorskip("ray")
    count, kills = (2000, 20) if "CREASE_LONG" in os.environ else (40, 1)
    make_meshes(count)
    expected = alone("--crease", "30")
    ray.init(num_cpus=2, log_to_driver=False, include_dashboard=False)
    numbers, killed, ended = random.Random(1), [], threading.Event()

    def kill():
        # By progress, not by time: fast and slow machines kill as many.
        for progress in sorted(numbers.sample(range(count * 9 // 10), kills)):
            while not ended.is_set():
                done = Path("journal").read_text().count("\n") if Path("journal").exists() else 0
                busy = ["pgrep", "-f", "ray::run_chunk"]
                found = subprocess.run(busy, capture_output=True, text=True).stdout.split() if done >= progress else []
                time.sleep(numbers.uniform(0, 0.02))
                try:
                    os.kill(int(numbers.choice(found)), signal.SIGKILL)
                    killed.append(progress)
                    break
                except (IndexError, ProcessLookupError):
                    time.sleep(0.005)

    killer = threading.Thread(target=kill)
    killer.start()
    try:
        # One chunk may be unlucky each time.
        options = {"ray": "auto", "chunk": count // 200 or 4, "retries": 2 * kills}
        counts = batch.run("list", "out", ["--crease", "30"], journal="journal", **options)
    finally:
        ended.set()
        killer.join()
        ray.shutdown()
    assert len(killed) == kills
    assert counts == {"done": count, "skipped": 0}
    entries = [json.loads(line)["input"] for line in open("journal")]
    assert len(entries) == len(set(entries)) == count, "each file is in the journal once"
    # A program that is killed with its worker while it writes may leave its temporary file; docs/batches.md says so.
    found = {name: content for name, content in files("out/in").items() if not name.startswith(".crease-")}
    assert found == expected

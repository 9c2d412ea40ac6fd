# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m filmsticking and its files. Usage: files_test.py [PCD_TO_MESH]."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from filmsticking.files import FileError, positions_of, read_cloud, write_mesh

DATA = Path(__file__).parent.parent / "data"
PCD_TO_MESH = sys.argv.pop(1) if len(sys.argv) > 1 else None

FIELDS = [("x", "f4"), ("y", "f4"), ("z", "f4"), ("red", "u1"), ("time", "f8")]


def cloud(n=50):
    random = np.random.default_rng(3)
    rows = np.zeros(n, FIELDS)
    for name in "xyz":
        rows[name] = random.normal(size=n)
    rows["red"] = random.integers(0, 256, n)
    rows["time"] = random.normal(size=n)
    return rows


def ply(rows, form):
    kinds = {"f4": "float", "u1": "uchar", "f8": "double"}
    header = ["ply", f"format {form} 1.0", "comment c", f"element vertex {len(rows)}"]
    header += [f"property {kinds[kind]} {name}" for name, kind in FIELDS]
    header += ["element face 1", "property list uchar int vertex_indices", "end_header", ""]
    body = b""
    if form == "ascii":
        body = "".join(" ".join(repr(value) for value in row.tolist()) + "\n" for row in rows).encode()
        body += b"3 0 1 2\n"
    else:
        order = "<" if "little" in form else ">"
        body = rows.astype([(name, order + kind) for name, kind in FIELDS]).tobytes()
        body += b"\3" + np.array([0, 1, 2], order + "i4").tobytes()
    return "\n".join(header).encode() + body


class Scratch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class Files(Scratch):
    def written(self, name, data):
        (self.folder / name).write_bytes(data)
        return self.folder / name

    def test_all_forms_of_ply_keep_all_fields(self):
        rows = cloud()
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            with self.subTest(form):
                read = read_cloud(self.written("a.ply", ply(rows, form)))
                for name, _ in FIELDS:
                    np.testing.assert_array_equal(read[name], rows[name])
                self.assertEqual(positions_of(read).dtype, np.float32)

    def test_text_and_npy(self):
        points = np.random.default_rng(1).normal(size=(20, 3))
        np.savetxt(self.folder / "a.xyz", np.hstack([points, points]), fmt="%.17g")
        np.save(self.folder / "a.npy", points)
        for name in ("a.xyz", "a.npy"):
            np.testing.assert_array_equal(positions_of(read_cloud(self.folder / name)), points)

    def test_a_written_mesh_has_the_vertices_with_all_fields(self):
        rows = cloud()
        write_mesh(self.folder / "m.ply", rows, np.array([[0, 1, 2], [2, 1, 3]], np.int32))
        data = (self.folder / "m.ply").read_bytes()
        self.assertTrue(data.endswith(b"\3" + np.array([2, 1, 3], "<i4").tobytes()))
        np.testing.assert_array_equal(read_cloud(self.folder / "m.ply"), rows)

    def test_broken_files_are_refused_with_their_name(self):
        good = ply(cloud(), "binary_little_endian")
        text = ply(cloud(), "ascii")
        for name, data in {
            "cut.ply": good[:600],
            "cut_header.ply": good[:60],
            "cut_text.ply": text[:800],
            "other.ply": b"solid x\n",
            "empty.ply": b"",
            "no_z.ply": good.replace(b" z\n", b" w\n"),
            "huge.ply": good.replace(b"vertex 50", b"vertex 999999999999"),
            "word.ply": text.replace(b"end_header\n", b"end_header\nnone "),
            "too_big.ply": text.replace(b"end_header\n", b"end_header\n0 0 0 256 0\n"),
            "half.xyz": b"1 2 3\n4 5\n",
            "a.npy": b"\x93NUMPY",
            "a.pcd": b"",
        }.items():
            with self.subTest(name), self.assertRaisesRegex(FileError, name):
                read_cloud(self.written(name, data))

    def test_a_mesh_that_cannot_be_written_leaves_nothing(self):
        with self.assertRaises(OSError):
            write_mesh(self.folder / "none" / "m.ply", cloud(), np.zeros((1, 3), np.int32))
        (self.folder / "m.ply").mkdir()
        with self.assertRaises(OSError):
            write_mesh(self.folder / "m.ply", cloud(), np.zeros((1, 3), np.int32))
        self.assertEqual([file.name for file in self.folder.iterdir()], ["m.ply"])


class Program(Scratch):
    def run_module(self, *words):
        return subprocess.run(
            [sys.executable, "-m", "filmsticking", *map(str, words)], capture_output=True, text=True
        )

    def test_it_makes_a_mesh_and_says_so(self):
        done = self.run_module(DATA / "spot_10k.ply", self.folder / "m.ply")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, "10000 vertices, 19996 triangles, closed, genus 0")
        if PCD_TO_MESH:
            subprocess.run(
                [PCD_TO_MESH, DATA / "spot_10k.ply", self.folder / "cpp.ply"], check=True, capture_output=True
            )
            size = 19996 * 13  # the triangles, which end both files
            self.assertEqual(
                (self.folder / "m.ply").read_bytes()[-size:], (self.folder / "cpp.ply").read_bytes()[-size:]
            )

    def test_failures_are_one_sentence_and_a_status(self):
        np.save(self.folder / "few.npy", np.eye(3))
        for words, sentence in (
            ((self.folder / "none.ply", self.folder / "m.ply"), "none.ply"),
            ((self.folder / "few.npy", self.folder / "m.ply"), "few.npy.*four"),
            ((DATA / "spot_10k.ply", self.folder / "m.obj"), "m.obj.*pcd_to_mesh"),
            ((DATA / "bun0.pcd", self.folder / "m.ply"), "bun0.pcd.*pcd_to_mesh"),
        ):
            with self.subTest(sentence):
                done = self.run_module(*words)
                self.assertEqual(done.returncode, 1)
                self.assertRegex(done.stderr, sentence)
                self.assertEqual(len(done.stderr.splitlines()), 1)
                self.assertFalse((self.folder / "m.ply").exists())


if __name__ == "__main__":
    unittest.main()

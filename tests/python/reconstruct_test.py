# SPDX-License-Identifier: GPL-3.0-or-later
"""filmsticking.reconstruct(): what its docstring promises."""

import gc
import os
import signal
import threading
import time
import unittest

import numpy as np

import filmsticking


def sphere(n, seed=1):
    points = np.random.default_rng(seed).normal(size=(n, 3))
    return points / np.linalg.norm(points, axis=1)[:, None]


def directed_edges(mesh):
    t = mesh.triangles.astype(np.int64)
    edges = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    return edges[:, 0] * len(mesh.vertices) + edges[:, 1], edges[:, 1] * len(mesh.vertices) + edges[:, 0]


class Reconstruct(unittest.TestCase):
    def same_mesh(self, one, other):
        np.testing.assert_array_equal(one.vertices, other.vertices)
        np.testing.assert_array_equal(one.triangles, other.triangles)
        np.testing.assert_array_equal(one.gaps, other.gaps)

    def test_the_mesh_is_closed_oriented_and_of_input_points(self):
        points = sphere(2000)
        mesh = filmsticking.reconstruct(points)
        forth, back = directed_edges(mesh)
        self.assertEqual(len(np.unique(forth)), len(forth))
        np.testing.assert_array_equal(np.sort(forth), np.sort(back))
        np.testing.assert_array_equal(mesh.points, points[mesh.vertices])
        a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
        volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6
        self.assertAlmostEqual(volume, 4 / 3 * np.pi, delta=0.05)
        self.assertEqual(mesh.gaps.shape, (len(mesh.triangles),))
        self.assertTrue(mesh.report.closed and mesh.report.manifold)
        self.assertEqual(mesh.status, filmsticking.Status.Ok)

    def test_an_open_surface_shows_its_front_to_what_saw_it(self):
        rng = np.random.default_rng(1)
        x, y = rng.uniform(-1, 1, (2, 3000))
        hills = np.column_stack([x, y, 0.3 * np.exp(-4 * (x * x + y * y))])
        for side in (-1, 1):
            for seen in (
                {"viewpoints": hills + (0, 0, 5 * side)},
                {"viewpoint": (0, 0, 50 * side)},
                {"view_direction": (0, 0, -side)},
            ):
                mesh = filmsticking.reconstruct(hills, open=True, **seen)
                a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
                up = np.cross(b - a, c - a)[:, 2] * side
                self.assertGreater(up[up > 0].sum(), 0.95 * np.abs(up).sum(), seen)
        with self.assertRaisesRegex(filmsticking.Error, "viewpoints"):
            filmsticking.reconstruct(hills, viewpoints=hills[:5])

    def test_any_type_and_layout_of_the_same_numbers_gives_the_same_mesh(self):
        single = sphere(800).astype(np.float32)
        expected = filmsticking.reconstruct(single)
        double = single.astype(np.float64)
        wide = np.zeros((800, 7))
        wide[:, 2:5] = double
        packed = np.zeros(800, dtype=[("label", "u1"), ("place", "f4", 3)])  # 13 bytes a point: unaligned
        packed["place"] = single
        with_gaps = np.zeros((1600, 3), np.float32)
        with_gaps[::2] = single
        read_only = double.copy()
        read_only.flags.writeable = False
        forms = {
            "double": double,
            "columns of a wider array": wide[:, 2:5],
            "a field of a packed structure": packed["place"],
            "every second row": with_gaps[::2],
            "column by column": np.asfortranarray(single),
            "from the last to the first, twice": single[::-1].copy()[::-1],
            "big-endian": double.astype(">f8"),
            "read-only": read_only,
            "long double": double.astype(np.longdouble),
            "lists": double.tolist(),
        }
        for name, points in forms.items():
            with self.subTest(name):
                self.same_mesh(filmsticking.reconstruct(points), expected)

    def test_integers_and_half_precision_are_read_by_their_value(self):
        whole = np.round(sphere(500) * 1000)
        expected = filmsticking.reconstruct(whole)
        self.same_mesh(filmsticking.reconstruct(whole.astype(np.int32)), expected)
        self.same_mesh(filmsticking.reconstruct(whole.astype(np.float16)), expected)

    def test_floats_are_read_in_place(self):
        wide = np.zeros((500, 5), np.float32)
        wide[:, :3] = sphere(500)
        mesh = filmsticking.reconstruct(wide[:, :3])
        self.assertTrue(np.shares_memory(mesh._input, wide))

    def test_masked_points_and_those_that_are_not_finite_are_skipped(self):
        points = sphere(600)
        masked = np.ma.masked_array(points.copy(), mask=np.zeros((600, 3), bool))
        masked[7] = np.ma.masked
        holed = points.copy()
        holed[7] = np.nan
        mesh = filmsticking.reconstruct(holed)
        self.assertEqual(mesh.report.non_finite, 1)
        self.assertNotIn(7, mesh.vertices)
        self.same_mesh(filmsticking.reconstruct(masked), mesh)

    def test_the_number_of_threads_does_not_matter(self):
        points = sphere(5000)
        self.same_mesh(filmsticking.reconstruct(points, threads=1), filmsticking.reconstruct(points, threads=3))

    def test_open_keeps_the_rim_of_a_half(self):
        points = sphere(4000)
        half = points[points[:, 2] > 0]
        mesh = filmsticking.reconstruct(half, open=True)
        self.assertFalse(mesh.report.closed)
        self.assertEqual(mesh.report.boundary_loops, 1)
        self.assertTrue(filmsticking.reconstruct(half).report.closed)

    def test_max_hole_closes_small_holes_and_leaves_wide_ones(self):
        points = sphere(8000)
        radius = np.hypot(points[:, 0], points[:, 1])
        points = points[radius > np.where(points[:, 2] > 0, 0.3, 0.6)]
        mesh = filmsticking.reconstruct(points, max_hole=0.9)
        self.assertEqual([hole.closed for hole in mesh.report.holes], [False, True])
        self.assertAlmostEqual(mesh.report.holes[0].diameter, 1.2, delta=0.15)
        self.assertEqual(mesh.report.boundary_loops, 1)

    def test_stability_only_if_asked_for(self):
        points = sphere(800)
        self.assertIsNone(filmsticking.reconstruct(points).stability)
        mesh = filmsticking.reconstruct(points, stability=True)
        self.assertEqual(mesh.stability.shape, (len(mesh.triangles),))

    def test_normals_are_one_for_every_input_point(self):
        points = np.vstack([sphere(2000), [[0, 0, 9], [np.nan, 0, 0]]]).astype(np.float32)  # an outlier
        mesh = filmsticking.reconstruct(points)
        normals = mesh.normals
        self.assertEqual(normals.shape, points.shape)
        np.testing.assert_allclose(np.linalg.norm(normals[:-1], axis=1), 1, atol=1e-6)
        outward = (normals * points / np.linalg.norm(points, axis=1)[:, None]).sum(axis=1)[:-1]
        self.assertGreater(outward.min(), 0.9)
        self.assertTrue(np.isnan(normals[-1]).all())
        self.assertIs(mesh.normals, normals)

    def test_arrays_outlive_the_mesh(self):
        mesh = filmsticking.reconstruct(sphere(3000))
        triangles, expected = mesh.triangles, mesh.triangles.copy()
        del mesh
        gc.collect()
        filmsticking.reconstruct(sphere(3000, 2))  # would take the memory that was freed
        np.testing.assert_array_equal(triangles, expected)


class Failures(unittest.TestCase):
    def test_no_surface_is_an_error_with_a_sentence_a_status_and_a_report(self):
        plane = sphere(300)
        plane[:, 2] = 0
        with self.assertRaisesRegex(filmsticking.Error, "plane") as caught:
            filmsticking.reconstruct(plane)
        self.assertEqual(caught.exception.status, filmsticking.Status.Coplanar)
        self.assertEqual(caught.exception.report.points, 300)
        with self.assertRaisesRegex(filmsticking.Error, "four") as caught:
            filmsticking.reconstruct(np.empty((0, 3)))
        self.assertEqual(caught.exception.status, filmsticking.Status.TooFewPoints)

    def test_too_little_memory_is_an_error(self):
        with self.assertRaisesRegex(filmsticking.Error, "memory") as caught:
            filmsticking.reconstruct(sphere(3000), max_memory=100000)
        self.assertEqual(caught.exception.status, filmsticking.Status.OutOfMemory)

    def test_arguments_of_another_shape_or_kind_are_refused_with_a_sentence(self):
        points = sphere(100)
        for error, sentence, call in (
            (ValueError, r"\(n, 3\).*points\[:, :3\]", lambda: filmsticking.reconstruct(np.zeros((9, 6)))),
            (ValueError, r"\(n, 3\)", lambda: filmsticking.reconstruct(np.zeros(9))),
            (ValueError, r"\(n, 3\)", lambda: filmsticking.reconstruct([])),
            (TypeError, "real numbers", lambda: filmsticking.reconstruct(points.astype(complex))),
            (TypeError, "real numbers", lambda: filmsticking.reconstruct(points.astype(str))),
            (ValueError, r"\(3,\)", lambda: filmsticking.reconstruct(points, viewpoint=(1, 2))),
            (ValueError, "threads", lambda: filmsticking.reconstruct(points, threads=2**40)),
            (TypeError, "function", lambda: filmsticking.reconstruct(points, progress=3)),
            (filmsticking.Error, "threads", lambda: filmsticking.reconstruct(points, threads=-1)),
        ):
            with self.subTest(sentence), self.assertRaisesRegex(error, sentence):
                call()


class Execution(unittest.TestCase):
    def test_progress_rises_to_one_in_the_calling_thread(self):
        seen = []
        filmsticking.reconstruct(
            sphere(3000), progress=lambda share, stage: seen.append((share, stage, threading.get_ident()))
        )
        shares = [share for share, _, _ in seen]
        self.assertEqual(shares, sorted(shares))
        self.assertEqual(shares[-1], 1)
        self.assertEqual({thread for _, _, thread in seen}, {threading.get_ident()})
        self.assertIn("triangulation", {stage for _, stage, _ in seen})

    def test_what_progress_raises_comes_out(self):
        sent = LookupError("enough")

        def progress(share, stage):
            raise sent

        with self.assertRaises(LookupError) as caught:
            filmsticking.reconstruct(sphere(3000), progress=progress)
        self.assertIs(caught.exception, sent)

    def test_other_threads_of_python_run_meanwhile(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.wait(0.001):
                ticks.append(time.monotonic())

        thread = threading.Thread(target=tick)
        thread.start()
        begin = time.monotonic()
        filmsticking.reconstruct(sphere(50000))
        end = time.monotonic()
        done.set()
        thread.join()
        meanwhile = [t for t in ticks if begin + 0.1 * (end - begin) < t < end - 0.1 * (end - begin)]
        self.assertGreater(len(meanwhile), 5)

    def test_ctrl_c_ends_the_work(self):
        # A job in the background has it ignored.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        points = sphere(300000)
        begin = time.monotonic()
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            filmsticking.reconstruct(points)
            timer.cancel()
        cancelled = time.monotonic() - begin
        begin = time.monotonic()
        filmsticking.reconstruct(points)
        self.assertLess(cancelled, time.monotonic() - begin)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Every block ```python of docs/python.md runs as it stands. Usage: recipes_test.py REPOSITORY."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from filmsticking.files import positions_of, read_cloud, write_mesh

REPOSITORY = Path(sys.argv.pop(1))
IN_DEBIAN = {"filmsticking", "numpy", "open3d", "vtk", "meshio"}  # what .ci/setup installs; others may be missing


def blocks(page):
    """(heading, code) of each block."""
    heading = ""
    for match in re.finditer(r"^#+ ([^\n]*)$|^```python\n(.*?)^```$", page.read_text(), re.M | re.S):
        heading = match[1] or heading
        if match[2]:
            yield heading, match[2]


def write_fused(path):
    """A cloud as COLMAP writes it."""
    points = positions_of(read_cloud(REPOSITORY / "tests" / "data" / "spot_10k.ply"))
    rows = np.zeros(len(points), [(name, "f4") for name in ("x", "y", "z", "nx", "ny", "nz")]
                    + [(name, "u1") for name in ("red", "green", "blue")])  # fmt: skip
    for axis, name in enumerate("xyz"):
        rows[name] = points[:, axis]
    rows["red"] = 200
    write_mesh(path, rows, np.empty((0, 3), np.int32))


class Recipes(unittest.TestCase):
    def test_every_block_of_the_page_runs(self):
        ran = 0
        for heading, code in blocks(REPOSITORY / "docs" / "python.md"):
            modules = set(re.findall(r"^(?:import|from) (\w+)", code, re.M))
            missing = {name for name in modules - IN_DEBIAN if importlib.util.find_spec(name) is None}
            with self.subTest(heading), tempfile.TemporaryDirectory() as folder:
                if missing:
                    print(f"{heading}: skipped, {', '.join(missing)} is not here")
                    continue
                for cloud in ("spot_10k.ply", "bun0.pcd", "milk.pcd"):
                    shutil.copy(REPOSITORY / "tests" / "data" / cloud, folder)
                write_fused(Path(folder, "fused.ply"))
                done = subprocess.run(
                    [sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, env=os.environ
                )
                self.assertEqual(done.returncode, 0, done.stderr)
                ran += 1
        self.assertGreaterEqual(ran, 10)


if __name__ == "__main__":
    unittest.main()

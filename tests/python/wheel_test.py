# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel of python/backend installs without a network. Usage: wheel_test.py REPOSITORY FOLDER-OF-THE-PACKAGE."""

import base64
import hashlib
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

PACKAGE = Path(sys.argv.pop()) / "filmsticking"
REPOSITORY = Path(sys.argv.pop())
sys.path.insert(0, str(REPOSITORY / "python" / "backend"))
import filmsticking_build  # noqa: E402


class Wheel(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        # Of the build tree: compiling anew would take minutes.
        filmsticking_build._built_package = lambda _: PACKAGE
        self.wheel = self.folder / filmsticking_build.build_wheel(self.folder)

    def test_its_record_names_every_file_with_its_digest(self):
        with zipfile.ZipFile(self.wheel) as wheel:
            record = next(name for name in wheel.namelist() if name.endswith("RECORD"))
            lines = dict(line.split(",", 1) for line in wheel.read(record).decode().splitlines())
            self.assertEqual(set(lines), set(wheel.namelist()))
            for name, rest in lines.items():
                if name != record:
                    data = wheel.read(name)
                    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                    self.assertEqual(rest, f"sha256={digest},{len(data)}")

    @unittest.skipUnless(importlib.util.find_spec("pip"), "pip is not here")
    def test_pip_installs_it_and_it_runs(self):
        subprocess.run(
            [sys.executable, "-m", "pip", "install", "--no-index", "--no-deps", "--quiet", "--target",
             str(self.folder / "site"), str(self.wheel)], check=True)  # fmt: skip
        code = (
            "import numpy, filmsticking; print(filmsticking.__file__, filmsticking.__version__);"
            "assert filmsticking.reconstruct(numpy.random.default_rng(1).normal(size=(99, 3))).report.closed"
        )
        environment = {**os.environ, "PYTHONPATH": str(self.folder / "site")}
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(str(self.folder / "site"), done.stdout)
        self.assertIn(filmsticking_build._version(), done.stdout)


if __name__ == "__main__":
    unittest.main()

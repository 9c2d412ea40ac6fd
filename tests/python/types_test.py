# SPDX-License-Identifier: GPL-3.0-or-later
"""Type hints agree with the code and the module. Usage: types_test.py FOLDER-OF-THE-PACKAGE."""

import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FOLDER = Path(sys.argv.pop(1))


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not here")
class Types(unittest.TestCase):
    def run_tool(self, *words):
        # From elsewhere: mypy does not check what is on PYTHONPATH.
        environment = {**os.environ, "PYTHONPATH": "", "MYPYPATH": str(FOLDER)}
        with tempfile.TemporaryDirectory() as cache:
            done = subprocess.run(
                [sys.executable, "-m", *words], capture_output=True, text=True, env=environment, cwd=cache
            )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_package_keeps_its_hints(self):
        self.run_tool("mypy", "--strict", str(FOLDER / "filmsticking"))

    def test_a_caller_is_checked(self):
        with tempfile.TemporaryDirectory() as folder:
            caller = Path(folder, "caller.py")
            caller.write_text(
                "import numpy as np\nimport filmsticking\n"
                "mesh = filmsticking.reconstruct(np.zeros((9, 3)), progress=lambda share, stage: print(share))\n"
                "closed: bool = mesh.report.closed\n"
                "first: float = mesh.points[0, 0]\n"
            )
            self.run_tool("mypy", "--strict", str(caller))

    def test_the_stub_says_what_the_module_has(self):
        import filmsticking

        stub = (FOLDER / "filmsticking" / "_core.pyi").read_text()
        for kind in ("Hole", "Report", "Result", "Options", "Status"):
            members = [name for name in dir(getattr(filmsticking._core, kind)) if not name.startswith("_")]
            part = stub.split(f"class {kind}")[1].split("\nclass")[0]
            for name in members:
                if name not in ("name", "value"):  # of an enumeration
                    self.assertRegex(part, rf"\b{name}\b")


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The build backend of pip (PEP 517): runs CMake and zips what it installs. Needs no package of PyPI.

By hand: setuptools and scikit-build-core would have to be downloaded into pip's own environment first.
"""

import base64
import hashlib
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

PYTHON = Path(__file__).resolve().parent.parent
SOURCES = PYTHON.parent


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("the sources are the whole repository; install from a clone of it")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = Path(metadata_directory, f"filmsticking-{_version()}.dist-info")
    info.mkdir()
    for name, text in _metadata().items():
        (info / name).write_text(text)
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"filmsticking-{_version()}-{_tag()}.whl"
    with tempfile.TemporaryDirectory(prefix="filmsticking-") as folder:
        package = _built_package(Path(folder))
        contents = {f"filmsticking/{file.name}": file.read_bytes() for file in sorted(package.iterdir())
                    if file.is_file()}  # fmt: skip
    info = f"filmsticking-{_version()}.dist-info"
    contents.update((f"{info}/{file}", text.encode()) for file, text in _metadata().items())
    record = "".join(f"{file},sha256={_digest(data)},{len(data)}\n" for file, data in contents.items())
    contents[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    with zipfile.ZipFile(Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for file, data in contents.items():
            wheel.writestr(file, data)
    return name


def _built_package(folder):
    """Where CMake put the package: the core is linked into its module."""
    if shutil.which("cmake") is None:
        raise RuntimeError("cmake is needed; on Debian: apt install cmake g++ pybind11-dev libcgal-dev libtbb-dev")
    build, prefix = folder / "build", folder / "prefix"
    off = [f"-DFILMSTICKING_BUILD_{part}=OFF" for part in ("PCL", "APPS", "ROS", "TESTS", "BENCHMARKS")]
    _run("cmake", "-S", SOURCES, "-B", build, "-Wno-dev", *off, "-DFILMSTICKING_BUILD_PYTHON=ON",
         "-DBUILD_SHARED_LIBS=OFF", f"-DPython3_EXECUTABLE={sys.executable}",
         "-DFILMSTICKING_PYTHON_DIR=packages")  # fmt: skip
    _run("cmake", "--build", build, "--target", "filmsticking_python", "--parallel", str(os.cpu_count() or 1))
    _run("cmake", "--install", build, "--prefix", prefix, "--component", "python", "--strip")
    return prefix / "packages" / "filmsticking"


def _run(*command):
    subprocess.run([str(word) for word in command], check=True)


def _version():
    return re.search(r"project\(FilmstickingPP VERSION ([0-9.]+)", (SOURCES / "CMakeLists.txt").read_text())[1]


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def _metadata():
    return {
        "METADATA": f"Metadata-Version: 2.1\nName: filmsticking\nVersion: {_version()}\n"
        "Summary: Closed, manifold, interpolating triangle meshes of point clouds without normals\n"
        "License: GPL-3.0-or-later\nRequires-Python: >=3.8\nRequires-Dist: numpy\n",
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: filmsticking_build\nRoot-Is-Purelib: false\nTag: {_tag()}\n",
        "LICENSE": (SOURCES / "LICENSE").read_text(),
    }

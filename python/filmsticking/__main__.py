# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m filmsticking CLOUD MESH: pcd_to_mesh where only the Python package is installed."""

from __future__ import annotations

import argparse
import sys
from typing import List, Optional

from . import Error, __version__, reconstruct
from .files import positions_of, read_cloud, write_mesh


def _arguments(words: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m filmsticking", description="Makes a mesh through the points of a cloud."
    )
    parser.add_argument("cloud", help=".ply .xyz .txt .npy")
    parser.add_argument("mesh", help=".ply; vertices keep all fields of the cloud")
    parser.add_argument("--open", action="store_true", help="leave out the faces that no points support")
    parser.add_argument("--viewpoint", metavar="X,Y,Z", help="where all points may have been seen from")
    parser.add_argument("--keep-outliers", action="store_true", help="mesh points far from all others, too")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="0, the default: all")
    parser.add_argument("--version", action="version", version=__version__)
    given = parser.parse_args(words)
    if given.viewpoint is not None:
        try:
            given.viewpoint = [float(word) for word in given.viewpoint.split(",")]
        except ValueError:
            parser.error("--viewpoint takes X,Y,Z")
    return given


def main(words: Optional[List[str]] = None) -> int:
    """The exit status is 0 only if the mesh was written; else one sentence on stderr says why."""
    given = _arguments(words)
    try:
        cloud = read_cloud(given.cloud)
        mesh = reconstruct(
            positions_of(cloud),
            open=given.open,
            viewpoint=given.viewpoint,
            keep_outliers=given.keep_outliers,
            threads=given.threads,
        )
        write_mesh(given.mesh, cloud[mesh.vertices], mesh.triangles)
    except KeyboardInterrupt:
        print("filmsticking: interrupted", file=sys.stderr)
        return 130
    except Error as error:
        print(f"filmsticking: {given.cloud}: {error}", file=sys.stderr)
        return 1
    except (OSError, ValueError, MemoryError) as error:
        print(f"filmsticking: {error or 'the memory does not suffice'}", file=sys.stderr)
        return 1
    report = mesh.report
    print(f"{given.mesh}: {len(mesh.vertices)} vertices, {len(mesh.triangles)} triangles, ", end="")
    print("closed" if report.closed else f"{report.boundary_loops} borders", end="")
    print(f", genus {report.genus}, {report.seconds:.1f} s")
    if report.warning:
        print(f"note: {report.warning}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed, manifold, interpolating triangle meshes of point clouds without normals.

    import filmsticking
    mesh = filmsticking.reconstruct(points)           # points: (n, 3), float32 or float64
    mesh.points, mesh.triangles                       # (v, 3) of the input, (t, 3) indices into them

Method: Wang et al., "Filmsticking++", arXiv 2602.11433.
"""

from __future__ import annotations

import operator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Callable, Optional, Sequence, Tuple

import numpy as np

from . import _core
from ._core import Hole, Report, Status, __version__

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Error", "Hole", "Mesh", "Report", "Status", "__version__", "reconstruct"]


class Error(RuntimeError):
    """No mesh was made. Its text is one sentence that says why."""

    status: Status  #: the kind of failure
    report: Report  #: what was done, up to the failure

    def __init__(self, message: str, status: Status, report: Report) -> None:
        super().__init__(message)
        self.status = status
        self.report = report


@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh whose vertices are input points. Not copied: arrays are those of the library.

    Every edge has two faces (with `open` or `max_hole`: one or two), the faces around a vertex form one ring (or fan), and
    outermost components wind counter-clockwise seen from outside.
    """

    vertices: NDArray[np.int32]  #: (v,) vertex k is input point vertices[k]; strictly increasing
    triangles: NDArray[np.int32]  #: (t, 3) indices into `vertices`
    #: (t,) float32, the gap that each triangle bridges: the diameter of its smallest enclosing circle, in
    #: spacings of the points there. About 1.5 where the sampling is even; large where no data support it.
    gaps: NDArray[np.float32]
    stability: Optional[NDArray[np.float32]]  #: (t,) confidence, 0 to 1; None unless asked for
    report: Report  #: what was done
    status: Status  #: Status.Ok: other ends are exceptions
    _input: NDArray[np.floating[Any]]
    _threads: int

    @property
    def points(self) -> NDArray[np.floating[Any]]:
        """(v, 3) positions of the vertices, in the type of the input; a copy at every call."""
        return self._input[self.vertices]

    @cached_property
    def normals(self) -> NDArray[np.float32]:
        """(n, 3) float32, one unit normal for every *input* point, oriented by the surface; computed at the
        first use. A point that is no vertex gets that of the nearest place, one that is not finite NaN.
        """
        return _core.point_normals(self._input, self.vertices, self.triangles, self._threads)


def reconstruct(
    points: ArrayLike,
    *,
    open: bool = False,
    max_hole: float = 0,
    viewpoint: Optional[Sequence[float]] = None,
    viewpoints: Optional[ArrayLike] = None,
    view_direction: Optional[Sequence[float]] = None,
    keep_outliers: bool = False,
    sharp_edges: bool = True,
    stability: bool = False,
    threads: int = 0,
    max_memory: int = 0,
    progress: Optional[Callable[[float, str], object]] = None,
) -> Mesh:
    """Reconstructs the surface through points without normals.

    points: (n, 3) in any unit and order. float32 and float64 are read in place, with any stride between
        points; other arrays are copied once. Rows with NaN or infinity, masked and repeated ones are skipped.
        No other thread may change them meanwhile.
    open: the result may have a boundary; faces that no data support are left out.
    max_hole: as `open`, but holes of at most this diameter, in the unit of the points, get a lid; 0: none.
        report.holes lists all holes.
    viewpoint: (3,) where all points were seen from. What is between is outside, what is just behind inside.
    viewpoints: (n, 3) where each point was seen from, instead; NaN: unknown.
    view_direction: (3,) the way in which a far sensor looked at all points, instead; (0, 0, -1): from above.
    keep_outliers: mesh points that are far from all others, too.
    sharp_edges: flip edges to lie along sharp edges.
    stability: fill Mesh.stability, in about a tenth more time.
    threads: 0: all of the machine. The result does not depend on it.
    max_memory: bytes; a reconstruction that needs more is an Error. 0: no limit.
    progress: called as progress(share, stage) in the calling thread; share rises from 0 to 1.

    The interpreter's lock is released. Ctrl-C, and what `progress` raises, end the work and are raised.
    The same points give the same bytes, with any number of threads.

    Raises Error with one sentence and a status if there is no surface; ValueError or TypeError for arguments
    of another shape or kind.
    """
    array = _rows_of_three(points)
    options = _core.Options()
    options.open_boundary = bool(open)
    options.max_hole = float(max_hole)
    options.viewpoint = None if viewpoint is None else _place("viewpoint", viewpoint)
    options.view_direction = None if view_direction is None else _place("view_direction", view_direction)
    if viewpoints is not None:
        _core.set_viewpoints(options, np.ascontiguousarray(_rows_of_three(viewpoints), dtype=np.float64))
    options.keep_outliers = bool(keep_outliers)
    options.sharp_edges = bool(sharp_edges)
    options.stability = bool(stability)
    options.threads = _integer("threads", threads, 2**31)
    options.max_memory = _integer("max_memory", max_memory, 2**63)
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function of a share and the name of a stage")
    result = _core.reconstruct(array, options, progress)
    if result.status != Status.Ok:
        raise Error(result.message or result.status.name, result.status, result.report)
    return Mesh(
        vertices=result.vertices,
        triangles=result.triangles,
        gaps=result.gaps,
        stability=result.stability if stability and result.stability.size else None,
        report=result.report,
        status=result.status,
        _input=array,
        _threads=max(0, options.threads),
    )


def _rows_of_three(points: ArrayLike) -> NDArray[np.floating[Any]]:
    """The points as the core reads them: in place if their type and layout allow."""
    if isinstance(points, np.ma.MaskedArray):
        masked = np.asarray(points.mask)
        points = np.array(points.data, dtype=np.float64)
        points[masked] = np.nan
    array: NDArray[Any] = np.asarray(points)
    if array.ndim != 2 or array.shape[1] != 3:
        hint = "; pass points[:, :3]" if array.ndim == 2 and array.shape[1] > 3 else ""
        raise ValueError(f"points must have the shape (n, 3), not {array.shape}{hint}")
    if array.dtype not in (np.float32, np.float64):
        if array.dtype.kind not in "fiu":
            raise TypeError(f"points must be real numbers, not {array.dtype}")
        array = array.astype(np.float64)
    if array.strides[1] != array.itemsize or array.strides[0] < 0:
        array = np.ascontiguousarray(array)
    return array


def _integer(name: str, value: int, end: int) -> int:
    number = operator.index(value)
    if not -end <= number < end:
        raise ValueError(f"{name} must be below {end}, not {number}")
    return number


def _place(name: str, numbers: Sequence[float]) -> Tuple[float, float, float]:
    place = np.asarray(numbers, dtype=np.float64)
    if place.shape != (3,):
        raise ValueError(f"{name} must have the shape (3,), not {place.shape}")
    return (float(place[0]), float(place[1]), float(place[2]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Clouds and meshes in files, with NumPy alone. pcd_to_mesh reads and writes more formats."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, List, Optional, Tuple, Union

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

PathLike = Union[str, "os.PathLike[str]"]

_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
    "ushort": "u2", "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}  # fmt: skip
_NAMES = {"i1": "char", "u1": "uchar", "i2": "short", "u2": "ushort", "i4": "int", "u4": "uint",
          "f4": "float", "f8": "double"}  # fmt: skip


class FileError(ValueError):
    """A file cannot be read; the text names it and says why."""


def read_cloud(path: PathLike) -> NDArray[np.void]:
    """Reads .ply (text or binary), .xyz, .txt or .npy.

    Returns a structured array (n,): the fields x, y and z, and all others of a PLY file's vertices.
    Raises FileError, OSError.
    """
    kind = Path(path).suffix.lower()
    try:
        if kind == ".ply":
            return _read_ply(path)
        if kind == ".npy":
            return _with_names(np.load(path, allow_pickle=False))
        if kind in (".xyz", ".txt"):
            return _with_names(np.loadtxt(path, dtype=np.float64, usecols=(0, 1, 2), ndmin=2))
    except (ValueError, IndexError) as error:
        raise FileError(f"{path}: {error}") from None
    raise FileError(f"{path}: its extension is none of .ply .xyz .txt .npy; pcd_to_mesh reads .pcd .obj .stl")


def positions_of(cloud: NDArray[np.void]) -> NDArray[np.floating[Any]]:
    """The fields x, y, z of a structured array (n,) as (n, 3): float32 if all three are, else float64."""
    single = all(cloud.dtype[axis].str[1:] == "f4" for axis in "xyz")
    columns = [cloud[axis] for axis in "xyz"]
    positions: NDArray[np.floating[Any]] = np.stack(columns, axis=1)
    return positions.astype(np.float32 if single else np.float64, copy=False)


def write_mesh(path: PathLike, vertices: NDArray[Any], triangles: NDArray[np.int32]) -> None:
    """Writes a binary .ply.

    vertices: structured (v,), with all its fields, or (v, 3). triangles: (t, 3) indices into them.
    The file appears under its name when it is whole.
    """
    if Path(path).suffix.lower() != ".ply":
        raise FileError(f"{path}: its extension is not .ply; pcd_to_mesh writes .obj .stl .vtk .glb")
    if vertices.dtype.names is None:
        vertices = _with_names(vertices)
    vertices = vertices.astype(vertices.dtype.newbyteorder("<"))
    faces = np.empty(len(triangles), dtype=[("n", "u1"), ("corners", "<i4", 3)])
    faces["n"] = 3
    faces["corners"] = triangles
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    for name in vertices.dtype.names or ():
        header.append(f"property {_NAMES[vertices.dtype[name].str[1:]]} {name}")
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header", ""]

    folder = Path(path).resolve().parent
    handle, draft = tempfile.mkstemp(dir=folder, suffix=".ply")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write("\n".join(header).encode("ascii"))
            vertices.tofile(file)
            faces.tofile(file)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(draft, 0o666 & ~mask)  # mkstemp makes files that others cannot read
        os.replace(draft, path)
    except BaseException:
        os.unlink(draft)
        raise


def _with_names(points: NDArray[Any]) -> NDArray[np.void]:
    if points.ndim != 2 or points.shape[1] != 3 or points.dtype.kind not in "fiu":
        raise ValueError(f"an array (n, 3) of numbers is needed, not {points.dtype} {points.shape}")
    kind = "<f4" if points.dtype == np.float32 else "<f8"
    named = np.empty(len(points), dtype=[(axis, kind) for axis in "xyz"])
    for column, axis in enumerate("xyz"):
        named[axis] = points[:, column]
    return named


class _Element:
    def __init__(self, name: str, count: int) -> None:
        self.name = name
        self.count = count
        self.fields: List[Tuple[str, str]] = []
        self.has_list = False


def _read_header(file: BinaryIO) -> Tuple[str, List[_Element]]:
    if file.readline(8).strip() != b"ply":
        raise ValueError("it is no PLY file")
    form = ""
    elements: List[_Element] = []
    while True:
        line = file.readline(10000)
        words = line.decode("latin-1").split()
        if not line.endswith(b"\n"):
            raise ValueError("its header does not end")
        if not words or words[0] in ("comment", "obj_info"):
            continue
        if words[0] == "end_header":
            return form, elements
        if words[0] == "format" and len(words) == 3:
            form = words[1]
        elif words[0] == "element" and len(words) == 3 and words[2].isdigit():
            elements.append(_Element(words[1], int(words[2])))
        elif words[0] == "property" and elements and words[1:2] == ["list"]:
            elements[-1].has_list = True
        elif words[0] == "property" and elements and len(words) == 3 and words[1] in _TYPES:
            elements[-1].fields.append((words[2], _TYPES[words[1]]))
        else:
            raise ValueError(f"its header has the line '{' '.join(words)}'")


def _read_ply(path: PathLike) -> NDArray[np.void]:
    with open(path, "rb") as file:
        form, elements = _read_header(file)
        order = {"binary_little_endian": "<", "binary_big_endian": ">", "ascii": ""}.get(form)
        if order is None:
            raise ValueError(f"its format is '{form}'")
        for element in elements:
            if element.has_list and element.name == "vertex":
                raise ValueError("its vertices have lists")
            if element.has_list:
                raise ValueError(f"the element {element.name} comes before the vertices")
            read = _text_rows if form == "ascii" else _binary_rows
            rows = read(file, element, order)
            if element.name == "vertex":
                missing = [axis for axis in "xyz" if axis not in (rows.dtype.names or ())]
                if missing:
                    raise ValueError(f"its vertices have no {missing[0]}")
                return rows
    raise ValueError("it has no vertices")


def _binary_rows(file: BinaryIO, element: _Element, order: str) -> NDArray[np.void]:
    dtype = np.dtype([(name, order + kind) for name, kind in element.fields])
    size = element.count * dtype.itemsize
    left = os.fstat(file.fileno()).st_size - file.tell()
    if size > left:
        raise ValueError(f"{element.count} of the element {element.name} are announced, and it ends before")
    return np.frombuffer(file.read(size), dtype=dtype, count=element.count)


def _text_rows(file: BinaryIO, element: _Element, order: str) -> NDArray[np.void]:
    lines: List[bytes] = []
    while len(lines) < element.count:
        line = file.readline()
        if not line:
            raise ValueError(f"{element.count} of the element {element.name} are announced, and it ends before")
        if line.strip():
            lines.append(line)
    dtype = np.dtype(element.fields)
    rows = np.empty(element.count, dtype=dtype)
    if not lines:
        return rows
    numbers = np.loadtxt(lines, dtype=np.float64, ndmin=2, comments=None)
    if numbers.shape[1] != len(element.fields):
        raise ValueError(f"the element {element.name} has {numbers.shape[1]} numbers, not {len(element.fields)}")
    for column, (name, kind) in enumerate(element.fields):
        if kind[0] != "f":
            limits = np.iinfo(kind)
            within = (numbers[:, column] >= limits.min) & (numbers[:, column] <= limits.max)
            if not within.all():
                raise ValueError(f"a number of the property {name} does not fit its type")
        rows[name] = numbers[:, column]
    return rows

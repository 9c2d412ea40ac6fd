#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fingerprints of meshes, to show that a change of the code changes no mesh.

    same_bytes.py run BIN -o before.tsv [--list CATALOG.tsv] [--clouds DIR] [CLOUD..]
    same_bytes.py diff before.tsv after.tsv

`run` meshes every cloud with BIN/pcd_to_mesh by four ways and writes a line for each mesh: cloud, way, a hash of
positions and triangles, a hash of the whole file. The clouds are those given, and with --list a sample of every
closed mesh of a catalogue, which BIN/compare draws into DIR, once. `diff` lists the lines that differ: `mesh` where
positions or triangles do, `file` where only other bytes of the file do. Exit status 1 if any mesh differs.
"""
import argparse
import csv
import hashlib
import os
import struct
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

WAYS = {"closed": [], "open": ["--open"], "paper": ["--preset", "paper"], "wrap": ["--init", "wrap"]}
SCALARS = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f",
           "double": "d"}


def geometry_hash(data):
    """Of a little-endian PLY file: positions as doubles, and triangles, whatever else the file holds."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    elements = []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    digest = hashlib.sha256()
    for name, count, properties in elements:
        if name == "vertex":
            row = struct.Struct("<" + "".join(SCALARS[kind] for kind, _ in properties))
            places = [[name for _, name in properties].index(axis) for axis in "xyz"]
            for values in row.iter_unpack(data[end:end + count * row.size]):
                digest.update(struct.pack("<3d", *(values[k] for k in places)))
            end += count * row.size
        else:
            digest.update(data[end:end + 13 * count])  # one byte for three corners, and these
            end += 13 * count
    return digest.hexdigest()[:16]


def fingerprint(program, cloud, way):
    with tempfile.TemporaryDirectory() as folder:
        mesh = os.path.join(folder, "mesh.ply")
        done = subprocess.run([program, cloud, mesh, "--threads", "1", *WAYS[way]], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            said = done.stderr.strip().splitlines()
            return ["failed", said[-1].split(": ")[-1] if said else str(done.returncode)]
        with open(mesh, "rb") as file:
            data = file.read()
    return [geometry_hash(data), hashlib.sha256(data).hexdigest()[:16]]


def sampled(options):
    """The clouds of --list: 10,000 points of every closed mesh."""
    if not options.list:
        return []
    os.makedirs(options.clouds, exist_ok=True)
    clouds = []
    with open(options.list, newline="") as table:
        for row in csv.DictReader(table, delimiter="\t"):
            if row["kind"] != "mesh" or row["watertight"] != "yes":
                continue
            cloud = os.path.join(options.clouds, row["name"] + ".ply")
            if not os.path.exists(cloud):
                source = os.path.join(os.path.dirname(options.list), row["file"])
                subprocess.run([os.path.join(options.bin, "compare"), "sample", source, "-o", cloud, "--points", "10K"],
                               check=True, stdout=subprocess.DEVNULL)
            clouds.append(cloud)
    return clouds


def run(options):
    jobs = [(cloud, way) for cloud in options.cloud + sampled(options) for way in WAYS]
    program = os.path.join(options.bin, "pcd_to_mesh")
    with ThreadPoolExecutor(options.jobs) as pool, open(options.output, "w") as out:
        for (cloud, way), found in zip(jobs, pool.map(lambda job: fingerprint(program, *job), jobs)):
            print(os.path.basename(cloud), way, *found, sep="\t", file=out, flush=True)


def diff(options):
    tables = []
    for path in (options.before, options.after):
        with open(path) as file:
            rows = (line.rstrip("\n").split("\t") for line in file)
            tables.append({(row[0], row[1]): row[2:] for row in rows})
    before, after = tables
    worse = 0
    for key in sorted(before.keys() | after.keys()):
        old, new = before.get(key, ["none", ""]), after.get(key, ["none", ""])
        if old != new:
            kind = "file" if old[0] == new[0] != "failed" else "mesh"
            worse += kind == "mesh"
            print(kind, *key, *old, "->", *new)
    print(f"{len(before.keys() & after.keys())} compared, {worse} meshes differ")
    return 1 if worse or before.keys() != after.keys() else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    modes = parser.add_subparsers(required=True)
    mode = modes.add_parser("run")
    mode.add_argument("bin")
    mode.add_argument("cloud", nargs="*")
    mode.add_argument("-o", "--output", required=True)
    mode.add_argument("--list")
    mode.add_argument("--clouds", default="same_bytes_clouds")
    mode.add_argument("--jobs", type=int, default=os.cpu_count())
    mode.set_defaults(call=run)
    mode = modes.add_parser("diff")
    mode.add_argument("before")
    mode.add_argument("after")
    mode.set_defaults(call=diff)
    options = parser.parse_args()
    return options.call(options) or 0


if __name__ == "__main__":
    sys.exit(main())

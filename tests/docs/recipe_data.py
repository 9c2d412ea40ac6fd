#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that the commands of docs/recipes.md read, made of tests/data or of formulas.

    recipe_data.py TESTS_DATA FOLDER      writes all of them to FOLDER
"""
import math
import os
import random
import shutil
import struct
import sys


def write_xyz(path, points):
    with open(path, "w", encoding="ascii") as file:
        file.writelines("%.6f %.6f %.6f\n" % point for point in points)


def write_pcd(path, points, viewpoint="0 0 0 1 0 0 0", width=None):
    width = width or len(points)
    with open(path, "wb") as file:
        file.write(("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                    f"WIDTH {width}\nHEIGHT {len(points) // width}\nVIEWPOINT {viewpoint}\n"
                    f"POINTS {len(points)}\nDATA binary\n").encode())
        for point in points:
            file.write(struct.pack("<3f", *point))


def read_ply_floats(path):
    """The positions of a binary PLY of x, y, z in single precision."""
    with open(path, "rb") as file:
        header = b""
        while not header.endswith(b"end_header\n"):
            header += file.readline()
        count = int(header.split(b"element vertex ")[1].split()[0])
        return [struct.unpack("<3f", file.read(12)) for _ in range(count)]


def colmap_fused(data, path):
    """As COLMAP's stereo_fusion writes it: positions, normals and colours, noisy, with strays."""
    rng = random.Random(1)
    points = [tuple(x + rng.gauss(0, 0.002) for x in point) for point in read_ply_floats(data + "/spot_10k.ply")]
    points += [tuple(rng.uniform(-1.5, 1.5) for _ in range(3)) for _ in range(60)]
    names = "".join(f"property float {name}\n" for name in "x y z nx ny nz".split())
    names += "".join(f"property uchar {name}\n" for name in "red green blue".split())
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{names}end_header\n".encode())
        for x, y, z in points:
            file.write(struct.pack("<6f3B", x, y, z, 0, 0, 1, 200, 150, int(100 + 50 * (x > 0))))


def depth_frame(path):
    """An organised frame of a ball before a wall, 0.8 and 1.5 m away, with noise that grows with the depth."""
    rng, points, width, height, focal = random.Random(2), [], 160, 120, 140
    for row in range(height):
        for column in range(width):
            x, y = (column - width / 2) / focal, (row - height / 2) / focal
            # |t (x, y, 1) - (0, 0, 0.9)| = 0.25
            a, b, c = x * x + y * y + 1, -1.8, 0.81 - 0.0625
            root = b * b - 4 * a * c
            depth = (-b - math.sqrt(root)) / (2 * a) if root > 0 else 1.5
            depth += rng.gauss(0, 0.0015 * depth * depth)
            lost = rng.random() < 0.01
            points.append((math.nan,) * 3 if lost else (x * depth, y * depth, depth))
    write_pcd(path, points, width=width)


def room_stations(folder):
    """Two stations in a room of 6 x 4 x 3 with a block of 1.5 x 1 x 1; each in its own coordinates."""
    os.makedirs(folder)
    block = ((2.5, 1.5, 0), (4, 2.5, 1))
    for number, eye in enumerate([(1, 1, 1.6), (5, 3, 1.6)]):
        rng, points = random.Random(number), []
        while len(points) < 15000:
            ray = [rng.gauss(0, 1) for _ in range(3)]
            length = math.sqrt(sum(x * x for x in ray))
            ray = [x / length for x in ray]
            wall = min(((6, 4, 3)[k] - eye[k] if ray[k] > 0 else -eye[k]) / ray[k] for k in range(3))
            spans = [sorted(((block[0][k] - eye[k]) / ray[k], (block[1][k] - eye[k]) / ray[k])) for k in range(3)]
            enter, leave = max(s[0] for s in spans), min(s[1] for s in spans)
            far = enter if 0 < enter < leave else wall
            points.append(tuple(far * x for x in ray))
        write_pcd(f"{folder}/station_{number}.pcd", points, "%g %g %g 1 0 0 0" % eye)


def stockpile(path):
    """A heap of 0.467 cubic metres, 1 m in radius, on even ground."""
    rng, points = random.Random(3), []
    for _ in range(20000):
        x, y = rng.uniform(-2, 2), rng.uniform(-2, 2)
        r = math.hypot(x, y)
        points.append((x, y, (0.25 * (1 + math.cos(math.pi * r)) if r < 1 else 0) + rng.gauss(0, 0.003)))
    write_xyz(path, points)


def terrain(path):
    """A raster of heights in UTM, with a step of three cells and without the cells of a pond."""
    rng = random.Random(5)
    write_xyz(path, [(483000 + x, 5457000 + y,
                      200 + 2 * math.sin(x / 9) + (3 if x + y > 50 else 0) + rng.gauss(0, 0.03))
                     for x in range(60) for y in range(50) if (x - 18) ** 2 + (y - 14) ** 2 > 36])


def printed_part(path):
    """A plate of 40 x 30 x 10 mm with a bore of 12 mm."""
    rng, points = random.Random(4), []
    for _ in range(10000):
        x, y = rng.uniform(0, 40), rng.uniform(0, 30)
        if math.hypot(x - 20, y - 15) > 6:
            points.append((x, y, rng.choice((0, 10))))
    for _ in range(3000):
        z, along = rng.uniform(0, 10), rng.uniform(0, 140)
        points.append((along, 0, z) if along < 40 else (40, along - 40, z) if along < 70
                      else (110 - along, 30, z) if along < 110 else (0, 140 - along, z))
    for _ in range(1000):
        angle = rng.uniform(0, 2 * math.pi)
        points.append((20 + 6 * math.cos(angle), 15 + 6 * math.sin(angle), rng.uniform(0, 10)))
    write_xyz(path, points)


def write_all(data, folder):
    colmap_fused(data, folder + "/fused.ply")
    shutil.copy(data + "/milk.pcd", folder + "/kinect.pcd")
    shutil.copytree(data + "/spot_turntable", folder + "/turntable")
    room_stations(folder + "/stations")
    stockpile(folder + "/stockpile.xyz")
    terrain(folder + "/terrain.xyz")
    printed_part(folder + "/part.xyz")
    shutil.copy(data + "/spot_10k.ply", folder + "/scan.ply")
    depth_frame(folder + "/frame.pcd")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write_all(sys.argv[1], sys.argv[2])

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_corpus.py FOLDER [POINTS]: writes one ellipsoid of 600 coloured points in every variant of every format.

FOLDER/truth.txt has a line a point: x y z r g b nx ny nz. FOLDER/manifest.tsv has a line a variant:

    read NAME colours=0|1 scale=S offset=X,Y,Z tolerance=D skipped=N fields=a,b said=WORDS columns=.. writer=WHO
    refuse NAME said=WORDS columns=.. writer=WHO
    grid NAME

separated by tabs. Coordinates are those of the truth times `scale`, plus `offset`, to `tolerance`; `order=0`: in any order, repeated
ones once; `skipped` points are not finite or lie far outside;
`fields` must be there; `said` must be in a note, or in the refusal; `columns` is handed to the reader.
"""
import math
import random
import struct
import sys
from pathlib import Path

N = int(sys.argv[2]) if len(sys.argv) > 2 else 600  # a multiple of 20
HALF = N // 2
GOLDEN = math.pi * (3 - math.sqrt(5))


def ellipsoid():
    points = []
    for i in range(N):
        w = 1 - (2 * i + 1) / N
        s = math.sqrt(1 - w * w)
        unit = (s * math.cos(GOLDEN * i), s * math.sin(GOLDEN * i), w)
        p = tuple(round(a * u, 6) for a, u in zip((1, 0.6, 0.4), unit))
        g = tuple(u / a for a, u in zip((1, 0.6, 0.4), unit))
        length = math.sqrt(sum(x * x for x in g))
        colour = tuple(int(127.5 + 127 * u) for u in unit)
        points.append((p, colour, tuple(round(x / length, 6) for x in g)))
    return points


POINTS = ellipsoid()
random.seed(36)
INTENSITY = [random.randrange(40, 240) for _ in POINTS]
TIME = [1500000000 + 0.1 * i for i in range(N)]
folder = Path(sys.argv[1])
folder.mkdir(parents=True, exist_ok=True)
manifest = []


def add(kind, name, data, said=None, **facts):
    if isinstance(data, str):
        data = data.encode()
    (folder / name).write_bytes(data)
    if said:
        facts["said"] = said
    manifest.append("\t".join([kind, name] + [f"{k}={v}" for k, v in facts.items()]))


def read(name, data, colours=0, said=None, **facts):
    add("read", name, data, said, colours=colours, **facts)


def refuse(name, data, said, **facts):
    add("refuse", name, data, said, **facts)


# ---- text

def xyz(p, form="%.6f"):
    return [form % x for x in p]


def rows(*parts):
    """A row of words a point; each part is a function of point, colour, normal and number."""
    return [[w for part in parts for w in part(p, c, n, i)] for i, (p, c, n) in enumerate(POINTS)]


def text(table, separator=" ", head="", end="\n", tail=""):
    return head + "".join(separator.join(row) + end for row in table) + tail


def P(p, c, n, i):
    return xyz(p)


def RGB(p, c, n, i):
    return [str(v) for v in c]


def UNIT(p, c, n, i):
    return ["%.6f" % (v / 255) for v in c]


def BYTES_REAL(p, c, n, i):
    return ["%.1f" % v for v in c]


def WIDE(p, c, n, i):
    return [str(257 * v) for v in c]


def NORMAL(p, c, n, i):
    return xyz(n)


def I(p, c, n, i):
    return [str(INTENSITY[i])]


def I01(p, c, n, i):
    return ["%.4f" % (INTENSITY[i] / 255)]


def ID(p, c, n, i):
    return [str(i + 1)]


def T(p, c, n, i):
    return ["%.3f" % TIME[i]]


def C(word):
    return lambda p, c, n, i: [word]


def PACKED(p, c, n, i):
    return [str(c[0] << 16 | c[1] << 8 | c[2])]


def make_text():
    plain = rows(P)
    for ext, separator in [("xyz", " "), ("txt", "\t"), ("csv", ","), ("asc", ";"), ("pts", "  "), ("dat", ", "),
                           ("neu", " ; "), ("xyz1", " \t ")]:
        read(f"plain.{ext}", text(plain, separator))
    read("no_end_of_line.xyz", text(plain).rstrip("\n"))
    for name, end in [("dos", "\r\n"), ("mac", "\r"), ("blank_lines", "\n\n"), ("trailing_blanks", "  \n"),
                      ("trailing_tab", "\t\n")]:
        read(f"end_{name}.xyz", text(plain, end=end))
    read("end_comma.csv", text(plain, ",", end=",\n"))
    read("end_semicolon.txt", text(plain, " ", end=";\n"), writer="MATLAB")
    for name, codec in [("utf8_bom", "utf-8-sig"), ("utf16", "utf-16"), ("utf16le", "utf-16-le"),
                        ("utf16be", "utf-16-be")]:
        read(f"{name}.xyz", text(plain).encode(codec))
        read(f"{name}_header.csv", text(rows(P, RGB), ",", head="x,y,z,r,g,b\n").encode(codec), 1)
    refuse("utf32.xyz", text(plain).encode("utf-32"), "UTF-8")
    # Numbers
    comma = [[w.replace(".", ",") for w in row] for row in plain]
    read("decimal_comma_blank.xyz", text(comma), said="decimal points")
    read("decimal_comma_tab.txt", text(comma, "\t"), said="decimal points", writer="Excel, German")
    read("decimal_comma_semicolon.csv", text(comma, ";"), said="decimal points", writer="Excel, German")
    read("decimal_comma_header.csv", text(comma, ";", head="X;Y;Z\n"), said="decimal points")
    read("decimal_comma_quoted.csv", text([[f'"{w}"' for w in row] for row in comma], ","))
    refuse("decimal_comma_comma.csv", text(comma, ","), "decimal points or separators")
    refuse("thousands.txt", text([[f"{1e6 * float(w):,.2f}" for w in row] for row in plain]), "1,234.5")
    read("fortran.xyz", text([["%.7E" % float(w) for w in row] for row in plain]).replace("E", "D"))
    read("exponents.xyz", text([["%.7e" % float(w) for w in row] for row in plain]))
    read("plus_signs.xyz", text([["%+.6f" % float(w) for w in row] for row in plain]))
    read("seventeen_digits.xyz", text([["%.17g" % float(w) for w in row] for row in plain]))
    read("quoted.csv", text([[f'"{w}"' for w in row] for row in plain], ","))
    read("single_quotes.csv", text([[f"'{w}'" for w in row] for row in plain], ","))
    read("brackets.txt", text(plain, " ", end="]\n").replace("\n", "\n[").rstrip("[").join(["[", ""]), writer="NumPy")
    read("round_brackets.txt", "".join("(" + ", ".join(row) + ")\n" for row in plain))
    read("json_rows.txt", "[" + ",\n".join("[" + ", ".join(row) + "]" for row in plain) + "]\n")
    # What is no point
    read("comments.xyz", text(plain, head="# a comment\n// another\n% and\n! another\n\n"))
    read("comment_behind.xyz", text(plain, end=" # a point\n"))
    read("heading.xyz", text(plain, head="a scan of an ellipsoid\nmade for a test\n"))
    read("trailer.xyz", text(plain, tail="END\n"))
    read("trailer_comment.xyz", text(plain, tail="# 600 points\n"))
    read("trailer_count.txt", text(plain, tail=f"{N}\n"))
    read("count.pts", text(plain, head=f"{N}\n"), writer="Leica Cyclone")
    read("two_blocks.pts", text(plain[:HALF], head=f"{HALF}\n") + text(plain[HALF:], head=f"{N - HALF}\n"), writer="Leica Cyclone")
    refuse("count_too_large.pts", text(plain, head=f"{N + 1}\n"), f"announces {N + 1} points")
    refuse("count_too_small.pts", text(plain, head=f"{N - 1}\n"), f"announces {N - 1} points")
    read("molecule.xyz", text(rows(C("C"), P), head=f"{N}\nmade by a program\n"), writer="Open Babel")
    read("molecule_extended.xyz", text(rows(C("Si"), P), head=f'{N}\nProperties=species:S:1:pos:R:3\n'), writer="ASE")
    read("name_first.txt", text(rows(lambda p, c, n, i: [f"P{i + 1}"], P)), said="columns 2 to 4 as x y z")
    read("name_last.txt", text(rows(P, C("ground"))), said="without column 4")
    refuse("two_columns.xyz", text([row[:2] for row in plain]), "fewer than three numbers")
    refuse("one_column.xyz", text([row[:1] for row in plain]), "")
    refuse("short_line.xyz", text(plain[:HALF] + [plain[HALF][:2]] + plain[HALF + 1:]), f"line {HALF + 1}")
    refuse("long_line.xyz", text(plain[:HALF] + [plain[HALF] + ["1"]] + plain[HALF + 1:]), f"line {HALF + 1}")
    refuse("word_in_the_middle.xyz", text(plain[:HALF] + [["0.1", "0.2", "zero"]] + plain[HALF + 1:]), f"line {HALF + 1}")
    refuse("text_in_the_middle.xyz", text(plain[:HALF] + [["scan", "two"]] + plain[HALF + 1:]), f"line {HALF + 1}")
    refuse("prose.txt", "There is nothing here.\nNo numbers at all.\n", "no line has three numbers")
    refuse("separators.csv", text([row if i != 5 else [row[0], "", "", row[1], row[2]] for i, row in enumerate(plain)], ","),
           "line 6")
    read("missing_number.csv", text([row if i != 5 else [row[0], "", row[2]] for i, row in enumerate(plain)], ","),
         skipped=1)
    for word in ["nan", "NaN", "-nan", "NULL".lower(), "1.#QNAN", "-1.#IND", "-nan(ind)", "inf", "-Infinity"]:
        read("not_finite_" + word.replace("#", "_").replace("(", "_").replace(")", "") + ".xyz",
             text([row if i != 5 else [word] * 3 for i, row in enumerate(plain)]), skipped=1)
    # Headers
    for name, head, separator in [("csv", "x,y,z", ","), ("upper", "X,Y,Z", ","), ("blank", "x y z", " "), ("tab", "X\tY\tZ", "\t"),
                                  ("quoted", '"x","y","z"', ","), ("cloudcompare", "//X Y Z", " "), ("hash", "# x y z", " "),
                                  ("hash_close", "#x,y,z", ","), ("units", "x [m];y [m];z [m]", ";"),
                                  ("units_blank", "X[m] Y[m] Z[m]", " "), ("units_round", "X (m),Y (m),Z (m)", ","),
                                  ("utm_words", "Easting,Northing,Elevation", ","), ("paraview", '"Points:0","Points:1","Points:2"', ","),
                                  ("paraview_new", '"Points_0","Points_1","Points_2"', ","), ("spaces", "x, y, z", ", ")]:
        read(f"header_{name}.csv", text(plain, separator, head=head + "\n"))
    read("header_unknown.csv", text(plain, ",", head="a,b,c\n"), said="columns 1 to 3 as x y z")
    read("header_yxz.txt", text(rows(lambda p, c, n, i: [xyz(p)[1], xyz(p)[0], xyz(p)[2]]), head="Y X Z\n"))
    read("header_zyx.csv", text(rows(lambda p, c, n, i: xyz(p)[::-1]), ",", head="z,y,x\n"))
    refuse("header_xy.csv", text([row[:2] + ["1"] for row in plain], ",", head="x,y,w\n"), "no z")
    refuse("header_longer.csv", text(plain, ",", head="x,y,z,r\n"), "the header names 4")
    read("header_repeated.csv", text(plain[:HALF], ",", head="x,y,z\n") + text(plain[HALF:], ",", head="x,y,z\n"))
    read("header_id.csv", text(rows(ID, P), ",", head="ID,X,Y,Z\n"), said="left out column 1")
    read("header_id_last.csv", text(rows(P, ID), ",", head="X,Y,Z,ID\n"), said="left out column 4")
    read("header_time.csv", text(rows(T, P), ",", head="time,x,y,z\n"), fields="time")
    read("header_intensity.txt", text(rows(P, I, RGB), head="x y z intensity r g b\n"), 1, fields="intensity")
    read("header_rgb.csv", text(rows(P, RGB), ",", head="x,y,z,red,green,blue\n"), 1)
    read("header_rgb_first.csv", text(rows(RGB, P), ",", head="r,g,b,x,y,z\n"), 1)
    read("header_bgr.csv", text(rows(P, lambda p, c, n, i: [str(v) for v in c[::-1]]), ",", head="x,y,z,b,g,r\n"), 1)
    read("header_rgb_unit.csv", text(rows(P, UNIT), ",", head="X,Y,Z,R,G,B\n"), 1)
    read("header_rgb_real.csv", text(rows(P, BYTES_REAL), ",", head="X,Y,Z,R,G,B\n"), 1)
    read("header_rgb_wide.csv", text(rows(P, WIDE), ",", head="X,Y,Z,Red,Green,Blue\n"), 1, writer="PDAL")
    read("header_rgb_cloudcompare.asc", text(rows(P, RGB), head="//X Y Z R G B\n"), 1, writer="CloudCompare")
    read("header_rgb_count.asc", text(rows(P, RGB), head=f"//X Y Z R G B\n{N}\n"), 1, writer="CloudCompare")
    read("header_rgb_float_cloudcompare.asc", text(rows(P, UNIT), head="//X Y Z Rf Gf Bf\n"), 1, writer="CloudCompare")
    read("header_normals_cloudcompare.asc", text(rows(P, RGB, NORMAL), head="//X Y Z R G B Nx Ny Nz\n"), 1,
         fields="normal_x,normal_y,normal_z", writer="CloudCompare")
    read("header_scalar_cloudcompare.asc", text(rows(P, RGB, I), head="//X Y Z R G B Scalar_field\n"), 1,
         fields="scalar_field", writer="CloudCompare")
    read("header_packed.csv", text(rows(P, PACKED), ",", head="x,y,z,rgb\n"), 1)
    read("header_rgba.csv", text(rows(P, RGB, C("255")), ",", head="x,y,z,r,g,b,a\n"), 1)
    read("header_viewpoint.csv", text(rows(P, C("5"), C("6"), C("7.5")), ",", head="x,y,z,vp_x,vp_y,vp_z\n"),
         fields="vp_x,vp_y,vp_z")
    read("header_lidar.csv", text(rows(P, I, lambda p, c, n, i: [str(i % 16)], T), ",", head="X,Y,Z,intensity,laser_id,timestamp\n"),
         fields="intensity,laser_id,timestamp", writer="VeloView")
    read("header_pandas.csv", text(rows(ID, P), ",", head=",x,y,z\n"), said="left out column 1", writer="pandas")
    read("header_r.txt", text(rows(lambda p, c, n, i: [f'"{i + 1}"'], P), head='"x" "y" "z"\n'), said="left out column 1", writer="R")
    read("header_pyntcloud.csv", text(rows(P, RGB), ",", head="x,y,z,red,green,blue\n"), 1, writer="pyntcloud")
    refuse("header_latitude.csv", text(rows(P), ",", head="lat,lon,altitude\n"), "project them to metres")
    read("header_metashape.csv", text(rows(lambda p, c, n, i: [f"P{i}"], P, C("0.01"), C("0.02")), ",", head="#Label,X/Easting,Y/Northing,Z/Altitude,Error_(m),X_error\n"),
         said="left out column 1", writer="Metashape")
    read("header_rostopic.csv", text(rows(T, P, I), ",", head="%time,field.x,field.y,field.z,field.intensity\n"), fields="time", writer="rostopic echo -p")
    read("header_german.csv", text(rows(ID, lambda p, c, n, i: [xyz(p)[1], xyz(p)[0], xyz(p)[2]]), ",", head="Nr,Hochwert,Rechtswert,Hoehe\n"), said="left out column 1")
    read("header_enh.csv", text(rows(lambda p, c, n, i: [xyz(p)[1], xyz(p)[0], xyz(p)[2]]), ",", head="N,E,H\n"))
    read("header_color_red.csv", text(rows(P, RGB), ",", head="x,y,z,Color_Red,Color_Green,Color_Blue\n"), 1)
    read("header_colorr.csv", text(rows(P, RGB), ",", head="x,y,z,colorR,colorG,colorB\n"), 1)
    read("header_paraview_all.csv", text(rows(RGB, NORMAL, P), ",", head='"RGB_0","RGB_1","RGB_2","Normals_0","Normals_1","Normals_2","Points_0","Points_1","Points_2"\n'), 1,
         fields="normal_x,normal_y,normal_z", writer="ParaView")
    read("header_radius.csv", text(rows(P, C("0.5"), RGB), ",", head="x,y,z,r,red,green,blue\n"), 1, fields="r")
    read("header_twice.csv", text(rows(P, C("1"), C("2"), C("3")), ",", head="x,y,z,x,y,z\n"), said="the second 'x'")
    read("header_web_colours.csv", text(rows(P, lambda p, c, n, i: ["#%02x%02x%02x" % c]), ",", head="x,y,z,color\n"), said="left out column 4")
    read("header_pdal.csv", text(rows(P, I, C("1"), WIDE), ",", head='"X","Y","Z","Intensity","ReturnNumber","Red","Green","Blue"\n'), 1, fields="intensity", writer="PDAL")
    read("header_las2txt.txt", text(rows(P, I, C("2")), ",", head="% file: a.las\n% x,y,z,i,c\n"), writer="LAStools")
    read("header_class.csv", text(rows(P, C("ground")), ",", head="x,y,z,class\n"), said="left out column 4")
    # Without names
    read("id_first.txt", text(rows(ID, P)), said="columns 2 to 4 as x y z")
    read("id_sparse.txt", text(rows(lambda p, c, n, i: [str(7 * i + i % 3)], P)), said="columns 2 to 4 as x y z")
    read("time_first.txt", text(rows(T, P)), said="columns 2 to 4 as x y z")
    read("time_first_ns.csv", text(rows(lambda p, c, n, i: [str(1500000000000000000 + 1000 * i)], P), ","), said="columns 2 to 4 as x y z")
    read("sorted_millimetres.txt", text(sorted(rows(lambda p, c, n, i: [str(round(4e8 + 1e6 * p[0])), str(round(5e9 + 1e6 * p[1])),
                                                                  str(round(1e6 * p[2])), "7"]), key=lambda row: int(row[0]))),
         scale=1e6, offset="400000000,5000000000,0", order=0, tolerance=2)
    grid = lambda p, c, n, i: [str(i // 20), str(i % 20)]
    read("row_and_column.xyz", text(rows(grid, P)), said="columns 3 to 5 as x y z", writer="FARO SCENE")
    read("row_and_column_rgb.xyz", text(rows(grid, P, RGB)), 1, said="columns 3 to 5 as x y z", writer="FARO SCENE")
    read("row_and_column_i.xyz", text(rows(grid, P, I)), said="columns 3 to 5 as x y z", writer="FARO SCENE")
    read("gps_seconds_first.txt", text(rows(lambda p, c, n, i: ["%.3f" % (413162.5 + 0.001 * i)], P)), said="columns 2 to 4 as x y z", writer="LAStools")
    read("tetgen.node", text(rows(ID, P), head=f"{N} 3 0 0\n"), said="columns 2 to 4 as x y z", writer="TetGen")
    read("abaqus.inp", text(rows(ID, P), ", ", head="*NODE\n"), said="columns 2 to 4 as x y z", writer="Abaqus")
    read("wkt.txt", "".join("POINT Z (%s %s %s)\n" % tuple(row) for row in plain), said="columns 3 to 5 as x y z", writer="PostGIS")
    read("web_colours.txt", text(rows(P, lambda p, c, n, i: ["#%02x%02x%02x" % c])), said="without column 4")
    refuse("blanks_in_numbers.csv", text([[f"{1e7 * (float(w) + 2):,.3f}".replace(",", " ").replace(".", ",") for w in row] for row in plain], ";"), "1 234 567",
           writer="Excel, French")
    read("metashape.txt", text(rows(P, RGB, NORMAL)), 1, fields="normal_x,normal_y,normal_z", writer="Metashape")
    read("intensity.xyz", text(rows(P, I)), said="without column 4")
    read("rgb.xyz", text(rows(P, RGB)), 1, said="columns 4 to 6 as r g b")
    read("rgb.csv", text(rows(P, RGB), ","), 1, said="columns 4 to 6 as r g b", writer="MeshLab")
    read("rgb_unit.xyzrgb", text(rows(P, UNIT)), 1, said="columns 4 to 6 as r g b", writer="Open3D")
    read("rgb_real.txt", text(rows(P, BYTES_REAL)), 1, said="columns 4 to 6 as r g b")
    read("rgb_wide.txt", text(rows(P, WIDE)), said="without columns 4 to 6")
    read("normals.xyzn", text(rows(P, NORMAL)), said="columns 4 to 6 as nx ny nz", fields="normal_x,normal_y,normal_z", writer="Open3D")
    read("rgb_normals.txt", text(rows(P, RGB, NORMAL)), 1, said="7 to 9 as nx ny nz")
    read("normals_rgb.txt", text(rows(P, NORMAL, RGB)), 1, said="7 to 9 as r g b")
    read("normals_rgb_unit.txt", text(rows(P, NORMAL, UNIT)), 1, said="7 to 9 as r g b")
    read("irgb.pts", text(rows(P, I, RGB), head=f"{N}\n"), 1, said="columns 5 to 7 as r g b", writer="Leica Cyclone")
    read("irgb_negative.pts", text(rows(P, lambda p, c, n, i: [str(-INTENSITY[i] * 8)], RGB), head=f"{N}\n"), 1,
         said="columns 5 to 7 as r g b", writer="Leica Cyclone")
    read("irgb_unit.txt", text(rows(P, I01, RGB)), 1, said="columns 5 to 7 as r g b")
    read("rgbi_real.txt", text(rows(P, RGB, lambda p, c, n, i: ["%.2f" % (INTENSITY[i] * 8.5)])), 1, said="columns 4 to 6 as r g b")
    read("labels.txt", text(rows(P, lambda p, c, n, i: [str(i % 2)] * 3)), said="without columns 4 to 6")
    track = rows(lambda p, c, n, i: [str(3 * i + 1)], P, RGB, C("0.7"), lambda p, c, n, i: ["1", "20"] * (2 + i % 3))
    colmap = ("# 3D point list with one line of data per point:\n#   POINT3D_ID, X, Y, Z, R, G, B, ERROR, "
              "TRACK[] as (IMAGE_ID, POINT2D_IDX)\n# Number of points: 600, mean track length: 3\n")
    read("points3D.txt", text(track, head=colmap), 1, said="left out", writer="COLMAP")
    read("points3D_bare.txt", text(track), 1, said="columns 2 to 4 as x y z", writer="COLMAP")
    # --columns
    read("columns_skip.txt", text(rows(ID, P, I, RGB)), 1, columns="_,x,y,z,intensity,r,g,b", fields="intensity")
    read("columns_order.txt", text(rows(lambda p, c, n, i: xyz(p)[::-1])), columns="z,y,x")
    read("columns_over_header.csv", text(rows(P), ",", head="y,x,z\n"), columns="x,y,z")
    refuse("columns_too_many.txt", text(plain), "--columns names 4", columns="x,y,z,r")
    refuse("columns_without_z.txt", text(plain), "no x, y and z", columns="x,y,w")


def ptx(station, matrix, table, columns=N // 20):
    lines = [str(columns), str(len(table) // columns), " ".join("%g" % x for x in station), "1 0 0", "0 1 0", "0 0 1"]
    return "\n".join(lines + [" ".join("%.9g" % x for x in row) for row in matrix]) + "\n" + text(table)


def make_ptx():
    one = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    read("one.ptx", ptx((0, 0, 0), one, rows(P, C("0.5"))), fields="intensity,_vp_x,_vp_y,_vp_z", writer="Leica Cyclone")
    read("rgb.ptx", ptx((0, 0, 0), one, rows(P, C("0.5"), RGB)), 1, writer="Leica Cyclone")
    read("dos.ptx", ptx((0, 0, 0), one, rows(P, C("0.5"))).replace("\n", "\r\n"))
    read("ptx_named.xyz", ptx((0, 0, 0), one, rows(P, C("0.5"))))
    hole = rows(P, C("0.5"))
    read("no_returns.ptx", ptx((0, 0, 0), one, hole + [["0", "0", "0", "0.5"]] * 30), skipped=30, said="30 points")
    # A station at (2, 3, 0.5), turned by a quarter around z: points in its coordinates.
    turned = [[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 0], [2, 3, 0.5, 1]]
    local = rows(lambda p, c, n, i: ["%.6f" % x for x in (p[1] - 3, 2 - p[0], p[2] - 0.5)], C("0.5"))
    read("moved.ptx", ptx((2, 3, 0.5), turned, local), tolerance=3e-6)
    by_columns = [list(row) for row in zip(*turned)]
    read("moved_by_columns.ptx", ptx((2, 3, 0.5), by_columns, local), tolerance=3e-6)
    read("two_stations.ptx", ptx((0, 0, 0), one, hole[:HALF]) + ptx((2, 3, 0.5), turned, local[HALF:]), tolerance=3e-6)
    refuse("cut.ptx", ptx((0, 0, 0), one, hole[:-(N // 20)]).replace("\n19\n", "\n20\n"), "ends before")
    refuse("bad_matrix.ptx", ptx((0, 0, 0), one, hole).replace("0 0 1 0\n0 0 0 1", "0 0 1\n0 0 0 1", 1), "")


def make_grid():
    def grid(head):
        return head + "".join(" ".join("%g" % (10 + r + 0.5 * c) if (r, c) != (1, 1) else "-9999" for c in range(4)) + "\n"
                              for r in range(3))

    add("grid", "heights.asc", grid("ncols 4\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\nNODATA_value -9999\n"))
    add("grid", "heights_center.asc", grid("NCOLS 4\nNROWS 3\nXLLCENTER 101\nYLLCENTER 201\nCELLSIZE 2\nNODATA_VALUE -9999\n"))
    refuse("heights_short.asc", grid("ncols 4\nnrows 4\nxllcorner 100\nyllcorner 200\ncellsize 2\n"), "fewer heights")
    refuse("heights_long.asc", grid("ncols 4\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 2\n"), "more heights")


# ---- PCD

SIZES = {"I": {1: "b", 2: "h", 4: "i", 8: "q"}, "U": {1: "B", 2: "H", 4: "I", 8: "Q"}, "F": {4: "f", 8: "d"}}


def packed(colour, alpha=255):
    return alpha << 24 | colour[0] << 16 | colour[1] << 8 | colour[2]


def as_float(bits):
    return struct.unpack("<f", struct.pack("<I", bits))[0]


def lzf(data):
    """Literals only: valid, if not small."""
    return b"".join(bytes([len(data[i:i + 32]) - 1]) + data[i:i + 32] for i in range(0, len(data), 32))


def pcd(fields, values, data="ascii", version="0.7", extra="", count=True, height=1, end="\n", order=None, form="%.6f",
        padding_packed=True):
    """fields: (name, type, size, count); values: a list of numbers a point."""
    head = {"VERSION": version, "FIELDS": " ".join(f[0] for f in fields), "SIZE": " ".join(str(f[2]) for f in fields),
            "TYPE": " ".join(f[1] for f in fields), "COUNT": " ".join(str(f[3]) for f in fields),
            "WIDTH": str(len(values) // height), "HEIGHT": str(height), "VIEWPOINT": "0 0 0 1 0 0 0",
            "POINTS": str(len(values)), "DATA": data}
    if not count:
        del head["COUNT"]
    lines = [f"{k} {head[k]}" for k in (order or head) if k in head]
    text_head = "# .PCD v" + version + " - Point Cloud Data file format" + end + extra + end.join(lines) + end
    codes = [c for name, kind, size, n in fields for c in [SIZES[kind][size]] * n]
    if data == "ascii":
        body = "".join(" ".join(form % v if c in "fd" and abs(v) < 1e6 and (v == 0 or abs(v) > 1e-6) else ("%.9g" % v if c in "fd" else str(v))
                                for c, v in zip(codes, row)) + end for row in values)
        return (text_head + body).encode()
    if data == "binary":
        record = struct.Struct("<" + "".join(codes))
        return text_head.encode() + b"".join(record.pack(*row) for row in values)
    columns, at = [], 0
    for name, kind, size, n in fields:
        if name != "_" or padding_packed:
            columns.append(b"".join(struct.pack("<" + SIZES[kind][size] * n, *row[at:at + n]) for row in values))
        at += n
    raw = b"".join(columns)
    small = lzf(raw)
    return text_head.encode() + struct.pack("<II", len(small), len(raw)) + small


def make_pcd():
    f4 = [(a, "F", 4, 1) for a in "xyz"]
    f8 = [(a, "F", 8, 1) for a in "xyz"]
    positions = [list(p) for p, c, n in POINTS]
    kinds = ["ascii", "binary", "binary_compressed"]
    for data in kinds:
        short = data.replace("binary_", "")
        read(f"xyz_{short}.pcd", pcd(f4, positions, data), writer="PCL")
        read(f"double_{short}.pcd", pcd(f8, positions, data))
        read(f"mixed_{short}.pcd", pcd([f4[0], f8[1], f4[2]], positions, data))
        read(f"upper_{short}.pcd", pcd([(a.upper(), "F", 4, 1) for a in "xyz"], positions, data))
        read(f"packed_float_{short}.pcd", pcd(f4 + [("rgb", "F", 4, 1)], [list(p) + [as_float(packed(c, 0))] for p, c, n in POINTS], data),
             1, writer="PCL")
        read(f"packed_uint_{short}.pcd", pcd(f4 + [("rgb", "U", 4, 1)], [list(p) + [packed(c)] for p, c, n in POINTS], data), 1,
             writer="Open3D")
        read(f"rgba_{short}.pcd", pcd(f4 + [("rgba", "U", 4, 1)], [list(p) + [packed(c)] for p, c, n in POINTS], data), 1, writer="PCL")
        for name, kind, size, scale in [("uchar", "U", 1, 1), ("ushort", "U", 2, 257), ("int", "I", 4, 1), ("float", "F", 4, 1 / 255),
                                        ("float255", "F", 4, 1)]:
            values = [list(p) + [v * scale if kind == "F" else int(v * scale) for v in c] for p, c, n in POINTS]
            read(f"rgb_{name}_{short}.pcd", pcd(f4 + [(a, kind, size, 1) for a in "rgb"], values, data), 1)
        read(f"rgb_list_{short}.pcd", pcd(f4 + [("rgb", "U", 1, 3)], [list(p) + list(c) for p, c, n in POINTS], data), 1)
        read(f"normals_{short}.pcd", pcd(f4 + [("normal_" + a, "F", 4, 1) for a in "xyz"], [list(p) + list(n) for p, c, n in POINTS], data),
             fields="normal_x,normal_y,normal_z", writer="PCL")
        read(f"intensity_{short}.pcd", pcd(f4 + [("intensity", "F", 4, 1)], [list(p) + [float(INTENSITY[i])] for i, (p, c, n) in enumerate(POINTS)], data),
             fields="intensity", writer="PCL")
        read(f"order_{short}.pcd", pcd([("label", "U", 2, 1), ("z", "F", 4, 1), ("hist", "F", 4, 3), ("x", "F", 4, 1), ("y", "F", 4, 1)],
                                       [[7, p[2], 1.5, 2.5, 3.5, p[0], p[1]] for p, c, n in POINTS], data), fields="label,hist")
        read(f"int_{short}.pcd", pcd([(a, "I", 4, 1) for a in "xyz"], [[round(1e6 * x) for x in p] for p, c, n in POINTS], data), scale=1e6,
             tolerance=2)
        read(f"padding_{short}.pcd", pcd(f4 + [("_", "U", 1, 4)], [list(p) + [0] * 4 for p, c, n in POINTS], data), writer="PCL")
        read(f"organised_{short}.pcd", pcd(f4, positions, data, height=20))
        nan = float("nan")
        read(f"nan_{short}.pcd", pcd(f4, positions + [[nan] * 3] * 10, data), skipped=10)
    read("padding_left_out.pcd", pcd(f4[:2] + [("_", "U", 1, 4), f4[2]], [[p[0], p[1], 0, 0, 0, 0, p[2]] for p, c, n in POINTS],
                                     "binary_compressed", padding_packed=False), writer="PCL")
    read("version5.pcd", pcd(f4, positions, version=".5", order=["FIELDS", "SIZE", "TYPE", "WIDTH", "POINTS", "DATA"]))
    read("version5_columns.pcd", pcd(f4, positions, version=".5", order=["FIELDS", "SIZE", "TYPE", "WIDTH", "POINTS", "DATA"]).replace(b"FIELDS", b"COLUMNS"))
    read("version6.pcd", pcd(f4, positions, version=".6", count=False))
    read("no_count.pcd", pcd(f4, positions, count=False))
    read("no_magic.pcd", pcd(f4, positions).split(b"\n", 1)[1])
    read("dos.pcd", pcd(f4, positions, end="\r\n"))
    read("dos_binary.pcd", pcd(f4, positions, "binary", end="\r\n"))
    read("comments.pcd", pcd(f4, positions, extra="# made for a test\n\n"))
    read("decimal_comma.pcd", pcd(f4, positions).replace(b".", b",").replace(b",PCD", b".PCD").replace(b"v0,7", b"v0.7"))
    read("pcd_named.xyz", pcd(f4, positions))
    read("binary_and_more.pcd", pcd(f4, positions, "binary") + b"\n\n")
    refuse("short.pcd", pcd(f4, positions, "binary")[:-1], "ends before")
    refuse("short_text.pcd", pcd(f4, positions)[:-30], "ends before")
    refuse("column_too_many.pcd", text(rows(P, C("1")), head="VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH %d\nHEIGHT 1\nPOINTS %d\nDATA ascii\n" % (N, N)),
           "more numbers")
    refuse("no_z.pcd", pcd(f4[:2], [p[:2] for p in positions]), "no x, y and z")
    refuse("bad_type.pcd", pcd(f4, positions).replace(b"TYPE F F F", b"TYPE F F Q"), "TYPE")
    refuse("word.pcd", pcd(f4, positions).replace(b"0.1", b"o.1", 1), "is no number")
    refuse("comma_separated.pcd", text(rows(P), ",", head="VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH %d\nHEIGHT 1\nPOINTS %d\nDATA ascii\n" % (N, N)), "")


# ---- PLY

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d", "int8": "b",
         "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def ply(properties, values, form="binary_little_endian", end="\n", extra="", before="", faces="", first="ply"):
    """properties: (type, name), or (("list", count type, type), name)."""
    head = [first, f"format {form} 1.0"] + ([extra] if extra else []) + ([before] if before else []) + [f"element vertex {len(values)}"]
    for kind, name in properties:
        head.append(f"property {kind if isinstance(kind, str) else ' '.join(kind)} {name}")
    head += ([faces] if faces else []) + ["end_header"]
    mark = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[form]
    body = []
    for row in values:
        if form == "ascii":
            words = []
            for (kind, name), v in zip(properties, row):
                for x in ([len(v)] + list(v) if isinstance(v, (list, tuple)) else [v]):
                    words.append("%.6f" % x if isinstance(x, float) else str(x))
            body.append((" ".join(words) + end).encode())
            continue
        for (kind, name), v in zip(properties, row):
            if isinstance(kind, str):
                body.append(struct.pack(mark + TYPES[kind], v))
            else:
                body.append(struct.pack(mark + TYPES[kind[1]] + TYPES[kind[2]] * len(v), len(v), *v))
    return (end.join(head) + end).encode() + b"".join(body)


def make_ply():
    forms = ["ascii", "binary_little_endian", "binary_big_endian"]
    axes = [("float", a) for a in "xyz"]
    positions = [list(p) for p, c, n in POINTS]
    coloured = [list(p) + list(c) for p, c, n in POINTS]
    for form in forms:
        short = {"ascii": "ascii", "binary_little_endian": "le", "binary_big_endian": "be"}[form]
        read(f"xyz_{short}.ply", ply(axes, positions, form))
        read(f"float32_{short}.ply", ply([("float32", a) for a in "xyz"], positions, form))
        read(f"double_{short}.ply", ply([("double", a) for a in "xyz"], positions, form), writer="Open3D")
        read(f"mixed_{short}.ply", ply([("float", "x"), ("double", "y"), ("float", "z")], positions, form))
        read(f"upper_{short}.ply", ply([("float", a.upper()) for a in "xyz"], positions, form))
        read(f"ints_{short}.ply", ply([("int", a) for a in "xyz"], [[round(1e6 * x) for x in p] for p in positions], form), scale=1e6, tolerance=2)
        read(f"shorts_{short}.ply", ply([("short", a) for a in "xyz"], [[round(1e4 * x) for x in p] for p in positions], form), scale=1e4, tolerance=1)
        for names in ["red green blue", "r g b", "diffuse_red diffuse_green diffuse_blue", "Red Green Blue"]:
            read(f"{names.split()[0]}_{short}.ply", ply(axes + [("uchar", n) for n in names.split()], coloured, form), 1)
        for kind, scale in [("ushort", 257), ("short", 1), ("int", 1), ("uint", 1), ("uint8", 1)]:
            read(f"red_{kind}_{short}.ply", ply(axes + [(kind, n) for n in ("red", "green", "blue")],
                                                [list(p) + [int(v * scale) for v in c] for p, c, n in POINTS], form), 1)
        for kind, scale in [("float", 1 / 255), ("double", 1 / 255), ("float", 1)]:
            name = kind + ("" if scale < 1 else "255")
            read(f"red_{name}_{short}.ply", ply(axes + [(kind, n) for n in ("red", "green", "blue")],
                                                [list(p) + [v * scale for v in map(float, c)] for p, c, n in POINTS], form), 1)
        read(f"rgba_{short}.ply", ply(axes + [("uchar", n) for n in ("red", "green", "blue", "alpha")],
                                      [list(p) + list(c) + [255] for p, c, n in POINTS], form), 1, writer="MeshLab, trimesh")
        read(f"rgba_first_{short}.ply", ply([("uchar", n) for n in ("red", "green", "blue")] + axes, [list(c) + list(p) for p, c, n in POINTS], form), 1)
        read(f"normals_{short}.ply", ply(axes + [("float", n) for n in ("nx", "ny", "nz")] + [("uchar", n) for n in ("red", "green", "blue")],
                                         [list(p) + list(n) + list(c) for p, c, n in POINTS], form), 1, fields="normal_x,normal_y,normal_z", writer="Open3D, COLMAP")
        read(f"scalar_{short}.ply", ply(axes + [("float", "scalar_Intensity")], [list(p) + [float(INTENSITY[i])] for i, (p, c, n) in enumerate(POINTS)], form),
             fields="scalar_Intensity", writer="CloudCompare")
        read(f"list_{short}.ply", ply([("float", "x"), (("list", "uchar", "int"), "seen"), ("float", "y"), ("float", "z")],
                                      [[p[0], [1, 2, 3][:i % 4], p[1], p[2]] for i, (p, c, n) in enumerate(POINTS)], form), said="lists")
        read(f"list_long_{short}.ply", ply(axes + [(("list", "uint", "double"), "seen")], [list(p) + [[0.5] * (i % 3)] for i, (p, c, n) in enumerate(POINTS)], form),
             said="lists")
        camera = ply([("float", "a"), ("uchar", "b")], [[1.5, 2]], form).split(b"end_header\n")[1]
        whole = ply(axes, positions, form, before="element camera 1\nproperty float a\nproperty uchar b")
        head, body = whole.split(b"end_header\n", 1)
        read(f"element_before_{short}.ply", head + b"end_header\n" + camera + body)
        refuse(f"cut_{short}.ply", ply(axes, positions, form)[:-40], "ends before")
        read(f"dos_{short}.ply", ply(axes, positions, form, end="\r\n"))
        read(f"mac_{short}.ply", ply(axes, positions, form, end="\r"))
        read(f"blank_behind_{short}.ply", ply(axes, positions, form, first="ply "))
        read(f"comments_{short}.ply", ply(axes, positions, form, extra="comment made for a test\nobj_info num_cols 30"), writer="Stanford")
    read("radius.ply", ply(axes + [("float", "r")] + [("uchar", n) for n in ("red", "green", "blue")], [list(p) + [0.5] + list(c) for p, c, n in POINTS]), 1, fields="r")
    read("a_scalar.ply", ply(axes + [("uchar", n) for n in ("red", "green", "blue")] + [("float", "a")], [list(p) + list(c) + [0.5] for p, c, n in POINTS]), 1, fields="a")
    read("metashape.ply", ply(axes + [("float", n) for n in ("nx", "ny", "nz")] + [("uchar", n) for n in ("red", "green", "blue", "confidence", "class")],
                              [list(p) + list(n) + list(c) + [3, 2] for p, c, n in POINTS]), 1, fields="confidence,class", writer="Metashape")
    read("more_behind.ply", ply(axes, positions, "binary_little_endian") + bytes(480), said="480 bytes")
    read("trailing_blanks.ply", ply(axes, positions, "ascii").replace(b"\n", b" \n"))
    read("decimal_comma.ply", ply(axes, positions, "ascii").replace(b".", b",").replace(b"1,0", b"1.0", 1))
    read("ply_named.xyz", ply(axes, positions))
    read("ply_named.foo", ply(axes, positions))
    refuse("column_too_many.ply", ply(axes, positions, "ascii").replace(b"\n", b" 1\n").replace(b"header 1", b"header").replace(b"ply 1", b"ply")
           .replace(b"ascii 1.0 1", b"ascii 1.0").replace(b"vertex %d 1" % N, b"vertex %d" % N).replace(b"x 1\n", b"x\n").replace(b"y 1\n", b"y\n").replace(b"z 1\n", b"z\n"), "more numbers")
    refuse("fractions_as_bytes.ply", text(rows(P, UNIT), head=f"ply\nformat ascii 1.0\nelement vertex {N}\n" + "".join(
        f"property {k} {n}\n" for k, n in [("float", a) for a in "xyz"] + [("uchar", a) for a in ("red", "green", "blue")]) + "end_header\n"),
        "is no number of its column's type")
    refuse("splats.ply", ply(axes + [("float", n) for n in ("f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "rot_0")], [p + [0.1] * 6 for p in positions]),
           "3dgsconverter", writer="Gaussian Splatting")
    refuse("no_vertices.ply", ply([("float", "a")], [[1.0]]), "no x, y and z")
    refuse("bad_format.ply", ply(axes, positions, "ascii").replace(b"format ascii", b"format text"), "unknown format")
    refuse("bad_type.ply", ply(axes, positions).replace(b"float x", b"half x"), "unknown type")
    refuse("word.ply", ply(axes, positions, "ascii").replace(b" 0.3", b" o.3", 1), "is no number")
    far = 3.4028234663852886e38
    read("no_return.ply", ply(axes, positions + [[far] * 3], "binary_little_endian"), skipped=1)
    utm = (483020.0, 5457020.0, 250.0)
    read("utm.ply", ply([("double", a) for a in "xyz"], [[x + o for x, o in zip(p, utm)] for p in positions]), offset="483020,5457020,250")


# ---- LAS

def las(form, minor, scale=1e-6, offset=(0, 0, 0), extra=0, wide=True, shift=(0, 0, 0), legacy=True, cut=0, compressed=False):
    size = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67][form]
    records = []
    for i, (p, c, n) in enumerate(POINTS):
        stored = [round((x + s - o) / scale) for x, s, o in zip(p, shift, offset)]
        record = struct.pack("<3iH", *stored, INTENSITY[i])
        if form < 6:
            record += struct.pack("<BBbBH", 0x49, 2 | 0x20, 0, 0, 1)
            record += struct.pack("<d", TIME[i]) if form in (1, 3, 4, 5) else b""
            record += struct.pack("<3H", *[v * (257 if wide else 1) for v in c]) if form in (2, 3, 5) else b""
        else:
            record += struct.pack("<BBBBhHd", 0x11, 0, 2, 0, 0, 1, TIME[i])
            record += struct.pack("<3H", *[v * (257 if wide else 1) for v in c]) if form in (7, 8, 10) else b""
        records.append(record.ljust(size + extra, b"\0"))
    header = {0: 227, 1: 227, 2: 227, 3: 235, 4: 375}[minor]
    count = N if minor < 4 or legacy else 0
    lo = [min(p[k] for p, c, n in POINTS) + shift[k] for k in range(3)]
    hi = [max(p[k] for p, c, n in POINTS) + shift[k] for k in range(3)]
    head = struct.pack("<4sHHIHH8sBB32s32sHHHIIBHI5I3d3d6d", b"LASF", 0, 0, 0, 0, 0, b"", 1, minor, b"TEST", b"make_corpus.py", 1, 2026, header, header, 0,
                       form | (0x80 if compressed else 0), size + extra, count, *([count] + [0] * 4), scale, scale, scale, *offset, hi[0], lo[0], hi[1], lo[1], hi[2], lo[2])
    if minor >= 3:
        head += struct.pack("<Q", 0)
    if minor >= 4:
        head += struct.pack("<QIQ15Q", 0, 0, N, *([N] + [0] * 14))
    return (head.ljust(header, b"\0") + b"".join(records))[:-cut or None]


def make_las():
    for minor, forms in [(0, [0, 1]), (1, [0, 1]), (2, [0, 1, 2, 3]), (3, [4, 5]), (4, [6, 7, 8, 9, 10, 0, 3])]:
        for form in forms:
            colours = 1 if form in (2, 3, 5, 7, 8, 10) else 0
            fields = "intensity,classification" + (",gps_time" if form not in (0, 2) else "")
            read(f"v1{minor}_f{form}.las", las(form, minor), colours, fields=fields, tolerance=1e-9)
    read("bytes_as_colours.las", las(2, 2, wide=False), 1)
    read("extra_bytes.las", las(3, 2, extra=4), 1, said="extra bytes")
    read("count_of_14_alone.las", las(7, 4, legacy=False), 1)
    read("utm_millimetres.las", las(0, 2, 1e-6, (483000, 5457000, 0), shift=(483020, 5457020, 250)), offset="483020,5457020,250", tolerance=2e-9)
    read("odd_scale.las", las(0, 2, 0.00000037), tolerance=2e-7)
    read("las_named.xyz", las(0, 2))
    refuse("cut.las", las(0, 2, cut=1), "ends before")
    refuse("compressed.laz", las(0, 2, compressed=True), "laszip", writer="LAStools")
    refuse("version2.las", las(0, 2)[:24] + b"\2\0" + las(0, 2)[26:], "1.0 to 1.4")
    refuse("format11.las", las(0, 2)[:104] + b"\x0b" + las(0, 2)[105:], "point format")


# ---- others

def cube_faces():
    return [(i, i + 1, i + 2) for i in range(0, N - 2, 3)]


def make_others():
    vertices = rows(P)
    faces = "".join("3 %d %d %d\n" % f for f in cube_faces())
    count = f"{N} {len(cube_faces())} 0\n"
    read("points.off", text(vertices, head=f"OFF\n{N} 0 0\n"))
    read("faces.off", text(vertices, head="OFF\n" + count) + faces, writer="trimesh")
    read("one_line.off", text(vertices, head=f"OFF {N} 0 0\n"))
    read("comments.off", text(vertices, head=f"# a comment\nOFF\n\n# another\n{N} 0 0 # here\n"))
    read("colours.off", text(rows(P, RGB), head=f"COFF\n{N} 0 0\n"), 1)
    read("colours_alpha.off", text(rows(P, RGB, C("255")), head=f"COFF\n{N} 0 0\n"), 1, writer="MeshLab")
    read("colours_unit.off", text(rows(P, UNIT, C("1.0")), head=f"COFF\n{N} 0 0\n"), 1)
    read("colours_in_off.off", text(rows(P, RGB), head=f"OFF\n{N} 0 0\n"), 1)
    read("normals.off", text(rows(P, NORMAL), head=f"NOFF\n{N} 0 0\n"), fields="normal_x,normal_y,normal_z", writer="CGAL")
    read("colours_normals.off", text(rows(P, NORMAL, RGB), head=f"CNOFF\n{N} 0 0\n"), 1, fields="normal_x,normal_y,normal_z")
    read("texture.off", text(rows(P, C("0.5"), C("0.25")), head=f"STOFF\n{N} 0 0\n"), said="texture")
    read("normals_and_colours_in_off.off", text(rows(P, NORMAL, RGB), head=f"OFF\n{N} 0 0\n"), said="other numbers")
    read("colours_of_faces.off", text(vertices, head=f"OFF\n{N} 1 0\n") + "3 0 1 2 255 0 0\n", said="colours of its faces", writer="MeshLab")
    read("dos.off", text(vertices, head=f"OFF\r\n{N} 0 0\r\n", end="\r\n"))
    refuse("cut.off", text(vertices[:-5], head=f"OFF\n{N} 0 0\n"), "ends before")
    refuse("binary.off", f"OFF BINARY\n{N} 0 0\n", "BINARY")
    refuse("four.off", text(rows(P, C("1")), head=f"4OFF\n{N} 0 0\n"), "four coordinates")

    read("points.obj", text([["v"] + row for row in vertices]))
    read("faces.obj", text([["v"] + row for row in vertices], tail="".join("f %d %d %d\n" % tuple(k + 1 for k in f) for f in cube_faces())), writer="Open3D")
    read("colours.obj", text(rows(C("v"), P, UNIT)), 1, writer="MeshLab")
    read("colours_bytes.obj", text(rows(C("v"), P, RGB)), 1)
    read("normals.obj", text([["v"] + row for row in vertices]) + text(rows(C("vn"), NORMAL)), writer="trimesh")
    read("comments.obj", text([["v"] + row for row in vertices], head="# made for a test\nmtllib a.mtl\no ellipsoid\n"), writer="Blender")
    read("normals_of_points.obj", "".join("v " + " ".join(a) + "\nvn " + " ".join(b) + "\n" for a, b in zip(vertices, rows(NORMAL))),
         fields="normal_x,normal_y,normal_z", writer="CloudCompare")
    read("weights_colours.obj", text(rows(C("v"), P, C("1.0"), UNIT)), 1)
    read("colours_alpha.obj", text(rows(C("v"), P, UNIT, C("1.0"))), 1)
    read("weights.obj", text(rows(C("v"), P, C("1.0"))))
    read("decimal_comma.obj", text([["v"] + [w.replace(".", ",") for w in row] for row in vertices]))
    refuse("word.obj", text([["v"] + row for row in vertices[:HALF]] + [["v", "a", "b", "c"]]), f"line {HALF + 1}")

    def vtk(form, kind="float", data="", dataset="POLYDATA", version="3.0"):
        head = f"# vtk DataFile Version {version}\na title\n{form}\nDATASET {dataset}\n"
        if dataset == "STRUCTURED_GRID":
            head += f"DIMENSIONS {N} 1 1\n"
        head += f"POINTS {N} {kind}\n"
        if form == "ASCII":
            return (text(vertices, head=head) + data).encode()
        code = {"float": "f", "double": "d"}[kind]
        return head.encode() + b"".join(struct.pack(">3" + code, *p) for p, c, n in POINTS) + b"\n" + (data if isinstance(data, bytes) else data.encode())

    for form in ["ASCII", "BINARY"]:
        for kind in ["float", "double"]:
            read(f"{kind}_{form.lower()}.vtk", vtk(form, kind), writer="VTK")
        read(f"unstructured_{form.lower()}.vtk", vtk(form, dataset="UNSTRUCTURED_GRID"))
        read(f"structured_{form.lower()}.vtk", vtk(form, dataset="STRUCTURED_GRID"))
    read("colours_ascii.vtk", vtk("ASCII", data=f"POINT_DATA {N}\nCOLOR_SCALARS rgb 3\n" + text(rows(UNIT))), 1, writer="VTK")
    read("colours_binary.vtk", vtk("BINARY", data=f"POINT_DATA {N}\nCOLOR_SCALARS rgb 3\n".encode() + b"".join(bytes(c) for p, c, n in POINTS)), 1, writer="VTK")
    read("intensity.vtk", vtk("ASCII", data=f"POINT_DATA {N}\nSCALARS intensity float 1\nLOOKUP_TABLE default\n" + text(rows(I01))), said="intensity",
         writer="libpointmatcher")
    read("normals.vtk", vtk("ASCII", data=f"POINT_DATA {N}\nNORMALS normals float\n" + text(rows(NORMAL))), said="normals")
    refuse("image.vtk", "# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\n", "no points")
    refuse("cut.vtk", vtk("BINARY")[:-5], "not a whole VTK file")

    triangles = cube_faces()
    corners = b"".join(struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *POINTS[k][0]) for k in f) + b"\0\0" for f in triangles)
    read("binary.stl", b"made for a test".ljust(80) + struct.pack("<I", len(triangles)) + corners, order=0)
    read("binary_solid.stl", b"solid made for a test".ljust(80) + struct.pack("<I", len(triangles)) + corners, order=0, writer="SolidWorks")
    loops = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex " + " ".join(xyz(POINTS[k][0])) + "\n" for k in f) + "endloop\nendfacet\n" for f in triangles)
    read("text.stl", "solid a\n" + loops + "endsolid a\n", order=0)
    read("text_dos.stl", ("solid a\n" + loops + "endsolid a\n").replace("\n", "\r\n"), order=0)
    refuse("cut.stl", b"made for a test".ljust(80) + struct.pack("<I", len(triangles)) + corners[:-9], "not a whole STL")

    for name, data, said in [("cloud.e57", b"ASTM-E57" + bytes(100), "pdal translate"), ("cloud.rcs", bytes(range(100)), "ReCap"),
                             ("cloud.rcp", bytes(range(100)), "ReCap"), ("cloud.npy", b"\x93NUMPY" + bytes(100), "numpy.savetxt"),
                             ("cloud.xyz.gz", b"\x1f\x8b" + bytes(100), "gunzip"), ("cloud.zip", b"PK\3\4" + bytes(100), "unzip"),
                             ("cloud.vtp", b"<?xml version='1.0'?><VTKFile>", "ParaView"), ("cloud.json", b'{"points": [1, 2, 3]}', "JSON"),
                             ("cloud.glb", b"glTF" + bytes(100), "assimp"), ("cloud.drc", b"DRACO" + bytes(100), "draco_decoder"),
                             ("cloud.bag", b"#ROSBAG V2.0\n" + bytes(100), "bag_to_pcd"), ("cloud.bin", b"CCB2" + bytes(100), "CloudCompare"),
                             ("cloud.fls", bytes(range(100)), "SCENE"), ("cloud.png", b"\x89PNG" + bytes(100), "picture"),
                             ("cloud.pcap", b"\xd4\xc3\xb2\xa1" + bytes(100), "VeloView"), ("noise.bin", bytes(range(256)), "no format"),
                             ("zeros.xyz", bytes(1000), "")]:
        refuse(name, data, said)


make_text()
make_ptx()
make_grid()
make_pcd()
make_ply()
make_las()
make_others()
(folder / "truth.txt").write_text("".join(" ".join(xyz(p) + [str(v) for v in c] + xyz(n)) + "\n" for p, c, n in POINTS))
(folder / "manifest.tsv").write_text("\n".join(manifest) + "\n")

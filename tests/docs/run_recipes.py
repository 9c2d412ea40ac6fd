#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of docs/recipes.md as they stand.

    run_recipes.py PAGE TESTS_DATA BIN [HEADING]      BIN: the folder of the programs

Each recipe runs in a folder of its own with the files of recipe_data.py. Its commands must succeed, what its blocks of
text show must be printed, and volumes must be those that the data were made with. Exit status 77: a program of Debian's
that a recipe needs is not installed.
"""
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import recipe_data

# What the last commands print, by formulas; each within 1 %.
VOLUMES = {"A room": [6 * 4 * 3 - 1.5], "A stockpile": [math.pi * (0.25 - 1 / math.pi ** 2)] * 2,
           "A part for printing": [10 * (40 * 30 - math.pi * 36)]}
SKIPPED = 77


def recipes_of(page):
    """{heading: (commands, {file: text}, [lines to be printed])}"""
    recipes, block = {}, None
    with open(page, encoding="utf-8") as file:
        for line in file.read().splitlines():
            if line.startswith("## "):
                commands, files, shown = recipes[line[3:]] = ([], {}, [])
            elif line.startswith("```"):
                words = line[3:].split()
                if block is None and words[:1] == ["python"]:
                    block = files.setdefault(words[1], [])
                elif block is None:
                    block = shown
                else:
                    block = None
            elif block is not None:
                block.append(line)
            elif line.startswith("    ") and recipes:
                commands.append(line.strip())
    return recipes


def squeezed(text):
    return re.sub(r"[ \t]+", " ", text)


def faults_of(heading, recipe, data, bin_folder):
    commands, files, shown = recipe
    path = os.pathsep.join([os.path.abspath(bin_folder), "/usr/bin", os.environ["PATH"]])  # Debian's Python has Debian's VTK
    printed, faults = "", []
    with tempfile.TemporaryDirectory() as folder:
        recipe_data.write_all(data, folder)
        for name, lines in files.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write("\n".join(lines) + "\n")
        for command in commands:
            run = subprocess.run(command, shell=True, cwd=folder, env=dict(os.environ, PATH=path), text=True,
                                 capture_output=True, timeout=300, check=False)
            printed += run.stdout
            if run.returncode != 0:
                return [f"{heading}: {command}: status {run.returncode}: {run.stderr}"]
    for line in shown:
        if squeezed(line) not in squeezed(printed):
            faults.append(f"{heading}: '{line}' is not printed")
    found = [float(number) for number in re.findall(r"^volume(?: over ground, net)? +([\d.]+)", printed, re.M)]
    wanted = VOLUMES.get(heading, [])
    if wanted and (len(found) != len(wanted) or any(abs(a / b - 1) > 0.01 for a, b in zip(found, wanted))):
        faults.append(f"{heading}: volumes {found}, expected {wanted}")
    return faults


def missing(recipe):
    commands, files, _ = recipe
    if any(command.startswith("pcl_") and not shutil.which(command.split()[0], path="/usr/bin") for command in commands):
        return "pcl-tools"
    if files and subprocess.run(["/usr/bin/python3", "-c", "import vtk"], check=False, capture_output=True).returncode:
        return "python3-vtk9"
    return None


def main(arguments):
    if len(arguments) not in (3, 4):
        sys.exit(__doc__)
    recipes = recipes_of(arguments[0])
    if len(arguments) == 4:
        recipes = {arguments[3]: recipes[arguments[3]]}
    status = 0
    for heading, recipe in recipes.items():
        package = missing(recipe)
        if package:
            print(f"{heading}: skipped, {package} is not installed")
            status = status or SKIPPED
            continue
        faults = faults_of(heading, recipe, arguments[1], arguments[2])
        print("\n".join(faults) if faults else f"{heading}: as written")
        if faults:
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the pages say what the repository has.

    check_docs.py ROOT [PROGRAM..]      PROGRAM: an executable, whose --help lists its options
    check_docs.py --self-test           every check must find the fault of a page made for it

Checked are the length of README.md, links and anchors, paths and functions in backticks, programs, scripts and
files in commands, options, that C++ blocks quote an example, and that every header of the core has its line. Prints one line a fault; exit status 1 if there is any.
"""
import glob
import os
import re
import stat
import subprocess
import sys
import tempfile

README_LINES = 120
FOLDERS = "src|apps|ros|include|tests|docs|examples|benchmark|launch|cmake|.ci|.github".replace(".", r"\.")
PATH = re.compile(rf"^(?:{FOLDERS})/[\w.*/-]*$")
LINK = re.compile(r"\]\(([^)\s]+)\)")
SPAN = re.compile(r"`([^`]+)`")
OPTION = re.compile(r"(?<![\w-])--[a-z][\w-]*")


def pages_of(root):
    names = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "benchmark/README.md", "launch/README.md"]
    pages = [os.path.join(root, name) for name in names]
    pages += glob.glob(os.path.join(root, "docs/**/*.md"), recursive=True)
    pages += glob.glob(os.path.join(root, "tests/*/README.md"))
    return [page for page in pages if os.path.exists(page)]


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class Page:
    """A page in paragraphs, lines of commands and C++ blocks; the first two with the heading above them."""

    def __init__(self, text):
        self.prose, self.commands, self.cpp, self.anchors = [], [], [], set()
        heading, block, kind, paragraph, indented = "", [], None, [], False

        def end_paragraph():
            if paragraph:
                self.prose.append((heading, " ".join(paragraph)))
                paragraph.clear()

        for line in text.splitlines() + [""]:
            if line.startswith("```") and kind is None:
                end_paragraph()
                kind, block = line[3:].strip() or "text", []
            elif line.startswith("```"):
                if kind == "cpp":
                    self.cpp.append(block)
                kind = None
            elif kind is not None:
                block.append(line)
            elif line.startswith("    ") and (indented or not paragraph):
                indented = True
                self.commands.append((heading, line.strip()))
            else:
                indented = False
                if not line.strip() or line.startswith("#"):
                    end_paragraph()
                if line.startswith("#"):
                    heading = line.lstrip("#").strip()
                    self.anchors.add(slug(heading))
                if line.strip():
                    paragraph.append(line.strip())


def slug(heading):
    """The anchor that GitHub gives a heading."""
    return re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower()).replace(" ", "-")


def help_of(program):
    done = subprocess.run([program, "--help"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60,
                          check=False)
    return done.stdout.decode("utf-8", "replace")


def quoted(block, example):
    """Do the lines stand in the example, in this order? Indentation and what is in between do not count."""
    at = 0
    for line in (line.strip() for line in block):
        if not line:
            continue
        while at < len(example) and example[at] != line:
            at += 1
        if at == len(example):
            return False
        at += 1
    return True


class Checker:
    def __init__(self, root, programs):
        self.root = root
        self.faults = []
        self.options = {os.path.basename(p): set(OPTION.findall(help_of(p))) for p in programs}
        self.executables = set(self.options)
        for listing in glob.glob(os.path.join(root, "**/CMakeLists.txt"), recursive=True):
            self.executables |= set(re.findall(r"add_executable\((\w+)", read(listing)))
        self.examples = [[line.strip() for line in read(example).splitlines()]
                         for example in glob.glob(os.path.join(root, "examples/*.cpp"))]
        sources = glob.glob(os.path.join(root, "include/**/*.h*"), recursive=True)
        sources += glob.glob(os.path.join(root, "src/**/*.[hc]*"), recursive=True)
        sources += glob.glob(os.path.join(root, "tests/**/*.cpp"), recursive=True)
        self.calls = set(re.findall(r"(\w+)\(", "\n".join(read(source) for source in sources)))
        self.parsed = {}

    def page(self, path):
        path = os.path.normpath(path)
        if path not in self.parsed:
            self.parsed[path] = Page(read(path))
        return self.parsed[path]

    def fault(self, page, text):
        self.faults.append(f"{os.path.relpath(page, self.root)}: {text}")

    def exists(self, path):
        """Components of one capital letter stand for any name."""
        return bool(re.search(r"/[A-Z](?=/|$)", path)) or bool(glob.glob(os.path.join(self.root, path)))

    def run(self):
        lines = len(read(os.path.join(self.root, "README.md")).splitlines())
        if lines > README_LINES:
            self.fault(os.path.join(self.root, "README.md"), f"{lines} lines, more than {README_LINES}")
        for path in pages_of(self.root):
            self.check_prose(path)
            self.check_commands(path)
            for block in self.page(path).cpp:
                if not any(quoted(block, example) for example in self.examples):
                    self.fault(path, f"no example has the block of '{block[0].strip() if block else ''}'")
        self.check_headers()
        return self.faults

    def check_headers(self):
        """Every header of the core is on the page that has a line for each."""
        page = os.path.join(self.root, "docs/architecture.md")
        if not os.path.exists(page):
            return
        text = read(page)
        for header in glob.glob(os.path.join(self.root, "src/core/**/*.h"), recursive=True):
            name = os.path.relpath(header, self.root)
            if name not in text:
                self.fault(page, f"no line for {name}")

    def check_prose(self, path):
        for heading, paragraph in self.page(path).prose:
            for target in LINK.findall(paragraph):
                self.check_link(path, target)
            for span in SPAN.findall(paragraph):
                self.check_span(path, heading, span)

    def check_link(self, path, target):
        if re.match(r"\w+:", target):
            return
        name, _, anchor = target.partition("#")
        linked = os.path.join(os.path.dirname(path), name) if name else path
        if not os.path.exists(linked):
            self.fault(path, f"link to {target}: no such file")
        elif anchor and linked.endswith(".md") and anchor not in self.page(linked).anchors:
            self.fault(path, f"link to {target}: no such heading")

    def check_span(self, path, heading, span):
        words = span.split()
        for word in words:
            if PATH.match(word) and not self.exists(word):
                self.fault(path, f"`{word}`: no such path")
            if re.fullmatch(r"\w+\.launch", word) and not self.exists(f"launch/{word}"):
                self.fault(path, f"`{word}`: no such launch file")
        call = re.fullmatch(r"(?:\w+::)?(\w+)\(.*\)", span)
        if call and call.group(1) not in self.calls:
            self.fault(path, f"`{span}`: no such function")
        named = [word for word in words if os.path.basename(word) in self.options]
        if named or re.match(r"--[a-z]", span):
            owner = os.path.basename(named[0]) if named else heading if heading in self.options else None
            self.check_options(path, owner, OPTION.findall(span))

    def check_options(self, path, owner, options):
        known = self.options[owner] if owner else set().union(*self.options.values())
        for option in options:
            if self.options and option not in known:
                self.fault(path, f"{owner} has no option {option}" if owner else f"no program has option {option}")

    def check_commands(self, path):
        owner = None
        for _, line in self.page(path).commands:
            continued = owner if line.startswith("--") else None
            owner = None
            for command in re.split(r"[|;]|&&", line.partition(" #")[0]):
                owner = self.check_command(path, command.split(), continued)
                continued = None

    def check_command(self, path, words, owner):
        """Returns the program of ours that the command runs, if any."""
        for i, word in enumerate(words):
            name = os.path.basename(word)
            if word.startswith("build/bin/") and name not in self.executables:
                self.fault(path, f"{word}: no such program")
            if PATH.match(word) and not word.startswith("build/") and not self.exists(word):
                self.fault(path, f"{word}: no such path")
            if words[0] == "roslaunch" and word.endswith(".launch") and not self.exists(f"launch/{word}"):
                self.fault(path, f"{word}: no such launch file")
            if name in self.options and word in (name, f"build/bin/{name}") and owner is None:
                if i == 0 or words[i - 1] in ("-a", "xvfb-run"):
                    owner = name
        if owner:
            self.check_options(path, owner, [w for w in words if OPTION.fullmatch(w)])
        return owner


GOOD = """# Title

[here](#title), [there](docs/page.md#one-two), `src/a.cpp`, `src/F/x.cpp`, `tool --fast`, `--fast`, `a.launch`, `twice(x)`

    build/bin/tool tests/data/x.ply --fast    # --not-an-option of a comment
    bash .ci/run
    roslaunch filmsticking_pp a.launch

```cpp
int a = 1;
return a;
```
"""

FAULTS = {
    "[x](gone.md)": "no such file",
    "[x](#gone)": "no such heading",
    "[x](docs/page.md#gone)": "no such heading",
    "`src/gone.cpp`": "no such path",
    "`gone.launch`": "no such launch file",
    "`gone()`": "no such function",
    "`--gone`": "option --gone",
    "`tool --gone`": "option --gone",
    "`tool\n--gone`": "option --gone",
    "[a\nb](gone.md)": "no such file",
    "\n    tool --gone": "option --gone",
    "\n    xvfb-run -a tool --gone": "option --gone",
    "\n    cat x | tool - --gone": "option --gone",
    "\n    tool a\n    --gone": "option --gone",
    "\n    build/bin/gone": "no such program",
    "\n    bash .ci/gone": "no such path",
    "\n    tool tests/data/gone.ply": "no such path",
    "\n    roslaunch filmsticking_pp gone.launch": "no such launch file",
    "```cpp\nreturn a;\nint a = 1;\n```": "no example",
    "\n" * README_LINES: "lines, more than",
}


def self_test():
    with tempfile.TemporaryDirectory() as root:
        def write(name, text):
            path = os.path.join(root, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            return path

        write("src/a.cpp", "int twice(int x) { return 2 * x; }\n")
        for name in (".ci/run", "launch/a.launch", "tests/data/x.ply", "src/core/x/y.h"):
            write(name, "")
        write("docs/page.md", "## One `two`\n")
        write("docs/architecture.md", "src/core/x/y.h\n")
        write("examples/01.cpp", "  int a = 1;\n  ++a;\n  return a;\n")
        write("CMakeLists.txt", "add_executable(tool tool.cpp)\n")
        tool = write("bin/tool", "#!/bin/sh\necho '  --fast  be fast'\n")
        os.chmod(tool, os.stat(tool).st_mode | stat.S_IXUSR)

        failures = []
        write("README.md", GOOD)
        if faults := Checker(root, [tool]).run():
            failures.append(f"a good page has faults: {faults}")
        for text, wanted in FAULTS.items():
            write("README.md", GOOD + "\n" + text + "\n")
            faults = Checker(root, [tool]).run()
            if len(faults) != 1 or wanted not in faults[0]:
                failures.append(f"{text!r}: {faults}, expected one with '{wanted}'")
        write("README.md", GOOD)
        write("src/core/x/z.h", "")
        if "no line for src/core/x/z.h" not in "".join(Checker(root, [tool]).run()):
            failures.append("a header without a line was not found")
    return failures


def main(arguments):
    if not arguments:
        sys.exit(__doc__)
    if arguments == ["--self-test"]:
        faults = self_test()
    else:
        faults = Checker(arguments[0], arguments[1:]).run()
    print("\n".join(faults) if faults else "no faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

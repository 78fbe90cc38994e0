#!/usr/bin/env python3
"""check_layers.py [ROOT]: which file may include which, as core/README.md draws it, how long a file may be, and that the
repository holds nothing beside what it is made of: results of a trial are no part of it, and may show a patient."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__ + "/../../..").resolve()
LAYERS = {"core": 0, "render": 1, "app": 2}
# Inside core a folder may include itself and folders of a lower rank; equal ranks do not know each other.
RANKS = {"base": 0, "volume": 1, "mesh": 2, "io": 3, "phantom": 3, "enhancement": 3, "classification": 3, "surface": 3, "rbf": 4, "face": 4,
         "skin": 4, "pipeline": 5}
# The same for rooms inside a folder; "" is what lies in the folder itself.
ROOMS = {"core/mesh": {"": 0, "iso": 1, "search": 1, "facts": 2, "atlas": 2, "repair": 3, "parts": 4, "print": 4},
         "core/rbf": {"": 0, "compact": 1, "global": 1, "surface": 2},
         "app": {"texts": 0, "document": 1, "widgets": 1, "workspace": 2, "views": 3, "panels": 3, "batch": 2, "window": 4, "cli": 5, "": 6}}
# Libraries and the one place that may see each.
LIBRARIES = [(re.compile(r"itk"), re.compile(r"core/io/[^/]+\.cpp")),
             (re.compile(r"glad/|GL/|EGL/"), re.compile(r"render/")),
             (re.compile(r"imgui|GLFW/"), re.compile(r"app/"))]
LONGEST = 400
FOLDERS = {".ci", "app", "assets", "cmake", "core", "render", "shaders", "tests"}
INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')


def room(folder, name):
    """The room of a file of the folder, None of any other file."""
    inner = name.removeprefix(folder + "/")
    return None if inner == name else inner.split("/")[0] if "/" in inner else ""


def upward(name, target):
    """What is wrong with an include from a room to another of the same folder that does not lie below it."""
    for folder, ranks in ROOMS.items():
        here, there = room(folder, name), room(folder, target)
        if None not in (here, there) and here != there and ranks.get(there, 99) >= ranks.get(here, -1):
            yield f"{folder}/{here} must not know {folder}/{there}"


def faults(name, lines):
    parts = name.split("/")
    if len(lines) > LONGEST:
        yield f"{name}: {len(lines)} lines, {LONGEST} at most: split it by subject"
    for number, line in enumerate(lines, 1):
        if not (match := INCLUDE.match(line)):
            continue
        target = match.group(1)
        to = target.split("/")
        where = f"{name}:{number}: {target}"
        if to[0] in LAYERS and LAYERS[to[0]] > LAYERS[parts[0]]:
            yield f"{where}: {parts[0]} must not know {to[0]}"
        if parts[0] == to[0] == "core" and parts[1] != to[1]:
            if RANKS.get(to[1], 99) >= RANKS.get(parts[1], -1):
                yield f"{where}: core/{parts[1]} must not know core/{to[1]}"
        for fault in upward(name, target):
            yield f"{where}: {fault}"
        for library, home in LIBRARIES:
            if library.match(target) and not home.match(name):
                yield f"{where}: only {home.pattern} may see this library"


def strangers():
    listed = subprocess.run(["git", "-C", str(ROOT), "ls-files"], capture_output=True, text=True)  # nothing outside of git
    for folder in sorted({name.split("/")[0] for name in listed.stdout.splitlines() if "/" in name} - FOLDERS):
        yield f"{folder}: not a folder of the repository (FOLDERS in {pathlib.Path(__file__).name})"


def main():
    found = list(strangers())
    for layer in LAYERS:
        for path in sorted((ROOT / layer).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                name = path.relative_to(ROOT).as_posix()
                found += faults(name, path.read_text(encoding="utf-8").splitlines())
    print("\n".join(found) or "layers: every include goes downward")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""read_table.py PROGRAM [--shared FOLDER] [--only WORD]: what the program says of every file in FOLDER/data and
FOLDER/cases (default: ../shared beside the repository), and of the files that the scripts in cases make, as a Markdown table on
standard output. Beside each value stands that of a reader that shares no code with the program: the parsers of plain_readers.py (NRRD,
MetaImage, NIfTI, VTK, Kretz, GLB, 3MF, STL, PLY, OBJ), and pydicom for DICOM; where they differ the line is marked. Ends with 1
where any line is. Needs Debian's python3-numpy and python3-pydicom.

Values are in the program's words: voxels, spacing and origin in mm and LPS, axes as rows. A file that one of the two refuses has no
values to compare: its line holds the sentence."""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

from plain_readers import READERS, dicom, nrrd

OTHERS = {".md", ".py", ".sh", ".mtl", ".jpg", ".txt", ".raw", ".json", ".inf"}


# ---- the table

def said(program, path):
    """What the program says: values, or its sentence, and what it warns of."""
    done = subprocess.run([program, "info", str(path), "--json"], capture_output=True, text=True, timeout=600)
    lines = done.stderr.splitlines()
    warnings = [l.split(": ", 2)[2] for l in lines if l.startswith(("sonoskin: warning", "sonoskin: note"))]
    if done.returncode != 0:
        sentence = next((l.split(": ", 2)[-1] for l in lines if "error" in l), f"ended with {done.returncode}")
        return None, sentence.replace(str(path), path.name), warnings
    return json.loads(done.stdout), "", warnings


def ours_of(j):
    if "triangles" in j:
        return {"triangles": j["triangles"], "size": j.get("size_mm") or j.get("extent_mm")}
    if "volumes" in j:
        return {"frame": f"{len(j['volumes'])} volumes to choose from"}
    return {"samples": j.get("converted_from", {}).get("samples"), "dims": j["dims"], "spacing": j["spacing_mm"],
            "origin": j["origin_mm"], "axes": j["direction"], "steps": j["time_steps"],
            "known": j["spacing_known"], "frame": "LPS", "unit": "mm"}


def shown(value):
    if isinstance(value, (list, tuple)):
        return "; ".join(map(shown, value)) if value and isinstance(value[0], list) else " ".join(map(shown, value))
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def differs(a, b):
    try:
        x, y = np.array(a, float), np.array(b, float)
    except (TypeError, ValueError):
        return False  # words
    return x.shape != y.shape or not np.allclose(x, y, rtol=1e-4, atol=1e-4)


COLUMNS = ("samples", "dims", "spacing", "origin", "axes", "frame", "unit", "steps", "triangles", "size")


def line(program, path, name):
    answer, sentence, warnings = said(program, path)
    cannot = False
    reader = READERS.get(path.suffix.lower(), dicom if path.is_dir() else None)
    try:
        other = reader(path) if reader else {}
    except NotImplementedError as fault:
        other, refused, cannot = None, str(fault), True
    except Exception as fault:  # whatever is wrong with the file
        other, refused = None, f"{type(fault).__name__}: {fault}"[:120]
    ours = ours_of(answer) if answer else None
    cells, marks = [], []
    for column in COLUMNS:
        a, b = (ours or {}).get(column), (other or {}).get(column)
        if a is not None and b is not None and differs(a, b):
            marks.append(column)
        cells.append(shown(a) if a is not None and (b is None or shown(a) == shown(b)) else
                     " / ".join("-" if v is None else shown(v) for v in (a, b)) if a is not None or b is not None else "")
    if ours and other and ours.get("known") is False and other.get("known"):
        marks.append("spacing known")
    read = "read" if ours else "refused: " + sentence
    if other is None:
        read += f" (other reader: {refused})"
        if ours and not cannot:
            marks.append("only the program reads it")
    elif ours is None and other:
        read += " (other reader: read)"
    return [name, read, *cells, "; ".join(warnings), "≠ " + ", ".join(marks) if marks else ""]


def files_of(program, shared, work):
    """All files to look at, with what they are called in the table; scripts of the cases write into `work`."""
    for folder in sorted({p.parent for p in (shared / "data").rglob("*1.dcm") if len(list(p.parent.glob("*.dcm"))) > 5}):
        yield folder, str(folder.relative_to(shared))
    cases = work / "cases"
    shutil.copytree(shared / "cases", cases)
    subprocess.run(["chmod", "-R", "u+w", str(cases)], check=True)
    before = set(cases.rglob("*"))
    for script in sorted(cases.glob("[0-9]*.py")):
        arguments = []
        if "argv" in script.read_text(encoding="utf-8"):  # of a scan
            subprocess.run([program, "phantom", "--dims", "180x100x48", "--out", str(work / "scan.nrrd")], check=False,
                           capture_output=True)
            arguments = [str(work / "scan.nrrd"), str(cases)]
        subprocess.run([sys.executable, script.name, *arguments], cwd=cases, check=False, stdout=subprocess.DEVNULL)
    for path in sorted((shared / "data").rglob("*")) + sorted(cases.rglob("*")):
        many = path.suffix == ".dcm" and len(list(path.parent.glob("*.dcm"))) > 5
        if path.is_file() and path.suffix.lower() not in OTHERS and "__pycache__" not in str(path) and not many:
            made = path.is_relative_to(cases)
            name = "cases/" + str(path.relative_to(cases)) + ("" if path in before else " (made)") if made else str(
                path.relative_to(shared))
            yield path, name


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--shared", default=pathlib.Path(__file__).resolve().parents[3] / "shared", type=pathlib.Path)
    parser.add_argument("--only", default="", help="names that hold this word")
    options = parser.parse_args()
    marked = total = 0
    print("| file | | " + " | ".join(COLUMNS) + " | warned | differs |\n" + "|---" * (len(COLUMNS) + 4) + "|")
    with tempfile.TemporaryDirectory() as work:
        for path, name in files_of(options.program, options.shared, pathlib.Path(work)):
            if options.only in name:
                cells = line(options.program, path, name)
                total, marked = total + 1, marked + bool(cells[-1])
                print("| " + " | ".join(c.replace("|", "/") for c in cells) + " |", flush=True)
    print(f"\n{total} files, {marked} where the two readers differ. `a / b`: the program's value and the other reader's.")
    return 1 if marked else 0


if __name__ == "__main__":
    sys.exit(main())

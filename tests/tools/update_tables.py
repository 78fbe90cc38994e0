#!/usr/bin/env python3
"""update_tables.py PROGRAM: puts the tables that the program prints where people read them: the formats into README.md, the
parameters into assets/docs/parameters.md."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = (("README.md", "formats", ["info", "--formats"]),
          ("assets/docs/parameters.md", "parameters", ["recipe", "--explain"]))

for name, mark, arguments in TABLES:
    file = ROOT / name
    table = subprocess.run([sys.argv[1], *arguments], check=True, capture_output=True, text=True).stdout
    text, found = re.subn(rf"(<!-- {mark}: [^\n]*-->\n).*(<!-- end of {mark} -->)",
                          lambda match, table=table: f"{match[1]}\n{table}\n{match[2]}",
                          file.read_text(encoding="utf-8"), flags=re.DOTALL)
    if not found:
        sys.exit(f"{name} has no place for the table of {mark}.")
    file.write_text(text, encoding="utf-8")

#!/usr/bin/env python3
"""update_readme.py PROGRAM: puts the tables of formats and of parameters that the program prints into README.md."""
import pathlib
import re
import subprocess
import sys

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"
text = README.read_text(encoding="utf-8")
for mark, arguments in (("formats", ["info", "--formats"]), ("parameters", ["recipe", "--explain"])):
    table = subprocess.run([sys.argv[1], *arguments], check=True, capture_output=True, text=True).stdout
    text = re.sub(rf"(<!-- {mark}: [^\n]*-->\n).*(<!-- end of {mark} -->)",
                  lambda match, table=table: f"{match[1]}\n{table}\n{match[2]}", text, flags=re.DOTALL)
README.write_text(text, encoding="utf-8")

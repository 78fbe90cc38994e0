#!/usr/bin/env python3
"""update_readme.py PROGRAM: puts the table of parameters that the program prints into README.md."""
import pathlib
import re
import subprocess
import sys

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"
table = subprocess.run([sys.argv[1], "recipe", "--explain"], check=True, capture_output=True, text=True).stdout
text = README.read_text(encoding="utf-8")
text = re.sub(r"(<!-- parameters: [^\n]*-->\n).*(<!-- end of parameters -->)",
              lambda match: f"{match[1]}\n{table}\n{match[2]}", text, flags=re.DOTALL)
README.write_text(text, encoding="utf-8")
